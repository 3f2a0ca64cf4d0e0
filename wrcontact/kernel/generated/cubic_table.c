/* Generated from surface/cubic_table.py by tools/transpile_kernel.py; change that one.
 *
 * A function read from a table of cubics over even cells (the record CubicTable).
 */

#include "cubic_table.h"

/* Value of the function; outside the table, that at its end. */
static inline double cubic_table__read_cubic(array_double_1d tables, int64_t table, double at)
{
    int64_t cell;
    double x;
    int64_t cubic;
    double result;
    table_cell__table_cell(&cell, &x, (at - (*cspan_at(&tables, table + layout__CUBIC_TABLE_START))) * (*cspan_at(&tables, table + layout__CUBIC_TABLE_CELLS_PER_UNIT)), (*cspan_at(&tables, table + layout__CUBIC_TABLE_COUNT)));
    cubic = table + layout__CUBIC_TABLE_CELLS + layout__CUBIC_SIZE * cell;
    result = (*cspan_at(&tables, cubic + layout__CUBIC_VALUE)) + x * ((*cspan_at(&tables, cubic + layout__CUBIC_SLOPE)) + x * ((*cspan_at(&tables, cubic + layout__CUBIC_BEND)) + x * (*cspan_at(&tables, cubic + layout__CUBIC_THIRD))));
    return result;
}

/* Value of the function and its derivative; outside the table, those at its end. */
static inline int64_t cubic_table__read_cubic_jet(double* result_0, double* result_1, array_double_1d tables, int64_t table, double at)
{
    int64_t cell;
    double x;
    int64_t cubic;
    double q2;
    double q1;
    table_cell__table_cell(&cell, &x, (at - (*cspan_at(&tables, table + layout__CUBIC_TABLE_START))) * (*cspan_at(&tables, table + layout__CUBIC_TABLE_CELLS_PER_UNIT)), (*cspan_at(&tables, table + layout__CUBIC_TABLE_COUNT)));
    cubic = table + layout__CUBIC_TABLE_CELLS + layout__CUBIC_SIZE * cell;
    q2 = (*cspan_at(&tables, cubic + layout__CUBIC_BEND)) + x * (*cspan_at(&tables, cubic + layout__CUBIC_THIRD));
    q1 = (*cspan_at(&tables, cubic + layout__CUBIC_SLOPE)) + x * q2;
    (*result_0) = (*cspan_at(&tables, cubic + layout__CUBIC_VALUE)) + x * q1;
    (*result_1) = (q1 + x * (q2 + x * (*cspan_at(&tables, cubic + layout__CUBIC_THIRD)))) * (*cspan_at(&tables, table + layout__CUBIC_TABLE_CELLS_PER_UNIT));
    return 0;
}
