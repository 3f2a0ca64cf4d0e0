/* Generated from tangent_wear_outline.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of wear_outline.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_WEAR_OUTLINE_H
#define WRCONTACT_KERNEL_TANGENT_WEAR_OUTLINE_H

#include "../native/spans.h"
#include "layout.h"
#include "tangent_rates.h"

static inline int64_t tangent_wear_outline__strip_shear_t(double* shear, double* shear_t, array_double_1d work, array_double_1d work_t, int64_t strip);
static inline int64_t tangent_wear_outline__strip_slip_t(double* slip, double* slip_t, array_double_1d work, array_double_1d work_t, int64_t patch, int64_t strip);
static inline int64_t tangent_wear_outline__write_patch_wear_t(array_double_1d work, array_double_1d work_t, int64_t outline, int64_t stations, int64_t patch);
static inline int64_t tangent_wear_outline__write_wear_t(array_double_1d work, array_double_1d work_t, int64_t outline, int64_t stations, int64_t rolling);

#endif
