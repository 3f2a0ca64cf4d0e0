/* Generated from normal/strip_placement.py by tools/transpile_kernel.py; change that one.
 *
 * Where the strips of the strip correction lie: how far the zone of each region reaches, and how strips
 * divide it.
 *
 * Half of the strips are spread evenly.  The others have the density sqrt(B) sqrt(1 - g / penetration): they are
 * narrower where the gap bends and near the contact (docs/method.md, section 9).
 */

#ifndef WRCONTACT_KERNEL_STRIP_PLACEMENT_H
#define WRCONTACT_KERNEL_STRIP_PLACEMENT_H

#include "../native/spans.h"
#include "layout.h"

static const double strip_placement__ZONE = 0.9;
static const double strip_placement__BEYOND = 0.6;
static const double strip_placement__EVEN = 0.5;
static const int64_t strip_placement__FEWEST = INT64_C(12);
static const double strip_placement__TOUCHING = 1e-06;

static inline double strip_placement__zone_excess(array_double_1d work, int64_t region, int64_t nodes, int64_t k, double penetration);
static inline double strip_placement__zone_end(array_double_1d work, int64_t region, int64_t nodes, int64_t direction, double penetration);
static inline double strip_placement__node_weight(array_double_1d work, int64_t region, int64_t nodes, int64_t k, double penetration);
static inline int64_t strip_placement__cell_overlap(double* result_0, double* start, array_double_1d work, int64_t zone, int64_t region, int64_t k);
static inline double strip_placement__zone_weight(array_double_1d work, int64_t zone, int64_t region, int64_t nodes);
static inline int64_t strip_placement__measure_zone(array_double_1d work, int64_t zone, int64_t region, int64_t nodes, double penetration);
static inline int64_t strip_placement__cut_strip(array_double_1d work, int64_t i, int64_t index, double offset, double start, double stop);
static inline int64_t strip_placement__divide_zone(array_double_1d work, int64_t region, int64_t nodes, int64_t index, int64_t first, int64_t own);
static inline int64_t strip_placement__join_strips(array_double_1d work, int64_t count);
static inline int64_t strip_placement__place_strips(array_double_1d work, int64_t count, int64_t wanted, double penetration);

#endif
