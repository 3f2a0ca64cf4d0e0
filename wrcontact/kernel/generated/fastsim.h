/* Generated from tangential/fastsim.py by tools/transpile_kernel.py; change that one.
 *
 * FASTSIM, Kalker's simplified theory.
 *
 * J. J. Kalker, A fast algorithm for the simplified theory of rolling contact, Vehicle System Dynamics 11 (1982)
 * 1-13.  The surface gives way like u = L p, so that along a strip, in the direction of rolling,
 *
 *     dp_x/dx = (xi - phi y) / L1,   dp_y/dx = eta / L2 + phi x / L3                              (F1)
 *     L1 = 8 a / (3 C11 G),  L2 = 8 a / (3 C22 G),  L3 = pi a sqrt(a/b) / (4 C23 G)               (F2)
 *
 * from zero at the leading edge, cut to the bound.  a, b and the coefficients are those of the ellipse with the
 * patch's area and length over width.  As published, -phi y has the flexibility L3; with L1, which is that of
 * all longitudinal creepage, the force is closer to the complete theory.  The bound is that of the pressure,
 * mu p0 sqrt(1 - (x/a)^2).  Where L1 and L2 differ, the force of full slip does not point quite against the
 * slip: up to 10 degrees.
 */

#ifndef WRCONTACT_KERNEL_FASTSIM_H
#define WRCONTACT_KERNEL_FASTSIM_H

#include "../native/spans.h"
#include "layout.h"
#include "shapes.h"
#include "tractions.h"

static inline int64_t fastsim__stiffnesses(double* result_0, double* result_1, double* result_2, array_double_1d work, array_double_1d tables, int64_t rolling);
static inline double fastsim__strip_push(array_double_1d work, int64_t rolling, int64_t strip, double along, double turning);
static inline double fastsim__march_strip(array_double_1d tables, array_double_1d work, int64_t table, int64_t rolling, int64_t strip, double rate, double push, double across, double turning);
static inline int64_t fastsim__solve_fastsim(array_double_1d work, array_double_1d tables, int64_t rolling);

#endif
