/* Generated from tangent_strip_influence.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of strip_influence.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_STRIP_INFLUENCE_H
#define WRCONTACT_KERNEL_TANGENT_STRIP_INFLUENCE_H

#include "../native/spans.h"
#include "layout.h"
#include "tangent_interaction.h"
#include "tangent_rates.h"

static inline int64_t tangent_strip_influence__measure_distances_t(array_double_1d work, array_double_1d work_t, int64_t i, int64_t others);
static inline int64_t tangent_strip_influence__line_influence_t(double* result_0, double* result_1, array_double_1d tables, int64_t table, double abscissa, double abscissa_t);
static inline int64_t tangent_strip_influence__near_share_t(double* result_0, double* result_1, double share, double share_t);
static inline int64_t tangent_strip_influence__turn_influences_t(array_double_1d work, array_double_1d work_t, int64_t count);
static inline int64_t tangent_strip_influence__fill_influences_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t table);

#endif
