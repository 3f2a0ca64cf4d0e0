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
#include "node_coefficients.h"
#include "planes.h"

static inline double hertz_contact__solve_hertz(array_double_1d work, array_double_1d tables, int64_t point, int64_t region, double force, double prescribed);
static inline int64_t hertz_contact__hertz_contact(double* penetration, int64_t* result_1, int64_t* result_2, array_double_1d work, array_double_1d tables, int64_t point, double force, double prescribed);

#endif
