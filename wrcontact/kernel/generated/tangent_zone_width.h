/* Generated from tangent_zone_width.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of zone_width.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_ZONE_WIDTH_H
#define WRCONTACT_KERNEL_TANGENT_ZONE_WIDTH_H

#include "../native/spans.h"
#include "contact_plane.h"
#include "layout.h"
#include "tangent_curves.h"
#include "tangent_rates.h"
#include "tangent_separation.h"
#include "tangent_traces.h"
#include "zone_width.h"

static inline int64_t tangent_zone_width__width_limit_t(double* limit, double* limit_t, array_double_1d work, array_double_1d work_t, int64_t region, double direction, double direction_t);
static inline int64_t tangent_zone_width__width_tolerance_t(double* tolerance, double* tolerance_t, double estimate, double estimate_t);
static inline int64_t tangent_zone_width__zone_width_t(double* result_0_0001, double* result_1_0001, array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t region, array_double_1d state, double direction, double direction_t, double level, double level_t, double estimate, double estimate_t);
static inline int64_t tangent_zone_width__width_jet_t(double* gap, double* gap_t, double* rate, double* rate_t, array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t region, array_double_1d state, double direction, double direction_t, double width, double width_t, double tolerance, double tolerance_t);
static inline int64_t tangent_zone_width__width_rule_t(double* width, double* width_t, array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t region, array_double_1d state, double direction, double direction_t, double level, double level_t, double estimate, double estimate_t);

#endif
