/* Generated from tangent_contact_rates.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of contact_rates.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_CONTACT_RATES_H
#define WRCONTACT_KERNEL_TANGENT_CONTACT_RATES_H

#include "../native/spans.h"
#include "layout.h"

static inline int64_t tangent_contact_rates__touching_constraint_t(array_double_1d work, array_double_1d work_t, int64_t side, double mirror, double mirror_t, int64_t constraint);
static inline int64_t tangent_contact_rates__loaded_constraint_t(array_double_1d work, array_double_1d work_t, int64_t side, int64_t constraint);
static inline int64_t tangent_contact_rates__known_part_t(double* result_0, double* result_1, array_double_1d work, array_double_1d work_t, int64_t index);
static inline int64_t tangent_contact_rates__contact_rates_t(double* vertical, double* vertical_t, double* roll_rate, double* roll_rate_t, array_double_1d work, array_double_1d work_t);

#endif
