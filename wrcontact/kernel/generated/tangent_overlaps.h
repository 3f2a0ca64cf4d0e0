/* Generated from tangent_overlaps.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of overlaps.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_OVERLAPS_H
#define WRCONTACT_KERNEL_TANGENT_OVERLAPS_H

#include "../native/spans.h"
#include "layout.h"
#include "overlaps.h"
#include "pressed.h"
#include "tangent_pressed.h"

static inline int64_t tangent_overlaps__turning_rule_t(double* found_x, double* found_x_t, double* result_2, double* result_3, double* overlap, double* overlap_t, int64_t* found, array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t place, double x, double x_t, double y, double y_t, double height, double height_t);
static inline int64_t tangent_overlaps__overlaps_rule_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t side, array_double_1d state, double height, double height_t);

#endif
