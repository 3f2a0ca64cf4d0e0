/* Generated from normal/strip_patches.py by tools/transpile_kernel.py; change that one.
 *
 * From corrected strips to solved patches: each run of loaded strips that touch each other is a patch.
 */

#ifndef WRCONTACT_KERNEL_STRIP_PATCHES_H
#define WRCONTACT_KERNEL_STRIP_PATCHES_H

#include "../native/spans.h"
#include "filling.h"
#include "layout.h"
#include "quadrature.h"
#include "rails.h"
#include "strip_edges.h"

static const double strip_patches__CLOSE = 1e-06;

static inline int64_t strip_patches__slant_region(array_double_1d work, int64_t region, int64_t index, double station, double x);
static inline int64_t strip_patches__load_region(array_double_1d work, array_double_1d tables, int64_t region, int64_t index);
static inline int64_t strip_patches__end_like_ellipse(array_double_1d work, int64_t edge, int64_t inner);
static inline int64_t strip_patches__add_strip(array_double_1d work, int64_t patch, int64_t strip, int64_t to);
static inline double strip_patches__divided_bend(array_double_1d work, int64_t i, double before, double value, double after);
static inline double strip_patches__square_bend(array_double_1d work, int64_t i);
static inline double strip_patches__cell_bend(array_double_1d work, int64_t i, int64_t first, int64_t last);
static inline double strip_patches__cell_area(double low, double high, double bend, double width);
static inline double strip_patches__run_area(array_double_1d work, int64_t first, int64_t last, double start, double stop);
static inline double strip_patches__summit(array_double_1d work, int64_t i, double before, double value, double after);
static inline double strip_patches__largest_pressure(array_double_1d work, int64_t first, int64_t last);
static inline double strip_patches__largest_square(array_double_1d work, int64_t first, int64_t last);
static inline int64_t strip_patches__fill_run(array_double_1d work, int64_t first, int64_t last);
static inline int64_t strip_patches__fill_from_strips(array_double_1d work, array_double_1d tables, int64_t count);
static inline int64_t strip_patches__add_stiffness(array_double_1d work, array_double_1d tables, int64_t count);

#endif
