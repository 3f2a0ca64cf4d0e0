/* Generated from tangent_touching.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of touching.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_TOUCHING_H
#define WRCONTACT_KERNEL_TANGENT_TOUCHING_H

#include "../native/spans.h"
#include "layout.h"
#include "tangent_locus.h"
#include "tangent_profile_table.h"
#include "tangent_rates.h"
#include "touching.h"

static inline int64_t tangent_touching__pair_rule_t(double* result_0, double* result_1, double* result_2, double* result_3, double* depth, double* depth_t, double* aside, double* aside_t, double* back_shift, double* back_shift_t, int64_t* found, array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t place, double y, double y_t, double abscissa, double abscissa_t, double shift, double shift_t);

#endif
