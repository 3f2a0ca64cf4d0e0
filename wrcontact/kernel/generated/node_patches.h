/* Generated from normal/node_patches.py by tools/transpile_kernel.py; change that one.
 *
 * From ANALYN's regions to solved patches: every node becomes a strip, every run of loaded cells a patch.
 *
 * Between the strips the line load and the squares of half-length and pressure follow quadratics
 * (:mod:`quadrature`), so that an ellipse comes out exactly.  A patch may reach over the bound between two
 * regions, and a region may hold two patches.
 */

#ifndef WRCONTACT_KERNEL_NODE_PATCHES_H
#define WRCONTACT_KERNEL_NODE_PATCHES_H

#include "../native/spans.h"
#include "analyn.h"
#include "filling.h"
#include "layout.h"
#include "quadrature.h"

static const double node_patches__JOINED = 1e-09;

static inline int64_t node_patches__fill_strips(array_double_1d work, int64_t region, int64_t nodes);
static inline int64_t node_patches__narrow_strips(array_double_1d work, int64_t inner, int64_t outer, double start, double stop, double spacing);
static inline int64_t node_patches__patch_from(array_double_1d work, int64_t region, double start, int64_t strip, double contact_angle);
static inline int64_t node_patches__add_load(double* load, double* moment, array_double_1d work, int64_t totals, int64_t region, int64_t before, int64_t low, int64_t high, double start, double stop, double step);
static inline double node_patches__peak_square(double before, double square, double after);
static inline int64_t node_patches__keep_largest(array_double_1d work, int64_t strip);
static inline int64_t node_patches__add_cell(array_double_1d work, int64_t region, int64_t number, int64_t nodes, int64_t k, double contact_angle);
static inline int64_t node_patches__fill_from_nodes(array_double_1d work, int64_t count);

#endif
