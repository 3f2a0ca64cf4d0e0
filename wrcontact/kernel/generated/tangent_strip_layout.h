/* Generated from tangent_strip_layout.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of strip_layout.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_STRIP_LAYOUT_H
#define WRCONTACT_KERNEL_TANGENT_STRIP_LAYOUT_H

#include "../native/spans.h"
#include "layout.h"
#include "strip_layout.h"
#include "tangent_rates.h"

static inline int64_t tangent_strip_layout__zone_cells_t(array_double_1d work, array_double_1d work_t, int64_t count);
static inline int64_t tangent_strip_layout__touch_t(array_double_1d work, array_double_1d work_t, int64_t count);
static inline int64_t tangent_strip_layout__loaded_share_t(double* share, double* share_t, array_double_1d work, array_double_1d work_t, int64_t count, int64_t i, double largest, double largest_t);
static inline int64_t tangent_strip_layout__pressure_changes_t(double* change, double* change_t, array_double_1d work, array_double_1d work_t, int64_t count, int64_t i);
static inline int64_t tangent_strip_layout__strip_cells_t(array_double_1d work, array_double_1d work_t);
static inline int64_t tangent_strip_layout__run_of_cells_t(int64_t* last, double* weight, double* weight_t, array_double_1d work, array_double_1d work_t, int64_t first);
static inline int64_t tangent_strip_layout__run_stop_t(double* result_0, double* result_1, array_double_1d work, array_double_1d work_t, int64_t index);
static inline int64_t tangent_strip_layout__cut_run_t(array_double_1d work, array_double_1d work_t, int64_t first, int64_t made, int64_t number, double weight, double weight_t);
static inline int64_t tangent_strip_layout__place_in_regions_t(array_double_1d work, array_double_1d work_t, int64_t count, int64_t region_count);
static inline int64_t tangent_strip_layout__divide_cells_t(array_double_1d work, array_double_1d work_t, int64_t region_count, int64_t wanted);
static inline int64_t tangent_strip_layout__cell_middle_t(double* result_0, double* result_1, array_double_1d work, array_double_1d work_t, int64_t cell);
static inline int64_t tangent_strip_layout__length_before_t(array_double_1d work, array_double_1d work_t);

#endif
