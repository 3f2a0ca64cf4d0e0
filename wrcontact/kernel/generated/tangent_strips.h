/* Generated from tangent_strips.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of strips.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_STRIPS_H
#define WRCONTACT_KERNEL_TANGENT_STRIPS_H

#include "../native/spans.h"
#include "contact_plane.h"
#include "layout.h"
#include "strip_layout.h"
#include "strip_lengths.h"
#include "strips.h"
#include "tangent_strip_influence.h"
#include "tangent_strip_layout.h"
#include "tangent_strip_lengths.h"
#include "tangent_strip_pressures.h"
#include "tangent_strip_surfaces.h"

static inline int64_t tangent_strips__lay_strips_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, int64_t count, int64_t wanted);
static inline int64_t tangent_strips__solve_strips_t(double* r1, double* r1_t, int64_t* r2, array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, double force, double force_t, int64_t by_penetration);
static inline int64_t tangent_strips__first_layout_t(double* result_0, double* result_1, int64_t* result_2, array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, int64_t count, double force, double force_t, int64_t by_penetration);
static inline int64_t tangent_strips__second_layout_t(double* result_0, double* result_1, int64_t* result_2, array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, int64_t count, double force, double force_t, int64_t by_penetration);

#endif
