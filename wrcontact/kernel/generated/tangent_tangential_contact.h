/* Generated from tangent_tangential_contact.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of tangential_contact.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_TANGENTIAL_CONTACT_H
#define WRCONTACT_KERNEL_TANGENT_TANGENTIAL_CONTACT_H

#include "../native/spans.h"
#include "layout.h"
#include "tangent_coupled_strips.h"
#include "tangent_dissipation.h"
#include "tangent_fastrip.h"
#include "tangent_fastsim.h"
#include "tangent_polach.h"

static inline int64_t tangent_tangential_contact__clear_found_t(array_double_1d work, array_double_1d work_t, int64_t rolling);
static inline int64_t tangent_tangential_contact__mirror_rolling_t(array_double_1d work, array_double_1d work_t, int64_t rolling);
static inline int64_t tangent_tangential_contact__solve_tangential_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t rolling);

#endif
