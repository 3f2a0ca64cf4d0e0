/* Generated from prepare/zones.py by tools/transpile_kernel.py; change that one.
 *
 * The zones that a profile is defined with, as numbers: polynomials and circular arcs,
 * upright or turned; in millimetres.
 *
 * A definition is one array: how many zones, the length of their rows, then the rows.
 * wrcontact/profiles/zones.py has the same zones as objects, and
 * wrcontact/profiles/definition.py turns one into the other.
 */

#ifndef WRCONTACT_KERNEL_PREPARE_ZONES_H
#define WRCONTACT_KERNEL_PREPARE_ZONES_H

#include "../native/spans.h"

static const int64_t prepare_zones__DEFINITION_COUNT = INT64_C(0);
static const int64_t prepare_zones__DEFINITION_ROW = INT64_C(1);
static const int64_t prepare_zones__DEFINITION_ZONES = INT64_C(2);
static const int64_t prepare_zones__ZONE_FAMILY = INT64_C(0);
static const int64_t prepare_zones__ZONE_START = INT64_C(1);
static const int64_t prepare_zones__ZONE_STOP = INT64_C(2);
static const int64_t prepare_zones__ZONE_ORIGIN = INT64_C(3);
static const int64_t prepare_zones__ZONE_Z_CENTRE = INT64_C(4);
static const int64_t prepare_zones__ZONE_RADIUS = INT64_C(5);
static const int64_t prepare_zones__ZONE_SIDE = INT64_C(6);
static const int64_t prepare_zones__ZONE_TERMS = INT64_C(7);
static const int64_t prepare_zones__ZONE_TURNED = INT64_C(8);
static const int64_t prepare_zones__ZONE_COS = INT64_C(9);
static const int64_t prepare_zones__ZONE_SIN = INT64_C(10);
static const int64_t prepare_zones__ZONE_Y_SHIFT = INT64_C(11);
static const int64_t prepare_zones__ZONE_Z_SHIFT = INT64_C(12);
static const int64_t prepare_zones__ZONE_FIRST = INT64_C(13);
static const int64_t prepare_zones__ZONE_LAST = INT64_C(14);
static const int64_t prepare_zones__ZONE_COEFFICIENTS = INT64_C(15);
static const int64_t prepare_zones__FAMILY_POLYNOMIAL = INT64_C(0);
static const int64_t prepare_zones__FAMILY_ARC = INT64_C(1);
static const int64_t prepare_zones__TURNED_ITERATIONS = INT64_C(60);
static const double prepare_zones__TURNED_SHARP = 1e-15;
static const double prepare_zones__VERTICAL = 1e-90;

static inline int64_t prepare_zones__polynomial_jet(double* z, double* slope, double* bend, array_double_1d zones, int64_t row, double t);
static inline int64_t prepare_zones__arc_jet(double* z, double* result_1, double* result_2, array_double_1d zones, int64_t row, double y);
static inline int64_t prepare_zones__upright_jet(double* z, double* slope, double* bend, array_double_1d zones, int64_t row, double t);
static inline int64_t prepare_zones__turned_point(double* result_0, double* result_1, array_double_1d zones, int64_t row, double t, double cosine, double sine);
static inline double prepare_zones__within(double x, double low, double high);
static inline int64_t prepare_zones__turned_jet(double* result_0, double* result_1, double* result_2, array_double_1d zones, int64_t row, double y);
static inline int64_t prepare_zones__zone_jet(double* z, double* slope, double* bend, array_double_1d zones, int64_t row, double y);

#endif
