/* Generated from wheelset/moving.py by tools/transpile_kernel.py; change that one.
 *
 * The motion of a wheelset whose contact is solved: its velocities, and the creepages of its patches.
 */

#ifndef WRCONTACT_KERNEL_MOVING_H
#define WRCONTACT_KERNEL_MOVING_H

#include "../native/spans.h"
#include "contact_rates.h"
#include "creepage.h"
#include "layout.h"
#include "requested.h"
#include "side.h"
#include "wheelset_motion.h"

static inline int64_t moving__is_rolling(array_double_1d work);
static inline int64_t moving__open_given_motion(array_double_1d left_tables, array_double_1d right_tables, array_double_1d work);
static inline int64_t moving__constrain_side(array_double_1d tables, array_double_1d work, array_double_1d state, int64_t index);
static inline int64_t moving__write_creepages(array_double_1d left_tables, array_double_1d right_tables, array_double_1d work, array_double_1d state);

#endif
