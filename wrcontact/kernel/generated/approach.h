/* Generated from motion/approach.py by tools/transpile_kernel.py; change that one.
 *
 * How fast a wheel and its rail approach each other.
 */

#ifndef WRCONTACT_KERNEL_APPROACH_H
#define WRCONTACT_KERNEL_APPROACH_H

#include "../native/spans.h"
#include "layout.h"

static inline double approach__approach_rate(array_double_1d work, int64_t index, int64_t at, double angle);

#endif
