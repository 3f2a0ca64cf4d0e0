/* Generated from tangent_fastrip.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of fastrip.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_FASTRIP_H
#define WRCONTACT_KERNEL_TANGENT_FASTRIP_H

#include "../native/spans.h"
#include "layout.h"
#include "tangent_fastsim.h"
#include "tangent_rates.h"
#include "tangent_shapes.h"
#include "tangent_tractions.h"

static inline int64_t tangent_fastrip__set_stiffnesses_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t rolling);
static inline int64_t tangent_fastrip__longitudinal_t(double* push, double* push_t, array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t rolling, int64_t strip);
static inline int64_t tangent_fastrip__find_stick_t(array_double_1d work, array_double_1d work_t, int64_t march, double push, double push_t, double lateral, double lateral_t, double spin, double spin_t);
static inline int64_t tangent_fastrip__next_traction_t(double* p_x, double* p_x_t, double* p_y, double* p_y_t, array_double_1d work, array_double_1d work_t, int64_t march, double x, double x_t, double bound, double bound_t);
static inline int64_t tangent_fastrip__add_tractions_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t table, int64_t rolling, int64_t strip);
static inline int64_t tangent_fastrip__solve_fastrip_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t rolling);

#endif
