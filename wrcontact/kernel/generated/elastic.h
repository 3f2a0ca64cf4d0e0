/* Generated from wheelset/elastic.py by tools/transpile_kernel.py; change that one.
 *
 * Elastic equilibrium: the height and roll at which both wheels carry their loads.
 *
 * The wheels sink into their rails.  At a given roll each side has one height at which it carries its load; where these heights
 * are equal the wheelset stands.  Their difference D(roll) = height_right - height_left falls as that of the rigid gaps does
 * (:mod:`roll`), and a small load leaves the gaps themselves.  How a side's height follows the roll,
 *
 *     d height / d roll = sum k_i cos(angle_i) G_i / sum k_i cos(angle_i),
 *
 * is the mean of its regions' rigid levers G_i = gap_per_roll, weighted by their stiffnesses k_i: Newton's slope, by the
 * envelope theorem (docs/method.md, section 11).  Both unknowns are found by Broyden's method (Broyden 1965).
 *
 * Regions and nodes are laid where the wheels stand, which is found along with height and roll: a trial lays both wheels down at
 * one pose, and solves their loads; what either lacks of the height that it would carry its load at vanishes in equilibrium.
 * The compliant form is given height and roll,
 * and each wheel's load follows from how deep it stands.
 */

#ifndef WRCONTACT_KERNEL_ELASTIC_H
#define WRCONTACT_KERNEL_ELASTIC_H

#include "../native/spans.h"
#include "estimate.h"
#include "layout.h"
#include "roll.h"
#include "side.h"
#include "touching.h"

static const int64_t elastic__TRIALS = INT64_C(25);
static const int64_t elastic__BRACKETINGS = INT64_C(90);
static const double elastic__BRACKET_SHARP = 1e-13;
static const double elastic__FIRST_REACH = 2e-05;
static const double elastic__ELASTIC_SHARP = 1e-13;
static const double elastic__LONGEST = 0.0002;
static const double elastic__SINGULAR = 0.02;
static const double elastic__LEAST_LEVER = 0.01;
static const double elastic__SHALLOWEST = 0.1;
static const double elastic__DEEPEST = 0.002;
static const double elastic__GRAZING = 1e-13;

static OUT_OF_LINE int64_t elastic__first_sink(array_double_1d tables, array_double_1d work, array_double_1d state, int64_t index, double force);
static OUT_OF_LINE int64_t elastic__carry_side(array_double_1d tables, array_double_1d work, array_double_1d state, int64_t index, double force, double height);
static OUT_OF_LINE int64_t elastic__turn_to(array_double_1d tables, array_double_1d work, array_double_1d state, double roll);
static OUT_OF_LINE int64_t elastic__carry_both(array_double_1d tables, array_double_1d work, array_double_1d state, double left, double right, double height);
static OUT_OF_LINE int64_t elastic__too_deep(array_double_1d work, int64_t index);
static OUT_OF_LINE int64_t elastic__flatter_side(array_double_1d work);
static OUT_OF_LINE double elastic__carried_load(array_double_1d work, int64_t count);
static OUT_OF_LINE int64_t elastic__lay_side(double* lack, int64_t* met, int64_t* status, array_double_1d tables, array_double_1d work, array_double_1d state, int64_t index, double force, double height);
static OUT_OF_LINE double elastic__within_bracket(double low, double high, double at_low, double at_high, int64_t i);
static OUT_OF_LINE int64_t elastic__bracket_height(array_double_1d tables, array_double_1d work, array_double_1d state, int64_t index, double force);
static OUT_OF_LINE int64_t elastic__stand_at(double* lack, int64_t* met, int64_t* result_2, array_double_1d tables, array_double_1d work, array_double_1d state, double roll, double left, double right, int64_t flat);
static OUT_OF_LINE int64_t elastic__bracket_roll(double* result_0, int64_t* result_1, array_double_1d tables, array_double_1d work, array_double_1d state, double roll, double left, double right);
static OUT_OF_LINE int64_t elastic__solve_elastic(double* result_0, int64_t* result_1, array_double_1d tables, array_double_1d work, array_double_1d state, double roll, double left, double right);
static OUT_OF_LINE int64_t elastic__bear_side(array_double_1d tables, array_double_1d work, array_double_1d state, int64_t index, double height);
static OUT_OF_LINE int64_t elastic__stand_compliant(array_double_1d tables, array_double_1d work, array_double_1d state);

#endif
