/* Generated from normal/strip_zones.py by tools/transpile_kernel.py; change that one.
 *
 * Where wheel and rail overlap as they are laid: there the first strips lie.
 */

#ifndef WRCONTACT_KERNEL_STRIP_ZONES_H
#define WRCONTACT_KERNEL_STRIP_ZONES_H

#include "../native/spans.h"
#include "layout.h"
#include "planes.h"
#include "zone_width.h"

static const double strip_zones__SHALLOW = 0.03;
static const double strip_zones__OWN_SHALLOW = 0.25;

static inline int64_t strip_zones__measure_zone(array_double_1d work, array_double_1d tables, array_double_1d state, int64_t region, int64_t zone, double deepest);
static inline int64_t strip_zones__find_zones(array_double_1d work, array_double_1d tables, array_double_1d state, int64_t count, double deepest);

#endif
