/* Generated from tangent_roll.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of roll.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_ROLL_H
#define WRCONTACT_KERNEL_TANGENT_ROLL_H

#include "../native/spans.h"
#include "layout.h"
#include "tangent_locus.h"
#include "tangent_rails.h"

static inline int64_t tangent_roll__restore_yaw_t(array_double_1d work, array_double_1d work_t, int64_t place);
static inline int64_t tangent_roll__turn_both_t(array_double_1d work, array_double_1d work_t, double roll, double roll_t);
static inline int64_t tangent_roll__lean_both_t(array_double_1d work, array_double_1d work_t, array_double_1d left_tables, array_double_1d right_tables, double roll, double roll_t);
static inline int64_t tangent_roll__place_both_t(array_double_1d work, array_double_1d work_t, array_double_1d left_tables, array_double_1d right_tables, double roll, double roll_t);

#endif
