/* Generated from tangent_planes.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of planes.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_PLANES_H
#define WRCONTACT_KERNEL_TANGENT_PLANES_H

#include "../native/spans.h"
#include "layout.h"
#include "tangent_locus.h"

static inline int64_t tangent_planes__keep_frame_t(array_double_1d work, array_double_1d work_t, int64_t slot);
static inline int64_t tangent_planes__use_frame_t(array_double_1d work, array_double_1d work_t, int64_t slot);
static inline int64_t tangent_planes__locate_along_track_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t count);
static inline int64_t tangent_planes__enter_plane_t(array_double_1d work, array_double_1d work_t, int64_t region, int64_t slot);
static inline int64_t tangent_planes__leave_plane_t(array_double_1d work, array_double_1d work_t, int64_t region);

#endif
