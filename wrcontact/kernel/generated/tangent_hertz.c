/* Generated from tangent_hertz.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of hertz.py.
 */

#include "tangent_hertz.h"

/* Tangent of ``table_value``. */
static inline int64_t tangent_hertz__table_value_t(double* result_0, double* result_1, array_double_1d tables, int64_t table, int64_t column, double abscissa, double abscissa_t)
{
    double v1;
    int64_t cell;
    double u;
    double u_t;
    int64_t at;
    double v2;
    double high_t;
    double high;
    double v3;
    double v4;
    v1 = abscissa - (*cspan_at(&tables, table + layout__HERTZ_TABLE_START));
    tangent_table_cell__table_cell_t(&cell, &u, &u_t, v1 * (*cspan_at(&tables, table + layout__HERTZ_TABLE_CELLS_PER_UNIT)), abscissa_t * (*cspan_at(&tables, table + layout__HERTZ_TABLE_CELLS_PER_UNIT)), (*cspan_at(&tables, table + layout__HERTZ_TABLE_COUNT)), 0.0);
    at = layout__HERTZ_ROW * cell + column;
    v2 = (*cspan_at(&tables, table + layout__HERTZ_TABLE_ROWS + (at + INT64_C(4)))) + u * (*cspan_at(&tables, table + layout__HERTZ_TABLE_ROWS + (at + INT64_C(5))));
    high_t = u_t * v2 + u * (u_t * (*cspan_at(&tables, table + layout__HERTZ_TABLE_ROWS + (at + INT64_C(5)))));
    high = (*cspan_at(&tables, table + layout__HERTZ_TABLE_ROWS + (at + INT64_C(3)))) + u * v2;
    v3 = (*cspan_at(&tables, table + layout__HERTZ_TABLE_ROWS + (at + INT64_C(2)))) + u * high;
    v4 = (*cspan_at(&tables, table + layout__HERTZ_TABLE_ROWS + (at + INT64_C(1)))) + u * v3;
    (*result_0) = (*cspan_at(&tables, table + layout__HERTZ_TABLE_ROWS + at)) + u * v4;
    (*result_1) = u_t * v4 + u * (u_t * v3 + u * (u_t * high + u * high_t));
    return 0;
}

/* Tangent of ``hertz_coefficients``. */
static inline int64_t tangent_hertz__hertz_coefficients_t(double* v2, double* v2_t, double* v3, double* v3_t, double* v4, double* v4_t, array_double_1d tables, int64_t table, double A, double A_t, double B, double B_t)
{
    double v1;
    double ratio_t;
    double ratio;
    v1 = B / A;
    ratio_t = (B_t - v1 * A_t) / A / v1;
    ratio = log(v1);
    tangent_hertz__table_value_t(v2, v2_t, tables, table, INT64_C(0), ratio, ratio_t);
    tangent_hertz__table_value_t(v3, v3_t, tables, table, INT64_C(0), -ratio, -ratio_t);
    tangent_hertz__table_value_t(v4, v4_t, tables, table, INT64_C(6), ratio, ratio_t);
    return 0;
}

/* Tangent of ``skewed_coefficients``. */
static inline int64_t tangent_hertz__skewed_coefficients_t(double* v17, double* result_1, double* v18, double* result_3, double* result_4, double* result_5, array_double_1d tables, int64_t table, double A, double A_t, double B, double B_t, double slant, double slant_t)
{
    double v1;
    double v2;
    double v3;
    double cross_t;
    double cross;
    double diagonal_t;
    double diagonal;
    double v4;
    double half_t;
    double half;
    double v5;
    double v6;
    double spread_t;
    double spread;
    double v7;
    double large_t;
    double large;
    double v8;
    double v9;
    double small_t;
    double small;
    double along;
    double along_t;
    double across;
    double across_t;
    double nr;
    double nr_t;
    double cosine_t;
    double cosine;
    double v10;
    double v11;
    double v12;
    double length_t;
    double length;
    double v13;
    double v14;
    double v15;
    double v16;
    double width_t;
    double width;
    double v19;
    double v20;
    if (A * slant * slant > hertz__STEEPEST * B)
    {
        v1 = hertz__STEEPEST * B;
        v2 = v1 / A;
        v3 = sqrt(v2);
        slant_t = tangent_rates__root_rate(v3, (hertz__STEEPEST * B_t - v2 * A_t) / A);
        slant = v3;
    }
    cross_t = A_t * slant + A * slant_t;
    cross = A * slant;
    diagonal_t = B_t + (cross_t * slant + cross * slant_t);
    diagonal = B + cross * slant;
    v4 = A - diagonal;
    half_t = 0.5 * (A_t - diagonal_t);
    half = 0.5 * v4;
    v5 = half * half + cross * cross;
    v6 = sqrt(v5);
    spread_t = tangent_rates__root_rate(v6, half_t * half + half * half_t + (cross_t * cross + cross * cross_t));
    spread = v6;
    v7 = A + diagonal;
    large_t = 0.5 * (A_t + diagonal_t) + spread_t;
    large = 0.5 * v7 + spread;
    v8 = A * B;
    v9 = v8 / large;
    small_t = (A_t * B + A * B_t - v9 * large_t) / large;
    small = v9;
    tangent_hertz__hertz_coefficients_t(&along, &along_t, &across, &across_t, &nr, &nr_t, tables, table, small, small_t, large, large_t);
    along_t = along_t * small + along * small_t;
    along = along * small;
    across_t = across_t * large + across * large_t;
    across = across * large;
    cosine_t = 0.0;
    cosine = 0.5;
    if (spread > hertz__TILTED * large)
    {
        v10 = 0.5 * half;
        v11 = v10 / spread;
        cosine_t = -((0.5 * half_t - v11 * spread_t) / spread);
        cosine = 0.5 - v11;
    }
    v12 = 1.0 - cosine;
    length_t = cosine_t * along + cosine * along_t + ((-cosine_t) * across + v12 * across_t);
    length = cosine * along + v12 * across;
    v13 = along * across;
    v14 = 1.0 - cosine;
    v15 = cosine * along + v14 * across;
    v16 = v13 / v15;
    width_t = (along_t * across + along * across_t - v16 * (cosine_t * along + cosine * along_t + ((-cosine_t) * across + v14 * across_t))) / v15;
    width = v16;
    (*v17) = length / A;
    (*v18) = width / B;
    v19 = length / along;
    v20 = sqrt(v19);
    (*result_1) = (length_t - (*v17) * A_t) / A;
    (*result_3) = (width_t - (*v18) * B_t) / B;
    (*result_4) = nr * v20;
    (*result_5) = nr_t * v20 + nr * tangent_rates__root_rate(v20, (length_t - v19 * along_t) / along);
    return 0;
}

/* Tangent of ``middle_slant``. */
static inline int64_t tangent_hertz__middle_slant_t(double* result_0, double* result_1, array_double_1d tables, int64_t table, double A, double A_t, double B, double B_t, double slant, double slant_t)
{
    double v1;
    double v2;
    double v3;
    double v4;
    double v5;
    double v6;
    double cross_t;
    double cross;
    double diagonal_t;
    double diagonal;
    double v7;
    double half_t;
    double half;
    double v8;
    double v9;
    double spread_t;
    double spread;
    double v10;
    double large_t;
    double large;
    double v11;
    double v12;
    double small_t;
    double small;
    double along;
    double along_t;
    double across;
    double across_t;
    double nr;
    double nr_t;
    double v13;
    double v14;
    double cosine_t;
    double cosine;
    double v15;
    double length_t;
    double length;
    double v16;
    double v17;
    double v18;
    double v19;
    double v20;
    if (A * slant * slant > hertz__STEEPEST * B)
    {
        v1 = hertz__STEEPEST * B;
        v2 = v1 / A;
        v3 = sqrt(v2);
        v4 = v3 * slant;
        v5 = fabs(slant);
        v6 = v4 / v5;
        slant_t = (tangent_rates__root_rate(v3, (hertz__STEEPEST * B_t - v2 * A_t) / A) * slant + v3 * slant_t - v6 * tangent_rates__size_rate(slant, slant_t)) / v5;
        slant = v6;
    }
    cross_t = A_t * slant + A * slant_t;
    cross = A * slant;
    diagonal_t = B_t + (cross_t * slant + cross * slant_t);
    diagonal = B + cross * slant;
    v7 = A - diagonal;
    half_t = 0.5 * (A_t - diagonal_t);
    half = 0.5 * v7;
    v8 = half * half + cross * cross;
    v9 = sqrt(v8);
    spread_t = tangent_rates__root_rate(v9, half_t * half + half * half_t + (cross_t * cross + cross * cross_t));
    spread = v9;
    v10 = A + diagonal;
    large_t = 0.5 * (A_t + diagonal_t) + spread_t;
    large = 0.5 * v10 + spread;
    v11 = A * B;
    v12 = v11 / large;
    small_t = (A_t * B + A * B_t - v12 * large_t) / large;
    small = v12;
    if (!(spread > hertz__TILTED * large))
    {
        (*result_0) = slant;
        (*result_1) = slant_t;
        return 0;
    }
    tangent_hertz__hertz_coefficients_t(&along, &along_t, &across, &across_t, &nr, &nr_t, tables, table, small, small_t, large, large_t);
    along_t = along_t * small + along * small_t;
    along = along * small;
    across_t = across_t * large + across * large_t;
    across = across * large;
    v13 = 0.5 * half;
    v14 = v13 / spread;
    cosine_t = -((0.5 * half_t - v14 * spread_t) / spread);
    cosine = 0.5 - v14;
    v15 = 1.0 - cosine;
    length_t = cosine_t * along + cosine * along_t + ((-cosine_t) * across + v15 * across_t);
    length = cosine * along + v15 * across;
    v16 = across - along;
    v17 = cross * v16;
    v18 = large - small;
    v19 = v18 * length;
    v20 = v17 / v19;
    (*result_0) = v20;
    (*result_1) = (cross_t * v16 + cross * (across_t - along_t) - v20 * ((large_t - small_t) * length + v18 * length_t)) / v19;
    return 0;
}

/* Tangent of ``hertz_stiffness``. */
static inline int64_t tangent_hertz__hertz_stiffness_t(double* v6, double* result_1, array_double_1d tables, int64_t table, double A, double A_t, double B, double B_t, double contact_modulus, double contact_modulus_t)
{
    double one_alpha;
    double one_alpha_t;
    double one_beta;
    double one_beta_t;
    double nr;
    double nr_t;
    double v1;
    double v2;
    double v3;
    double v4;
    double v5;
    tangent_hertz__hertz_coefficients_t(&one_alpha, &one_alpha_t, &one_beta, &one_beta_t, &nr, &nr_t, tables, table, A, A_t, B, B_t);
    v1 = 4.0 / 3.0;
    v2 = v1 * contact_modulus;
    v3 = one_beta * B;
    v4 = sqrt(v3);
    v5 = nr * v4;
    (*v6) = v2 / v5;
    (*result_1) = (v1 * contact_modulus_t - (*v6) * (nr_t * v4 + nr * tangent_rates__root_rate(v4, one_beta_t * B + one_beta * B_t))) / v5;
    return 0;
}
