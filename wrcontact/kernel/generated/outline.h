/* Generated from patch/outline.py by tools/transpile_kernel.py; change that one.
 *
 * Where the outline of a side lies: three runs of equal length, its stations, half-lengths and pressures.
 *
 * With STATION_COUNT stations it is part of the side's outputs.  With another number the outlines of both sides, left then
 * right, follow behind all outputs, and the places for it among the side's own stay zero.
 */

#ifndef WRCONTACT_KERNEL_OUTLINE_H
#define WRCONTACT_KERNEL_OUTLINE_H

#include "../native/spans.h"
#include "layout.h"

static inline int64_t outline__outline_place(array_double_1d tables, array_double_1d work, int64_t out);
static inline int64_t outline__fill_apart(array_double_1d tables, array_double_1d work, int64_t out, double value);
static inline int64_t outline__row_size(array_double_1d tables);

#endif
