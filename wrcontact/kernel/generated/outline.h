/* Generated from patch/outline.py by tools/transpile_kernel.py; change that one.
 *
 * The outline of a wheel's patches: half-length and pressure at evenly spaced stations, from the first edge
 * to the last.
 *
 * With STATION_COUNT stations it is part of the outputs of its side.  With another number the outlines of both
 * sides, left then right, follow all outputs, and the places for it among the outputs of the side stay zero.
 */

#ifndef WRCONTACT_KERNEL_OUTLINE_H
#define WRCONTACT_KERNEL_OUTLINE_H

#include "../native/spans.h"
#include "interpolation.h"
#include "layout.h"

static inline int64_t outline__row_size(array_double_1d tables);
static inline int64_t outline__fill_outline(array_double_1d work, int64_t outline, int64_t stations, double value);
static inline int64_t outline__write_ellipse(array_double_1d work, int64_t outline, int64_t stations, int64_t totals);
static inline int64_t outline__write_quadratic(array_double_1d work, int64_t outline, int64_t stations, int64_t count);
static inline int64_t outline__patch_beside(array_double_1d work, int64_t index, double station);
static inline int64_t outline__write_straight(array_double_1d work, int64_t outline, int64_t stations);
static inline int64_t outline__write_outline(array_double_1d work, int64_t outline, int64_t stations, int64_t count);

#endif
