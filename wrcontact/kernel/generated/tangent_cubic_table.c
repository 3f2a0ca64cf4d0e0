/* Generated from tangent_cubic_table.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of cubic_table.py.
 */

#include "tangent_cubic_table.h"

/* Tangent of ``read_cubic``. */
static inline int64_t tangent_cubic_table__read_cubic_t(double* result_0, double* result_1, array_double_1d tables, int64_t table, double at, double at_t)
{
    double v1;
    int64_t cell;
    double x;
    double x_t;
    int64_t cubic;
    double v2;
    double v3;
    v1 = at - (*cspan_at(&tables, table + layout__CUBIC_TABLE_START));
    tangent_table_cell__table_cell_t(&cell, &x, &x_t, v1 * (*cspan_at(&tables, table + layout__CUBIC_TABLE_CELLS_PER_UNIT)), at_t * (*cspan_at(&tables, table + layout__CUBIC_TABLE_CELLS_PER_UNIT)), (*cspan_at(&tables, table + layout__CUBIC_TABLE_COUNT)), 0.0);
    cubic = table + layout__CUBIC_TABLE_CELLS + layout__CUBIC_SIZE * cell;
    v2 = (*cspan_at(&tables, cubic + layout__CUBIC_BEND)) + x * (*cspan_at(&tables, cubic + layout__CUBIC_THIRD));
    v3 = (*cspan_at(&tables, cubic + layout__CUBIC_SLOPE)) + x * v2;
    (*result_0) = (*cspan_at(&tables, cubic + layout__CUBIC_VALUE)) + x * v3;
    (*result_1) = x_t * v3 + x * (x_t * v2 + x * (x_t * (*cspan_at(&tables, cubic + layout__CUBIC_THIRD))));
    return 0;
}

/* Tangent of ``read_cubic_jet``. */
static inline int64_t tangent_cubic_table__read_cubic_jet_t(double* result_0, double* result_1, double* result_2, double* result_3, array_double_1d tables, int64_t table, double at, double at_t)
{
    double v1;
    int64_t cell;
    double x;
    double x_t;
    int64_t cubic;
    double q2_t;
    double q2;
    double q1_t;
    double q1;
    double v2;
    double v3;
    v1 = at - (*cspan_at(&tables, table + layout__CUBIC_TABLE_START));
    tangent_table_cell__table_cell_t(&cell, &x, &x_t, v1 * (*cspan_at(&tables, table + layout__CUBIC_TABLE_CELLS_PER_UNIT)), at_t * (*cspan_at(&tables, table + layout__CUBIC_TABLE_CELLS_PER_UNIT)), (*cspan_at(&tables, table + layout__CUBIC_TABLE_COUNT)), 0.0);
    cubic = table + layout__CUBIC_TABLE_CELLS + layout__CUBIC_SIZE * cell;
    q2_t = x_t * (*cspan_at(&tables, cubic + layout__CUBIC_THIRD));
    q2 = (*cspan_at(&tables, cubic + layout__CUBIC_BEND)) + x * (*cspan_at(&tables, cubic + layout__CUBIC_THIRD));
    q1_t = x_t * q2 + x * q2_t;
    q1 = (*cspan_at(&tables, cubic + layout__CUBIC_SLOPE)) + x * q2;
    v2 = q2 + x * (*cspan_at(&tables, cubic + layout__CUBIC_THIRD));
    v3 = q1 + x * v2;
    (*result_0) = (*cspan_at(&tables, cubic + layout__CUBIC_VALUE)) + x * q1;
    (*result_1) = x_t * q1 + x * q1_t;
    (*result_2) = v3 * (*cspan_at(&tables, table + layout__CUBIC_TABLE_CELLS_PER_UNIT));
    (*result_3) = (q1_t + (x_t * v2 + x * (q2_t + x_t * (*cspan_at(&tables, cubic + layout__CUBIC_THIRD))))) * (*cspan_at(&tables, table + layout__CUBIC_TABLE_CELLS_PER_UNIT));
    return 0;
}
