/* Generated from normal/strip_pressures.py by tools/transpile_kernel.py; change that one.
 *
 * Pressures of the strips: no strip pulls, none without load penetrates, and together they carry the force;
 * eq. (S5).
 *
 * A linear complementarity problem: elimination for the strips that are taken as loaded, then an exchange of
 * those that pull or penetrate, until none does.
 */

#ifndef WRCONTACT_KERNEL_STRIP_PRESSURES_H
#define WRCONTACT_KERNEL_STRIP_PRESSURES_H

#include "../native/spans.h"
#include "elimination.h"
#include "layout.h"
#include "strip_influence.h"

static const int64_t strip_pressures__EXCHANGES = INT64_C(10);
static const int64_t strip_pressures__EXCHANGE_LIMIT = INT64_C(200);
static const double strip_pressures__TOUCH = 1e-12;

static inline int64_t strip_pressures__list_loaded(array_double_1d work);
static inline int64_t strip_pressures__write_equations(array_double_1d work, int64_t size);
static inline double strip_pressures__equilibrium_penetration(array_double_1d work, array_double_1d tables, int64_t size, double force);
static inline int64_t strip_pressures__read_solution(array_double_1d work, int64_t size, double penetration);
static inline int64_t strip_pressures__exchange_strips(array_double_1d work, double penetration, int64_t single);
static inline int64_t strip_pressures__solve_pressures(double* result_0, int64_t* result_1_0001, array_double_1d work, array_double_1d tables, array_double_1d state, double force, int64_t by_penetration, int64_t yawed);

#endif
