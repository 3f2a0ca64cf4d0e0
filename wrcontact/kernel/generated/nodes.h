/* Generated from normal/nodes.py by tools/transpile_kernel.py; change that one.
 *
 * Nodes across a region: gap, longitudinal curvature, and a prepared lateral curvature.
 *
 * Nodes are anchored at the minimum of the region, station + k h, with h a fixed share of the half-width of the
 * interpenetration. So a result depends on the pose alone and is smooth in it.
 */

#ifndef WRCONTACT_KERNEL_NODES_H
#define WRCONTACT_KERNEL_NODES_H

#include "../native/spans.h"
#include "contact_plane.h"
#include "curves.h"
#include "lateral_curvature.h"
#include "layout.h"
#include "profile_table.h"
#include "separation.h"
#include "traces.h"

static const double nodes__WINDOW = 0.26666666666666666;
static const double nodes__TRACE_SHARE = 0.01;
static const double nodes__COARSEST_TRACE = 5e-06;
static const double nodes__LEAST_TURN = 0.2;

static inline int64_t nodes__window_nodes(array_double_1d tables);
static inline int64_t nodes__node_stride(array_double_1d tables);
static inline double nodes__trace_tolerance(double spacing);
static inline double nodes__turn_cosine(array_double_1d work, array_double_1d tables);
static inline int64_t nodes__trace_node(double* gap, double* rate, array_double_1d work, array_double_1d tables, array_double_1d state, int64_t region, int64_t nodes, int64_t at);
static inline int64_t nodes__end_region(array_double_1d work, int64_t region, int64_t direction, double station);
static inline int64_t nodes__fill_straight(array_double_1d work, int64_t values, int64_t start, int64_t stop, int64_t count);
static inline int64_t nodes__fill_between(array_double_1d work, int64_t nodes, int64_t start, int64_t stop, int64_t count, double spacing, double start_rate, double stop_rate);
static inline int64_t nodes__extrapolate_node(array_double_1d work, int64_t nodes, int64_t at, int64_t direction);
static inline int64_t nodes__lay_side_nodes(array_double_1d work, array_double_1d tables, array_double_1d state, int64_t region, int64_t nodes, int64_t direction, double reach, double rate);
static inline int64_t nodes__lay_nodes(array_double_1d work, array_double_1d tables, array_double_1d state, int64_t region, int64_t nodes, double low_reach, double high_reach);
static inline int64_t nodes__bring_nearer(array_double_1d work, int64_t region, int64_t nodes);

#endif
