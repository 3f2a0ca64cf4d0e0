/* Generated from tangent_interaction.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of interaction.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_INTERACTION_H
#define WRCONTACT_KERNEL_TANGENT_INTERACTION_H

#include "../native/spans.h"
#include "interaction.h"
#include "layout.h"
#include "tangent_rates.h"

static inline int64_t tangent_interaction__region_lead_t(double* lead, double* lead_t, array_double_1d work, array_double_1d work_t, int64_t one, int64_t other);
static inline int64_t tangent_interaction__planes_cosine_t(double* cosine, double* cosine_t, array_double_1d work, array_double_1d work_t, int64_t one, int64_t other);
static inline int64_t tangent_interaction__region_influence_t(double* result, double* result_t, array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t one, int64_t other);

#endif
