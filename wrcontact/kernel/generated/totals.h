/* Generated from patch/totals.py by tools/transpile_kernel.py; change that one.
 *
 * From the solved patches to the outputs of a side: its totals and its heaviest patches.
 */

#ifndef WRCONTACT_KERNEL_TOTALS_H
#define WRCONTACT_KERNEL_TOTALS_H

#include "../native/spans.h"
#include "layout.h"

static inline int64_t totals__write_patch(array_double_1d work, int64_t patch, int64_t to);
static inline int64_t totals__write_patches(array_double_1d work, int64_t side);

#endif
