/* Generated from normal/strips.py by tools/transpile_kernel.py; change that one.
 *
 * The strip correction: ANALYN's patch, put right by the elastic half-space.
 *
 * ANALYN's strips do not feel each other: the displacement of each is that of a Hertz ellipse with its own curvatures.  Here
 * the same strips, each with a pressure p sqrt(1 - (x/a)^2) along the track, press on one half-space (docs/method.md, S1-S9):
 *
 * 1. place the strips over ANALYN's zone, finer where the gap bends and near the contact,
 * 2. solve sum_j F_ij y_j = penetration - gap_i with y = h p / (pi E*) >= 0 and the force given; F_ij tells how a strip j of
 *    half-length a_j pushes the middle line of strip i down,
 * 3. correct every half-length by what the middle line's curvature along the track asks for, at its line load.
 *
 * One round of 2 and 3 is a sweep.  Where the true patch differs from ANALYN's, strips lose their load or take some up.
 */

#ifndef WRCONTACT_KERNEL_STRIPS_H
#define WRCONTACT_KERNEL_STRIPS_H

#include "../native/spans.h"
#include "contact_plane.h"
#include "interaction.h"
#include "layout.h"
#include "nodes.h"

static const int64_t strips__STRIP_STATION = INT64_C(0);
static const int64_t strips__STRIP_WIDTH = INT64_C(1);
static const int64_t strips__STRIP_GAP = INT64_C(2);
static const int64_t strips__STRIP_A = INT64_C(3);
static const int64_t strips__STRIP_HERTZ = INT64_C(4);
static const int64_t strips__STRIP_HALF = INT64_C(5);
static const int64_t strips__STRIP_LOG = INT64_C(6);
static const int64_t strips__STRIP_SHARE = INT64_C(7);
static const int64_t strips__STRIP_LOADED = INT64_C(8);
static const int64_t strips__STRIP_REGION = INT64_C(9);
static const int64_t strips__STRIP_LINE = INT64_C(10);
static const int64_t strips__STRIP_SQUARE = INT64_C(11);
static const int64_t strips__STRIP_PRESSURE = INT64_C(12);
static const int64_t strips__STRIP_JOINED = INT64_C(13);
static const int64_t strips__STRIP_RANK = INT64_C(14);
static const int64_t strips__STRIP_TURN = INT64_C(15);
static const int64_t strips__TABLE_START = INT64_C(0);
static const int64_t strips__TABLE_CELLS_PER_UNIT = INT64_C(1);
static const int64_t strips__TABLE_COUNT = INT64_C(2);
static const int64_t strips__TABLE_CELLS = INT64_C(4);
static const int64_t strips__TABLE_ROW = INT64_C(4);
static const double strips__ZONE = 0.9;
static const double strips__BEYOND = 0.6;
static const double strips__EVEN = 0.5;
static const int64_t strips__LEAST = INT64_C(12);
static const double strips__SHORTEST = 0.1;
static const double strips__INSIDE = 0.3;
static const double strips__SQUARE = 0.5;
static const int64_t strips__EXCHANGES = INT64_C(10);
static const int64_t strips__EXCHANGE_LIMIT = INT64_C(200);
static const double strips__TOUCH = 1e-12;
static const double strips__TOUCHING = 1e-06;

static inline int64_t strips__strip_field(int64_t field);
static inline double strips__zone_excess(array_double_1d work, int64_t block, int64_t gaps, int64_t rises, int64_t k, double penetration);
static inline double strips__zone_end(array_double_1d work, int64_t region, int64_t direction, double penetration);
static inline double strips__node_weight(array_double_1d work, int64_t region, int64_t k, double penetration);
static inline int64_t strips__cell_overlap(double* result_0, double* start, array_double_1d work, int64_t block, int64_t k);
static inline double strips__weigh_region(array_double_1d work, int64_t region, double penetration);
static inline int64_t strips__divide_zone(array_double_1d work, int64_t region, double penetration, int64_t strips, int64_t own, double even, double graded, double share);
static inline int64_t strips__place_strips(array_double_1d tables, array_double_1d work, int64_t count, double penetration);
static inline int64_t strips__join_strips(array_double_1d work, int64_t strips);
static inline double strips__cubic_through(double before, double low, double high, double after, double x);
static inline double strips__cubic_value(array_double_1d work, int64_t at, double x);
static inline double strips__node_value(array_double_1d work, int64_t region, int64_t field, int64_t k, double x);
static inline int64_t strips__locate_strip(int64_t* region, int64_t* k, double* x, array_double_1d work, int64_t i);
static inline int64_t strips__keep_long(array_double_1d work, int64_t strips, double longest);
static inline int64_t strips__describe_strips(array_double_1d work, int64_t strips, double penetration);
static inline int64_t strips__run_end(array_double_1d work, int64_t strips, int64_t first);
static inline double strips__run_edge(array_double_1d work, int64_t strips, int64_t last, int64_t first, int64_t outward);
static inline int64_t strips__measure_distances(array_double_1d work, int64_t strips, int64_t i, int64_t others);
static inline int64_t strips__set_strip(array_double_1d work, int64_t strips, int64_t i, double start, double stop);
static inline int64_t strips__fit_edge(array_double_1d work, int64_t strips, int64_t last, double edge, int64_t outward);
static inline int64_t strips__fit_edges(array_double_1d work, int64_t strips);
static inline double strips__influence_value(array_double_1d tables, int64_t base, double abscissa);
static inline double strips__near_share(double share);
static inline int64_t strips__turn_influence(array_double_1d work, int64_t strips);
static inline int64_t strips__fill_influence(array_double_1d tables, array_double_1d work, int64_t strips, int64_t count);
static inline int64_t strips__eliminate(array_double_1d work, int64_t size);
static inline double strips__solve_loaded(array_double_1d tables, array_double_1d work, int64_t strips, double force, double prescribed, int64_t by_penetration);
static inline int64_t strips__exchange_strips(array_double_1d work, int64_t strips, double penetration, int64_t single);
static inline int64_t strips__solve_strips(double* result_0, int64_t* result_1_0001, array_double_1d tables, array_double_1d work, array_double_1d state, int64_t strips, double force, double prescribed, int64_t by_penetration);
static inline int64_t strips__correct_lengths(array_double_1d tables, array_double_1d work, int64_t strips);
static inline int64_t strips__adopt_lengths(array_double_1d work, int64_t strips);
static inline int64_t strips__start_loaded(array_double_1d work, int64_t strips);
static inline int64_t strips__correct_strips(double* result_0, int64_t* result_1, int64_t* result_2, array_double_1d tables, array_double_1d work, array_double_1d state, int64_t count, double force, double predicted, int64_t by_penetration);

#endif
