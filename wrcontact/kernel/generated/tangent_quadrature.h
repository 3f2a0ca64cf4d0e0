/* Generated from tangent_quadrature.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of quadrature.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_QUADRATURE_H
#define WRCONTACT_KERNEL_TANGENT_QUADRATURE_H

#include "../native/spans.h"
#include "quadrature.h"
#include "tangent_rates.h"

static inline int64_t tangent_quadrature__bend_of_t(double* bend, double* bend_t, double before, double before_t, double low, double low_t, double high, double high_t);
static inline int64_t tangent_quadrature__quadratic_value_t(double* result_0, double* result_1, double before, double before_t, double low, double low_t, double high, double high_t, double x, double x_t);
static inline int64_t tangent_quadrature__cell_part_t(double* start, double* start_t, double* stop, double* stop_t, double d_before, double d_before_t, double d_low, double d_low_t, double d_high, double d_high_t);
static inline int64_t tangent_quadrature__quadratic_integral_t(double* result_0, double* result_1, double before, double before_t, double low, double low_t, double high, double high_t, double stop, double stop_t);
static inline int64_t tangent_quadrature__quadratic_moment_t(double* result_0, double* result_1, double before, double before_t, double low, double low_t, double high, double high_t, double stop, double stop_t);
static inline int64_t tangent_quadrature__quadratic_at_t(double* value, double* value_t, double low, double low_t, double slope, double slope_t, double bend, double bend_t, double x, double x_t);
static inline int64_t tangent_quadrature__bent_integral_t(double* result_0, double* result_1, double low, double low_t, double slope, double slope_t, double bend, double bend_t, double start, double start_t, double stop, double stop_t);
static inline int64_t tangent_quadrature__root_integral_t(double* v2, double* v2_t, double before, double before_t, double low, double low_t, double high, double high_t, double start, double start_t, double stop, double stop_t);

#endif
