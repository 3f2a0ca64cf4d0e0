/* Generated from normal/elimination.py by tools/transpile_kernel.py; change that one.
 *
 * Linear equations with two right-hand sides.
 */

#ifndef WRCONTACT_KERNEL_ELIMINATION_H
#define WRCONTACT_KERNEL_ELIMINATION_H

#include "../native/spans.h"
#include "layout.h"

static inline int64_t elimination__eliminate(array_double_1d work, int64_t size);

#endif
