/* Generated from motion/wheelset_motion.py by tools/transpile_kernel.py; change that one.
 *
 * The motion of a wheelset and its rails, from the inputs.
 *
 * Velocities are those in the track frame, whose origin runs along the track with the speed.  In a curve the
 * frame turns in space, and the rails stand still there.
 */

#ifndef WRCONTACT_KERNEL_WHEELSET_MOTION_H
#define WRCONTACT_KERNEL_WHEELSET_MOTION_H

#include "../native/spans.h"
#include "layout.h"

static inline int64_t wheelset_motion__is_rail_moderate(double lateral, double vertical, double roll);
static inline int64_t wheelset_motion__is_moderate(array_double_1d work);
static inline double wheelset_motion__rolling_rate(array_double_1d work, array_double_1d tables);
static inline int64_t wheelset_motion__open_motion(array_double_1d work, array_double_1d tables);
static inline int64_t wheelset_motion__open_rails(array_double_1d work, array_double_1d left_tables, array_double_1d right_tables);
static inline int64_t wheelset_motion__set_rates(array_double_1d work, double vertical, double roll_rate);

#endif
