/* Generated from tangent_node_patches.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of node_patches.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_NODE_PATCHES_H
#define WRCONTACT_KERNEL_TANGENT_NODE_PATCHES_H

#include "../native/spans.h"
#include "layout.h"
#include "node_patches.h"
#include "tangent_analyn.h"
#include "tangent_filling.h"
#include "tangent_quadrature.h"
#include "tangent_rates.h"

static inline int64_t tangent_node_patches__fill_strips_t(array_double_1d work, array_double_1d work_t, int64_t region, int64_t nodes);
static inline int64_t tangent_node_patches__narrow_strips_t(array_double_1d work, array_double_1d work_t, int64_t inner, int64_t outer, double start, double start_t, double stop, double stop_t, double spacing, double spacing_t);
static inline int64_t tangent_node_patches__patch_from_t(array_double_1d work, array_double_1d work_t, int64_t region, double start, double start_t, int64_t strip, double contact_angle, double contact_angle_t);
static inline int64_t tangent_node_patches__add_load_t(double* load, double* load_t, double* moment, double* moment_t, array_double_1d work, array_double_1d work_t, int64_t totals, int64_t region, int64_t before, int64_t low, int64_t high, double start, double start_t, double stop, double stop_t, double step, double step_t);
static inline int64_t tangent_node_patches__peak_square_t(double* result_0, double* result_1, double before, double before_t, double square, double square_t, double after, double after_t);
static inline int64_t tangent_node_patches__keep_largest_t(array_double_1d work, array_double_1d work_t, int64_t strip);
static inline int64_t tangent_node_patches__add_cell_t(array_double_1d work, array_double_1d work_t, int64_t region, int64_t number, int64_t nodes, int64_t k, double contact_angle, double contact_angle_t);
static inline int64_t tangent_node_patches__fill_from_nodes_t(array_double_1d work, array_double_1d work_t, int64_t count);

#endif
