/* Generated from tangent_lateral_curvature.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of lateral_curvature.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_LATERAL_CURVATURE_H
#define WRCONTACT_KERNEL_TANGENT_LATERAL_CURVATURE_H

#include "../native/spans.h"
#include "layout.h"
#include "tangent_table_cell.h"

static inline int64_t tangent_lateral_curvature__profile_curvature_t(double* result_0, double* result_1, array_double_1d tables, int64_t table, double y, double y_t);
static inline int64_t tangent_lateral_curvature__relative_curvature_t(double* result_0, double* result_1, array_double_1d tables, double y, double y_t, double abscissa, double abscissa_t);

#endif
