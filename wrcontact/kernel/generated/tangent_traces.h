/* Generated from tangent_traces.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of traces.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_TRACES_H
#define WRCONTACT_KERNEL_TANGENT_TRACES_H

#include "../native/spans.h"
#include "layout.h"
#include "tangent_locus.h"
#include "tangent_longitudinal_curvature.h"
#include "tangent_profile_table.h"
#include "traces.h"

static inline int64_t tangent_traces__start_traces_t(array_double_1d work, array_double_1d work_t, double station, double station_t, double abscissa, double abscissa_t, double y, double y_t);
static inline int64_t tangent_traces__first_abscissa_t(double* u, double* u_t, array_double_1d work, array_double_1d work_t, int64_t trace, double away, double away_t);
static inline int64_t tangent_traces__trace_profile_t(double* result_0, double* result_1, double* result_2, double* result_3, double* ordinate_bend, double* ordinate_bend_t, double* result_6, double* result_7, double* result_8, double* result_9, int64_t* exists, array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t profile, int64_t point, int64_t plane, int64_t trace, double station, double station_t, double tolerance, double tolerance_t);
static inline int64_t tangent_traces__trace_rail_t(double* ordinate, double* ordinate_t, double* rate, double* rate_t, double* bend, double* bend_t, int64_t* exists, array_double_1d work, array_double_1d work_t, array_double_1d tables, double station, double station_t, double tolerance, double tolerance_t);
static inline int64_t tangent_traces__trace_outline_t(double* ordinate, double* ordinate_t, double* result_2, double* result_3, double* ordinate_bend, double* ordinate_bend_t, double* curvature, double* curvature_t, int64_t* exists, array_double_1d work, array_double_1d work_t, array_double_1d tables, double station, double station_t, double tolerance, double tolerance_t);
static inline int64_t tangent_traces__trace_wheel_t(double* ordinate, double* ordinate_t, double* rate, double* rate_t, double* bend, double* bend_t, double* curvature, double* curvature_t, int64_t* exists, array_double_1d work, array_double_1d work_t, array_double_1d tables, double station, double station_t, double tolerance, double tolerance_t);

#endif
