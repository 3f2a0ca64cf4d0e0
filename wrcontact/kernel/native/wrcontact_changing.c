/* A translation unit of its own, as wrcontact_prepare.c: a step on constant rails does not enter it. */
#include "wrcontact_changing.h"

/* Its headers declare functions of the kernel that it does not call. */
#if defined(__GNUC__) || defined(__clang__)
#pragma GCC diagnostic ignored "-Wunused-function"
#endif
#include "../generated/changing_unit.c"

int wrcontact_step_changing(const wrcontact_handle *handle)
{
    return (int)section_step__step_changing(handle->tables, handle->state, handle->workspace, handle->inputs,
                                            handle->outputs);
}

int wrcontact_step_changing_many(const wrcontact_handle *handle, int64_t count, double *inputs, double *outputs,
                                 double *statuses)
{
    return (int)section_step__step_changing_many(count, handle->tables, handle->state, handle->workspace,
                                                 span_of(inputs, count * layout__INPUT_COUNT),
                                                 span_of(outputs, count * outline__row_size(handle->tables)),
                                                 span_of(statuses, count));
}
