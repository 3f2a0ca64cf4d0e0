/* Generated from tangent_table_cell.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of table_cell.py.
 */

#include "tangent_table_cell.h"

/* Tangent of ``table_cell``. */
static inline int64_t tangent_table_cell__table_cell_t(int64_t* cell, double* result_1, double* result_2, double u, double u_t, double last, double last_t)
{
    if (!(u > 0.0))
    {
        u_t = 0.0;
        u = 0.0;
    }
    if (u > last)
    {
        u_t = last_t;
        u = last;
    }
    (*cell) = (int64_t)(u);
    if ((*cell) > (int64_t)(last) - INT64_C(1))
    {
        (*cell) = (int64_t)(last) - INT64_C(1);
    }
    (*result_1) = u - (double)((*cell));
    (*result_2) = u_t;
    return 0;
}
