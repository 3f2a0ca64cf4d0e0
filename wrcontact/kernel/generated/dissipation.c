/* Generated from tangential/dissipation.py by tools/transpile_kernel.py; change that one.
 *
 * Friction takes power: where a model would give some back, its moment is changed.
 *
 * In steady rolling elastic deformation takes no power in sum, and over the rolling speed friction takes
 *
 *     P = -(xi F_x + eta F_y + phi M + sum_i (w_i - xi + phi y_i) F_x,i)                             (W1)
 *
 * with the longitudinal creepages w_i of the strips.  The complete theory has P >= 0, and so have the models
 * almost everywhere.  In one of some thousand cases, with spin on long patches, the error of the moment makes P
 * negative; there the moment is the one with P = 0.  Forces stay as they are, and nothing jumps.
 */

#include "dissipation.h"

/* Change the moment where it would be a gain of power, eq. (W1), but to no more than friction has. */
static inline int64_t dissipation__keep_dissipating(array_double_1d work, int64_t rolling)
{
    double gain;
    double reach;
    double most;
    double moment;
    gain = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_X)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_X)) + (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_Y)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_Y)) + (*cspan_at(&work, rolling + layout__ROLLING_PATCH_SPIN)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_MOMENT)) + dissipation__bent_gain(work, rolling);
    if ((gain > 0.0) && ((*cspan_at(&work, rolling + layout__ROLLING_PATCH_SPIN)) != 0.0))
    {
        reach = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_LENGTH));
        if (reach < (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_WIDTH)))
        {
            reach = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_WIDTH));
        }
        most = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FRICTION)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_LOAD)) * reach;
        moment = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_MOMENT)) - gain / (*cspan_at(&work, rolling + layout__ROLLING_PATCH_SPIN));
        if (moment > most)
        {
            moment = most;
        }
        if (moment < -most)
        {
            moment = -most;
        }
        (*cspan_at(&work, rolling + layout__ROLLING_PATCH_MOMENT)) = moment;
    }
    return INT64_C(0);
}

/* The sum of eq. (W1), which is zero in a plane patch. */
static inline double dissipation__bent_gain(array_double_1d work, int64_t rolling)
{
    int64_t i_end;
    int64_t i;
    int64_t strip;
    double plane;
    double gain;
    gain = 0.0;
    i_end = (int64_t)((*cspan_at(&work, rolling + layout__ROLLING_PATCH_COUNT)));
    for (i = INT64_C(0); i < i_end; i += INT64_C(1))
    {
        strip = rolling + layout__ROLLING_PATCH_STRIPS + layout__ROLLING_STRIP_SIZE * i;
        plane = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_X)) - (*cspan_at(&work, rolling + layout__ROLLING_PATCH_SPIN)) * (*cspan_at(&work, strip + layout__ROLLING_STRIP_Y));
        gain += ((*cspan_at(&work, strip + layout__ROLLING_STRIP_SLIP)) - plane) * (*cspan_at(&work, strip + layout__ROLLING_STRIP_FORCE_X)) * (*cspan_at(&work, strip + layout__ROLLING_STRIP_WIDTH));
    }
    return gain;
}
