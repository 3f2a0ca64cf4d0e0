/* Generated from tangent_damping.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of damping.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_DAMPING_H
#define WRCONTACT_KERNEL_TANGENT_DAMPING_H

#include "../native/spans.h"
#include "layout.h"
#include "tangent_approach.h"

static inline int64_t tangent_damping__damping_factor_t(double* factor, double* factor_t, array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t patch, int64_t index);
static inline int64_t tangent_damping__damp_patch_t(array_double_1d work, array_double_1d work_t, int64_t patch, double factor, double factor_t);
static inline int64_t tangent_damping__damp_patches_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t index, int64_t resultant);

#endif
