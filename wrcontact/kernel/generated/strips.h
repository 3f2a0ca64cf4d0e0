/* Generated from normal/strips.py by tools/transpile_kernel.py; change that one.
 *
 * The strip model: strips of the rail that press on each other through the elastic half-space
 * (docs/method.md, section 9).
 *
 * Each strip has a place s_j along the rail, a middle x_j and a half-length a_j along the track, and the
 * pressure p_j sqrt(1 - ((x - x_j) / a_j)^2).  What it displaces is eq. (S1).  One round of
 *
 * 1. solve sum_j F_ij y_j = c_i penetration - g_i with y = h p / (pi E*) >= 0 and the given force, eq. (S5)
 *    (strip_pressures); F_ij is how strip j displaces the middle of strip i, eqs. (S2) and (S4)
 *    (strip_influence),
 * 2. correct every half-length by how much less the surface is displaced towards the ends of the strip than the
 *    gap rises, and let the middle move to where both ends are alike, eqs. (S6) and (S7) (strip_lengths)
 *
 * is a sweep.  Strips are laid twice (strip_layout): evenly over the overlap, and by the pressures that were
 * found.
 */

#ifndef WRCONTACT_KERNEL_STRIPS_H
#define WRCONTACT_KERNEL_STRIPS_H

#include "../native/spans.h"
#include "contact_plane.h"
#include "layout.h"
#include "strip_influence.h"
#include "strip_layout.h"
#include "strip_lengths.h"
#include "strip_pressures.h"
#include "strip_surfaces.h"

static const int64_t strips__FIRST_SWEEPS = INT64_C(1);

static inline int64_t strips__lay_strips(array_double_1d work, array_double_1d tables, array_double_1d state, int64_t count, int64_t wanted);
static inline int64_t strips__solve_strips(double* result_0, int64_t* result_1, array_double_1d work, array_double_1d tables, array_double_1d state, double force, int64_t by_penetration);
static inline int64_t strips__first_layout(double* result_0, int64_t* result_1, array_double_1d work, array_double_1d tables, array_double_1d state, int64_t count, double force, int64_t by_penetration);
static inline int64_t strips__second_layout(double* result_0, int64_t* result_1, array_double_1d work, array_double_1d tables, array_double_1d state, int64_t count, double force, int64_t by_penetration);

#endif
