/* Generated from tangential/coupled_strips.py by tools/transpile_kernel.py; change that one.
 *
 * Coupled strips: creep force of any patch, strip by strip.
 *
 * Each strip has its stick zone (stick_zone.py) and its slip zone (slip_march.py), with the stiffness that it
 * has beside the others on one half-space (stiffness.py).  What an ellipse with the patch's area and length over
 * width is known to differ by from the complete theory comes to the sum (correction.py).  Sums over a strip:
 *
 *     int p dx = sum_q p_q a pi/(n + 1) sin t_q - c (e - (0, k)) (pi/2) m (a - d)^2,   x_q = a cos t_q   (T1)
 *     int x p_y dx = sum_q x_q p_q,y a pi/(n + 1) sin t_q - c (e_y - k) (pi/2) m (a - d)^2 d            (T2)
 *
 * in which the second root of eq. (Z1) is integrated exactly.
 */

#ifndef WRCONTACT_KERNEL_COUPLED_STRIPS_H
#define WRCONTACT_KERNEL_COUPLED_STRIPS_H

#include "../native/spans.h"
#include "correction.h"
#include "layout.h"
#include "slip_march.h"
#include "stick_zone.h"
#include "stiffness.h"
#include "tractions.h"

static inline int64_t coupled_strips__flexibilities(double* result_0, double* result_1, array_double_1d work, int64_t rolling);
static inline int64_t coupled_strips__begin_march(array_double_1d work, int64_t rolling, int64_t strip, double rate, int64_t index);
static inline int64_t coupled_strips__finish_marches(array_double_1d work, int64_t rolling);
static inline int64_t coupled_strips__add_strips(array_double_1d work, array_double_1d tables, int64_t rolling);
static inline int64_t coupled_strips__solve_strips(array_double_1d work, array_double_1d tables, int64_t rolling);

#endif
