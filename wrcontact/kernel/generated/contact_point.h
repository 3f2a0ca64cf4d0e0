/* Generated from wheelset/contact_point.py by tools/transpile_kernel.py; change that one.
 *
 * The contact of one side, described: where it is on wheel, rail and track, its angle, radius and
 * curvatures.
 */

#ifndef WRCONTACT_KERNEL_CONTACT_POINT_H
#define WRCONTACT_KERNEL_CONTACT_POINT_H

#include "../native/spans.h"
#include "contact_plane.h"
#include "lateral_curvature.h"
#include "layout.h"
#include "locus.h"
#include "rails.h"
#include "regions.h"

static const double contact_point__PARALLEL = 1e-06;
static const double contact_point__CORNER = 0.001;
static const double contact_point__AT_END = 1e-08;

static inline int64_t contact_point__is_end(array_double_1d tables, int64_t profile, double y);
static inline int64_t contact_point__describe_contact(array_double_1d tables, array_double_1d work, array_double_1d state, int64_t index, double y, double aside, double shift);

#endif
