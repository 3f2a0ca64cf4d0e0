/* Generated from tangent_hertz_contact.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of hertz_contact.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_HERTZ_CONTACT_H
#define WRCONTACT_KERNEL_TANGENT_HERTZ_CONTACT_H

#include "../native/spans.h"
#include "layout.h"
#include "node_coefficients.h"
#include "tangent_filling.h"
#include "tangent_hertz.h"
#include "tangent_planes.h"
#include "tangent_rates.h"

static inline int64_t tangent_hertz_contact__solve_hertz_t(double* penetration, double* penetration_t, array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t point, int64_t region, double force, double force_t, double prescribed, double prescribed_t);
static inline int64_t tangent_hertz_contact__hertz_contact_t(double* penetration, double* penetration_t, int64_t* result_2, int64_t* result_3, array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t point, double force, double force_t, double prescribed, double prescribed_t);

#endif
