/* Generated from surface/gap.py by tools/transpile_kernel.py; change that one.
 *
 * The vertical gap between a placed right wheel and its rail, along the contact locus.
 *
 * gap(y) = z_rail(Y(y)) - Z(y), with the outline (Y, Z) of :mod:`locus`; positive where the wheel is above the
 * rail.  The wheelset stands at vertical shift zero, so contact lies at the smallest gap and the vertical shift
 * is that gap.
 */

#ifndef WRCONTACT_KERNEL_GAP_H
#define WRCONTACT_KERNEL_GAP_H

#include "../native/spans.h"
#include "layout.h"
#include "locus.h"
#include "profile_table.h"

static const double gap__FOLDED = 1000000.0;

static inline int64_t gap__above_rail(array_double_1d tables, double abscissa);
static inline int64_t gap__vertical_gap(double* result_0, double* mismatch, double* result_2, array_double_1d work, array_double_1d tables, int64_t place, double y);
static inline double gap__gap_per_roll(array_double_1d work, array_double_1d tables, int64_t place, double y);
static inline int64_t gap__gap_jet(double* result_0, double* mismatch, double* result_2, double* result_3, double* result_4, double* abscissa, array_double_1d work, array_double_1d tables, int64_t place, double y);

#endif
