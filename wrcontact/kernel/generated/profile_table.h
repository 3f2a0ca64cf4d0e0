/* Generated from surface/profile_table.py by tools/transpile_kernel.py; change that one.
 *
 * A profile as the kernel reads it: quintic pieces found through uniform bins.
 *
 * Table at ``base``: start, stop, bins per metre, bin count, offset of the pieces, then for each bin the offset of the first
 * piece that reaches into it, then per piece its start and six coefficients; the piece after the last starts at not-a-number, which no
 * abscissa reaches.  An abscissa that is not a number, infinite or far outside reads an end piece: nothing leaves the table.
 */

#ifndef WRCONTACT_KERNEL_PROFILE_TABLE_H
#define WRCONTACT_KERNEL_PROFILE_TABLE_H

#include "../native/spans.h"

static const int64_t profile_table__START = INT64_C(0);
static const int64_t profile_table__STOP = INT64_C(1);
static const int64_t profile_table__BINS_PER_METRE = INT64_C(2);
static const int64_t profile_table__BIN_COUNT = INT64_C(3);
static const int64_t profile_table__PIECE_OFFSET = INT64_C(4);
static const int64_t profile_table__BINS = INT64_C(5);
static const int64_t profile_table__PIECE_SIZE = INT64_C(7);

static inline int64_t profile_table__find_piece(array_double_1d tables, int64_t base, double y);
static inline int64_t profile_table__height_slope(double* result_0, double* slope, array_double_1d tables, int64_t base, double y);
static inline int64_t profile_table__height_slope_bend(double* result_0, double* result_1, double* result_2, array_double_1d tables, int64_t base, double y);

#endif
