/* Generated from tangent_sections.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of sections.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_SECTIONS_H
#define WRCONTACT_KERNEL_TANGENT_SECTIONS_H

#include "../native/spans.h"
#include "layout.h"
#include "sections.h"
#include "tangent_rates.h"

static inline int64_t tangent_sections__describe_ellipse_t(array_double_1d work, array_double_1d work_t, int64_t totals, int64_t rolling);
static inline int64_t tangent_sections__lay_strips_t(array_double_1d work, array_double_1d work_t, int64_t rolling, double start, double start_t, double stop, double stop_t);
static inline int64_t tangent_sections__cut_ellipse_t(array_double_1d work, array_double_1d work_t, int64_t totals, int64_t rolling);
static inline int64_t tangent_sections__add_piece_t(array_double_1d work, array_double_1d work_t, int64_t rolling, int64_t at, double low, double low_t, double low_square, double low_square_t, double low_load, double low_load_t, double high, double high_t, double high_square, double high_square_t, double high_load, double high_load_t);
static inline int64_t tangent_sections__cut_strips_t(array_double_1d work, array_double_1d work_t, int64_t patch, int64_t rolling);
static inline int64_t tangent_sections__finish_strips_t(array_double_1d work, array_double_1d work_t, int64_t rolling, double centroid, double centroid_t, double slant, double slant_t);
static inline int64_t tangent_sections__plane_slips_t(array_double_1d work, array_double_1d work_t, int64_t rolling);
static inline int64_t tangent_sections__cut_patch_t(array_double_1d work, array_double_1d work_t, int64_t index, int64_t rolling);

#endif
