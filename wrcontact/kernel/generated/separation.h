/* Generated from contact/separation.py by tools/transpile_kernel.py; change that one.
 *
 * The undeformed distance over a region's stations, measured in one of four ways.
 *
 * normal        along the normal of the contact plane, :mod:`contact_plane`; of a pressed wheel, along the
 *               rail's, :mod:`pressed`;
 * vertical      at common lateral track coordinate: station s stands for y = y_0 + s cos(plane's angle);
 * equidistant   between the points at arc length s from the region's minimum on both curves, along the mean of
 *               their normals;
 * chord         likewise, with points that a circle of radius h around the one before cuts out of the curve (the
 *               source).
 *
 * Except for the first, the wheel is moved so that its point at the region's minimum lies on the rail's, and the
 * smallest gap is added again: each region is a contact of its own, and only differences of coordinates count,
 * not where the wheelset is.
 */

#ifndef WRCONTACT_KERNEL_SEPARATION_H
#define WRCONTACT_KERNEL_SEPARATION_H

#include "../native/spans.h"
#include "contact_plane.h"
#include "curves.h"
#include "layout.h"
#include "longitudinal_curvature.h"
#include "moves.h"
#include "pressed.h"
#include "profile_table.h"

static OUT_OF_LINE int64_t separation__vertical_rise(double* result_0, double* result_1, double* result_2, int64_t* exists, array_double_1d work, array_double_1d tables, double station);
static OUT_OF_LINE int64_t separation__equidistant_rise(double* result_0, double* rate, double* result_2, int64_t* exists, array_double_1d work, array_double_1d tables, double station);
static OUT_OF_LINE int64_t separation__depth_lost(double* result_0, double* result_1, array_double_1d work, array_double_1d tables);
static OUT_OF_LINE int64_t separation__moved_separation(double* gap, double* rate, double* bend, double* curvature, array_double_1d work, array_double_1d tables, array_double_1d state, double station, int64_t kind);
static inline int64_t separation__separation(double* gap, double* rate, double* bend, double* curvature, array_double_1d work, array_double_1d tables, array_double_1d state, double station, double tolerance);

#endif
