/* Generated from normal/hertz.py by tools/transpile_kernel.py; change that one.
 *
 * Hertz's coefficients and closed-form contact, through a table of exact values.
 *
 * With q the ratio of the short to the long semi-axis, K, E the complete elliptic integrals of modulus
 * sqrt(1 - q^2) and L^3 = 2 E / (pi q^2),
 *
 *     A > B (long across):   m = L q,  n = L,    r = 2 K / (pi L)
 *     A < B:                 m = L,    n = L q,  r the same
 *
 * so that the three combinations ANALYN needs are functions of ln(B/A) alone:
 *
 *     1 + alpha = (r / m^2)(1 + B/A),    1 + beta = (r / n^2)(1 + A/B),    n r
 *
 * and 1 + beta at ln(B/A) is 1 + alpha at ln(A/B).  The table holds quintics over uniform cells, exact to 1e-11
 * (kernel/binding/hertz_table.py).
 */

#include "hertz.h"

/* Value of column 0 (1 + alpha) or 6 (n r) at ``abscissa`` = ln(B/A); clamped to the table's range. */
static inline double hertz__table_value(array_double_1d tables, int64_t table, int64_t column, double abscissa)
{
    int64_t cell;
    double u;
    int64_t at;
    double high;
    double result;
    table_cell__table_cell(&cell, &u, (abscissa - (*cspan_at(&tables, table + layout__HERTZ_TABLE_START))) * (*cspan_at(&tables, table + layout__HERTZ_TABLE_CELLS_PER_UNIT)), (*cspan_at(&tables, table + layout__HERTZ_TABLE_COUNT)));
    at = layout__HERTZ_ROW * cell + column;
    high = (*cspan_at(&tables, table + layout__HERTZ_TABLE_ROWS + (at + INT64_C(3)))) + u * ((*cspan_at(&tables, table + layout__HERTZ_TABLE_ROWS + (at + INT64_C(4)))) + u * (*cspan_at(&tables, table + layout__HERTZ_TABLE_ROWS + (at + INT64_C(5)))));
    result = (*cspan_at(&tables, table + layout__HERTZ_TABLE_ROWS + at)) + u * ((*cspan_at(&tables, table + layout__HERTZ_TABLE_ROWS + (at + INT64_C(1)))) + u * ((*cspan_at(&tables, table + layout__HERTZ_TABLE_ROWS + (at + INT64_C(2)))) + u * high));
    return result;
}

/* 1 + alpha, 1 + beta and n r for the separation A x^2 + B s^2; both positive. */
static inline int64_t hertz__hertz_coefficients(double* result_0, double* result_1, double* result_2, array_double_1d tables, int64_t table, double A, double B)
{
    double ratio;
    ratio = log(B / A);
    (*result_0) = hertz__table_value(tables, table, INT64_C(0), ratio);
    (*result_1) = hertz__table_value(tables, table, INT64_C(0), -ratio);
    (*result_2) = hertz__table_value(tables, table, INT64_C(6), ratio);
    return 0;
}

/* 1 + alpha, 1 + beta and n r for the separation A (x - slant s)^2 + B s^2 of a yawed wheel.
 *
 * Its principal curvatures, of product A B, give a tilted ellipse.  Cut along x at the station s it is an
 * upright one again, which is all that ANALYN asks of it: half-length 0 where (1 + beta) B s^2 is the
 * penetration, and at s = 0 a half-length a with (1 + alpha) A a^2 the penetration and n r for its
 * pressure.  Exact for constant curvatures.
 *
 * Where the lateral curvature has fallen to its floor, a slant would make a long oblique ellipse of what is
 * a patch's edge: A slant^2 counts as STEEPEST B at most.
 */
static inline int64_t hertz__skewed_coefficients(double* result_0, double* result_1, double* result_2, array_double_1d tables, int64_t table, double A, double B, double slant)
{
    double cross;
    double diagonal;
    double half;
    double spread;
    double large;
    double small;
    double along;
    double across;
    double nr;
    double cosine;
    double length;
    double width;
    if (A * slant * slant > hertz__STEEPEST * B)
    {
        slant = sqrt(hertz__STEEPEST * B / A);
    }
    cross = A * slant;
    diagonal = B + cross * slant;
    half = 0.5 * (A - diagonal);
    spread = sqrt(half * half + cross * cross);
    large = 0.5 * (A + diagonal) + spread;
    small = A * B / large;
    hertz__hertz_coefficients(&along, &across, &nr, tables, table, small, large);
    along *= small;
    across *= large;
    /* the square of the cosine of the long axis' angle to x; a circle has no long axis */
    cosine = 0.5;
    if (spread > hertz__TILTED * large)
    {
        cosine = 0.5 - 0.5 * half / spread;
    }
    length = cosine * along + (1.0 - cosine) * across;
    width = along * across / (cosine * along + (1.0 - cosine) * across);
    (*result_0) = length / A;
    (*result_1) = width / B;
    (*result_2) = nr * sqrt(length / along);
    return 0;
}

/* dx/ds of the line through the middles of the ellipse's chords along x, for a gap whose ridge has this
 * ``slant``; steep ones are taken as there.
 */
static inline double hertz__middle_slant(array_double_1d tables, int64_t table, double A, double B, double slant)
{
    double cross;
    double diagonal;
    double half;
    double spread;
    double large;
    double small;
    double along;
    double across;
    double nr;
    double cosine;
    double length;
    if (A * slant * slant > hertz__STEEPEST * B)
    {
        slant = sqrt(hertz__STEEPEST * B / A) * slant / fabs(slant);
    }
    cross = A * slant;
    diagonal = B + cross * slant;
    half = 0.5 * (A - diagonal);
    spread = sqrt(half * half + cross * cross);
    large = 0.5 * (A + diagonal) + spread;
    small = A * B / large;
    if (!(spread > hertz__TILTED * large))
    {
        return slant;
    }
    hertz__hertz_coefficients(&along, &across, &nr, tables, table, small, large);
    along *= small;
    across *= large;
    cosine = 0.5 - 0.5 * half / spread;
    length = cosine * along + (1.0 - cosine) * across;
    return cross * (across - along) / ((large - small) * length);
}

/* N / penetration^(3/2) [N/m^1.5].
 *
 * N = integral of E* d / (n r) over the width with d = penetration - (1 + beta) B s^2: eq. (2.15) of Hertz's
 * closed form in ANALYN's coefficients, (4/3) E* / (n r sqrt((1 + beta) B)).
 */
static inline double hertz__hertz_stiffness(array_double_1d tables, int64_t table, double A, double B, double contact_modulus)
{
    double one_alpha;
    double one_beta;
    double nr;
    hertz__hertz_coefficients(&one_alpha, &one_beta, &nr, tables, table, A, B);
    return 4.0 / 3.0 * contact_modulus / (nr * sqrt(one_beta * B));
}
