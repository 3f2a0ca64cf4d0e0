/* Generated from patch/outline.py by tools/transpile_kernel.py; change that one.
 *
 * The outline of a wheel's patches: half-length and pressure at evenly spaced stations, from the first edge to the last.
 *
 * With STATION_COUNT stations it is part of the outputs of its side.  With another number the outlines of both sides, left then
 * right, follow all outputs, and the places for it among the outputs of the side stay zero.
 */

#include "outline.h"

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

/* Write ``value`` all over an outline. */
static inline int64_t outline__fill_outline(array_double_1d work, int64_t outline, int64_t stations, double value)
{
    int64_t i;
    for (i = INT64_C(0); i < INT64_C(3) * stations; i += INT64_C(1))
    {
        (*cspan_at(&work, outline + layout__OUTLINE_NUMBERS + i)) = value;
    }
    return INT64_C(0);
}

/* The outline of the solved patches at ``stations`` stations; the totals of ``side`` are known. */
static inline int64_t outline__write_outline(array_double_1d work, int64_t outline, int64_t stations, int64_t side)
{
    if ((int64_t)((*cspan_at(&work, layout__WORK_SOLVED + layout__SOLVED_PATCHES_COUNT))) > INT64_C(0))
    {
        if ((int64_t)((*cspan_at(&work, layout__WORK_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_RULE))) == layout__RULE_ELLIPSE)
        {
            outline__write_ellipse(work, outline, stations, layout__WORK_SOLVED + layout__SOLVED_PATCHES_PATCHES);
        }
        else if ((int64_t)((*cspan_at(&work, layout__WORK_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_RULE))) == layout__RULE_QUADRATIC)
        {
            outline__write_quadratic(work, outline, stations, side);
        }
        else
        {
            outline__write_straight(work, outline, stations);
        }
    }
    return INT64_C(0);
}

/* Station ``j`` of an outline. */
static inline int64_t outline__write_station(array_double_1d work, int64_t outline, int64_t stations, int64_t j, double station, double half_length, double pressure)
{
    (*cspan_at(&work, outline + layout__OUTLINE_NUMBERS + j)) = station;
    (*cspan_at(&work, outline + layout__OUTLINE_NUMBERS + (stations + j))) = half_length;
    (*cspan_at(&work, outline + layout__OUTLINE_NUMBERS + (INT64_C(2) * stations + j))) = pressure;
    return INT64_C(0);
}

/* The outline of a single elliptic patch around station zero. */
static inline int64_t outline__write_ellipse(array_double_1d work, int64_t outline, int64_t stations, int64_t patch)
{
    int64_t j;
    double share;
    double height;
    for (j = INT64_C(0); j < stations; j += INT64_C(1))
    {
        share = 2.0 * (double)(j) / (double)(stations - INT64_C(1)) - 1.0;
        height = sqrt(1.0 - share * share);
        outline__write_station(work, outline, stations, j, share * (*cspan_at(&work, patch + layout__SOLVED_PATCH_STOP)), (*cspan_at(&work, patch + layout__SOLVED_PATCH_MAX_HALF_LENGTH)) * height, (*cspan_at(&work, patch + layout__SOLVED_PATCH_MAX_PRESSURE)) * height);
    }
    return INT64_C(0);
}

/* The first patch from ``index`` on that does not end before ``station`` [m]; the last one if all do. */
static inline int64_t outline__patch_beside(array_double_1d work, int64_t index, double station)
{
    while((index < (int64_t)((*cspan_at(&work, layout__WORK_SOLVED + layout__SOLVED_PATCHES_COUNT))) - INT64_C(1)) && (station > (*cspan_at(&work, layout__WORK_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_SIZE * index + layout__SOLVED_PATCH_STOP))))
    {
        index += INT64_C(1);
    }
    return index;
}

/* The outline of patches with RULE_QUADRATIC.  The quadratics can rise above the largest values where the surfaces have a
 * kink; they are cut there.
 */
static inline int64_t outline__write_quadratic(array_double_1d work, int64_t outline, int64_t stations, int64_t side)
{
    double start;
    int64_t last;
    double stop;
    int64_t index;
    int64_t j;
    double station;
    double half_length;
    double pressure;
    start = (*cspan_at(&work, layout__WORK_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_START));
    last = layout__WORK_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_SIZE * ((int64_t)((*cspan_at(&work, layout__WORK_SOLVED + layout__SOLVED_PATCHES_COUNT))) - INT64_C(1));
    stop = (*cspan_at(&work, last + layout__SOLVED_PATCH_STOP));
    index = INT64_C(0);
    for (j = INT64_C(0); j < stations; j += INT64_C(1))
    {
        station = start + (stop - start) * (double)(j) / (double)(stations - INT64_C(1));
        half_length = 0.0;
        pressure = 0.0;
        if ((j > INT64_C(0)) && (j < stations - INT64_C(1)))
        {
            index = outline__patch_beside(work, index, station);
            interpolation__quadratic_at(&half_length, &pressure, work, index, station);
        }
        if (half_length > 0.5 * (*cspan_at(&work, side + layout__SIDE_OUTPUTS_PATCH_LENGTH)))
        {
            half_length = 0.5 * (*cspan_at(&work, side + layout__SIDE_OUTPUTS_PATCH_LENGTH));
        }
        if (pressure > (*cspan_at(&work, side + layout__SIDE_OUTPUTS_MAX_PRESSURE)))
        {
            pressure = (*cspan_at(&work, side + layout__SIDE_OUTPUTS_MAX_PRESSURE));
        }
        outline__write_station(work, outline, stations, j, station, half_length, pressure);
    }
    return INT64_C(0);
}

/* The outline of patches with RULE_STRAIGHT. */
static inline int64_t outline__write_straight(array_double_1d work, int64_t outline, int64_t stations)
{
    double start;
    int64_t last;
    double stop;
    int64_t index;
    int64_t strip;
    int64_t j;
    double station;
    double half_length;
    double pressure;
    int64_t patch;
    start = (*cspan_at(&work, layout__WORK_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_START));
    last = layout__WORK_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_SIZE * ((int64_t)((*cspan_at(&work, layout__WORK_SOLVED + layout__SOLVED_PATCHES_COUNT))) - INT64_C(1));
    stop = (*cspan_at(&work, last + layout__SOLVED_PATCH_STOP));
    index = INT64_C(0);
    strip = INT64_C(0);
    for (j = INT64_C(0); j < stations; j += INT64_C(1))
    {
        station = start + (stop - start) * (double)(j) / (double)(stations - INT64_C(1));
        half_length = 0.0;
        pressure = 0.0;
        index = outline__patch_beside(work, index, station);
        patch = layout__WORK_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_SIZE * index;
        if ((j > INT64_C(0)) && (j < stations - INT64_C(1)) && (station > (*cspan_at(&work, patch + layout__SOLVED_PATCH_START))) && (station < (*cspan_at(&work, patch + layout__SOLVED_PATCH_STOP))))
        {
            if (strip < (int64_t)((*cspan_at(&work, patch + layout__SOLVED_PATCH_FIRST))))
            {
                strip = (int64_t)((*cspan_at(&work, patch + layout__SOLVED_PATCH_FIRST)));
            }
            while((strip <= (int64_t)((*cspan_at(&work, patch + layout__SOLVED_PATCH_LAST)))) && ((*cspan_at(&work, layout__WORK_SOLVED + layout__SOLVED_PATCHES_STRIPS + layout__SOLVED_STRIP_SIZE * strip + layout__SOLVED_STRIP_STATION)) < station))
            {
                strip += INT64_C(1);
            }
            interpolation__straight_at(&half_length, &pressure, work, patch, strip, station);
        }
        outline__write_station(work, outline, stations, j, station, half_length, pressure);
    }
    return INT64_C(0);
}
