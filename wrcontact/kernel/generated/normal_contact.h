/* Generated from normal/normal_contact.py by tools/transpile_kernel.py; change that one.
 *
 * The normal contact of one side, by the model that is chosen: each one fills the solved patches.
 *
 * A further model is a file with a function like :func:`~.analyn_contact.analyn_contact`, and a line here.
 */

#ifndef WRCONTACT_KERNEL_NORMAL_CONTACT_H
#define WRCONTACT_KERNEL_NORMAL_CONTACT_H

#include "../native/spans.h"
#include "analyn_contact.h"
#include "hertz_contact.h"
#include "layout.h"
#include "strip_contact.h"

static inline int64_t normal_contact__solve_normal(double* penetration, int64_t* count, int64_t* satisfied, array_double_1d work, array_double_1d tables, array_double_1d state, int64_t side, int64_t point, double force, double prescribed);

#endif
