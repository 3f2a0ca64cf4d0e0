/* Generated from tangent_contact_point.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of contact_point.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_CONTACT_POINT_H
#define WRCONTACT_KERNEL_TANGENT_CONTACT_POINT_H

#include "../native/spans.h"
#include "contact_point.h"
#include "layout.h"
#include "tangent_contact_plane.h"
#include "tangent_lateral_curvature.h"
#include "tangent_locus.h"
#include "tangent_rails.h"
#include "tangent_regions.h"

static inline int64_t tangent_contact_point__describe_contact_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, array_double_1d state, int64_t index, double y, double y_t, double aside, double aside_t, double shift, double shift_t);

#endif
