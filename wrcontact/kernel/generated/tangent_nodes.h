/* Generated from tangent_nodes.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of nodes.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_NODES_H
#define WRCONTACT_KERNEL_TANGENT_NODES_H

#include "../native/spans.h"
#include "contact_plane.h"
#include "layout.h"
#include "nodes.h"
#include "tangent_contact_plane.h"
#include "tangent_hertz.h"
#include "tangent_lateral_curvature.h"
#include "tangent_rates.h"
#include "tangent_separation.h"

static inline int64_t tangent_nodes__end_region_t(array_double_1d work, array_double_1d work_t, int64_t block, int64_t direction, double station, double station_t);
static inline int64_t tangent_nodes__fill_straight_t(array_double_1d work, array_double_1d work_t, int64_t field, int64_t start, int64_t stop, int64_t count);
static inline int64_t tangent_nodes__fill_between_t(array_double_1d work, array_double_1d work_t, int64_t gaps, int64_t longitudinal, int64_t start, int64_t stop, int64_t count, double spacing, double spacing_t, double start_rate, double start_rate_t, double stop_rate, double stop_rate_t);
static inline int64_t tangent_nodes__extrapolate_node_t(array_double_1d work, array_double_1d work_t, int64_t gaps, int64_t longitudinal, int64_t at, int64_t direction);
static inline int64_t tangent_nodes__lay_nodes_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, array_double_1d state, int64_t region, double low_reach, double low_reach_t, double high_reach, double high_reach_t, double spacing, double spacing_t, int64_t window, int64_t stride);
static inline int64_t tangent_nodes__second_difference_t(double* v5, double* result_1, array_double_1d work, array_double_1d work_t, int64_t at, double spacing, double spacing_t, int64_t window);
static inline int64_t tangent_nodes__secant_curvature_t(double* v3, double* result_1, array_double_1d work, array_double_1d work_t, int64_t region, int64_t k, int64_t window, double middle, double middle_t);
static inline int64_t tangent_nodes__windowed_curvature_t(double* v4, double* result_1, double averaged, double averaged_t, double secant, double secant_t, double share, double share_t);
static inline int64_t tangent_nodes__adaptive_curvatures_t(double* secant, double* secant_t, double* side, double* side_t, double* B, double* B_t, array_double_1d work, array_double_1d work_t, int64_t region, int64_t k, int64_t window, double middle, double middle_t, double mean, double mean_t, double least, double least_t);
static inline int64_t tangent_nodes__turn_region_t(double* v5, double* result_1, double* v6, double* result_3, double* v7, double* result_5, array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t region);
static inline int64_t tangent_nodes__weigh_nodes_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t region, int64_t window);

#endif
