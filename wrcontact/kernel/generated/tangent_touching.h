/* Generated from tangent_touching.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of touching.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_TOUCHING_H
#define WRCONTACT_KERNEL_TANGENT_TOUCHING_H

#include "../native/spans.h"
#include "layout.h"
#include "pressed.h"
#include "tangent_pressed.h"
#include "tangent_profile_table.h"
#include "tangent_rates.h"
#include "touching.h"

static inline int64_t tangent_touching__limited_t(double* result_0, double* result_1, double step, double step_t, double limit, double limit_t);
static inline int64_t tangent_touching__turning_point_t(double* result_0, double* result_1, double* result_2_0001, double* result_3_0001, double* result_4, double* result_5, int64_t* result_6, array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t place, double low, double low_t, double high, double high_t, double y, double y_t, double height, double height_t, double sign, double sign_t);

#endif
