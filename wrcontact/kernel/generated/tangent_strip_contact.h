/* Generated from tangent_strip_contact.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of strip_contact.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_STRIP_CONTACT_H
#define WRCONTACT_KERNEL_TANGENT_STRIP_CONTACT_H

#include "../native/spans.h"
#include "deep_points.h"
#include "layout.h"
#include "strip_contact.h"
#include "tangent_estimate.h"
#include "tangent_planes.h"
#include "tangent_pressed_regions.h"
#include "tangent_strip_patches.h"
#include "tangent_strip_zones.h"
#include "tangent_strips.h"

static inline int64_t tangent_strip_contact__open_zones_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state);
static inline int64_t tangent_strip_contact__strip_contact_t(double* result_0_0001, double* result_1_0001, int64_t* result_2, int64_t* result_3, array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, int64_t side, double force, double force_t, double prescribed, double prescribed_t);
static inline int64_t tangent_strip_contact__coarse_contact_t(double* penetration, double* penetration_t, int64_t* count, int64_t* satisfied, array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, double force, double force_t);

#endif
