/* Generated from tangential/dissipation.py by tools/transpile_kernel.py; change that one.
 *
 * Friction takes power: where a model would give some back, its moment is changed.
 *
 * In steady rolling elastic deformation takes no power in sum, and over the rolling speed friction takes
 *
 *     P = -(xi F_x + eta F_y + phi M + sum_i (w_i - xi + phi y_i) F_x,i)                             (W1)
 *
 * with the longitudinal creepages w_i of the strips.  The complete theory has P >= 0, and so have the models
 * almost everywhere.  In one of some thousand cases, with spin on long patches, the error of the moment makes P
 * negative; there the moment is the one with P = 0.  Forces stay as they are, and nothing jumps.
 */

#ifndef WRCONTACT_KERNEL_DISSIPATION_H
#define WRCONTACT_KERNEL_DISSIPATION_H

#include "../native/spans.h"
#include "layout.h"

static inline double dissipation__bent_gain(array_double_1d work, int64_t rolling);
static inline int64_t dissipation__keep_dissipating(array_double_1d work, int64_t rolling);

#endif
