/* Generated from surface/locus.py by tools/transpile_kernel.py; change that one.
 *
 * The contact locus: where a yawed wheel can touch a rail that is the same all along the track.
 *
 * The wheel is a surface of revolution, the rail a cylinder along x, so their common normal has no x component.
 * That leaves one angle around the wheel for every profile point (Wang 1984; closed form in docs/method.md):
 *
 *     phi(y) = -atan t - asin w,   t = tan(yaw) sin(roll),   w = tan(yaw) cos(roll) r'(y) / sqrt(1 + t^2)
 *
 * Seen along the track the locus is the wheel's outline, and wheel against rail becomes a problem in the (y, z)
 * plane. Everything here is for a right wheel; the left one comes in mirrored (conventions.MIRROR).
 */

#ifndef WRCONTACT_KERNEL_LOCUS_H
#define WRCONTACT_KERNEL_LOCUS_H

#include "../native/spans.h"
#include "layout.h"
#include "profile_table.h"

static inline int64_t locus__set_roll(array_double_1d work, int64_t place, double sin_roll, double cos_roll);
static inline int64_t locus__turn_wheelset(array_double_1d work, int64_t place, double roll);
static inline int64_t locus__place_wheelset(array_double_1d work, int64_t place, double lateral_shift, double yaw, double roll, double radius, double height, double arm);
static inline int64_t locus__mirror_roll(array_double_1d work, int64_t place, int64_t mirrored);
static inline int64_t locus__mirror_place(array_double_1d work, int64_t place, int64_t mirrored, double radius);
static ALWAYS_INLINE int64_t locus__around_wheel(double* result_0, double* result_1, array_double_1d work, int64_t place, double slope);
static inline int64_t locus__outline_point(double* y_track, double* z_track, double* outline_slope, array_double_1d work, int64_t place, double y, double z, double slope);
static inline int64_t locus__outline_jet(double* y_track, double* z_track, double* outline_slope, double* stretch, double* slope_rate, array_double_1d work, int64_t place, double y, double z, double slope, double bend);
static inline double locus__outline_x(array_double_1d work, array_double_1d tables, int64_t place, double y);

#endif
