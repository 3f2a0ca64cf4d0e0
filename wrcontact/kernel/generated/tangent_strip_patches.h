/* Generated from tangent_strip_patches.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of strip_patches.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_STRIP_PATCHES_H
#define WRCONTACT_KERNEL_TANGENT_STRIP_PATCHES_H

#include "../native/spans.h"
#include "layout.h"
#include "strip_patches.h"
#include "strips.h"
#include "tangent_filling.h"
#include "tangent_quadrature.h"
#include "tangent_strips.h"

static inline int64_t tangent_strip_patches__divided_bend_t(double* v7, double* result_1, array_double_1d work, array_double_1d work_t, int64_t field, int64_t i);
static inline int64_t tangent_strip_patches__cell_bend_t(double* bend, double* bend_t, array_double_1d work, array_double_1d work_t, int64_t field, int64_t i, int64_t first, int64_t last);
static inline int64_t tangent_strip_patches__cell_area_t(double* result_0, double* result_1, double low, double low_t, double high, double high_t, double bend, double bend_t, double width, double width_t);
static inline int64_t tangent_strip_patches__run_area_t(double* result_0, double* result_1, array_double_1d work, array_double_1d work_t, int64_t first, int64_t last, double start, double start_t, double stop, double stop_t);
static inline int64_t tangent_strip_patches__top_value_t(double* value, double* value_t, array_double_1d work, array_double_1d work_t, int64_t field, int64_t i, int64_t first, int64_t last);
static inline int64_t tangent_strip_patches__gather_strips_t(array_double_1d work, array_double_1d work_t, int64_t strips);

#endif
