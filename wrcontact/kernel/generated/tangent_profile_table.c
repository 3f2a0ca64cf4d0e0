/* Generated from tangent_profile_table.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of profile_table.py.
 */

#include "tangent_profile_table.h"

/* Tangent of ``height_slope``. */
static inline int64_t tangent_profile_table__height_slope_t(double* result_0, double* result_1, double* slope, double* slope_t, array_double_1d tables, int64_t profile, double y, double y_t)
{
    int64_t piece;
    double u_t;
    double u;
    double p4_t;
    double p4;
    double p3_t;
    double p3;
    double p2_t;
    double p2;
    double p1_t;
    double p1;
    double v1;
    double v2;
    double v3;
    piece = profile_table__find_piece(tables, profile, y);
    u_t = y_t;
    u = y - (*cspan_at(&tables, piece + layout__PIECE_START));
    p4_t = u_t * (*cspan_at(&tables, piece + layout__PIECE_C5));
    p4 = (*cspan_at(&tables, piece + layout__PIECE_C4)) + u * (*cspan_at(&tables, piece + layout__PIECE_C5));
    p3_t = u_t * p4 + u * p4_t;
    p3 = (*cspan_at(&tables, piece + layout__PIECE_C3)) + u * p4;
    p2_t = u_t * p3 + u * p3_t;
    p2 = (*cspan_at(&tables, piece + layout__PIECE_C2)) + u * p3;
    p1_t = u_t * p2 + u * p2_t;
    p1 = (*cspan_at(&tables, piece + layout__PIECE_C1)) + u * p2;
    v1 = p4 + u * (*cspan_at(&tables, piece + layout__PIECE_C5));
    v2 = p3 + u * v1;
    v3 = p2 + u * v2;
    (*slope_t) = p1_t + (u_t * v3 + u * (p2_t + (u_t * v2 + u * (p3_t + (u_t * v1 + u * (p4_t + u_t * (*cspan_at(&tables, piece + layout__PIECE_C5))))))));
    (*slope) = p1 + u * v3;
    (*result_0) = (*cspan_at(&tables, piece + layout__PIECE_C0)) + u * p1;
    (*result_1) = u_t * p1 + u * p1_t;
    return 0;
}

/* Tangent of ``height_slope_bend``. */
static inline int64_t tangent_profile_table__height_slope_bend_t(double* result_0, double* result_1, double* result_2, double* result_3, double* result_4, double* result_5, array_double_1d tables, int64_t profile, double y, double y_t)
{
    int64_t piece;
    double u_t;
    double u;
    double p4_t;
    double p4;
    double p3_t;
    double p3;
    double p2_t;
    double p2;
    double p1_t;
    double p1;
    double q4_t;
    double q4;
    double q3_t;
    double q3;
    double q2_t;
    double q2;
    double v1;
    double v2;
    double half_bend_t;
    double half_bend;
    piece = profile_table__find_piece(tables, profile, y);
    u_t = y_t;
    u = y - (*cspan_at(&tables, piece + layout__PIECE_START));
    p4_t = u_t * (*cspan_at(&tables, piece + layout__PIECE_C5));
    p4 = (*cspan_at(&tables, piece + layout__PIECE_C4)) + u * (*cspan_at(&tables, piece + layout__PIECE_C5));
    p3_t = u_t * p4 + u * p4_t;
    p3 = (*cspan_at(&tables, piece + layout__PIECE_C3)) + u * p4;
    p2_t = u_t * p3 + u * p3_t;
    p2 = (*cspan_at(&tables, piece + layout__PIECE_C2)) + u * p3;
    p1_t = u_t * p2 + u * p2_t;
    p1 = (*cspan_at(&tables, piece + layout__PIECE_C1)) + u * p2;
    q4_t = p4_t + u_t * (*cspan_at(&tables, piece + layout__PIECE_C5));
    q4 = p4 + u * (*cspan_at(&tables, piece + layout__PIECE_C5));
    q3_t = p3_t + (u_t * q4 + u * q4_t);
    q3 = p3 + u * q4;
    q2_t = p2_t + (u_t * q3 + u * q3_t);
    q2 = p2 + u * q3;
    v1 = q4 + u * (*cspan_at(&tables, piece + layout__PIECE_C5));
    v2 = q3 + u * v1;
    half_bend_t = q2_t + (u_t * v2 + u * (q3_t + (u_t * v1 + u * (q4_t + u_t * (*cspan_at(&tables, piece + layout__PIECE_C5))))));
    half_bend = q2 + u * v2;
    (*result_0) = (*cspan_at(&tables, piece + layout__PIECE_C0)) + u * p1;
    (*result_1) = u_t * p1 + u * p1_t;
    (*result_2) = p1 + u * q2;
    (*result_3) = p1_t + (u_t * q2 + u * q2_t);
    (*result_4) = 2.0 * half_bend;
    (*result_5) = 2.0 * half_bend_t;
    return 0;
}
