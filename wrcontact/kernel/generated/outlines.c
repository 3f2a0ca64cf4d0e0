/* Generated from wheelset/outlines.py by tools/transpile_kernel.py; change that one.
 *
 * Where the outline of each side is: among its outputs, or behind those of both sides for
 * another number of stations.
 */

#include "outlines.h"

/* Offset in the workspace of the outline of side ``index``. */
static inline int64_t outlines__outline_place(array_double_1d tables, array_double_1d work, int64_t index)
{
    int64_t place;
    place = layout__WORK_OUTPUTS + layout__OUTPUTS_LEFT + layout__SIDE_OUTPUTS_SIZE * index + layout__SIDE_OUTPUTS_STATION;
    if ((int64_t)((*cspan_at(&tables, layout__TABLES_STATIONS))) != layout__STATION_COUNT)
    {
        place = layout__WORK_OUTLINES + layout__RUN_COUNT * (int64_t)((*cspan_at(&tables, layout__TABLES_STATIONS))) * index;
    }
    return place;
}

/* Write ``value`` all over a side's outline, where it is not part of the side's outputs. */
static inline int64_t outlines__fill_apart(array_double_1d tables, array_double_1d work, int64_t index, double value)
{
    if ((int64_t)((*cspan_at(&tables, layout__TABLES_STATIONS))) != layout__STATION_COUNT)
    {
        outline__fill_outline(work, outlines__outline_place(tables, work, index), (int64_t)((*cspan_at(&tables, layout__TABLES_STATIONS))), value);
    }
    return INT64_C(0);
}
