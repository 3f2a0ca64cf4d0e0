/* Generated from tangent_table_cell.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of table_cell.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_TABLE_CELL_H
#define WRCONTACT_KERNEL_TANGENT_TABLE_CELL_H

#include "../native/spans.h"

static inline int64_t tangent_table_cell__table_cell_t(int64_t* cell, double* result_1, double* result_2, double u, double u_t, double last, double last_t);

#endif
