/* Generated from normal/strips.py by tools/transpile_kernel.py; change that one.
 *
 * The strip correction: ANALYN's patch, corrected by the elastic half-space (docs/method.md, section 9).
 *
 * The strips of ANALYN do not feel each other: the displacement of each is that of a Hertz ellipse with its own
 * curvatures.  Here the same strips, each with a pressure p sqrt(1 - (x/a)^2) along the track, press on one
 * half-space, eq. (S1):
 *
 * 1. place the strips over ANALYN's zone (strip_placement), and read gap and curvature there (strip_surfaces),
 * 2. solve sum_j F_ij y_j = penetration - g_i with y = h p / (pi E*) >= 0 and the given force, eq. (S5)
 *    (strip_pressures).  F_ij is how a strip j of half-length a_j displaces the middle line of strip i, eqs.
 *    (S2) and (S4) (strip_influence),
 * 3. correct every half-length by what the middle line's curvature along the track demands at its line load,
 *    eqs. (S6)-(S9) (strip_lengths), and cut the outermost strips at the edges of the patch (strip_edges).
 *
 * One round of 2 and 3 is a sweep.  Where the true patch differs from ANALYN's, strips lose their load or are
 * loaded.
 */

#ifndef WRCONTACT_KERNEL_STRIPS_H
#define WRCONTACT_KERNEL_STRIPS_H

#include "../native/spans.h"
#include "layout.h"
#include "strip_edges.h"
#include "strip_influence.h"
#include "strip_lengths.h"
#include "strip_pressures.h"

static inline int64_t strips__solve_strips(double* result_0, int64_t* result_1, array_double_1d work, array_double_1d tables, array_double_1d state, double force, int64_t by_penetration);

#endif
