/* Generated from tangent_stick_zone.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of stick_zone.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_STICK_ZONE_H
#define WRCONTACT_KERNEL_TANGENT_STICK_ZONE_H

#include "../native/spans.h"
#include "layout.h"
#include "stick_zone.h"
#include "tangent_rates.h"

static inline int64_t tangent_stick_zone__spread_square_t(double* result_0, double* result_1, array_double_1d work, array_double_1d work_t, int64_t march, double scale, double scale_t, double k, double k_t, double ratio, double ratio_t);
static inline int64_t tangent_stick_zone__smooth_step_t(double* value, double* value_t, double z, double z_t);
static inline int64_t tangent_stick_zone__slip_depth_t(double* depth, double* depth_t, double* weight, double* weight_t, double square, double square_t, double v, double v_t, double k, double k_t, double a, double a_t);
static inline int64_t tangent_stick_zone__later_share_t(double* share, double* share_t, double depth, double depth_t, double ratio, double ratio_t);
static inline int64_t tangent_stick_zone__edge_weight_t(double* weight, double* weight_t, array_double_1d work, array_double_1d work_t, int64_t march);
static inline int64_t tangent_stick_zone__find_stick_zone_t(array_double_1d work, array_double_1d work_t, int64_t march, double width, double width_t, double ratio, double ratio_t);

#endif
