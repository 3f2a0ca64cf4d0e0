/* Generated from tangent_outline.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of outline.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_OUTLINE_H
#define WRCONTACT_KERNEL_TANGENT_OUTLINE_H

#include "../native/spans.h"
#include "layout.h"
#include "outline.h"
#include "tangent_interpolation.h"

static inline int64_t tangent_outline__fill_outline_t(array_double_1d work, array_double_1d work_t, int64_t outline, int64_t stations, double value, double value_t);
static inline int64_t tangent_outline__write_ellipse_t(array_double_1d work, array_double_1d work_t, int64_t outline, int64_t stations, int64_t totals);
static inline int64_t tangent_outline__write_quadratic_t(array_double_1d work, array_double_1d work_t, int64_t outline, int64_t stations, int64_t count);
static inline int64_t tangent_outline__write_straight_t(array_double_1d work, array_double_1d work_t, int64_t outline, int64_t stations);
static inline int64_t tangent_outline__write_outline_t(array_double_1d work, array_double_1d work_t, int64_t outline, int64_t stations, int64_t count);

#endif
