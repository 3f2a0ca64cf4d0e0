/* Generated from tangent_step.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of step.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_STEP_H
#define WRCONTACT_KERNEL_TANGENT_STEP_H

#include "../native/spans.h"
#include "layout.h"
#include "side.h"
#include "step.h"
#include "tangent_resultant.h"
#include "tangent_side.h"

static inline int64_t tangent_step__side_force_t(double* result_0, double* result_1, array_double_1d work, array_double_1d work_t, int64_t index);
static inline int64_t tangent_step__stand_rigid_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, array_double_1d state, double roll, double roll_t);
static inline int64_t tangent_step__withhold_t(array_double_1d tables, array_double_1d work, array_double_1d work_t);

#endif
