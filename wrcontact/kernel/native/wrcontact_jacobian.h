/* Directional derivatives of a step along many directions at once: the step and the values are computed once for all of them. */
#ifndef WRCONTACT_JACOBIAN_H
#define WRCONTACT_JACOBIAN_H

#include "wrcontact_kernel.h"

/* Numbers of memory that derivatives along many directions need. */
WRCONTACT_EXPORT int64_t wrcontact_jacobian_room(void);

/* As wrcontact_derivative in wrcontact_derivative.h along `count` directions: row by row `seeds` has the rates at which the inputs
 * move, and `rates` gets those of the outputs. */
WRCONTACT_EXPORT int wrcontact_jacobian(const wrcontact_handle *handle, int64_t count, const double *seeds, double *rates,
                                        double *room);

#endif
