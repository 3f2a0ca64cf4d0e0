/* Generated from surface/profile_table.py by tools/transpile_kernel.py; change that one.
 *
 * Heights, slopes and bends of a profile, from its table of quintic pieces (the record Profile).
 *
 * An abscissa that is not a number, infinite or far outside is read from a piece at an end: nothing outside the
 * table is read.
 */

#include "profile_table.h"

/* The piece that holds ``y`` [m]. */
static inline int64_t profile_table__find_piece(array_double_1d tables, int64_t profile, double y)
{
    double u;
    double last;
    int64_t piece;
    u = (y - (*cspan_at(&tables, profile + layout__PROFILE_START))) * (*cspan_at(&tables, profile + layout__PROFILE_BINS_PER_METRE));
    last = (*cspan_at(&tables, profile + layout__PROFILE_BIN_COUNT)) - 1.0;
    if (!(u > 0.0))
    {
        u = 0.0;
    }
    if (u > last)
    {
        u = last;
    }
    piece = profile + (int64_t)((*cspan_at(&tables, profile + layout__PROFILE_BINS + (int64_t)(u))));
    while(y >= (*cspan_at(&tables, piece + layout__PIECE_SIZE + layout__PIECE_START)))
    {
        piece = piece + layout__PIECE_SIZE;
    }
    return piece;
}

/* Height [m] and slope [-] of the profile at ``y`` [m]. */
static inline int64_t profile_table__height_slope(double* result_0, double* slope, array_double_1d tables, int64_t profile, double y)
{
    int64_t piece;
    double u;
    double p4;
    double p3;
    double p2;
    double p1;
    piece = profile_table__find_piece(tables, profile, y);
    u = y - (*cspan_at(&tables, piece + layout__PIECE_START));
    /* Horner's scheme, and again on the quotient that it leaves */
    p4 = (*cspan_at(&tables, piece + layout__PIECE_C4)) + u * (*cspan_at(&tables, piece + layout__PIECE_C5));
    p3 = (*cspan_at(&tables, piece + layout__PIECE_C3)) + u * p4;
    p2 = (*cspan_at(&tables, piece + layout__PIECE_C2)) + u * p3;
    p1 = (*cspan_at(&tables, piece + layout__PIECE_C1)) + u * p2;
    (*slope) = p1 + u * (p2 + u * (p3 + u * (p4 + u * (*cspan_at(&tables, piece + layout__PIECE_C5)))));
    (*result_0) = (*cspan_at(&tables, piece + layout__PIECE_C0)) + u * p1;
    return 0;
}

/* Height [m], slope [-] and second derivative [1/m] of the profile at ``y`` [m]. */
static inline int64_t profile_table__height_slope_bend(double* result_0, double* result_1, double* result_2, array_double_1d tables, int64_t profile, double y)
{
    int64_t piece;
    double u;
    double p4;
    double p3;
    double p2;
    double p1;
    double q4;
    double q3;
    double q2;
    double half_bend;
    piece = profile_table__find_piece(tables, profile, y);
    u = y - (*cspan_at(&tables, piece + layout__PIECE_START));
    /* Horner's scheme as in height_slope, which is called most, and twice again on the quotient that it leaves */
    p4 = (*cspan_at(&tables, piece + layout__PIECE_C4)) + u * (*cspan_at(&tables, piece + layout__PIECE_C5));
    p3 = (*cspan_at(&tables, piece + layout__PIECE_C3)) + u * p4;
    p2 = (*cspan_at(&tables, piece + layout__PIECE_C2)) + u * p3;
    p1 = (*cspan_at(&tables, piece + layout__PIECE_C1)) + u * p2;
    q4 = p4 + u * (*cspan_at(&tables, piece + layout__PIECE_C5));
    q3 = p3 + u * q4;
    q2 = p2 + u * q3;
    half_bend = q2 + u * (q3 + u * (q4 + u * (*cspan_at(&tables, piece + layout__PIECE_C5))));
    (*result_0) = (*cspan_at(&tables, piece + layout__PIECE_C0)) + u * p1;
    (*result_1) = p1 + u * q2;
    (*result_2) = 2.0 * half_bend;
    return 0;
}
