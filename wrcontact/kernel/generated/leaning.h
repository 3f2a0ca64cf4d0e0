/* Generated from wheelset/leaning.py by tools/transpile_kernel.py; change that one.
 *
 * Rails that are rolled: the place of a wheelset over them holds for one vertical shift (surface/rails.py),
 * which is found together with the contact.
 *
 * The residual, how much lower the contact is found than the reference, falls at a rate of nearly one as the
 * reference rises. So the secant finds its root in three or four contacts.
 */

#ifndef WRCONTACT_KERNEL_LEANING_H
#define WRCONTACT_KERNEL_LEANING_H

#include "../native/spans.h"
#include "layout.h"

static const int64_t leaning__MEETINGS = INT64_C(20);
static const double leaning__RIGID_MET = 1e-14;
static const double leaning__ELASTIC_MET = 2e-13;
static const double leaning__STEEPEST_FALL = -2.0;
static const double leaning__FLATTEST_FALL = -0.5;

static inline int64_t leaning__set_reference(array_double_1d work, double height);
static inline int64_t leaning__is_leaning(array_double_1d work);
static inline int64_t leaning__open_reference(array_double_1d work, double height, double found);
static inline double leaning__next_reference(array_double_1d work);
static inline int64_t leaning__note_reference(array_double_1d work, double height, double found, double met);

#endif
