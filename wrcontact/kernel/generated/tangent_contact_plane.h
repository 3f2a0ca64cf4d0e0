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
#include "tangent_traces.h"

static inline int64_t tangent_contact_plane__open_frame_t(double* z, double* z_t, double* slope, double* slope_t, double* y_track, double* y_track_t, double* rail_slope, double* rail_slope_t, double* mismatch, double* mismatch_t, array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t place, double y, double y_t, double aside, double aside_t, double shift, double shift_t);
static inline int64_t tangent_contact_plane__normal_gap_t(double* gap, double* gap_t, double* result_2, double* result_3, double* result_4, double* result_5, double* curvature, double* curvature_t, array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, double station, double station_t, double tolerance, double tolerance_t);

#endif
