/* Generated from wheelset/elastic.py by tools/transpile_kernel.py; change that one.
 *
 * Elastic equilibrium: the height and roll at which both wheels carry their loads.
 *
 * The wheels are pressed into their rails. At a given roll each side has one height at which it carries its
 * load; where these heights are equal the wheelset is in equilibrium. Their difference D(roll) = height_right -
 * height_left falls as that of the rigid gaps does (:mod:`roll`), and a small load leaves the gaps themselves.
 * How a side's height follows the roll,
 *
 *     d height / d roll = sum k_i cos(angle_i) G_i / sum k_i cos(angle_i),
 *
 * is the mean of its regions' rigid levers G_i = gap_per_roll, weighted by their stiffnesses k_i: Newton's
 * slope, by the envelope theorem (docs/method.md, section 11).
 *
 * Both unknowns are found by Broyden's method (Broyden 1965), in trials (trial.py); where it finds
 * nothing, by brackets (brackets.py).
 */

#ifndef WRCONTACT_KERNEL_ELASTIC_H
#define WRCONTACT_KERNEL_ELASTIC_H

#include "../native/spans.h"
#include "brackets.h"
#include "layout.h"
#include "side.h"
#include "touching.h"
#include "trial.h"

static const int64_t elastic__TRIALS = INT64_C(25);
static const double elastic__ELASTIC_SHARP = 1e-13;
static const double elastic__UNBALANCED = 1e-09;
static const double elastic__NOT_LAST = 1e-10;
static const double elastic__COARSE = 2e-06;
static const double elastic__LONGEST = 0.0002;
static const double elastic__SINGULAR = 0.02;
static const double elastic__LEAST_LEVER = 0.01;

static OUT_OF_LINE int64_t elastic__first_estimate(double* height, double* move, array_double_1d left_tables, array_double_1d right_tables, array_double_1d work);
static OUT_OF_LINE int64_t elastic__begin_derivatives(array_double_1d work, double arm);
static OUT_OF_LINE int64_t elastic__update(array_double_1d work, double height);
static OUT_OF_LINE int64_t elastic__find_move(array_double_1d work, double arm);
static OUT_OF_LINE int64_t elastic__gaps_hold(array_double_1d left_tables, array_double_1d right_tables, array_double_1d work, array_double_1d state, double roll);
static OUT_OF_LINE int64_t elastic__iterate(double* result_0_0001, int64_t* result_1_0001, array_double_1d left_tables, array_double_1d right_tables, array_double_1d work, array_double_1d state, double roll, double height, double left, double right);
static OUT_OF_LINE int64_t elastic__solve_elastic(double* result_0, int64_t* result_1, array_double_1d left_tables, array_double_1d right_tables, array_double_1d work, array_double_1d state, double roll, double left, double right);

#endif
