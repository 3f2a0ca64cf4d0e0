/* Generated from tangent_hertz.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of hertz.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_HERTZ_H
#define WRCONTACT_KERNEL_TANGENT_HERTZ_H

#include "../native/spans.h"
#include "hertz.h"
#include "layout.h"
#include "tangent_rates.h"
#include "tangent_table_cell.h"

static inline int64_t tangent_hertz__table_value_t(double* result_0, double* result_1, array_double_1d tables, int64_t table, int64_t column, double abscissa, double abscissa_t);
static inline int64_t tangent_hertz__hertz_coefficients_t(double* v2, double* v2_t, double* v3, double* v3_t, double* v4, double* v4_t, array_double_1d tables, int64_t table, double A, double A_t, double B, double B_t);
static inline int64_t tangent_hertz__skewed_coefficients_t(double* v17, double* result_1, double* v18, double* result_3, double* result_4, double* result_5, array_double_1d tables, int64_t table, double A, double A_t, double B, double B_t, double slant, double slant_t);
static inline int64_t tangent_hertz__middle_slant_t(double* result_0, double* result_1, array_double_1d tables, int64_t table, double A, double A_t, double B, double B_t, double slant, double slant_t);
static inline int64_t tangent_hertz__hertz_stiffness_t(double* v6, double* result_1, array_double_1d tables, int64_t table, double A, double A_t, double B, double B_t, double contact_modulus, double contact_modulus_t);

#endif
