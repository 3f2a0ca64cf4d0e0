/* Generated from tangential/stiffness.py by tools/transpile_kernel.py; change that one.
 *
 * Linear theory of strips that roll side by side on one half-space: how stiff each of them is.
 *
 * A strip j carries the traction X_j sqrt((a - x)/(a + x)), zero at the leading edge a, or in spin X_j
 * sqrt(1 - (x/a)^2).  That its neighbours move the surface below strip i, weighted along i, gives
 *
 *     (2 (1 - nu) / G) sum_j Phi_ij X_j = -w_i                                                    (K1)
 *     Phi_ij = S((e_{j+1} - y_i) / a_ij) - S((e_j - y_i) / a_ij),   a_ij^2 = (a_i^2 + a_j^2) / 2  (K2)
 *
 * for longitudinal creepage; e_j are the strips' edges, y_i their middles.  For lateral creepage and for spin
 * 2/G stands for 2 (1 - nu)/G, and each of the three has its own odd function S, with S(infinity) = 1/2
 * (binding/reach_table.py), so that one infinitely wide strip is Carter's.  With unit creepages
 *
 *     K1 = f1 G / (2 (1 - nu)) Phi_x^-1 1,   K2 = f2 (G/2) Phi_y^-1 1,   K3 = f3 (G/2) (Phi_s^-1 a) / a   (K3)
 *
 * in which the factors f, of the patch's length over width, make the force of an ellipse exactly Kalker's.
 * Long patches have the mean of K3, weighted with a^2 and width, in all strips: from a/b = 1.5 to 3 it takes
 * over.  The equations are solved for pairs of strips; between the middles of pairs stiffnesses follow straight
 * lines.  None is taken below a small share of their mean: in spin the outermost strips of patches with a/b < 3
 * would be dragged the other way round by their neighbours, which errs more.
 */

#ifndef WRCONTACT_KERNEL_STIFFNESS_H
#define WRCONTACT_KERNEL_STIFFNESS_H

#include "../native/spans.h"
#include "layout.h"
#include "shapes.h"

static const double stiffness__SHORT = 0.001;
static const double stiffness__SOFT = 0.02;
static const double stiffness__NEAREST = 1e-12;
static const double stiffness__OWN_UNTIL = 0.4054651081081644;
static const double stiffness__MEAN_FROM = 1.0986122886681098;

static inline int64_t stiffness__join_strips(array_double_1d work, int64_t rolling);
static inline double stiffness__reach_cubic(array_double_1d tables, int64_t table, int64_t at, double u);
static inline int64_t stiffness__reaches(double* result_0, double* result_1, double* result_2, array_double_1d tables, int64_t table, double distance);
static inline int64_t stiffness__reach_beside(array_double_1d tables, array_double_1d work, int64_t table, int64_t rolling, int64_t i, int64_t j, double near, double far);
static inline int64_t stiffness__fill_equations(array_double_1d tables, array_double_1d work, int64_t table, int64_t rolling);
static inline int64_t stiffness__solve_blocks(array_double_1d work, int64_t equations);
static inline double stiffness__mean_share(double ratio);
static inline double stiffness__not_below(double value, double least);
static inline int64_t stiffness__spread_turning(array_double_1d work, int64_t blocks, double share);
static inline int64_t stiffness__find_stiffnesses(array_double_1d work, array_double_1d tables, int64_t rolling);
static inline int64_t stiffness__stiffnesses_at(double* along, double* across, double* turning, array_double_1d work, int64_t blocks, int64_t index, double station);

#endif
