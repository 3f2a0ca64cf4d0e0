/* Generated from tangent_estimate.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of estimate.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_ESTIMATE_H
#define WRCONTACT_KERNEL_TANGENT_ESTIMATE_H

#include "../native/spans.h"
#include "estimate.h"
#include "layout.h"
#include "node_coefficients.h"
#include "tangent_hertz.h"
#include "tangent_rates.h"
#include "tangent_regions.h"
#include "tangent_widths.h"

static inline int64_t tangent_estimate__guess_penetration_t(double* v8, double* result_1, double force, double force_t, double A, double A_t, double contact_modulus, double contact_modulus_t);
static inline int64_t tangent_estimate__estimate_penetration_t(double* v8, double* result_1, array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, double force, double force_t);
static inline int64_t tangent_estimate__first_penetration_t(double* v1, double* v1_t, array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, double force, double force_t);
static inline int64_t tangent_estimate__start_penetrations_t(array_double_1d work, array_double_1d work_t, int64_t count, double penetration, double penetration_t);

#endif
