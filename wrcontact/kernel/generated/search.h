/* Generated from search/search.py by tools/transpile_kernel.py; change that one.
 *
 * The smallest vertical gap of one side: march, bound, refine.
 *
 * The gap has up to three local minima (tread, flange root, flange) that exchange rank.  From a known place the search
 * marches outwards over a fixed raster of the wheel profile.  Gap, slope and a lower bound of the second derivative tell how
 * far the gap cannot have fallen below the best one known; that stretch, of up to 32 cells, is skipped.  Where not even one
 * cell can be, the gap between its two nodes lies above its chord by no less than -M h^2 / 8, where M bounds its second
 * derivative from above, and a cell that could still hold a smaller value is halved until that is settled.  So the global
 * minimum is bounded and not assumed.
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
static const int64_t search__SCAN_RAIL_PER_METRE = INT64_C(3);
static const int64_t search__SCAN_RAIL_OFFSET = INT64_C(4);
static const int64_t search__SCAN_BIN_OFFSET = INT64_C(5);
static const int64_t search__SCAN_BIN_COUNT = INT64_C(6);
static const int64_t search__SCAN_BINS_PER_METRE = INT64_C(7);
static const int64_t search__SCAN_STEEPEST = INT64_C(8);
static const int64_t search__SCAN_NODES = INT64_C(9);
static const int64_t search__LEVELS = INT64_C(6);
static const int64_t search__SCAN_ROW = INT64_C(17);
static const int64_t search__ROW_Y = INT64_C(0);
static const int64_t search__ROW_HEIGHT = INT64_C(1);
static const int64_t search__ROW_SLOPE = INT64_C(2);
static const int64_t search__ROW_LEAST_BEND = INT64_C(3);
static const int64_t search__ROW_MOST_BENDS = INT64_C(4);
static const int64_t search__ROW_STEEPEST_BENDS = INT64_C(10);
static const int64_t search__ROW_LEVER = INT64_C(16);
static const int64_t search__RAIL_ROW = INT64_C(9);
static const int64_t search__RAIL_LEAST_BEND = INT64_C(0);
static const int64_t search__RAIL_MOST_BEND = INT64_C(1);
static const int64_t search__RAIL_LEAST_BENDS = INT64_C(2);
static const double search__YAWED_SHARE = 0.3;
static const double search__STRETCHED_SHARE = 10.0;
static const double search__ROLLED_SHARE = 0.02;
static const double search__STEEP = 3.0;
static const double search__ROLL_STRETCH = 3.1;
static const double search__BEND_STRETCH = 1.1;
static const double search__STEEP_STRETCH = 10.0;
static const double search__ROLL_BEND = 9.5;
static const double search__YAW_BEND = 18.0;
static const double search__WIDEST = 0.25;
static const double search__REACH_SHARE = 1.2;
static const double search__REACH_ROLL = 0.06;
static const double search__FINE_CELL = 0.000501;
static const int64_t search__PROBE_STRIDE = INT64_C(8);
static const double search__NARROW = 2e-06;
static const double search__LISTED = 2e-06;
static const double search__LISTED_ONE = 0.00025;
static const double search__SHARP = 1e-13;
static const double search__ROUNDING = 1e-15;
static const double search__END_SHARP = 1e-09;
static const double search__LARGE_GAP = 1000.0;
static const int64_t search__CANDIDATES = INT64_C(16);

static inline int64_t search__node_below(array_double_1d tables, double y);
static inline int64_t search__node_gap(double* result_0, double* result_1, double* abscissa, array_double_1d tables, array_double_1d place, int64_t at, int64_t node);
static inline double search__rail_cell(array_double_1d tables, double abscissa);
static inline int64_t search__rail_row(array_double_1d tables, double u);
static inline int64_t search__least_bend(double* bend, double* stretch, array_double_1d tables, array_double_1d place, int64_t at, int64_t first, int64_t level, double length, double u);
static inline double search__largest_fall(double slope, double bend, double length, double stretch);
static inline int64_t search__clear_level(array_double_1d tables, array_double_1d place, int64_t at, int64_t node, int64_t direction, double abscissa, double excess, double slope, int64_t level, int64_t risen);
static inline int64_t search__leave_minimum(array_double_1d tables, array_double_1d place, int64_t at, int64_t cell, int64_t direction, double abscissa);
static inline int64_t search__bend_bounds(double* least, double* most, array_double_1d tables, array_double_1d place, int64_t at, int64_t cell, double abscissa);
static inline double search__rail_end(array_double_1d tables, array_double_1d place, int64_t at, int64_t node, int64_t outward);
static inline int64_t search__push_cell(array_double_1d work, int64_t top, double low, double high, double gap_low, double gap_high, double mismatch_low, double mismatch_high);
static inline int64_t search__keep_best(array_double_1d work, int64_t side, double y, double gap);
static inline double search__least_slope(double least, double most, double width, double first, double last);
static inline int64_t search__is_steady(double least, double most, double width, double mismatch_low, double mismatch_high);
static inline int64_t search__refine_minimum(double* y, double* gap, array_double_1d tables, array_double_1d place, int64_t at, array_double_1d state, double low, double high, double mismatch_low, double mismatch_high, double sharp);
static inline int64_t search__keep_refined(array_double_1d work, int64_t side, double y, double gap, double width);
static inline int64_t search__search_cell(array_double_1d tables, array_double_1d work, int64_t side, array_double_1d place, int64_t at, array_double_1d state, double least, double most, double first, double last);
static inline int64_t search__search_end(array_double_1d tables, array_double_1d work, int64_t side, array_double_1d place, int64_t at, array_double_1d state, int64_t node, int64_t outward, double abscissa, double beyond);
static inline int64_t search__is_gone(array_double_1d tables, array_double_1d place, int64_t at, int64_t node, int64_t direction, double abscissa);
static inline int64_t search__bound_cell(array_double_1d tables, array_double_1d work, int64_t side, array_double_1d place, int64_t at, array_double_1d state, int64_t cell, double gap_low, double gap_high, double abscissa);
static inline int64_t search__march(array_double_1d tables, array_double_1d work, int64_t side, array_double_1d place, int64_t at, array_double_1d state, int64_t node, int64_t direction);
static inline int64_t search__probe(array_double_1d tables, array_double_1d work, int64_t side, array_double_1d place, int64_t at, array_double_1d state, int64_t stride);
static inline int64_t search__search_side(array_double_1d tables, array_double_1d work, int64_t side, array_double_1d place, int64_t at, array_double_1d state, int64_t known);
static inline double search__rail_place(array_double_1d tables, array_double_1d place, int64_t at, double y);
static inline int64_t search__list_minimum(array_double_1d work, int64_t side, double y, double abscissa, int64_t direction);
static inline int64_t search__list_cell(array_double_1d tables, array_double_1d work, int64_t side, array_double_1d place, int64_t at, array_double_1d state, double reach, int64_t cell, int64_t direction, double abscissa, double low, double high, double gap_low, double gap_high, double mismatch_low, double mismatch_high);
static inline int64_t search__list_end(array_double_1d tables, array_double_1d work, int64_t side, array_double_1d place, int64_t at, array_double_1d state, double reach, int64_t node, int64_t outward, int64_t direction);
static inline int64_t search__scan_on(array_double_1d tables, array_double_1d work, int64_t side, array_double_1d place, int64_t at, array_double_1d state, double reach, int64_t node, int64_t direction);
static inline int64_t search__scan_side(array_double_1d tables, array_double_1d work, int64_t side, array_double_1d place, int64_t at, array_double_1d state, double reach, double abscissa);

#endif
