/* Generated from tangent_friction.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of friction.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_FRICTION_H
#define WRCONTACT_KERNEL_TANGENT_FRICTION_H

#include "../native/spans.h"
#include "friction.h"
#include "layout.h"
#include "tangent_rates.h"
#include "tangent_shapes.h"

static inline int64_t tangent_friction__flange_share_t(double* result_0, double* result_1, array_double_1d tables, double angle, double angle_t);
static inline int64_t tangent_friction__patch_friction_t(double* found, double* found_t, array_double_1d tables, double friction, double friction_t, double angle, double angle_t, double sliding, double sliding_t);
static inline int64_t tangent_friction__multiply_creepages_t(array_double_1d work, array_double_1d work_t, int64_t patch, double factor, double factor_t);
static inline int64_t tangent_friction__reduce_slope_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t patch);

#endif
