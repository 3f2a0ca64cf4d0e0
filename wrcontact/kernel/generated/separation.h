/* Generated from contact/separation.py by tools/transpile_kernel.py; change that one.
 *
 * The undeformed distance over a region's stations, measured in one of four ways.
 *
 * normal        along the normal of the contact plane, :mod:`contact_plane`; of a pressed wheel, along the rail's, :mod:`pressed`;
 * vertical      at common lateral track coordinate: station s stands for y = y_0 + s cos(plane's angle);
 * equidistant   between the points at arc length s from the region's minimum on both curves, along the mean of their normals;
 * chord         likewise, with points that a circle of radius h around the one before cuts out of the curve (the source).
 *
 * Except for the first, the wheel is moved so that its point at the region's minimum lies on the rail's, and the smallest gap
 * is added again: each region is a contact of its own, and only differences of coordinates count, not where the wheelset is.
 * The wheel's curve is its outline (:mod:`locus`); without yaw that is the profile, turned by the roll.
 */

#ifndef WRCONTACT_KERNEL_SEPARATION_H
#define WRCONTACT_KERNEL_SEPARATION_H

#include "../native/spans.h"
#include "contact_plane.h"
#include "layout.h"
#include "locus.h"
#include "pressed.h"
#include "profile_table.h"

static const int64_t separation__AT_RAIL_ORIGIN = INT64_C(47075);
static const int64_t separation__AT_WHEEL_ORIGIN = INT64_C(47077);
static const double separation__SHARP = 1e-13;
static const int64_t separation__ITERATIONS = INT64_C(40);
static const double separation__GAUSS_1 = 0.2386191860831969;
static const double separation__GAUSS_2 = 0.6612093864662645;
static const double separation__GAUSS_3 = 0.932469514203152;
static const double separation__WEIGHT_1 = 0.467913934572691;
static const double separation__WEIGHT_2 = 0.3607615730481386;
static const double separation__WEIGHT_3 = 0.1713244923791704;

static OUT_OF_LINE int64_t separation__curve_profile(array_double_1d tables, int64_t tracer);
static OUT_OF_LINE int64_t separation__curve_jet(double* across, double* down, double* slope, double* stretch, double* bend, array_double_1d tables, array_double_1d work, int64_t tracer, double u);
static OUT_OF_LINE double separation__curve_speed(array_double_1d tables, array_double_1d work, int64_t tracer, double u);
static OUT_OF_LINE double separation__panel_length(array_double_1d tables, array_double_1d work, int64_t tracer, double low, double high);
static OUT_OF_LINE double separation__arc_length(array_double_1d tables, array_double_1d work, int64_t tracer, double start, double stop);
static OUT_OF_LINE double separation__within(array_double_1d tables, int64_t tracer, double u);
static OUT_OF_LINE int64_t separation__open_curve(array_double_1d tables, array_double_1d work, int64_t tracer, int64_t origin, double u);
static OUT_OF_LINE int64_t separation__open_origin(array_double_1d tables, array_double_1d work, double station, double gap, double abscissa, double y, double spacing);
static OUT_OF_LINE int64_t separation__move_arc(array_double_1d tables, array_double_1d work, int64_t tracer, double length);
static OUT_OF_LINE int64_t separation__move_chord(array_double_1d tables, array_double_1d work, int64_t tracer, double chord);
static OUT_OF_LINE int64_t separation__move_station(array_double_1d tables, array_double_1d work, int64_t tracer, double station);
static OUT_OF_LINE int64_t separation__move_across(array_double_1d tables, array_double_1d work, double lateral);
static OUT_OF_LINE int64_t separation__vertical_rise(double* result_0, double* result_1, double* result_2, int64_t* exists, array_double_1d tables, array_double_1d work, double station);
static OUT_OF_LINE int64_t separation__equidistant_rise(double* result_0, double* rate, double* result_2, int64_t* exists, array_double_1d tables, array_double_1d work, double station);
static OUT_OF_LINE int64_t separation__lean_away(double* result_0, double* result_1, array_double_1d tables, array_double_1d work);
static OUT_OF_LINE int64_t separation__moved_separation(double* gap, double* rate, double* bend, double* curvature, array_double_1d tables, array_double_1d work, array_double_1d state, double station, int64_t kind);
static inline int64_t separation__separation(double* gap, double* rate, double* bend, double* curvature, array_double_1d tables, array_double_1d work, array_double_1d state, double station, double tolerance);

#endif
