/* Generated from tangent_rolling_patches.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of rolling_patches.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_ROLLING_PATCHES_H
#define WRCONTACT_KERNEL_TANGENT_ROLLING_PATCHES_H

#include "../native/spans.h"
#include "layout.h"
#include "rolling_patches.h"
#include "tangent_arc_length.h"
#include "tangent_profile_table.h"
#include "tangent_rails.h"
#include "tangent_sections.h"

static inline int64_t tangent_rolling_patches__place_strip_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t region, int64_t strip, double mirror, double mirror_t);
static inline int64_t tangent_rolling_patches__place_strips_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t region, int64_t patch, double mirror, double mirror_t);
static inline int64_t tangent_rolling_patches__keep_rolling_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t rolling, double mirror, double mirror_t);

#endif
