/* Generated from profile_table.py by tools/transpile_kernel.py; change that one.
 *
 * A profile as the kernel reads it: quintic pieces found through uniform bins.
 *
 * Table at ``base``: start, stop, bins per metre, bin count, offset of the pieces, then for each bin the first piece that
 * reaches into it, then per piece its start and six coefficients; the piece after the last starts at not-a-number, which no
 * abscissa reaches.  An abscissa that is not a number, infinite or far outside reads an end piece: nothing leaves the table.
 */

#include "profile_table.h"

/* Offset in ``tables`` of the piece that holds ``y`` [m]. */
static int64_t profile_table__find_piece(array_double_1d tables, int64_t base, double y)
{
    double u;
    double last;
    int64_t piece;
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
    piece = (int64_t)((*cspan_at(&tables, base + profile_table__BINS + (int64_t)(u))));
    at = base + (int64_t)((*cspan_at(&tables, base + profile_table__PIECE_OFFSET))) + profile_table__PIECE_SIZE * piece;
    while(y >= (*cspan_at(&tables, at + profile_table__PIECE_SIZE)))
    {
        at += profile_table__PIECE_SIZE;
    }
    return at;
}

/* Height [m] and slope [-] of the profile at ``y`` [m]. */
static int64_t profile_table__height_slope(double* z, double* slope, array_double_1d tables, int64_t base, double y)
{
    int64_t at;
    double u;
    double c1;
    double c2;
    double c3;
    double c4;
    double c5;
    at = profile_table__find_piece(tables, base, y);
    u = y - (*cspan_at(&tables, at));
    c1 = (*cspan_at(&tables, at + INT64_C(2)));
    c2 = (*cspan_at(&tables, at + INT64_C(3)));
    c3 = (*cspan_at(&tables, at + INT64_C(4)));
    c4 = (*cspan_at(&tables, at + INT64_C(5)));
    c5 = (*cspan_at(&tables, at + INT64_C(6)));
    (*z) = (*cspan_at(&tables, at + INT64_C(1))) + u * (c1 + u * (c2 + u * (c3 + u * (c4 + u * c5))));
    (*slope) = c1 + u * (2.0 * c2 + u * (3.0 * c3 + u * (4.0 * c4 + u * (5.0 * c5))));
    return 0;
}

/* Height [m], slope [-] and second derivative [1/m] of the profile at ``y`` [m]. */
static int64_t profile_table__height_slope_bend(double* z, double* slope, double* bend, array_double_1d tables, int64_t base, double y)
{
    int64_t at;
    double u;
    double c1;
    double c2;
    double c3;
    double c4;
    double c5;
    at = profile_table__find_piece(tables, base, y);
    u = y - (*cspan_at(&tables, at));
    c1 = (*cspan_at(&tables, at + INT64_C(2)));
    c2 = (*cspan_at(&tables, at + INT64_C(3)));
    c3 = (*cspan_at(&tables, at + INT64_C(4)));
    c4 = (*cspan_at(&tables, at + INT64_C(5)));
    c5 = (*cspan_at(&tables, at + INT64_C(6)));
    (*z) = (*cspan_at(&tables, at + INT64_C(1))) + u * (c1 + u * (c2 + u * (c3 + u * (c4 + u * c5))));
    (*slope) = c1 + u * (2.0 * c2 + u * (3.0 * c3 + u * (4.0 * c4 + u * (5.0 * c5))));
    (*bend) = 2.0 * c2 + u * (6.0 * c3 + u * (12.0 * c4 + u * (20.0 * c5)));
    return 0;
}
