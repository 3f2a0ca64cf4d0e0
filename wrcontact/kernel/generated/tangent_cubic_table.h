/* Generated from tangent_cubic_table.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of cubic_table.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_CUBIC_TABLE_H
#define WRCONTACT_KERNEL_TANGENT_CUBIC_TABLE_H

#include "../native/spans.h"
#include "layout.h"
#include "tangent_table_cell.h"

static inline int64_t tangent_cubic_table__read_cubic_t(double* result_0, double* result_1, array_double_1d tables, int64_t table, double at, double at_t);
static inline int64_t tangent_cubic_table__read_cubic_jet_t(double* result_0, double* result_1, double* result_2, double* result_3, array_double_1d tables, int64_t table, double at, double at_t);

#endif
