/* Generated from tangential/stick_zone.py by tools/transpile_kernel.py; change that one.
 *
 * Where a strip sticks: strip theory with a bound, made continuous.
 *
 * In units of the bound's rate m the creepages of a strip are u = -K1 w_x / m, v = -K2 w_y / m [m] and
 * k = -K3 phi / m.  The strip sticks from -a + 2 d to its leading edge a, with the traction
 *
 *     p = m (e sqrt(a^2 - x^2) - (e - (0, k)) sqrt((a - d)^2 - (x - d)^2))                         (Z1)
 *     e = (u, v + k d) / d,   d^2 (1 - k^2) - 2 v k d - (U + v^2) = 0,   U = u^2 + s^2             (Z2)
 *
 * after Haines & Ollerton (1963) and Kalker (1967); without spin this is Carter's.  s^2 is twice the variance
 * of u over the strip's width, and a floor in long patches, where all strips would begin to slip at once as k
 * passes 1:
 *
 *     s^2 = (K1 phi h / m)^2 / 6 + (0.3 min(1, r/6) min(|k|, 1.5)^2 a)^2,   r = a/b of the patch     (Z3)
 *
 * Strips slip later than lines: u, v, k and s are taken 1 - (1/2) E f^2 / (d/a) times, E = 0.08 r / (1 + r),
 * f = 2 d/a - (d/a)^2, and eq. (Z2) is solved once more.                                            (Z4)
 *
 * Where the stick zone of eq. (Z2) is about to be none, or asks for tractions beyond the bound at the leading
 * edge, its weight c falls smoothly from 1 to 0, so that no force jumps:  with S(z) = z^2 (3 - 2 z),
 * D = v^2 + (1 - k^2) U, t = sqrt(1 - d/a) and q = |e (1 - t) + (0, k) t|
 *
 *     c = S(D/v^2) (1 - S(q - 1)) S((1 - d/a) / 0.1)                                               (Z5)
 *
 * of which the first two count only for k^2 > 1, the first only for v k < 0.
 */

#ifndef WRCONTACT_KERNEL_STICK_ZONE_H
#define WRCONTACT_KERNEL_STICK_ZONE_H

#include "../native/spans.h"
#include "layout.h"

static const double stick_zone__LATER = 0.08;
static const double stick_zone__FADE = 0.1;
static const double stick_zone__FLOOR = 0.3;
static const double stick_zone__FLOOR_RATIO = 4.5;
static const double stick_zone__FLOOR_TWIST = 1.5;
static const double stick_zone__NOTHING = 1e-300;

static inline double stick_zone__spread_square(array_double_1d work, int64_t march, double scale, double k, double ratio);
static inline double stick_zone__smooth_step(double z);
static inline int64_t stick_zone__slip_depth(double* depth, double* weight, double square, double v, double k, double a);
static inline double stick_zone__later_share(double depth, double ratio);
static inline double stick_zone__edge_weight(array_double_1d work, int64_t march);
static inline int64_t stick_zone__find_stick_zone(array_double_1d work, int64_t march, double width, double ratio);

#endif
