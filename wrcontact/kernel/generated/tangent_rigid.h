/* Generated from tangent_rigid.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of rigid.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_RIGID_H
#define WRCONTACT_KERNEL_TANGENT_RIGID_H

#include "../native/spans.h"
#include "layout.h"
#include "requested.h"
#include "tangent_requested.h"
#include "tangent_resultant.h"
#include "tangent_side.h"

static inline int64_t tangent_rigid__solve_rigid_t(array_double_1d left_tables, array_double_1d right_tables, array_double_1d work, array_double_1d work_t, array_double_1d state, double roll, double roll_t);

#endif
