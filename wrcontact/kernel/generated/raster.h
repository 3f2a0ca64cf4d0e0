/* Generated from search/raster.py by tools/transpile_kernel.py; change that one.
 *
 * The wheel's outline over the rail, at the nodes of the raster and at the ends of the rail.
 */

#ifndef WRCONTACT_KERNEL_RASTER_H
#define WRCONTACT_KERNEL_RASTER_H

#include "../native/spans.h"
#include "gap.h"
#include "layout.h"
#include "locus.h"
#include "profile_table.h"

static const double raster__REACH_SHARE = 1.2;
static const double raster__REACH_ROLL = 0.06;
static const double raster__END_SHARP = 1e-09;

static inline int64_t raster__node_below(array_double_1d tables, int64_t scan, double y);
static inline int64_t raster__node_gap(double* result_0, double* result_1, double* abscissa, array_double_1d work, array_double_1d tables, int64_t at, int64_t node);
static inline double raster__rail_below(array_double_1d work, array_double_1d tables, int64_t at, double y);
static inline int64_t raster__leaves_rail(array_double_1d work, array_double_1d tables, int64_t at, int64_t node, int64_t direction, double abscissa);
static inline double raster__above_rail_end(array_double_1d work, array_double_1d tables, int64_t at, int64_t node, int64_t outward);

#endif
