/* Generated from normal/strip_surfaces.py by tools/transpile_kernel.py; change that one.
 *
 * What the surfaces are at each strip: gap, curvature, and ANALYN's half-length and coefficients, read from
 * the region's nodes.
 */

#ifndef WRCONTACT_KERNEL_STRIP_SURFACES_H
#define WRCONTACT_KERNEL_STRIP_SURFACES_H

#include "../native/spans.h"
#include "arc_length.h"
#include "cubic.h"
#include "layout.h"
#include "profile_table.h"

static const double strip_surfaces__SHORTEST = 0.1;
static const double strip_surfaces__INSIDE = 0.3;
static const double strip_surfaces__SQUARE = 0.5;

static inline int64_t strip_surfaces__node_cell(int64_t* k, double* result_1, array_double_1d work, int64_t strip, int64_t region);
static inline int64_t strip_surfaces__read_surfaces(array_double_1d work, int64_t strip, int64_t region, int64_t nodes, int64_t k, double x);
static inline int64_t strip_surfaces__incline_strips(array_double_1d work, array_double_1d tables);
static inline int64_t strip_surfaces__limit_lengths(array_double_1d work, int64_t count, double longest);
static inline int64_t strip_surfaces__load_one(array_double_1d work, int64_t count);
static inline int64_t strip_surfaces__describe_strips(array_double_1d work);

#endif
