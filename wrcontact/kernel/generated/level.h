/* Generated from search/level.py by tools/transpile_kernel.py; change that one.
 *
 * Where the wheels could stand at several rolls: the first one from level.
 *
 * While a flange is less steep than both levers allow, D(roll) = gap_right - gap_left (roll.py) falls and has one zero.  A large
 * wheel on a steep flange (600 mm on 70 deg), or strong yaw with both flanges on the rails, lets D rise in between, and it has
 * three.
 * The roll is then the first zero on the way from level to the side on which D(0) tells that there is one: it depends on nothing
 * but the pose, and D falls through it.
 *
 * That no zero lies before a known one is certified.  On that way the contact of the wheel that rises moves towards its flange and
 * the other's away from it, since rails are convex; so D' is bounded by the steepest places of the wheels between their contacts
 * at both ends of the way.  Where this does not settle it, the way is halved.
 */

#ifndef WRCONTACT_KERNEL_LEVEL_H
#define WRCONTACT_KERNEL_LEVEL_H

#include "../native/spans.h"
#include "layout.h"
#include "locus.h"
#include "profile_table.h"
#include "roll.h"
#include "search.h"

static const double level__APART = 1e-13;
static const int64_t level__TRIALS = INT64_C(300);
static const double level__TURNED_SHARE = 1.1;
static const double level__YAWED_SHARE = 1.2;
static const double level__FASTER = 1.5;
static const int64_t level__ENTRY_ROLL = INT64_C(0);
static const int64_t level__ENTRY_DIFFERENCE = INT64_C(1);
static const int64_t level__ENTRY_LEFT = INT64_C(2);
static const int64_t level__ENTRY_RIGHT = INT64_C(3);
static const int64_t level__ENTRY_SIZE = INT64_C(4);
static const int64_t level__ENTRY_LIMIT = INT64_C(60);
static const int64_t level__LEVEL = INT64_C(48973);
static const int64_t level__ENDS = INT64_C(48977);

static inline double level__turned(double steep, double radius, double arm);
static inline double level__lever_beyond(array_double_1d tables, double y, double roll, double sine);
static inline int64_t level__beside_rail(array_double_1d tables, array_double_1d work, int64_t at, double known, double roll, double sine);
static inline int64_t level__certainly_first(array_double_1d tables, array_double_1d work, array_double_1d state, double roll);
static inline int64_t level__falls_at_level(array_double_1d tables, array_double_1d work, double roll);
static inline double level__lever_at(array_double_1d tables, array_double_1d work, int64_t at, double y);
static inline int64_t level__lever_range(double* least, double* most, array_double_1d tables, array_double_1d work, array_double_1d state, int64_t at, double one, double other);
static inline int64_t level__note_entry(array_double_1d work, int64_t entry, double roll);
static inline int64_t level__is_clear(array_double_1d tables, array_double_1d work, array_double_1d state, int64_t near, int64_t far, double sign);
static inline int64_t level__first_from_level(double* result_0, int64_t* result_1, array_double_1d tables, array_double_1d work, array_double_1d state, double roll);
static inline int64_t level__certified_roll(double* roll, int64_t* status, array_double_1d tables, array_double_1d work, array_double_1d state, double guess, int64_t warm);
static inline int64_t level__solve_roll(double* roll, int64_t* status, array_double_1d tables, array_double_1d work, array_double_1d state, double guess, int64_t warm);

#endif
