/* Generated from wheelset/brackets.py by tools/transpile_kernel.py; change that one.
 *
 * Elastic equilibrium by brackets around brackets: slow, and it cannot fail while the
 * flatter wheel carries its load.
 *
 * A steep flange may carry its load at several heights of one roll, or at none that is not too deep; at the
 * height of the other wheel its load has one value at every roll. So the flatter wheel gives the height of each
 * roll, and the steeper one the residual that changes its sign at the roll in equilibrium. Where that jumps,
 * since a region comes or goes, the roll of the jump is taken.
 */

#ifndef WRCONTACT_KERNEL_BRACKETS_H
#define WRCONTACT_KERNEL_BRACKETS_H

#include "../native/spans.h"
#include "layout.h"
#include "side.h"
#include "trial.h"

static const int64_t brackets__BRACKETINGS = INT64_C(90);
static const double brackets__BRACKET_SHARP = 1e-13;
static const double brackets__FIRST_REACH = 2e-05;
static const double brackets__DEEPER = 1.5;

static OUT_OF_LINE double brackets__next_in_bracket(array_double_1d work, int64_t bracket, int64_t i);
static OUT_OF_LINE int64_t brackets__narrow_bracket(array_double_1d work, int64_t bracket, double place, double value);
static OUT_OF_LINE double brackets__carried_load(array_double_1d work, int64_t count);
static OUT_OF_LINE int64_t brackets__height_residual(double* residual, int64_t* satisfied, int64_t* status, array_double_1d tables, array_double_1d work, array_double_1d state, int64_t index, double force, double height);
static OUT_OF_LINE int64_t brackets__bracket_height(array_double_1d tables, array_double_1d work, array_double_1d state, int64_t index, double force);
static OUT_OF_LINE int64_t brackets__flatter_side(array_double_1d work);
static OUT_OF_LINE int64_t brackets__level_residual(double* residual, int64_t* satisfied, int64_t* status, array_double_1d flat_tables, array_double_1d steep_tables, array_double_1d work, array_double_1d state, int64_t flat, double flat_force, double steep_force);
static OUT_OF_LINE int64_t brackets__roll_residual(double* residual, int64_t* satisfied, int64_t* result_2, array_double_1d left_tables, array_double_1d right_tables, array_double_1d work, array_double_1d state, double roll, double left, double right, int64_t flat);
static OUT_OF_LINE int64_t brackets__enclose_roll(array_double_1d left_tables, array_double_1d right_tables, array_double_1d work, array_double_1d state, double roll, double left, double right, int64_t flat);
static OUT_OF_LINE int64_t brackets__bracket_roll(double* result_0, int64_t* status, array_double_1d left_tables, array_double_1d right_tables, array_double_1d work, array_double_1d state, double roll, double left, double right);

#endif
