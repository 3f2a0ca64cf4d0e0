/* Generated from patch/outline.py by tools/transpile_kernel.py; change that one.
 *
 * Where the outline of a side lies: three runs of equal length, its stations, half-lengths and pressures.
 *
 * With STATION_COUNT stations it is part of the side's outputs.  With another number the outlines of both sides, left then
 * right, follow behind all outputs, and the places for it among the side's own stay zero.
 */

#include "outline.h"

/* Offset in the workspace of the outline of the side whose outputs are at ``out``. */
static inline int64_t outline__outline_place(array_double_1d tables, array_double_1d work, int64_t out)
{
    int64_t stations;
    int64_t place;
    stations = (int64_t)((*cspan_at(&tables, layout__TABLES_STATIONS)));
    place = out + layout__SIDE_STATION;
    if (stations != layout__STATION_COUNT)
    {
        place = layout__WORK_OUTLINES;
        if (out > layout__WORK_OUTPUTS + layout__OUT_LEFT)
        {
            place += INT64_C(3) * stations;
        }
    }
    return place;
}

/* Write ``value`` all over a side's outline, where it is not part of the side's outputs. */
static inline int64_t outline__fill_apart(array_double_1d tables, array_double_1d work, int64_t out, double value)
{
    int64_t stations;
    int64_t place;
    int64_t i;
    stations = (int64_t)((*cspan_at(&tables, layout__TABLES_STATIONS)));
    if (stations != layout__STATION_COUNT)
    {
        place = outline__outline_place(tables, work, out);
        for (i = INT64_C(0); i < INT64_C(3) * stations; i += INT64_C(1))
        {
            (*cspan_at(&work, place + i)) = value;
        }
    }
    return INT64_C(0);
}

/* How many numbers an evaluation gives: the outputs, and the outlines where they follow behind them. */
static inline int64_t outline__row_size(array_double_1d tables)
{
    int64_t stations;
    int64_t size;
    stations = (int64_t)((*cspan_at(&tables, layout__TABLES_STATIONS)));
    size = layout__OUTPUT_COUNT;
    if (stations != layout__STATION_COUNT)
    {
        size += INT64_C(6) * stations;
    }
    return size;
}
