/* Generated from patch/filling.py by tools/transpile_kernel.py; change that one.
 *
 * How a model of normal contact fills the solved patches: one after the other by rising station, then totals
 * and ranks.
 */

#ifndef WRCONTACT_KERNEL_FILLING_H
#define WRCONTACT_KERNEL_FILLING_H

#include "../native/spans.h"
#include "layout.h"

static inline int64_t filling__clear_totals(array_double_1d work, int64_t totals, double start);
static inline int64_t filling__clear_patches(array_double_1d work);
static inline int64_t filling__place_patch(array_double_1d work, int64_t patch, int64_t region, int64_t first, int64_t rule, double contact_angle);
static inline int64_t filling__begin_patch(array_double_1d work, int64_t region, double start, int64_t first, int64_t rule, double contact_angle);
static inline int64_t filling__add_part(array_double_1d work, int64_t patch, int64_t region, double load, double moment);
static inline int64_t filling__fill_single(array_double_1d work);
static inline int64_t filling__complete_totals(array_double_1d work, int64_t totals);
static inline int64_t filling__finish_patch(array_double_1d work);
static inline int64_t filling__hand_part(array_double_1d work, int64_t number, int64_t heir);
static inline int64_t filling__remove_patch(array_double_1d work, int64_t index);
static inline int64_t filling__remove_unloaded(array_double_1d work);
static inline int64_t filling__heaviest_patch(array_double_1d work);
static inline int64_t filling__finish_patches(array_double_1d work);

#endif
