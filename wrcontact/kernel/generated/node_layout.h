/* Generated from normal/node_layout.py by tools/transpile_kernel.py; change that one.
 *
 * Where the nodes of regions lie: spacing from the width of the interpenetration, as far as the gap says that
 * strips are loaded.
 */

#ifndef WRCONTACT_KERNEL_NODE_LAYOUT_H
#define WRCONTACT_KERNEL_NODE_LAYOUT_H

#include "../native/spans.h"
#include "contact_plane.h"
#include "hertz.h"
#include "layout.h"
#include "mean_normal.h"
#include "node_coefficients.h"
#include "nodes.h"
#include "planes.h"
#include "regions.h"
#include "widths.h"

static const double node_layout__MEASURED = 0.9;
static const double node_layout__COVER = 1.1;
static const double node_layout__SPREAD = 1.25;
static const double node_layout__NARROWEST = 0.01;
static const double node_layout__WIDEST = 110.0;

static inline double node_layout__zone_share(array_double_1d tables, double A, double side);
static inline double node_layout__node_spacing(array_double_1d work, array_double_1d tables, int64_t region, double enlarge);
static inline int64_t node_layout__prepare_nodes(array_double_1d work, array_double_1d tables, array_double_1d state, int64_t region, int64_t nodes, double enlarge);
static inline int64_t node_layout__prepare_regions(array_double_1d work, array_double_1d tables, array_double_1d state, int64_t count, double enlarge);
static inline int64_t node_layout__covered(array_double_1d work, int64_t count);

#endif
