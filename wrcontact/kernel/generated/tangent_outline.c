/* Generated from tangent_outline.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of outline.py.
 */

#include "tangent_outline.h"

/* Tangent of ``fill_outline``. */
static inline int64_t tangent_outline__fill_outline_t(array_double_1d work, array_double_1d work_t, int64_t outline, int64_t stations, double value, double value_t)
{
    int64_t i;
    for (i = INT64_C(0); i < layout__RUN_COUNT * stations; i += INT64_C(1))
    {
        (*cspan_at(&work_t, outline + layout__OUTLINE_NUMBERS + i)) = value_t;
        (*cspan_at(&work, outline + layout__OUTLINE_NUMBERS + i)) = value;
    }
    return INT64_C(0);
}

/* Tangent of ``write_outline``. */
static inline int64_t tangent_outline__write_outline_t(array_double_1d work, array_double_1d work_t, int64_t outline, int64_t stations, int64_t count)
{
    int64_t rule;
    if ((int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_COUNT))) > INT64_C(0))
    {
        rule = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_RULE)));
        if (rule == layout__RULE_ELLIPSE)
        {
            tangent_outline__write_ellipse_t(work, work_t, outline, stations, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS);
        }
        else if (rule == layout__RULE_QUADRATIC)
        {
            tangent_outline__write_quadratic_t(work, work_t, outline, stations, count);
        }
        else
        {
            tangent_outline__write_straight_t(work, work_t, outline, stations);
        }
    }
    return INT64_C(0);
}

/* Tangent of ``write_ellipse``. */
static inline int64_t tangent_outline__write_ellipse_t(array_double_1d work, array_double_1d work_t, int64_t outline, int64_t stations, int64_t totals)
{
    double half_length_t;
    double half_length;
    double half_width_t;
    double half_width;
    double pressure_t;
    double pressure;
    int64_t j;
    double share;
    double height;
    half_length_t = (*cspan_at(&work_t, totals + layout__PATCH_TOTALS_MAX_HALF_LENGTH));
    half_length = (*cspan_at(&work, totals + layout__PATCH_TOTALS_MAX_HALF_LENGTH));
    half_width_t = (*cspan_at(&work_t, totals + layout__PATCH_TOTALS_STOP));
    half_width = (*cspan_at(&work, totals + layout__PATCH_TOTALS_STOP));
    pressure_t = (*cspan_at(&work_t, totals + layout__PATCH_TOTALS_MAX_PRESSURE));
    pressure = (*cspan_at(&work, totals + layout__PATCH_TOTALS_MAX_PRESSURE));
    for (j = INT64_C(0); j < stations; j += INT64_C(1))
    {
        share = 2.0 * (double)(j) / (double)(stations - INT64_C(1)) - 1.0;
        height = sqrt(1.0 - share * share);
        (*cspan_at(&work_t, outline + layout__OUTLINE_NUMBERS + j)) = share * half_width_t;
        (*cspan_at(&work, outline + layout__OUTLINE_NUMBERS + j)) = share * half_width;
        (*cspan_at(&work_t, outline + layout__OUTLINE_NUMBERS + (stations + j))) = half_length_t * height;
        (*cspan_at(&work, outline + layout__OUTLINE_NUMBERS + (stations + j))) = half_length * height;
        (*cspan_at(&work_t, outline + layout__OUTLINE_NUMBERS + (INT64_C(2) * stations + j))) = pressure_t * height;
        (*cspan_at(&work, outline + layout__OUTLINE_NUMBERS + (INT64_C(2) * stations + j))) = pressure * height;
    }
    return INT64_C(0);
}

/* Tangent of ``write_quadratic``. */
static inline int64_t tangent_outline__write_quadratic_t(array_double_1d work, array_double_1d work_t, int64_t outline, int64_t stations, int64_t count)
{
    double start_t;
    double start;
    double stop_t;
    double stop;
    double largest_t;
    double largest;
    double peak_t;
    double peak;
    int64_t j;
    double v1;
    double v2;
    double v3;
    double v4;
    double station_t;
    double station;
    double half_length_t;
    double half_length;
    double pressure_t;
    double pressure;
    start_t = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_START));
    start = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_START));
    stop_t = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_STOP));
    stop = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_STOP));
    largest_t = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_MAX_HALF_LENGTH));
    largest = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_MAX_HALF_LENGTH));
    peak_t = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_MAX_PRESSURE));
    peak = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_MAX_PRESSURE));
    for (j = INT64_C(0); j < stations; j += INT64_C(1))
    {
        v1 = stop - start;
        v2 = (double)(j);
        v3 = v1 * v2;
        v4 = (double)(stations - INT64_C(1));
        station_t = start_t + (stop_t - start_t) * v2 / v4;
        station = start + v3 / v4;
        half_length_t = 0.0;
        half_length = 0.0;
        pressure_t = 0.0;
        pressure = 0.0;
        if ((j > INT64_C(0)) && (j < stations - INT64_C(1)))
        {
            tangent_interpolation__quadratic_at_t(&half_length, &half_length_t, &pressure, &pressure_t, work, work_t, count, station, station_t);
        }
        if (half_length > largest)
        {
            half_length_t = largest_t;
            half_length = largest;
        }
        if (pressure > peak)
        {
            pressure_t = peak_t;
            pressure = peak;
        }
        (*cspan_at(&work_t, outline + layout__OUTLINE_NUMBERS + j)) = station_t;
        (*cspan_at(&work, outline + layout__OUTLINE_NUMBERS + j)) = station;
        (*cspan_at(&work_t, outline + layout__OUTLINE_NUMBERS + (stations + j))) = half_length_t;
        (*cspan_at(&work, outline + layout__OUTLINE_NUMBERS + (stations + j))) = half_length;
        (*cspan_at(&work_t, outline + layout__OUTLINE_NUMBERS + (INT64_C(2) * stations + j))) = pressure_t;
        (*cspan_at(&work, outline + layout__OUTLINE_NUMBERS + (INT64_C(2) * stations + j))) = pressure;
    }
    return INT64_C(0);
}

/* Tangent of ``write_straight``. */
static inline int64_t tangent_outline__write_straight_t(array_double_1d work, array_double_1d work_t, int64_t outline, int64_t stations)
{
    double start_t;
    double start;
    double stop_t;
    double stop;
    int64_t index;
    int64_t strip;
    int64_t j;
    double v1;
    double v2;
    double v3;
    double v4;
    double station_t;
    double station;
    double half_length_t;
    double half_length;
    double pressure_t;
    double pressure;
    int64_t patch;
    start_t = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_START));
    start = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_START));
    stop_t = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_STOP));
    stop = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_STOP));
    index = INT64_C(0);
    strip = INT64_C(0);
    for (j = INT64_C(0); j < stations; j += INT64_C(1))
    {
        v1 = stop - start;
        v2 = (double)(j);
        v3 = v1 * v2;
        v4 = (double)(stations - INT64_C(1));
        station_t = start_t + (stop_t - start_t) * v2 / v4;
        station = start + v3 / v4;
        half_length_t = 0.0;
        half_length = 0.0;
        pressure_t = 0.0;
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
                strip = strip + INT64_C(1);
            }
            tangent_interpolation__straight_at_t(&half_length, &half_length_t, &pressure, &pressure_t, work, work_t, patch, strip, station, station_t);
        }
        (*cspan_at(&work_t, outline + layout__OUTLINE_NUMBERS + j)) = station_t;
        (*cspan_at(&work, outline + layout__OUTLINE_NUMBERS + j)) = station;
        (*cspan_at(&work_t, outline + layout__OUTLINE_NUMBERS + (stations + j))) = half_length_t;
        (*cspan_at(&work, outline + layout__OUTLINE_NUMBERS + (stations + j))) = half_length;
        (*cspan_at(&work_t, outline + layout__OUTLINE_NUMBERS + (INT64_C(2) * stations + j))) = pressure_t;
        (*cspan_at(&work, outline + layout__OUTLINE_NUMBERS + (INT64_C(2) * stations + j))) = pressure;
    }
    return INT64_C(0);
}
