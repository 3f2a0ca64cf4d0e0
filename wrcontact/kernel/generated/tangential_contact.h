/* Generated from tangential/tangential_contact.py by tools/transpile_kernel.py; change that one.
 *
 * The creep force of a patch by the chosen model.
 */

#ifndef WRCONTACT_KERNEL_TANGENTIAL_CONTACT_H
#define WRCONTACT_KERNEL_TANGENTIAL_CONTACT_H

#include "../native/spans.h"
#include "coupled_strips.h"
#include "dissipation.h"
#include "fastrip.h"
#include "fastsim.h"
#include "layout.h"
#include "polach.h"

static inline int64_t tangential_contact__clear_found(array_double_1d work, int64_t rolling);
static inline int64_t tangential_contact__mirror_rolling(array_double_1d work, int64_t rolling);
static inline int64_t tangential_contact__solve_tangential(array_double_1d work, array_double_1d tables, int64_t rolling);

#endif
