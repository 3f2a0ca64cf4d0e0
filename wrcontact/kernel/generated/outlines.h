/* Generated from wheelset/outlines.py by tools/transpile_kernel.py; change that one.
 *
 * Where the outline of each side is: among its outputs, or behind those of both sides for
 * another number of stations.
 */

#ifndef WRCONTACT_KERNEL_OUTLINES_H
#define WRCONTACT_KERNEL_OUTLINES_H

#include "../native/spans.h"
#include "layout.h"
#include "outline.h"

static inline int64_t outlines__outline_place(array_double_1d tables, array_double_1d work, int64_t index);
static inline int64_t outlines__fill_apart(array_double_1d tables, array_double_1d work, int64_t index, double value);

#endif
