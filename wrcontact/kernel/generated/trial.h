/* Generated from wheelset/trial.py by tools/transpile_kernel.py; change that one.
 *
 * One trial of an elastic wheelset: both wheels pressed into their rails at one height and roll.
 *
 * Regions and nodes are placed where the wheel is at the height of the trial. With them the height
 * follows at which the side carries its force; the residual, how much lower than the trial that is,
 * vanishes in equilibrium.
 */

#ifndef WRCONTACT_KERNEL_TRIAL_H
#define WRCONTACT_KERNEL_TRIAL_H

#include "../native/spans.h"
#include "estimate.h"
#include "layout.h"
#include "roll.h"
#include "side.h"

static const double trial__SHALLOWEST = 0.1;
static const double trial__DEEPEST = 0.002;

static OUT_OF_LINE int64_t trial__estimate_approach(array_double_1d tables, array_double_1d work, array_double_1d state, int64_t index, double force);
static OUT_OF_LINE double trial__permitted_approach(array_double_1d work, int64_t support, int64_t side, double height);
static OUT_OF_LINE int64_t trial__balance_side(array_double_1d tables, array_double_1d work, array_double_1d state, int64_t index, double force, double height);
static OUT_OF_LINE int64_t trial__balance_both(array_double_1d left_tables, array_double_1d right_tables, array_double_1d work, array_double_1d state, double left, double right, double height);
static OUT_OF_LINE int64_t trial__turn_to(array_double_1d left_tables, array_double_1d right_tables, array_double_1d work, array_double_1d state, double roll);
static OUT_OF_LINE int64_t trial__turn_near(array_double_1d left_tables, array_double_1d right_tables, array_double_1d work, array_double_1d state, double roll);
static OUT_OF_LINE int64_t trial__depth_outcome(array_double_1d work, int64_t status);

#endif
