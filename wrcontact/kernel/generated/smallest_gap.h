/* Generated from search/smallest_gap.py by tools/transpile_kernel.py; change that one.
 *
 * The smallest vertical gap of one side, and the further local minima of the gap.
 *
 * The gap has up to three local minima (tread, flange root, flange) that exchange rank. From a known
 * place, or the best of a few nodes, the search walks outwards over the raster of the wheel. Whatever it
 * leaves out cannot hold a smaller gap, by the bounds of the gap's second derivative: so the global
 * minimum is bounded and not assumed.
 */

#ifndef WRCONTACT_KERNEL_SMALLEST_GAP_H
#define WRCONTACT_KERNEL_SMALLEST_GAP_H

#include "../native/spans.h"
#include "bounds.h"
#include "gap.h"
#include "layout.h"
#include "raster.h"
#include "walk.h"

static const int64_t smallest_gap__PROBE_STRIDE = INT64_C(8);

static inline int64_t smallest_gap__best_node(array_double_1d work, array_double_1d tables, int64_t side, array_double_1d state, int64_t stride);
static inline int64_t smallest_gap__search_side(array_double_1d work, array_double_1d tables, int64_t side, array_double_1d state, int64_t known);
static inline int64_t smallest_gap__list_minima(array_double_1d work, array_double_1d tables, int64_t side, array_double_1d state, double reach, double abscissa);

#endif
