/* Generated from tangent_tractions.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of tractions.py.
 */

#include "tangent_tractions.h"

/* Tangent of ``bound_rate``. */
static inline int64_t tangent_tractions__bound_rate_t(double* rate, double* rate_t, array_double_1d work, array_double_1d work_t, int64_t rolling, int64_t strip)
{
    double a_t;
    double a;
    double v1;
    double v2;
    double v3;
    double v4;
    double v5;
    a_t = (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_HALF_LENGTH));
    a = (*cspan_at(&work, strip + layout__ROLLING_STRIP_HALF_LENGTH));
    (*rate_t) = 0.0;
    (*rate) = 0.0;
    if (((*cspan_at(&work, strip + layout__ROLLING_STRIP_LINE_LOAD)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_WIDTH)) > tractions__SLIGHT * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_LOAD))) && (a > tractions__SLIGHT * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_LENGTH))))
    {
        v1 = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FRICTION)) * 2.0;
        v2 = v1 * (*cspan_at(&work, strip + layout__ROLLING_STRIP_LINE_LOAD));
        v3 = M_PI * a;
        v4 = v3 * a;
        v5 = v2 / v4;
        (*rate_t) = ((*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_FRICTION)) * 2.0 * (*cspan_at(&work, strip + layout__ROLLING_STRIP_LINE_LOAD)) + v1 * (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_LINE_LOAD)) - v5 * (M_PI * a_t * a + v3 * a_t)) / v4;
        (*rate) = v5;
    }
    return 0;
}

/* Tangent of ``cut_to``. */
static inline int64_t tangent_tractions__cut_to_t(double* result_0, double* result_1, double* result_2, double* result_3, double along, double along_t, double across, double across_t, double bound, double bound_t)
{
    double square_t;
    double square;
    double v1;
    double v2;
    double share_t;
    double share;
    square_t = along_t * along + along * along_t + (across_t * across + across * across_t);
    square = along * along + across * across;
    if (square > bound * bound)
    {
        v1 = sqrt(square);
        v2 = bound / v1;
        share_t = (bound_t - v2 * tangent_rates__root_rate(v1, square_t)) / v1;
        share = v2;
        along_t = along_t * share + along * share_t;
        along = along * share;
        across_t = across_t * share + across * share_t;
        across = across * share;
    }
    (*result_0) = along;
    (*result_1) = along_t;
    (*result_2) = across;
    (*result_3) = across_t;
    return 0;
}

/* Tangent of ``add_strip``. */
static inline int64_t tangent_tractions__add_strip_t(array_double_1d work, array_double_1d work_t, int64_t rolling, int64_t strip, double along, double along_t, double across, double across_t, double moment, double moment_t)
{
    double v1;
    (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_FORCE_X)) = along_t;
    (*cspan_at(&work, strip + layout__ROLLING_STRIP_FORCE_X)) = along;
    (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_FORCE_Y)) = across_t;
    (*cspan_at(&work, strip + layout__ROLLING_STRIP_FORCE_Y)) = across;
    (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_MOMENT)) = moment_t + ((*cspan_at(&work_t, strip + layout__ROLLING_STRIP_X)) * across + (*cspan_at(&work, strip + layout__ROLLING_STRIP_X)) * across_t);
    (*cspan_at(&work, strip + layout__ROLLING_STRIP_MOMENT)) = moment + (*cspan_at(&work, strip + layout__ROLLING_STRIP_X)) * across;
    (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_FORCE_X)) = (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_FORCE_X)) + (along_t * (*cspan_at(&work, strip + layout__ROLLING_STRIP_WIDTH)) + along * (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_WIDTH)));
    (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_X)) = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_X)) + along * (*cspan_at(&work, strip + layout__ROLLING_STRIP_WIDTH));
    (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_FORCE_Y)) = (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_FORCE_Y)) + (across_t * (*cspan_at(&work, strip + layout__ROLLING_STRIP_WIDTH)) + across * (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_WIDTH)));
    (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_Y)) = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_Y)) + across * (*cspan_at(&work, strip + layout__ROLLING_STRIP_WIDTH));
    v1 = moment + (*cspan_at(&work, strip + layout__ROLLING_STRIP_X)) * across - (*cspan_at(&work, strip + layout__ROLLING_STRIP_Y)) * along;
    (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_MOMENT)) = (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_MOMENT)) + ((moment_t + ((*cspan_at(&work_t, strip + layout__ROLLING_STRIP_X)) * across + (*cspan_at(&work, strip + layout__ROLLING_STRIP_X)) * across_t) - ((*cspan_at(&work_t, strip + layout__ROLLING_STRIP_Y)) * along + (*cspan_at(&work, strip + layout__ROLLING_STRIP_Y)) * along_t)) * (*cspan_at(&work, strip + layout__ROLLING_STRIP_WIDTH)) + v1 * (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_WIDTH)));
    (*cspan_at(&work, rolling + layout__ROLLING_PATCH_MOMENT)) = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_MOMENT)) + v1 * (*cspan_at(&work, strip + layout__ROLLING_STRIP_WIDTH));
    return INT64_C(0);
}

/* Tangent of ``patch_area``. */
static inline int64_t tangent_tractions__patch_area_t(double* area, double* area_t, array_double_1d work, array_double_1d work_t, int64_t rolling)
{
    int64_t i_end;
    int64_t i;
    int64_t strip;
    double v1;
    (*area_t) = 0.0;
    (*area) = 0.0;
    i_end = (int64_t)((*cspan_at(&work, rolling + layout__ROLLING_PATCH_COUNT)));
    for (i = INT64_C(0); i < i_end; i += INT64_C(1))
    {
        strip = rolling + layout__ROLLING_PATCH_STRIPS + layout__ROLLING_STRIP_SIZE * i;
        v1 = 2.0 * (*cspan_at(&work, strip + layout__ROLLING_STRIP_HALF_LENGTH));
        (*area_t) = (*area_t) + (2.0 * (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_HALF_LENGTH)) * (*cspan_at(&work, strip + layout__ROLLING_STRIP_WIDTH)) + v1 * (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_WIDTH)));
        (*area) = (*area) + v1 * (*cspan_at(&work, strip + layout__ROLLING_STRIP_WIDTH));
    }
    return 0;
}

/* Tangent of ``point_weight``. */
static inline int64_t tangent_tractions__point_weight_t(double* result_0, double* result_1, array_double_1d work, array_double_1d work_t, int64_t strip)
{
    (*result_0) = tractions__WEIGHT * (*cspan_at(&work, strip + layout__ROLLING_STRIP_HALF_LENGTH));
    (*result_1) = tractions__WEIGHT * (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_HALF_LENGTH));
    return 0;
}
