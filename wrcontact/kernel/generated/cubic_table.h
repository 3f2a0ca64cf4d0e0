/* Generated from surface/cubic_table.py by tools/transpile_kernel.py; change that one.
 *
 * A function read from a table of cubics over even cells (the record CubicTable).
 */

#ifndef WRCONTACT_KERNEL_CUBIC_TABLE_H
#define WRCONTACT_KERNEL_CUBIC_TABLE_H

#include "../native/spans.h"
#include "layout.h"
#include "table_cell.h"

static inline double cubic_table__read_cubic(array_double_1d tables, int64_t table, double at);
static inline int64_t cubic_table__read_cubic_jet(double* result_0, double* result_1, array_double_1d tables, int64_t table, double at);

#endif
