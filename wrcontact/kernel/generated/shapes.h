/* Generated from tangential/shapes.py by tools/transpile_kernel.py; change that one.
 *
 * What depends on the shape of a patch, its length over its width, from the table of rolling.
 */

#ifndef WRCONTACT_KERNEL_SHAPES_H
#define WRCONTACT_KERNEL_SHAPES_H

#include "../native/spans.h"
#include "layout.h"
#include "table_cell.h"

static inline double shapes__shape_place(double axis_ratio);
static inline double shapes__shape_value(array_double_1d tables, int64_t table, int64_t column, double place);
static inline int64_t shapes__kalker_coefficients(double* result_0, double* result_1, double* result_2, array_double_1d tables, int64_t table, double axis_ratio);

#endif
