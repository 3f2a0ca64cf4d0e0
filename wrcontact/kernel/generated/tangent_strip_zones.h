/* Generated from tangent_strip_zones.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of strip_zones.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_STRIP_ZONES_H
#define WRCONTACT_KERNEL_TANGENT_STRIP_ZONES_H

#include "../native/spans.h"
#include "layout.h"
#include "strip_zones.h"
#include "tangent_planes.h"
#include "tangent_rates.h"
#include "tangent_zone_width.h"

static inline int64_t tangent_strip_zones__measure_zone_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, int64_t region, int64_t zone, double deepest, double deepest_t);
static inline int64_t tangent_strip_zones__find_zones_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, int64_t count, double deepest, double deepest_t);

#endif
