/* Derivatives of a step along any number of directions, WRCONTACT_DIRECTIONS of them in each pass of the differentiated kernel.
 *
 * A unit that defines WRCONTACT_DIRECTIONS includes this file, and with it the differentiated kernel.
 */
#include "wrcontact_derivative.h"

#include <string.h>

/* Differentiating leaves values over that nothing asks for. */
#if defined(__GNUC__) || defined(__clang__)
#pragma GCC diagnostic ignored "-Wunused-but-set-variable"
#endif
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wpsabi"            /* only static functions hand vectors over */
#endif
#include "../generated/derivative_unit.c"

/* Numbers of memory that the derivatives need. */
static int64_t derivative_room(void)
{
    return layout__STATE_SIZE + (1 + WRCONTACT_DIRECTIONS) * layout__WORK_SIZE + layout__INPUT_COUNT + layout__OUTPUT_COUNT
        + 2 * (layout__RUN_COUNT + layout__WEAR_RUN_COUNT) * layout__STATION_LIMIT + layout__WEAR_END;
}

/* Over which share of its usual size (as in the table of variables) an input moves for a difference. */
static const double SHARE = 1e-4;

/* One step at the handle's inputs, moved by `way` along `seed`; the status. */
static int step_along(const wrcontact_handle *own, const wrcontact_handle *handle, const double *seed, double way)
{
    for (int i = 0; i < layout__INPUT_COUNT; i += 1)
        own->inputs.data[i] = i == layout__IN_ROLL_GUESS ? 0.0 : handle->inputs.data[i] + way * seed[i];
    own->workspace.data[layout__WORK_KNOWN] = 0.0;
    return wrcontact_step(own);
}

/* Rates from steps to either side, as far as these are valid. */
static void difference(const wrcontact_handle *own, const wrcontact_handle *handle, const double *seed, double *rates)
{
    double size = 0.0, ways[2] = {0.0, 0.0};
    for (int i = 0; i < layout__INPUT_COUNT; i += 1)
    {
        const double share = fabs(seed[i]) / layout__INPUT_NOMINALS[i];
        size = share > size ? share : size;
    }
    for (int side = 0; side < 2 && size > 0.0; side += 1)
    {
        const double sign = side ? 1.0 : -1.0;
        ways[side] = step_along(own, handle, seed, sign * SHARE / size) <= layout__UNLOADED ? sign * SHARE / size : 0.0;
        if (ways[side] == 0.0 && step_along(own, handle, seed, 0.0) > layout__UNLOADED)
            size = 0.0;
        for (int i = 0; i < own->outputs.shape[0]; i += 1)
            rates[i] = side ? own->outputs.data[i] - rates[i] : own->outputs.data[i];
    }
    for (int i = 0; i < own->outputs.shape[0]; i += 1)
        rates[i] = size > 0.0 && ways[1] > ways[0] ? rates[i] / (ways[1] - ways[0]) : 0.0;
}

static bool all_finite(const double *values, int64_t count)
{
    for (int64_t i = 0; i < count; i += 1)
        if (!isfinite(values[i]))
            return false;
    return true;
}

/* The own step at the handle's inputs, which starts where the handle's state says; its status. */
static int step_as(const wrcontact_handle *own, const wrcontact_handle *handle)
{
    memcpy(own->state.data, handle->state.data, layout__STATE_SIZE * sizeof(double));
    memcpy(own->inputs.data, handle->inputs.data, layout__INPUT_COUNT * sizeof(double));
    if (own->state.data[layout__STATE_WARM] == 1.0 && isfinite(own->inputs.data[layout__IN_ROLL_GUESS]))
        own->inputs.data[layout__IN_ROLL_GUESS] = 0.0;  /* the search starts where the wheelset stands */
    own->workspace.data[layout__WORK_KNOWN] = 0.0;
    return wrcontact_step(own);
}

/* No rates, but where they are written before they are read: the outlines, patches, nodes, strips, equations and samples of the
 * wheels, which are most of the memory. */
static void clear_rates(directional_rate *rates)
{
    const int64_t right = layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE;
    const int64_t parts[][2] = {
        {0, layout__WORK_OUTLINES},
        {layout__WORK_SIDES, layout__WORK_SIDES + layout__SIDE_SEARCH_PATCHES},
        {layout__WORK_SIDES + layout__SIDE_SEARCH_TOTALS, layout__WORK_SIDES + layout__SIDE_SEARCH_OUTLINE},
        {layout__WORK_SIDES + layout__SIDE_SEARCH_MOTION, right + layout__SIDE_SEARCH_PATCHES},
        {right + layout__SIDE_SEARCH_TOTALS, right + layout__SIDE_SEARCH_OUTLINE},
        {right + layout__SIDE_SEARCH_MOTION, layout__WORK_CONTACT + layout__CONTACT_NODES},
        {layout__WORK_CONTACT + layout__CONTACT_ORIGIN, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_SAMPLES},
        {layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH, layout__WORK_ROLLING}};
    for (size_t k = 0; k < sizeof parts / sizeof parts[0]; k += 1)
        memset(rates + parts[k][0], 0, (parts[k][1] - parts[k][0]) * sizeof(directional_rate));
}

/* Rates of all outputs along `count` directions (count, outputs), whose rates of the inputs are the rows of `seeds`; the status. */
static int derivatives(const wrcontact_handle *handle, int64_t count, const double *seeds, double *rates, double *room)
{
    const array_double_1d work = span_of(room, layout__WORK_SIZE);
    const array_directional_rate_1d work_t = {(directional_rate *)(room + layout__WORK_SIZE), {layout__WORK_SIZE}};
    const array_double_1d state = span_of(room + (1 + WRCONTACT_DIRECTIONS) * layout__WORK_SIZE, layout__STATE_SIZE);
    const array_double_1d inputs = span_of(state.data + layout__STATE_SIZE, layout__INPUT_COUNT);
    const array_double_1d outputs = span_of(inputs.data + layout__INPUT_COUNT, outline__row_size(handle->tables));
    const wrcontact_handle own = {handle->tables, state, work, inputs, outputs};
    const int64_t size = outputs.shape[0];
    memset(rates, 0, count * size * sizeof(double));
    int status = step_as(&own, handle);
    for (int64_t first = 0; first < count && status <= layout__UNLOADED; first += WRCONTACT_DIRECTIONS)
    {
        clear_rates(work_t.data);
        for (int64_t k = 0; k < WRCONTACT_DIRECTIONS && first + k < count; k += 1)
            for (int64_t i = 0; i < layout__INPUT_COUNT; i += 1)
                *rate_along(work_t.data + layout__WORK_INPUTS + i, k) = seeds[(first + k) * layout__INPUT_COUNT + i];
        const bool reported = derivative_wheelset_rules__differentiate_t(handle->tables, work, work_t) == 0;
        bool stepped = false;
        for (int64_t k = 0; k < WRCONTACT_DIRECTIONS && first + k < count; k += 1)
        {
            double *found = rates + (first + k) * size;
            for (int64_t i = 0; i < size; i += 1)
                found[i] = *rate_along(work_t.data + layout__WORK_OUTPUTS + i, k);
            if (!reported || !all_finite(found, size))
            {
                difference(&own, handle, seeds + (first + k) * layout__INPUT_COUNT, found);
                stepped = true;
            }
        }
        if (stepped)
            status = step_as(&own, handle);
    }
    return status;
}
