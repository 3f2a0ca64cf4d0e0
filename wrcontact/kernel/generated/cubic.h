/* Generated from surface/cubic.py by tools/transpile_kernel.py; change that one.
 *
 * A cubic through four evenly spaced values.
 */

#ifndef WRCONTACT_KERNEL_CUBIC_H
#define WRCONTACT_KERNEL_CUBIC_H

#include "../native/spans.h"

static inline double cubic__cubic_through(double before, double low, double high, double after, double x);

#endif
