/* Generated from search/roll.py by tools/transpile_kernel.py; change that one.
 *
 * The roll of the wheelset: the angle at which both wheels have the same smallest gap.
 *
 * D(roll) = gap_right - gap_left falls strictly while one flange is less steep than atan(2 arm / radius) (73 deg
 * for 750 mm and 460 mm), so a bracket and Newton's method with the envelope derivative cannot fail. Where it
 * has several roots, first_root.py decides which is the roll.
 *
 * Solve first, certify then: with two minima at hand Newton finds the roll that makes them equal, following each
 * one; at that roll both sides are searched for a smaller one. If there is none, this is the roll; otherwise the
 * smaller minima take over, within a bracket that every search narrows.
 */

#ifndef WRCONTACT_KERNEL_ROLL_H
#define WRCONTACT_KERNEL_ROLL_H

#include "../native/spans.h"
#include "cells.h"
#include "gap.h"
#include "layout.h"
#include "locus.h"
#include "rails.h"
#include "raster.h"
#include "smallest_gap.h"

static const double roll__ROLL_SHARP = 1e-14;
static const int64_t roll__SEARCHES = INT64_C(120);
static const double roll__EQUAL = 1e-09;
static const int64_t roll__NEWTON_STEPS = INT64_C(25);
static const double roll__LONGEST_TURN = 0.005;
static const double roll__LONGEST_MOVE = 0.005;
static const int64_t roll__FOLLOW_STEPS = INT64_C(8);
static const double roll__FOLLOW_REACH = 0.002;

static inline int64_t roll__restore_yaw(array_double_1d work, int64_t place);
static inline int64_t roll__turn_both(array_double_1d work, double roll);
static inline int64_t roll__lean_both(array_double_1d work, array_double_1d left_tables, array_double_1d right_tables, double roll);
static inline int64_t roll__place_both(array_double_1d work, array_double_1d left_tables, array_double_1d right_tables, double roll);
static inline int64_t roll__search_both(array_double_1d work, array_double_1d left_tables, array_double_1d right_tables, array_double_1d state, int64_t known);
static inline int64_t roll__keep_known(array_double_1d work, int64_t side, double y, double gap, double abscissa);
static inline int64_t roll__follow_side(array_double_1d work, array_double_1d tables, int64_t side, array_double_1d state);
static inline int64_t roll__newton_move(double* difference, double* move, array_double_1d work, array_double_1d left_tables, array_double_1d right_tables);
static inline int64_t roll__on_profiles(array_double_1d tables, double y, double abscissa);
static inline int64_t roll__equalize_minima(double* result_0_0001, int64_t* result_1_0001, array_double_1d work, array_double_1d left_tables, array_double_1d right_tables, array_double_1d state, double roll, double low, double high);
static inline int64_t roll__roll_between(double* result_0_0001, int64_t* result_1_0001, array_double_1d work, array_double_1d left_tables, array_double_1d right_tables, array_double_1d state, double roll, double first, double last, int64_t known);
static inline int64_t roll__any_roll(double* roll, int64_t* status, array_double_1d work, array_double_1d left_tables, array_double_1d right_tables, array_double_1d state, double guess, int64_t warm);

#endif
