/* Generated from tangent_wheelset_motion.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of wheelset_motion.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_WHEELSET_MOTION_H
#define WRCONTACT_KERNEL_TANGENT_WHEELSET_MOTION_H

#include "../native/spans.h"
#include "layout.h"

static inline int64_t tangent_wheelset_motion__rolling_rate_t(double* rate, double* rate_t, array_double_1d work, array_double_1d work_t, array_double_1d tables);
static inline int64_t tangent_wheelset_motion__open_motion_t(array_double_1d work, array_double_1d work_t, array_double_1d tables);
static inline int64_t tangent_wheelset_motion__open_rails_t(array_double_1d work, array_double_1d work_t, array_double_1d left_tables, array_double_1d right_tables);
static inline int64_t tangent_wheelset_motion__set_rates_t(array_double_1d work, array_double_1d work_t, double vertical, double vertical_t, double roll_rate, double roll_rate_t);

#endif
