/* Generated from tangent_gap.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of gap.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_GAP_H
#define WRCONTACT_KERNEL_TANGENT_GAP_H

#include "../native/spans.h"
#include "gap.h"
#include "layout.h"
#include "tangent_locus.h"
#include "tangent_profile_table.h"

static inline int64_t tangent_gap__vertical_gap_t(double* result_0, double* result_1, double* mismatch, double* mismatch_t, double* result_4, double* result_5, array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t place, double y, double y_t);
static inline int64_t tangent_gap__gap_per_roll_t(double* result_0, double* result_1, array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t place, double y, double y_t);

#endif
