/* Generated from wheelset/side.py by tools/transpile_kernel.py; change that one.
 *
 * One side of a wheelset, from where its wheel is to its outputs: contact, patches, and its
 * share of the resultant.
 */

#ifndef WRCONTACT_KERNEL_SIDE_H
#define WRCONTACT_KERNEL_SIDE_H

#include "../native/spans.h"
#include "contact_point.h"
#include "deep_points.h"
#include "followed_overlaps.h"
#include "gap.h"
#include "layout.h"
#include "normal_contact.h"
#include "outline.h"
#include "outlines.h"
#include "overlaps.h"
#include "pressed_regions.h"
#include "resultant.h"
#include "rolling_patches.h"
#include "totals.h"

static inline int64_t side__clear_side(array_double_1d tables, array_double_1d work, int64_t index);
static inline int64_t side__load_side(int64_t* count, int64_t* result_1, array_double_1d tables, array_double_1d work, array_double_1d state, int64_t index, double force, double prescribed);
static inline int64_t side__touch_side(array_double_1d tables, array_double_1d work, array_double_1d state, int64_t index);
static inline int64_t side__solve_side(array_double_1d tables, array_double_1d work, array_double_1d state, int64_t index, double force);
static inline int64_t side__find_points(array_double_1d work, array_double_1d tables, array_double_1d state, int64_t side, int64_t index, double height);
static inline int64_t side__press_side(array_double_1d tables, array_double_1d work, array_double_1d state, int64_t index, double approach);
static inline double side__side_lever(array_double_1d tables, array_double_1d work, int64_t index, int64_t count);

#endif
