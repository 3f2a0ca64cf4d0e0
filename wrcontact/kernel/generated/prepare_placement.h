/* Generated from prepare/placement.py by tools/transpile_kernel.py; change that one.
 *
 * The rail on the track, and the part of a wheel that can be read.
 *
 * A definition (zones.py) is turned and shifted into another one, in millimetres.
 */

#ifndef WRCONTACT_KERNEL_PREPARE_PLACEMENT_H
#define WRCONTACT_KERNEL_PREPARE_PLACEMENT_H

#include "../native/spans.h"
#include "prepare_zones.h"

static const double prepare_placement__STEEPEST = 1.3962634015954636;
static const double prepare_placement__SLIVER = 1e-06;
static const double prepare_placement__MEETING = 1e-09;
static const double prepare_placement__NO_FACE = -1e+300;

static inline double prepare_placement__turned_slope(array_double_1d zones, int64_t row, double t, double angle);
static inline double prepare_placement__level_place(array_double_1d zones, int64_t row, double angle);
static inline int64_t prepare_placement__highest_point(double* y_top, double* z_top, array_double_1d zones, int64_t base, double angle);
static inline double prepare_placement__place_at_depth(array_double_1d zones, int64_t row, double cosine, double sine, double depth);
static inline int64_t prepare_placement__inner_face(double* result_0_0001, double* result_1_0001, array_double_1d zones, int64_t base, double angle, double depth);
static inline int64_t prepare_placement__turn_arc(array_double_1d zones, int64_t row, double angle, double y_shift, double z_shift);
static inline int64_t prepare_placement__turn_polynomial(array_double_1d zones, int64_t row, double angle, double y_shift, double z_shift);
static inline int64_t prepare_placement__turn_zones(array_double_1d zones, int64_t base, double angle, double y_shift, double z_shift);
static inline int64_t prepare_placement__meets_next(array_double_1d zones, int64_t row, int64_t size);
static inline int64_t prepare_placement__keep_around_top(array_double_1d zones, int64_t base);

#endif
