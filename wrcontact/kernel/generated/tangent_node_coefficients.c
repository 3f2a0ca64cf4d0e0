/* Generated from tangent_node_coefficients.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of node_coefficients.py.
 */

#include "tangent_node_coefficients.h"

/* Tangent of ``second_difference``. */
static inline int64_t tangent_node_coefficients__second_difference_t(double* v5, double* result_1, array_double_1d work, array_double_1d work_t, int64_t values, int64_t k, double spacing, double spacing_t, int64_t window)
{
    double v1;
    double width_t;
    double width;
    double v2;
    double v3;
    double v4;
    v1 = (double)(window);
    width_t = spacing_t * v1;
    width = spacing * v1;
    v2 = (*cspan_at(&work, values + INT64_C(128) + (k + window))) - 2.0 * (*cspan_at(&work, values + INT64_C(128) + k)) + (*cspan_at(&work, values + INT64_C(128) + (k - window)));
    v3 = 2.0 * width;
    v4 = v3 * width;
    (*v5) = v2 / v4;
    (*result_1) = ((*cspan_at(&work_t, values + INT64_C(128) + (k + window))) - 2.0 * (*cspan_at(&work_t, values + INT64_C(128) + k)) + (*cspan_at(&work_t, values + INT64_C(128) + (k - window))) - (*v5) * (2.0 * width_t * width + v3 * width_t)) / v4;
    return 0;
}

/* Tangent of ``secant_curvature``. */
static inline int64_t tangent_node_coefficients__secant_curvature_t(double* v3, double* result_1, array_double_1d work, array_double_1d work_t, int64_t gaps, int64_t k, double spacing, double spacing_t, int64_t window, double middle, double middle_t)
{
    double v1;
    double s_t;
    double s;
    double v2;
    double v4;
    double width_t;
    double width;
    double v5;
    double v6;
    double edge_t;
    double edge;
    double v7;
    double v8;
    double v9;
    double v10;
    double v11;
    double v12;
    if ((k >= window) || (k <= -window))
    {
        v1 = (double)(k);
        s_t = spacing_t * v1;
        s = spacing * v1;
        v2 = s * s;
        (*v3) = (*cspan_at(&work, gaps + INT64_C(128) + k)) / v2;
        (*result_1) = ((*cspan_at(&work_t, gaps + INT64_C(128) + k)) - (*v3) * (s_t * s + s * s_t)) / v2;
        return 0;
    }
    v4 = (double)(window);
    width_t = spacing_t * v4;
    width = spacing * v4;
    v5 = width * width;
    v6 = (*cspan_at(&work, gaps + INT64_C(128) + window)) / v5;
    edge_t = ((*cspan_at(&work_t, gaps + INT64_C(128) + window)) - v6 * (width_t * width + width * width_t)) / v5;
    edge = v6;
    if (k < INT64_C(0))
    {
        v7 = width * width;
        v8 = (*cspan_at(&work, gaps + INT64_C(128) + (-window))) / v7;
        edge_t = ((*cspan_at(&work_t, gaps + INT64_C(128) + (-window))) - v8 * (width_t * width + width * width_t)) / v7;
        edge = v8;
    }
    v9 = edge - middle;
    v10 = fabs((double)(k));
    v11 = v9 * v10;
    v12 = (double)(window);
    (*v3) = middle + v11 / v12;
    (*result_1) = middle_t + (edge_t - middle_t) * v10 / v12;
    return 0;
}

/* Tangent of ``windowed_curvature``. */
static inline int64_t tangent_node_coefficients__windowed_curvature_t(double* v4, double* result_1, double averaged, double averaged_t, double secant, double secant_t, double share, double share_t)
{
    double grown_t;
    double grown;
    double v1;
    double v2;
    double v3;
    if (averaged < node_coefficients__WINDOW_FLOOR * secant)
    {
        averaged_t = node_coefficients__WINDOW_FLOOR * secant_t;
        averaged = node_coefficients__WINDOW_FLOOR * secant;
    }
    grown_t = secant_t;
    grown = secant;
    if (averaged > secant)
    {
        v1 = node_coefficients__GROWTH * share;
        v2 = averaged - secant;
        grown_t = grown_t + (node_coefficients__GROWTH * share_t * v2 + v1 * (averaged_t - secant_t));
        grown = grown + v1 * v2;
    }
    v3 = averaged * grown;
    (*v4) = sqrt(v3);
    (*result_1) = tangent_rates__root_rate((*v4), averaged_t * grown + averaged * grown_t);
    return 0;
}

/* Tangent of ``adaptive_curvatures``. */
static inline int64_t tangent_node_coefficients__adaptive_curvatures_t(double* secant, double* secant_t, double* side, double* side_t, double* B, double* B_t, array_double_1d work, array_double_1d work_t, int64_t region, int64_t gaps, int64_t k, int64_t window, double middle, double middle_t, double mean, double mean_t, double least, double least_t)
{
    double spacing_t;
    double spacing;
    double v1;
    double v1_t;
    double v2;
    double v3;
    double v4;
    double share_t;
    double share;
    double v6;
    double v6_t;
    double v5;
    double v5_t;
    spacing_t = (*cspan_at(&work_t, region + layout__REGION_SPACING));
    spacing = (*cspan_at(&work, region + layout__REGION_SPACING));
    tangent_node_coefficients__secant_curvature_t(&v1, &v1_t, work, work_t, gaps, k, spacing, spacing_t, window, middle, middle_t);
    (*secant_t) = v1_t;
    (*secant) = v1;
    if ((*secant) < least)
    {
        (*secant_t) = least_t;
        (*secant) = least;
    }
    v2 = fabs((double)(k));
    v3 = v2 * spacing;
    v4 = v3 / mean;
    share_t = (v2 * spacing_t - v4 * mean_t) / mean;
    share = v4;
    if (share > 1.0)
    {
        share_t = 0.0;
        share = 1.0;
    }
    tangent_node_coefficients__second_difference_t(&v6, &v6_t, work, work_t, gaps, k, spacing, spacing_t, window);
    tangent_node_coefficients__windowed_curvature_t(&v5, &v5_t, v6, v6_t, (*secant), (*secant_t), share, share_t);
    (*B_t) = v5_t;
    (*B) = v5;
    if ((*B) < least)
    {
        (*B_t) = least_t;
        (*B) = least;
    }
    (*side_t) = (*cspan_at(&work_t, region + layout__REGION_SIDE_HIGH));
    (*side) = (*cspan_at(&work, region + layout__REGION_SIDE_HIGH));
    if (k < INT64_C(0))
    {
        (*side_t) = (*cspan_at(&work_t, region + layout__REGION_SIDE_LOW));
        (*side) = (*cspan_at(&work, region + layout__REGION_SIDE_LOW));
    }
    if ((*side) < least)
    {
        (*side_t) = least_t;
        (*side) = least;
    }
    return 0;
}

/* Tangent of ``weigh_nodes``. */
static inline int64_t tangent_node_coefficients__weigh_nodes_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t region, int64_t nodes, int64_t window, int64_t yawed)
{
    int64_t table;
    int64_t prepared;
    double alpha_factor_t;
    double alpha_factor;
    double beta_factor_t;
    double beta_factor;
    double nr_factor_t;
    double nr_factor;
    double v1;
    double mean_t;
    double mean;
    double v2;
    double v2_t;
    double middle_t;
    double middle;
    int64_t k_end;
    int64_t k;
    double A_t;
    double A;
    double least_t;
    double least;
    double B_t;
    double B;
    double secant_t;
    double secant;
    double side_t;
    double side;
    double v4;
    double v3;
    double v3_t;
    double alpha_t;
    double alpha;
    double v6;
    double v5;
    double v5_t;
    double beta_t;
    double beta;
    double v8;
    double v7;
    double v7_t;
    double nr_t;
    double nr;
    double v9;
    table = (int64_t)((*cspan_at(&tables, layout__TABLES_HERTZ)));
    prepared = INT64_C(0);
    if ((int64_t)((*cspan_at(&tables, layout__TABLES_LATERAL))) != layout__LATERAL_ADAPTIVE)
    {
        prepared = INT64_C(1);
    }
    alpha_factor_t = 0.0;
    alpha_factor = 1.0;
    beta_factor_t = 0.0;
    beta_factor = 1.0;
    nr_factor_t = 0.0;
    nr_factor = 1.0;
    if (yawed == INT64_C(1))
    {
        tangent_node_coefficients__skew_factors_t(&alpha_factor, &alpha_factor_t, &beta_factor, &beta_factor_t, &nr_factor, &nr_factor_t, work, work_t, tables, region, (*cspan_at(&work, nodes + layout__NODES_A + INT64_C(128) + INT64_C(0))), (*cspan_at(&work_t, nodes + layout__NODES_A + INT64_C(128) + INT64_C(0))));
    }
    v1 = (*cspan_at(&work, region + layout__REGION_WIDTH_LOW)) + (*cspan_at(&work, region + layout__REGION_WIDTH_HIGH));
    mean_t = 0.5 * ((*cspan_at(&work_t, region + layout__REGION_WIDTH_LOW)) + (*cspan_at(&work_t, region + layout__REGION_WIDTH_HIGH)));
    mean = 0.5 * v1;
    tangent_node_coefficients__second_difference_t(&v2, &v2_t, work, work_t, nodes + layout__NODES_GAP, INT64_C(0), (*cspan_at(&work, region + layout__REGION_SPACING)), (*cspan_at(&work_t, region + layout__REGION_SPACING)), window);
    middle_t = v2_t;
    middle = v2;
    if (middle < 0.0)
    {
        middle_t = 0.0;
        middle = 0.0;
    }
    k_end = (int64_t)((*cspan_at(&work, region + layout__REGION_LAST))) + INT64_C(1);
    for (k = (int64_t)((*cspan_at(&work, region + layout__REGION_FIRST))); k < k_end; k += INT64_C(1))
    {
        A_t = (*cspan_at(&work_t, nodes + layout__NODES_A + INT64_C(128) + k));
        A = (*cspan_at(&work, nodes + layout__NODES_A + INT64_C(128) + k));
        least_t = node_coefficients__FLOOR * A_t;
        least = node_coefficients__FLOOR * A;
        if (prepared == INT64_C(1))
        {
            B_t = (*cspan_at(&work_t, nodes + layout__NODES_B + INT64_C(128) + k));
            B = (*cspan_at(&work, nodes + layout__NODES_B + INT64_C(128) + k));
            if (B < least)
            {
                B_t = least_t;
                B = least;
            }
            secant_t = B_t;
            secant = B;
            side_t = B_t;
            side = B;
        }
        else
        {
            tangent_node_coefficients__adaptive_curvatures_t(&secant, &secant_t, &side, &side_t, &B, &B_t, work, work_t, region, nodes + layout__NODES_GAP, k, window, middle, middle_t, mean, mean_t, least, least_t);
        }
        v4 = secant / A;
        tangent_hertz__table_value_t(&v3, &v3_t, tables, table, INT64_C(0), log(v4), (secant_t - v4 * A_t) / A / v4);
        alpha_t = v3_t;
        alpha = v3;
        v6 = A / side;
        tangent_hertz__table_value_t(&v5, &v5_t, tables, table, INT64_C(0), log(v6), (A_t - v6 * side_t) / side / v6);
        beta_t = v5_t;
        beta = v5;
        v8 = B / A;
        tangent_hertz__table_value_t(&v7, &v7_t, tables, table, INT64_C(6), log(v8), (B_t - v8 * A_t) / A / v8);
        nr_t = v7_t;
        nr = v7;
        if (yawed == INT64_C(1))
        {
            alpha_t = alpha_t * alpha_factor + alpha * alpha_factor_t;
            alpha = alpha * alpha_factor;
            beta_t = beta_t * beta_factor + beta * beta_factor_t;
            beta = beta * beta_factor;
            nr_t = nr_t * nr_factor + nr * nr_factor_t;
            nr = nr * nr_factor;
        }
        (*cspan_at(&work_t, nodes + layout__NODES_B + INT64_C(128) + k)) = B_t;
        (*cspan_at(&work, nodes + layout__NODES_B + INT64_C(128) + k)) = B;
        (*cspan_at(&work_t, nodes + layout__NODES_RISE + INT64_C(128) + k)) = beta_t * (*cspan_at(&work, nodes + layout__NODES_GAP + INT64_C(128) + k)) + beta * (*cspan_at(&work_t, nodes + layout__NODES_GAP + INT64_C(128) + k));
        (*cspan_at(&work, nodes + layout__NODES_RISE + INT64_C(128) + k)) = beta * (*cspan_at(&work, nodes + layout__NODES_GAP + INT64_C(128) + k));
        v9 = (*cspan_at(&tables, layout__TABLES_CONTACT_MODULUS)) / nr;
        (*cspan_at(&work_t, nodes + layout__NODES_LINE + INT64_C(128) + k)) = (-v9) * nr_t / nr;
        (*cspan_at(&work, nodes + layout__NODES_LINE + INT64_C(128) + k)) = v9;
        (*cspan_at(&work_t, nodes + layout__NODES_LENGTH + INT64_C(128) + k)) = alpha_t * A + alpha * A_t;
        (*cspan_at(&work, nodes + layout__NODES_LENGTH + INT64_C(128) + k)) = alpha * A;
    }
    return INT64_C(0);
}

/* Tangent of ``skew_factors``. */
static inline int64_t tangent_node_coefficients__skew_factors_t(double* v2, double* result_1, double* v3, double* result_3, double* v4, double* result_5, array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t region, double A, double A_t)
{
    int64_t table;
    double v1;
    double B_t;
    double B;
    double alpha;
    double alpha_t;
    double beta;
    double beta_t;
    double nr;
    double nr_t;
    double skewed_alpha;
    double skewed_alpha_t;
    double skewed_beta;
    double skewed_beta_t;
    double skewed_nr;
    double skewed_nr_t;
    table = (int64_t)((*cspan_at(&tables, layout__TABLES_HERTZ)));
    v1 = (*cspan_at(&work, region + layout__REGION_SIDE_LOW)) + (*cspan_at(&work, region + layout__REGION_SIDE_HIGH));
    B_t = 0.5 * ((*cspan_at(&work_t, region + layout__REGION_SIDE_LOW)) + (*cspan_at(&work_t, region + layout__REGION_SIDE_HIGH)));
    B = 0.5 * v1;
    if (B < node_coefficients__FLOOR * A)
    {
        B_t = node_coefficients__FLOOR * A_t;
        B = node_coefficients__FLOOR * A;
    }
    tangent_hertz__hertz_coefficients_t(&alpha, &alpha_t, &beta, &beta_t, &nr, &nr_t, tables, table, A, A_t, B, B_t);
    tangent_hertz__skewed_coefficients_t(&skewed_alpha, &skewed_alpha_t, &skewed_beta, &skewed_beta_t, &skewed_nr, &skewed_nr_t, tables, table, A, A_t, B, B_t, (*cspan_at(&work, region + layout__REGION_SLANT)), (*cspan_at(&work_t, region + layout__REGION_SLANT)));
    (*v2) = skewed_alpha / alpha;
    (*v3) = skewed_beta / beta;
    (*v4) = skewed_nr / nr;
    (*result_1) = (skewed_alpha_t - (*v2) * alpha_t) / alpha;
    (*result_3) = (skewed_beta_t - (*v3) * beta_t) / beta;
    (*result_5) = (skewed_nr_t - (*v4) * nr_t) / nr;
    return 0;
}
