/* Generated from patch/strip_patches.py by tools/transpile_kernel.py; change that one.
 *
 * From corrected strips to contact patches: edges, loads, areas and pressures.
 *
 * A patch is a run of loaded strips that touch each other.  Near its edge the line load falls to zero in proportion to the
 * distance, so the edge is where the straight line through the last two strips' line loads ends.
 */

#ifndef WRCONTACT_KERNEL_STRIP_PATCHES_H
#define WRCONTACT_KERNEL_STRIP_PATCHES_H

#include "../native/spans.h"
#include "filling.h"
#include "layout.h"
#include "quadrature.h"
#include "strips.h"

static inline double strip_patches__divided_bend(array_double_1d work, int64_t field, int64_t i);
static inline double strip_patches__cell_bend(array_double_1d work, int64_t field, int64_t i, int64_t first, int64_t last);
static inline double strip_patches__cell_area(double low, double high, double bend, double width);
static inline double strip_patches__run_area(array_double_1d work, int64_t first, int64_t last, double start, double stop);
static inline double strip_patches__top_value(array_double_1d work, int64_t field, int64_t i, int64_t first, int64_t last);
static inline int64_t strip_patches__largest_of(array_double_1d work, int64_t field, int64_t first, int64_t last);
static inline int64_t strip_patches__gather_strips(array_double_1d work, int64_t strips);

#endif
