/* Generated from tangent_shapes.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of shapes.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_SHAPES_H
#define WRCONTACT_KERNEL_TANGENT_SHAPES_H

#include "../native/spans.h"
#include "layout.h"
#include "tangent_table_cell.h"

static inline int64_t tangent_shapes__shape_place_t(double* result_0, double* result_1, double axis_ratio, double axis_ratio_t);
static inline int64_t tangent_shapes__shape_value_t(double* result_0, double* result_1, array_double_1d tables, int64_t table, int64_t column, double place, double place_t);
static inline int64_t tangent_shapes__kalker_coefficients_t(double* v3, double* result_1, double* v5, double* result_3, double* v7, double* result_5, array_double_1d tables, int64_t table, double axis_ratio, double axis_ratio_t);

#endif
