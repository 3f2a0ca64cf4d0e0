/* Generated from elastic.py by tools/transpile_kernel.py; change that one.
 *
 * Elastic equilibrium: the height and roll at which both wheels carry their loads.
 *
 * The wheels sink into their rails.  At a given roll each side has one height at which it carries its load; where these heights
 * are equal the wheelset stands.  Their difference D(roll) = height_right - height_left falls as that of the rigid gaps does
 * (:mod:`roll`), and a small load leaves the gaps themselves.  How a side's height follows the roll,
 *
 *     d height / d roll = sum k_i cos(angle_i) G_i / sum k_i cos(angle_i),
 *
 * is the mean of its regions' rigid levers G_i = gap_per_roll, weighted by their stiffnesses k_i: Newton's slope.
 *
 * Regions and nodes are laid for the depth that a side has sunk to, which is found along with the roll: every trial of the
 * roll presses each wheel as deep as the one before found, and solves its load.  The compliant form is given height and roll,
 * and each wheel's load follows from how deep it stands.
 */

#ifndef WRCONTACT_KERNEL_ELASTIC_H
#define WRCONTACT_KERNEL_ELASTIC_H

#include "../native/spans.h"
#include "contact_plane.h"
#include "gap.h"
#include "layout.h"
#include "locus.h"
#include "normal_contact.h"
#include "profile_table.h"
#include "resultant.h"
#include "roll.h"
#include "search.h"
#include "side.h"

static const int64_t elastic__TRIALS = INT64_C(90);
static const double elastic__ELASTIC_SHARP = 1e-12;
static const double elastic__SETTLED = 1e-07;
static const double elastic__SMALLEST = 1e-15;
static const int64_t elastic__FROZEN = INT64_C(20);
static const double elastic__ELASTIC_TURN = 0.005;
static const double elastic__SLOPE_FACTOR = 2.0;
static const double elastic__SLOPE_APART = 1e-10;
static const double elastic__JUMP_SHARP = 1e-13;
static const double elastic__DEEPEST = 0.002;
static const int64_t elastic__FOLLOW_STEPS = INT64_C(8);
static const double elastic__FOLLOW_REACH = 0.002;

static inline int64_t elastic__first_sink(double* sink, int64_t* status, array_double_1d tables, array_double_1d work, array_double_1d state, int64_t index, double force);
static inline int64_t elastic__carry_side(array_double_1d tables, array_double_1d work, array_double_1d state, int64_t index, double force);
static inline int64_t elastic__settled_side(array_double_1d work, int64_t index);
static inline int64_t elastic__follow_side(array_double_1d tables, array_double_1d work, array_double_1d state, int64_t index);
static inline int64_t elastic__turn_to(array_double_1d tables, array_double_1d work, array_double_1d state, double roll);
static inline int64_t elastic__carry_both(array_double_1d tables, array_double_1d work, array_double_1d state, double left, double right);
static inline int64_t elastic__solve_elastic(double* result_0_0001, int64_t* result_1_0001, array_double_1d tables, array_double_1d work, array_double_1d state, double roll, double left, double right);
static inline int64_t elastic__bear_side(array_double_1d tables, array_double_1d work, array_double_1d state, int64_t index, double height);
static inline int64_t elastic__stand_compliant(array_double_1d tables, array_double_1d work, array_double_1d state);

#endif
