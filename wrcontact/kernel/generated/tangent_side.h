/* Generated from tangent_side.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of side.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_SIDE_H
#define WRCONTACT_KERNEL_TANGENT_SIDE_H

#include "../native/spans.h"
#include "deep_points.h"
#include "layout.h"
#include "outlines.h"
#include "tangent_contact_point.h"
#include "tangent_followed_overlaps.h"
#include "tangent_gap.h"
#include "tangent_normal_contact.h"
#include "tangent_outline.h"
#include "tangent_outlines.h"
#include "tangent_overlaps.h"
#include "tangent_pressed_regions.h"
#include "tangent_resultant.h"
#include "tangent_rolling_patches.h"
#include "tangent_totals.h"

static inline int64_t tangent_side__clear_side_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t index);
static inline int64_t tangent_side__load_side_t(int64_t* count, int64_t* result_1, array_double_1d tables, array_double_1d work, array_double_1d work_t, array_double_1d state, int64_t index, double force, double force_t, double prescribed, double prescribed_t);
static inline int64_t tangent_side__touch_side_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, array_double_1d state, int64_t index);
static inline int64_t tangent_side__solve_side_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, array_double_1d state, int64_t index, double force, double force_t);
static inline int64_t tangent_side__find_points_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, int64_t side, int64_t index, double height, double height_t);
static inline int64_t tangent_side__press_side_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, array_double_1d state, int64_t index, double approach, double approach_t);
static inline int64_t tangent_side__side_lever_t(double* lever, double* lever_t, array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t index, int64_t count);

#endif
