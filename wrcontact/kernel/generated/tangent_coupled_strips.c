/* Generated from tangent_coupled_strips.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of coupled_strips.py.
 */

#include "tangent_coupled_strips.h"

/* Tangent of ``solve_strips``. */
static inline int64_t tangent_coupled_strips__solve_strips_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t rolling)
{
    tangent_stiffness__find_stiffnesses_t(work, work_t, tables, rolling);
    tangent_coupled_strips__add_strips_t(work, work_t, tables, rolling);
    if (!((*cspan_at(&work, rolling + layout__ROLLING_PATCH_BARE)) == 1.0))
    {
        tangent_correction__correct_force_t(work, work_t, tables, rolling);
    }
    return INT64_C(0);
}

/* Tangent of ``add_strips``. */
static inline int64_t tangent_coupled_strips__add_strips_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t rolling)
{
    int64_t march;
    int64_t marches;
    double v1;
    double ratio_t;
    double ratio;
    double plane;
    double plane_t;
    double spinning;
    double spinning_t;
    double stuck_t;
    double stuck;
    int64_t i_end;
    int64_t i;
    int64_t strip;
    double v2;
    double v2_t;
    double rate_t;
    double rate;
    double v3;
    double v4;
    double v5;
    double v6;
    double v6_t;
    double v7;
    march = rolling + layout__ROLLING_PATCH_MARCH;
    marches = rolling + layout__ROLLING_PATCH_MARCHES;
    v1 = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_LENGTH)) / (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_WIDTH));
    ratio_t = ((*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_HALF_LENGTH)) - v1 * (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_HALF_WIDTH))) / (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_WIDTH));
    ratio = v1;
    tangent_coupled_strips__flexibilities_t(&plane, &plane_t, &spinning, &spinning_t, work, work_t, rolling);
    tangent_slip_march__open_marches_t(work, work_t, marches, ratio, ratio_t);
    stuck_t = 0.0;
    stuck = 0.0;
    i_end = (int64_t)((*cspan_at(&work, rolling + layout__ROLLING_PATCH_COUNT)));
    for (i = INT64_C(0); i < i_end; i += INT64_C(1))
    {
        strip = rolling + layout__ROLLING_PATCH_STRIPS + layout__ROLLING_STRIP_SIZE * i;
        tangent_tractions__bound_rate_t(&v2, &v2_t, work, work_t, rolling, strip);
        rate_t = v2_t;
        rate = v2;
        if (rate > 0.0)
        {
            tangent_coupled_strips__begin_march_t(work, work_t, rolling, strip, rate, rate_t, i);
            tangent_stick_zone__find_stick_zone_t(work, work_t, march, (*cspan_at(&work, strip + layout__ROLLING_STRIP_WIDTH)), (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_WIDTH)), ratio, ratio_t);
            tangent_slip_march__set_pushes_t(work, work_t, march, marches, i, plane, plane_t, spinning, spinning_t, ratio, ratio_t);
            tangent_slip_march__set_stick_t(tables, work, work_t, (int64_t)((*cspan_at(&tables, layout__TABLES_ROLLING))), march, marches, i);
            v3 = (*cspan_at(&work, march + layout__ROLLING_MARCH_HALF_LENGTH)) - (*cspan_at(&work, march + layout__ROLLING_MARCH_DEPTH));
            v4 = 2.0 * v3;
            v5 = v4 * (*cspan_at(&work, march + layout__ROLLING_MARCH_WEIGHT));
            stuck_t = stuck_t + ((2.0 * ((*cspan_at(&work_t, march + layout__ROLLING_MARCH_HALF_LENGTH)) - (*cspan_at(&work_t, march + layout__ROLLING_MARCH_DEPTH))) * (*cspan_at(&work, march + layout__ROLLING_MARCH_WEIGHT)) + v4 * (*cspan_at(&work_t, march + layout__ROLLING_MARCH_WEIGHT))) * (*cspan_at(&work, strip + layout__ROLLING_STRIP_WIDTH)) + v5 * (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_WIDTH)));
            stuck = stuck + v5 * (*cspan_at(&work, strip + layout__ROLLING_STRIP_WIDTH));
        }
    }
    tangent_slip_march__march_strips_t(tables, work, work_t, (int64_t)((*cspan_at(&tables, layout__TABLES_ROLLING))), marches);
    tangent_coupled_strips__finish_marches_t(work, work_t, rolling);
    tangent_tractions__patch_area_t(&v6, &v6_t, work, work_t, rolling);
    v7 = stuck / v6;
    (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_STICK_SHARE)) = (stuck_t - v7 * v6_t) / v6;
    (*cspan_at(&work, rolling + layout__ROLLING_PATCH_STICK_SHARE)) = v7;
    return INT64_C(0);
}

/* Tangent of ``flexibilities``. */
static inline int64_t tangent_coupled_strips__flexibilities_t(double* v4, double* result_1, double* v7, double* result_3, array_double_1d work, array_double_1d work_t, int64_t rolling)
{
    double first_t;
    double first;
    double second_t;
    double second;
    double third_t;
    double third;
    int64_t i_end;
    int64_t i;
    int64_t strip;
    double area_t;
    double area;
    double v1;
    double v2;
    double v3;
    double v5;
    double v6;
    first_t = 0.0;
    first = 0.0;
    second_t = 0.0;
    second = 0.0;
    third_t = 0.0;
    third = 0.0;
    i_end = (int64_t)((*cspan_at(&work, rolling + layout__ROLLING_PATCH_COUNT)));
    for (i = INT64_C(0); i < i_end; i += INT64_C(1))
    {
        strip = rolling + layout__ROLLING_PATCH_STRIPS + layout__ROLLING_STRIP_SIZE * i;
        area_t = (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_HALF_LENGTH)) * (*cspan_at(&work, strip + layout__ROLLING_STRIP_WIDTH)) + (*cspan_at(&work, strip + layout__ROLLING_STRIP_HALF_LENGTH)) * (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_WIDTH));
        area = (*cspan_at(&work, strip + layout__ROLLING_STRIP_HALF_LENGTH)) * (*cspan_at(&work, strip + layout__ROLLING_STRIP_WIDTH));
        first_t = first_t + area_t;
        first = first + area;
        second_t = second_t + (area_t * (*cspan_at(&work, strip + layout__ROLLING_STRIP_HALF_LENGTH)) + area * (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_HALF_LENGTH)));
        second = second + area * (*cspan_at(&work, strip + layout__ROLLING_STRIP_HALF_LENGTH));
        v1 = area * (*cspan_at(&work, strip + layout__ROLLING_STRIP_HALF_LENGTH));
        third_t = third_t + ((area_t * (*cspan_at(&work, strip + layout__ROLLING_STRIP_HALF_LENGTH)) + area * (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_HALF_LENGTH))) * (*cspan_at(&work, strip + layout__ROLLING_STRIP_HALF_LENGTH)) + v1 * (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_HALF_LENGTH)));
        third = third + v1 * (*cspan_at(&work, strip + layout__ROLLING_STRIP_HALF_LENGTH));
    }
    v2 = 0.5 * M_PI;
    v3 = v2 * first;
    (*v4) = v3 / second;
    v5 = 0.75 * M_PI;
    v6 = v5 * second;
    (*v7) = v6 / third;
    (*result_1) = (v2 * first_t - (*v4) * second_t) / second;
    (*result_3) = (v5 * second_t - (*v7) * third_t) / third;
    return 0;
}

/* Tangent of ``begin_march``. */
static inline int64_t tangent_coupled_strips__begin_march_t(array_double_1d work, array_double_1d work_t, int64_t rolling, int64_t strip, double rate, double rate_t, int64_t index)
{
    int64_t march;
    double along;
    double along_t;
    double across;
    double across_t;
    double turning;
    double turning_t;
    march = rolling + layout__ROLLING_PATCH_MARCH;
    (*cspan_at(&work_t, march + layout__ROLLING_MARCH_HALF_LENGTH)) = (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_HALF_LENGTH));
    (*cspan_at(&work, march + layout__ROLLING_MARCH_HALF_LENGTH)) = (*cspan_at(&work, strip + layout__ROLLING_STRIP_HALF_LENGTH));
    (*cspan_at(&work_t, march + layout__ROLLING_MARCH_RATE)) = rate_t;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_RATE)) = rate;
    (*cspan_at(&work_t, march + layout__ROLLING_MARCH_SLIP)) = (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_SLIP));
    (*cspan_at(&work, march + layout__ROLLING_MARCH_SLIP)) = (*cspan_at(&work, strip + layout__ROLLING_STRIP_SLIP));
    (*cspan_at(&work_t, march + layout__ROLLING_MARCH_LATERAL)) = (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_CREEPAGE_Y)) + ((*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_SPIN)) * (*cspan_at(&work, strip + layout__ROLLING_STRIP_X)) + (*cspan_at(&work, rolling + layout__ROLLING_PATCH_SPIN)) * (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_X)));
    (*cspan_at(&work, march + layout__ROLLING_MARCH_LATERAL)) = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_Y)) + (*cspan_at(&work, rolling + layout__ROLLING_PATCH_SPIN)) * (*cspan_at(&work, strip + layout__ROLLING_STRIP_X));
    (*cspan_at(&work_t, march + layout__ROLLING_MARCH_SPIN)) = (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_SPIN));
    (*cspan_at(&work, march + layout__ROLLING_MARCH_SPIN)) = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_SPIN));
    tangent_stiffness__stiffnesses_at_t(&along, &along_t, &across, &across_t, &turning, &turning_t, work, work_t, rolling + layout__ROLLING_PATCH_BLOCKS, index, (*cspan_at(&work, strip + layout__ROLLING_STRIP_STATION)), (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_STATION)));
    (*cspan_at(&work_t, march + layout__ROLLING_MARCH_ALONG)) = along_t;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_ALONG)) = along;
    (*cspan_at(&work_t, march + layout__ROLLING_MARCH_ACROSS)) = across_t;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_ACROSS)) = across;
    (*cspan_at(&work_t, march + layout__ROLLING_MARCH_TURNING)) = turning_t;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_TURNING)) = turning;
    return INT64_C(0);
}

/* Tangent of ``finish_marches``. */
static inline int64_t tangent_coupled_strips__finish_marches_t(array_double_1d work, array_double_1d work_t, int64_t rolling)
{
    int64_t marches;
    double largest_t;
    double largest;
    int64_t i_end;
    int64_t i;
    int64_t strip;
    double v1;
    double v1_t;
    double unit_t;
    double unit;
    double v2;
    double square_t;
    double square;
    double v3;
    double v3_t;
    double v4;
    double v5;
    marches = rolling + layout__ROLLING_PATCH_MARCHES;
    largest_t = 0.0;
    largest = 0.0;
    i_end = (int64_t)((*cspan_at(&work, rolling + layout__ROLLING_PATCH_COUNT)));
    for (i = INT64_C(0); i < i_end; i += INT64_C(1))
    {
        strip = rolling + layout__ROLLING_PATCH_STRIPS + layout__ROLLING_STRIP_SIZE * i;
        tangent_tractions__bound_rate_t(&v1, &v1_t, work, work_t, rolling, strip);
        unit_t = v1_t * (*cspan_at(&work, strip + layout__ROLLING_STRIP_HALF_LENGTH)) + v1 * (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_HALF_LENGTH));
        unit = v1 * (*cspan_at(&work, strip + layout__ROLLING_STRIP_HALF_LENGTH));
        v2 = (*cspan_at(&work, marches + layout__ROLLING_MARCHES_LARGEST + i)) * unit;
        square_t = ((*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_LARGEST + i)) * unit + (*cspan_at(&work, marches + layout__ROLLING_MARCHES_LARGEST + i)) * unit_t) * unit + v2 * unit_t;
        square = v2 * unit;
        if (square > largest)
        {
            largest_t = square_t;
            largest = square;
        }
        if (unit > 0.0)
        {
            tangent_tractions__point_weight_t(&v3, &v3_t, work, work_t, strip);
            unit_t = unit_t * v3 + unit * v3_t;
            unit = unit * v3;
            v4 = unit * (*cspan_at(&work, strip + layout__ROLLING_STRIP_HALF_LENGTH));
            tangent_tractions__add_strip_t(work, work_t, rolling, strip, unit * (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SUM_X + i)), unit_t * (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SUM_X + i)) + unit * (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_SUM_X + i)), unit * (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SUM_Y + i)), unit_t * (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SUM_Y + i)) + unit * (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_SUM_Y + i)), v4 * (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SUM_MOMENT + i)), (unit_t * (*cspan_at(&work, strip + layout__ROLLING_STRIP_HALF_LENGTH)) + unit * (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_HALF_LENGTH))) * (*cspan_at(&work, marches + layout__ROLLING_MARCHES_SUM_MOMENT + i)) + v4 * (*cspan_at(&work_t, marches + layout__ROLLING_MARCHES_SUM_MOMENT + i)));
        }
    }
    v5 = sqrt(largest);
    (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_MAX_SHEAR)) = tangent_rates__root_rate(v5, largest_t);
    (*cspan_at(&work, rolling + layout__ROLLING_PATCH_MAX_SHEAR)) = v5;
    return INT64_C(0);
}
