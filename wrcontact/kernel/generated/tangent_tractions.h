/* Generated from tangent_tractions.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of tractions.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_TRACTIONS_H
#define WRCONTACT_KERNEL_TANGENT_TRACTIONS_H

#include "../native/spans.h"
#include "layout.h"
#include "tangent_rates.h"
#include "tractions.h"

static inline int64_t tangent_tractions__bound_rate_t(double* rate, double* rate_t, array_double_1d work, array_double_1d work_t, int64_t rolling, int64_t strip);
static inline int64_t tangent_tractions__cut_to_t(double* result_0, double* result_1, double* result_2, double* result_3, double along, double along_t, double across, double across_t, double bound, double bound_t);
static inline int64_t tangent_tractions__add_strip_t(array_double_1d work, array_double_1d work_t, int64_t rolling, int64_t strip, double along, double along_t, double across, double across_t, double moment, double moment_t);
static inline int64_t tangent_tractions__patch_area_t(double* area, double* area_t, array_double_1d work, array_double_1d work_t, int64_t rolling);
static inline int64_t tangent_tractions__point_weight_t(double* result_0, double* result_1, array_double_1d work, array_double_1d work_t, int64_t strip);

#endif
