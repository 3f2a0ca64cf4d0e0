/* Generated from wheelset/damping.py by tools/transpile_kernel.py; change that one.
 *
 * Contact damping of a compliant wheelset: forces grow with the speed of the approach.
 *
 * The force of a patch is multiplied by 1 + d a, with the contact damping d [s/m] and the speed a [m/s] at which
 * wheel and rail approach each other along the patch's normal at its centre of load; it is never below zero.
 * Areas and pressures stay those of the elastic contact.
 */

#ifndef WRCONTACT_KERNEL_DAMPING_H
#define WRCONTACT_KERNEL_DAMPING_H

#include "../native/spans.h"
#include "approach.h"
#include "layout.h"

static inline int64_t damping__is_damped(array_double_1d tables);
static inline double damping__damping_factor(array_double_1d work, array_double_1d tables, int64_t patch, int64_t index);
static inline int64_t damping__damp_patch(array_double_1d work, int64_t patch, double factor);
static inline int64_t damping__damp_patches(array_double_1d work, array_double_1d tables, int64_t index, int64_t resultant);

#endif
