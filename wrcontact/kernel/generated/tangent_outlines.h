/* Generated from tangent_outlines.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of outlines.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_OUTLINES_H
#define WRCONTACT_KERNEL_TANGENT_OUTLINES_H

#include "../native/spans.h"
#include "layout.h"
#include "outlines.h"
#include "tangent_outline.h"

static inline int64_t tangent_outlines__fill_apart_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t index, double value, double value_t);

#endif
