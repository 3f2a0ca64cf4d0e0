/* Generated from tangent_interpolation.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of interpolation.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_INTERPOLATION_H
#define WRCONTACT_KERNEL_TANGENT_INTERPOLATION_H

#include "../native/spans.h"
#include "layout.h"
#include "tangent_quadrature.h"
#include "tangent_rates.h"

static inline int64_t tangent_interpolation__between_strips_t(double* half_length, double* half_length_t, double* pressure, double* pressure_t, array_double_1d work, array_double_1d work_t, int64_t region, double own, double own_t);
static inline int64_t tangent_interpolation__quadratic_at_t(double* half_length, double* half_length_t, double* pressure, double* pressure_t, array_double_1d work, array_double_1d work_t, int64_t count, double station, double station_t);
static inline int64_t tangent_interpolation__straight_at_t(double* half_length, double* half_length_t, double* pressure, double* pressure_t, array_double_1d work, array_double_1d work_t, int64_t patch, int64_t after, double station, double station_t);

#endif
