/* Generated from contact/pressed.py by tools/transpile_kernel.py; change that one.
 *
 * The overlap of a wheel that is pressed into its rail, along the rail's own normals.
 *
 * A wheel that comes down meets every part of the rail along another normal.  Where a patch reaches around a
 * corner one plane cannot hold that; so the overlap o of a pressed wheel is measured along the normal of each
 * rail point x, to where that line meets the wheel's outline (Y, Z) as it stands,
 *
 *     Y - x + (Z - z_rail(x)) m = 0,   o = (Z - z_rail - m (Y - x)) / sqrt(1 + m^2),   m = z_rail'(x)
 *
 * and stations run along the rail, by its arc length.  With slope m_w of the outline there and kappa of the rail
 *
 *     do/ds = (m_w - m) / (1 + m m_w)
 *
 * but for a factor 1 - kappa o, below 1 % and left out: kappa jumps where profiles are joined, and a slope must
 * not.  The deepest point of a region is a pair of points with one normal, and o does not depend on where
 * stations begin.
 */

#ifndef WRCONTACT_KERNEL_PRESSED_H
#define WRCONTACT_KERNEL_PRESSED_H

#include "../native/spans.h"
#include "arc_length.h"
#include "contact_plane.h"
#include "layout.h"
#include "locus.h"
#include "longitudinal_curvature.h"
#include "profile_table.h"

static const double pressed__LINE_SHARP = 1e-08;
static const double pressed__NODE_SHARP = 1e-06;
static const double pressed__LINE_JOINT = 1e-07;
static const int64_t pressed__LINE_ITERATIONS = INT64_C(20);
static const double pressed__LINE_STEP = 0.004;
static const double pressed__FARTHEST = 0.005;
static const double pressed__LEAST_WAY = 1e-05;

static OUT_OF_LINE int64_t pressed__meet_wheel(double* result_0_0001, double* result_1, double* result_2, double* result_3_0001, double* result_4, double* result_5, double* result_6, int64_t* result_7_0001, array_double_1d work, array_double_1d tables, int64_t place, double abscissa, double y, double height, double tolerance);
static OUT_OF_LINE double pressed__mean_bend(array_double_1d work, array_double_1d tables, double y, double bend);
static OUT_OF_LINE int64_t pressed__normal_line(double* result_0, double* overlap, double* rise, double* rate, double* curvature, int64_t* found, array_double_1d work, array_double_1d tables, int64_t place, double abscissa, double y, double height, double tolerance);
static OUT_OF_LINE int64_t pressed__pressed_gap(double* gap, double* rate, double* bend, double* curvature, array_double_1d work, array_double_1d tables, array_double_1d state, double station);

#endif
