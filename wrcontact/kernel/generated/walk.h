/* Generated from search/walk.py by tools/transpile_kernel.py; change that one.
 *
 * Walk over the raster of the wheel from a node outwards, and search the cells that
 * may hold a minimum of the gap.
 *
 * Gap, slope and a lower bound of the second derivative tell over how many cells the gap cannot have a value of
 * interest; that stretch, of up to 32 cells, is skipped. Where not even one cell can be skipped, the cell itself
 * is searched. One walk serves two questions: the smallest gap (``listing`` = 0) and all local minima below
 * ``side.reach`` (``listing`` = 1).
 *
 * The overlap of a pressed wheel has a walk of its own (contact/overlaps.py): it keeps what it finds at the
 * nodes, does not look between them, and ends at the first node beside the rail.
 */

#ifndef WRCONTACT_KERNEL_WALK_H
#define WRCONTACT_KERNEL_WALK_H

#include "../native/spans.h"
#include "bounds.h"
#include "cells.h"
#include "gap.h"
#include "layout.h"
#include "raster.h"

static const double walk__LARGE_GAP = 1000.0;

static inline int64_t walk__search_end(array_double_1d work, array_double_1d tables, int64_t side, array_double_1d state, int64_t node, int64_t outward, int64_t direction, int64_t listing);
static inline int64_t walk__search_between(array_double_1d work, array_double_1d tables, int64_t side, array_double_1d state, int64_t node, int64_t direction, double abscissa, int64_t listing);
static inline int64_t walk__walk(array_double_1d work, array_double_1d tables, int64_t side, array_double_1d state, int64_t node, int64_t direction, int64_t listing);

#endif
