/* Generated from contact/overlaps.py by tools/transpile_kernel.py; change that one.
 *
 * Where a pressed wheel overlaps its rail: the deepest point of every region, and the humps between them.
 *
 * The overlap is sampled at the scan nodes where the wheel is below the rail, taken straight down and turned into the normal;
 * between two samples where it turns from rising to falling lies a deepest point, which is refined along the rail's normals
 * (:mod:`pressed`).  Two that are parted by a low hump are one region (regions.MERGE).
 */

#ifndef WRCONTACT_KERNEL_OVERLAPS_H
#define WRCONTACT_KERNEL_OVERLAPS_H

#include "../native/spans.h"
#include "bounds.h"
#include "contact_plane.h"
#include "gap.h"
#include "layout.h"
#include "locus.h"
#include "planes.h"
#include "pressed.h"
#include "profile_table.h"
#include "raster.h"
#include "regions.h"

static const int64_t overlaps__DEEP_COUNT = INT64_C(47241);
static const int64_t overlaps__DEEP_FIRST = INT64_C(47242);
static const int64_t overlaps__DEEP_SIZE = INT64_C(6);
static const int64_t overlaps__DEEP_LIMIT = INT64_C(9);
static const int64_t overlaps__DEEP_RAIL = INT64_C(0);
static const int64_t overlaps__DEEP_WHEEL = INT64_C(1);
static const int64_t overlaps__DEEP_DEPTH = INT64_C(2);
static const int64_t overlaps__DEEP_HUMP = INT64_C(3);
static const int64_t overlaps__DEEP_BETWEEN = INT64_C(4);
static const int64_t overlaps__SAMPLE_RAIL = INT64_C(47305);
static const int64_t overlaps__SAMPLE_WHEEL = INT64_C(47705);
static const int64_t overlaps__SAMPLE_RISE = INT64_C(48105);
static const int64_t overlaps__SAMPLE_NEXT = INT64_C(48505);
static const double overlaps__DEEP_SHARP = 1e-13;
static const int64_t overlaps__DEEP_ITERATIONS = INT64_C(60);
static const double overlaps__LEVEL_RISE = 0.0001;
static const double overlaps__SAME = 1e-06;
static const int64_t overlaps__PARTS = INT64_C(4);
static const double overlaps__FIRST_STEP = 1e-07;
static const double overlaps__FAR_STEP = 0.001;
static const int64_t overlaps__WIDENINGS = INT64_C(6);

static OUT_OF_LINE int64_t overlaps__sample_overlap(double* gap, double* result_1, double* abscissa, array_double_1d tables, array_double_1d work, int64_t at, int64_t node, double height, int64_t entry);
static OUT_OF_LINE int64_t overlaps__sample_end(array_double_1d tables, array_double_1d work, int64_t direction, int64_t entry);
static OUT_OF_LINE int64_t overlaps__walk_overlap(array_double_1d tables, array_double_1d work, array_double_1d state, int64_t at, int64_t node, int64_t direction, double height, int64_t first);
static OUT_OF_LINE int64_t overlaps__turning_point(double* result_0, double* result_1_0001, double* result_2, int64_t* result_3, array_double_1d tables, array_double_1d work, int64_t at, double low, double high, double y, double height, double sign);
static OUT_OF_LINE double overlaps__bracket_end(array_double_1d tables, array_double_1d work, int64_t at, double x, double step, double y, double height);
static OUT_OF_LINE int64_t overlaps__keep_deep(array_double_1d work, double x, double y, double depth);
static OUT_OF_LINE int64_t overlaps__remove_deep(array_double_1d work, int64_t entry);
static OUT_OF_LINE int64_t overlaps__drop_deep(array_double_1d work, int64_t entry);
static OUT_OF_LINE int64_t overlaps__find_humps(array_double_1d tables, array_double_1d work, int64_t at, double height);
static OUT_OF_LINE int64_t overlaps__deepest_entry(array_double_1d work);
static OUT_OF_LINE int64_t overlaps__keep_deepest(array_double_1d work);
static OUT_OF_LINE int64_t overlaps__shallowest_entry(array_double_1d work);
static OUT_OF_LINE int64_t overlaps__merge_deep(array_double_1d work);
static OUT_OF_LINE int64_t overlaps__is_listed(array_double_1d work, double x);
static OUT_OF_LINE int64_t overlaps__list_between(array_double_1d tables, array_double_1d work, int64_t at, double low, double high, double y, double height);
static OUT_OF_LINE int64_t overlaps__sort_deep(array_double_1d work);
static OUT_OF_LINE int64_t overlaps__list_smallest(array_double_1d tables, array_double_1d work, int64_t side, int64_t at, double height);
static OUT_OF_LINE int64_t overlaps__find_overlaps(array_double_1d tables, array_double_1d work, array_double_1d state, int64_t side, int64_t at, double height);
static OUT_OF_LINE int64_t overlaps__touching_shift(double* result_0, double* result_1, array_double_1d tables, array_double_1d work, int64_t at, int64_t entry, double height);
static OUT_OF_LINE int64_t overlaps__press_frame(array_double_1d work, double height, double depth, double gap);
static OUT_OF_LINE int64_t overlaps__gather_overlaps(array_double_1d tables, array_double_1d work, array_double_1d state);

#endif
