/* Generated from tangential/dissipation.py by tools/transpile_kernel.py; change that one.
 *
 * Friction takes power: what a model would give back is taken out of its result.
 *
 * In steady rolling elastic deformation takes no power in sum, and over the rolling speed friction takes
 *
 *     P = -(xi F_x + eta F_y + phi M + sum_i (w_i - xi + phi y_i) F_x,i)                             (W1)
 *
 * with the longitudinal creepages w_i of the strips.  The complete theory has P >= 0, and so have the models
 * almost everywhere: in one of some thousand cases, with spin and long patches, P is a little below zero.  There
 * the moment is reduced, as far as it drives, and then the force along the slip.  Neither becomes larger, and
 * both stay continuous.
 */

#ifndef WRCONTACT_KERNEL_DISSIPATION_H
#define WRCONTACT_KERNEL_DISSIPATION_H

#include "../native/spans.h"
#include "layout.h"

static inline double dissipation__bent_gain(array_double_1d work, int64_t rolling);
static inline double dissipation__smaller(double one, double other);
static inline int64_t dissipation__keep_dissipating(array_double_1d work, int64_t rolling);

#endif
