/* Generated from tangent_strip_pressures.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of strip_pressures.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_STRIP_PRESSURES_H
#define WRCONTACT_KERNEL_TANGENT_STRIP_PRESSURES_H

#include "../native/spans.h"
#include "layout.h"
#include "strip_pressures.h"
#include "tangent_elimination.h"
#include "tangent_strip_influence.h"

static inline int64_t tangent_strip_pressures__list_loaded_t(array_double_1d work, array_double_1d work_t);
static inline int64_t tangent_strip_pressures__write_equations_t(array_double_1d work, array_double_1d work_t, int64_t size);
static inline int64_t tangent_strip_pressures__equilibrium_penetration_t(double* v3, double* result_1, array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t size, double force, double force_t);
static inline int64_t tangent_strip_pressures__read_solution_t(array_double_1d work, array_double_1d work_t, int64_t size, double penetration, double penetration_t);
static inline int64_t tangent_strip_pressures__exchange_strips_t(array_double_1d work, array_double_1d work_t, double penetration, double penetration_t, int64_t single);
static inline int64_t tangent_strip_pressures__solve_pressures_t(double* result_0, double* result_1, int64_t* result_2_0001, array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, double force, double force_t, int64_t by_penetration, int64_t yawed);

#endif
