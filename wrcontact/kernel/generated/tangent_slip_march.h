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

static inline int64_t tangent_slip_march__open_marches_t(array_double_1d work, array_double_1d work_t, int64_t marches, double ratio, double ratio_t);
static inline int64_t tangent_slip_march__set_pushes_t(array_double_1d work, array_double_1d work_t, int64_t march, int64_t marches, int64_t number, double plane, double plane_t, double spinning, double spinning_t, double ratio, double ratio_t);
static inline int64_t tangent_slip_march__add_beyond_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t table, int64_t march, int64_t marches, int64_t number, int64_t last);
static inline int64_t tangent_slip_march__set_stick_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t table, int64_t march, int64_t marches, int64_t number);
static inline int64_t tangent_slip_march__sqrt_of_t(double* root, double* root_t, double value, double value_t);
static inline int64_t tangent_slip_march__stepped_t(double* result_0, double* result_1, double* result_2, double* result_3, array_double_1d work, array_double_1d work_t, int64_t marches, int64_t i, double p_x, double p_x_t, double p_y, double p_y_t, double x, double x_t, double step, double step_t);
static inline int64_t tangent_slip_march__note_largest_t(array_double_1d work, array_double_1d work_t, int64_t marches, int64_t i, double p_x, double p_x_t, double p_y, double p_y_t);
static inline int64_t tangent_slip_march__reach_edge_t(array_double_1d work, array_double_1d work_t, int64_t marches, int64_t i, double before, double before_t, double x, double x_t, double bound, double bound_t);
static inline int64_t tangent_slip_march__march_first_t(array_double_1d work, array_double_1d work_t, int64_t marches, double x, double x_t, double bound, double bound_t, double step, double step_t);
static inline int64_t tangent_slip_march__march_second_t(array_double_1d work, array_double_1d work_t, int64_t marches, double x, double x_t, double bound, double bound_t, double step, double step_t);
static inline int64_t tangent_slip_march__slip_traction_t(double* result_0, double* result_1, double* result_2, double* result_3, array_double_1d work, array_double_1d work_t, int64_t marches, int64_t i, double bound, double bound_t);
static inline int64_t tangent_slip_march__leave_edge_t(array_double_1d work, array_double_1d work_t, int64_t marches, int64_t i, double x, double x_t, double bound, double bound_t);
static inline int64_t tangent_slip_march__march_strips_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t table, int64_t marches);

#endif
