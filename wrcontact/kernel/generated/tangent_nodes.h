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
#include "tangent_curves.h"
#include "tangent_lateral_curvature.h"
#include "tangent_profile_table.h"
#include "tangent_rates.h"
#include "tangent_separation.h"
#include "tangent_traces.h"

static inline int64_t tangent_nodes__trace_tolerance_t(double* tolerance, double* tolerance_t, double spacing, double spacing_t);
static inline int64_t tangent_nodes__turn_cosine_t(double* v4, double* result_1, array_double_1d work, array_double_1d work_t, array_double_1d tables);
static inline int64_t tangent_nodes__trace_node_t(double* gap, double* gap_t, double* rate, double* rate_t, array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, int64_t region, int64_t nodes, int64_t at);
static inline int64_t tangent_nodes__end_region_t(array_double_1d work, array_double_1d work_t, int64_t region, int64_t direction, double station, double station_t);
static inline int64_t tangent_nodes__fill_straight_t(array_double_1d work, array_double_1d work_t, int64_t values, int64_t start, int64_t stop, int64_t count);
static inline int64_t tangent_nodes__fill_between_t(array_double_1d work, array_double_1d work_t, int64_t nodes, int64_t start, int64_t stop, int64_t count, double spacing, double spacing_t, double start_rate, double start_rate_t, double stop_rate, double stop_rate_t);
static inline int64_t tangent_nodes__extrapolate_node_t(array_double_1d work, array_double_1d work_t, int64_t nodes, int64_t at, int64_t direction);
static inline int64_t tangent_nodes__lay_side_nodes_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, int64_t region, int64_t nodes, int64_t direction, double reach, double reach_t, double rate, double rate_t);
static inline int64_t tangent_nodes__lay_nodes_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, int64_t region, int64_t nodes, double low_reach, double low_reach_t, double high_reach, double high_reach_t);
static inline int64_t tangent_nodes__bring_nearer_t(array_double_1d work, array_double_1d work_t, int64_t region, int64_t nodes);

#endif
