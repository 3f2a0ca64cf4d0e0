/* The second translation unit: what prepares the tables.  It stands apart so that the compiler spends nothing on it that it
 * would take from the steps.
 */
#include "wrcontact_prepare.h"

#include <string.h>

/* Its headers declare functions of the kernel that it does not call. */
#if defined(__GNUC__) || defined(__clang__)
#pragma GCC diagnostic ignored "-Wunused-function"
#endif
#include "../generated/prepare_unit.c"

/* Where the wheelset stands without load at the shifts of the table of starts, from the kernel itself. */
static void fill_starts(array_double_1d left, array_double_1d right, double *work)
{
    const int64_t sizes[] = {layout__STATE_SIZE, layout__WORK_SIZE, layout__INPUTS_SIZE, layout__OUTPUTS_SIZE};
    array_double_1d parts[4];
    for (int i = 0; i < 4; i += 1)
    {
        parts[i] = span_of(work, sizes[i]);
        memset(work, 0, (size_t)sizes[i] * sizeof *work);
        work += sizes[i];
    }
    const wrcontact_handle handle = {left, right, parts[0], parts[1], parts[2], parts[3]};
    for (int64_t row = 0; row < layout__START_COUNT; row += 1)
    {
        parts[2].data[layout__INPUTS_LATERAL_SHIFT] = prepare_tables__start_shift(right, row);
        prepare_tables__note_start(parts[1], right, row, wrcontact_step(&handle));
    }
    prepare_tables__open_starts(right, left.data == right.data);
}

int64_t wrcontact_prepare_room(const wrcontact_preparation *preparation)
{
    const int64_t zones = preparation->wheel.shape[0] + preparation->rail.shape[0];
    const int64_t starts = layout__STATE_SIZE + layout__WORK_SIZE + layout__INPUTS_SIZE + layout__OUTPUTS_SIZE;
    const int64_t needed = zones + preparation->tables.shape[0] + 1000;
    return needed > starts ? needed : starts;
}

int wrcontact_prepare(const wrcontact_preparation *p)
{
    return (int)prepare_tables__prepare(p->setup, p->wheel, p->rail, p->fixed, p->tables, p->work, p->report);
}

void wrcontact_complete(array_double_1d setup, array_double_1d left, array_double_1d right, double *work)
{
    fill_starts(left, right, work);
    prepare_tables__write_methods(setup, left);
    prepare_tables__write_methods(setup, right);
}
