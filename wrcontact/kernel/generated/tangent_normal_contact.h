/* Generated from tangent_normal_contact.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of normal_contact.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_NORMAL_CONTACT_H
#define WRCONTACT_KERNEL_TANGENT_NORMAL_CONTACT_H

#include "../native/spans.h"
#include "layout.h"
#include "tangent_analyn_contact.h"
#include "tangent_hertz_contact.h"
#include "tangent_strip_contact.h"

static inline int64_t tangent_normal_contact__solve_normal_t(double* penetration, double* penetration_t, int64_t* count, int64_t* satisfied, array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, int64_t side, int64_t point, double force, double force_t, double prescribed, double prescribed_t);

#endif
