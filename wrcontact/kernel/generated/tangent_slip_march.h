/* Generated from tangent_slip_march.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of slip_march.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_SLIP_MARCH_H
#define WRCONTACT_KERNEL_TANGENT_SLIP_MARCH_H

#include "../native/spans.h"
#include "layout.h"
#include "slip_march.h"
#include "tangent_rates.h"
#include "tangent_tractions.h"

static inline int64_t tangent_slip_march__set_pushes_t(array_double_1d work, array_double_1d work_t, int64_t march, double plane, double plane_t, double spinning, double spinning_t, double ratio, double ratio_t);
static inline int64_t tangent_slip_march__stepped_t(double* r2, double* r2_t, double* r3, double* r3_t, array_double_1d work, array_double_1d work_t, int64_t march, int64_t index, double p_x, double p_x_t, double p_y, double p_y_t, double x, double x_t, double step, double step_t, double bound, double bound_t);
static inline int64_t tangent_slip_march__step_first_t(array_double_1d work, array_double_1d work_t, int64_t march, double x, double x_t, double step, double step_t, double bound, double bound_t);
static inline int64_t tangent_slip_march__beyond_bound_t(double* change_x, double* change_x_t, double* change_y, double* change_y_t, array_double_1d work, array_double_1d work_t, int64_t march, double x, double x_t, double bound, double bound_t);
static inline int64_t tangent_slip_march__step_second_t(array_double_1d work, array_double_1d work_t, int64_t march, double from_x, double from_x_t, double from_y, double from_y_t, double x, double x_t, double step, double step_t, double bound, double bound_t);
static inline int64_t tangent_slip_march__slip_traction_t(double* result_0, double* result_1, double* result_2, double* result_3, array_double_1d work, array_double_1d work_t, int64_t march, double bound, double bound_t);
static inline int64_t tangent_slip_march__note_largest_t(array_double_1d work, array_double_1d work_t, int64_t march, double p_x, double p_x_t, double p_y, double p_y_t);
static inline int64_t tangent_slip_march__add_point_t(array_double_1d work, array_double_1d work_t, int64_t march, double x, double x_t, double weight, double weight_t, double p_x, double p_x_t, double p_y, double p_y_t);
static inline int64_t tangent_slip_march__march_stick_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t table, int64_t march);
static inline int64_t tangent_slip_march__march_held_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t table, int64_t march);
static inline int64_t tangent_slip_march__sqrt_of_t(double* root, double* root_t, double value, double value_t);
static inline int64_t tangent_slip_march__cross_edge_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t table, int64_t march, int64_t q);
static inline int64_t tangent_slip_march__march_slip_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t table, int64_t march, int64_t first);
static inline int64_t tangent_slip_march__march_strip_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t table, int64_t march);

#endif
