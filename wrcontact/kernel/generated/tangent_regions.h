/* Generated from tangent_regions.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of regions.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_REGIONS_H
#define WRCONTACT_KERNEL_TANGENT_REGIONS_H

#include "../native/spans.h"
#include "layout.h"
#include "regions.h"
#include "tangent_contact_plane.h"
#include "tangent_rails.h"
#include "tangent_rates.h"

static inline int64_t tangent_regions__incline_region_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t region, double slope, double slope_t);
static inline int64_t tangent_regions__measure_contact_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state);
static inline int64_t tangent_regions__open_contact_region_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t region);

#endif
