/* Generated from search/first_root.py by tools/transpile_kernel.py; change that one.
 *
 * Which roll of several: the first root of the difference of both gaps, starting from zero roll.
 *
 * While a flange is less steep than both levers allow, D(roll) = gap_right - gap_left (roll.py) falls
 * and has one root. A large wheel on a steep flange (600 mm on 70 deg), or strong yaw with both flanges
 * on the rails, lets D rise in between, and it has three. The roll is then the first root on the way
 * from zero roll to the side on which the sign of D(0) says that there is one: it depends on nothing but
 * the pose, and D falls through it.
 *
 * That no root lies before a known one is certified. On that way the contact of the wheel that rises
 * moves towards its flange and the other's away from it, since rails are convex; so D' is bounded by the
 * steepest places of the wheels between their contacts at both ends of the way. Where this does not
 * settle it, the way is halved.
 */

#ifndef WRCONTACT_KERNEL_FIRST_ROOT_H
#define WRCONTACT_KERNEL_FIRST_ROOT_H

#include "../native/spans.h"
#include "layout.h"
#include "locus.h"
#include "profile_table.h"
#include "raster.h"
#include "roll.h"
#include "smallest_gap.h"

static const double first_root__APART = 1e-13;
static const int64_t first_root__TRIALS = INT64_C(300);
static const double first_root__TURNED_SHARE = 1.1;
static const double first_root__YAWED_SHARE = 1.2;
static const double first_root__LEANING_SHARE = 1.1;
static const double first_root__FASTER = 1.5;

static inline int64_t first_root__falls_at_zero_roll(array_double_1d work, array_double_1d left_tables, array_double_1d right_tables, double roll);
static inline double first_root__lever_per_roll(double steep, double radius, double arm);
static inline double first_root__largest_lever_beyond(array_double_1d tables, double y, double roll, double sine);
static inline int64_t first_root__is_beside_rail(array_double_1d work, array_double_1d tables, int64_t at, double known, double roll, double sine);
static inline int64_t first_root__falls_from_zero_roll(array_double_1d work, array_double_1d tables, int64_t index, array_double_1d state, double known, double roll, double turned);
static inline int64_t first_root__is_certainly_first(array_double_1d work, array_double_1d left_tables, array_double_1d right_tables, array_double_1d state, double roll);
static inline int64_t first_root__note_trial(array_double_1d work, int64_t trial, double roll);
static inline int64_t first_root__note_root(array_double_1d work, int64_t trial, double roll);
static inline double first_root__lever_at(array_double_1d work, array_double_1d tables, int64_t at, double y);
static inline int64_t first_root__lever_range(double* least, double* most, array_double_1d work, array_double_1d tables, array_double_1d state, int64_t at, double one, double other);
static inline int64_t first_root__has_no_root(array_double_1d work, array_double_1d left_tables, array_double_1d right_tables, array_double_1d state, int64_t near, int64_t far, double sign);
static inline int64_t first_root__copy_trial(array_double_1d work, int64_t trial, int64_t to);
static inline int64_t first_root__root_before(double* result_0, int64_t* result_1, array_double_1d work, array_double_1d left_tables, array_double_1d right_tables, array_double_1d state, double near, double middle, double sign);
static inline int64_t first_root__first_root(double* result_0, int64_t* result_1, array_double_1d work, array_double_1d left_tables, array_double_1d right_tables, array_double_1d state, double roll);
static inline int64_t first_root__certified_roll(double* roll, int64_t* status, array_double_1d work, array_double_1d left_tables, array_double_1d right_tables, array_double_1d state, double guess, int64_t warm);
static inline int64_t first_root__solve_roll(double* roll, int64_t* status, array_double_1d work, array_double_1d left_tables, array_double_1d right_tables, array_double_1d state, double guess, int64_t warm);

#endif
