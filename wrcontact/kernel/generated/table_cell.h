/* Generated from surface/table_cell.py by tools/transpile_kernel.py; change that one.
 *
 * Where a value lies in a table with even steps.
 */

#ifndef WRCONTACT_KERNEL_TABLE_CELL_H
#define WRCONTACT_KERNEL_TABLE_CELL_H

#include "../native/spans.h"

static inline int64_t table_cell__table_cell(int64_t* cell, double* result_1, double u, double last);

#endif
