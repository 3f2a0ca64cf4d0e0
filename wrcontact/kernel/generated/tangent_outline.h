/* Generated from tangent_outline.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of outline.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_OUTLINE_H
#define WRCONTACT_KERNEL_TANGENT_OUTLINE_H

#include "../native/spans.h"
#include "layout.h"
#include "outline.h"

static inline int64_t tangent_outline__fill_apart_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t out, double value, double value_t);

#endif
