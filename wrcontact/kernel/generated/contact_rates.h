/* Generated from motion/contact_rates.py by tools/transpile_kernel.py; change that one.
 *
 * Vertical velocity and roll rate of a wheelset that stays on both rails.
 *
 * A wheel that stays in contact moves along the plane of the contact: the velocity of its surface against the
 * rail has no part along the normal n.  With the velocity v of the wheelset's centre and its rotation W this is
 *
 *     n . v + ((P - C) x n) . W = the same for the rail
 *
 * at each wheel, two linear equations for the two that are not given.  The rotation about the axle is left out:
 * it does not move the surface of a round wheel, whose normal goes through the axle.
 */

#ifndef WRCONTACT_KERNEL_CONTACT_RATES_H
#define WRCONTACT_KERNEL_CONTACT_RATES_H

#include "../native/spans.h"
#include "layout.h"

static inline int64_t contact_rates__touching_constraint(array_double_1d work, int64_t side, double mirror, int64_t constraint);
static inline int64_t contact_rates__loaded_constraint(array_double_1d work, int64_t side, int64_t constraint);
static inline double contact_rates__known_part(array_double_1d work, int64_t index);
static inline int64_t contact_rates__contact_rates(double* vertical, double* roll_rate, array_double_1d work);

#endif
