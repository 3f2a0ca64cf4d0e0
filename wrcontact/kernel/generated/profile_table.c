/* Generated from surface/profile_table.py by tools/transpile_kernel.py; change that one.
 *
 * A profile as the kernel reads it: quintic pieces found through uniform bins.
 *
 * Table at ``base``: start, stop, bins per metre, bin count, offset of the pieces, then for each bin the offset of the first
 * piece that reaches into it, then per piece its start and six coefficients; the piece after the last starts at not-a-number, which no
 * abscissa reaches.  An abscissa that is not a number, infinite or far outside reads an end piece: nothing leaves the table.
 */

#include "profile_table.h"

/* Offset in ``tables`` of the piece that holds ``y`` [m]. */
static inline int64_t profile_table__find_piece(array_double_1d tables, int64_t base, double y)
{
    double u;
    double last;
    int64_t at;
    u = (y - (*cspan_at(&tables, base + profile_table__START))) * (*cspan_at(&tables, base + profile_table__BINS_PER_METRE));
    last = (*cspan_at(&tables, base + profile_table__BIN_COUNT)) - 1.0;
    if (!(u > 0.0))
    {
        u = 0.0;
    }
    if (u > last)
    {
        u = last;
    }
    at = base + (int64_t)((*cspan_at(&tables, base + profile_table__BINS + (int64_t)(u))));
    while(y >= (*cspan_at(&tables, at + profile_table__PIECE_SIZE)))
    {
        at += profile_table__PIECE_SIZE;
    }
    return at;
}

/* Height [m] and slope [-] of the profile at ``y`` [m]. */
static inline int64_t profile_table__height_slope(double* result_0, double* slope, array_double_1d tables, int64_t base, double y)
{
    int64_t at;
    double u;
    double c5;
    double p4;
    double p3;
    double p2;
    double p1;
    at = profile_table__find_piece(tables, base, y);
    u = y - (*cspan_at(&tables, at));
    /* Horner's scheme, and again on the quotient that it leaves */
    c5 = (*cspan_at(&tables, at + INT64_C(6)));
    p4 = (*cspan_at(&tables, at + INT64_C(5))) + u * c5;
    p3 = (*cspan_at(&tables, at + INT64_C(4))) + u * p4;
    p2 = (*cspan_at(&tables, at + INT64_C(3))) + u * p3;
    p1 = (*cspan_at(&tables, at + INT64_C(2))) + u * p2;
    (*slope) = p1 + u * (p2 + u * (p3 + u * (p4 + u * c5)));
    (*result_0) = (*cspan_at(&tables, at + INT64_C(1))) + u * p1;
    return 0;
}

/* Height [m], slope [-] and second derivative [1/m] of the profile at ``y`` [m]. */
static inline int64_t profile_table__height_slope_bend(double* result_0, double* result_1, double* result_2, array_double_1d tables, int64_t base, double y)
{
    int64_t at;
    double u;
    double c5;
    double p4;
    double p3;
    double p2;
    double p1;
    double q4;
    double q3;
    double q2;
    double half_bend;
    at = profile_table__find_piece(tables, base, y);
    u = y - (*cspan_at(&tables, at));
    /* Horner's scheme, and twice again on the quotient that it leaves */
    c5 = (*cspan_at(&tables, at + INT64_C(6)));
    p4 = (*cspan_at(&tables, at + INT64_C(5))) + u * c5;
    p3 = (*cspan_at(&tables, at + INT64_C(4))) + u * p4;
    p2 = (*cspan_at(&tables, at + INT64_C(3))) + u * p3;
    p1 = (*cspan_at(&tables, at + INT64_C(2))) + u * p2;
    q4 = p4 + u * c5;
    q3 = p3 + u * q4;
    q2 = p2 + u * q3;
    half_bend = q2 + u * (q3 + u * (q4 + u * c5));
    (*result_0) = (*cspan_at(&tables, at + INT64_C(1))) + u * p1;
    (*result_1) = p1 + u * q2;
    (*result_2) = 2.0 * half_bend;
    return 0;
}
