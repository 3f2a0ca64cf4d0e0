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
static void fill_starts(array_double_1d tables, double *work)
{
    const int64_t sizes[] = {layout__STATE_SIZE, layout__WORK_SIZE, layout__INPUTS_SIZE, layout__OUTPUTS_SIZE};
    array_double_1d parts[4];
    for (int i = 0; i < 4; i += 1)
    {
        parts[i] = span_of(work, sizes[i]);
        memset(work, 0, (size_t)sizes[i] * sizeof *work);
        work += sizes[i];
    }
    const wrcontact_handle handle = {tables, parts[0], parts[1], parts[2], parts[3]};
    for (int64_t row = 0; row < layout__START_COUNT; row += 1)
    {
        parts[2].data[layout__INPUTS_LATERAL_SHIFT] = prepare_tables__start_shift(tables, row);
        prepare_tables__note_start(parts[1], tables, row, wrcontact_step(&handle));
    }
    prepare_tables__open_starts(tables);
}

int64_t wrcontact_prepare_room(const wrcontact_preparation *p)
{
    const int64_t lengths[] = {p->wheel.shape[0], p->rail.shape[0], p->left_wheel.shape[0], p->left_rail.shape[0]};
    const int64_t starts = layout__STATE_SIZE + layout__WORK_SIZE + layout__INPUTS_SIZE + layout__OUTPUTS_SIZE;
    int64_t longest = 0;
    for (int i = 0; i < 4; i += 1)
        longest = lengths[i] > longest ? lengths[i] : longest;
    const int64_t needed = longest + p->tables.shape[0] + 1000;
    return needed > starts ? needed : starts;
}

int wrcontact_prepare(const wrcontact_preparation *p)
{
    const int used = (int)prepare_tables__prepare(p->setup, p->wheel, p->rail, p->left_wheel, p->left_rail, p->fixed, p->tables,
                                                     p->work);
    if (used >= 0)
    {
        fill_starts(p->tables, p->work.data);
        prepare_tables__write_methods(p->setup, p->tables);
    }
    return used;
}
