/* Generated from tangent_strips.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of strips.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_STRIPS_H
#define WRCONTACT_KERNEL_TANGENT_STRIPS_H

#include "../native/spans.h"
#include "contact_plane.h"
#include "layout.h"
#include "nodes.h"
#include "strips.h"
#include "tangent_interaction.h"
#include "tangent_rates.h"

static inline int64_t tangent_strips__zone_excess_t(double* below, double* below_t, array_double_1d work, array_double_1d work_t, int64_t block, int64_t gaps, int64_t rises, int64_t k, double penetration, double penetration_t);
static inline int64_t tangent_strips__zone_end_t(double* station, double* station_t, array_double_1d work, array_double_1d work_t, int64_t region, int64_t direction, double penetration, double penetration_t);
static inline int64_t tangent_strips__node_weight_t(double* weight, double* weight_t, array_double_1d work, array_double_1d work_t, int64_t region, int64_t k, double penetration, double penetration_t);
static inline int64_t tangent_strips__cell_overlap_t(double* result_0, double* result_1, double* start, double* start_t, array_double_1d work, array_double_1d work_t, int64_t block, int64_t k);
static inline int64_t tangent_strips__weigh_region_t(double* total, double* total_t, array_double_1d work, array_double_1d work_t, int64_t region, double penetration, double penetration_t);
static inline int64_t tangent_strips__divide_zone_t(array_double_1d work, array_double_1d work_t, int64_t region, double penetration, double penetration_t, int64_t strips, int64_t own, double even, double even_t, double graded, double graded_t, double share, double share_t);
static inline int64_t tangent_strips__place_strips_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t count, double penetration, double penetration_t);
static inline int64_t tangent_strips__join_strips_t(array_double_1d work, array_double_1d work_t, int64_t strips);
static inline int64_t tangent_strips__cubic_through_t(double* result_0, double* result_1, double before, double before_t, double low, double low_t, double high, double high_t, double after, double after_t, double x, double x_t);
static inline int64_t tangent_strips__cubic_value_t(double* v1, double* v1_t, array_double_1d work, array_double_1d work_t, int64_t at, double x, double x_t);
static inline int64_t tangent_strips__node_value_t(double* result_0, double* result_1, array_double_1d work, array_double_1d work_t, int64_t region, int64_t field, int64_t k, double x, double x_t);
static inline int64_t tangent_strips__locate_strip_t(int64_t* region, int64_t* k, double* x, double* x_t, array_double_1d work, array_double_1d work_t, int64_t i);
static inline int64_t tangent_strips__keep_long_t(array_double_1d work, array_double_1d work_t, int64_t strips, double longest, double longest_t);
static inline int64_t tangent_strips__describe_strips_t(array_double_1d work, array_double_1d work_t, int64_t strips, double penetration, double penetration_t);
static inline int64_t tangent_strips__run_edge_t(double* edge, double* edge_t, array_double_1d work, array_double_1d work_t, int64_t strips, int64_t last, int64_t first, int64_t outward);
static inline int64_t tangent_strips__measure_distances_t(array_double_1d work, array_double_1d work_t, int64_t strips, int64_t i, int64_t others);
static inline int64_t tangent_strips__set_strip_t(array_double_1d work, array_double_1d work_t, int64_t strips, int64_t i, double start, double start_t, double stop, double stop_t);
static inline int64_t tangent_strips__fit_edge_t(array_double_1d work, array_double_1d work_t, int64_t strips, int64_t last, double edge, double edge_t, int64_t outward);
static inline int64_t tangent_strips__fit_edges_t(array_double_1d work, array_double_1d work_t, int64_t strips);
static inline int64_t tangent_strips__influence_value_t(double* result_0, double* result_1, array_double_1d tables, int64_t base, double abscissa, double abscissa_t);
static inline int64_t tangent_strips__near_share_t(double* result_0, double* result_1, double share, double share_t);
static inline int64_t tangent_strips__turn_influence_t(array_double_1d work, array_double_1d work_t, int64_t strips);
static inline int64_t tangent_strips__fill_influence_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t strips, int64_t count);
static inline int64_t tangent_strips__eliminate_t(array_double_1d work, array_double_1d work_t, int64_t size);
static inline int64_t tangent_strips__solve_loaded_t(double* penetration, double* penetration_t, array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t strips, double force, double force_t, double prescribed, double prescribed_t, int64_t by_penetration);
static inline int64_t tangent_strips__exchange_strips_t(array_double_1d work, array_double_1d work_t, int64_t strips, double penetration, double penetration_t, int64_t single);
static inline int64_t tangent_strips__solve_strips_t(double* result_0, double* result_1, int64_t* result_2_0001, array_double_1d tables, array_double_1d work, array_double_1d work_t, array_double_1d state, int64_t strips, double force, double force_t, double prescribed, double prescribed_t, int64_t by_penetration);
static inline int64_t tangent_strips__correct_lengths_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t strips);
static inline int64_t tangent_strips__adopt_lengths_t(array_double_1d work, array_double_1d work_t, int64_t strips);
static inline int64_t tangent_strips__start_loaded_t(array_double_1d work, array_double_1d work_t, int64_t strips);
static inline int64_t tangent_strips__correct_strips_t(double* result_0, double* result_1, int64_t* result_2, int64_t* result_3, array_double_1d tables, array_double_1d work, array_double_1d work_t, array_double_1d state, int64_t count, double force, double force_t, double predicted, double predicted_t, int64_t by_penetration);

#endif
