/* Generated from tangent_filling.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of filling.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_FILLING_H
#define WRCONTACT_KERNEL_TANGENT_FILLING_H

#include "../native/spans.h"
#include "filling.h"
#include "layout.h"
#include "tangent_rates.h"

static inline int64_t tangent_filling__clear_totals_t(array_double_1d work, array_double_1d work_t, int64_t totals, double start, double start_t);
static inline int64_t tangent_filling__clear_patches_t(array_double_1d work, array_double_1d work_t);
static inline int64_t tangent_filling__place_patch_t(array_double_1d work, array_double_1d work_t, int64_t patch, int64_t region, int64_t first, int64_t rule, double contact_angle, double contact_angle_t);
static inline int64_t tangent_filling__begin_patch_t(array_double_1d work, array_double_1d work_t, int64_t region, double start, double start_t, int64_t first, int64_t rule, double contact_angle, double contact_angle_t);
static inline int64_t tangent_filling__add_part_t(array_double_1d work, array_double_1d work_t, int64_t patch, int64_t region, double load, double load_t, double moment, double moment_t);
static inline int64_t tangent_filling__fill_single_t(array_double_1d work, array_double_1d work_t);
static inline int64_t tangent_filling__complete_totals_t(array_double_1d work, array_double_1d work_t, int64_t totals);
static inline int64_t tangent_filling__finish_patch_t(array_double_1d work, array_double_1d work_t);
static inline int64_t tangent_filling__hand_part_t(array_double_1d work, array_double_1d work_t, int64_t number, int64_t heir);
static inline int64_t tangent_filling__remove_patch_t(array_double_1d work, array_double_1d work_t, int64_t index);
static inline int64_t tangent_filling__remove_unloaded_t(array_double_1d work, array_double_1d work_t);
static inline int64_t tangent_filling__finish_patches_t(array_double_1d work, array_double_1d work_t);

#endif
