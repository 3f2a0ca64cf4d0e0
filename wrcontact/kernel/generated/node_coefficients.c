/* Generated from normal/node_coefficients.py by tools/transpile_kernel.py; change that one.
 *
 * ANALYN's coefficients at the nodes of a region, from the longitudinal curvature and a lateral one.
 *
 * Lateral curvature.  Second differences over a window w (the curvature averaged with a triangle of half-width
 * w) are smooth but blind to what lies beyond; the secant g/s^2 knows how far the surfaces have parted but lags
 * behind.  With B_t and B_s these two,
 *
 *     B = sqrt(B_t max(B_t, B_s)),   B_t, B_s >= FLOOR A
 *
 * follows a sharp joint (B_t) and keeps a patch from growing where B_t falls to zero or below (B_s).
 *
 * That is the lateral curvature "adaptive".  "smooth" and "rough" are the source's, prepared for each profile
 * (:mod:`lateral_curvature`), one B in all three places; where it is below FLOOR A it counts as that.
 */

#include "node_coefficients.h"

/* Half the second derivative [1/m] of the values at node ``k``, averaged with a triangle of half-width
 * window h.
 */
static inline double node_coefficients__second_difference(array_double_1d work, int64_t values, int64_t k, double spacing, int64_t window)
{
    double width;
    double result;
    width = spacing * (double)(window);
    result = ((*cspan_at(&work, values + INT64_C(128) + (k + window))) - 2.0 * (*cspan_at(&work, values + INT64_C(128) + k)) + (*cspan_at(&work, values + INT64_C(128) + (k - window)))) / (2.0 * width * width);
    return result;
}

/* g / s^2 [1/m] at node ``k``; within the window a blend from ``middle`` to the secant at its end. */
static inline double node_coefficients__secant_curvature(array_double_1d work, int64_t gaps, int64_t k, double spacing, int64_t window, double middle)
{
    double s;
    double width;
    double edge;
    double result;
    if ((k >= window) || (k <= -window))
    {
        s = spacing * (double)(k);
        result = (*cspan_at(&work, gaps + INT64_C(128) + k)) / (s * s);
        return result;
    }
    width = spacing * (double)(window);
    edge = (*cspan_at(&work, gaps + INT64_C(128) + window)) / (width * width);
    if (k < INT64_C(0))
    {
        edge = (*cspan_at(&work, gaps + INT64_C(128) + (-window))) / (width * width);
    }
    return middle + (edge - middle) * fabs((double)(k)) / (double)(window);
}

/* sqrt(B_w (B_s + GROWTH share max(B_w - B_s, 0))) [1/m], with B_w not below WINDOW_FLOOR B_s. */
static inline double node_coefficients__windowed_curvature(double averaged, double secant, double share)
{
    double grown;
    if (averaged < node_coefficients__WINDOW_FLOOR * secant)
    {
        averaged = node_coefficients__WINDOW_FLOOR * secant;
    }
    grown = secant;
    if (averaged > secant)
    {
        grown += node_coefficients__GROWTH * share * (averaged - secant);
    }
    return sqrt(averaged * grown);
}

/* The three lateral curvatures [1/m] at node ``k``, for 1 + alpha, 1 + beta and n r: secant, side and
 * window; none below ``least``.
 */
static inline int64_t node_coefficients__adaptive_curvatures(double* secant, double* side, double* B, array_double_1d work, int64_t region, int64_t gaps, int64_t k, int64_t window, double middle, double mean, double least)
{
    double spacing;
    double share;
    spacing = (*cspan_at(&work, region + layout__REGION_SPACING));
    (*secant) = node_coefficients__secant_curvature(work, gaps, k, spacing, window, middle);
    if ((*secant) < least)
    {
        (*secant) = least;
    }
    share = fabs((double)(k)) * spacing / mean;
    if (share > 1.0)
    {
        share = 1.0;
    }
    (*B) = node_coefficients__windowed_curvature(node_coefficients__second_difference(work, gaps, k, spacing, window), (*secant), share);
    if ((*B) < least)
    {
        (*B) = least;
    }
    (*side) = (*cspan_at(&work, region + layout__REGION_SIDE_HIGH));
    if (k < INT64_C(0))
    {
        (*side) = (*cspan_at(&work, region + layout__REGION_SIDE_LOW));
    }
    if ((*side) < least)
    {
        (*side) = least;
    }
    return 0;
}

/* ANALYN's coefficients at the nodes of a region: (1 + beta) g, E* /(n r) and (1 + alpha) A, each with its
 * own B, or all with the prepared one.  ``window`` : of the lateral curvature, in nodes; ``yawed`` : 1 or
 * 0.
 */
static inline int64_t node_coefficients__weigh_nodes(array_double_1d work, array_double_1d tables, int64_t region, int64_t nodes, int64_t window, int64_t yawed)
{
    int64_t table;
    int64_t prepared;
    double alpha_factor;
    double beta_factor;
    double nr_factor;
    double mean;
    double middle;
    int64_t k_end;
    int64_t k;
    double A;
    double least;
    double B;
    double secant;
    double side;
    double alpha;
    double beta;
    double nr;
    table = (int64_t)((*cspan_at(&tables, layout__TABLES_HERTZ)));
    prepared = INT64_C(0);
    if ((int64_t)((*cspan_at(&tables, layout__TABLES_LATERAL))) != layout__LATERAL_ADAPTIVE)
    {
        prepared = INT64_C(1);
    }
    alpha_factor = 1.0;
    beta_factor = 1.0;
    nr_factor = 1.0;
    if (yawed == INT64_C(1))
    {
        node_coefficients__skew_factors(&alpha_factor, &beta_factor, &nr_factor, work, tables, region, (*cspan_at(&work, nodes + layout__NODES_A + INT64_C(128) + INT64_C(0))));
    }
    mean = 0.5 * ((*cspan_at(&work, region + layout__REGION_WIDTH_LOW)) + (*cspan_at(&work, region + layout__REGION_WIDTH_HIGH)));
    middle = node_coefficients__second_difference(work, nodes + layout__NODES_GAP, INT64_C(0), (*cspan_at(&work, region + layout__REGION_SPACING)), window);
    if (middle < 0.0)
    {
        middle = 0.0;
    }
    k_end = (int64_t)((*cspan_at(&work, region + layout__REGION_LAST))) + INT64_C(1);
    for (k = (int64_t)((*cspan_at(&work, region + layout__REGION_FIRST))); k < k_end; k += INT64_C(1))
    {
        A = (*cspan_at(&work, nodes + layout__NODES_A + INT64_C(128) + k));
        least = node_coefficients__FLOOR * A;
        if (prepared == INT64_C(1))
        {
            B = (*cspan_at(&work, nodes + layout__NODES_B + INT64_C(128) + k));
            if (B < least)
            {
                B = least;
            }
            secant = B;
            side = B;
        }
        else
        {
            node_coefficients__adaptive_curvatures(&secant, &side, &B, work, region, nodes + layout__NODES_GAP, k, window, middle, mean, least);
        }
        alpha = hertz__table_value(tables, table, INT64_C(0), log(secant / A));
        beta = hertz__table_value(tables, table, INT64_C(0), log(A / side));
        nr = hertz__table_value(tables, table, INT64_C(6), log(B / A));
        if (yawed == INT64_C(1))
        {
            alpha *= alpha_factor;
            beta *= beta_factor;
            nr *= nr_factor;
        }
        (*cspan_at(&work, nodes + layout__NODES_B + INT64_C(128) + k)) = B;
        (*cspan_at(&work, nodes + layout__NODES_RISE + INT64_C(128) + k)) = beta * (*cspan_at(&work, nodes + layout__NODES_GAP + INT64_C(128) + k));
        (*cspan_at(&work, nodes + layout__NODES_LINE + INT64_C(128) + k)) = (*cspan_at(&tables, layout__TABLES_CONTACT_MODULUS)) / nr;
        (*cspan_at(&work, nodes + layout__NODES_LENGTH + INT64_C(128) + k)) = alpha * A;
    }
    return INT64_C(0);
}

/* Factors of 1 + alpha, 1 + beta and n r for all nodes of a region, from the slant of a yawed wheel's
 * ridge: its mean slant and curvature, with ``A`` [1/m] at the minimum.
 */
static inline int64_t node_coefficients__skew_factors(double* result_0, double* result_1, double* result_2, array_double_1d work, array_double_1d tables, int64_t region, double A)
{
    int64_t table;
    double B;
    double alpha;
    double beta;
    double nr;
    double skewed_alpha;
    double skewed_beta;
    double skewed_nr;
    table = (int64_t)((*cspan_at(&tables, layout__TABLES_HERTZ)));
    B = 0.5 * ((*cspan_at(&work, region + layout__REGION_SIDE_LOW)) + (*cspan_at(&work, region + layout__REGION_SIDE_HIGH)));
    if (B < node_coefficients__FLOOR * A)
    {
        B = node_coefficients__FLOOR * A;
    }
    hertz__hertz_coefficients(&alpha, &beta, &nr, tables, table, A, B);
    hertz__skewed_coefficients(&skewed_alpha, &skewed_beta, &skewed_nr, tables, table, A, B, (*cspan_at(&work, region + layout__REGION_SLANT)));
    (*result_0) = skewed_alpha / alpha;
    (*result_1) = skewed_beta / beta;
    (*result_2) = skewed_nr / nr;
    return 0;
}
