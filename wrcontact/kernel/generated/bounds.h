/* Generated from search/bounds.py by tools/transpile_kernel.py; change that one.
 *
 * How far the gap can fall: bounds of its second derivative between nodes of the raster.
 *
 * Along the wheel the slope difference rail - outline rises by no less than m = rail'' - wheel'', each but for
 * its share, and the gap changes by that slope times the outline's stretch 1 +- w. Both second derivatives are
 * bounded in the tables over stretches of 2^k cells. The shares are compared with dense sampling in
 * tests/search/test_rigid.py.
 */

#ifndef WRCONTACT_KERNEL_BOUNDS_H
#define WRCONTACT_KERNEL_BOUNDS_H

#include "../native/spans.h"
#include "layout.h"
#include "raster.h"

static const double bounds__YAWED_SHARE = 0.3;
static const double bounds__STRETCHED_SHARE = 10.0;
static const double bounds__ROLLED_SHARE = 0.02;
static const double bounds__STEEP = 3.0;
static const double bounds__ROLL_STRETCH = 3.1;
static const double bounds__BEND_STRETCH = 1.1;
static const double bounds__STEEP_STRETCH = 10.0;
static const double bounds__ROLL_BEND = 9.5;
static const double bounds__YAW_BEND = 18.0;
static const double bounds__WIDEST = 0.25;
static const double bounds__FINE_CELL = 0.000501;

static inline double bounds__rail_place(array_double_1d tables, int64_t scan, double abscissa);
static inline int64_t bounds__rail_index(array_double_1d tables, int64_t scan, double u);
static inline int64_t bounds__least_bend(double* bend, double* stretch, array_double_1d tables, array_double_1d work, int64_t scan, int64_t at, int64_t first, int64_t exponent, double length, double u);
static inline int64_t bounds__stretch_bend(double* length, double* bend, double* stretch, array_double_1d tables, array_double_1d work, int64_t scan, int64_t at, int64_t node, int64_t direction, int64_t exponent, double u);
static inline double bounds__largest_fall(double slope, double bend, double length, double stretch);
static ALWAYS_INLINE int64_t bounds__clear_exponent(array_double_1d tables, array_double_1d work, int64_t scan, int64_t at, int64_t node, int64_t direction, double abscissa, double excess, double slope, int64_t exponent);
static inline int64_t bounds__rising_exponent(array_double_1d tables, array_double_1d work, int64_t scan, int64_t at, int64_t node, int64_t direction, double abscissa, double excess, double slope, int64_t exponent);
static inline int64_t bounds__rising_from_minimum(array_double_1d tables, array_double_1d work, int64_t scan, int64_t at, double y, int64_t direction, double abscissa);
static inline int64_t bounds__bend_bounds(double* least, double* most, array_double_1d tables, array_double_1d work, int64_t scan, int64_t at, int64_t cell, double abscissa);
static inline double bounds__least_slope(double least, double most, double width, double first, double last);
static inline int64_t bounds__only_rises_or_falls(double least, double most, double width, double mismatch_low, double mismatch_high);

#endif
