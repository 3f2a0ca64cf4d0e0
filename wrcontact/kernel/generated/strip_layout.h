/* Generated from normal/strip_layout.py by tools/transpile_kernel.py; change that one.
 *
 * How the rail is divided into strips: evenly over the zones first, then by the pressure that was found.
 *
 * The places of the strips follow the pose without jumps: pieces of the rail have weights that do, and strips
 * of one weight are cut from them, one after the other.  A strip that reaches over a hole between two pieces is
 * cut in two.
 */

#ifndef WRCONTACT_KERNEL_STRIP_LAYOUT_H
#define WRCONTACT_KERNEL_STRIP_LAYOUT_H

#include "../native/spans.h"
#include "layout.h"

static const double strip_layout__FIRST_SHARE = 0.6666666666666666;
static const double strip_layout__DEEP = 0.5;
static const double strip_layout__EVEN = 0.5;
static const double strip_layout__LOADED = 0.1;
static const double strip_layout__TOUCHING = 1e-09;

static inline int64_t strip_layout__zone_cells(array_double_1d work, int64_t count);
static inline int64_t strip_layout__touch(array_double_1d work, int64_t count);
static inline double strip_layout__loaded_share(array_double_1d work, int64_t count, int64_t i, double largest);
static inline double strip_layout__pressure_changes(array_double_1d work, int64_t count, int64_t i);
static inline int64_t strip_layout__strip_cells(array_double_1d work);
static inline int64_t strip_layout__cut_strip(array_double_1d work, int64_t i, double start, double stop);
static inline int64_t strip_layout__place_in_regions(array_double_1d work, int64_t count, int64_t region_count);
static inline int64_t strip_layout__divide_cells(array_double_1d work, int64_t region_count, int64_t wanted);
static inline double strip_layout__cell_middle(array_double_1d work, int64_t cell);
static inline int64_t strip_layout__length_before(array_double_1d work);

#endif
