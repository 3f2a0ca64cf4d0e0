/* Generated from normal/node_coefficients.py by tools/transpile_kernel.py; change that one.
 *
 * ANALYN's coefficients at the nodes of a region, from the longitudinal curvature and a lateral one.
 *
 * Lateral curvature.  Second differences over a window w (the curvature averaged with a triangle of half-width
 * w) are smooth but blind to what lies beyond; the secant g/s^2 knows how far the surfaces have parted but lags
 * behind.  With B_t and B_s these two,
 *
 *     B = sqrt(B_t max(B_t, B_s)),   B_t, B_s >= FLOOR A
 *
 * follows a sharp joint (B_t) and keeps a patch from growing where B_t falls to zero or below (B_s).
 *
 * That is the lateral curvature "adaptive".  "smooth" and "rough" are the source's, prepared for each profile
 * (:mod:`lateral_curvature`), one B in all three places; where it is below FLOOR A it counts as that.
 */

#ifndef WRCONTACT_KERNEL_NODE_COEFFICIENTS_H
#define WRCONTACT_KERNEL_NODE_COEFFICIENTS_H

#include "../native/spans.h"
#include "hertz.h"
#include "layout.h"

static const double node_coefficients__FLOOR = 0.02;
static const double node_coefficients__WINDOW_FLOOR = 0.05;
static const double node_coefficients__GROWTH = 0.12;

static inline double node_coefficients__second_difference(array_double_1d work, int64_t values, int64_t k, double spacing, int64_t window);
static inline double node_coefficients__secant_curvature(array_double_1d work, int64_t gaps, int64_t k, double spacing, int64_t window, double middle);
static inline double node_coefficients__windowed_curvature(double averaged, double secant, double share);
static inline int64_t node_coefficients__adaptive_curvatures(double* secant, double* side, double* B, array_double_1d work, int64_t region, int64_t gaps, int64_t k, int64_t window, double middle, double mean, double least);
static inline int64_t node_coefficients__skew_factors(double* result_0, double* result_1, double* result_2, array_double_1d work, array_double_1d tables, int64_t region, double A);
static inline int64_t node_coefficients__weigh_nodes(array_double_1d work, array_double_1d tables, int64_t region, int64_t nodes, int64_t window, int64_t yawed);

#endif
