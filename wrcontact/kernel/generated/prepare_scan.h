/* Generated from prepare/scan.py by tools/transpile_kernel.py; change that one.
 *
 * The search's raster over the wheel, with the bounds that certify it.
 *
 * The table is the record Scan. Scratch holds, for each piece of the profile at work, the smallest and largest
 * second derivative and the largest absolute slope of its samples.
 */

#ifndef WRCONTACT_KERNEL_PREPARE_SCAN_H
#define WRCONTACT_KERNEL_PREPARE_SCAN_H

#include "../native/spans.h"
#include "bounds.h"
#include "layout.h"
#include "prepare_pieces.h"
#include "profile_table.h"

static const double prepare_scan__COARSE_STEP = 0.001;
static const double prepare_scan__FINE_STEP = 0.0005;
static const double prepare_scan__STRAIGHT = 20.0;
static const double prepare_scan__TOO_STEEP = 1000000000.0;
static const int64_t prepare_scan__LAST_SAMPLE = INT64_C(16);
static const int64_t prepare_scan__TOO_WIDE = INT64_C(-2);
static const double prepare_scan__FAR = 1e+300;

static inline int64_t prepare_scan__first_piece(array_double_1d tables, int64_t base);
static inline int64_t prepare_scan__piece_count(array_double_1d tables, int64_t base);
static inline double prepare_scan__piece_width(array_double_1d tables, int64_t base, int64_t at);
static inline int64_t prepare_scan__slope_bend(double* slope, double* bend, array_double_1d tables, int64_t at, double u);
static inline int64_t prepare_scan__piece_range(double* least, double* most, double* steepest, array_double_1d tables, int64_t at, double width, double low, double high);
static inline int64_t prepare_scan__sample_pieces(array_double_1d tables, int64_t base, array_double_1d work, int64_t scratch);
static inline int64_t prepare_scan__bend_range(double* least, double* most, double* steepest, array_double_1d tables, int64_t base, array_double_1d work, int64_t scratch, double low, double high);
static inline int64_t prepare_scan__coarse_count(double start, double stop);
static inline double prepare_scan__raster_place(double start, double stop, int64_t count, int64_t i);
static inline int64_t prepare_scan__write_raster(array_double_1d tables, int64_t scan, array_double_1d work, int64_t scratch, int64_t firsts);
static inline int64_t prepare_scan__write_wheel_bounds(array_double_1d tables, int64_t scan, int64_t count, array_double_1d work, int64_t scratch);
static inline int64_t prepare_scan__write_levers(array_double_1d tables, int64_t scan, int64_t count);
static inline int64_t prepare_scan__write_rail_bounds(array_double_1d tables, int64_t scan, array_double_1d work, int64_t scratch);
static inline int64_t prepare_scan__write_scan(array_double_1d tables, array_double_1d work, int64_t scratch);

#endif
