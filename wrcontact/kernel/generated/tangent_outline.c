/* Generated from tangent_outline.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of outline.py.
 */

#include "tangent_outline.h"

/* Tangent of ``fill_outline``. */
static inline int64_t tangent_outline__fill_outline_t(array_double_1d work, array_double_1d work_t, int64_t outline, int64_t stations, double value, double value_t)
{
    int64_t i;
    for (i = INT64_C(0); i < INT64_C(3) * stations; i += INT64_C(1))
    {
        (*cspan_at(&work_t, outline + layout__OUTLINE_NUMBERS + i)) = value_t;
        (*cspan_at(&work, outline + layout__OUTLINE_NUMBERS + i)) = value;
    }
    return INT64_C(0);
}

/* Tangent of ``write_outline``. */
static inline int64_t tangent_outline__write_outline_t(array_double_1d work, array_double_1d work_t, int64_t outline, int64_t stations, int64_t side)
{
    if ((int64_t)((*cspan_at(&work, layout__WORK_SOLVED + layout__SOLVED_PATCHES_COUNT))) > INT64_C(0))
    {
        if ((int64_t)((*cspan_at(&work, layout__WORK_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_RULE))) == layout__RULE_ELLIPSE)
        {
            tangent_outline__write_ellipse_t(work, work_t, outline, stations, layout__WORK_SOLVED + layout__SOLVED_PATCHES_PATCHES);
        }
        else if ((int64_t)((*cspan_at(&work, layout__WORK_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_RULE))) == layout__RULE_QUADRATIC)
        {
            tangent_outline__write_quadratic_t(work, work_t, outline, stations, side);
        }
        else
        {
            tangent_outline__write_straight_t(work, work_t, outline, stations);
        }
    }
    return INT64_C(0);
}

/* Tangent of ``write_station``. */
static inline int64_t tangent_outline__write_station_t(array_double_1d work, array_double_1d work_t, int64_t outline, int64_t stations, int64_t j, double station, double station_t, double half_length, double half_length_t, double pressure, double pressure_t)
{
    (*cspan_at(&work_t, outline + layout__OUTLINE_NUMBERS + j)) = station_t;
    (*cspan_at(&work, outline + layout__OUTLINE_NUMBERS + j)) = station;
    (*cspan_at(&work_t, outline + layout__OUTLINE_NUMBERS + (stations + j))) = half_length_t;
    (*cspan_at(&work, outline + layout__OUTLINE_NUMBERS + (stations + j))) = half_length;
    (*cspan_at(&work_t, outline + layout__OUTLINE_NUMBERS + (INT64_C(2) * stations + j))) = pressure_t;
    (*cspan_at(&work, outline + layout__OUTLINE_NUMBERS + (INT64_C(2) * stations + j))) = pressure;
    return INT64_C(0);
}

/* Tangent of ``write_ellipse``. */
static inline int64_t tangent_outline__write_ellipse_t(array_double_1d work, array_double_1d work_t, int64_t outline, int64_t stations, int64_t patch)
{
    int64_t j;
    double share;
    double height;
    for (j = INT64_C(0); j < stations; j += INT64_C(1))
    {
        share = 2.0 * (double)(j) / (double)(stations - INT64_C(1)) - 1.0;
        height = sqrt(1.0 - share * share);
        tangent_outline__write_station_t(work, work_t, outline, stations, j, share * (*cspan_at(&work, patch + layout__SOLVED_PATCH_STOP)), share * (*cspan_at(&work_t, patch + layout__SOLVED_PATCH_STOP)), (*cspan_at(&work, patch + layout__SOLVED_PATCH_MAX_HALF_LENGTH)) * height, (*cspan_at(&work_t, patch + layout__SOLVED_PATCH_MAX_HALF_LENGTH)) * height, (*cspan_at(&work, patch + layout__SOLVED_PATCH_MAX_PRESSURE)) * height, (*cspan_at(&work_t, patch + layout__SOLVED_PATCH_MAX_PRESSURE)) * height);
    }
    return INT64_C(0);
}

/* Tangent of ``write_quadratic``. */
static inline int64_t tangent_outline__write_quadratic_t(array_double_1d work, array_double_1d work_t, int64_t outline, int64_t stations, int64_t side)
{
    double start_t;
    double start;
    int64_t last;
    double stop_t;
    double stop;
    int64_t index;
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
    start_t = (*cspan_at(&work_t, layout__WORK_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_START));
    start = (*cspan_at(&work, layout__WORK_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_START));
    last = layout__WORK_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_SIZE * ((int64_t)((*cspan_at(&work, layout__WORK_SOLVED + layout__SOLVED_PATCHES_COUNT))) - INT64_C(1));
    stop_t = (*cspan_at(&work_t, last + layout__SOLVED_PATCH_STOP));
    stop = (*cspan_at(&work, last + layout__SOLVED_PATCH_STOP));
    index = INT64_C(0);
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
            index = outline__patch_beside(work, index, station);
            tangent_interpolation__quadratic_at_t(&half_length, &half_length_t, &pressure, &pressure_t, work, work_t, index, station, station_t);
        }
        if (half_length > 0.5 * (*cspan_at(&work, side + layout__SIDE_OUTPUTS_PATCH_LENGTH)))
        {
            half_length_t = 0.5 * (*cspan_at(&work_t, side + layout__SIDE_OUTPUTS_PATCH_LENGTH));
            half_length = 0.5 * (*cspan_at(&work, side + layout__SIDE_OUTPUTS_PATCH_LENGTH));
        }
        if (pressure > (*cspan_at(&work, side + layout__SIDE_OUTPUTS_MAX_PRESSURE)))
        {
            pressure_t = (*cspan_at(&work_t, side + layout__SIDE_OUTPUTS_MAX_PRESSURE));
            pressure = (*cspan_at(&work, side + layout__SIDE_OUTPUTS_MAX_PRESSURE));
        }
        tangent_outline__write_station_t(work, work_t, outline, stations, j, station, station_t, half_length, half_length_t, pressure, pressure_t);
    }
    return INT64_C(0);
}

/* Tangent of ``write_straight``. */
static inline int64_t tangent_outline__write_straight_t(array_double_1d work, array_double_1d work_t, int64_t outline, int64_t stations)
{
    double start_t;
    double start;
    int64_t last;
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
    start_t = (*cspan_at(&work_t, layout__WORK_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_START));
    start = (*cspan_at(&work, layout__WORK_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_START));
    last = layout__WORK_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_SIZE * ((int64_t)((*cspan_at(&work, layout__WORK_SOLVED + layout__SOLVED_PATCHES_COUNT))) - INT64_C(1));
    stop_t = (*cspan_at(&work_t, last + layout__SOLVED_PATCH_STOP));
    stop = (*cspan_at(&work, last + layout__SOLVED_PATCH_STOP));
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
        patch = layout__WORK_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_SIZE * index;
        if ((j > INT64_C(0)) && (j < stations - INT64_C(1)) && (station > (*cspan_at(&work, patch + layout__SOLVED_PATCH_START))) && (station < (*cspan_at(&work, patch + layout__SOLVED_PATCH_STOP))))
        {
            if (strip < (int64_t)((*cspan_at(&work, patch + layout__SOLVED_PATCH_FIRST))))
            {
                strip = (int64_t)((*cspan_at(&work, patch + layout__SOLVED_PATCH_FIRST)));
            }
            while((strip <= (int64_t)((*cspan_at(&work, patch + layout__SOLVED_PATCH_LAST)))) && ((*cspan_at(&work, layout__WORK_SOLVED + layout__SOLVED_PATCHES_STRIPS + layout__SOLVED_STRIP_SIZE * strip + layout__SOLVED_STRIP_STATION)) < station))
            {
                strip = strip + INT64_C(1);
            }
            tangent_interpolation__straight_at_t(&half_length, &half_length_t, &pressure, &pressure_t, work, work_t, patch, strip, station, station_t);
        }
        tangent_outline__write_station_t(work, work_t, outline, stations, j, station, station_t, half_length, half_length_t, pressure, pressure_t);
    }
    return INT64_C(0);
}
