/* Generated from normal/nodes.py by tools/transpile_kernel.py; change that one.
 *
 * Nodes across a region: gap, longitudinal and lateral curvature, and from them ANALYN's coefficients.
 *
 * Nodes are anchored at the region's minimum, station + k h, with h a fixed share of the half-width of the
 * interpenetration; so a result depends on the pose alone and moves smoothly with it.
 *
 * Lateral curvature.  Second differences over a window w (the curvature averaged with a triangle of half-width w) are
 * smooth but blind to what lies beyond; the secant g/s^2 knows how far the surfaces have parted but lags behind.  With
 * B_t and B_s these two,
 *
 *     B = sqrt(B_t max(B_t, B_s)),   B_t, B_s >= FLOOR A
 *
 * follows a sharp joint (B_t) and keeps a patch from growing where B_t falls to zero or below (B_s).
 *
 * That is the lateral curvature "adaptive".  "smooth" and "rough" are the source's, prepared for each profile
 * (:mod:`lateral_curvature`), one B in all three places; where it is below FLOOR A it counts as that.
 */

#ifndef WRCONTACT_KERNEL_NODES_H
#define WRCONTACT_KERNEL_NODES_H

#include "../native/spans.h"
#include "contact_plane.h"
#include "hertz.h"
#include "lateral_curvature.h"
#include "layout.h"
#include "separation.h"

static const int64_t nodes__NODE_GAP = INT64_C(0);
static const int64_t nodes__NODE_A = INT64_C(1);
static const int64_t nodes__NODE_RISE = INT64_C(2);
static const int64_t nodes__NODE_LINE = INT64_C(3);
static const int64_t nodes__NODE_LENGTH = INT64_C(4);
static const int64_t nodes__NODE_B = INT64_C(5);
static const double nodes__FLOOR = 0.02;
static const double nodes__WINDOW_FLOOR = 0.05;
static const double nodes__GROWTH = 0.12;
static const double nodes__TRACE_SHARE = 0.001;
static const double nodes__FINEST_TRACE = 5e-08;

static inline int64_t nodes__node_field(int64_t region, int64_t field);
static inline int64_t nodes__end_region(array_double_1d work, int64_t block, int64_t direction, double station);
static inline int64_t nodes__fill_straight(array_double_1d work, int64_t field, int64_t start, int64_t stop, int64_t count);
static inline int64_t nodes__fill_between(array_double_1d work, int64_t gaps, int64_t longitudinal, int64_t start, int64_t stop, int64_t count, double spacing, double start_rate, double stop_rate);
static inline int64_t nodes__extrapolate_node(array_double_1d work, int64_t gaps, int64_t longitudinal, int64_t at, int64_t direction);
static inline int64_t nodes__lay_nodes(array_double_1d tables, array_double_1d work, array_double_1d state, int64_t region, double low_reach, double high_reach, double spacing, int64_t window, int64_t stride);
static inline double nodes__second_difference(array_double_1d work, int64_t at, double spacing, int64_t window);
static inline double nodes__secant_curvature(array_double_1d work, int64_t region, int64_t k, int64_t window, double middle);
static inline double nodes__windowed_curvature(double averaged, double secant, double share);
static inline int64_t nodes__adaptive_curvatures(double* secant, double* side, double* B, array_double_1d work, int64_t region, int64_t k, int64_t window, double middle, double mean, double least);
static inline int64_t nodes__turn_region(double* result_0, double* result_1, double* result_2, array_double_1d tables, array_double_1d work, int64_t region);
static inline int64_t nodes__weigh_nodes(array_double_1d tables, array_double_1d work, int64_t region, int64_t window);

#endif
