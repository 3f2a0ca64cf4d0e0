/* Generated from tangent_approach.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of approach.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_APPROACH_H
#define WRCONTACT_KERNEL_TANGENT_APPROACH_H

#include "../native/spans.h"
#include "layout.h"

static inline int64_t tangent_approach__approach_rate_t(double* result_0, double* result_1, array_double_1d work, array_double_1d work_t, int64_t index, int64_t at, double angle, double angle_t);

#endif
