/* Generated from normal/hertz_contact.py by tools/transpile_kernel.py; change that one.
 *
 * Hertz's contact of one side in closed form: one elliptic patch with the curvatures at the contact point.
 */

#ifndef WRCONTACT_KERNEL_HERTZ_CONTACT_H
#define WRCONTACT_KERNEL_HERTZ_CONTACT_H

#include "../native/spans.h"
#include "filling.h"
#include "hertz.h"
#include "layout.h"
#include "nodes.h"

static inline double hertz_contact__solve_hertz(array_double_1d work, array_double_1d tables, int64_t point, int64_t region, double force, double prescribed);

#endif
