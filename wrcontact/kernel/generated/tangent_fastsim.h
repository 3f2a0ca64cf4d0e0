/* Generated from tangent_fastsim.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of fastsim.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_FASTSIM_H
#define WRCONTACT_KERNEL_TANGENT_FASTSIM_H

#include "../native/spans.h"
#include "layout.h"
#include "tangent_rates.h"
#include "tangent_shapes.h"
#include "tangent_tractions.h"

static inline int64_t tangent_fastsim__stiffnesses_t(double* v5, double* result_1, double* v9, double* result_3, double* v15, double* result_5, array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t rolling);
static inline int64_t tangent_fastsim__strip_push_t(double* push, double* push_t, array_double_1d work, array_double_1d work_t, int64_t rolling, int64_t strip, double along, double along_t, double turning, double turning_t);
static inline int64_t tangent_fastsim__march_strip_t(double* v11, double* result_1, array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t table, int64_t rolling, int64_t strip, double rate, double rate_t, double push, double push_t, double across, double across_t, double turning, double turning_t);
static inline int64_t tangent_fastsim__solve_fastsim_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t rolling);

#endif
