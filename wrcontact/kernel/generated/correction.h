/* Generated from tangential/correction.py by tools/transpile_kernel.py; change that one.
 *
 * What the strips' force of an ellipse lacks to that of the complete theory.
 *
 * For the ellipse with the patch's area and length over width, r = a/b, the saturation
 *
 *     s1 = -xi ab G C11/(mu N),   s2 = -eta ab G C22/(mu N),
 *     s3 = -phi (ab)^1.5 G C23/(mu N) sqrt(1 + 0.66 r^-2.7)                                        (D1)
 *
 * is mirrored until s1 and s3 are not negative, and taken in polar coordinates: its length R as R / (1 + R), its
 * elevation arctan(s1 / sqrt(s2^2 + s3^2)) and its azimuth arctan2(s3, s2).  Over these and ln r the table holds
 * the force over mu N and the moment over mu N sqrt(ab) that are missing; between its nodes they follow straight
 * lines along each coordinate.  The force is then cut to mu N.
 *
 * s3 is zero on both sides of the azimuth's ends, where the table's values change over into their mirror images;
 * so the correction is continuous all over.
 */

#ifndef WRCONTACT_KERNEL_CORRECTION_H
#define WRCONTACT_KERNEL_CORRECTION_H

#include "../native/spans.h"
#include "layout.h"
#include "shapes.h"
#include "table_cell.h"
#include "tractions.h"

static const int64_t correction__ELEVATION_STRIDE = INT64_C(468);
static const int64_t correction__RATIO_STRIDE = INT64_C(2340);
static const double correction__FIRST_RATIO = 0.1;
static const double correction__PER_DOUBLING = 1.4426950408889634;

static inline double correction__scale_at(array_double_1d tables, int64_t table, int64_t at, double share);
static inline int64_t correction__saturation(double* result_0, double* result_1, double* result_2, array_double_1d work, array_double_1d tables, int64_t rolling, int64_t cell, double share);
static inline int64_t correction__radius_cell(int64_t* cell, double* result_1, array_double_1d tables, int64_t table, double place);
static inline int64_t correction__node_at(int64_t* at, double* on_elevation, double* on_azimuth, double* on_radius, array_double_1d tables, int64_t table, double along, double across, double turning);
static inline double correction__on_line(array_double_1d tables, int64_t table, int64_t at, double on_radius);
static inline double correction__on_cone(array_double_1d tables, int64_t table, int64_t at, double on_azimuth, double on_radius);
static inline double correction__on_plane(array_double_1d tables, int64_t table, int64_t at, double on_elevation, double on_azimuth, double on_radius);
static inline double correction__missing(array_double_1d tables, int64_t table, int64_t at, double on_ratio, double on_elevation, double on_azimuth, double on_radius);
static inline int64_t correction__correct_force(array_double_1d work, array_double_1d tables, int64_t rolling);

#endif
