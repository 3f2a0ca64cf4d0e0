/* Generated from tangential/shapes.py by tools/transpile_kernel.py; change that one.
 *
 * What depends on the shape of a patch, its length over its width, from the table of rolling.
 */

#include "shapes.h"

/* Place of a/b in the table, counted in cells; beyond its ends the shape of the end is taken. */
static inline double shapes__shape_place(double axis_ratio)
{
    return (log(axis_ratio) - layout__SHAPE_START) * layout__SHAPE_PER_UNIT;
}

/* Value of a column, 0 ... SHAPE_COLUMNS - 1, at a place. */
static inline double shapes__shape_value(array_double_1d tables, int64_t table, int64_t column, double place)
{
    int64_t cell;
    double u;
    int64_t at;
    double high;
    double result;
    table_cell__table_cell(&cell, &u, place, (double)(layout__SHAPE_CELLS));
    at = layout__SHAPE_ROW * cell + INT64_C(4) * column;
    high = (*cspan_at(&tables, table + layout__ROLLING_TABLE_SHAPES + (at + INT64_C(2)))) + u * (*cspan_at(&tables, table + layout__ROLLING_TABLE_SHAPES + (at + INT64_C(3))));
    result = (*cspan_at(&tables, table + layout__ROLLING_TABLE_SHAPES + at)) + u * ((*cspan_at(&tables, table + layout__ROLLING_TABLE_SHAPES + (at + INT64_C(1)))) + u * high);
    return result;
}

/* Kalker's creepage coefficients C11, C22, C23 of an ellipse with this a/b, length over width. */
static inline int64_t shapes__kalker_coefficients(double* result_0, double* result_1, double* result_2, array_double_1d tables, int64_t table, double axis_ratio)
{
    double place;
    place = shapes__shape_place(axis_ratio);
    (*result_0) = 1.0 / shapes__shape_value(tables, table, INT64_C(0), place);
    (*result_1) = 1.0 / shapes__shape_value(tables, table, INT64_C(1), place);
    (*result_2) = 1.0 / shapes__shape_value(tables, table, INT64_C(2), place);
    return 0;
}
