/* Generated from tangential/dissipation.py by tools/transpile_kernel.py; change that one.
 *
 * Friction takes power: what a model would give back is taken out of its result.
 *
 * In steady rolling elastic deformation takes no power in sum, and over the rolling speed friction takes
 *
 *     P = -(xi F_x + eta F_y + phi M + sum_i (w_i - xi + phi y_i) F_x,i)                             (W1)
 *
 * with the longitudinal creepages w_i of the strips.  The complete theory has P >= 0, and so have the models
 * almost everywhere: in one of some thousand cases, with spin and long patches, P is a little below zero.  There
 * the moment is reduced, as far as it drives, and then the force along the slip.  Neither becomes larger, and
 * both stay continuous.
 */

#include "dissipation.h"

/* Take what would be a gain of power, eq. (W1), out of moment and force. */
static inline int64_t dissipation__keep_dissipating(array_double_1d work, int64_t rolling)
{
    double x;
    double y;
    double sliding;
    double turning;
    double gain;
    double less;
    double share;
    x = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_X));
    y = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_Y));
    sliding = x * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_X)) + y * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_Y));
    turning = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_SPIN)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_MOMENT));
    gain = sliding + turning + dissipation__bent_gain(work, rolling);
    if ((gain > 0.0) && (turning > 0.0))
    {
        less = dissipation__smaller(turning, gain);
        (*cspan_at(&work, rolling + layout__ROLLING_PATCH_MOMENT)) *= (turning - less) / turning;
        gain -= less;
    }
    if ((gain > 0.0) && (sliding > 0.0))
    {
        share = dissipation__smaller(sliding, gain) / (x * x + y * y);
        (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_X)) -= share * x;
        (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_Y)) -= share * y;
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

/* The smaller of both. */
static inline double dissipation__smaller(double one, double other)
{
    if (other < one)
    {
        one = other;
    }
    return one;
}
