/* Generated from search/cells.py by tools/transpile_kernel.py; change that one.
 *
 * Local minima of the gap inside one cell of the raster, or inside the part of it that is above the rail.
 *
 * A cell that could hold a minimum is halved until that is settled. The gap between both ends lies above its
 * chord by no less than -M h^2 / 8, where M bounds its second derivative from above. Two loops do this, since
 * they ask for different things: ``search_cell`` for any value below the smallest gap, which narrows as it goes,
 * also at ends; ``list_cell`` for all minima below a fixed reach, in their order, each of them once.
 */

#ifndef WRCONTACT_KERNEL_CELLS_H
#define WRCONTACT_KERNEL_CELLS_H

#include "../native/spans.h"
#include "bounds.h"
#include "gap.h"
#include "layout.h"
#include "raster.h"

static const double cells__NARROW = 2e-06;
static const double cells__LISTED_ONE = 0.00025;
static const double cells__SHARP = 1e-13;
static const double cells__LISTED_SHARP = 2e-06;
static const int64_t cells__REFINEMENTS = INT64_C(60);
static const double cells__ROUNDING = 1e-15;

static inline int64_t cells__write_cell(array_double_1d work, int64_t cell, double low, double high, double gap_low, double gap_high, double mismatch_low, double mismatch_high);
static inline int64_t cells__cell_ends(double* result_0, double* result_1, double* result_2, double* result_3, double* result_4, double* result_5, array_double_1d work, int64_t cell);
static inline int64_t cells__keep_smaller(array_double_1d work, int64_t side, double y, double gap);
static inline int64_t cells__refine_minimum(double* y, double* gap, array_double_1d work, array_double_1d tables, int64_t at, array_double_1d state, int64_t cell, double sharp);
static inline int64_t cells__keep_refined(array_double_1d work, int64_t side, double y, double gap, double width);
static inline int64_t cells__search_cell(array_double_1d work, array_double_1d tables, int64_t side, array_double_1d state, double least, double most, double first, double last);
static inline int64_t cells__list_minimum(array_double_1d work, int64_t side, double y, double abscissa, int64_t direction);
static inline int64_t cells__list_cell(array_double_1d work, array_double_1d tables, int64_t side, array_double_1d state, int64_t node, int64_t direction, double abscissa);

#endif
