/* Generated from wheelset/requested.py by tools/transpile_kernel.py; change that one.
 *
 * What is asked of a step: whether its inputs can be evaluated, each side's force, and which
 * outputs are requested.
 */

#ifndef WRCONTACT_KERNEL_REQUESTED_H
#define WRCONTACT_KERNEL_REQUESTED_H

#include "../native/spans.h"
#include "friction.h"
#include "layout.h"
#include "outlines.h"
#include "wheelset_motion.h"

static inline int64_t requested__is_rail_far(array_double_1d work);
static inline int64_t requested__check_inputs(array_double_1d work, array_double_1d tables);
static inline double requested__side_force(array_double_1d work, int64_t index);
static inline int64_t requested__is_requested(array_double_1d tables, int64_t index);
static inline int64_t requested__first_omitted(array_double_1d tables);
static inline int64_t requested__omit_from(array_double_1d tables, array_double_1d work, int64_t index, int64_t first);
static inline int64_t requested__omit_outputs(array_double_1d tables, array_double_1d work);

#endif
