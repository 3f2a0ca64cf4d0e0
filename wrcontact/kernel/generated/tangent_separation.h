/* Generated from tangent_separation.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of separation.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_SEPARATION_H
#define WRCONTACT_KERNEL_TANGENT_SEPARATION_H

#include "../native/spans.h"
#include "contact_plane.h"
#include "layout.h"
#include "profile_table.h"
#include "separation.h"
#include "tangent_contact_plane.h"
#include "tangent_locus.h"
#include "tangent_pressed.h"
#include "tangent_profile_table.h"
#include "tangent_rates.h"

static inline int64_t tangent_separation__curve_jet_t(double* across, double* across_t, double* down, double* down_t, double* slope, double* slope_t, double* stretch, double* stretch_t, double* bend, double* bend_t, array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t tracer, double u, double u_t);
static inline int64_t tangent_separation__curve_speed_t(double* speed, double* speed_t, array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t tracer, double u, double u_t);
static inline int64_t tangent_separation__panel_length_t(double* result_0, double* result_1, array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t tracer, double low, double low_t, double high, double high_t);
static inline int64_t tangent_separation__arc_length_t(double* total, double* total_t, array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t tracer, double start, double start_t, double stop, double stop_t);
static inline int64_t tangent_separation__within_t(double* result_0, double* result_1, array_double_1d tables, int64_t tracer, double u, double u_t);
static inline int64_t tangent_separation__open_curve_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t tracer, int64_t origin, double u, double u_t);
static inline int64_t tangent_separation__open_origin_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, double station, double station_t, double gap, double gap_t, double abscissa, double abscissa_t, double y, double y_t, double spacing, double spacing_t);
static inline int64_t tangent_separation__arc_rule_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t tracer, double length, double length_t);
static inline int64_t tangent_separation__chord_rule_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t tracer, double chord, double chord_t);
static inline int64_t tangent_separation__move_station_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t tracer, double station, double station_t);
static inline int64_t tangent_separation__across_rule_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, double lateral, double lateral_t);
static inline int64_t tangent_separation__vertical_rise_t(double* result_0, double* result_1, double* result_2, double* result_3, double* result_4, double* result_5, int64_t* exists, array_double_1d tables, array_double_1d work, array_double_1d work_t, double station, double station_t);
static inline int64_t tangent_separation__equidistant_rise_t(double* result_0, double* result_1, double* rate, double* rate_t, double* result_4, double* result_5, int64_t* exists, array_double_1d tables, array_double_1d work, array_double_1d work_t, double station, double station_t);
static inline int64_t tangent_separation__lean_away_t(double* result_0, double* result_1, double* result_2, double* result_3, array_double_1d tables, array_double_1d work, array_double_1d work_t);
static inline int64_t tangent_separation__moved_separation_t(double* gap, double* gap_t, double* rate, double* rate_t, double* bend, double* bend_t, double* curvature, double* curvature_t, array_double_1d tables, array_double_1d work, array_double_1d work_t, array_double_1d state, double station, double station_t, int64_t kind);
static inline int64_t tangent_separation__separation_t(double* gap, double* gap_t, double* rate, double* rate_t, double* bend, double* bend_t, double* curvature, double* curvature_t, array_double_1d tables, array_double_1d work, array_double_1d work_t, array_double_1d state, double station, double station_t, double tolerance, double tolerance_t);

#endif
