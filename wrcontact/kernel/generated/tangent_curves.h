/* Generated from tangent_curves.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of curves.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_CURVES_H
#define WRCONTACT_KERNEL_TANGENT_CURVES_H

#include "../native/spans.h"
#include "curves.h"
#include "layout.h"
#include "tangent_locus.h"
#include "tangent_profile_table.h"
#include "tangent_rates.h"

static inline int64_t tangent_curves__curve_jet_t(double* across, double* across_t, double* down, double* down_t, double* slope, double* slope_t, double* stretch, double* stretch_t, double* bend, double* bend_t, array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t curve, double u, double u_t);
static inline int64_t tangent_curves__curve_speed_t(double* speed, double* speed_t, array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t curve, double u, double u_t);
static inline int64_t tangent_curves__within_t(double* result_0, double* result_1, array_double_1d tables, int64_t curve, double u, double u_t);
static inline int64_t tangent_curves__open_curve_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t curve, double u, double u_t);
static inline int64_t tangent_curves__open_origin_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t region, double spacing, double spacing_t);

#endif
