/* Generated from tangent_wheelset_rules.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of wheelset_rules.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_WHEELSET_RULES_H
#define WRCONTACT_KERNEL_TANGENT_WHEELSET_RULES_H

#include "../native/spans.h"
#include "creep_forces.h"
#include "damping.h"
#include "elastic.h"
#include "friction_load.h"
#include "layout.h"
#include "moving.h"
#include "tangent_compliant.h"
#include "tangent_creep_forces.h"
#include "tangent_friction_load.h"
#include "tangent_gap.h"
#include "tangent_leaning.h"
#include "tangent_moving.h"
#include "tangent_requested.h"
#include "tangent_resultant.h"
#include "tangent_rigid.h"
#include "tangent_roll.h"
#include "tangent_trial.h"

static inline int64_t tangent_wheelset_rules__begin_yaw_t(array_double_1d work, array_double_1d work_t, double roll, double roll_t);
static inline int64_t tangent_wheelset_rules__place_moving_t(array_double_1d left_tables, array_double_1d right_tables, array_double_1d work, array_double_1d work_t, double roll, double roll_t);
static inline int64_t tangent_wheelset_rules__follow_minimum_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t index);
static inline int64_t tangent_wheelset_rules__follow_roll_t(double* roll, double* result_1, array_double_1d left_tables, array_double_1d right_tables, array_double_1d work, array_double_1d work_t);
static inline int64_t tangent_wheelset_rules__follow_gaps_t(double* result_0, double* result_1, double* result_2, double* result_3, array_double_1d left_tables, array_double_1d right_tables, array_double_1d work, array_double_1d work_t, double roll, double roll_t, double height, double height_t);
static inline int64_t tangent_wheelset_rules__follow_leaning_roll_t(double* roll, double* roll_rate, array_double_1d left_tables, array_double_1d right_tables, array_double_1d work, array_double_1d work_t);
static inline int64_t tangent_wheelset_rules__follow_position_t(array_double_1d left_tables, array_double_1d right_tables, array_double_1d work, array_double_1d work_t, array_double_1d state, double roll, double roll_t, double height, double height_t);
static inline int64_t tangent_wheelset_rules__follow_elastic_t(array_double_1d left_tables, array_double_1d right_tables, array_double_1d work, array_double_1d work_t, array_double_1d state);
static inline int64_t tangent_wheelset_rules__follow_compliant_t(array_double_1d left_tables, array_double_1d right_tables, array_double_1d work, array_double_1d work_t, array_double_1d state);
static inline int64_t tangent_wheelset_rules__follow_wheelset_t(array_double_1d left_tables, array_double_1d right_tables, array_double_1d work, array_double_1d work_t, array_double_1d state);
static inline int64_t tangent_wheelset_rules__follow_load_t(array_double_1d work, array_double_1d work_t);
static inline int64_t tangent_wheelset_rules__differentiate_t(array_double_1d left_tables, array_double_1d right_tables, array_double_1d work, array_double_1d work_t, array_double_1d state);

#endif
