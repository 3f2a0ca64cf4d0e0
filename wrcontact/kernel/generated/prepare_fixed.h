/* Generated from prepare/fixed.py by tools/transpile_kernel.py; change that one.
 *
 * Tables that do not depend on the profiles, from the array ``fixed`` (binding/fixed_tables.py).
 *
 * It begins with the sizes of its tables: Hertz's, that of influences, and that of rolling for all Poisson's
 * ratios (binding/rolling_table.py).  The tables follow one after the other.
 */

#ifndef WRCONTACT_KERNEL_PREPARE_FIXED_H
#define WRCONTACT_KERNEL_PREPARE_FIXED_H

#include "../native/spans.h"
#include "layout.h"
#include "prepare_pieces.h"

static const int64_t prepare_fixed__FIXED_HERTZ = INT64_C(0);
static const int64_t prepare_fixed__FIXED_INFLUENCE = INT64_C(1);
static const int64_t prepare_fixed__FIXED_ROLLING = INT64_C(2);
static const int64_t prepare_fixed__FIXED_COUNT = INT64_C(3);
static const double prepare_fixed__LOW_RATIO = 0.0;
static const double prepare_fixed__MIDDLE_RATIO = 0.25;
static const double prepare_fixed__HIGH_RATIO = 0.5;
static const double prepare_fixed__FIRST_CORRECTION = 0.25;
static const double prepare_fixed__SECOND_CORRECTION = 0.28;
static const double prepare_fixed__THIRD_CORRECTION = 0.3;

static inline int64_t prepare_fixed__fixed_table(array_double_1d fixed, int64_t index);
static inline int64_t prepare_fixed__append_fixed(array_double_1d tables, int64_t at, array_double_1d fixed, int64_t index);
static inline int64_t prepare_fixed__parabola_weights(double* result_0, double* result_1, double* result_2, double low, double middle, double high, double x);
static inline int64_t prepare_fixed__write_shapes(array_double_1d tables, int64_t table, array_double_1d fixed, int64_t first, double poisson_ratio);
static inline int64_t prepare_fixed__write_reaches(array_double_1d tables, int64_t table, array_double_1d fixed, int64_t first, double poisson_ratio);
static inline int64_t prepare_fixed__write_corrections(array_double_1d tables, int64_t table, array_double_1d fixed, int64_t first, double poisson_ratio);
static inline int64_t prepare_fixed__append_rolling(array_double_1d tables, int64_t at, array_double_1d fixed, double poisson_ratio);

#endif
