/* Generated from search/starts.py by tools/transpile_kernel.py; change that one.
 *
 * Where the roll search starts without a near pose before: contacts without yaw,
 * known for a row of lateral shifts.
 *
 * A start sets the cost and never the answer, which is certified.
 */

#ifndef WRCONTACT_KERNEL_STARTS_H
#define WRCONTACT_KERNEL_STARTS_H

#include "../native/spans.h"
#include "layout.h"

static inline int64_t starts__nearest_start(array_double_1d tables, int64_t starts, double shift);

#endif
