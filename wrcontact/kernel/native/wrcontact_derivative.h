/* How the outputs of a step move with its inputs: the directional derivative, by a kernel with a rate beside every value.
 *
 * The caller owns all memory; nothing is allocated.
 */
#ifndef WRCONTACT_TANGENT_H
#define WRCONTACT_TANGENT_H

#include "wrcontact_kernel.h"

/* Numbers of memory that a directional derivative needs. */
WRCONTACT_EXPORT int64_t wrcontact_derivative_room(void);

/* Rates of all outputs of the step at handle->inputs, where each input moves at its rate in `seed`; the status of that step.
 *
 * The step starts where handle->state says and is made in `room`, wrcontact_derivative_room() numbers, of which nothing is kept;
 * the handle's own arrays are left as they are.  Where the status is neither 0 nor 1 the outputs are held: rates are 0.  Where
 * no equation tells how the outputs move they are differences between steps; they are always finite. */
WRCONTACT_EXPORT int wrcontact_derivative(const wrcontact_handle *handle, const double *seed, double *rates, double *room);

#endif
