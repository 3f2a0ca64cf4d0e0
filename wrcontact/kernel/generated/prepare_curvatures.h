/* Generated from prepare/curvatures.py by tools/transpile_kernel.py; change that one.
 *
 * Lateral curvature of a profile all along it, as the source takes it.
 *
 * Curvatures here are d(angle)/d(arc length) with z down, positive where the profile is hollow upwards; the
 * table has them positive where the profile bulges towards the other body, which is this sign on a rail and the
 * other one on a wheel. The table is the record CurvatureTable.
 */

#ifndef WRCONTACT_KERNEL_PREPARE_CURVATURES_H
#define WRCONTACT_KERNEL_PREPARE_CURVATURES_H

#include "../native/spans.h"
#include "layout.h"
#include "prepare_pieces.h"
#include "prepare_scan.h"
#include "profile_table.h"

static const double prepare_curvatures__RASTER_SHARE = 0.25;
static const double prepare_curvatures__FINEST = 1e-05;
static const double prepare_curvatures__COARSEST = 5e-05;
static const int64_t prepare_curvatures__SAMPLES = INT64_C(61);
static const int64_t prepare_curvatures__GAUSS_POINTS = INT64_C(10);
static const int64_t prepare_curvatures__ARC_ITERATIONS = INT64_C(30);
static const double prepare_curvatures__ARC_SHARP = 1e-15;

static inline double prepare_curvatures__circle_curvature(double n00, double n01, double n02, double n11, double n12, double n22, double r0, double r1, double r2);
static inline double prepare_curvatures__fitted_curvature(array_double_1d tables, int64_t profile, double y, double reach);
static inline int64_t prepare_curvatures__write_gauss(array_double_1d work, int64_t scratch);
static inline double prepare_curvatures__arc_panel(array_double_1d tables, int64_t profile, double low, double high, array_double_1d work, int64_t scratch);
static inline double prepare_curvatures__write_lengths(array_double_1d tables, int64_t profile, array_double_1d work, int64_t scratch);
static inline double prepare_curvatures__arc_length(array_double_1d tables, int64_t profile, double y, array_double_1d work, int64_t scratch);
static inline double prepare_curvatures__place_at_length(array_double_1d tables, int64_t profile, double length, array_double_1d work, int64_t scratch);
static inline double prepare_curvatures__turned_curvature(array_double_1d tables, int64_t profile, double y, double step, double total, array_double_1d work, int64_t scratch);
static inline int64_t prepare_curvatures__write_curvatures(array_double_1d tables, int64_t base, int64_t profile, double sign, array_double_1d work, int64_t scratch);

#endif
