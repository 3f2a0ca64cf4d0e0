/* Generated from tangent_regions.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of regions.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_REGIONS_H
#define WRCONTACT_KERNEL_TANGENT_REGIONS_H

#include "../native/spans.h"
#include "layout.h"
#include "regions.h"
#include "smallest_gap.h"
#include "tangent_contact_plane.h"
#include "tangent_profile_table.h"
#include "tangent_rates.h"
#include "tangent_traces.h"

static inline int64_t tangent_regions__incline_region_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t region, double slope, double slope_t);
static inline int64_t tangent_regions__open_region_t(double* found, double* found_t, array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t region, array_double_1d state, double station, double station_t);
static inline int64_t tangent_regions__measure_contact_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state);
static inline int64_t tangent_regions__open_contact_region_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t region);
static inline int64_t tangent_regions__minimum_rule_t(double* found, double* found_t, array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t region, array_double_1d state, double station, double station_t);
static inline int64_t tangent_regions__find_regions_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t side, array_double_1d state, double level, double level_t);
static inline int64_t tangent_regions__swap_regions_t(array_double_1d work, array_double_1d work_t, int64_t first, int64_t second);
static inline int64_t tangent_regions__saddle_rule_t(double* station, double* station_t, double* gap, double* result_3, array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t low, int64_t high, array_double_1d state);
static inline int64_t tangent_regions__bound_regions_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, int64_t count, double level, double level_t);

#endif
