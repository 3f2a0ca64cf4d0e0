/* Generated from tangent_requested.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of requested.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_REQUESTED_H
#define WRCONTACT_KERNEL_TANGENT_REQUESTED_H

#include "../native/spans.h"
#include "layout.h"
#include "requested.h"
#include "tangent_outlines.h"

static inline int64_t tangent_requested__side_force_t(double* result_0, double* result_1, array_double_1d work, array_double_1d work_t, int64_t index);
static inline int64_t tangent_requested__omit_from_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t index, int64_t first);
static inline int64_t tangent_requested__omit_outputs_t(array_double_1d tables, array_double_1d work, array_double_1d work_t);

#endif
