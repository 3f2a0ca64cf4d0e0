/* Generated from prepare/arcs.py by tools/transpile_kernel.py; change that one.
 *
 * Tables of the rail's arc length over its abscissa, and of the abscissa over the arc length.
 *
 * Cubics of Hermite over even cells: value and slope at the ends of a cell are exact.
 */

#ifndef WRCONTACT_KERNEL_PREPARE_ARCS_H
#define WRCONTACT_KERNEL_PREPARE_ARCS_H

#include "../native/spans.h"
#include "layout.h"
#include "prepare_curvatures.h"
#include "prepare_pieces.h"
#include "profile_table.h"

static const double prepare_arcs__ARC_STEP = 0.0001;

static inline int64_t prepare_arcs__open_table(int64_t* cells, int64_t* result_1, array_double_1d tables, int64_t base, double start, double length);
static inline int64_t prepare_arcs__write_cubic(array_double_1d tables, int64_t base, int64_t cell, double low, double high, double low_rise, double high_rise);
static inline double prepare_arcs__rail_speed(array_double_1d tables, int64_t rail, double abscissa);
static inline int64_t prepare_arcs__write_arcs(array_double_1d tables, int64_t base, int64_t rail, array_double_1d work, int64_t scratch);
static inline int64_t prepare_arcs__write_abscissae(array_double_1d tables, int64_t base, int64_t rail, array_double_1d work, int64_t scratch);

#endif
