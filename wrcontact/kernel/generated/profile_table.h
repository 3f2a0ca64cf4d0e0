/* Generated from surface/profile_table.py by tools/transpile_kernel.py; change that one.
 *
 * Heights, slopes and bends of a profile, from its table of quintic pieces (the record Profile).
 *
 * An abscissa that is not a number, infinite or far outside is read from a piece at an end: nothing outside the
 * table is read.
 */

#ifndef WRCONTACT_KERNEL_PROFILE_TABLE_H
#define WRCONTACT_KERNEL_PROFILE_TABLE_H

#include "../native/spans.h"
#include "layout.h"

static inline int64_t profile_table__find_piece(array_double_1d tables, int64_t profile, double y);
static inline int64_t profile_table__height_slope(double* result_0, double* slope, array_double_1d tables, int64_t profile, double y);
static inline int64_t profile_table__height_slope_bend(double* result_0, double* result_1, double* result_2, array_double_1d tables, int64_t profile, double y);

#endif
