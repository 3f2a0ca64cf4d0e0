/* Generated from hertz.py by tools/transpile_kernel.py; change that one.
 *
 * Hertz's coefficients and closed-form contact, through a table of exact values.
 *
 * With q the ratio of the short to the long semi-axis and K, E the complete elliptic integrals of modulus sqrt(1 - q^2),
 *
 *     A > B (long across):  m = L q, n = L, r = 2 K / (pi L);   A < B: m = L, n = L q, r the same;   L^3 = 2 E / (pi q^2)
 *
 * so that the three combinations ANALYN needs are functions of ln(B/A) alone:
 *
 *     1 + alpha = (r / m^2)(1 + B/A),    1 + beta = (r / n^2)(1 + A/B),    n r
 *
 * and 1 + beta at ln(B/A) is 1 + alpha at ln(A/B).  The table holds quintics over uniform cells, exact to 1e-11
 * (wrcontact/profiles is not involved; see wrcontact/hertz_table.py).
 */

#include "hertz.h"

/* Value of table column 0 (1 + alpha) or 6 (n r) at ``abscissa`` = ln(B/A); clamped to the table's range. */
static inline double hertz__table_value(array_double_1d tables, int64_t base, int64_t column, double abscissa)
{
    double u;
    double last;
    int64_t cell;
    int64_t at;
    double result;
    u = (abscissa - (*cspan_at(&tables, base + hertz__TABLE_START))) * (*cspan_at(&tables, base + hertz__TABLE_CELLS_PER_UNIT));
    last = (*cspan_at(&tables, base + hertz__TABLE_COUNT));
    if (!(u > 0.0))
    {
        u = 0.0;
    }
    if (u > last)
    {
        u = last;
    }
    cell = (int64_t)(u);
    if (cell > (int64_t)(last) - INT64_C(1))
    {
        cell = (int64_t)(last) - INT64_C(1);
    }
    u -= (double)(cell);
    at = base + hertz__TABLE_CELLS + hertz__TABLE_ROW * cell + column;
    result = (*cspan_at(&tables, at)) + u * ((*cspan_at(&tables, at + INT64_C(1))) + u * ((*cspan_at(&tables, at + INT64_C(2))) + u * ((*cspan_at(&tables, at + INT64_C(3))) + u * ((*cspan_at(&tables, at + INT64_C(4))) + u * (*cspan_at(&tables, at + INT64_C(5)))))));
    return result;
}

/* 1 + alpha, 1 + beta and n r for the separation A x^2 + B s^2; both positive. */
static inline int64_t hertz__hertz_coefficients(double* result_0, double* result_1, double* result_2, array_double_1d tables, int64_t base, double A, double B)
{
    double ratio;
    ratio = log(B / A);
    (*result_0) = hertz__table_value(tables, base, INT64_C(0), ratio);
    (*result_1) = hertz__table_value(tables, base, INT64_C(0), -ratio);
    (*result_2) = hertz__table_value(tables, base, INT64_C(6), ratio);
    return 0;
}

/* N / penetration^(3/2) [N/m^1.5].
 *
 * N = integral of E* d / (n r) over the width with d = penetration - (1 + beta) B s^2: eq. (2.15) of Hertz's closed
 * form in ANALYN's coefficients, (4/3) E* / (n r sqrt((1 + beta) B)).
 */
static inline double hertz__hertz_stiffness(array_double_1d tables, int64_t base, double A, double B, double contact_modulus)
{
    double one_alpha;
    double one_beta;
    double nr;
    hertz__hertz_coefficients(&one_alpha, &one_beta, &nr, tables, base, A, B);
    return 4.0 / 3.0 * contact_modulus / (nr * sqrt(one_beta * B));
}
