/* Generated from roll.py by tools/transpile_kernel.py; change that one.
 *
 * The roll of the wheelset: the angle at which both wheels have the same smallest gap.
 *
 * D(roll) = gap_right - gap_left falls strictly while flanges are less steep than atan(2 arm / radius) (73 deg for
 * 750 mm and 460 mm), so a bracket and Newton with the envelope derivative cannot fail.  D has kinks where minima exchange
 * rank; there the bracket takes over.
 */

#ifndef WRCONTACT_KERNEL_ROLL_H
#define WRCONTACT_KERNEL_ROLL_H

#include "../native/spans.h"
#include "gap.h"
#include "layout.h"
#include "locus.h"
#include "search.h"

static const double roll__ROLL_LIMIT = 0.12;
static const double roll__ROLL_SHARP = 1e-14;
static const int64_t roll__ROLL_ITERATIONS = INT64_C(80);

static int64_t roll__place_both(array_double_1d tables, array_double_1d work, double roll);
static int64_t roll__search_both(array_double_1d tables, array_double_1d work, array_double_1d state);
static int64_t roll__follow_both(array_double_1d tables, array_double_1d work, array_double_1d state);
static int64_t roll__solve_roll(double* result_0, int64_t* result_1_0001, array_double_1d tables, array_double_1d work, array_double_1d state, double guess);

#endif
