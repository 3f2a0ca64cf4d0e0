/* Generated from tangent_dissipation.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of dissipation.py.
 */

#include "tangent_dissipation.h"

/* Tangent of ``keep_dissipating``. */
static inline int64_t tangent_dissipation__keep_dissipating_t(array_double_1d work, array_double_1d work_t, int64_t rolling)
{
    double v1;
    double v1_t;
    double gain_t;
    double gain;
    double reach_t;
    double reach;
    double v2;
    double most_t;
    double most;
    double v3;
    double moment_t;
    double moment;
    tangent_dissipation__bent_gain_t(&v1, &v1_t, work, work_t, rolling);
    gain_t = (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_CREEPAGE_X)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_X)) + (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_X)) * (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_FORCE_X)) + ((*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_CREEPAGE_Y)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_Y)) + (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_Y)) * (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_FORCE_Y))) + ((*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_SPIN)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_MOMENT)) + (*cspan_at(&work, rolling + layout__ROLLING_PATCH_SPIN)) * (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_MOMENT))) + v1_t;
    gain = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_X)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_X)) + (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_Y)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_Y)) + (*cspan_at(&work, rolling + layout__ROLLING_PATCH_SPIN)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_MOMENT)) + v1;
    if ((gain > 0.0) && ((*cspan_at(&work, rolling + layout__ROLLING_PATCH_SPIN)) != 0.0))
    {
        reach_t = (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_HALF_LENGTH));
        reach = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_LENGTH));
        if (reach < (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_WIDTH)))
        {
            reach_t = (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_HALF_WIDTH));
            reach = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_WIDTH));
        }
        v2 = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FRICTION)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_LOAD));
        most_t = ((*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_FRICTION)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_LOAD)) + (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FRICTION)) * (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_LOAD))) * reach + v2 * reach_t;
        most = v2 * reach;
        v3 = gain / (*cspan_at(&work, rolling + layout__ROLLING_PATCH_SPIN));
        moment_t = (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_MOMENT)) - (gain_t - v3 * (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_SPIN))) / (*cspan_at(&work, rolling + layout__ROLLING_PATCH_SPIN));
        moment = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_MOMENT)) - v3;
        if (moment > most)
        {
            moment_t = most_t;
            moment = most;
        }
        if (moment < -most)
        {
            moment_t = -most_t;
            moment = -most;
        }
        (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_MOMENT)) = moment_t;
        (*cspan_at(&work, rolling + layout__ROLLING_PATCH_MOMENT)) = moment;
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
