/* Generated from tangent_strip_placement.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of strip_placement.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_STRIP_PLACEMENT_H
#define WRCONTACT_KERNEL_TANGENT_STRIP_PLACEMENT_H

#include "../native/spans.h"
#include "layout.h"
#include "strip_placement.h"
#include "tangent_rates.h"

static inline int64_t tangent_strip_placement__zone_excess_t(double* excess, double* excess_t, array_double_1d work, array_double_1d work_t, int64_t region, int64_t nodes, int64_t k, double penetration, double penetration_t);
static inline int64_t tangent_strip_placement__zone_end_t(double* station, double* station_t, array_double_1d work, array_double_1d work_t, int64_t region, int64_t nodes, int64_t direction, double penetration, double penetration_t);
static inline int64_t tangent_strip_placement__node_weight_t(double* weight, double* weight_t, array_double_1d work, array_double_1d work_t, int64_t region, int64_t nodes, int64_t k, double penetration, double penetration_t);
static inline int64_t tangent_strip_placement__cell_overlap_t(double* result_0, double* result_1, double* start, double* start_t, array_double_1d work, array_double_1d work_t, int64_t zone, int64_t region, int64_t k);
static inline int64_t tangent_strip_placement__zone_weight_t(double* total, double* total_t, array_double_1d work, array_double_1d work_t, int64_t zone, int64_t region, int64_t nodes);
static inline int64_t tangent_strip_placement__measure_zone_t(array_double_1d work, array_double_1d work_t, int64_t zone, int64_t region, int64_t nodes, double penetration, double penetration_t);
static inline int64_t tangent_strip_placement__cut_strip_t(array_double_1d work, array_double_1d work_t, int64_t i, int64_t index, double offset, double offset_t, double start, double start_t, double stop, double stop_t);
static inline int64_t tangent_strip_placement__divide_zone_t(array_double_1d work, array_double_1d work_t, int64_t region, int64_t nodes, int64_t index, int64_t first, int64_t own);
static inline int64_t tangent_strip_placement__join_strips_t(array_double_1d work, array_double_1d work_t, int64_t count);
static inline int64_t tangent_strip_placement__place_strips_t(array_double_1d work, array_double_1d work_t, int64_t count, int64_t wanted, double penetration, double penetration_t);

#endif
