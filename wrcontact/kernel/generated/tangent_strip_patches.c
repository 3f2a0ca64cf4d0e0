/* Generated from tangent_strip_patches.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of strip_patches.py.
 */

#include "tangent_strip_patches.h"

/* Tangent of ``divided_bend``. */
static inline int64_t tangent_strip_patches__divided_bend_t(double* v7, double* result_1, array_double_1d work, array_double_1d work_t, int64_t field, int64_t i)
{
    int64_t stations;
    double left_t;
    double left;
    double right_t;
    double right;
    double v1;
    double v2;
    double after_t;
    double after;
    double v3;
    double v4;
    double before_t;
    double before;
    double v5;
    double v6;
    stations = strips__strip_field(strips__STRIP_STATION);
    left_t = (*cspan_at(&work_t, stations + i)) - (*cspan_at(&work_t, stations + i - INT64_C(1)));
    left = (*cspan_at(&work, stations + i)) - (*cspan_at(&work, stations + i - INT64_C(1)));
    right_t = (*cspan_at(&work_t, stations + i + INT64_C(1))) - (*cspan_at(&work_t, stations + i));
    right = (*cspan_at(&work, stations + i + INT64_C(1))) - (*cspan_at(&work, stations + i));
    v1 = (*cspan_at(&work, field + i + INT64_C(1))) - (*cspan_at(&work, field + i));
    v2 = v1 / right;
    after_t = ((*cspan_at(&work_t, field + i + INT64_C(1))) - (*cspan_at(&work_t, field + i)) - v2 * right_t) / right;
    after = v2;
    v3 = (*cspan_at(&work, field + i)) - (*cspan_at(&work, field + i - INT64_C(1)));
    v4 = v3 / left;
    before_t = ((*cspan_at(&work_t, field + i)) - (*cspan_at(&work_t, field + i - INT64_C(1))) - v4 * left_t) / left;
    before = v4;
    v5 = after - before;
    v6 = left + right;
    (*v7) = v5 / v6;
    (*result_1) = (after_t - before_t - (*v7) * (left_t + right_t)) / v6;
    return 0;
}

/* Tangent of ``cell_bend``. */
static inline int64_t tangent_strip_patches__cell_bend_t(double* bend, double* bend_t, array_double_1d work, array_double_1d work_t, int64_t field, int64_t i, int64_t first, int64_t last)
{
    double found;
    double v1;
    double v1_t;
    double v2;
    double v2_t;
    (*bend_t) = 0.0;
    (*bend) = 0.0;
    found = 0.0;
    if ((i > first) && (i < last))
    {
        tangent_strip_patches__divided_bend_t(&v1, &v1_t, work, work_t, field, i);
        (*bend_t) = (*bend_t) + v1_t;
        (*bend) = (*bend) + v1;
        found = found + 1.0;
    }
    if ((i + INT64_C(1) < last) && (i + INT64_C(1) > first))
    {
        tangent_strip_patches__divided_bend_t(&v2, &v2_t, work, work_t, field, i + INT64_C(1));
        (*bend_t) = (*bend_t) + v2_t;
        (*bend) = (*bend) + v2;
        found = found + 1.0;
    }
    if (found > 0.0)
    {
        (*bend_t) = (*bend_t) / found;
        (*bend) = (*bend) / found;
    }
    return 0;
}

/* Tangent of ``cell_area``. */
static inline int64_t tangent_strip_patches__cell_area_t(double* result_0, double* result_1, double low, double low_t, double high, double high_t, double bend, double bend_t, double width, double width_t)
{
    double v2;
    double v3;
    double v1;
    double v1_t;
    v2 = 2.0 * bend;
    v3 = v2 * width;
    tangent_quadrature__root_integral_t(&v1, &v1_t, 2.0 * low - high + v3 * width, 2.0 * low_t - high_t + ((2.0 * bend_t * width + v2 * width_t) * width + v3 * width_t), low, low_t, high, high_t, 0.0, 0.0, 1.0, 0.0);
    (*result_0) = width * v1;
    (*result_1) = width_t * v1 + width * v1_t;
    return 0;
}

/* Tangent of ``run_area``. */
static inline int64_t tangent_strip_patches__run_area_t(double* result_0, double* result_1, array_double_1d work, array_double_1d work_t, int64_t first, int64_t last, double start, double start_t, double stop, double stop_t)
{
    int64_t stations;
    int64_t squares;
    double v1;
    double v1_t;
    double bend_t;
    double bend;
    double v2;
    double v2_t;
    double half_t;
    double half;
    int64_t i;
    double v3;
    double v3_t;
    double v4;
    double v4_t;
    double v5;
    double v5_t;
    double v6;
    double v6_t;
    stations = strips__strip_field(strips__STRIP_STATION);
    squares = strips__strip_field(strips__STRIP_SQUARE);
    tangent_strip_patches__cell_bend_t(&v1, &v1_t, work, work_t, squares, first, first, last);
    bend_t = v1_t;
    bend = v1;
    tangent_strip_patches__cell_area_t(&v2, &v2_t, 0.0, 0.0, (*cspan_at(&work, squares + first)), (*cspan_at(&work_t, squares + first)), bend, bend_t, (*cspan_at(&work, stations + first)) - start, (*cspan_at(&work_t, stations + first)) - start_t);
    half_t = v2_t;
    half = v2;
    for (i = first; i < last; i += INT64_C(1))
    {
        tangent_strip_patches__cell_bend_t(&v3, &v3_t, work, work_t, squares, i, first, last);
        bend_t = v3_t;
        bend = v3;
        tangent_strip_patches__cell_area_t(&v4, &v4_t, (*cspan_at(&work, squares + i)), (*cspan_at(&work_t, squares + i)), (*cspan_at(&work, squares + i + INT64_C(1))), (*cspan_at(&work_t, squares + i + INT64_C(1))), bend, bend_t, (*cspan_at(&work, stations + i + INT64_C(1))) - (*cspan_at(&work, stations + i)), (*cspan_at(&work_t, stations + i + INT64_C(1))) - (*cspan_at(&work_t, stations + i)));
        half_t = half_t + v4_t;
        half = half + v4;
    }
    tangent_strip_patches__cell_bend_t(&v5, &v5_t, work, work_t, squares, last - INT64_C(1), first, last);
    bend_t = v5_t;
    bend = v5;
    tangent_strip_patches__cell_area_t(&v6, &v6_t, (*cspan_at(&work, squares + last)), (*cspan_at(&work_t, squares + last)), 0.0, 0.0, bend, bend_t, stop - (*cspan_at(&work, stations + last)), stop_t - (*cspan_at(&work_t, stations + last)));
    half_t = half_t + v6_t;
    half = half + v6;
    (*result_0) = 2.0 * half;
    (*result_1) = 2.0 * half_t;
    return 0;
}

/* Tangent of ``top_value``. */
static inline int64_t tangent_strip_patches__top_value_t(double* value, double* value_t, array_double_1d work, array_double_1d work_t, int64_t field, int64_t i, int64_t first, int64_t last)
{
    int64_t stations;
    double v1;
    double v1_t;
    double bend_t;
    double bend;
    double left_t;
    double left;
    double v2;
    double v3;
    double slope_t;
    double slope;
    double v4;
    double v5;
    double v6;
    (*value_t) = (*cspan_at(&work_t, field + i));
    (*value) = (*cspan_at(&work, field + i));
    if ((i > first) && (i < last))
    {
        stations = strips__strip_field(strips__STRIP_STATION);
        tangent_strip_patches__divided_bend_t(&v1, &v1_t, work, work_t, field, i);
        bend_t = v1_t;
        bend = v1;
        if (bend < 0.0)
        {
            left_t = (*cspan_at(&work_t, stations + i)) - (*cspan_at(&work_t, stations + i - INT64_C(1)));
            left = (*cspan_at(&work, stations + i)) - (*cspan_at(&work, stations + i - INT64_C(1)));
            v2 = (*value) - (*cspan_at(&work, field + i - INT64_C(1)));
            v3 = v2 / left;
            slope_t = ((*value_t) - (*cspan_at(&work_t, field + i - INT64_C(1))) - v3 * left_t) / left + (bend_t * left + bend * left_t);
            slope = v3 + bend * left;
            v4 = slope * slope;
            v5 = 4.0 * bend;
            v6 = v4 / v5;
            (*value_t) = (*value_t) - (slope_t * slope + slope * slope_t - v6 * (4.0 * bend_t)) / v5;
            (*value) = (*value) - v6;
        }
    }
    return 0;
}

/* Tangent of ``gather_strips``. */
static inline int64_t tangent_strip_patches__gather_strips_t(array_double_1d work, array_double_1d work_t, int64_t strips)
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
    double v1;
    double v1_t;
    double start_t;
    double start;
    double v2;
    double v2_t;
    double stop_t;
    double stop;
    int64_t n3;
    int64_t index;
    int64_t patch;
    int64_t i;
    double load_t;
    double load;
    int64_t carrier;
    int64_t strip;
    double v4;
    int64_t k5;
    double v6;
    double v6_t;
    double v7;
    double v7_t;
    double pressure_t;
    double pressure;
    double v8;
    double v8_t;
    for (region = INT64_C(0); region < layout__REGION_LIMIT; region += INT64_C(1))
    {
        (*cspan_at(&work_t, layout__WORK_REGIONS + layout__REGION_SIZE * region + layout__REGION_CARRIED)) = 0.0;
        (*cspan_at(&work, layout__WORK_REGIONS + layout__REGION_SIZE * region + layout__REGION_CARRIED)) = 0.0;
        (*cspan_at(&work_t, layout__WORK_REGIONS + layout__REGION_SIZE * region + layout__REGION_MOMENT)) = 0.0;
        (*cspan_at(&work, layout__WORK_REGIONS + layout__REGION_SIZE * region + layout__REGION_MOMENT)) = 0.0;
    }
    tangent_filling__clear_patches_t(work, work_t);
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
            tangent_strips__run_edge_t(&v1, &v1_t, work, work_t, strips, first, last, -INT64_C(1));
            start_t = v1_t;
            start = v1;
            tangent_strips__run_edge_t(&v2, &v2_t, work, work_t, strips, last, first, INT64_C(1));
            stop_t = v2_t;
            stop = v2;
            n3 = tangent_filling__begin_patch_t(work, work_t, block, start, start_t, first, layout__RULE_STRAIGHT, -atan((*cspan_at(&work, block + layout__REGION_LEAN))), -((*cspan_at(&work_t, block + layout__REGION_LEAN)) / (1.0 + (*cspan_at(&work, block + layout__REGION_LEAN)) * (*cspan_at(&work, block + layout__REGION_LEAN)))));
            index = n3;
            patch = layout__WORK_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_SIZE * index;
            for (i = first; i < last + INT64_C(1); i += INT64_C(1))
            {
                load_t = (*cspan_at(&work_t, lines + i)) * (*cspan_at(&work, widths + i)) + (*cspan_at(&work, lines + i)) * (*cspan_at(&work_t, widths + i));
                load = (*cspan_at(&work, lines + i)) * (*cspan_at(&work, widths + i));
                (*cspan_at(&work_t, patch + layout__SOLVED_PATCH_LOAD)) = (*cspan_at(&work_t, patch + layout__SOLVED_PATCH_LOAD)) + load_t;
                (*cspan_at(&work, patch + layout__SOLVED_PATCH_LOAD)) = (*cspan_at(&work, patch + layout__SOLVED_PATCH_LOAD)) + load;
                (*cspan_at(&work_t, patch + layout__SOLVED_PATCH_MOMENT)) = (*cspan_at(&work_t, patch + layout__SOLVED_PATCH_MOMENT)) + (load_t * (*cspan_at(&work, stations + i)) + load * (*cspan_at(&work_t, stations + i)));
                (*cspan_at(&work, patch + layout__SOLVED_PATCH_MOMENT)) = (*cspan_at(&work, patch + layout__SOLVED_PATCH_MOMENT)) + load * (*cspan_at(&work, stations + i));
                region = (int64_t)((*cspan_at(&work, strips__strip_field(strips__STRIP_REGION) + i)));
                carrier = layout__WORK_REGIONS + layout__REGION_SIZE * region;
                (*cspan_at(&work_t, carrier + layout__REGION_CARRIED)) = (*cspan_at(&work_t, carrier + layout__REGION_CARRIED)) + load_t;
                (*cspan_at(&work, carrier + layout__REGION_CARRIED)) = (*cspan_at(&work, carrier + layout__REGION_CARRIED)) + load;
                (*cspan_at(&work_t, carrier + layout__REGION_MOMENT)) = (*cspan_at(&work_t, carrier + layout__REGION_MOMENT)) + (load_t * (*cspan_at(&work, stations + i)) + load * (*cspan_at(&work_t, stations + i)));
                (*cspan_at(&work, carrier + layout__REGION_MOMENT)) = (*cspan_at(&work, carrier + layout__REGION_MOMENT)) + load * (*cspan_at(&work, stations + i));
                strip = layout__WORK_SOLVED + layout__SOLVED_PATCHES_STRIPS + layout__SOLVED_STRIP_SIZE * i;
                (*cspan_at(&work_t, strip + layout__SOLVED_STRIP_STATION)) = (*cspan_at(&work_t, stations + i));
                (*cspan_at(&work, strip + layout__SOLVED_STRIP_STATION)) = (*cspan_at(&work, stations + i));
                (*cspan_at(&work_t, strip + layout__SOLVED_STRIP_WIDTH)) = (*cspan_at(&work_t, widths + i));
                (*cspan_at(&work, strip + layout__SOLVED_STRIP_WIDTH)) = (*cspan_at(&work, widths + i));
                v4 = (*cspan_at(&work, stations + i)) - (*cspan_at(&work, carrier + layout__REGION_OFFSET)) - (*cspan_at(&work, carrier + layout__REGION_STATION));
                (*cspan_at(&work_t, strip + layout__SOLVED_STRIP_X)) = (*cspan_at(&work_t, carrier + layout__REGION_ALONG)) + ((*cspan_at(&work_t, carrier + layout__REGION_SLANT)) * v4 + (*cspan_at(&work, carrier + layout__REGION_SLANT)) * ((*cspan_at(&work_t, stations + i)) - (*cspan_at(&work_t, carrier + layout__REGION_OFFSET)) - (*cspan_at(&work_t, carrier + layout__REGION_STATION))));
                (*cspan_at(&work, strip + layout__SOLVED_STRIP_X)) = (*cspan_at(&work, carrier + layout__REGION_ALONG)) + (*cspan_at(&work, carrier + layout__REGION_SLANT)) * v4;
                k5 = strips__strip_field(strips__STRIP_A) + i;
                (*cspan_at(&work_t, strip + layout__SOLVED_STRIP_CURVATURE)) = 2.0 * (*cspan_at(&work_t, k5));
                (*cspan_at(&work, strip + layout__SOLVED_STRIP_CURVATURE)) = 2.0 * (*cspan_at(&work, k5));
                (*cspan_at(&work_t, strip + layout__SOLVED_STRIP_LINE_LOAD)) = (*cspan_at(&work_t, lines + i));
                (*cspan_at(&work, strip + layout__SOLVED_STRIP_LINE_LOAD)) = (*cspan_at(&work, lines + i));
                (*cspan_at(&work_t, strip + layout__SOLVED_STRIP_HALF_LENGTH_SQUARE)) = (*cspan_at(&work_t, squares + i));
                (*cspan_at(&work, strip + layout__SOLVED_STRIP_HALF_LENGTH_SQUARE)) = (*cspan_at(&work, squares + i));
                (*cspan_at(&work_t, strip + layout__SOLVED_STRIP_PRESSURE_SQUARE)) = (*cspan_at(&work_t, pressures + i)) * (*cspan_at(&work, pressures + i)) + (*cspan_at(&work, pressures + i)) * (*cspan_at(&work_t, pressures + i));
                (*cspan_at(&work, strip + layout__SOLVED_STRIP_PRESSURE_SQUARE)) = (*cspan_at(&work, pressures + i)) * (*cspan_at(&work, pressures + i));
                (*cspan_at(&work_t, strip + layout__SOLVED_STRIP_REGION)) = 0.0;
                (*cspan_at(&work, strip + layout__SOLVED_STRIP_REGION)) = (double)(region);
            }
            (*cspan_at(&work_t, patch + layout__SOLVED_PATCH_STOP)) = stop_t;
            (*cspan_at(&work, patch + layout__SOLVED_PATCH_STOP)) = stop;
            (*cspan_at(&work_t, patch + layout__SOLVED_PATCH_LAST)) = 0.0;
            (*cspan_at(&work, patch + layout__SOLVED_PATCH_LAST)) = (double)(last);
            tangent_strip_patches__run_area_t(&v6, &v6_t, work, work_t, first, last, start, start_t, stop, stop_t);
            (*cspan_at(&work_t, patch + layout__SOLVED_PATCH_AREA)) = v6_t;
            (*cspan_at(&work, patch + layout__SOLVED_PATCH_AREA)) = v6;
            tangent_strip_patches__top_value_t(&v7, &v7_t, work, work_t, pressures, strip_patches__largest_of(work, pressures, first, last), first, last);
            pressure_t = v7_t;
            pressure = v7;
            (*cspan_at(&work_t, layout__WORK_SOLVED + layout__SOLVED_PATCHES_PRESSURE_SQUARE)) = pressure_t * pressure + pressure * pressure_t;
            (*cspan_at(&work, layout__WORK_SOLVED + layout__SOLVED_PATCHES_PRESSURE_SQUARE)) = pressure * pressure;
            tangent_strip_patches__top_value_t(&v8, &v8_t, work, work_t, squares, strip_patches__largest_of(work, squares, first, last), first, last);
            (*cspan_at(&work_t, layout__WORK_SOLVED + layout__SOLVED_PATCHES_HALF_LENGTH_SQUARE)) = v8_t;
            (*cspan_at(&work, layout__WORK_SOLVED + layout__SOLVED_PATCHES_HALF_LENGTH_SQUARE)) = v8;
            tangent_filling__finish_patch_t(work, work_t);
        }
        first = last + INT64_C(1);
    }
    tangent_filling__rank_patches_t(work, work_t);
    return INT64_C(0);
}
