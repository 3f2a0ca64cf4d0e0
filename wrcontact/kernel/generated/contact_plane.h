/* Generated from contact/contact_plane.py by tools/transpile_kernel.py; change that one.
 *
 * The geometry that a normal contact model needs, in the plane of the rigid contact point.
 *
 * Station s runs along the contact plane to the field side, from the contact point; heights n are measured along the
 * plane's normal, from rail to wheel.  The outline of the wheel (:mod:`locus`) and the rail profile are both read as
 * n(s): the profile abscissa that projects on s is found by Newton's method from the previous station, and the last
 * residual is removed by the curve's own slope and bend, which leaves an error of third order in a small residual.
 */

#ifndef WRCONTACT_KERNEL_CONTACT_PLANE_H
#define WRCONTACT_KERNEL_CONTACT_PLANE_H

#include "../native/spans.h"
#include "gap.h"
#include "layout.h"
#include "locus.h"
#include "profile_table.h"

static const int64_t contact_plane__AT_PLANE = INT64_C(2280);
static const int64_t contact_plane__AT_WHEEL_PLANE = INT64_C(2285);
static const int64_t contact_plane__TRACER_RAIL = INT64_C(2288);
static const int64_t contact_plane__TRACER_WHEEL = INT64_C(2291);
static const double contact_plane__NO_GAP = 1.0;
static const double contact_plane__NEAR = 0.001;
static const int64_t contact_plane__TRACE_ITERATIONS = INT64_C(30);
static const double contact_plane__CURVATURE_FLOOR = 0.05;

static inline int64_t contact_plane__start_tracer(array_double_1d work, double station, double abscissa, double y);
static inline int64_t contact_plane__open_frame(double* z, double* slope, double* y_track, double* rail_slope, double* mismatch, array_double_1d tables, array_double_1d work, int64_t at, double y, double aside, double shift);
static inline double contact_plane__longitudinal_curvature(array_double_1d tables, array_double_1d place, int64_t at, double z, double slope, double bend);
static inline double contact_plane__first_abscissa(array_double_1d work, int64_t tracer, double away);
static inline int64_t contact_plane__trace_profile(double* result_0, double* result_1, double* turn, double* slope, double* height, int64_t* exists, array_double_1d tables, array_double_1d work, int64_t profile, int64_t tracer, int64_t frame, double station, double tolerance, double origin, double height_there);
static inline int64_t contact_plane__trace_rail(double* ordinate, double* rate, double* bend, int64_t* exists, array_double_1d tables, array_double_1d work, double station, double tolerance);
static inline int64_t contact_plane__trace_outline(double* result_0, double* result_1, double* turn, double* curvature, int64_t* exists, array_double_1d tables, array_double_1d work, int64_t at, double station, double tolerance);
static inline int64_t contact_plane__trace_wheel(double* ordinate, double* rate, double* bend, double* curvature, int64_t* exists, array_double_1d tables, array_double_1d work, double station, double tolerance);
static inline int64_t contact_plane__normal_gap(double* gap, double* result_1, double* result_2, double* curvature, array_double_1d tables, array_double_1d work, array_double_1d state, double station, double tolerance);
static inline int64_t contact_plane__is_yawed(array_double_1d work);
static inline double contact_plane__ridge_place(array_double_1d tables, array_double_1d work, double y);

#endif
