/* Generated from tangent_touching.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of touching.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_TOUCHING_H
#define WRCONTACT_KERNEL_TANGENT_TOUCHING_H

#include "../native/spans.h"

static inline int64_t tangent_touching__limited_t(double* result_0, double* result_1, double step, double step_t, double limit, double limit_t);

#endif
