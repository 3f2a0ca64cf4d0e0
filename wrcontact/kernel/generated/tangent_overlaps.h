/* Generated from tangent_overlaps.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of overlaps.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_OVERLAPS_H
#define WRCONTACT_KERNEL_TANGENT_OVERLAPS_H

#include "../native/spans.h"
#include "layout.h"
#include "overlaps.h"
#include "tangent_contact_plane.h"
#include "tangent_locus.h"
#include "tangent_planes.h"
#include "tangent_pressed.h"
#include "tangent_profile_table.h"
#include "tangent_regions.h"

static inline int64_t tangent_overlaps__keep_deepest_t(array_double_1d work, array_double_1d work_t);
static inline int64_t tangent_overlaps__touching_shift_t(double* result_0, double* result_1, double* result_2, double* result_3, array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t at, int64_t entry, double height, double height_t);
static inline int64_t tangent_overlaps__press_frame_t(array_double_1d work, array_double_1d work_t, double height, double height_t, double depth, double depth_t, double gap, double gap_t);
static inline int64_t tangent_overlaps__gather_overlaps_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, array_double_1d state);
static inline int64_t tangent_overlaps__turning_rule_t(double* place, double* place_t, double* result_2, double* result_3, double* overlap, double* overlap_t, int64_t* found, array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t at, double x, double x_t, double y, double y_t, double height, double height_t);
static inline int64_t tangent_overlaps__overlaps_rule_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, array_double_1d state, int64_t side, int64_t at, double height, double height_t);

#endif
