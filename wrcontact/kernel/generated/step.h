/* Generated from wheelset/step.py by tools/transpile_kernel.py; change that one.
 *
 * One step of a wheelset: from pose and load to contact positions, roll and patches.
 *
 * The recipe: check the inputs, find the roll at which both wheels touch, describe each contact, solve its normal contact.
 */

#ifndef WRCONTACT_KERNEL_STEP_H
#define WRCONTACT_KERNEL_STEP_H

#include "../native/spans.h"
#include "elastic.h"
#include "layout.h"
#include "level.h"
#include "outline.h"
#include "resultant.h"
#include "side.h"
#include "starts.h"

static const double step__NEAR_SHIFT = 0.0002;

static inline int64_t step__inputs_valid(array_double_1d work);
static inline int64_t step__inputs_in_range(array_double_1d tables, array_double_1d work);
static inline int64_t step__find_roll(double* result_0, int64_t* result_1, array_double_1d tables, array_double_1d work, array_double_1d state);
static inline double step__side_force(array_double_1d work, int64_t index);
static inline int64_t step__is_wanted(array_double_1d tables, int64_t index);
static inline int64_t step__stand_rigid(array_double_1d tables, array_double_1d work, array_double_1d state, double roll);
static inline int64_t step__stand_elastic(array_double_1d tables, array_double_1d work, array_double_1d state, double rigid_roll);
static inline int64_t step__remember(array_double_1d work, array_double_1d state, double roll);
static inline int64_t step__withhold(array_double_1d tables, array_double_1d work);
static inline int64_t step__evaluate(array_double_1d tables, array_double_1d work, array_double_1d state);
static inline int64_t step__step_row(array_double_1d tables, array_double_1d state, array_double_1d workspace, array_double_1d inputs, array_double_1d outputs, int64_t row);
static inline int64_t step__step(array_double_1d tables, array_double_1d state, array_double_1d workspace, array_double_1d inputs, array_double_1d outputs);
static inline int64_t step__step_many(int64_t count, array_double_1d tables, array_double_1d state, array_double_1d workspace, array_double_1d inputs, array_double_1d outputs, array_double_1d statuses);

#endif
