/* Generated from tangent_creepage.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of creepage.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_CREEPAGE_H
#define WRCONTACT_KERNEL_TANGENT_CREEPAGE_H

#include "../native/spans.h"
#include "creepage.h"
#include "layout.h"
#include "tangent_rates.h"

static inline int64_t tangent_creepage__rolling_velocity_t(double* result_0, double* result_1, double* result_2, double* result_3, double* result_4, double* result_5, array_double_1d work, array_double_1d work_t, double x, double x_t, double y, double y_t, double z, double z_t, double radius, double radius_t);
static inline int64_t tangent_creepage__velocity_along_t(double* result_0, double* result_1, array_double_1d work, array_double_1d work_t, double y, double y_t, double z, double z_t, double rolling_x, double rolling_x_t);
static inline int64_t tangent_creepage__reference_speed_t(double* result_0, double* result_1, array_double_1d work, array_double_1d work_t, double rolling_x, double rolling_x_t);
static inline int64_t tangent_creepage__write_creepage_t(array_double_1d work, array_double_1d work_t, int64_t rail, int64_t patch, double mirror, double mirror_t);
static inline int64_t tangent_creepage__write_side_creepages_t(array_double_1d work, array_double_1d work_t, int64_t rail, int64_t side, double mirror, double mirror_t);
static inline int64_t tangent_creepage__patch_speed_t(double* v1, double* v1_t, array_double_1d work, array_double_1d work_t, int64_t patch);

#endif
