/* Generated from tangent_fastrip.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of fastrip.py.
 */

#include "tangent_fastrip.h"

/* Tangent of ``solve_fastrip``. */
static inline int64_t tangent_fastrip__solve_fastrip_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t rolling)
{
    int64_t march;
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
    double lateral_t;
    double lateral;
    double v2;
    double v2_t;
    double v3;
    double v3_t;
    double v4;
    double v5;
    double v6;
    double v7;
    double v8;
    double v8_t;
    double v9;
    march = rolling + layout__ROLLING_PATCH_MARCH;
    tangent_fastsim__stiffnesses_t(&along, &along_t, &across, &across_t, &turning, &turning_t, work, work_t, tables, rolling);
    tangent_fastrip__set_stiffnesses_t(work, work_t, tables, rolling);
    (*cspan_at(&work_t, march + layout__ROLLING_MARCH_LARGEST)) = 0.0;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_LARGEST)) = 0.0;
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
            (*cspan_at(&work_t, march + layout__ROLLING_MARCH_HALF_LENGTH)) = (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_HALF_LENGTH));
            (*cspan_at(&work, march + layout__ROLLING_MARCH_HALF_LENGTH)) = (*cspan_at(&work, strip + layout__ROLLING_STRIP_HALF_LENGTH));
            (*cspan_at(&work_t, march + layout__ROLLING_MARCH_RATE)) = rate_t;
            (*cspan_at(&work, march + layout__ROLLING_MARCH_RATE)) = rate;
            lateral_t = (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_CREEPAGE_Y)) + ((*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_SPIN)) * (*cspan_at(&work, strip + layout__ROLLING_STRIP_X)) + (*cspan_at(&work, rolling + layout__ROLLING_PATCH_SPIN)) * (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_X)));
            lateral = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_Y)) + (*cspan_at(&work, rolling + layout__ROLLING_PATCH_SPIN)) * (*cspan_at(&work, strip + layout__ROLLING_STRIP_X));
            tangent_fastrip__longitudinal_t(&v2, &v2_t, work, work_t, tables, rolling, strip);
            tangent_fastrip__find_stick_t(work, work_t, march, v2, v2_t, lateral, lateral_t, (*cspan_at(&work, rolling + layout__ROLLING_PATCH_SPIN)), (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_SPIN)));
            tangent_fastsim__strip_push_t(&v3, &v3_t, work, work_t, rolling, strip, along, along_t, turning, turning_t);
            (*cspan_at(&work_t, march + layout__ROLLING_MARCH_PUSH_X)) = v3_t;
            (*cspan_at(&work, march + layout__ROLLING_MARCH_PUSH_X)) = v3;
            v4 = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_SPIN)) * (*cspan_at(&work, strip + layout__ROLLING_STRIP_X));
            (*cspan_at(&work_t, march + layout__ROLLING_MARCH_PUSH_Y)) = (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_CREEPAGE_Y)) * across + (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_Y)) * across_t + (((*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_SPIN)) * (*cspan_at(&work, strip + layout__ROLLING_STRIP_X)) + (*cspan_at(&work, rolling + layout__ROLLING_PATCH_SPIN)) * (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_X))) * turning + v4 * turning_t);
            (*cspan_at(&work, march + layout__ROLLING_MARCH_PUSH_Y)) = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_Y)) * across + v4 * turning;
            (*cspan_at(&work_t, march + layout__ROLLING_MARCH_PUSH_TURN)) = (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_SPIN)) * turning + (*cspan_at(&work, rolling + layout__ROLLING_PATCH_SPIN)) * turning_t;
            (*cspan_at(&work, march + layout__ROLLING_MARCH_PUSH_TURN)) = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_SPIN)) * turning;
            tangent_fastrip__add_tractions_t(tables, work, work_t, (int64_t)((*cspan_at(&tables, layout__TABLES_ROLLING))), rolling, strip);
            v5 = (*cspan_at(&work, march + layout__ROLLING_MARCH_HALF_LENGTH)) - (*cspan_at(&work, march + layout__ROLLING_MARCH_DEPTH));
            v6 = 2.0 * v5;
            stuck_t = stuck_t + (2.0 * ((*cspan_at(&work_t, march + layout__ROLLING_MARCH_HALF_LENGTH)) - (*cspan_at(&work_t, march + layout__ROLLING_MARCH_DEPTH))) * (*cspan_at(&work, strip + layout__ROLLING_STRIP_WIDTH)) + v6 * (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_WIDTH)));
            stuck = stuck + v6 * (*cspan_at(&work, strip + layout__ROLLING_STRIP_WIDTH));
        }
    }
    v7 = sqrt((*cspan_at(&work, march + layout__ROLLING_MARCH_LARGEST)));
    (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_MAX_SHEAR)) = tangent_rates__root_rate(v7, (*cspan_at(&work_t, march + layout__ROLLING_MARCH_LARGEST)));
    (*cspan_at(&work, rolling + layout__ROLLING_PATCH_MAX_SHEAR)) = v7;
    tangent_tractions__patch_area_t(&v8, &v8_t, work, work_t, rolling);
    v9 = stuck / v8;
    (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_STICK_SHARE)) = (stuck_t - v9 * v8_t) / v8;
    (*cspan_at(&work, rolling + layout__ROLLING_PATCH_STICK_SHARE)) = v9;
    return INT64_C(0);
}

/* Tangent of ``set_stiffnesses``. */
static inline int64_t tangent_fastrip__set_stiffnesses_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t rolling)
{
    int64_t march;
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
    double v5;
    double v6;
    double v7;
    double v8;
    double v9;
    double v10;
    double v11;
    double v12;
    march = rolling + layout__ROLLING_PATCH_MARCH;
    v1 = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_LENGTH)) / (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_WIDTH));
    ratio_t = ((*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_HALF_LENGTH)) - v1 * (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_HALF_WIDTH))) / (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_WIDTH));
    ratio = v1;
    tangent_shapes__kalker_coefficients_t(&first, &first_t, &second, &second_t, &third, &third_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_ROLLING))), ratio, ratio_t);
    modulus = (*cspan_at(&tables, layout__TABLES_SHEAR_MODULUS));
    v2 = 2.0 * first;
    v3 = v2 * modulus;
    v4 = M_PI * M_PI;
    (*cspan_at(&work_t, march + layout__ROLLING_MARCH_ALONG)) = 2.0 * first_t * modulus / v4;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_ALONG)) = v3 / v4;
    v5 = 2.0 * second;
    v6 = v5 * modulus;
    v7 = M_PI * M_PI;
    (*cspan_at(&work_t, march + layout__ROLLING_MARCH_ACROSS)) = 2.0 * second_t * modulus / v7;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_ACROSS)) = v6 / v7;
    v8 = 1.5 * third;
    v9 = v8 * modulus;
    v10 = sqrt(ratio);
    v11 = M_PI * v10;
    v12 = v9 / v11;
    (*cspan_at(&work_t, march + layout__ROLLING_MARCH_TURNING)) = (1.5 * third_t * modulus - v12 * (M_PI * tangent_rates__root_rate(v10, ratio_t))) / v11;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_TURNING)) = v12;
    return INT64_C(0);
}

/* Tangent of ``longitudinal``. */
static inline int64_t tangent_fastrip__longitudinal_t(double* push, double* push_t, array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t rolling, int64_t strip)
{
    int64_t march;
    double v1;
    double v2;
    double v3;
    march = rolling + layout__ROLLING_PATCH_MARCH;
    (*push_t) = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_ALONG)) * (*cspan_at(&work, strip + layout__ROLLING_STRIP_SLIP)) + (*cspan_at(&work, march + layout__ROLLING_MARCH_ALONG)) * (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_SLIP));
    (*push) = (*cspan_at(&work, march + layout__ROLLING_MARCH_ALONG)) * (*cspan_at(&work, strip + layout__ROLLING_STRIP_SLIP));
    if ((*cspan_at(&work, rolling + layout__ROLLING_PATCH_PUBLISHED)) == 1.0)
    {
        v1 = (*cspan_at(&work, strip + layout__ROLLING_STRIP_SLIP)) - (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_X));
        v2 = (*cspan_at(&work, march + layout__ROLLING_MARCH_TURNING)) * v1;
        v3 = 1.0 - (*cspan_at(&tables, layout__TABLES_PARAMETERS + layout__PARAMETERS_POISSON_RATIO));
        (*push_t) = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_ALONG)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_X)) + (*cspan_at(&work, march + layout__ROLLING_MARCH_ALONG)) * (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_CREEPAGE_X)) + ((*cspan_at(&work_t, march + layout__ROLLING_MARCH_TURNING)) * v1 + (*cspan_at(&work, march + layout__ROLLING_MARCH_TURNING)) * ((*cspan_at(&work_t, strip + layout__ROLLING_STRIP_SLIP)) - (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_CREEPAGE_X)))) / v3;
        (*push) = (*cspan_at(&work, march + layout__ROLLING_MARCH_ALONG)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_X)) + v2 / v3;
    }
    return 0;
}

/* Tangent of ``find_stick``. */
static inline int64_t tangent_fastrip__find_stick_t(array_double_1d work, array_double_1d work_t, int64_t march, double push, double push_t, double lateral, double lateral_t, double spin, double spin_t)
{
    double v1;
    double v2;
    double u_t;
    double u;
    double v3;
    double v4;
    double v5;
    double v_t;
    double v;
    double v6;
    double v7;
    double v8;
    double k_t;
    double k;
    double rest_t;
    double rest;
    double cross_t;
    double cross;
    double v9;
    double spread_t;
    double spread;
    double depth_t;
    double depth;
    double v10;
    double root_t;
    double root;
    double v11;
    double v12;
    double v13;
    double v14;
    double v15;
    double v16;
    double v17;
    double v18;
    double v19;
    double v20;
    double v21;
    double v22;
    v1 = -push;
    v2 = v1 / (*cspan_at(&work, march + layout__ROLLING_MARCH_RATE));
    u_t = ((-push_t) - v2 * (*cspan_at(&work_t, march + layout__ROLLING_MARCH_RATE))) / (*cspan_at(&work, march + layout__ROLLING_MARCH_RATE));
    u = v2;
    v3 = -(*cspan_at(&work, march + layout__ROLLING_MARCH_ACROSS));
    v4 = v3 * lateral;
    v5 = v4 / (*cspan_at(&work, march + layout__ROLLING_MARCH_RATE));
    v_t = ((-(*cspan_at(&work_t, march + layout__ROLLING_MARCH_ACROSS))) * lateral + v3 * lateral_t - v5 * (*cspan_at(&work_t, march + layout__ROLLING_MARCH_RATE))) / (*cspan_at(&work, march + layout__ROLLING_MARCH_RATE));
    v = v5;
    v6 = -(*cspan_at(&work, march + layout__ROLLING_MARCH_TURNING));
    v7 = v6 * spin;
    v8 = v7 / (*cspan_at(&work, march + layout__ROLLING_MARCH_RATE));
    k_t = ((-(*cspan_at(&work_t, march + layout__ROLLING_MARCH_TURNING))) * spin + v6 * spin_t - v8 * (*cspan_at(&work_t, march + layout__ROLLING_MARCH_RATE))) / (*cspan_at(&work, march + layout__ROLLING_MARCH_RATE));
    k = v8;
    rest_t = -(k_t * k + k * k_t);
    rest = 1.0 - k * k;
    cross_t = v_t * k + v * k_t;
    cross = v * k;
    v9 = rest * u;
    spread_t = v_t * v + v * v_t + ((rest_t * u + rest * u_t) * u + v9 * u_t);
    spread = v * v + v9 * u;
    depth_t = 2.0 * (*cspan_at(&work_t, march + layout__ROLLING_MARCH_HALF_LENGTH));
    depth = 2.0 * (*cspan_at(&work, march + layout__ROLLING_MARCH_HALF_LENGTH));
    if (rest > 0.0)
    {
        v10 = sqrt(spread);
        root_t = tangent_rates__root_rate(v10, spread_t);
        root = v10;
        depth_t = root_t + cross_t;
        depth = root + cross;
        if (cross < 0.0)
        {
            v11 = u * u + v * v;
            v12 = root - cross;
            v13 = v11 / v12;
            depth_t = (u_t * u + u * u_t + (v_t * v + v * v_t) - v13 * (root_t - cross_t)) / v12 * rest + v13 * rest_t;
            depth = v13 * rest;
        }
        v14 = depth / rest;
        depth_t = (depth_t - v14 * rest_t) / rest;
        depth = v14;
    }
    else if ((cross < 0.0) && (spread > 0.0))
    {
        v15 = u * u + v * v;
        v16 = sqrt(spread);
        v17 = v16 - cross;
        v18 = v15 / v17;
        depth_t = (u_t * u + u * u_t + (v_t * v + v * v_t) - v18 * (tangent_rates__root_rate(v16, spread_t) - cross_t)) / v17;
        depth = v18;
    }
    (*cspan_at(&work_t, march + layout__ROLLING_MARCH_TWIST)) = k_t;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_TWIST)) = k;
    (*cspan_at(&work_t, march + layout__ROLLING_MARCH_DEPTH)) = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_HALF_LENGTH));
    (*cspan_at(&work, march + layout__ROLLING_MARCH_DEPTH)) = (*cspan_at(&work, march + layout__ROLLING_MARCH_HALF_LENGTH));
    (*cspan_at(&work_t, march + layout__ROLLING_MARCH_STICK_X)) = 0.0;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_X)) = 0.0;
    (*cspan_at(&work_t, march + layout__ROLLING_MARCH_STICK_Y)) = 0.0;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_Y)) = 0.0;
    if (depth < (*cspan_at(&work, march + layout__ROLLING_MARCH_HALF_LENGTH)))
    {
        (*cspan_at(&work_t, march + layout__ROLLING_MARCH_DEPTH)) = depth_t;
        (*cspan_at(&work, march + layout__ROLLING_MARCH_DEPTH)) = depth;
        v19 = depth + 1e-300;
        v20 = u / v19;
        (*cspan_at(&work_t, march + layout__ROLLING_MARCH_STICK_X)) = (u_t - v20 * depth_t) / v19;
        (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_X)) = v20;
        v21 = depth + 1e-300;
        v22 = v / v21;
        (*cspan_at(&work_t, march + layout__ROLLING_MARCH_STICK_Y)) = (v_t - v22 * depth_t) / v21 + k_t;
        (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_Y)) = v22 + k;
    }
    (*cspan_at(&work_t, march + layout__ROLLING_MARCH_EDGE)) = 2.0 * (*cspan_at(&work_t, march + layout__ROLLING_MARCH_DEPTH)) - (*cspan_at(&work_t, march + layout__ROLLING_MARCH_HALF_LENGTH));
    (*cspan_at(&work, march + layout__ROLLING_MARCH_EDGE)) = 2.0 * (*cspan_at(&work, march + layout__ROLLING_MARCH_DEPTH)) - (*cspan_at(&work, march + layout__ROLLING_MARCH_HALF_LENGTH));
    return INT64_C(0);
}

/* Tangent of ``add_tractions``. */
static inline int64_t tangent_fastrip__add_tractions_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t table, int64_t rolling, int64_t strip)
{
    int64_t march;
    double a_t;
    double a;
    int64_t q;
    double x_t;
    double x;
    double v1;
    double bound_t;
    double bound;
    double p_x;
    double p_x_t;
    double p_y;
    double p_y_t;
    double square_t;
    double square;
    double v2;
    double v3;
    double v3_t;
    double weight_t;
    double weight;
    march = rolling + layout__ROLLING_PATCH_MARCH;
    a_t = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_HALF_LENGTH));
    a = (*cspan_at(&work, march + layout__ROLLING_MARCH_HALF_LENGTH));
    (*cspan_at(&work_t, march + layout__ROLLING_MARCH_X)) = a_t;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_X)) = a;
    (*cspan_at(&work_t, march + layout__ROLLING_MARCH_FIRST_X)) = 0.0;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_FIRST_X)) = 0.0;
    (*cspan_at(&work_t, march + layout__ROLLING_MARCH_FIRST_Y)) = 0.0;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_FIRST_Y)) = 0.0;
    (*cspan_at(&work_t, march + layout__ROLLING_MARCH_SUM_X)) = 0.0;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_SUM_X)) = 0.0;
    (*cspan_at(&work_t, march + layout__ROLLING_MARCH_SUM_Y)) = 0.0;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_SUM_Y)) = 0.0;
    (*cspan_at(&work_t, march + layout__ROLLING_MARCH_SUM_MOMENT)) = 0.0;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_SUM_MOMENT)) = 0.0;
    for (q = INT64_C(0); q < layout__POINT_LIMIT; q += INT64_C(1))
    {
        x_t = a_t * (*cspan_at(&tables, table + layout__ROLLING_TABLE_COSINES + q));
        x = a * (*cspan_at(&tables, table + layout__ROLLING_TABLE_COSINES + q));
        v1 = (*cspan_at(&work, march + layout__ROLLING_MARCH_RATE)) * a;
        bound_t = ((*cspan_at(&work_t, march + layout__ROLLING_MARCH_RATE)) * a + (*cspan_at(&work, march + layout__ROLLING_MARCH_RATE)) * a_t) * (*cspan_at(&tables, table + layout__ROLLING_TABLE_SINES + q));
        bound = v1 * (*cspan_at(&tables, table + layout__ROLLING_TABLE_SINES + q));
        tangent_fastrip__next_traction_t(&p_x, &p_x_t, &p_y, &p_y_t, work, work_t, march, x, x_t, bound, bound_t);
        square_t = p_x_t * p_x + p_x * p_x_t + (p_y_t * p_y + p_y * p_y_t);
        square = p_x * p_x + p_y * p_y;
        if (square > (*cspan_at(&work, march + layout__ROLLING_MARCH_LARGEST)))
        {
            (*cspan_at(&work_t, march + layout__ROLLING_MARCH_LARGEST)) = square_t;
            (*cspan_at(&work, march + layout__ROLLING_MARCH_LARGEST)) = square;
        }
        (*cspan_at(&work_t, march + layout__ROLLING_MARCH_SUM_X)) = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_SUM_X)) + (*cspan_at(&tables, table + layout__ROLLING_TABLE_SINES + q)) * p_x_t;
        (*cspan_at(&work, march + layout__ROLLING_MARCH_SUM_X)) = (*cspan_at(&work, march + layout__ROLLING_MARCH_SUM_X)) + (*cspan_at(&tables, table + layout__ROLLING_TABLE_SINES + q)) * p_x;
        (*cspan_at(&work_t, march + layout__ROLLING_MARCH_SUM_Y)) = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_SUM_Y)) + (*cspan_at(&tables, table + layout__ROLLING_TABLE_SINES + q)) * p_y_t;
        (*cspan_at(&work, march + layout__ROLLING_MARCH_SUM_Y)) = (*cspan_at(&work, march + layout__ROLLING_MARCH_SUM_Y)) + (*cspan_at(&tables, table + layout__ROLLING_TABLE_SINES + q)) * p_y;
        v2 = (*cspan_at(&tables, table + layout__ROLLING_TABLE_SINES + q)) * x;
        (*cspan_at(&work_t, march + layout__ROLLING_MARCH_SUM_MOMENT)) = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_SUM_MOMENT)) + ((*cspan_at(&tables, table + layout__ROLLING_TABLE_SINES + q)) * x_t * p_y + v2 * p_y_t);
        (*cspan_at(&work, march + layout__ROLLING_MARCH_SUM_MOMENT)) = (*cspan_at(&work, march + layout__ROLLING_MARCH_SUM_MOMENT)) + v2 * p_y;
    }
    tangent_tractions__point_weight_t(&v3, &v3_t, work, work_t, strip);
    weight_t = v3_t;
    weight = v3;
    tangent_tractions__add_strip_t(work, work_t, rolling, strip, weight * (*cspan_at(&work, march + layout__ROLLING_MARCH_SUM_X)), weight_t * (*cspan_at(&work, march + layout__ROLLING_MARCH_SUM_X)) + weight * (*cspan_at(&work_t, march + layout__ROLLING_MARCH_SUM_X)), weight * (*cspan_at(&work, march + layout__ROLLING_MARCH_SUM_Y)), weight_t * (*cspan_at(&work, march + layout__ROLLING_MARCH_SUM_Y)) + weight * (*cspan_at(&work_t, march + layout__ROLLING_MARCH_SUM_Y)), weight * (*cspan_at(&work, march + layout__ROLLING_MARCH_SUM_MOMENT)), weight_t * (*cspan_at(&work, march + layout__ROLLING_MARCH_SUM_MOMENT)) + weight * (*cspan_at(&work_t, march + layout__ROLLING_MARCH_SUM_MOMENT)));
    return INT64_C(0);
}

/* Tangent of ``next_traction``. */
static inline int64_t tangent_fastrip__next_traction_t(double* p_x, double* p_x_t, double* p_y, double* p_y_t, array_double_1d work, array_double_1d work_t, int64_t march, double x, double x_t, double bound, double bound_t)
{
    double step_t;
    double step;
    double v1;
    double across_t;
    double across;
    double reach_t;
    double reach;
    double v2;
    double v3;
    double inner_t;
    double inner;
    double v4;
    double root_t;
    double root;
    double v5;
    double v6;
    double v7;
    double v8;
    double size_t;
    double size;
    double v9;
    double v10;
    step_t = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_X)) - x_t;
    step = (*cspan_at(&work, march + layout__ROLLING_MARCH_X)) - x;
    v1 = x + 0.5 * step;
    across_t = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_PUSH_Y)) + ((*cspan_at(&work_t, march + layout__ROLLING_MARCH_PUSH_TURN)) * v1 + (*cspan_at(&work, march + layout__ROLLING_MARCH_PUSH_TURN)) * (x_t + 0.5 * step_t));
    across = (*cspan_at(&work, march + layout__ROLLING_MARCH_PUSH_Y)) + (*cspan_at(&work, march + layout__ROLLING_MARCH_PUSH_TURN)) * v1;
    tangent_tractions__cut_to_t(p_x, p_x_t, p_y, p_y_t, (*cspan_at(&work, march + layout__ROLLING_MARCH_FIRST_X)) - step * (*cspan_at(&work, march + layout__ROLLING_MARCH_PUSH_X)), (*cspan_at(&work_t, march + layout__ROLLING_MARCH_FIRST_X)) - (step_t * (*cspan_at(&work, march + layout__ROLLING_MARCH_PUSH_X)) + step * (*cspan_at(&work_t, march + layout__ROLLING_MARCH_PUSH_X))), (*cspan_at(&work, march + layout__ROLLING_MARCH_FIRST_Y)) - step * across, (*cspan_at(&work_t, march + layout__ROLLING_MARCH_FIRST_Y)) - (step_t * across + step * across_t), bound, bound_t);
    (*cspan_at(&work_t, march + layout__ROLLING_MARCH_X)) = x_t;
    (*cspan_at(&work, march + layout__ROLLING_MARCH_X)) = x;
    (*cspan_at(&work_t, march + layout__ROLLING_MARCH_FIRST_X)) = (*p_x_t);
    (*cspan_at(&work, march + layout__ROLLING_MARCH_FIRST_X)) = (*p_x);
    (*cspan_at(&work_t, march + layout__ROLLING_MARCH_FIRST_Y)) = (*p_y_t);
    (*cspan_at(&work, march + layout__ROLLING_MARCH_FIRST_Y)) = (*p_y);
    reach_t = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_HALF_LENGTH)) - (*cspan_at(&work_t, march + layout__ROLLING_MARCH_DEPTH));
    reach = (*cspan_at(&work, march + layout__ROLLING_MARCH_HALF_LENGTH)) - (*cspan_at(&work, march + layout__ROLLING_MARCH_DEPTH));
    v2 = x - (*cspan_at(&work, march + layout__ROLLING_MARCH_DEPTH));
    v3 = x - (*cspan_at(&work, march + layout__ROLLING_MARCH_DEPTH));
    inner_t = reach_t * reach + reach * reach_t - ((x_t - (*cspan_at(&work_t, march + layout__ROLLING_MARCH_DEPTH))) * v3 + v2 * (x_t - (*cspan_at(&work_t, march + layout__ROLLING_MARCH_DEPTH))));
    inner = reach * reach - v2 * v3;
    if (inner > 0.0)
    {
        v4 = sqrt(inner);
        root_t = (*cspan_at(&work_t, march + layout__ROLLING_MARCH_RATE)) * v4 + (*cspan_at(&work, march + layout__ROLLING_MARCH_RATE)) * tangent_rates__root_rate(v4, inner_t);
        root = (*cspan_at(&work, march + layout__ROLLING_MARCH_RATE)) * v4;
        v5 = bound - root;
        v6 = bound - root;
        tangent_tractions__cut_to_t(p_x, p_x_t, p_y, p_y_t, (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_X)) * v5, (*cspan_at(&work_t, march + layout__ROLLING_MARCH_STICK_X)) * v5 + (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_X)) * (bound_t - root_t), (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_Y)) * v6 + (*cspan_at(&work, march + layout__ROLLING_MARCH_TWIST)) * root, (*cspan_at(&work_t, march + layout__ROLLING_MARCH_STICK_Y)) * v6 + (*cspan_at(&work, march + layout__ROLLING_MARCH_STICK_Y)) * (bound_t - root_t) + ((*cspan_at(&work_t, march + layout__ROLLING_MARCH_TWIST)) * root + (*cspan_at(&work, march + layout__ROLLING_MARCH_TWIST)) * root_t), bound, bound_t);
    }
    else
    {
        v7 = (*p_x) * (*p_x) + (*p_y) * (*p_y);
        v8 = sqrt(v7);
        size_t = tangent_rates__root_rate(v8, (*p_x_t) * (*p_x) + (*p_x) * (*p_x_t) + ((*p_y_t) * (*p_y) + (*p_y) * (*p_y_t)));
        size = v8;
        if (size > 0.0)
        {
            v9 = bound / size;
            (*p_x_t) = (*p_x_t) * v9 + (*p_x) * ((bound_t - v9 * size_t) / size);
            (*p_x) = (*p_x) * v9;
            v10 = bound / size;
            (*p_y_t) = (*p_y_t) * v10 + (*p_y) * ((bound_t - v10 * size_t) / size);
            (*p_y) = (*p_y) * v10;
        }
    }
    return 0;
}
