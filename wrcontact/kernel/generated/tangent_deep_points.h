/* Generated from tangent_deep_points.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of deep_points.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_DEEP_POINTS_H
#define WRCONTACT_KERNEL_TANGENT_DEEP_POINTS_H

#include "../native/spans.h"
#include "deep_points.h"
#include "layout.h"

static inline int64_t tangent_deep_points__copy_point_t(array_double_1d work, array_double_1d work_t, int64_t point, int64_t copy);
static inline int64_t tangent_deep_points__keep_deepest_t(array_double_1d work, array_double_1d work_t);

#endif
