/* Generated from tangent_node_coefficients.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of node_coefficients.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_NODE_COEFFICIENTS_H
#define WRCONTACT_KERNEL_TANGENT_NODE_COEFFICIENTS_H

#include "../native/spans.h"
#include "layout.h"
#include "node_coefficients.h"
#include "tangent_hertz.h"
#include "tangent_rates.h"

static inline int64_t tangent_node_coefficients__second_difference_t(double* v5, double* result_1, array_double_1d work, array_double_1d work_t, int64_t values, int64_t k, double spacing, double spacing_t, int64_t window);
static inline int64_t tangent_node_coefficients__secant_curvature_t(double* v3, double* result_1, array_double_1d work, array_double_1d work_t, int64_t gaps, int64_t k, double spacing, double spacing_t, int64_t window, double middle, double middle_t);
static inline int64_t tangent_node_coefficients__windowed_curvature_t(double* v4, double* result_1, double averaged, double averaged_t, double secant, double secant_t, double share, double share_t);
static inline int64_t tangent_node_coefficients__adaptive_curvatures_t(double* secant, double* secant_t, double* side, double* side_t, double* B, double* B_t, array_double_1d work, array_double_1d work_t, int64_t region, int64_t gaps, int64_t k, int64_t window, double middle, double middle_t, double mean, double mean_t, double least, double least_t);
static inline int64_t tangent_node_coefficients__skew_factors_t(double* v2, double* result_1, double* v3, double* result_3, double* v4, double* result_5, array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t region, double A, double A_t);
static inline int64_t tangent_node_coefficients__weigh_nodes_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t region, int64_t nodes, int64_t window, int64_t yawed);

#endif
