/* Generated from wheelset/step.py by tools/transpile_kernel.py; change that one.
 *
 * One step of a wheelset: from pose and load to contact positions, roll and patches.
 *
 * The recipe: check the inputs, find the roll at which both wheels touch, describe each contact and
 * solve its normal contact; for an elastic wheelset, find the height and roll at which both wheels carry
 * their loads; add up the forces. If the wheelset rolls, creepages follow, and from them the creep forces; where
 * the load is a vertical one, friction carries some of it, and the wheelset is solved again.
 */

#ifndef WRCONTACT_KERNEL_STEP_H
#define WRCONTACT_KERNEL_STEP_H

#include "../native/spans.h"
#include "compliant.h"
#include "creep_forces.h"
#include "elastic.h"
#include "friction_load.h"
#include "layout.h"
#include "leaning.h"
#include "moving.h"
#include "outline.h"
#include "requested.h"
#include "resultant.h"
#include "rigid.h"
#include "roll.h"
#include "trial.h"

static inline double step__support_height(array_double_1d work);
static inline int64_t step__meet_leaning(double* result_0, int64_t* result_1_0001, array_double_1d left_tables, array_double_1d right_tables, array_double_1d work, array_double_1d state, double rigid_roll);
static inline int64_t step__elastic_from_rigid(array_double_1d left_tables, array_double_1d right_tables, array_double_1d work, array_double_1d state, double rigid_roll);
static inline int64_t step__solve_wheelset(array_double_1d left_tables, array_double_1d right_tables, array_double_1d work, array_double_1d state);
static inline int64_t step__solve_with_friction(array_double_1d left_tables, array_double_1d right_tables, array_double_1d work, array_double_1d state, int64_t status);
static inline int64_t step__evaluate(array_double_1d left_tables, array_double_1d right_tables, array_double_1d work, array_double_1d state);
static inline int64_t step__step_row(array_double_1d left_tables, array_double_1d right_tables, array_double_1d state, array_double_1d workspace, array_double_1d inputs, array_double_1d outputs, int64_t row);
static inline int64_t step__step(array_double_1d left_tables, array_double_1d right_tables, array_double_1d state, array_double_1d workspace, array_double_1d inputs, array_double_1d outputs);
static inline int64_t step__step_many(int64_t count, array_double_1d left_tables, array_double_1d right_tables, array_double_1d state, array_double_1d workspace, array_double_1d inputs, array_double_1d outputs, array_double_1d statuses);

#endif
