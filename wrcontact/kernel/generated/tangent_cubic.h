/* Generated from tangent_cubic.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of cubic.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_CUBIC_H
#define WRCONTACT_KERNEL_TANGENT_CUBIC_H

#include "../native/spans.h"

static inline int64_t tangent_cubic__cubic_through_t(double* result_0, double* result_1, double before, double before_t, double low, double low_t, double high, double high_t, double after, double after_t, double x, double x_t);

#endif
