/* Generated from normal/strip_layout.py by tools/transpile_kernel.py; change that one.
 *
 * How the rail is divided into strips: evenly over the zones first, then by the pressure that was found.
 *
 * Pieces of the rail have weights.  Each run of pieces that touch gets as many strips as its weight is worth,
 * all of one weight, and no fewer than FEWEST: with less a patch has no shape.
 */

#ifndef WRCONTACT_KERNEL_STRIP_LAYOUT_H
#define WRCONTACT_KERNEL_STRIP_LAYOUT_H

#include "../native/spans.h"
#include "layout.h"

static const double strip_layout__FIRST_SHARE = 0.6666666666666666;
static const double strip_layout__DEEP = 0.5;
static const double strip_layout__EVEN = 0.5;
static const double strip_layout__LOADED = 0.1;
static const int64_t strip_layout__FEWEST = INT64_C(4);
static const double strip_layout__MORE = 0.5;
static const double strip_layout__TOUCHING = 1e-09;

static inline int64_t strip_layout__zone_cells(array_double_1d work, int64_t count);
static inline int64_t strip_layout__touch(array_double_1d work, int64_t count);
static inline double strip_layout__loaded_share(array_double_1d work, int64_t count, int64_t i, double largest);
static inline double strip_layout__pressure_changes(array_double_1d work, int64_t count, int64_t i);
static inline int64_t strip_layout__strip_cells(array_double_1d work);
static inline int64_t strip_layout__continued(array_double_1d work, int64_t index);
static inline int64_t strip_layout__run_of_cells(int64_t* last, double* weight, array_double_1d work, int64_t first);
static inline double strip_layout__run_stop(array_double_1d work, int64_t index);
static inline int64_t strip_layout__cut_run(array_double_1d work, int64_t first, int64_t made, int64_t number, double weight);
static inline int64_t strip_layout__place_in_regions(array_double_1d work, int64_t count, int64_t region_count);
static inline int64_t strip_layout__divide_cells(array_double_1d work, int64_t region_count, int64_t wanted);
static inline double strip_layout__cell_middle(array_double_1d work, int64_t cell);
static inline int64_t strip_layout__length_before(array_double_1d work);

#endif
