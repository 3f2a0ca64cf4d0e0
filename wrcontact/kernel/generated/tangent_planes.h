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
#include "tangent_contact_plane.h"
#include "tangent_pressed.h"
#include "tangent_profile_table.h"
#include "tangent_regions.h"
#include "tangent_touching.h"

static inline int64_t tangent_planes__keep_frame_t(array_double_1d work, array_double_1d work_t, int64_t slot);
static inline int64_t tangent_planes__use_frame_t(array_double_1d work, array_double_1d work_t, int64_t slot);
static inline int64_t tangent_planes__bound_abscissa_t(double* abscissa, double* abscissa_t, array_double_1d tables, array_double_1d work, array_double_1d work_t, array_double_1d state, int64_t block, double bound, double bound_t);
static inline int64_t tangent_planes__bound_station_t(double* station, double* station_t, array_double_1d tables, array_double_1d work, array_double_1d work_t, double abscissa, double abscissa_t);
static inline int64_t tangent_planes__own_plane_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, array_double_1d state, int64_t region);
static inline int64_t tangent_planes__line_up_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t count);
static inline int64_t tangent_planes__give_planes_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, array_double_1d state, int64_t count);
static inline int64_t tangent_planes__enter_plane_t(array_double_1d work, array_double_1d work_t, int64_t region);
static inline int64_t tangent_planes__leave_plane_t(array_double_1d work, array_double_1d work_t, int64_t region);

#endif
