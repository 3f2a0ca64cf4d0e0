/* Generated from contact/regions.py by tools/transpile_kernel.py; change that one.
 *
 * Where a wheel may carry load: the contact point's own region and others whose gap is small enough.
 *
 * A region is the neighbourhood of a local minimum of the normal gap.  Between two minima lies a saddle, where
 * the gap is largest.  Both belong to one region while the saddle stays below MERGE of the penetration;
 * otherwise it bounds both.
 */

#ifndef WRCONTACT_KERNEL_REGIONS_H
#define WRCONTACT_KERNEL_REGIONS_H

#include "../native/spans.h"
#include "contact_plane.h"
#include "layout.h"
#include "profile_table.h"
#include "smallest_gap.h"
#include "traces.h"

static const double regions__MERGE = 0.3;
static const double regions__SEPARATE = 0.0002;
static const double regions__WANDER = 0.005;
static const double regions__DOWNHILL = 0.00025;
static const double regions__BEYOND = 1.0;
static const double regions__PLACE_TRACE = 1e-08;
static const double regions__PLACE_SHARP = 1e-11;
static const int64_t regions__SADDLE_SAMPLES = INT64_C(8);
static const int64_t regions__MINIMUM_ITERATIONS = INT64_C(30);

static inline int64_t regions__incline_region(array_double_1d work, array_double_1d tables, int64_t region, double slope);
static inline double regions__open_region(array_double_1d work, array_double_1d tables, int64_t region, array_double_1d state, double station);
static inline int64_t regions__measure_contact(array_double_1d work, array_double_1d tables, array_double_1d state);
static inline int64_t regions__open_contact_region(array_double_1d work, array_double_1d tables, int64_t region);
static inline int64_t regions__is_new(array_double_1d work, int64_t count);
static inline int64_t regions__find_regions(array_double_1d work, array_double_1d tables, int64_t side, array_double_1d state, double level);
static inline int64_t regions__swap_regions(array_double_1d work, int64_t first, int64_t second);
static inline int64_t regions__find_saddle(double* result_0_0001, double* result_1_0001, array_double_1d work, array_double_1d tables, int64_t low, int64_t high, array_double_1d state);
static inline int64_t regions__bound_regions(array_double_1d work, array_double_1d tables, array_double_1d state, int64_t count, double level);

#endif
