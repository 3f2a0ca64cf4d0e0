/* Generated from tangential/tractions.py by tools/transpile_kernel.py; change that one.
 *
 * Tractions along a strip: points, bound, and sums.
 *
 * The points x_q = a cos(q pi / (n + 1)), q = 1 ... n, run from the leading edge at a to the trailing one at -a.
 * With the weights a pi / (n + 1) sin(q pi / (n + 1)) the bound m sqrt(a^2 - x^2) is integrated exactly.  m is
 * the coefficient of friction times the pressure on the strip's middle over its half-length.
 */

#ifndef WRCONTACT_KERNEL_TRACTIONS_H
#define WRCONTACT_KERNEL_TRACTIONS_H

#include "../native/spans.h"
#include "layout.h"

static const double tractions__WEIGHT = 0.18479956785822313;
static const double tractions__SLIGHT = 1e-12;

static inline double tractions__bound_rate(array_double_1d work, int64_t rolling, int64_t strip);
static inline int64_t tractions__cut_to(double* result_0, double* result_1, double along, double across, double bound);
static inline int64_t tractions__add_strip(array_double_1d work, int64_t rolling, int64_t strip, double along, double across, double moment);
static inline double tractions__patch_area(array_double_1d work, int64_t rolling);
static inline double tractions__point_weight(array_double_1d work, int64_t strip);

#endif
