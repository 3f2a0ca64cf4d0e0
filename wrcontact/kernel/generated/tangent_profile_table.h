/* Generated from tangent_profile_table.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of profile_table.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_PROFILE_TABLE_H
#define WRCONTACT_KERNEL_TANGENT_PROFILE_TABLE_H

#include "../native/spans.h"
#include "layout.h"
#include "profile_table.h"

static inline int64_t tangent_profile_table__height_slope_t(double* result_0, double* result_1, double* slope, double* slope_t, array_double_1d tables, int64_t profile, double y, double y_t);
static inline int64_t tangent_profile_table__height_slope_bend_t(double* result_0, double* result_1, double* result_2, double* result_3, double* result_4, double* result_5, array_double_1d tables, int64_t profile, double y, double y_t);

#endif
