/* Generated from tangent_moving.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of moving.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_MOVING_H
#define WRCONTACT_KERNEL_TANGENT_MOVING_H

#include "../native/spans.h"
#include "layout.h"
#include "requested.h"
#include "tangent_contact_rates.h"
#include "tangent_creepage.h"
#include "tangent_side.h"
#include "tangent_wheelset_motion.h"

static inline int64_t tangent_moving__open_given_motion_t(array_double_1d left_tables, array_double_1d right_tables, array_double_1d work, array_double_1d work_t);
static inline int64_t tangent_moving__constrain_side_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, array_double_1d state, int64_t index);
static inline int64_t tangent_moving__write_creepages_t(array_double_1d left_tables, array_double_1d right_tables, array_double_1d work, array_double_1d work_t, array_double_1d state);

#endif
