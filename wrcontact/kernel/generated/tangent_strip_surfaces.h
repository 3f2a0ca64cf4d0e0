/* Generated from tangent_strip_surfaces.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of strip_surfaces.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_STRIP_SURFACES_H
#define WRCONTACT_KERNEL_TANGENT_STRIP_SURFACES_H

#include "../native/spans.h"
#include "layout.h"
#include "strip_surfaces.h"
#include "tangent_arc_length.h"
#include "tangent_cubic.h"
#include "tangent_profile_table.h"
#include "tangent_rates.h"

static inline int64_t tangent_strip_surfaces__node_cell_t(int64_t* k, double* result_1, double* u_t, array_double_1d work, array_double_1d work_t, int64_t strip, int64_t region);
static inline int64_t tangent_strip_surfaces__read_surfaces_t(array_double_1d work, array_double_1d work_t, int64_t strip, int64_t region, int64_t nodes, int64_t k, double x, double x_t);
static inline int64_t tangent_strip_surfaces__incline_strips_t(array_double_1d work, array_double_1d work_t, array_double_1d tables);
static inline int64_t tangent_strip_surfaces__limit_lengths_t(array_double_1d work, array_double_1d work_t, int64_t count, double longest, double longest_t);
static inline int64_t tangent_strip_surfaces__load_one_t(array_double_1d work, array_double_1d work_t, int64_t count);
static inline int64_t tangent_strip_surfaces__describe_strips_t(array_double_1d work, array_double_1d work_t);

#endif
