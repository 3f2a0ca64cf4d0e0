/* Generated from tangential/polach.py by tools/transpile_kernel.py; change that one.
 *
 * Polach's formula for one ellipse.
 *
 * O. Polach, A fast wheel-rail forces calculation computer code, Vehicle System Dynamics Supplement 33 (1999)
 * 728-739, without his reduction factors for wet rails.  With the semi-axes a along and b across, Kalker's
 * coefficients C_ij and
 *
 *     eta_c = eta + phi a where that is larger than eta, else eta;   s_c = sqrt(xi^2 + eta_c^2)
 *     C = sqrt((C11 xi)^2 + (C22 eta)^2) / sqrt(xi^2 + eta^2)
 *     e = pi a b G C s_c / (4 mu N)                                                              (P1)
 *     F = (2 mu N / pi) (e / (1 + e^2) + arctan e)                                               (P2)
 *
 * the force is F (xi, eta) / s_c against the slip, and the lateral force of spin
 *
 *     B = 1 + 6.3 (1 - exp(-a/b)),   e_s = (8/3) G b sqrt(ab) C23 s_c / (mu N B)                 (P3)
 *     K = e_s (d^3/3 - d^2/2 + 1/6) - (1 - d^2)^1.5 / 3,   d = (e_s^2 - 1) / (e_s^2 + 1)         (P4)
 *     F_s = (9/16) a mu N K B phi / s_c                                                          (P5)
 *
 * comes to it; K is negative.  Their sum is cut to mu N.  The formula knows neither a moment of spin nor a stick
 * zone.  For small creepages it is Kalker's linear theory: K = -(2/3) e_s.
 */

#ifndef WRCONTACT_KERNEL_POLACH_H
#define WRCONTACT_KERNEL_POLACH_H

#include "../native/spans.h"
#include "layout.h"
#include "shapes.h"

static const double polach__SMALLEST = 1e-150;

static inline double polach__mean_coefficient(array_double_1d work, int64_t rolling, double first, double second, double slip);
static inline double polach__creep_force(array_double_1d work, double shear_modulus, int64_t rolling, double coefficient, double whole);
static inline double polach__spin_share(double e);
static inline double polach__spin_force(array_double_1d work, double shear_modulus, int64_t rolling, double coefficient, double whole);
static inline int64_t polach__cut_force(array_double_1d work, int64_t rolling);
static inline double polach__largest_shear(array_double_1d work, int64_t rolling);
static inline int64_t polach__solve_polach(array_double_1d work, array_double_1d tables, int64_t rolling);

#endif
