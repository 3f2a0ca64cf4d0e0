/* Generated from contact/touching.py by tools/transpile_kernel.py; change that one.
 *
 * Pairs of points of wheel and rail with a common normal, found in two ways for two purposes.
 *
 * touching_pair   by Newton's method for both abscissae at once, from a good estimate: where a wheel that
 *                 overlaps its rail a little, or is above it, would touch. Wheel and rail have to be bent
 *                 towards each other.
 * turning_point   by a bracket on the rail, with Newton's method inside it: where the overlap of a pressed wheel
 *                 is largest, or smallest between two largest ones. It finds one also where curvatures jump.
 *
 * An elastic contact is a rigid one that has been pressed: the wheel is ``depth`` deeper than where it just
 * touches. In a pair the outline and the rail have one slope m and the line between both points is normal to
 * them,
 *
 *     m_wheel(y) = m_rail(x),   X - x + (Z - z_rail(x)) m = 0,
 *     depth = (Z - z_rail - m (X - x)) / sqrt(1 + m^2)
 *
 * with (X, Z) the wheel's point at abscissa y in its present pose. Without overlap it is the point of the
 * smallest vertical gap.
 */

#ifndef WRCONTACT_KERNEL_TOUCHING_H
#define WRCONTACT_KERNEL_TOUCHING_H

#include "../native/spans.h"
#include "layout.h"
#include "locus.h"
#include "pressed.h"
#include "profile_table.h"

static const double touching__PAIR_SHARP = 1e-12;
static const int64_t touching__PAIR_ITERATIONS = INT64_C(25);
static const double touching__PAIR_STEP = 0.0005;
static const double touching__PAIR_REACH = 0.004;
static const double touching__PAIR_BEND = 0.001;
static const double touching__DEEP_SHARP = 1e-13;
static const int64_t touching__DEEP_ITERATIONS = INT64_C(60);
static const double touching__LEVEL_RISE = 0.0001;

static OUT_OF_LINE double touching__limited(double step, double limit);
static OUT_OF_LINE int64_t touching__touching_pair(double* result_0_0001, double* result_1_0001, double* result_2, double* result_3_0001, double* result_4_0001, int64_t* result_5_0001, array_double_1d work, array_double_1d tables, int64_t place, double y, double abscissa, double shift);
static OUT_OF_LINE int64_t touching__turning_point(double* result_0, double* result_1_0001, double* result_2, int64_t* result_3, array_double_1d work, array_double_1d tables, int64_t place, double low, double high, double y, double height, double sign);

#endif
