/* Generated from tangent_strips.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of strips.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_STRIPS_H
#define WRCONTACT_KERNEL_TANGENT_STRIPS_H

#include "../native/spans.h"
#include "layout.h"
#include "tangent_strip_edges.h"
#include "tangent_strip_influence.h"
#include "tangent_strip_lengths.h"
#include "tangent_strip_pressures.h"

static inline int64_t tangent_strips__solve_strips_t(double* result_0, double* result_1, int64_t* result_2, array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, double force, double force_t, int64_t by_penetration);

#endif
