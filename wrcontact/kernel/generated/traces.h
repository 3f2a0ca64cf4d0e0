/* Generated from contact/traces.py by tools/transpile_kernel.py; change that one.
 *
 * Wheel and rail as heights over the contact plane, traced from station to station.
 *
 * Station s runs along the contact plane to the field side, from the contact point; heights n are measured along
 * the plane's normal, from rail to wheel.  The outline of the wheel (:mod:`locus`) and the rail profile are both
 * read as n(s): the profile abscissa that projects on s is found by Newton's method from the previous station,
 * and the last residual is removed by the curve's own slope and bend, which leaves an error of third order in a
 * small residual.
 */

#ifndef WRCONTACT_KERNEL_TRACES_H
#define WRCONTACT_KERNEL_TRACES_H

#include "../native/spans.h"
#include "layout.h"
#include "locus.h"
#include "longitudinal_curvature.h"
#include "profile_table.h"

static const double traces__EXTRAPOLATED = 0.004;
static const int64_t traces__TRACE_ITERATIONS = INT64_C(30);

static inline int64_t traces__start_traces(array_double_1d work, double station, double abscissa, double y);
static inline double traces__first_abscissa(array_double_1d work, int64_t trace, double away);
static inline int64_t traces__trace_profile(double* result_0, double* result_1, double* ordinate_bend, double* result_3, double* result_4, int64_t* exists, array_double_1d tables, array_double_1d work, int64_t profile, int64_t point, int64_t plane, int64_t trace, double station, double tolerance);
static inline int64_t traces__trace_rail(double* ordinate, double* rate, double* bend, int64_t* exists, array_double_1d work, array_double_1d tables, double station, double tolerance);
static inline int64_t traces__trace_outline(double* ordinate, double* result_1, double* ordinate_bend, double* curvature, int64_t* exists, array_double_1d work, array_double_1d tables, double station, double tolerance);
static inline int64_t traces__trace_wheel(double* ordinate, double* rate, double* bend, double* curvature, int64_t* exists, array_double_1d work, array_double_1d tables, double station, double tolerance);

#endif
