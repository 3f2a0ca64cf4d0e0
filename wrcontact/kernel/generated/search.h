/* Generated from search.py by tools/transpile_kernel.py; change that one.
 *
 * The smallest vertical gap of one side: scan, bound, refine.
 *
 * The gap has up to three local minima (tread, flange root, flange) that exchange rank.  The scan nodes lie on a fixed
 * raster of the wheel profile.  Between two nodes the gap lies above its chord by no less than -M h^2 / 8, where M bounds
 * its second derivative from above; where a lower bound of the second derivative is positive the cell is convex and holds
 * one minimum at most.  Cells that could hold a value below the best one known are halved until neither is left open, so
 * the global minimum is bounded and not assumed.
 */

#ifndef WRCONTACT_KERNEL_SEARCH_H
#define WRCONTACT_KERNEL_SEARCH_H

#include "../native/spans.h"
#include "gap.h"
#include "layout.h"
#include "locus.h"
#include "profile_table.h"

static const int64_t search__SCAN_COUNT = INT64_C(0);
static const int64_t search__SCAN_RAIL_COUNT = INT64_C(1);
static const int64_t search__SCAN_RAIL_START = INT64_C(2);
static const int64_t search__SCAN_RAIL_STEP = INT64_C(3);
static const int64_t search__SCAN_RAIL_OFFSET = INT64_C(4);
static const int64_t search__SCAN_NODES = INT64_C(8);
static const int64_t search__SCAN_ROW = INT64_C(5);
static const int64_t search__ROW_Y = INT64_C(0);
static const int64_t search__ROW_HEIGHT = INT64_C(1);
static const int64_t search__ROW_SLOPE = INT64_C(2);
static const int64_t search__ROW_LEAST_BEND = INT64_C(3);
static const int64_t search__ROW_MOST_BEND = INT64_C(4);
static const int64_t search__RAIL_ROW = INT64_C(2);
static const double search__YAWED_SHARE = 0.3;
static const double search__STRETCHED_SHARE = 10.0;
static const double search__ROLLED_SHARE = 0.02;
static const double search__DEEPEST = 0.004;
static const double search__NARROW = 3.2e-05;
static const double search__SHARP = 1e-13;
static const double search__LONGEST_MOVE = 0.0005;
static const int64_t search__FOLLOW_ITERATIONS = INT64_C(12);
static const double search__END_SHARP = 1e-09;
static const double search__SCAN_LEAD = 0.03;
static const double search__LARGE_GAP = 1000.0;

static int64_t search__scan_side(array_double_1d tables, array_double_1d work, int64_t side, array_double_1d place, int64_t at, array_double_1d state);
static int64_t search__bend_bounds(double* least, double* most, array_double_1d tables, array_double_1d place, int64_t at, int64_t cell, double abscissa);
static int64_t search__push_cell(array_double_1d work, int64_t top, double low, double high, double gap_low, double gap_high, double mismatch_low, double mismatch_high);
static int64_t search__keep_best(array_double_1d work, int64_t side, double y, double gap);
static int64_t search__refine_minimum(double* y, double* gap, array_double_1d tables, array_double_1d place, int64_t at, array_double_1d state, double low, double high, double mismatch_low, double mismatch_high);
static int64_t search__search_cell(array_double_1d tables, array_double_1d work, int64_t side, array_double_1d place, int64_t at, array_double_1d state, double least, double most, double first, double last);
static int64_t search__search_end(array_double_1d tables, array_double_1d work, int64_t side, array_double_1d place, int64_t at, array_double_1d state, int64_t node, int64_t outward);
static int64_t search__search_ends(array_double_1d tables, array_double_1d work, int64_t side, array_double_1d place, int64_t at, array_double_1d state, int64_t first, int64_t last);
static int64_t search__search_side(array_double_1d tables, array_double_1d work, int64_t side, array_double_1d place, int64_t at, array_double_1d state, int64_t known);
static int64_t search__follow_minimum(array_double_1d tables, array_double_1d work, int64_t side, array_double_1d place, int64_t at, array_double_1d state);

#endif
