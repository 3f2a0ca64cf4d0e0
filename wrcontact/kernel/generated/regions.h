/* Generated from contact/regions.py by tools/transpile_kernel.py; change that one.
 *
 * The region around a contact point or a deepest point, and what belongs to its inclination.
 */

#ifndef WRCONTACT_KERNEL_REGIONS_H
#define WRCONTACT_KERNEL_REGIONS_H

#include "../native/spans.h"
#include "contact_plane.h"
#include "layout.h"
#include "rails.h"

static const double regions__BEYOND = 1.0;
static const double regions__PLACE_TRACE = 1e-08;

static inline int64_t regions__incline_region(array_double_1d work, array_double_1d tables, int64_t region, double slope);
static inline int64_t regions__measure_contact(array_double_1d work, array_double_1d tables, array_double_1d state);
static inline int64_t regions__open_contact_region(array_double_1d work, array_double_1d tables, int64_t region);

#endif
