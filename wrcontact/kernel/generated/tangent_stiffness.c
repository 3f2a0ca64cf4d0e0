/* Generated from tangent_stiffness.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of stiffness.py.
 */

#include "tangent_stiffness.h"

/* Tangent of ``find_stiffnesses``. */
static inline int64_t tangent_stiffness__find_stiffnesses_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t rolling)
{
    int64_t blocks;
    double v1;
    double ratio_t;
    double ratio;
    double v2;
    double v2_t;
    double place_t;
    double place;
    double half;
    double v3;
    double v3_t;
    double v4;
    double v5;
    double along_t;
    double along;
    double v6;
    double v6_t;
    double across_t;
    double across;
    double v7;
    double v7_t;
    double turning_t;
    double turning;
    int64_t i;
    int64_t block;
    double v8;
    double v9;
    double v10;
    double v10_t;
    blocks = rolling + layout__ROLLING_PATCH_BLOCKS;
    tangent_stiffness__join_strips_t(work, work_t, rolling);
    tangent_stiffness__fill_equations_t(tables, work, work_t, (int64_t)((*cspan_at(&tables, layout__TABLES_ROLLING))), rolling);
    tangent_stiffness__solve_blocks_t(work, work_t, rolling + layout__ROLLING_PATCH_EQUATIONS_X);
    tangent_stiffness__solve_blocks_t(work, work_t, rolling + layout__ROLLING_PATCH_EQUATIONS_Y);
    tangent_stiffness__solve_blocks_t(work, work_t, rolling + layout__ROLLING_PATCH_EQUATIONS_SPIN);
    v1 = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_LENGTH)) / (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_WIDTH));
    ratio_t = ((*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_HALF_LENGTH)) - v1 * (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_HALF_WIDTH))) / (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_WIDTH));
    ratio = v1;
    tangent_shapes__shape_place_t(&v2, &v2_t, ratio, ratio_t);
    place_t = v2_t;
    place = v2;
    half = 0.5 * (*cspan_at(&tables, layout__TABLES_SHEAR_MODULUS));
    tangent_shapes__shape_value_t(&v3, &v3_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_ROLLING))), INT64_C(3), place, place_t);
    v4 = v3 * half;
    v5 = 1.0 - (*cspan_at(&tables, layout__TABLES_PARAMETERS + layout__PARAMETERS_POISSON_RATIO));
    along_t = v3_t * half / v5;
    along = v4 / v5;
    tangent_shapes__shape_value_t(&v6, &v6_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_ROLLING))), INT64_C(4), place, place_t);
    across_t = v6_t * half;
    across = v6 * half;
    tangent_shapes__shape_value_t(&v7, &v7_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_ROLLING))), INT64_C(5), place, place_t);
    turning_t = v7_t * half;
    turning = v7 * half;
    for (i = INT64_C(0); i < layout__BLOCK_COUNT; i += INT64_C(1))
    {
        block = blocks + layout__ROLLING_BLOCK_SIZE * i;
        (*cspan_at(&work_t, block + layout__ROLLING_BLOCK_ALONG)) = along_t * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_EQUATIONS_X + INT64_C(9) * i + layout__BLOCK_COUNT)) + along * (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_EQUATIONS_X + INT64_C(9) * i + layout__BLOCK_COUNT));
        (*cspan_at(&work, block + layout__ROLLING_BLOCK_ALONG)) = along * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_EQUATIONS_X + INT64_C(9) * i + layout__BLOCK_COUNT));
        (*cspan_at(&work_t, block + layout__ROLLING_BLOCK_ACROSS)) = across_t * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_EQUATIONS_Y + INT64_C(9) * i + layout__BLOCK_COUNT)) + across * (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_EQUATIONS_Y + INT64_C(9) * i + layout__BLOCK_COUNT));
        (*cspan_at(&work, block + layout__ROLLING_BLOCK_ACROSS)) = across * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_EQUATIONS_Y + INT64_C(9) * i + layout__BLOCK_COUNT));
        v8 = turning * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_EQUATIONS_SPIN + INT64_C(9) * i + layout__BLOCK_COUNT));
        v9 = v8 / (*cspan_at(&work, block + layout__ROLLING_BLOCK_HALF_LENGTH));
        (*cspan_at(&work_t, block + layout__ROLLING_BLOCK_TURNING)) = (turning_t * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_EQUATIONS_SPIN + INT64_C(9) * i + layout__BLOCK_COUNT)) + turning * (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_EQUATIONS_SPIN + INT64_C(9) * i + layout__BLOCK_COUNT)) - v9 * (*cspan_at(&work_t, block + layout__ROLLING_BLOCK_HALF_LENGTH))) / (*cspan_at(&work, block + layout__ROLLING_BLOCK_HALF_LENGTH));
        (*cspan_at(&work, block + layout__ROLLING_BLOCK_TURNING)) = v9;
    }
    tangent_stiffness__mean_share_t(&v10, &v10_t, ratio, ratio_t);
    tangent_stiffness__spread_turning_t(work, work_t, blocks, v10, v10_t);
    return INT64_C(0);
}

/* Tangent of ``join_strips``. */
static inline int64_t tangent_stiffness__join_strips_t(array_double_1d work, array_double_1d work_t, int64_t rolling)
{
    int64_t i;
    int64_t block;
    int64_t low;
    int64_t high;
    double v1;
    double v2;
    double v3;
    double v4;
    double v5;
    double square_t;
    double square;
    double least_t;
    double least;
    double v6;
    double v7;
    for (i = INT64_C(0); i < layout__BLOCK_COUNT; i += INT64_C(1))
    {
        block = rolling + layout__ROLLING_PATCH_BLOCKS + layout__ROLLING_BLOCK_SIZE * i;
        low = rolling + layout__ROLLING_PATCH_STRIPS + layout__ROLLING_STRIP_SIZE * (INT64_C(2) * i);
        high = rolling + layout__ROLLING_PATCH_STRIPS + layout__ROLLING_STRIP_SIZE * (INT64_C(2) * i + INT64_C(1));
        (*cspan_at(&work_t, block + layout__ROLLING_BLOCK_START)) = (*cspan_at(&work_t, low + layout__ROLLING_STRIP_START));
        (*cspan_at(&work, block + layout__ROLLING_BLOCK_START)) = (*cspan_at(&work, low + layout__ROLLING_STRIP_START));
        (*cspan_at(&work_t, block + layout__ROLLING_BLOCK_STOP)) = (*cspan_at(&work_t, high + layout__ROLLING_STRIP_STOP));
        (*cspan_at(&work, block + layout__ROLLING_BLOCK_STOP)) = (*cspan_at(&work, high + layout__ROLLING_STRIP_STOP));
        v1 = (*cspan_at(&work, low + layout__ROLLING_STRIP_HALF_LENGTH)) * (*cspan_at(&work, low + layout__ROLLING_STRIP_HALF_LENGTH));
        v2 = (*cspan_at(&work, high + layout__ROLLING_STRIP_HALF_LENGTH)) * (*cspan_at(&work, high + layout__ROLLING_STRIP_HALF_LENGTH));
        v3 = v1 * (*cspan_at(&work, low + layout__ROLLING_STRIP_WIDTH)) + v2 * (*cspan_at(&work, high + layout__ROLLING_STRIP_WIDTH));
        v4 = (*cspan_at(&work, block + layout__ROLLING_BLOCK_STOP)) - (*cspan_at(&work, block + layout__ROLLING_BLOCK_START));
        v5 = v3 / v4;
        square_t = (((*cspan_at(&work_t, low + layout__ROLLING_STRIP_HALF_LENGTH)) * (*cspan_at(&work, low + layout__ROLLING_STRIP_HALF_LENGTH)) + (*cspan_at(&work, low + layout__ROLLING_STRIP_HALF_LENGTH)) * (*cspan_at(&work_t, low + layout__ROLLING_STRIP_HALF_LENGTH))) * (*cspan_at(&work, low + layout__ROLLING_STRIP_WIDTH)) + v1 * (*cspan_at(&work_t, low + layout__ROLLING_STRIP_WIDTH)) + (((*cspan_at(&work_t, high + layout__ROLLING_STRIP_HALF_LENGTH)) * (*cspan_at(&work, high + layout__ROLLING_STRIP_HALF_LENGTH)) + (*cspan_at(&work, high + layout__ROLLING_STRIP_HALF_LENGTH)) * (*cspan_at(&work_t, high + layout__ROLLING_STRIP_HALF_LENGTH))) * (*cspan_at(&work, high + layout__ROLLING_STRIP_WIDTH)) + v2 * (*cspan_at(&work_t, high + layout__ROLLING_STRIP_WIDTH))) - v5 * ((*cspan_at(&work_t, block + layout__ROLLING_BLOCK_STOP)) - (*cspan_at(&work_t, block + layout__ROLLING_BLOCK_START)))) / v4;
        square = v5;
        least_t = stiffness__SHORT * (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_HALF_LENGTH));
        least = stiffness__SHORT * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_LENGTH));
        v6 = square + least * least;
        v7 = sqrt(v6);
        (*cspan_at(&work_t, block + layout__ROLLING_BLOCK_HALF_LENGTH)) = tangent_rates__root_rate(v7, square_t + (least_t * least + least * least_t));
        (*cspan_at(&work, block + layout__ROLLING_BLOCK_HALF_LENGTH)) = v7;
    }
    return INT64_C(0);
}

/* Tangent of ``fill_equations``. */
static inline int64_t tangent_stiffness__fill_equations_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t table, int64_t rolling)
{
    int64_t i;
    int64_t block;
    int64_t along;
    int64_t across;
    int64_t turning;
    double v1;
    double v2;
    double v3;
    double x;
    double x_t;
    double y;
    double y_t;
    double spin;
    double spin_t;
    int64_t j;
    int64_t other;
    double v4;
    double v5;
    double v6;
    double v7;
    double scale_t;
    double scale;
    double v8;
    double middle_t;
    double middle;
    double v9;
    double v10;
    double v11;
    double v12;
    double v13;
    for (i = INT64_C(0); i < layout__BLOCK_COUNT; i += INT64_C(1))
    {
        block = rolling + layout__ROLLING_PATCH_BLOCKS + layout__ROLLING_BLOCK_SIZE * i;
        along = rolling + layout__ROLLING_PATCH_EQUATIONS_X + INT64_C(9) * i;
        across = rolling + layout__ROLLING_PATCH_EQUATIONS_Y + INT64_C(9) * i;
        turning = rolling + layout__ROLLING_PATCH_EQUATIONS_SPIN + INT64_C(9) * i;
        v1 = (*cspan_at(&work, block + layout__ROLLING_BLOCK_STOP)) - (*cspan_at(&work, block + layout__ROLLING_BLOCK_START));
        v2 = 0.5 * v1;
        v3 = v2 / (*cspan_at(&work, block + layout__ROLLING_BLOCK_HALF_LENGTH));
        tangent_stiffness__reaches_t(&x, &x_t, &y, &y_t, &spin, &spin_t, tables, table, v3, (0.5 * ((*cspan_at(&work_t, block + layout__ROLLING_BLOCK_STOP)) - (*cspan_at(&work_t, block + layout__ROLLING_BLOCK_START))) - v3 * (*cspan_at(&work_t, block + layout__ROLLING_BLOCK_HALF_LENGTH))) / (*cspan_at(&work, block + layout__ROLLING_BLOCK_HALF_LENGTH)));
        (*cspan_at(&work_t, along + i)) = 2.0 * x_t;
        (*cspan_at(&work, along + i)) = 2.0 * x;
        (*cspan_at(&work_t, across + i)) = 2.0 * y_t;
        (*cspan_at(&work, across + i)) = 2.0 * y;
        (*cspan_at(&work_t, turning + i)) = 2.0 * spin_t;
        (*cspan_at(&work, turning + i)) = 2.0 * spin;
        (*cspan_at(&work_t, along + layout__BLOCK_COUNT)) = 0.0;
        (*cspan_at(&work, along + layout__BLOCK_COUNT)) = 1.0;
        (*cspan_at(&work_t, across + layout__BLOCK_COUNT)) = 0.0;
        (*cspan_at(&work, across + layout__BLOCK_COUNT)) = 1.0;
        (*cspan_at(&work_t, turning + layout__BLOCK_COUNT)) = (*cspan_at(&work_t, block + layout__ROLLING_BLOCK_HALF_LENGTH));
        (*cspan_at(&work, turning + layout__BLOCK_COUNT)) = (*cspan_at(&work, block + layout__ROLLING_BLOCK_HALF_LENGTH));
        for (j = i + INT64_C(1); j < layout__BLOCK_COUNT; j += INT64_C(1))
        {
            other = rolling + layout__ROLLING_PATCH_BLOCKS + layout__ROLLING_BLOCK_SIZE * j;
            v4 = (*cspan_at(&work, block + layout__ROLLING_BLOCK_HALF_LENGTH)) * (*cspan_at(&work, block + layout__ROLLING_BLOCK_HALF_LENGTH)) + (*cspan_at(&work, other + layout__ROLLING_BLOCK_HALF_LENGTH)) * (*cspan_at(&work, other + layout__ROLLING_BLOCK_HALF_LENGTH));
            v5 = 0.5 * v4;
            v6 = sqrt(v5);
            v7 = 1.0 / v6;
            scale_t = (-v7) * tangent_rates__root_rate(v6, 0.5 * ((*cspan_at(&work_t, block + layout__ROLLING_BLOCK_HALF_LENGTH)) * (*cspan_at(&work, block + layout__ROLLING_BLOCK_HALF_LENGTH)) + (*cspan_at(&work, block + layout__ROLLING_BLOCK_HALF_LENGTH)) * (*cspan_at(&work_t, block + layout__ROLLING_BLOCK_HALF_LENGTH)) + ((*cspan_at(&work_t, other + layout__ROLLING_BLOCK_HALF_LENGTH)) * (*cspan_at(&work, other + layout__ROLLING_BLOCK_HALF_LENGTH)) + (*cspan_at(&work, other + layout__ROLLING_BLOCK_HALF_LENGTH)) * (*cspan_at(&work_t, other + layout__ROLLING_BLOCK_HALF_LENGTH))))) / v6;
            scale = v7;
            v8 = (*cspan_at(&work, block + layout__ROLLING_BLOCK_START)) + (*cspan_at(&work, block + layout__ROLLING_BLOCK_STOP));
            middle_t = 0.5 * ((*cspan_at(&work_t, block + layout__ROLLING_BLOCK_START)) + (*cspan_at(&work_t, block + layout__ROLLING_BLOCK_STOP)));
            middle = 0.5 * v8;
            v9 = (*cspan_at(&work, other + layout__ROLLING_BLOCK_START)) - middle;
            v10 = (*cspan_at(&work, other + layout__ROLLING_BLOCK_STOP)) - middle;
            tangent_stiffness__reach_beside_t(tables, work, work_t, table, rolling, i, j, v9 * scale, ((*cspan_at(&work_t, other + layout__ROLLING_BLOCK_START)) - middle_t) * scale + v9 * scale_t, v10 * scale, ((*cspan_at(&work_t, other + layout__ROLLING_BLOCK_STOP)) - middle_t) * scale + v10 * scale_t);
            v11 = (*cspan_at(&work, other + layout__ROLLING_BLOCK_START)) + (*cspan_at(&work, other + layout__ROLLING_BLOCK_STOP));
            middle_t = 0.5 * ((*cspan_at(&work_t, other + layout__ROLLING_BLOCK_START)) + (*cspan_at(&work_t, other + layout__ROLLING_BLOCK_STOP)));
            middle = 0.5 * v11;
            v12 = middle - (*cspan_at(&work, block + layout__ROLLING_BLOCK_STOP));
            v13 = middle - (*cspan_at(&work, block + layout__ROLLING_BLOCK_START));
            tangent_stiffness__reach_beside_t(tables, work, work_t, table, rolling, j, i, v12 * scale, (middle_t - (*cspan_at(&work_t, block + layout__ROLLING_BLOCK_STOP))) * scale + v12 * scale_t, v13 * scale, (middle_t - (*cspan_at(&work_t, block + layout__ROLLING_BLOCK_START))) * scale + v13 * scale_t);
        }
    }
    return INT64_C(0);
}

/* Tangent of ``reach_beside``. */
static inline int64_t tangent_stiffness__reach_beside_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t table, int64_t rolling, int64_t i, int64_t j, double near, double near_t, double far, double far_t)
{
    double near_x;
    double near_x_t;
    double near_y;
    double near_y_t;
    double near_spin;
    double near_spin_t;
    double far_x;
    double far_x_t;
    double far_y;
    double far_y_t;
    double far_spin;
    double far_spin_t;
    int64_t along;
    int64_t across;
    int64_t turning;
    tangent_stiffness__reaches_t(&near_x, &near_x_t, &near_y, &near_y_t, &near_spin, &near_spin_t, tables, table, near, near_t);
    tangent_stiffness__reaches_t(&far_x, &far_x_t, &far_y, &far_y_t, &far_spin, &far_spin_t, tables, table, far, far_t);
    along = rolling + layout__ROLLING_PATCH_EQUATIONS_X + INT64_C(9) * i;
    across = rolling + layout__ROLLING_PATCH_EQUATIONS_Y + INT64_C(9) * i;
    turning = rolling + layout__ROLLING_PATCH_EQUATIONS_SPIN + INT64_C(9) * i;
    (*cspan_at(&work_t, along + j)) = far_x_t - near_x_t;
    (*cspan_at(&work, along + j)) = far_x - near_x;
    (*cspan_at(&work_t, across + j)) = far_y_t - near_y_t;
    (*cspan_at(&work, across + j)) = far_y - near_y;
    (*cspan_at(&work_t, turning + j)) = far_spin_t - near_spin_t;
    (*cspan_at(&work, turning + j)) = far_spin - near_spin;
    return INT64_C(0);
}

/* Tangent of ``reaches``. */
static inline int64_t tangent_stiffness__reaches_t(double* v4, double* v4_t, double* v5, double* v5_t, double* v6, double* v6_t, array_double_1d tables, int64_t table, double distance, double distance_t)
{
    double v1;
    double v2;
    double v3;
    double place_t;
    double place;
    int64_t cell;
    double u_t;
    double u;
    int64_t at;
    v1 = fabs(distance) + stiffness__NEAREST;
    v2 = sqrt(v1);
    v3 = sqrt(v2);
    place_t = layout__REACH_PER_UNIT * tangent_rates__root_rate(v3, tangent_rates__root_rate(v2, tangent_rates__size_rate(distance, distance_t)));
    place = layout__REACH_PER_UNIT * v3;
    if (!(place < (double)(layout__REACH_CELLS)))
    {
        place_t = 0.0;
        place = (double)(layout__REACH_CELLS);
    }
    cell = (int64_t)(place);
    u_t = place_t;
    u = place - (double)(cell);
    at = layout__REACH_ROW * cell;
    tangent_stiffness__reach_cubic_t(v4, v4_t, tables, table, at, u, u_t);
    tangent_stiffness__reach_cubic_t(v5, v5_t, tables, table, at + INT64_C(4), u, u_t);
    tangent_stiffness__reach_cubic_t(v6, v6_t, tables, table, at + INT64_C(8), u, u_t);
    return 0;
}

/* Tangent of ``reach_cubic``. */
static inline int64_t tangent_stiffness__reach_cubic_t(double* result_0, double* result_1, array_double_1d tables, int64_t table, int64_t at, double u, double u_t)
{
    double high_t;
    double high;
    double v1;
    high_t = u_t * (*cspan_at(&tables, table + layout__ROLLING_TABLE_REACHES + (at + INT64_C(3))));
    high = (*cspan_at(&tables, table + layout__ROLLING_TABLE_REACHES + (at + INT64_C(2)))) + u * (*cspan_at(&tables, table + layout__ROLLING_TABLE_REACHES + (at + INT64_C(3))));
    v1 = (*cspan_at(&tables, table + layout__ROLLING_TABLE_REACHES + (at + INT64_C(1)))) + u * high;
    (*result_0) = (*cspan_at(&tables, table + layout__ROLLING_TABLE_REACHES + at)) + u * v1;
    (*result_1) = u_t * v1 + u * (u_t * high + u * high_t);
    return 0;
}

/* Tangent of ``solve_blocks``. */
static inline int64_t tangent_stiffness__solve_blocks_t(array_double_1d work, array_double_1d work_t, int64_t equations)
{
    int64_t k;
    int64_t pivot;
    double v1;
    double inverse_t;
    double inverse;
    int64_t i;
    int64_t row;
    double factor_t;
    double factor;
    int64_t j;
    int64_t back;
    double value_t;
    double value;
    int64_t known;
    double v2;
    for (k = INT64_C(0); k < layout__BLOCK_COUNT; k += INT64_C(1))
    {
        pivot = equations + INT64_C(9) * k;
        v1 = 1.0 / (*cspan_at(&work, pivot + k));
        inverse_t = (-v1) * (*cspan_at(&work_t, pivot + k)) / (*cspan_at(&work, pivot + k));
        inverse = v1;
        for (i = k + INT64_C(1); i < layout__BLOCK_COUNT; i += INT64_C(1))
        {
            row = equations + INT64_C(9) * i;
            factor_t = (*cspan_at(&work_t, row + k)) * inverse + (*cspan_at(&work, row + k)) * inverse_t;
            factor = (*cspan_at(&work, row + k)) * inverse;
            for (j = k + INT64_C(1); j < layout__BLOCK_COUNT + INT64_C(1); j += INT64_C(1))
            {
                (*cspan_at(&work_t, row + j)) = (*cspan_at(&work_t, row + j)) - (factor_t * (*cspan_at(&work, pivot + j)) + factor * (*cspan_at(&work_t, pivot + j)));
                (*cspan_at(&work, row + j)) = (*cspan_at(&work, row + j)) - factor * (*cspan_at(&work, pivot + j));
            }
        }
    }
    for (back = INT64_C(0); back < layout__BLOCK_COUNT; back += INT64_C(1))
    {
        k = layout__BLOCK_COUNT - INT64_C(1) - back;
        pivot = equations + INT64_C(9) * k;
        value_t = (*cspan_at(&work_t, pivot + layout__BLOCK_COUNT));
        value = (*cspan_at(&work, pivot + layout__BLOCK_COUNT));
        for (j = k + INT64_C(1); j < layout__BLOCK_COUNT; j += INT64_C(1))
        {
            known = equations + INT64_C(9) * j;
            value_t = value_t - ((*cspan_at(&work_t, pivot + j)) * (*cspan_at(&work, known + layout__BLOCK_COUNT)) + (*cspan_at(&work, pivot + j)) * (*cspan_at(&work_t, known + layout__BLOCK_COUNT)));
            value = value - (*cspan_at(&work, pivot + j)) * (*cspan_at(&work, known + layout__BLOCK_COUNT));
        }
        v2 = value / (*cspan_at(&work, pivot + k));
        (*cspan_at(&work_t, pivot + layout__BLOCK_COUNT)) = (value_t - v2 * (*cspan_at(&work_t, pivot + k))) / (*cspan_at(&work, pivot + k));
        (*cspan_at(&work, pivot + layout__BLOCK_COUNT)) = v2;
    }
    return INT64_C(0);
}

/* Tangent of ``mean_share``. */
static inline int64_t tangent_stiffness__mean_share_t(double* share, double* share_t, double ratio, double ratio_t)
{
    double v1;
    double v2;
    v1 = log(ratio) - stiffness__OWN_UNTIL;
    v2 = stiffness__MEAN_FROM - stiffness__OWN_UNTIL;
    (*share_t) = ratio_t / ratio / v2;
    (*share) = v1 / v2;
    if ((*share) < 0.0)
    {
        (*share_t) = 0.0;
        (*share) = 0.0;
    }
    if ((*share) > 1.0)
    {
        (*share_t) = 0.0;
        (*share) = 1.0;
    }
    return 0;
}

/* Tangent of ``spread_turning``. */
static inline int64_t tangent_stiffness__spread_turning_t(array_double_1d work, array_double_1d work_t, int64_t blocks, double share, double share_t)
{
    double total_t;
    double total;
    double mean_t;
    double mean;
    double along_t;
    double along;
    double across_t;
    double across;
    int64_t i;
    int64_t block;
    double v1;
    double v2;
    double weight_t;
    double weight;
    double v3;
    double v4;
    double v6;
    double v7;
    double v5;
    double v5_t;
    double v9;
    double v10;
    double v8;
    double v8_t;
    double v12;
    double v13;
    double v11;
    double v11_t;
    total_t = 0.0;
    total = 0.0;
    mean_t = 0.0;
    mean = 0.0;
    along_t = 0.0;
    along = 0.0;
    across_t = 0.0;
    across = 0.0;
    for (i = INT64_C(0); i < layout__BLOCK_COUNT; i += INT64_C(1))
    {
        block = blocks + layout__ROLLING_BLOCK_SIZE * i;
        v1 = (*cspan_at(&work, block + layout__ROLLING_BLOCK_HALF_LENGTH)) * (*cspan_at(&work, block + layout__ROLLING_BLOCK_HALF_LENGTH));
        v2 = (*cspan_at(&work, block + layout__ROLLING_BLOCK_STOP)) - (*cspan_at(&work, block + layout__ROLLING_BLOCK_START));
        weight_t = ((*cspan_at(&work_t, block + layout__ROLLING_BLOCK_HALF_LENGTH)) * (*cspan_at(&work, block + layout__ROLLING_BLOCK_HALF_LENGTH)) + (*cspan_at(&work, block + layout__ROLLING_BLOCK_HALF_LENGTH)) * (*cspan_at(&work_t, block + layout__ROLLING_BLOCK_HALF_LENGTH))) * v2 + v1 * ((*cspan_at(&work_t, block + layout__ROLLING_BLOCK_STOP)) - (*cspan_at(&work_t, block + layout__ROLLING_BLOCK_START)));
        weight = v1 * v2;
        total_t = total_t + weight_t;
        total = total + weight;
        mean_t = mean_t + ((*cspan_at(&work_t, block + layout__ROLLING_BLOCK_TURNING)) * weight + (*cspan_at(&work, block + layout__ROLLING_BLOCK_TURNING)) * weight_t);
        mean = mean + (*cspan_at(&work, block + layout__ROLLING_BLOCK_TURNING)) * weight;
        along_t = along_t + ((*cspan_at(&work_t, block + layout__ROLLING_BLOCK_ALONG)) * weight + (*cspan_at(&work, block + layout__ROLLING_BLOCK_ALONG)) * weight_t);
        along = along + (*cspan_at(&work, block + layout__ROLLING_BLOCK_ALONG)) * weight;
        across_t = across_t + ((*cspan_at(&work_t, block + layout__ROLLING_BLOCK_ACROSS)) * weight + (*cspan_at(&work, block + layout__ROLLING_BLOCK_ACROSS)) * weight_t);
        across = across + (*cspan_at(&work, block + layout__ROLLING_BLOCK_ACROSS)) * weight;
    }
    for (i = INT64_C(0); i < layout__BLOCK_COUNT; i += INT64_C(1))
    {
        block = blocks + layout__ROLLING_BLOCK_SIZE * i;
        v3 = mean / total;
        v4 = v3 - (*cspan_at(&work, block + layout__ROLLING_BLOCK_TURNING));
        (*cspan_at(&work_t, block + layout__ROLLING_BLOCK_TURNING)) = (*cspan_at(&work_t, block + layout__ROLLING_BLOCK_TURNING)) + (share_t * v4 + share * ((mean_t - v3 * total_t) / total - (*cspan_at(&work_t, block + layout__ROLLING_BLOCK_TURNING))));
        (*cspan_at(&work, block + layout__ROLLING_BLOCK_TURNING)) = (*cspan_at(&work, block + layout__ROLLING_BLOCK_TURNING)) + share * v4;
        v6 = stiffness__SOFT * mean;
        v7 = v6 / total;
        tangent_stiffness__not_below_t(&v5, &v5_t, (*cspan_at(&work, block + layout__ROLLING_BLOCK_TURNING)), (*cspan_at(&work_t, block + layout__ROLLING_BLOCK_TURNING)), v7, (stiffness__SOFT * mean_t - v7 * total_t) / total);
        (*cspan_at(&work_t, block + layout__ROLLING_BLOCK_TURNING)) = v5_t;
        (*cspan_at(&work, block + layout__ROLLING_BLOCK_TURNING)) = v5;
        v9 = stiffness__SOFT * along;
        v10 = v9 / total;
        tangent_stiffness__not_below_t(&v8, &v8_t, (*cspan_at(&work, block + layout__ROLLING_BLOCK_ALONG)), (*cspan_at(&work_t, block + layout__ROLLING_BLOCK_ALONG)), v10, (stiffness__SOFT * along_t - v10 * total_t) / total);
        (*cspan_at(&work_t, block + layout__ROLLING_BLOCK_ALONG)) = v8_t;
        (*cspan_at(&work, block + layout__ROLLING_BLOCK_ALONG)) = v8;
        v12 = stiffness__SOFT * across;
        v13 = v12 / total;
        tangent_stiffness__not_below_t(&v11, &v11_t, (*cspan_at(&work, block + layout__ROLLING_BLOCK_ACROSS)), (*cspan_at(&work_t, block + layout__ROLLING_BLOCK_ACROSS)), v13, (stiffness__SOFT * across_t - v13 * total_t) / total);
        (*cspan_at(&work_t, block + layout__ROLLING_BLOCK_ACROSS)) = v11_t;
        (*cspan_at(&work, block + layout__ROLLING_BLOCK_ACROSS)) = v11;
    }
    return INT64_C(0);
}

/* Tangent of ``not_below``. */
static inline int64_t tangent_stiffness__not_below_t(double* result_0, double* result_1, double value, double value_t, double least, double least_t)
{
    if (value < least)
    {
        value_t = least_t;
        value = least;
    }
    (*result_0) = value;
    (*result_1) = value_t;
    return 0;
}

/* Tangent of ``stiffnesses_at``. */
static inline int64_t tangent_stiffness__stiffnesses_at_t(double* along, double* along_t, double* across, double* across_t, double* turning, double* turning_t, array_double_1d work, array_double_1d work_t, int64_t blocks, int64_t index, double station, double station_t)
{
    int64_t own;
    int64_t towards;
    int64_t other;
    double v1;
    double middle_t;
    double middle;
    double v2;
    double v3;
    double v4;
    double v5;
    double share_t;
    double share;
    double v6;
    double v7;
    double v8;
    own = blocks + layout__ROLLING_BLOCK_SIZE * (py_floor_div_int64_t(index, INT64_C(2)));
    towards = py_floor_div_int64_t(index, INT64_C(2)) - INT64_C(1);
    if (pyc_modulo(index, INT64_C(2)) == INT64_C(1))
    {
        towards = py_floor_div_int64_t(index, INT64_C(2)) + INT64_C(1);
    }
    (*along_t) = (*cspan_at(&work_t, own + layout__ROLLING_BLOCK_ALONG));
    (*along) = (*cspan_at(&work, own + layout__ROLLING_BLOCK_ALONG));
    (*across_t) = (*cspan_at(&work_t, own + layout__ROLLING_BLOCK_ACROSS));
    (*across) = (*cspan_at(&work, own + layout__ROLLING_BLOCK_ACROSS));
    (*turning_t) = (*cspan_at(&work_t, own + layout__ROLLING_BLOCK_TURNING));
    (*turning) = (*cspan_at(&work, own + layout__ROLLING_BLOCK_TURNING));
    if ((towards >= INT64_C(0)) && (towards < layout__BLOCK_COUNT))
    {
        other = blocks + layout__ROLLING_BLOCK_SIZE * towards;
        v1 = (*cspan_at(&work, own + layout__ROLLING_BLOCK_START)) + (*cspan_at(&work, own + layout__ROLLING_BLOCK_STOP));
        middle_t = 0.5 * ((*cspan_at(&work_t, own + layout__ROLLING_BLOCK_START)) + (*cspan_at(&work_t, own + layout__ROLLING_BLOCK_STOP)));
        middle = 0.5 * v1;
        v2 = station - middle;
        v3 = (*cspan_at(&work, other + layout__ROLLING_BLOCK_START)) + (*cspan_at(&work, other + layout__ROLLING_BLOCK_STOP));
        v4 = 0.5 * v3 - middle;
        v5 = v2 / v4;
        share_t = (station_t - middle_t - v5 * (0.5 * ((*cspan_at(&work_t, other + layout__ROLLING_BLOCK_START)) + (*cspan_at(&work_t, other + layout__ROLLING_BLOCK_STOP))) - middle_t)) / v4;
        share = v5;
        v6 = (*cspan_at(&work, other + layout__ROLLING_BLOCK_ALONG)) - (*along);
        (*along_t) = (*along_t) + (share_t * v6 + share * ((*cspan_at(&work_t, other + layout__ROLLING_BLOCK_ALONG)) - (*along_t)));
        (*along) = (*along) + share * v6;
        v7 = (*cspan_at(&work, other + layout__ROLLING_BLOCK_ACROSS)) - (*across);
        (*across_t) = (*across_t) + (share_t * v7 + share * ((*cspan_at(&work_t, other + layout__ROLLING_BLOCK_ACROSS)) - (*across_t)));
        (*across) = (*across) + share * v7;
        v8 = (*cspan_at(&work, other + layout__ROLLING_BLOCK_TURNING)) - (*turning);
        (*turning_t) = (*turning_t) + (share_t * v8 + share * ((*cspan_at(&work_t, other + layout__ROLLING_BLOCK_TURNING)) - (*turning_t)));
        (*turning) = (*turning) + share * v8;
    }
    return 0;
}
