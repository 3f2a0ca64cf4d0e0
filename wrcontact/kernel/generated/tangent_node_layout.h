/* Generated from tangent_node_layout.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of node_layout.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_NODE_LAYOUT_H
#define WRCONTACT_KERNEL_TANGENT_NODE_LAYOUT_H

#include "../native/spans.h"
#include "contact_plane.h"
#include "layout.h"
#include "node_coefficients.h"
#include "node_layout.h"
#include "nodes.h"
#include "tangent_hertz.h"
#include "tangent_mean_normal.h"
#include "tangent_node_coefficients.h"
#include "tangent_nodes.h"
#include "tangent_planes.h"
#include "tangent_rates.h"
#include "tangent_widths.h"

static inline int64_t tangent_node_layout__zone_share_t(double* share, double* share_t, array_double_1d tables, double A, double A_t, double side, double side_t);
static inline int64_t tangent_node_layout__node_spacing_t(double* spacing, double* spacing_t, array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t region, double enlarge, double enlarge_t);
static inline int64_t tangent_node_layout__prepare_nodes_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, int64_t region, int64_t nodes, double enlarge, double enlarge_t);
static inline int64_t tangent_node_layout__prepare_regions_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, int64_t count, double enlarge, double enlarge_t);

#endif
