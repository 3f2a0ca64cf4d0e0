/* Generated from patch/strip_patches.py by tools/transpile_kernel.py; change that one.
 *
 * From corrected strips to contact patches: edges, loads, areas and pressures.
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
    return width * quadrature__root_integral(2.0 * low - high + 2.0 * bend * width * width, low, high, 0.0, 1.0);
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

/* Fill the solved patches from the runs of loaded strips. */
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
    int64_t index;
    int64_t patch;
    int64_t i;
    double load;
    int64_t carrier;
    int64_t strip;
    double pressure;
    for (region = INT64_C(0); region < layout__REGION_LIMIT; region += INT64_C(1))
    {
        (*cspan_at(&work, layout__WORK_REGIONS + layout__REGION_SIZE * region + layout__REGION_CARRIED)) = 0.0;
        (*cspan_at(&work, layout__WORK_REGIONS + layout__REGION_SIZE * region + layout__REGION_MOMENT)) = 0.0;
    }
    filling__clear_patches(work);
    stations = strips__strip_field(strips__STRIP_STATION);
    widths = strips__strip_field(strips__STRIP_WIDTH);
    lines = strips__strip_field(strips__STRIP_LINE);
    squares = strips__strip_field(strips__STRIP_SQUARE);
    pressures = strips__strip_field(strips__STRIP_PRESSURE);
    first = INT64_C(0);
    while((first < strips) && ((int64_t)((*cspan_at(&work, layout__WORK_SOLVED + layout__SOLVED_PATCHES_COUNT))) < layout__SOLVED_PATCH_LIMIT))
    {
        last = first;
        if ((*cspan_at(&work, lines + first)) > 0.0)
        {
            last = strips__run_end(work, strips, first);
            block = layout__WORK_REGIONS + layout__REGION_SIZE * (int64_t)((*cspan_at(&work, strips__strip_field(strips__STRIP_REGION) + first)));
            start = strips__run_edge(work, strips, first, last, -INT64_C(1));
            stop = strips__run_edge(work, strips, last, first, INT64_C(1));
            index = filling__begin_patch(work, block, start, first, layout__RULE_STRAIGHT, -atan((*cspan_at(&work, block + layout__REGION_LEAN))));
            patch = layout__WORK_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_SIZE * index;
            for (i = first; i < last + INT64_C(1); i += INT64_C(1))
            {
                load = (*cspan_at(&work, lines + i)) * (*cspan_at(&work, widths + i));
                (*cspan_at(&work, patch + layout__SOLVED_PATCH_LOAD)) += load;
                (*cspan_at(&work, patch + layout__SOLVED_PATCH_MOMENT)) += load * (*cspan_at(&work, stations + i));
                region = (int64_t)((*cspan_at(&work, strips__strip_field(strips__STRIP_REGION) + i)));
                carrier = layout__WORK_REGIONS + layout__REGION_SIZE * region;
                (*cspan_at(&work, carrier + layout__REGION_CARRIED)) += load;
                (*cspan_at(&work, carrier + layout__REGION_MOMENT)) += load * (*cspan_at(&work, stations + i));
                strip = layout__WORK_SOLVED + layout__SOLVED_PATCHES_STRIPS + layout__SOLVED_STRIP_SIZE * i;
                (*cspan_at(&work, strip + layout__SOLVED_STRIP_STATION)) = (*cspan_at(&work, stations + i));
                (*cspan_at(&work, strip + layout__SOLVED_STRIP_WIDTH)) = (*cspan_at(&work, widths + i));
                (*cspan_at(&work, strip + layout__SOLVED_STRIP_X)) = (*cspan_at(&work, carrier + layout__REGION_ALONG)) + (*cspan_at(&work, carrier + layout__REGION_SLANT)) * ((*cspan_at(&work, stations + i)) - (*cspan_at(&work, carrier + layout__REGION_OFFSET)) - (*cspan_at(&work, carrier + layout__REGION_STATION)));
                (*cspan_at(&work, strip + layout__SOLVED_STRIP_CURVATURE)) = 2.0 * (*cspan_at(&work, strips__strip_field(strips__STRIP_A) + i));
                (*cspan_at(&work, strip + layout__SOLVED_STRIP_LINE_LOAD)) = (*cspan_at(&work, lines + i));
                (*cspan_at(&work, strip + layout__SOLVED_STRIP_HALF_LENGTH_SQUARE)) = (*cspan_at(&work, squares + i));
                (*cspan_at(&work, strip + layout__SOLVED_STRIP_PRESSURE_SQUARE)) = (*cspan_at(&work, pressures + i)) * (*cspan_at(&work, pressures + i));
                (*cspan_at(&work, strip + layout__SOLVED_STRIP_REGION)) = (double)(region);
            }
            (*cspan_at(&work, patch + layout__SOLVED_PATCH_STOP)) = stop;
            (*cspan_at(&work, patch + layout__SOLVED_PATCH_LAST)) = (double)(last);
            (*cspan_at(&work, patch + layout__SOLVED_PATCH_AREA)) = strip_patches__run_area(work, first, last, start, stop);
            pressure = strip_patches__top_value(work, pressures, strip_patches__largest_of(work, pressures, first, last), first, last);
            (*cspan_at(&work, layout__WORK_SOLVED + layout__SOLVED_PATCHES_PRESSURE_SQUARE)) = pressure * pressure;
            (*cspan_at(&work, layout__WORK_SOLVED + layout__SOLVED_PATCHES_HALF_LENGTH_SQUARE)) = strip_patches__top_value(work, squares, strip_patches__largest_of(work, squares, first, last), first, last);
            filling__finish_patch(work);
        }
        first = last + INT64_C(1);
    }
    filling__rank_patches(work);
    return INT64_C(0);
}
