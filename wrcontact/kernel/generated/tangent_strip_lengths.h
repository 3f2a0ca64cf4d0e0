/* Generated from tangent_strip_lengths.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of strip_lengths.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_STRIP_LENGTHS_H
#define WRCONTACT_KERNEL_TANGENT_STRIP_LENGTHS_H

#include "../native/spans.h"
#include "layout.h"
#include "strip_lengths.h"
#include "tangent_rates.h"
#include "tangent_strip_influence.h"

static inline int64_t tangent_strip_lengths__gap_beside_t(double* result_0, double* result_1, array_double_1d work, array_double_1d work_t, int64_t strip, double x, double x_t);
static inline int64_t tangent_strip_lengths__corrected_t(double* v3, double* result_1, double ratio, double ratio_t, double power, double power_t);
static inline int64_t tangent_strip_lengths__correct_strip_t(double* result_0, double* result_1, array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t table, int64_t i, double penetration, double penetration_t, double power, double power_t, int64_t yawed);
static inline int64_t tangent_strip_lengths__neighbouring_length_t(double* half, double* half_t, array_double_1d work, array_double_1d work_t, int64_t count, int64_t i);
static inline int64_t tangent_strip_lengths__correct_lengths_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, double penetration, double penetration_t, double power, double power_t, int64_t yawed);
static inline int64_t tangent_strip_lengths__limit_lengths_t(array_double_1d work, array_double_1d work_t, int64_t count);
static inline int64_t tangent_strip_lengths__adopt_lengths_t(array_double_1d work, array_double_1d work_t);

#endif
