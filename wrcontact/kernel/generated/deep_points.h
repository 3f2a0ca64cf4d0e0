/* Generated from contact/deep_points.py by tools/transpile_kernel.py; change that one.
 *
 * The list of deepest points of the overlap, in the order of the rail, with the saddles between them.
 */

#ifndef WRCONTACT_KERNEL_DEEP_POINTS_H
#define WRCONTACT_KERNEL_DEEP_POINTS_H

#include "../native/spans.h"
#include "layout.h"

static const double deep_points__MERGE = 0.3;
static const double deep_points__LEAST_HUMP = 1e-09;
static const double deep_points__SAME_POINT = 1e-06;

static OUT_OF_LINE int64_t deep_points__copy_point(array_double_1d work, int64_t point, int64_t copy);
static OUT_OF_LINE int64_t deep_points__append_point(array_double_1d work, double rail, double wheel, double depth);
static OUT_OF_LINE int64_t deep_points__sort_last(array_double_1d work);
static OUT_OF_LINE int64_t deep_points__is_listed(array_double_1d work, double x);
static OUT_OF_LINE int64_t deep_points__deepest_entry(array_double_1d work);
static OUT_OF_LINE int64_t deep_points__shallowest_entry(array_double_1d work);
static OUT_OF_LINE int64_t deep_points__keep_deepest(array_double_1d work);
static OUT_OF_LINE int64_t deep_points__remove_point(array_double_1d work, int64_t entry);
static OUT_OF_LINE int64_t deep_points__drop_point(array_double_1d work, int64_t entry);
static OUT_OF_LINE int64_t deep_points__merge_points(array_double_1d work);

#endif
