/* Generated from tangent_locus.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of locus.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_LOCUS_H
#define WRCONTACT_KERNEL_TANGENT_LOCUS_H

#include "../native/spans.h"
#include "layout.h"
#include "tangent_profile_table.h"
#include "tangent_rates.h"

static inline int64_t tangent_locus__set_roll_t(array_double_1d work, array_double_1d work_t, int64_t place, double sin_roll, double sin_roll_t, double cos_roll, double cos_roll_t);
static inline int64_t tangent_locus__turn_wheelset_t(array_double_1d work, array_double_1d work_t, int64_t place, double roll, double roll_t);
static inline int64_t tangent_locus__place_wheelset_t(array_double_1d work, array_double_1d work_t, int64_t place, double lateral_shift, double lateral_shift_t, double yaw, double yaw_t, double roll, double roll_t, double radius, double radius_t, double height, double height_t, double arm, double arm_t);
static inline int64_t tangent_locus__mirror_roll_t(array_double_1d work, array_double_1d work_t, int64_t place, int64_t mirrored);
static inline int64_t tangent_locus__mirror_place_t(array_double_1d work, array_double_1d work_t, int64_t place, int64_t mirrored, double radius, double radius_t);
static inline int64_t tangent_locus__around_wheel_t(double* result_0, double* result_1, double* result_2, double* result_3, array_double_1d work, array_double_1d work_t, int64_t place, double slope, double slope_t);
static inline int64_t tangent_locus__outline_point_t(double* y_track, double* y_track_t, double* z_track, double* z_track_t, double* outline_slope, double* outline_slope_t, array_double_1d work, array_double_1d work_t, int64_t place, double y, double y_t, double z, double z_t, double slope, double slope_t);
static inline int64_t tangent_locus__outline_jet_t(double* y_track, double* y_track_t, double* z_track, double* z_track_t, double* outline_slope, double* outline_slope_t, double* stretch, double* stretch_t, double* slope_rate, double* slope_rate_t, array_double_1d work, array_double_1d work_t, int64_t place, double y, double y_t, double z, double z_t, double slope, double slope_t, double bend, double bend_t);
static inline int64_t tangent_locus__outline_x_t(double* result_0, double* result_1, array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t place, double y, double y_t);

#endif
