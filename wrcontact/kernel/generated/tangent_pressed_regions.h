/* Generated from tangent_pressed_regions.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of pressed_regions.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_PRESSED_REGIONS_H
#define WRCONTACT_KERNEL_TANGENT_PRESSED_REGIONS_H

#include "../native/spans.h"
#include "deep_points.h"
#include "layout.h"
#include "regions.h"
#include "tangent_arc_length.h"
#include "tangent_contact_plane.h"
#include "tangent_locus.h"
#include "tangent_overlaps.h"
#include "tangent_planes.h"
#include "tangent_pressed.h"
#include "tangent_profile_table.h"
#include "tangent_regions.h"
#include "tangent_traces.h"

static inline int64_t tangent_pressed_regions__touching_shift_t(double* result_0, double* result_1, double* result_2, double* result_3, array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t place, int64_t point);
static inline int64_t tangent_pressed_regions__press_frame_t(array_double_1d work, array_double_1d work_t, double height, double height_t, double depth, double depth_t, double gap, double gap_t);
static inline int64_t tangent_pressed_regions__sink_wheel_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t side, array_double_1d state, double penetration, double penetration_t);
static inline int64_t tangent_pressed_regions__sink_deeper_t(array_double_1d work, array_double_1d work_t, int64_t count, double penetration, double penetration_t);
static inline int64_t tangent_pressed_regions__open_pressed_region_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t region, int64_t point);
static inline int64_t tangent_pressed_regions__give_own_frame_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t region, int64_t point);
static inline int64_t tangent_pressed_regions__gather_overlaps_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state);

#endif
