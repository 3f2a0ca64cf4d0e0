/* Generated from tangent_analyn.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of analyn.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_ANALYN_H
#define WRCONTACT_KERNEL_TANGENT_ANALYN_H

#include "../native/spans.h"
#include "analyn.h"
#include "elimination.h"
#include "layout.h"
#include "tangent_interaction.h"
#include "tangent_quadrature.h"

static inline int64_t tangent_analyn__clip_to_bound_t(double* result_0, double* result_1, array_double_1d work, array_double_1d work_t, int64_t region, int64_t k, int64_t outward, double stop, double stop_t);
static inline int64_t tangent_analyn__region_load_t(double* result_0, double* result_1, double* result_2, double* result_3, array_double_1d work, array_double_1d work_t, int64_t region, int64_t nodes, double local_penetration, double local_penetration_t);
static inline int64_t tangent_analyn__load_regions_t(double* total, double* total_t, array_double_1d work, array_double_1d work_t, int64_t count);
static inline int64_t tangent_analyn__penetrations_rule_t(double* result_0, double* result_1, int64_t* satisfied, array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, int64_t count, double force, double force_t, double penetration, double penetration_t, int64_t prescribed);

#endif
