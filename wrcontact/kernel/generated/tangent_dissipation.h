/* Generated from tangent_dissipation.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of dissipation.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_DISSIPATION_H
#define WRCONTACT_KERNEL_TANGENT_DISSIPATION_H

#include "../native/spans.h"
#include "layout.h"

static inline int64_t tangent_dissipation__bent_gain_t(double* gain, double* gain_t, array_double_1d work, array_double_1d work_t, int64_t rolling);
static inline int64_t tangent_dissipation__keep_dissipating_t(array_double_1d work, array_double_1d work_t, int64_t rolling);

#endif
