/* Generated from tangent_fastsim.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of fastsim.py.
 */

#include "tangent_fastsim.h"

/* Tangent of ``solve_fastsim``. */
static inline int64_t tangent_fastsim__solve_fastsim_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t rolling)
{
    double along;
    double along_t;
    double across;
    double across_t;
    double turning;
    double turning_t;
    double stuck_t;
    double stuck;
    int64_t i_end;
    int64_t i;
    int64_t strip;
    double v1;
    double v1_t;
    double rate_t;
    double rate;
    double v2;
    double v2_t;
    double push_t;
    double push;
    double v3;
    double v3_t;
    double v4;
    double v4_t;
    double area_t;
    double area;
    double v5;
    tangent_fastsim__stiffnesses_t(&along, &along_t, &across, &across_t, &turning, &turning_t, work, work_t, tables, rolling);
    stuck_t = 0.0;
    stuck = 0.0;
    i_end = (int64_t)((*cspan_at(&work, rolling + layout__ROLLING_PATCH_COUNT)));
    for (i = INT64_C(0); i < i_end; i += INT64_C(1))
    {
        strip = rolling + layout__ROLLING_PATCH_STRIPS + layout__ROLLING_STRIP_SIZE * i;
        tangent_tractions__bound_rate_t(&v1, &v1_t, work, work_t, rolling, strip);
        rate_t = v1_t;
        rate = v1;
        if (rate > 0.0)
        {
            tangent_fastsim__strip_push_t(&v2, &v2_t, work, work_t, rolling, strip, along, along_t, turning, turning_t);
            push_t = v2_t;
            push = v2;
            tangent_fastsim__march_strip_t(&v3, &v3_t, tables, work, work_t, (int64_t)((*cspan_at(&tables, layout__TABLES_ROLLING))), rolling, strip, rate, rate_t, push, push_t, across, across_t, turning, turning_t);
            stuck_t = stuck_t + v3_t;
            stuck = stuck + v3;
        }
    }
    tangent_tractions__patch_area_t(&v4, &v4_t, work, work_t, rolling);
    area_t = v4_t;
    area = v4;
    if (area > 0.0)
    {
        v5 = stuck / area;
        (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_STICK_SHARE)) = (stuck_t - v5 * area_t) / area;
        (*cspan_at(&work, rolling + layout__ROLLING_PATCH_STICK_SHARE)) = v5;
    }
    return INT64_C(0);
}

/* Tangent of ``stiffnesses``. */
static inline int64_t tangent_fastsim__stiffnesses_t(double* v5, double* result_1, double* v9, double* result_3, double* v15, double* result_5, array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t rolling)
{
    double a_t;
    double a;
    double v1;
    double ratio_t;
    double ratio;
    double first;
    double first_t;
    double second;
    double second_t;
    double third;
    double third_t;
    double modulus;
    double v2;
    double v3;
    double v4;
    double v6;
    double v7;
    double v8;
    double v10;
    double v11;
    double v12;
    double v13;
    double v14;
    a_t = (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_HALF_LENGTH));
    a = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_LENGTH));
    v1 = a / (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_WIDTH));
    ratio_t = (a_t - v1 * (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_HALF_WIDTH))) / (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_WIDTH));
    ratio = v1;
    tangent_shapes__kalker_coefficients_t(&first, &first_t, &second, &second_t, &third, &third_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_ROLLING))), ratio, ratio_t);
    modulus = (*cspan_at(&tables, layout__TABLES_SHEAR_MODULUS));
    v2 = 3.0 * first;
    v3 = v2 * modulus;
    v4 = 8.0 * a;
    (*v5) = v3 / v4;
    v6 = 3.0 * second;
    v7 = v6 * modulus;
    v8 = 8.0 * a;
    (*v9) = v7 / v8;
    v10 = 4.0 * third;
    v11 = v10 * modulus;
    v12 = M_PI * a;
    v13 = sqrt(ratio);
    v14 = v12 * v13;
    (*v15) = v11 / v14;
    (*result_1) = (3.0 * first_t * modulus - (*v5) * (8.0 * a_t)) / v4;
    (*result_3) = (3.0 * second_t * modulus - (*v9) * (8.0 * a_t)) / v8;
    (*result_5) = (4.0 * third_t * modulus - (*v15) * (M_PI * a_t * v13 + v12 * tangent_rates__root_rate(v13, ratio_t))) / v14;
    return 0;
}

/* Tangent of ``strip_push``. */
static inline int64_t tangent_fastsim__strip_push_t(double* push, double* push_t, array_double_1d work, array_double_1d work_t, int64_t rolling, int64_t strip, double along, double along_t, double turning, double turning_t)
{
    double v1;
    (*push_t) = (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_SLIP)) * along + (*cspan_at(&work, strip + layout__ROLLING_STRIP_SLIP)) * along_t;
    (*push) = (*cspan_at(&work, strip + layout__ROLLING_STRIP_SLIP)) * along;
    if ((*cspan_at(&work, rolling + layout__ROLLING_PATCH_PUBLISHED)) == 1.0)
    {
        v1 = (*cspan_at(&work, strip + layout__ROLLING_STRIP_SLIP)) - (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_X));
        (*push_t) = (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_CREEPAGE_X)) * along + (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_X)) * along_t + (((*cspan_at(&work_t, strip + layout__ROLLING_STRIP_SLIP)) - (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_CREEPAGE_X))) * turning + v1 * turning_t);
        (*push) = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_X)) * along + v1 * turning;
    }
    return 0;
}

/* Tangent of ``march_strip``. */
static inline int64_t tangent_fastsim__march_strip_t(double* v11, double* result_1, array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t table, int64_t rolling, int64_t strip, double rate, double rate_t, double push, double push_t, double across, double across_t, double turning, double turning_t)
{
    double a_t;
    double a;
    double v1;
    double lateral_t;
    double lateral;
    double turn_t;
    double turn;
    double before_t;
    double before;
    double p_x_t;
    double p_x;
    double p_y_t;
    double p_y;
    double force_x_t;
    double force_x;
    double force_y_t;
    double force_y;
    double moment_t;
    double moment;
    double stuck_t;
    double stuck;
    double total_t;
    double total;
    double largest_t;
    double largest;
    int64_t q;
    double x_t;
    double x;
    double weight_t;
    double weight;
    double step_t;
    double step;
    double free_x_t;
    double free_x;
    double v2;
    double v3;
    double free_y_t;
    double free_y;
    double v4;
    double square_t;
    double square;
    double v5;
    double v6;
    double v7;
    double v7_t;
    double v8;
    double v9;
    double v10;
    a_t = (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_HALF_LENGTH));
    a = (*cspan_at(&work, strip + layout__ROLLING_STRIP_HALF_LENGTH));
    v1 = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_SPIN)) * (*cspan_at(&work, strip + layout__ROLLING_STRIP_X));
    lateral_t = (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_CREEPAGE_Y)) * across + (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_Y)) * across_t + (((*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_SPIN)) * (*cspan_at(&work, strip + layout__ROLLING_STRIP_X)) + (*cspan_at(&work, rolling + layout__ROLLING_PATCH_SPIN)) * (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_X))) * turning + v1 * turning_t);
    lateral = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_Y)) * across + v1 * turning;
    turn_t = (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_SPIN)) * turning + (*cspan_at(&work, rolling + layout__ROLLING_PATCH_SPIN)) * turning_t;
    turn = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_SPIN)) * turning;
    before_t = a_t;
    before = a;
    p_x_t = 0.0;
    p_x = 0.0;
    p_y_t = 0.0;
    p_y = 0.0;
    force_x_t = 0.0;
    force_x = 0.0;
    force_y_t = 0.0;
    force_y = 0.0;
    moment_t = 0.0;
    moment = 0.0;
    stuck_t = 0.0;
    stuck = 0.0;
    total_t = 0.0;
    total = 0.0;
    largest_t = (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_MAX_SHEAR)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_MAX_SHEAR)) + (*cspan_at(&work, rolling + layout__ROLLING_PATCH_MAX_SHEAR)) * (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_MAX_SHEAR));
    largest = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_MAX_SHEAR)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_MAX_SHEAR));
    for (q = INT64_C(0); q < layout__POINT_LIMIT; q += INT64_C(1))
    {
        x_t = a_t * (*cspan_at(&tables, table + layout__ROLLING_TABLE_COSINES + q));
        x = a * (*cspan_at(&tables, table + layout__ROLLING_TABLE_COSINES + q));
        weight_t = 0.0;
        weight = (*cspan_at(&tables, table + layout__ROLLING_TABLE_SINES + q));
        step_t = before_t - x_t;
        step = before - x;
        free_x_t = p_x_t - (step_t * push + step * push_t);
        free_x = p_x - step * push;
        v2 = x + 0.5 * step;
        v3 = lateral + turn * v2;
        free_y_t = p_y_t - (step_t * v3 + step * (lateral_t + (turn_t * v2 + turn * (x_t + 0.5 * step_t))));
        free_y = p_y - step * v3;
        v4 = rate * a;
        tangent_tractions__cut_to_t(&p_x, &p_x_t, &p_y, &p_y_t, free_x, free_x_t, free_y, free_y_t, v4 * weight, (rate_t * a + rate * a_t) * weight + v4 * weight_t);
        if ((p_x == free_x) && (p_y == free_y))
        {
            stuck_t = stuck_t + weight_t;
            stuck = stuck + weight;
        }
        total_t = total_t + weight_t;
        total = total + weight;
        square_t = p_x_t * p_x + p_x * p_x_t + (p_y_t * p_y + p_y * p_y_t);
        square = p_x * p_x + p_y * p_y;
        if (square > largest)
        {
            largest_t = square_t;
            largest = square;
        }
        force_x_t = force_x_t + (weight_t * p_x + weight * p_x_t);
        force_x = force_x + weight * p_x;
        force_y_t = force_y_t + (weight_t * p_y + weight * p_y_t);
        force_y = force_y + weight * p_y;
        v5 = weight * x;
        moment_t = moment_t + ((weight_t * x + weight * x_t) * p_y + v5 * p_y_t);
        moment = moment + v5 * p_y;
        before_t = x_t;
        before = x;
    }
    v6 = sqrt(largest);
    (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_MAX_SHEAR)) = tangent_rates__root_rate(v6, largest_t);
    (*cspan_at(&work, rolling + layout__ROLLING_PATCH_MAX_SHEAR)) = v6;
    tangent_tractions__point_weight_t(&v7, &v7_t, work, work_t, strip);
    weight_t = v7_t;
    weight = v7;
    tangent_tractions__add_strip_t(work, work_t, rolling, strip, weight * force_x, weight_t * force_x + weight * force_x_t, weight * force_y, weight_t * force_y + weight * force_y_t, weight * moment, weight_t * moment + weight * moment_t);
    v8 = 2.0 * a;
    v9 = v8 * (*cspan_at(&work, strip + layout__ROLLING_STRIP_WIDTH));
    v10 = v9 * stuck;
    (*v11) = v10 / total;
    (*result_1) = ((2.0 * a_t * (*cspan_at(&work, strip + layout__ROLLING_STRIP_WIDTH)) + v8 * (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_WIDTH))) * stuck + v9 * stuck_t - (*v11) * total_t) / total;
    return 0;
}
