/* Generated from tangent_shapes.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of shapes.py.
 */

#include "tangent_shapes.h"

/* Tangent of ``shape_place``. */
static inline int64_t tangent_shapes__shape_place_t(double* result_0, double* result_1, double axis_ratio, double axis_ratio_t)
{
    double v1;
    v1 = log(axis_ratio) - layout__SHAPE_START;
    (*result_0) = v1 * layout__SHAPE_PER_UNIT;
    (*result_1) = axis_ratio_t / axis_ratio * layout__SHAPE_PER_UNIT;
    return 0;
}

/* Tangent of ``shape_value``. */
static inline int64_t tangent_shapes__shape_value_t(double* result_0, double* result_1, array_double_1d tables, int64_t table, int64_t column, double place, double place_t)
{
    int64_t cell;
    double u;
    double u_t;
    int64_t at;
    double high_t;
    double high;
    double v1;
    tangent_table_cell__table_cell_t(&cell, &u, &u_t, place, place_t, (double)(layout__SHAPE_CELLS), 0.0);
    at = layout__SHAPE_ROW * cell + INT64_C(4) * column;
    high_t = u_t * (*cspan_at(&tables, table + layout__ROLLING_TABLE_SHAPES + (at + INT64_C(3))));
    high = (*cspan_at(&tables, table + layout__ROLLING_TABLE_SHAPES + (at + INT64_C(2)))) + u * (*cspan_at(&tables, table + layout__ROLLING_TABLE_SHAPES + (at + INT64_C(3))));
    v1 = (*cspan_at(&tables, table + layout__ROLLING_TABLE_SHAPES + (at + INT64_C(1)))) + u * high;
    (*result_0) = (*cspan_at(&tables, table + layout__ROLLING_TABLE_SHAPES + at)) + u * v1;
    (*result_1) = u_t * v1 + u * (u_t * high + u * high_t);
    return 0;
}

/* Tangent of ``kalker_coefficients``. */
static inline int64_t tangent_shapes__kalker_coefficients_t(double* v3, double* result_1, double* v5, double* result_3, double* v7, double* result_5, array_double_1d tables, int64_t table, double axis_ratio, double axis_ratio_t)
{
    double v1;
    double v1_t;
    double place_t;
    double place;
    double v2;
    double v2_t;
    double v4;
    double v4_t;
    double v6;
    double v6_t;
    tangent_shapes__shape_place_t(&v1, &v1_t, axis_ratio, axis_ratio_t);
    place_t = v1_t;
    place = v1;
    tangent_shapes__shape_value_t(&v2, &v2_t, tables, table, INT64_C(0), place, place_t);
    (*v3) = 1.0 / v2;
    tangent_shapes__shape_value_t(&v4, &v4_t, tables, table, INT64_C(1), place, place_t);
    (*v5) = 1.0 / v4;
    tangent_shapes__shape_value_t(&v6, &v6_t, tables, table, INT64_C(2), place, place_t);
    (*v7) = 1.0 / v6;
    (*result_1) = (-(*v3)) * v2_t / v2;
    (*result_3) = (-(*v5)) * v4_t / v4;
    (*result_5) = (-(*v7)) * v6_t / v6;
    return 0;
}
