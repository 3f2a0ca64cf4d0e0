/* Generated from patch/strip_patches.py by tools/transpile_kernel.py; change that one.
 *
 * From corrected strips to contact patches: edges, loads, areas, pressures, and the outline at evenly spaced stations.
 *
 * A patch is a run of loaded strips that touch each other.  Near its edge the line load falls to zero in proportion to the
 * distance, so the edge is where the straight line through the last two strips' line loads ends.
 */

#include "strip_patches.h"

/* Second divided difference of ``field`` over the strips ``i`` - 1, ``i``, ``i`` + 1. */
static inline double strip_patches__divided_bend(array_double_1d work, int64_t field, int64_t i)
{
    int64_t stations;
    double left;
    double right;
    double after;
    double before;
    stations = strips__strip_field(strips__STRIP_STATION);
    left = (*cspan_at(&work, stations + i)) - (*cspan_at(&work, stations + i - INT64_C(1)));
    right = (*cspan_at(&work, stations + i + INT64_C(1))) - (*cspan_at(&work, stations + i));
    after = ((*cspan_at(&work, field + i + INT64_C(1))) - (*cspan_at(&work, field + i))) / right;
    before = ((*cspan_at(&work, field + i)) - (*cspan_at(&work, field + i - INT64_C(1)))) / left;
    return (after - before) / (left + right);
}

/* Second coefficient of ``field`` between strips ``i`` and ``i`` + 1 of the run first ... last. */
static inline double strip_patches__cell_bend(array_double_1d work, int64_t field, int64_t i, int64_t first, int64_t last)
{
    double found;
    double bend;
    bend = 0.0;
    found = 0.0;
    if ((i > first) && (i < last))
    {
        bend += strip_patches__divided_bend(work, field, i);
        found += 1.0;
    }
    if ((i + INT64_C(1) < last) && (i + INT64_C(1) > first))
    {
        bend += strip_patches__divided_bend(work, field, i + INT64_C(1));
        found += 1.0;
    }
    if (found > 0.0)
    {
        bend /= found;
    }
    return bend;
}

/* Integral over a cell of the root of the quadratic with end values ``low``, ``high`` and second coefficient
 * ``bend``.
 */
static inline double strip_patches__cell_area(double low, double high, double bend, double width)
{
    return width * patches__root_integral(2.0 * low - high + 2.0 * bend * width * width, low, high, 0.0, 1.0);
}

/* Area [m^2] of the run first ... last between its edges. */
static inline double strip_patches__run_area(array_double_1d work, int64_t first, int64_t last, double start, double stop)
{
    int64_t stations;
    int64_t squares;
    double bend;
    double half;
    int64_t i;
    stations = strips__strip_field(strips__STRIP_STATION);
    squares = strips__strip_field(strips__STRIP_SQUARE);
    bend = strip_patches__cell_bend(work, squares, first, first, last);
    half = strip_patches__cell_area(0.0, (*cspan_at(&work, squares + first)), bend, (*cspan_at(&work, stations + first)) - start);
    for (i = first; i < last; i += INT64_C(1))
    {
        bend = strip_patches__cell_bend(work, squares, i, first, last);
        half += strip_patches__cell_area((*cspan_at(&work, squares + i)), (*cspan_at(&work, squares + i + INT64_C(1))), bend, (*cspan_at(&work, stations + i + INT64_C(1))) - (*cspan_at(&work, stations + i)));
    }
    bend = strip_patches__cell_bend(work, squares, last - INT64_C(1), first, last);
    half += strip_patches__cell_area((*cspan_at(&work, squares + last)), 0.0, bend, stop - (*cspan_at(&work, stations + last)));
    return 2.0 * half;
}

/* Largest value of the parabola through strip ``i``, the largest of its run, and its neighbours in the run. */
static inline double strip_patches__top_value(array_double_1d work, int64_t field, int64_t i, int64_t first, int64_t last)
{
    int64_t stations;
    double bend;
    double left;
    double slope;
    double value;
    value = (*cspan_at(&work, field + i));
    if ((i > first) && (i < last))
    {
        stations = strips__strip_field(strips__STRIP_STATION);
        bend = strip_patches__divided_bend(work, field, i);
        if (bend < 0.0)
        {
            left = (*cspan_at(&work, stations + i)) - (*cspan_at(&work, stations + i - INT64_C(1)));
            slope = (value - (*cspan_at(&work, field + i - INT64_C(1)))) / left + bend * left;
            value -= slope * slope / (4.0 * bend);
        }
    }
    return value;
}

/* Strip with the largest value of ``field`` in a run. */
static inline int64_t strip_patches__largest_of(array_double_1d work, int64_t field, int64_t first, int64_t last)
{
    int64_t i;
    int64_t best;
    best = first;
    for (i = first; i < last + INT64_C(1); i += INT64_C(1))
    {
        if ((*cspan_at(&work, field + i)) > (*cspan_at(&work, field + best)))
        {
            best = i;
        }
    }
    return best;
}

/* Collect the runs of loaded strips as islands; their number. */
static inline int64_t strip_patches__gather_strips(array_double_1d work, int64_t strips)
{
    int64_t region;
    int64_t stations;
    int64_t widths;
    int64_t lines;
    int64_t squares;
    int64_t pressures;
    int64_t first;
    int64_t last;
    int64_t block;
    double start;
    double stop;
    int64_t at;
    int64_t i;
    double load;
    int64_t carrier;
    double pressure;
    int64_t islands;
    for (region = INT64_C(0); region < layout__REGION_LIMIT; region += INT64_C(1))
    {
        (*cspan_at(&work, layout__WORK_REGIONS + layout__REGION_SIZE * region + layout__REGION_CARRIED)) = 0.0;
        (*cspan_at(&work, layout__WORK_REGIONS + layout__REGION_SIZE * region + layout__REGION_MOMENT)) = 0.0;
    }
    stations = strips__strip_field(strips__STRIP_STATION);
    widths = strips__strip_field(strips__STRIP_WIDTH);
    lines = strips__strip_field(strips__STRIP_LINE);
    squares = strips__strip_field(strips__STRIP_SQUARE);
    pressures = strips__strip_field(strips__STRIP_PRESSURE);
    islands = INT64_C(0);
    first = INT64_C(0);
    while((first < strips) && (islands < patches__ISLAND_LIMIT))
    {
        last = first;
        if ((*cspan_at(&work, lines + first)) > 0.0)
        {
            last = strips__run_end(work, strips, first);
            block = layout__WORK_REGIONS + layout__REGION_SIZE * (int64_t)((*cspan_at(&work, strips__strip_field(strips__STRIP_REGION) + first)));
            start = strips__run_edge(work, strips, first, last, -INT64_C(1));
            stop = strips__run_edge(work, strips, last, first, INT64_C(1));
            patches__open_island(work, islands, start, -atan((*cspan_at(&work, block + layout__REGION_LEAN))));
            at = layout__WORK_ISLANDS + patches__ISLAND_SIZE * islands;
            for (i = first; i < last + INT64_C(1); i += INT64_C(1))
            {
                load = (*cspan_at(&work, lines + i)) * (*cspan_at(&work, widths + i));
                (*cspan_at(&work, at + patches__ISLAND_LOAD)) += load;
                (*cspan_at(&work, at + patches__ISLAND_MOMENT)) += load * (*cspan_at(&work, stations + i));
                carrier = layout__WORK_REGIONS + layout__REGION_SIZE * (int64_t)((*cspan_at(&work, strips__strip_field(strips__STRIP_REGION) + i)));
                (*cspan_at(&work, carrier + layout__REGION_CARRIED)) += load;
                (*cspan_at(&work, carrier + layout__REGION_MOMENT)) += load * (*cspan_at(&work, stations + i));
            }
            (*cspan_at(&work, at + patches__ISLAND_STOP)) = stop;
            (*cspan_at(&work, at + patches__ISLAND_AREA)) = strip_patches__run_area(work, first, last, start, stop);
            pressure = strip_patches__top_value(work, pressures, strip_patches__largest_of(work, pressures, first, last), first, last);
            (*cspan_at(&work, at + patches__ISLAND_PRESSURE)) = pressure * pressure;
            (*cspan_at(&work, at + patches__ISLAND_HALF_LENGTH)) = strip_patches__top_value(work, squares, strip_patches__largest_of(work, squares, first, last), first, last);
            islands += INT64_C(1);
        }
        first = last + INT64_C(1);
    }
    return islands;
}

/* Half-length and pressure at ``count`` stations from the first edge to the last, to ``place``. */
static inline int64_t strip_patches__write_strip_outline(array_double_1d work, int64_t place, int64_t count, int64_t strips, int64_t islands)
{
    double start;
    double stop;
    int64_t stations;
    int64_t squares;
    int64_t pressures;
    int64_t island;
    int64_t i;
    int64_t j;
    double station;
    double half;
    double pressure;
    int64_t at;
    double low;
    double low_square;
    double low_pressure;
    double high;
    double high_square;
    double high_pressure;
    double share;
    start = (*cspan_at(&work, layout__WORK_ISLANDS + patches__ISLAND_START));
    stop = (*cspan_at(&work, layout__WORK_ISLANDS + patches__ISLAND_SIZE * (islands - INT64_C(1)) + patches__ISLAND_STOP));
    stations = strips__strip_field(strips__STRIP_STATION);
    squares = strips__strip_field(strips__STRIP_SQUARE);
    pressures = strips__strip_field(strips__STRIP_PRESSURE);
    island = INT64_C(0);
    i = INT64_C(0);
    for (j = INT64_C(0); j < count; j += INT64_C(1))
    {
        station = start + (stop - start) * (double)(j) / (double)(count - INT64_C(1));
        half = 0.0;
        pressure = 0.0;
        while((island < islands - INT64_C(1)) && (station > (*cspan_at(&work, layout__WORK_ISLANDS + patches__ISLAND_SIZE * island + patches__ISLAND_STOP))))
        {
            island += INT64_C(1);
        }
        at = layout__WORK_ISLANDS + patches__ISLAND_SIZE * island;
        if ((j > INT64_C(0)) && (j < count - INT64_C(1)) && (station > (*cspan_at(&work, at + patches__ISLAND_START))) && (station < (*cspan_at(&work, at + patches__ISLAND_STOP))))
        {
            while((i < strips) && ((*cspan_at(&work, stations + i)) < station))
            {
                i += INT64_C(1);
            }
            /* between strips i - 1 and i, or between one of them and the edge */
            low = (*cspan_at(&work, at + patches__ISLAND_START));
            low_square = 0.0;
            low_pressure = 0.0;
            if (i > INT64_C(0))
            {
                if ((*cspan_at(&work, stations + i - INT64_C(1))) > low)
                {
                    low = (*cspan_at(&work, stations + i - INT64_C(1)));
                    low_square = (*cspan_at(&work, squares + i - INT64_C(1)));
                    low_pressure = (*cspan_at(&work, pressures + i - INT64_C(1)));
                }
            }
            high = (*cspan_at(&work, at + patches__ISLAND_STOP));
            high_square = 0.0;
            high_pressure = 0.0;
            if (i < strips)
            {
                if ((*cspan_at(&work, stations + i)) < high)
                {
                    high = (*cspan_at(&work, stations + i));
                    high_square = (*cspan_at(&work, squares + i));
                    high_pressure = (*cspan_at(&work, pressures + i));
                }
            }
            share = (station - low) / (high - low);
            half = sqrt(low_square + share * (high_square - low_square));
            pressure = sqrt(low_pressure * low_pressure + share * (high_pressure * high_pressure - low_pressure * low_pressure));
        }
        (*cspan_at(&work, place + j)) = station;
        (*cspan_at(&work, place + count + j)) = half;
        (*cspan_at(&work, place + INT64_C(2) * count + j)) = pressure;
    }
    return INT64_C(0);
}
