/* Generated from tangent_strip_patches.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of strip_patches.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_STRIP_PATCHES_H
#define WRCONTACT_KERNEL_TANGENT_STRIP_PATCHES_H

#include "../native/spans.h"
#include "layout.h"
#include "strip_edges.h"
#include "strip_patches.h"
#include "tangent_filling.h"
#include "tangent_quadrature.h"
#include "tangent_rails.h"
#include "tangent_rates.h"
#include "tangent_strip_edges.h"

static inline int64_t tangent_strip_patches__slant_region_t(array_double_1d work, array_double_1d work_t, int64_t region, int64_t index, double station, double station_t, double x, double x_t);
static inline int64_t tangent_strip_patches__load_region_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t region, int64_t index);
static inline int64_t tangent_strip_patches__end_like_ellipse_t(array_double_1d work, array_double_1d work_t, int64_t edge, int64_t inner);
static inline int64_t tangent_strip_patches__add_strip_t(array_double_1d work, array_double_1d work_t, int64_t patch, int64_t strip, int64_t to);
static inline int64_t tangent_strip_patches__divided_bend_t(double* v7, double* result_1, array_double_1d work, array_double_1d work_t, int64_t i, double before, double before_t, double value, double value_t, double after, double after_t);
static inline int64_t tangent_strip_patches__square_bend_t(double* v1, double* v1_t, array_double_1d work, array_double_1d work_t, int64_t i);
static inline int64_t tangent_strip_patches__cell_bend_t(double* bend, double* bend_t, array_double_1d work, array_double_1d work_t, int64_t i, int64_t first, int64_t last);
static inline int64_t tangent_strip_patches__cell_area_t(double* result_0, double* result_1, double low, double low_t, double high, double high_t, double bend, double bend_t, double width, double width_t);
static inline int64_t tangent_strip_patches__run_area_t(double* result_0, double* result_1, array_double_1d work, array_double_1d work_t, int64_t first, int64_t last, double start, double start_t, double stop, double stop_t);
static inline int64_t tangent_strip_patches__summit_t(double* result_0, double* result_1, array_double_1d work, array_double_1d work_t, int64_t i, double before, double before_t, double value, double value_t, double after, double after_t);
static inline int64_t tangent_strip_patches__largest_pressure_t(double* pressure, double* pressure_t, array_double_1d work, array_double_1d work_t, int64_t first, int64_t last);
static inline int64_t tangent_strip_patches__largest_square_t(double* square, double* square_t, array_double_1d work, array_double_1d work_t, int64_t first, int64_t last);
static inline int64_t tangent_strip_patches__fill_run_t(array_double_1d work, array_double_1d work_t, int64_t first, int64_t last);
static inline int64_t tangent_strip_patches__fill_from_strips_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t count);
static inline int64_t tangent_strip_patches__add_stiffness_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t count);

#endif
