/* Generated from contact/touching.py by tools/transpile_kernel.py; change that one.
 *
 * Pairs of points of wheel and rail with a common normal: where the overlap of a pressed wheel is largest, or
 * smallest between two largest ones.
 *
 * They are found by a bracket on the rail, with Newton's method inside it, also where curvatures jump.  In a
 * pair the outline and the rail have one slope m and the line between both points is normal to them,
 *
 *     m_wheel(y) = m_rail(x),   X - x + (Z - z_rail(x)) m = 0,
 *     depth = (Z - z_rail - m (X - x)) / sqrt(1 + m^2)
 *
 * with (X, Z) the wheel's point at abscissa y in its present pose.
 */

#ifndef WRCONTACT_KERNEL_TOUCHING_H
#define WRCONTACT_KERNEL_TOUCHING_H

#include "../native/spans.h"
#include "layout.h"
#include "pressed.h"
#include "profile_table.h"

static const double touching__DEEP_SHARP = 1e-13;
static const int64_t touching__DEEP_ITERATIONS = INT64_C(60);
static const double touching__LEVEL_RISE = 0.0001;
static const double touching__ZERO_RISE = 1e-09;

static OUT_OF_LINE double touching__limited(double step, double limit);
static OUT_OF_LINE int64_t touching__turning_point(double* result_0, double* result_1_0001, double* result_2, int64_t* result_3, array_double_1d work, array_double_1d tables, int64_t place, double low, double high, double y, double height, double sign);

#endif
