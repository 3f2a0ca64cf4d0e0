/* Generated from tangent_stiffness.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of stiffness.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_STIFFNESS_H
#define WRCONTACT_KERNEL_TANGENT_STIFFNESS_H

#include "../native/spans.h"
#include "layout.h"
#include "stiffness.h"
#include "tangent_rates.h"
#include "tangent_shapes.h"

static inline int64_t tangent_stiffness__join_strips_t(array_double_1d work, array_double_1d work_t, int64_t rolling);
static inline int64_t tangent_stiffness__reach_cubic_t(double* result_0, double* result_1, array_double_1d tables, int64_t table, int64_t at, double u, double u_t);
static inline int64_t tangent_stiffness__reaches_t(double* v4, double* v4_t, double* v5, double* v5_t, double* v6, double* v6_t, array_double_1d tables, int64_t table, double distance, double distance_t);
static inline int64_t tangent_stiffness__reach_beside_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t table, int64_t rolling, int64_t i, int64_t j, double near, double near_t, double far, double far_t);
static inline int64_t tangent_stiffness__fill_equations_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t table, int64_t rolling);
static inline int64_t tangent_stiffness__solve_blocks_t(array_double_1d work, array_double_1d work_t, int64_t equations);
static inline int64_t tangent_stiffness__mean_share_t(double* share, double* share_t, double ratio, double ratio_t);
static inline int64_t tangent_stiffness__not_below_t(double* result_0, double* result_1, double value, double value_t, double least, double least_t);
static inline int64_t tangent_stiffness__spread_turning_t(array_double_1d work, array_double_1d work_t, int64_t blocks, double share, double share_t);
static inline int64_t tangent_stiffness__find_stiffnesses_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t rolling);
static inline int64_t tangent_stiffness__stiffnesses_at_t(double* along, double* along_t, double* across, double* across_t, double* turning, double* turning_t, array_double_1d work, array_double_1d work_t, int64_t blocks, int64_t index, double station, double station_t);

#endif
