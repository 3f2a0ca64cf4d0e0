/* Generated from contact/overlaps.py by tools/transpile_kernel.py; change that one.
 *
 * Where a pressed wheel overlaps its rail: the deepest point of every region, and the saddles between them.
 *
 * Between two samples (:mod:`overlap_samples`) where the overlap changes from rising to falling lies a deepest
 * point, which is located along the rail's normals (:mod:`pressed`, :mod:`touching`).  Two with a low saddle
 * between them are one region (deep_points.MERGE).
 */

#ifndef WRCONTACT_KERNEL_OVERLAPS_H
#define WRCONTACT_KERNEL_OVERLAPS_H

#include "../native/spans.h"
#include "bounds.h"
#include "deep_points.h"
#include "layout.h"
#include "locus.h"
#include "overlap_samples.h"
#include "pressed.h"
#include "profile_table.h"
#include "raster.h"
#include "touching.h"

static const int64_t overlaps__PARTS = INT64_C(8);
static const int64_t overlaps__HIDDEN_PART = INT64_C(1);
static const int64_t overlaps__OVERLAP_PART = INT64_C(2);
static const double overlaps__NORMAL_SHARE = 0.01;
static const int64_t overlaps__HUMP_ITERATIONS = INT64_C(20);
static const double overlaps__FIRST_STEP = 1e-07;
static const double overlaps__FAR_STEP = 0.001;
static const int64_t overlaps__WIDENINGS = INT64_C(6);

static OUT_OF_LINE int64_t overlaps__may_turn(array_double_1d work, array_double_1d tables, int64_t place, int64_t entry);
static OUT_OF_LINE int64_t overlaps__set_point(array_double_1d work, int64_t point, double x, double rise, double rate);
static OUT_OF_LINE int64_t overlaps__open_stretch(array_double_1d work, array_double_1d tables, int64_t place, int64_t entry);
static OUT_OF_LINE int64_t overlaps__widen_bounds(array_double_1d work, array_double_1d tables, int64_t place, int64_t entry);
static OUT_OF_LINE int64_t overlaps__copy_rise(array_double_1d work, int64_t point, int64_t copy);
static OUT_OF_LINE int64_t overlaps__measure_rise(array_double_1d work, array_double_1d tables, int64_t place, int64_t point, double y);
static OUT_OF_LINE int64_t overlaps__list_turning_point(array_double_1d work, array_double_1d tables, int64_t place, double low, double high, double y);
static OUT_OF_LINE double overlaps__bracket_end(array_double_1d work, array_double_1d tables, int64_t place, double x, double step);
static OUT_OF_LINE int64_t overlaps__widen_stretch(array_double_1d work, array_double_1d tables, int64_t place);
static OUT_OF_LINE double overlaps__wheel_beside(array_double_1d work, double parts);
static OUT_OF_LINE int64_t overlaps__turns_once(array_double_1d work, double share);
static OUT_OF_LINE int64_t overlaps__list_hidden_point(array_double_1d work, array_double_1d tables, int64_t place);
static OUT_OF_LINE int64_t overlaps__list_on_stretch(array_double_1d work, array_double_1d tables, int64_t place, int64_t finest);
static OUT_OF_LINE int64_t overlaps__list_in_cell(array_double_1d work, array_double_1d tables, int64_t place, int64_t entry);
static OUT_OF_LINE int64_t overlaps__list_beside_smallest_gap(array_double_1d work, array_double_1d tables, int64_t side);
static OUT_OF_LINE int64_t overlaps__find_saddles(array_double_1d work, array_double_1d tables, int64_t place);
static OUT_OF_LINE int64_t overlaps__find_overlaps(array_double_1d work, array_double_1d tables, int64_t side, array_double_1d state, double height);

#endif
