/* Generated from tangent_followed_overlaps.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of followed_overlaps.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_FOLLOWED_OVERLAPS_H
#define WRCONTACT_KERNEL_TANGENT_FOLLOWED_OVERLAPS_H

#include "../native/spans.h"
#include "followed_overlaps.h"
#include "layout.h"
#include "tangent_deep_points.h"
#include "tangent_touching.h"

static inline int64_t tangent_followed_overlaps__keep_points_t(array_double_1d work, array_double_1d work_t, int64_t kept);
static inline int64_t tangent_followed_overlaps__follow_saddle_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t place, int64_t point, int64_t following, double height, double height_t);
static inline int64_t tangent_followed_overlaps__follow_overlaps_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t kept, int64_t place, double height, double height_t);

#endif
