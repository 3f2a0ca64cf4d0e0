/* Generated from normal/strip_contact.py by tools/transpile_kernel.py; change that one.
 *
 * The contact of one side by strips (docs/method.md, section 9).
 */

#ifndef WRCONTACT_KERNEL_STRIP_CONTACT_H
#define WRCONTACT_KERNEL_STRIP_CONTACT_H

#include "../native/spans.h"
#include "deep_points.h"
#include "estimate.h"
#include "layout.h"
#include "planes.h"
#include "pressed_regions.h"
#include "strip_patches.h"
#include "strip_zones.h"
#include "strips.h"

static const double strip_contact__DEEPER = 1.15;
static const int64_t strip_contact__SINKINGS = INT64_C(4);

static inline int64_t strip_contact__open_zones(array_double_1d work, array_double_1d tables, array_double_1d state);
static inline int64_t strip_contact__strip_contact(double* result_0_0001, int64_t* result_1, int64_t* result_2, array_double_1d work, array_double_1d tables, array_double_1d state, int64_t side, double force, double prescribed);
static inline int64_t strip_contact__coarse_contact(double* penetration, int64_t* count, int64_t* satisfied, array_double_1d work, array_double_1d tables, array_double_1d state, double force);

#endif
