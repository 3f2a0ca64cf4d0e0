/* Generated from tangential/slip_march.py by tools/transpile_kernel.py; change that one.
 *
 * Tractions of a strip from its leading edge to its trailing one.
 *
 * In the slip zone the traction is the bound; two marches tell its direction.  Both lose traction to the slip,
 * over steps D = x_{q-1} - x_q, and are cut to the bound g = m sqrt(a^2 - x^2):
 *
 *     p_A <- p_A - D (w_x i1, w_y i2 + phi x_m i3)   from zero at the leading edge,                (M1)
 *     p_B <- p_B - D i_c (w_x, w_y + phi x_m)        from the edge of the stick zone,              (M2)
 *     i1 = (pi/2) K1 sum(a h)/sum(a^2 h),  i2 the same with K2,
 *     i3 = (3 pi/4) K3 sum(a^2 h)/sum(a^3 h),   s = 3 pi a phi / 32,
 *     i_c = (w_x^2 i1 + w_y^2 i2 + s^2 i3) / (w_x^2 + w_y^2 + s^2)                                  (M3)
 *
 * x_m = x_q + L D.  A describes long patches, B has the direction of the rigid slip where that is large.  With
 * t = 2 sqrt(w_x^2 i1^2 + w_y^2 i2^2 + s^2 i3^2)/m, how often the creepage fills the bound, A becomes B:
 *
 *     i_j <- i_c + (i_j - i_c) / (1 + (t/6)^2),   L = (0.4 + 0.1 r/(r + 3)) / (1 + (t'/20)^2)       (M4)
 *
 * with t' = t for the new i_j.  The direction is that of c = (1 - W) p_A + W p_B, W = 0.65/(1 + (r/1.2)^4),
 *
 *     n = c g / sqrt(|c|^2 + 0.05^2 (g^2 - |c|^2))                                                 (M5)
 *
 * Where the stick zone (stick_zone.py) has the weight c < 1, the rest of the traction is that of a strip which
 * slips all over.  The first point behind the stick zone takes over in proportion to the way from its edge.
 *
 * All strips march side by side, with places over a and tractions over m a, so that bounds and steps are those
 * of all of them, and compilers do several strips at once.
 */

#ifndef WRCONTACT_KERNEL_SLIP_MARCH_H
#define WRCONTACT_KERNEL_SLIP_MARCH_H

#include "../native/spans.h"
#include "layout.h"
#include "tractions.h"

static const double slip_march__LAG = 0.4;
static const double slip_march__LONG_LAG = 0.1;
static const double slip_march__LAG_RATIO = 3.0;
static const double slip_march__LAG_FILLS = 20.0;
static const double slip_march__FILLS = 6.0;
static const double slip_march__SHARE = 0.65;
static const double slip_march__SHARE_RATIO = 1.2;
static const double slip_march__SOFT = 0.05;
static const double slip_march__NOTHING = 1e-300;

static inline int64_t slip_march__open_marches(array_double_1d work, int64_t marches, double ratio);
static inline int64_t slip_march__set_pushes(array_double_1d work, int64_t march, int64_t marches, int64_t number, double plane, double spinning, double ratio);
static inline int64_t slip_march__add_beyond(array_double_1d tables, array_double_1d work, int64_t table, int64_t march, int64_t marches, int64_t number, int64_t last);
static inline int64_t slip_march__set_stick(array_double_1d tables, array_double_1d work, int64_t table, int64_t march, int64_t marches, int64_t number);
static inline int64_t slip_march__has_slip(array_double_1d work, int64_t marches);
static inline double slip_march__sqrt_of(double value);
static inline int64_t slip_march__stepped(double* result_0, double* result_1, array_double_1d work, int64_t marches, int64_t i, double p_x, double p_y, double x, double step);
static inline int64_t slip_march__note_largest(array_double_1d work, int64_t marches, int64_t i, double p_x, double p_y);
static inline int64_t slip_march__reach_edge(array_double_1d work, int64_t marches, int64_t i, double before, double x, double bound);
static inline int64_t slip_march__march_first(array_double_1d work, int64_t marches, double x, double bound, double step);
static inline int64_t slip_march__march_second(array_double_1d work, int64_t marches, double x, double bound, double step);
static inline int64_t slip_march__slip_traction(double* result_0, double* result_1, array_double_1d work, int64_t marches, int64_t i, double bound);
static inline int64_t slip_march__leave_edge(array_double_1d work, int64_t marches, int64_t i, double x, double bound);
static inline int64_t slip_march__march_strips(array_double_1d tables, array_double_1d work, int64_t table, int64_t marches);

#endif
