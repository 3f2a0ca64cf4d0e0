/* Generated from normal/analyn.py by tools/transpile_kernel.py; change that one.
 *
 * ANALYN on the nodes of up to three regions: from local penetrations
 * to loads, and from a force to penetrations.
 *
 * Sichani, Enblom & Berg (2014).  In a region with local penetration D the strip at s is loaded where
 *
 *     d(s) = D - (1 + beta) g > 0,   half-length a = sqrt(d / ((1 + alpha) A)),   p0 = (2 E* /pi) d / (n r a)
 *
 * (the source's eq. 2.25 prints E* /(2 pi), which integrates to a quarter of the force), so the line load
 * (pi/2) a p0 = E* d / (n r) and the region's load is an integral without a root.
 *
 * Regions press on each other: the local penetration of region i is the total penetration minus its smallest gap
 * minus its displacement by the loads of the others, sum_j N_j / (pi E* distance_ij) (Boussinesq;
 * interaction.py, docs/method.md).  Where regions have planes of their own (:mod:`planes`), the penetration
 * counts by its share along each normal, and a displacement by the cosine of the angle between the two.
 */

#ifndef WRCONTACT_KERNEL_ANALYN_H
#define WRCONTACT_KERNEL_ANALYN_H

#include "../native/spans.h"
#include "interaction.h"
#include "layout.h"
#include "quadrature.h"

static const int64_t analyn__FORCE_ITERATIONS = INT64_C(60);
static const double analyn__FORCE_SHARP = 1e-12;
static const double analyn__ROUNDING = 1e-10;
static const double analyn__SLOPE_ERROR = 0.1;
static const double analyn__NEARLY_SHARP = 1e-09;
static const double analyn__NEARLY = 0.001;
static const double analyn__CLOSED = 1e-10;
static const double analyn__HIGHEST = 1000.0;

static inline double analyn__clip_to_bound(array_double_1d work, int64_t region, int64_t k, int64_t outward, double stop);
static inline int64_t analyn__region_load(double* result_0, double* result_1, array_double_1d work, int64_t region, int64_t nodes, double local_penetration);
static inline double analyn__load_regions(array_double_1d work, int64_t count);
static inline int64_t analyn__penetration_residuals(double* largest, double* slope, double* rest, array_double_1d work, array_double_1d tables, int64_t count, double penetration);
static inline double analyn__penetration_move(double force, double total, double slope, double rest, double penetration, double low, double high);
static inline int64_t analyn__apply_moves(array_double_1d work, int64_t count, double move);
static inline int64_t analyn__solve_penetrations(double* result_0_0001, int64_t* result_1_0001, array_double_1d work, array_double_1d tables, array_double_1d state, int64_t count, double force, double penetration, int64_t prescribed);

#endif
