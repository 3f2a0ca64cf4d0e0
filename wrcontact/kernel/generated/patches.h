/* Generated from patch/patches.py by tools/transpile_kernel.py; change that one.
 *
 * From solved regions to contact patches: loads, areas, pressures, centroids, and the outline at evenly spaced stations.
 *
 * A patch is a connected run of loaded strips.  Between nodes the line load and the squares of half-length and pressure
 * are the quadratics through the cell's nodes and its inner neighbour, so that an ellipse comes out exact.
 */

#ifndef WRCONTACT_KERNEL_PATCHES_H
#define WRCONTACT_KERNEL_PATCHES_H

#include "../native/spans.h"
#include "analyn.h"
#include "layout.h"
#include "nodes.h"

static const int64_t patches__ISLAND_SIZE = INT64_C(10);
static const int64_t patches__ISLAND_LIMIT = INT64_C(8);
static const int64_t patches__ISLAND_LOAD = INT64_C(0);
static const int64_t patches__ISLAND_AREA = INT64_C(1);
static const int64_t patches__ISLAND_MOMENT = INT64_C(2);
static const int64_t patches__ISLAND_PRESSURE = INT64_C(3);
static const int64_t patches__ISLAND_HALF_LENGTH = INT64_C(4);
static const int64_t patches__ISLAND_START = INT64_C(5);
static const int64_t patches__ISLAND_STOP = INT64_C(6);
static const int64_t patches__ISLAND_ANGLE = INT64_C(7);
static const double patches__STRAIGHT = 0.0001;
static const double patches__JOINED = 1e-09;

static inline double patches__quadratic_moment(double before, double low, double high, double start, double stop);
static inline double patches__bent_integral(double low, double slope, double bend, double start, double stop);
static inline double patches__root_integral(double before, double low, double high, double start, double stop);
static inline int64_t patches__load_nodes(array_double_1d work, int64_t region, double level);
static inline double patches__peak_square(array_double_1d work, int64_t field, int64_t k);
static inline int64_t patches__open_island(array_double_1d work, int64_t count, double start, double angle);
static inline int64_t patches__add_cell(array_double_1d work, int64_t region, int64_t before, int64_t low, int64_t high, double start, double stop, int64_t at, double inner, double step);
static inline int64_t patches__gather_cell(array_double_1d work, int64_t region, double level, int64_t k, int64_t islands, double angle);
static inline int64_t patches__gather_islands(array_double_1d tables, array_double_1d work, int64_t count);
static inline int64_t patches__write_patch(array_double_1d work, int64_t to, int64_t at);
static inline int64_t patches__write_patches(array_double_1d work, int64_t side, int64_t islands);
static inline double patches__quadratic_value(double before, double low, double high, double x);
static inline int64_t patches__strip_at(double* half, double* pressure, array_double_1d work, int64_t region, double station);
static inline int64_t patches__write_outline(array_double_1d work, int64_t side, int64_t place, int64_t stations, int64_t count, int64_t islands);

#endif
