/* Generated from wheelset/leaning.py by tools/transpile_kernel.py; change that one.
 *
 * Rails that are rolled: the place of a wheelset over them holds for one vertical shift (surface/rails.py),
 * which is found together with the contact.
 *
 * The residual, how much lower the contact is found than the reference, falls at a rate of nearly one as the
 * reference rises. So the secant finds its root in three or four contacts.
 *
 * Where a wheel is about to pass from one place to another, as from the flange root to the flange, the contact
 * falls faster than the reference rises, or jumps, and the secant wanders. Then the root is enclosed about the
 * first contact and halved, so that rounding does not decide which of several is found. If it is a jump, no
 * height is its own reference, and the end with the smaller residual is the answer: its wheels touch as if the
 * wheelset were shifted by the residual times the sine of the rail's roll.
 */

#ifndef WRCONTACT_KERNEL_LEANING_H
#define WRCONTACT_KERNEL_LEANING_H

#include "../native/spans.h"
#include "brackets.h"
#include "layout.h"

static const int64_t leaning__MEETINGS = INT64_C(80);
static const double leaning__SECANTS = 10.0;
static const double leaning__NEARER = 0.5;
static const double leaning__FARTHEST = 0.004;
static const double leaning__BESIDE = 1e-09;
static const double leaning__UNKNOWN = 1.0;
static const double leaning__RIGID_MET = 1e-14;
static const double leaning__ELASTIC_MET = 2e-13;
static const double leaning__STEEPEST_FALL = -2.0;
static const double leaning__FLATTEST_FALL = -0.5;

static inline int64_t leaning__set_reference(array_double_1d work, double height);
static inline int64_t leaning__is_leaning(array_double_1d work);
static inline int64_t leaning__open_reference(array_double_1d work, double height, double found);
static inline double leaning__next_reference(array_double_1d work, double met);
static inline int64_t leaning__note_reference(array_double_1d work, double height, double found, double met);

#endif
