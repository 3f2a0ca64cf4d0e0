/* Generated from tangential/sections.py by tools/transpile_kernel.py; change that one.
 *
 * provisional
 */

#ifndef WRCONTACT_KERNEL_SECTIONS_H
#define WRCONTACT_KERNEL_SECTIONS_H

#include "../native/spans.h"
#include "layout.h"

static inline int64_t sections__cut_patch(array_double_1d work, int64_t index, int64_t rolling);

#endif
