/* Generated from tangential/fastrip.py by tools/transpile_kernel.py; change that one.
 *
 * FaStrip: strip theory in the stick zone, FASTSIM's direction in the slip zone.
 *
 * M. Sh. Sichani, R. Enblom, M. Berg, An alternative to FASTSIM for tangential solution of the wheel-rail
 * contact, Vehicle System Dynamics 54 (2016) 748-764.  Strip theory (eqs. (Z1), (Z2) of stick_zone.py, there
 * with s = 0) has the stiffnesses that give Kalker's force for an ellipse,
 *
 *     K1 = 2 C11 G / pi^2,   K2 = 2 C22 G / pi^2,   K3 = 3 C23 G sqrt(b/a) / (2 pi)                (A1)
 *
 * the same in all strips.  A strip that has no stick zone, or one that is longer than itself, slips all over.
 * Where a strip slips its traction is the bound, in the direction that FASTSIM's traction has there.  As
 * published, -phi y has the stiffness K3 / (1 - nu) in strip theory and L3 in FASTSIM; with those of
 * longitudinal creepage, K1 and L1, the force is closer to the complete theory.
 *
 * The force is not continuous: strips begin to slip all over while their stick zone has a length.
 */

#ifndef WRCONTACT_KERNEL_FASTRIP_H
#define WRCONTACT_KERNEL_FASTRIP_H

#include "../native/spans.h"
#include "fastsim.h"
#include "layout.h"
#include "shapes.h"
#include "tractions.h"

static inline int64_t fastrip__set_stiffnesses(array_double_1d work, array_double_1d tables, int64_t rolling);
static inline double fastrip__longitudinal(array_double_1d work, array_double_1d tables, int64_t rolling, int64_t strip);
static inline int64_t fastrip__find_stick(array_double_1d work, int64_t march, double push, double lateral, double spin);
static inline int64_t fastrip__next_traction(double* p_x, double* p_y, array_double_1d work, int64_t march, double x, double bound);
static inline int64_t fastrip__add_tractions(array_double_1d tables, array_double_1d work, int64_t table, int64_t rolling, int64_t strip);
static inline int64_t fastrip__solve_fastrip(array_double_1d work, array_double_1d tables, int64_t rolling);

#endif
