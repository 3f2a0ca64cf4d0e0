/* Generated from search/starts.py by tools/transpile_kernel.py; change that one.
 *
 * Where the roll search starts without a near pose before: contacts without yaw, known for a row of lateral shifts.
 *
 * A start sets the cost and never the answer, which is certified.
 */

#ifndef WRCONTACT_KERNEL_STARTS_H
#define WRCONTACT_KERNEL_STARTS_H

#include "../native/spans.h"
#include "layout.h"

static const int64_t starts__START_COUNT = INT64_C(0);
static const int64_t starts__START_FIRST = INT64_C(1);
static const int64_t starts__START_PER_METRE = INT64_C(2);
static const int64_t starts__START_ROWS = INT64_C(3);
static const int64_t starts__START_ROW = INT64_C(4);
static const int64_t starts__START_KNOWN = INT64_C(0);
static const int64_t starts__START_ROLL = INT64_C(1);
static const int64_t starts__START_LEFT = INT64_C(2);
static const int64_t starts__START_RIGHT = INT64_C(3);

static inline int64_t starts__nearest_start(array_double_1d tables, double shift);

#endif
