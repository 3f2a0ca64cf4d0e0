/* Generated from wheelset/rigid.py by tools/transpile_kernel.py; change that one.
 *
 * Rigid contact: the roll at which both wheels touch, and the load that each carries there.
 */

#ifndef WRCONTACT_KERNEL_RIGID_H
#define WRCONTACT_KERNEL_RIGID_H

#include "../native/spans.h"
#include "first_root.h"
#include "layout.h"
#include "leaning.h"
#include "requested.h"
#include "resultant.h"
#include "side.h"
#include "starts.h"

static const double rigid__NEAR_SHIFT = 0.0002;

static inline int64_t rigid__find_leaning_roll(double* result_0_0001, int64_t* result_1_0001, array_double_1d left_tables, array_double_1d right_tables, array_double_1d work, array_double_1d state, double roll);
static inline int64_t rigid__find_roll(double* roll, int64_t* status, array_double_1d left_tables, array_double_1d right_tables, array_double_1d work, array_double_1d state);
static inline int64_t rigid__solve_rigid(array_double_1d left_tables, array_double_1d right_tables, array_double_1d work, array_double_1d state, double roll);
static inline int64_t rigid__keep_roll(array_double_1d work, array_double_1d state, double roll);

#endif
