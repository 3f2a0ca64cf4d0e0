/* Generated from tangent_contact_plane.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of contact_plane.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_CONTACT_PLANE_H
#define WRCONTACT_KERNEL_TANGENT_CONTACT_PLANE_H

#include "../native/spans.h"
#include "contact_plane.h"
#include "gap.h"
#include "layout.h"
#include "tangent_locus.h"
#include "tangent_profile_table.h"
#include "tangent_rates.h"

static inline int64_t tangent_contact_plane__start_tracer_t(array_double_1d work, array_double_1d work_t, double station, double station_t, double abscissa, double abscissa_t, double y, double y_t);
static inline int64_t tangent_contact_plane__open_frame_t(double* z, double* z_t, double* slope, double* slope_t, double* y_track, double* y_track_t, double* rail_slope, double* rail_slope_t, double* mismatch, double* mismatch_t, array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t at, double y, double y_t, double aside, double aside_t, double shift, double shift_t);
static inline int64_t tangent_contact_plane__longitudinal_curvature_t(double* curvature, double* curvature_t, array_double_1d tables, array_double_1d place, array_double_1d place_t, int64_t at, double z, double z_t, double slope, double slope_t, double bend, double bend_t);
static inline int64_t tangent_contact_plane__first_abscissa_t(double* u, double* u_t, array_double_1d work, array_double_1d work_t, int64_t tracer, double away, double away_t);
static inline int64_t tangent_contact_plane__trace_profile_t(double* result_0, double* result_1, double* result_2, double* result_3, double* turn, double* turn_t, double* slope, double* slope_t, double* height, double* height_t, int64_t* exists, array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t profile, int64_t tracer, int64_t frame, double station, double station_t, double tolerance, double tolerance_t, double origin, double origin_t, double height_there, double height_there_t);
static inline int64_t tangent_contact_plane__trace_rail_t(double* ordinate, double* ordinate_t, double* rate, double* rate_t, double* bend, double* bend_t, int64_t* exists, array_double_1d tables, array_double_1d work, array_double_1d work_t, double station, double station_t, double tolerance, double tolerance_t);
static inline int64_t tangent_contact_plane__trace_outline_t(double* result_0, double* result_1, double* result_2, double* result_3, double* turn, double* turn_t, double* curvature, double* curvature_t, int64_t* exists, array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t at, double station, double station_t, double tolerance, double tolerance_t);
static inline int64_t tangent_contact_plane__trace_wheel_t(double* ordinate, double* ordinate_t, double* rate, double* rate_t, double* bend, double* bend_t, double* curvature, double* curvature_t, int64_t* exists, array_double_1d tables, array_double_1d work, array_double_1d work_t, double station, double station_t, double tolerance, double tolerance_t);
static inline int64_t tangent_contact_plane__normal_gap_t(double* gap, double* gap_t, double* result_2, double* result_3, double* result_4, double* result_5, double* curvature, double* curvature_t, array_double_1d tables, array_double_1d work, array_double_1d work_t, array_double_1d state, double station, double station_t, double tolerance, double tolerance_t);
static inline int64_t tangent_contact_plane__ridge_place_t(double* result_0, double* result_1, array_double_1d tables, array_double_1d work, array_double_1d work_t, double y, double y_t);

#endif
