/* Generated from tangent_pressed.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of pressed.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_PRESSED_H
#define WRCONTACT_KERNEL_TANGENT_PRESSED_H

#include "../native/spans.h"
#include "contact_plane.h"
#include "layout.h"
#include "pressed.h"
#include "tangent_arc_length.h"
#include "tangent_locus.h"
#include "tangent_longitudinal_curvature.h"
#include "tangent_profile_table.h"
#include "tangent_rates.h"

static inline int64_t tangent_pressed__meet_wheel_t(double* result_0_0001, double* result_1_0001, double* result_2, double* result_3, double* result_4, double* result_5, double* result_6_0001, double* result_7_0001, double* result_8, double* result_9, double* result_10, double* result_11, double* result_12, double* result_13, int64_t* result_14_0001, array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t place, double abscissa, double abscissa_t, double y, double y_t, double height, double height_t, double tolerance, double tolerance_t);
static inline int64_t tangent_pressed__meet_rule_t(double* result_0, double* result_1, double* overlap, double* overlap_t, double* rise, double* rise_t, double* rate, double* rate_t, double* z, double* z_t, double* slope, double* slope_t, double* bend, double* bend_t, int64_t* found, array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t place, double abscissa, double abscissa_t, double y, double y_t, double height, double height_t, double tolerance, double tolerance_t);
static inline int64_t tangent_pressed__mean_bend_t(double* result_0, double* result_1, array_double_1d work, array_double_1d work_t, array_double_1d tables, double y, double y_t, double bend, double bend_t);
static inline int64_t tangent_pressed__normal_line_t(double* result_0, double* result_1, double* overlap, double* overlap_t, double* rise, double* rise_t, double* rate, double* rate_t, double* curvature, double* curvature_t, int64_t* found, array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t place, double abscissa, double abscissa_t, double y, double y_t, double height, double height_t, double tolerance, double tolerance_t);
static inline int64_t tangent_pressed__pressed_gap_t(double* gap, double* gap_t, double* rate, double* rate_t, double* bend, double* bend_t, double* curvature, double* curvature_t, array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, double station, double station_t);

#endif
