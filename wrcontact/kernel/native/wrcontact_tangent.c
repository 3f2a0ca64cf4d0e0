/* The third translation unit: the differentiated kernel.  It stands apart so that the compiler spends nothing on it that it
 * would take from the steps.
 */
#include "wrcontact_tangent.h"

#include <string.h>

#include "../generated/tangent_unit.c"

int64_t wrcontact_tangent_room(void)
{
    return layout__STATE_SIZE + 2 * layout__WORK_SIZE + layout__INPUT_COUNT + layout__OUTPUT_COUNT;
}

int wrcontact_tangent(const wrcontact_handle *handle, const double *seed, double *rates, double *room)
{
    const array_double_1d work = span_of(room, layout__WORK_SIZE), work_t = span_of(work.data + layout__WORK_SIZE, layout__WORK_SIZE);
    const array_double_1d state = span_of(work_t.data + layout__WORK_SIZE, layout__STATE_SIZE);
    const array_double_1d inputs = span_of(state.data + layout__STATE_SIZE, layout__INPUT_COUNT);
    const array_double_1d outputs = span_of(inputs.data + layout__INPUT_COUNT, layout__OUTPUT_COUNT);
    const wrcontact_handle own = {handle->tables, state, work, inputs, outputs};
    memcpy(state.data, handle->state.data, layout__STATE_SIZE * sizeof(double));
    memcpy(inputs.data, handle->inputs.data, layout__INPUT_COUNT * sizeof(double));
    if (state.data[layout__STATE_WARM] == 1.0 && isfinite(inputs.data[layout__IN_ROLL_GUESS]))
        inputs.data[layout__IN_ROLL_GUESS] = 0.0;       /* the search starts where the wheelset stands */
    work.data[layout__WORK_KNOWN] = 0.0;
    memset(rates, 0, layout__OUTPUT_COUNT * sizeof(double));
    const int status = wrcontact_step(&own);
    if (status <= layout__UNLOADED)
    {
        memset(work_t.data, 0, layout__WORK_SIZE * sizeof(double));
        memcpy(work_t.data + layout__WORK_INPUTS, seed, layout__INPUT_COUNT * sizeof(double));
        tangent_implicit__differentiate_t(handle->tables, work, work_t, state);
        memcpy(rates, work_t.data + layout__WORK_OUTPUTS, layout__OUTPUT_COUNT * sizeof(double));
    }
    return status;
}
