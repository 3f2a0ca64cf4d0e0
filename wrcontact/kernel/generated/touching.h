/* Generated from contact/touching.py by tools/transpile_kernel.py; change that one.
 *
 * Where a wheel that overlaps its rail would touch it, if it were drawn back along their common normal.
 *
 * An elastic contact is a rigid one that has been pressed: the wheel stands ``depth`` deeper than where it just touches.  The
 * pair of points is found where the outline and the rail have one slope m and the line between them is normal to both,
 *
 *     m_wheel(y) = m_rail(x),   X - x + (Z - z_rail(x)) m = 0,   depth = (Z - z_rail - m (X - x)) / sqrt(1 + m^2)
 *
 * with (X, Z) the wheel's point at abscissa y as it stands.  Without overlap it is the point of the smallest vertical gap.
 */

#ifndef WRCONTACT_KERNEL_TOUCHING_H
#define WRCONTACT_KERNEL_TOUCHING_H

#include "../native/spans.h"
#include "layout.h"
#include "locus.h"
#include "profile_table.h"

static const double touching__PAIR_SHARP = 1e-12;
static const int64_t touching__PAIR_ITERATIONS = INT64_C(25);
static const double touching__PAIR_STEP = 0.0005;
static const double touching__PAIR_REACH = 0.004;
static const double touching__PAIR_BEND = 0.001;

static OUT_OF_LINE double touching__limited(double step, double limit);
static OUT_OF_LINE int64_t touching__touching_pair(double* result_0_0001, double* result_1_0001, double* result_2, double* result_3_0001, double* result_4_0001, int64_t* result_5_0001, array_double_1d tables, array_double_1d work, int64_t at, double y, double abscissa, double shift);

#endif
