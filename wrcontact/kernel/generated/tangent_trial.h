/* Generated from tangent_trial.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of trial.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_TRIAL_H
#define WRCONTACT_KERNEL_TANGENT_TRIAL_H

#include "../native/spans.h"
#include "layout.h"
#include "tangent_side.h"
#include "trial.h"

static inline int64_t tangent_trial__permitted_approach_t(double* approach, double* approach_t, array_double_1d work, array_double_1d work_t, int64_t support, int64_t side, double height, double height_t);
static inline int64_t tangent_trial__balance_side_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, array_double_1d state, int64_t index, double force, double force_t, double height, double height_t);

#endif
