/* Generated from tangent_sections.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of sections.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_SECTIONS_H
#define WRCONTACT_KERNEL_TANGENT_SECTIONS_H

#include "../native/spans.h"
#include "layout.h"
#include "tangent_rates.h"

static inline int64_t tangent_sections__cut_patch_t(array_double_1d work, array_double_1d work_t, int64_t index, int64_t rolling);

#endif
