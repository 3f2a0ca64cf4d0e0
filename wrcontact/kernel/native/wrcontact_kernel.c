/* The first translation unit: the generated code, and the functions that the outside may call.
 *
 *     cc -std=gnu11 -O3 -ffp-contract=off -fno-math-errno -fvisibility=hidden -shared -fPIC *.c
 *
 * Without -ffp-contract=off the compiler may fuse a*b + c, and the last bits differ from the Python source.
 */
#include "wrcontact_kernel.h"
#include "../generated/unit.c"

int wrcontact_step(const wrcontact_handle *handle)
{
    return (int)step__step(handle->tables, handle->state, handle->workspace, handle->inputs, handle->outputs);
}

int wrcontact_step_many(const wrcontact_handle *handle, int64_t count, double *inputs, double *outputs, double *statuses)
{
    return (int)step__step_many(count, handle->tables, handle->state, handle->workspace,
                                span_of(inputs, count * layout__INPUT_COUNT),
                                span_of(outputs, count * outline__row_size(handle->tables)),
                                span_of(statuses, count));
}

void wrcontact_divide_into_strips(array_double_1d workspace)
{
    rolling_strips__divide_into_strips(workspace, layout__WORK_PATCH);
}

void wrcontact_solve_creep_force(array_double_1d tables, array_double_1d workspace)
{
    creep_force__solve_creep_force(workspace, tables, layout__WORK_PATCH);
}

int64_t wrcontact_abi(void)
{
    return WRCONTACT_KERNEL_FINGERPRINT;
}
