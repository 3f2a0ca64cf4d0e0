/* Generated from tangent_totals.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of totals.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_TOTALS_H
#define WRCONTACT_KERNEL_TANGENT_TOTALS_H

#include "../native/spans.h"
#include "layout.h"

static inline int64_t tangent_totals__write_patch_t(array_double_1d work, array_double_1d work_t, int64_t patch, int64_t to);
static inline int64_t tangent_totals__write_patches_t(array_double_1d work, array_double_1d work_t, int64_t side);

#endif
