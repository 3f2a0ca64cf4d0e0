/* Generated from tangent_strip_influence.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of strip_influence.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_STRIP_INFLUENCE_H
#define WRCONTACT_KERNEL_TANGENT_STRIP_INFLUENCE_H

#include "../native/spans.h"
#include "layout.h"
#include "strip_influence.h"
#include "tangent_rates.h"

static inline int64_t tangent_strip_influence__nearness_t(double* v3, double* result_1, double distance, double distance_t, double half_length, double half_length_t);
static inline int64_t tangent_strip_influence__apartness_t(double* v2, double* result_1, double x, double x_t, double half_length, double half_length_t);
static inline int64_t tangent_strip_influence__influence_at_t(double* result_0, double* result_1, array_double_1d tables, int64_t table, int64_t first, double u, double u_t, double v, double v_t);
static inline int64_t tangent_strip_influence__middle_influence_t(double* result_0, double* result_1, array_double_1d tables, int64_t table, int64_t first, double u, double u_t);
static inline int64_t tangent_strip_influence__mean_at_t(double* v6, double* result_1, array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t table, int64_t strip, double distance, double distance_t, double v, double v_t);
static inline int64_t tangent_strip_influence__begin_influences_t(array_double_1d work, array_double_1d work_t);
static inline int64_t tangent_strip_influence__fill_column_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t table, int64_t j, int64_t yawed);
static inline int64_t tangent_strip_influence__know_influences_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t table, int64_t yawed);
static inline int64_t tangent_strip_influence__far_displacement_t(double* total, double* total_t, array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t table, int64_t i, double x, double x_t, int64_t first, int64_t last);
static inline int64_t tangent_strip_influence__end_displacement_t(double* total, double* total_t, array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t table, int64_t i, double away, double away_t);

#endif
