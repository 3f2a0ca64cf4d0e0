/* Generated from surface/table_cell.py by tools/transpile_kernel.py; change that one.
 *
 * Where a value lies in a table with even steps.
 */

#include "table_cell.h"

/* The cell that holds ``u`` [cells], and where in it, 0 ... 1.
 *
 * ``u`` is clamped to 0 ... ``last``, and is 0 if it is not a number.
 */
static inline int64_t table_cell__table_cell(int64_t* cell, double* result_1, double u, double last)
{
    if (!(u > 0.0))
    {
        u = 0.0;
    }
    if (u > last)
    {
        u = last;
    }
    (*cell) = (int64_t)(u);
    if ((*cell) > (int64_t)(last) - INT64_C(1))
    {
        (*cell) = (int64_t)(last) - INT64_C(1);
    }
    (*result_1) = u - (double)((*cell));
    return 0;
}
