/* Generated from tangent_polach.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of polach.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_POLACH_H
#define WRCONTACT_KERNEL_TANGENT_POLACH_H

#include "../native/spans.h"
#include "layout.h"
#include "polach.h"
#include "tangent_rates.h"
#include "tangent_shapes.h"

static inline int64_t tangent_polach__mean_coefficient_t(double* v4, double* result_1, array_double_1d work, array_double_1d work_t, int64_t rolling, double first, double first_t, double second, double second_t, double slip, double slip_t);
static inline int64_t tangent_polach__creep_force_t(double* result_0, double* result_1, array_double_1d work, array_double_1d work_t, double shear_modulus, double shear_modulus_t, int64_t rolling, double coefficient, double coefficient_t, double whole, double whole_t);
static inline int64_t tangent_polach__spin_share_t(double* result_0, double* result_1, double e, double e_t);
static inline int64_t tangent_polach__spin_force_t(double* result_0, double* result_1, array_double_1d work, array_double_1d work_t, double shear_modulus, double shear_modulus_t, int64_t rolling, double coefficient, double coefficient_t, double whole, double whole_t);
static inline int64_t tangent_polach__cut_force_t(array_double_1d work, array_double_1d work_t, int64_t rolling);
static inline int64_t tangent_polach__largest_shear_t(double* v6, double* result_1, array_double_1d work, array_double_1d work_t, int64_t rolling);
static inline int64_t tangent_polach__solve_polach_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t rolling);

#endif
