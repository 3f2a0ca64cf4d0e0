/* Generated from patch/quadrature.py by tools/transpile_kernel.py; change that one.
 *
 * Integrals over the cells between the strips of a patch.
 *
 * A cell has a value at its inner end, one at its outer end, and the value one cell further in.  Between its
 * ends the quadratic through the three is taken, with a limited bend (:func:`bend_of`), so that an ellipse is
 * integrated exactly.  A place in a cell is its share of the cell, counted from the inner end.
 */

#ifndef WRCONTACT_KERNEL_QUADRATURE_H
#define WRCONTACT_KERNEL_QUADRATURE_H

#include "../native/spans.h"

static const double quadrature__STRAIGHT = 0.0001;

static inline double quadrature__bend_of(double before, double low, double high);
static inline double quadrature__quadratic_value(double before, double low, double high, double x);
static inline int64_t quadrature__cell_part(double* start, double* stop, double d_before, double d_low, double d_high);
static inline double quadrature__quadratic_integral(double before, double low, double high, double stop);
static inline double quadrature__quadratic_moment(double before, double low, double high, double stop);
static inline double quadrature__quadratic_at(double low, double slope, double bend, double x);
static inline double quadrature__bent_integral(double low, double slope, double bend, double start, double stop);
static inline double quadrature__root_integral(double before, double low, double high, double start, double stop);

#endif
