/* Generated from contact/regions.py by tools/transpile_kernel.py; change that one.
 *
 * Where a wheel may carry load: the contact point's own region and others whose gap is small enough.
 *
 * A region is the neighbourhood of a local minimum of the normal gap.  Two minima belong to one region while the hump
 * between them stays below MERGE of the penetration; otherwise the hump bounds both.
 */

#ifndef WRCONTACT_KERNEL_REGIONS_H
#define WRCONTACT_KERNEL_REGIONS_H

#include "../native/spans.h"
#include "contact_plane.h"
#include "layout.h"
#include "profile_table.h"
#include "search.h"
#include "separation.h"

static const int64_t regions__REGION_STATION = INT64_C(0);
static const int64_t regions__REGION_GAP = INT64_C(1);
static const int64_t regions__REGION_RAIL = INT64_C(2);
static const int64_t regions__REGION_WHEEL = INT64_C(3);
static const int64_t regions__REGION_LOW = INT64_C(4);
static const int64_t regions__REGION_HIGH = INT64_C(5);
static const int64_t regions__REGION_WIDTH_LOW = INT64_C(6);
static const int64_t regions__REGION_WIDTH_HIGH = INT64_C(7);
static const int64_t regions__REGION_SPACING = INT64_C(8);
static const int64_t regions__REGION_FIRST = INT64_C(9);
static const int64_t regions__REGION_LAST = INT64_C(10);
static const int64_t regions__REGION_LEVEL = INT64_C(11);
static const int64_t regions__REGION_LOAD = INT64_C(12);
static const int64_t regions__REGION_STIFFNESS = INT64_C(13);
static const int64_t regions__REGION_BEND = INT64_C(14);
static const int64_t regions__REGION_CURVATURE = INT64_C(15);
static const int64_t regions__REGION_MIDDLE = INT64_C(16);
static const int64_t regions__REGION_START = INT64_C(21);
static const int64_t regions__REGION_STOP = INT64_C(22);
static const int64_t regions__REGION_REACHED = INT64_C(25);
static const int64_t regions__REGION_SIDE_LOW = INT64_C(26);
static const int64_t regions__REGION_SIDE_HIGH = INT64_C(27);
static const int64_t regions__REGION_UPRIGHT_A = INT64_C(28);
static const int64_t regions__REGION_UPRIGHT_B = INT64_C(29);
static const int64_t regions__REGION_UPRIGHT_SHARE = INT64_C(30);
static const int64_t regions__REGION_SLANT = INT64_C(31);
static const int64_t regions__REGION_OWN = INT64_C(32);
static const int64_t regions__REGION_TURN = INT64_C(33);
static const int64_t regions__REGION_OFFSET = INT64_C(34);
static const int64_t regions__REGION_COS = INT64_C(35);
static const int64_t regions__REGION_SIN = INT64_C(36);
static const int64_t regions__REGION_SHARE = INT64_C(37);
static const int64_t regions__REGION_MOMENT = INT64_C(38);
static const int64_t regions__REGION_CARRIED = INT64_C(39);
static const int64_t regions__REGION_LEAN = INT64_C(40);
static const int64_t regions__REGION_ALONG = INT64_C(41);
static const int64_t regions__REGION_SQUARE = INT64_C(24);
static const int64_t regions__REGION_WEIGHT = INT64_C(23);
static const int64_t regions__REGION_WIDTH_LEVEL = INT64_C(20);
static const int64_t regions__REGION_RESIDUAL = INT64_C(17);
static const int64_t regions__REGION_SLOPE = INT64_C(18);
static const int64_t regions__REGION_MOVE = INT64_C(19);
static const double regions__MERGE = 0.3;
static const double regions__APART = 0.0002;
static const double regions__WANDER = 0.005;
static const double regions__DOWNHILL = 0.00025;
static const double regions__FAR = 1.0;
static const double regions__TRACE = 1e-12;
static const double regions__PLACE_SHARP = 1e-11;
static const double regions__WIDTH_TRACE = 5e-08;
static const double regions__HALVED_SHARP = 1e-09;
static const int64_t regions__WIDTH_ITERATIONS = INT64_C(60);
static const double regions__WIDTH_SHARP = 0.005;
static const double regions__PRESSED_SHARP = 1e-05;
static const int64_t regions__HUMP_SAMPLES = INT64_C(8);
static const int64_t regions__MINIMUM_ITERATIONS = INT64_C(30);

static inline int64_t regions__region_block(int64_t index);
static inline int64_t regions__lean_region(array_double_1d tables, array_double_1d work, int64_t block, double slope);
static inline double regions__open_region(array_double_1d tables, array_double_1d work, array_double_1d state, int64_t index, double station);
static inline int64_t regions__open_contact_region(array_double_1d tables, array_double_1d work, array_double_1d state);
static inline int64_t regions__is_new(array_double_1d work, int64_t count);
static inline int64_t regions__find_regions(array_double_1d tables, array_double_1d work, array_double_1d state, int64_t side, double level);
static inline int64_t regions__swap_regions(array_double_1d work, int64_t first, int64_t second);
static inline int64_t regions__find_hump(double* result_0_0001, double* result_1_0001, array_double_1d tables, array_double_1d work, array_double_1d state, int64_t low, int64_t high);
static inline int64_t regions__bound_regions(array_double_1d tables, array_double_1d work, array_double_1d state, int64_t count, double level);
static inline double regions__zone_width(array_double_1d tables, array_double_1d work, array_double_1d state, int64_t block, double direction, double level, double guess);

#endif
