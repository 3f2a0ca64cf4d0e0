/* Generated from tangent_correction.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of correction.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_CORRECTION_H
#define WRCONTACT_KERNEL_TANGENT_CORRECTION_H

#include "../native/spans.h"
#include "correction.h"
#include "layout.h"
#include "tangent_rates.h"
#include "tangent_shapes.h"
#include "tangent_table_cell.h"
#include "tangent_tractions.h"

static inline int64_t tangent_correction__scale_at_t(double* result_0, double* result_1, array_double_1d tables, int64_t table, int64_t at, double share, double share_t);
static inline int64_t tangent_correction__saturation_t(double* result_0, double* result_1, double* result_2, double* result_3, double* result_4, double* result_5, array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t rolling, int64_t cell, double share, double share_t);
static inline int64_t tangent_correction__radius_cell_t(int64_t* cell, double* result_1, double* result_2, array_double_1d tables, int64_t table, double place, double place_t);
static inline int64_t tangent_correction__node_at_t(int64_t* at, double* on_elevation, double* on_elevation_t, double* on_azimuth, double* on_azimuth_t, double* on_radius, double* on_radius_t, array_double_1d tables, int64_t table, double along, double along_t, double across, double across_t, double turning, double turning_t);
static inline int64_t tangent_correction__on_line_t(double* result_0, double* result_1, array_double_1d tables, int64_t table, int64_t at, double on_radius, double on_radius_t);
static inline int64_t tangent_correction__on_cone_t(double* result_0, double* result_1, array_double_1d tables, int64_t table, int64_t at, double on_azimuth, double on_azimuth_t, double on_radius, double on_radius_t);
static inline int64_t tangent_correction__on_plane_t(double* result_0, double* result_1, array_double_1d tables, int64_t table, int64_t at, double on_elevation, double on_elevation_t, double on_azimuth, double on_azimuth_t, double on_radius, double on_radius_t);
static inline int64_t tangent_correction__missing_t(double* result_0, double* result_1, array_double_1d tables, int64_t table, int64_t at, double on_ratio, double on_ratio_t, double on_elevation, double on_elevation_t, double on_azimuth, double on_azimuth_t, double on_radius, double on_radius_t);
static inline int64_t tangent_correction__correct_force_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t rolling);

#endif
