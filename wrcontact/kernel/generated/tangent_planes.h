/* Generated from tangent_planes.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of planes.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_PLANES_H
#define WRCONTACT_KERNEL_TANGENT_PLANES_H

#include "../native/spans.h"
#include "layout.h"
#include "planes.h"
#include "regions.h"
#include "tangent_arc_length.h"
#include "tangent_contact_plane.h"
#include "tangent_locus.h"
#include "tangent_profile_table.h"
#include "tangent_regions.h"
#include "tangent_touching.h"
#include "tangent_traces.h"

static inline int64_t tangent_planes__keep_frame_t(array_double_1d work, array_double_1d work_t, int64_t slot);
static inline int64_t tangent_planes__use_frame_t(array_double_1d work, array_double_1d work_t, int64_t slot);
static inline int64_t tangent_planes__bound_abscissa_t(double* abscissa, double* abscissa_t, array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t region, array_double_1d state, double bound, double bound_t);
static inline int64_t tangent_planes__bound_station_t(double* station, double* station_t, array_double_1d work, array_double_1d work_t, array_double_1d tables, double abscissa, double abscissa_t);
static inline int64_t tangent_planes__own_plane_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t region, int64_t slot, array_double_1d state);
static inline int64_t tangent_planes__locate_along_track_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t count);
static inline int64_t tangent_planes__give_planes_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, int64_t count);
static inline int64_t tangent_planes__enter_plane_t(array_double_1d work, array_double_1d work_t, int64_t region, int64_t slot);
static inline int64_t tangent_planes__leave_plane_t(array_double_1d work, array_double_1d work_t, int64_t region);

#endif
