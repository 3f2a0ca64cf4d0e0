/* Generated from tangent_patches.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of patches.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_PATCHES_H
#define WRCONTACT_KERNEL_TANGENT_PATCHES_H

#include "../native/spans.h"
#include "layout.h"
#include "nodes.h"
#include "patches.h"
#include "tangent_analyn.h"
#include "tangent_rates.h"

static inline int64_t tangent_patches__quadratic_moment_t(double* result_0, double* result_1, double before, double before_t, double low, double low_t, double high, double high_t, double start, double start_t, double stop, double stop_t);
static inline int64_t tangent_patches__bent_integral_t(double* result_0, double* result_1, double low, double low_t, double slope, double slope_t, double bend, double bend_t, double start, double start_t, double stop, double stop_t);
static inline int64_t tangent_patches__root_integral_t(double* v2, double* v2_t, double before, double before_t, double low, double low_t, double high, double high_t, double start, double start_t, double stop, double stop_t);
static inline int64_t tangent_patches__load_nodes_t(array_double_1d work, array_double_1d work_t, int64_t region, double level, double level_t);
static inline int64_t tangent_patches__peak_square_t(double* square, double* square_t, array_double_1d work, array_double_1d work_t, int64_t field, int64_t k);
static inline int64_t tangent_patches__open_island_t(array_double_1d work, array_double_1d work_t, int64_t count, double start, double start_t, double angle, double angle_t);
static inline int64_t tangent_patches__add_cell_t(array_double_1d work, array_double_1d work_t, int64_t region, int64_t before, int64_t low, int64_t high, double start, double start_t, double stop, double stop_t, int64_t at, double inner, double inner_t, double step, double step_t);
static inline int64_t tangent_patches__gather_cell_t(array_double_1d work, array_double_1d work_t, int64_t region, double level, double level_t, int64_t k, int64_t islands, double angle, double angle_t);
static inline int64_t tangent_patches__gather_islands_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t count);
static inline int64_t tangent_patches__write_patch_t(array_double_1d work, array_double_1d work_t, int64_t to, int64_t at);
static inline int64_t tangent_patches__write_patches_t(array_double_1d work, array_double_1d work_t, int64_t side, int64_t islands);
static inline int64_t tangent_patches__quadratic_value_t(double* result_0, double* result_1, double before, double before_t, double low, double low_t, double high, double high_t, double x, double x_t);
static inline int64_t tangent_patches__strip_at_t(double* half, double* half_t, double* pressure, double* pressure_t, array_double_1d work, array_double_1d work_t, int64_t region, double station, double station_t);
static inline int64_t tangent_patches__write_outline_t(array_double_1d work, array_double_1d work_t, int64_t side, int64_t place, int64_t stations, int64_t count, int64_t islands);

#endif
