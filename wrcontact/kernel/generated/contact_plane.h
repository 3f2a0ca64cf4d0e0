/* Generated from contact/contact_plane.py by tools/transpile_kernel.py; change that one.
 *
 * The plane of a contact, and the gap of wheel and rail along its normal.
 */

#ifndef WRCONTACT_KERNEL_CONTACT_PLANE_H
#define WRCONTACT_KERNEL_CONTACT_PLANE_H

#include "../native/spans.h"
#include "gap.h"
#include "layout.h"
#include "locus.h"
#include "profile_table.h"
#include "traces.h"

static const double contact_plane__NO_GAP = 1.0;

static inline int64_t contact_plane__open_frame(double* z, double* slope, double* y_track, double* rail_slope, double* mismatch, array_double_1d work, array_double_1d tables, int64_t place, double y, double aside, double shift);
static inline int64_t contact_plane__normal_gap(double* gap, double* result_1, double* result_2, double* curvature, array_double_1d work, array_double_1d tables, array_double_1d state, double station, double tolerance);
static inline int64_t contact_plane__is_yawed(array_double_1d work);

#endif
