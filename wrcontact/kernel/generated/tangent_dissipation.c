/* Generated from tangent_dissipation.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of dissipation.py.
 */

#include "tangent_dissipation.h"

/* Tangent of ``keep_dissipating``. */
static inline int64_t tangent_dissipation__keep_dissipating_t(array_double_1d work, array_double_1d work_t, int64_t rolling)
{
    double x_t;
    double x;
    double y_t;
    double y;
    double sliding_t;
    double sliding;
    double turning_t;
    double turning;
    double v1;
    double v1_t;
    double gain_t;
    double gain;
    double v2;
    double v2_t;
    double less_t;
    double less;
    double v3;
    double v4;
    double v5;
    double v5_t;
    double v6;
    double v7;
    double share_t;
    double share;
    x_t = (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_CREEPAGE_X));
    x = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_X));
    y_t = (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_CREEPAGE_Y));
    y = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_Y));
    sliding_t = x_t * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_X)) + x * (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_FORCE_X)) + (y_t * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_Y)) + y * (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_FORCE_Y)));
    sliding = x * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_X)) + y * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_Y));
    turning_t = (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_SPIN)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_MOMENT)) + (*cspan_at(&work, rolling + layout__ROLLING_PATCH_SPIN)) * (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_MOMENT));
    turning = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_SPIN)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_MOMENT));
    tangent_dissipation__bent_gain_t(&v1, &v1_t, work, work_t, rolling);
    gain_t = sliding_t + turning_t + v1_t;
    gain = sliding + turning + v1;
    if ((gain > 0.0) && (turning > 0.0))
    {
        tangent_dissipation__smaller_t(&v2, &v2_t, turning, turning_t, gain, gain_t);
        less_t = v2_t;
        less = v2;
        v3 = turning - less;
        v4 = v3 / turning;
        (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_MOMENT)) = (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_MOMENT)) * v4 + (*cspan_at(&work, rolling + layout__ROLLING_PATCH_MOMENT)) * ((turning_t - less_t - v4 * turning_t) / turning);
        (*cspan_at(&work, rolling + layout__ROLLING_PATCH_MOMENT)) = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_MOMENT)) * v4;
        gain_t = gain_t - less_t;
        gain = gain - less;
    }
    if ((gain > 0.0) && (sliding > 0.0))
    {
        tangent_dissipation__smaller_t(&v5, &v5_t, sliding, sliding_t, gain, gain_t);
        v6 = x * x + y * y;
        v7 = v5 / v6;
        share_t = (v5_t - v7 * (x_t * x + x * x_t + (y_t * y + y * y_t))) / v6;
        share = v7;
        (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_FORCE_X)) = (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_FORCE_X)) - (share_t * x + share * x_t);
        (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_X)) = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_X)) - share * x;
        (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_FORCE_Y)) = (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_FORCE_Y)) - (share_t * y + share * y_t);
        (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_Y)) = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_Y)) - share * y;
    }
    return INT64_C(0);
}

/* Tangent of ``bent_gain``. */
static inline int64_t tangent_dissipation__bent_gain_t(double* gain, double* gain_t, array_double_1d work, array_double_1d work_t, int64_t rolling)
{
    int64_t i_end;
    int64_t i;
    int64_t strip;
    double plane_t;
    double plane;
    double v1;
    double v2;
    (*gain_t) = 0.0;
    (*gain) = 0.0;
    i_end = (int64_t)((*cspan_at(&work, rolling + layout__ROLLING_PATCH_COUNT)));
    for (i = INT64_C(0); i < i_end; i += INT64_C(1))
    {
        strip = rolling + layout__ROLLING_PATCH_STRIPS + layout__ROLLING_STRIP_SIZE * i;
        plane_t = (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_CREEPAGE_X)) - ((*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_SPIN)) * (*cspan_at(&work, strip + layout__ROLLING_STRIP_Y)) + (*cspan_at(&work, rolling + layout__ROLLING_PATCH_SPIN)) * (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_Y)));
        plane = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_X)) - (*cspan_at(&work, rolling + layout__ROLLING_PATCH_SPIN)) * (*cspan_at(&work, strip + layout__ROLLING_STRIP_Y));
        v1 = (*cspan_at(&work, strip + layout__ROLLING_STRIP_SLIP)) - plane;
        v2 = v1 * (*cspan_at(&work, strip + layout__ROLLING_STRIP_FORCE_X));
        (*gain_t) = (*gain_t) + ((((*cspan_at(&work_t, strip + layout__ROLLING_STRIP_SLIP)) - plane_t) * (*cspan_at(&work, strip + layout__ROLLING_STRIP_FORCE_X)) + v1 * (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_FORCE_X))) * (*cspan_at(&work, strip + layout__ROLLING_STRIP_WIDTH)) + v2 * (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_WIDTH)));
        (*gain) = (*gain) + v2 * (*cspan_at(&work, strip + layout__ROLLING_STRIP_WIDTH));
    }
    return 0;
}

/* Tangent of ``smaller``. */
static inline int64_t tangent_dissipation__smaller_t(double* result_0, double* result_1, double one, double one_t, double other, double other_t)
{
    if (other < one)
    {
        one_t = other_t;
        one = other;
    }
    (*result_0) = one;
    (*result_1) = one_t;
    return 0;
}
