/* Generated from tangent_friction_load.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of friction_load.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_FRICTION_LOAD_H
#define WRCONTACT_KERNEL_TANGENT_FRICTION_LOAD_H

#include "../native/spans.h"
#include "layout.h"

static inline int64_t tangent_friction_load__carried_share_t(double* share, double* share_t, array_double_1d work, array_double_1d work_t, int64_t index);

#endif
