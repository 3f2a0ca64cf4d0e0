/* Generated from patch/outline.py by tools/transpile_kernel.py; change that one.
 *
 * The outline of a wheel's patches: half-length and pressure at evenly spaced stations, from the first edge
 * to the last.
 *
 * With STATION_COUNT stations it is part of the outputs of its side.  With another number the outlines of both
 * sides, left then right, follow all outputs, and the places for it among the outputs of the side stay zero.
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
        size += INT64_C(2) * layout__RUN_COUNT * stations;
    }
    return size;
}

/* Write ``value`` all over an outline. */
static inline int64_t outline__fill_outline(array_double_1d work, int64_t outline, int64_t stations, double value)
{
    int64_t i;
    for (i = INT64_C(0); i < layout__RUN_COUNT * stations; i += INT64_C(1))
    {
        (*cspan_at(&work, outline + layout__OUTLINE_NUMBERS + i)) = value;
    }
    return INT64_C(0);
}

/* The outline of the solved patches of ``count`` regions at ``stations`` stations. */
static inline int64_t outline__write_outline(array_double_1d work, int64_t outline, int64_t stations, int64_t count)
{
    int64_t rule;
    if ((int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_COUNT))) > INT64_C(0))
    {
        rule = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_RULE)));
        if (rule == layout__RULE_ELLIPSE)
        {
            outline__write_ellipse(work, outline, stations, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS);
        }
        else if (rule == layout__RULE_QUADRATIC)
        {
            outline__write_quadratic(work, outline, stations, count);
        }
        else
        {
            outline__write_straight(work, outline, stations);
        }
    }
    return INT64_C(0);
}

/* The outline of a single elliptic patch around station zero. */
static inline int64_t outline__write_ellipse(array_double_1d work, int64_t outline, int64_t stations, int64_t totals)
{
    double half_length;
    double half_width;
    double pressure;
    int64_t j;
    double share;
    double height;
    half_length = (*cspan_at(&work, totals + layout__PATCH_TOTALS_MAX_HALF_LENGTH));
    half_width = (*cspan_at(&work, totals + layout__PATCH_TOTALS_STOP));
    pressure = (*cspan_at(&work, totals + layout__PATCH_TOTALS_MAX_PRESSURE));
    for (j = INT64_C(0); j < stations; j += INT64_C(1))
    {
        share = 2.0 * (double)(j) / (double)(stations - INT64_C(1)) - 1.0;
        height = sqrt(1.0 - share * share);
        (*cspan_at(&work, outline + layout__OUTLINE_NUMBERS + j)) = share * half_width;
        (*cspan_at(&work, outline + layout__OUTLINE_NUMBERS + (stations + j))) = half_length * height;
        (*cspan_at(&work, outline + layout__OUTLINE_NUMBERS + (INT64_C(2) * stations + j))) = pressure * height;
    }
    return INT64_C(0);
}

/* The outline of patches with RULE_QUADRATIC.  The quadratics can rise above the largest values where the
 * surfaces have a kink; they are cut there.
 */
static inline int64_t outline__write_quadratic(array_double_1d work, int64_t outline, int64_t stations, int64_t count)
{
    double start;
    double stop;
    double largest;
    double peak;
    int64_t j;
    double station;
    double half_length;
    double pressure;
    start = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_START));
    stop = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_STOP));
    largest = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_MAX_HALF_LENGTH));
    peak = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_MAX_PRESSURE));
    for (j = INT64_C(0); j < stations; j += INT64_C(1))
    {
        station = start + (stop - start) * (double)(j) / (double)(stations - INT64_C(1));
        half_length = 0.0;
        pressure = 0.0;
        if ((j > INT64_C(0)) && (j < stations - INT64_C(1)))
        {
            interpolation__quadratic_at(&half_length, &pressure, work, count, station);
        }
        if (half_length > largest)
        {
            half_length = largest;
        }
        if (pressure > peak)
        {
            pressure = peak;
        }
        (*cspan_at(&work, outline + layout__OUTLINE_NUMBERS + j)) = station;
        (*cspan_at(&work, outline + layout__OUTLINE_NUMBERS + (stations + j))) = half_length;
        (*cspan_at(&work, outline + layout__OUTLINE_NUMBERS + (INT64_C(2) * stations + j))) = pressure;
    }
    return INT64_C(0);
}

/* The outline of patches with RULE_STRAIGHT. */
static inline int64_t outline__write_straight(array_double_1d work, int64_t outline, int64_t stations)
{
    double start;
    double stop;
    int64_t index;
    int64_t strip;
    int64_t j;
    double station;
    double half_length;
    double pressure;
    int64_t patch;
    start = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_START));
    stop = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_STOP));
    index = INT64_C(0);
    strip = INT64_C(0);
    for (j = INT64_C(0); j < stations; j += INT64_C(1))
    {
        station = start + (stop - start) * (double)(j) / (double)(stations - INT64_C(1));
        half_length = 0.0;
        pressure = 0.0;
        index = outline__patch_beside(work, index, station);
        patch = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_SIZE * index;
        if ((j > INT64_C(0)) && (j < stations - INT64_C(1)) && (station > (*cspan_at(&work, patch + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_START))) && (station < (*cspan_at(&work, patch + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_STOP))))
        {
            if (strip < (int64_t)((*cspan_at(&work, patch + layout__SOLVED_PATCH_FIRST))))
            {
                strip = (int64_t)((*cspan_at(&work, patch + layout__SOLVED_PATCH_FIRST)));
            }
            while((strip <= (int64_t)((*cspan_at(&work, patch + layout__SOLVED_PATCH_LAST)))) && ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_STRIPS + layout__SOLVED_STRIP_SIZE * strip + layout__SOLVED_STRIP_STATION)) < station))
            {
                strip += INT64_C(1);
            }
            interpolation__straight_at(&half_length, &pressure, work, patch, strip, station);
        }
        (*cspan_at(&work, outline + layout__OUTLINE_NUMBERS + j)) = station;
        (*cspan_at(&work, outline + layout__OUTLINE_NUMBERS + (stations + j))) = half_length;
        (*cspan_at(&work, outline + layout__OUTLINE_NUMBERS + (INT64_C(2) * stations + j))) = pressure;
    }
    return INT64_C(0);
}

/* The first patch from ``index`` on that does not end before ``station`` [m]; the last one if all do. */
static inline int64_t outline__patch_beside(array_double_1d work, int64_t index, double station)
{
    while((index < (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_COUNT))) - INT64_C(1)) && (station > (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_SIZE * index + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_STOP))))
    {
        index += INT64_C(1);
    }
    return index;
}
