/* A step on rails whose section changes along the track. */
#ifndef WRCONTACT_CHANGING_H
#define WRCONTACT_CHANGING_H

#include "wrcontact_kernel.h"

/* As wrcontact_step and wrcontact_step_many; they write to the handle's tables, which must be its own. */
WRCONTACT_EXPORT int wrcontact_step_changing(const wrcontact_handle *handle);
WRCONTACT_EXPORT int wrcontact_step_changing_many(const wrcontact_handle *handle, int64_t count, double *inputs,
                                                  double *outputs, double *statuses);

#endif
