/* Generated from wheelset/rolling_patches.py by tools/transpile_kernel.py; change that one.
 *
 * The patches of a wheel as the models of creep forces read them: cut into strips when they are solved, for
 * the solved patches of one wheel give way to those of the other.
 */

#ifndef WRCONTACT_KERNEL_ROLLING_PATCHES_H
#define WRCONTACT_KERNEL_ROLLING_PATCHES_H

#include "../native/spans.h"
#include "arc_length.h"
#include "layout.h"
#include "profile_table.h"
#include "rails.h"
#include "sections.h"

static inline int64_t rolling_patches__is_first_part(array_double_1d work, int64_t number);
static inline int64_t rolling_patches__place_strip(array_double_1d work, array_double_1d tables, int64_t region, int64_t strip, double mirror);
static inline int64_t rolling_patches__place_strips(array_double_1d work, array_double_1d tables, int64_t region, int64_t patch, double mirror);
static inline int64_t rolling_patches__keep_rolling(array_double_1d work, array_double_1d tables, int64_t rolling, double mirror);

#endif
