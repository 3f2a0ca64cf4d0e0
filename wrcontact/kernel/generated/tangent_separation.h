/* Generated from tangent_separation.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of separation.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_SEPARATION_H
#define WRCONTACT_KERNEL_TANGENT_SEPARATION_H

#include "../native/spans.h"
#include "contact_plane.h"
#include "curves.h"
#include "layout.h"
#include "tangent_contact_plane.h"
#include "tangent_curves.h"
#include "tangent_longitudinal_curvature.h"
#include "tangent_moves.h"
#include "tangent_pressed.h"
#include "tangent_profile_table.h"
#include "tangent_rates.h"

static inline int64_t tangent_separation__vertical_rise_t(double* result_0, double* result_1, double* result_2, double* result_3, double* result_4, double* result_5, int64_t* exists, array_double_1d work, array_double_1d work_t, array_double_1d tables, double station, double station_t);
static inline int64_t tangent_separation__equidistant_rise_t(double* result_0, double* result_1, double* rate, double* rate_t, double* result_4, double* result_5, int64_t* exists, array_double_1d work, array_double_1d work_t, array_double_1d tables, double station, double station_t);
static inline int64_t tangent_separation__depth_lost_t(double* result_0, double* result_1, double* result_2, double* result_3, array_double_1d work, array_double_1d work_t, array_double_1d tables);
static inline int64_t tangent_separation__moved_separation_t(double* gap, double* gap_t, double* rate, double* rate_t, double* bend, double* bend_t, double* curvature, double* curvature_t, array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, double station, double station_t, int64_t kind);
static inline int64_t tangent_separation__separation_t(double* gap, double* gap_t, double* rate, double* rate_t, double* bend, double* bend_t, double* curvature, double* curvature_t, array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, double station, double station_t, double tolerance, double tolerance_t);

#endif
