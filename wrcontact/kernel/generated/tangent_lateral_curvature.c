/* Generated from tangent_lateral_curvature.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of lateral_curvature.py.
 */

#include "tangent_lateral_curvature.h"

/* Tangent of ``profile_curvature``. */
static inline int64_t tangent_lateral_curvature__profile_curvature_t(double* result_0, double* result_1, array_double_1d tables, int64_t table, double y, double y_t)
{
    double v1;
    int64_t cell;
    double share;
    double share_t;
    double before;
    double v2;
    v1 = y - (*cspan_at(&tables, table + layout__CURVATURE_TABLE_START));
    tangent_table_cell__table_cell_t(&cell, &share, &share_t, v1 * (*cspan_at(&tables, table + layout__CURVATURE_TABLE_PER_METRE)), y_t * (*cspan_at(&tables, table + layout__CURVATURE_TABLE_PER_METRE)), (*cspan_at(&tables, table + layout__CURVATURE_TABLE_COUNT)) - 1.0, 0.0);
    before = (*cspan_at(&tables, table + layout__CURVATURE_TABLE_CURVATURES + cell));
    v2 = (*cspan_at(&tables, table + layout__CURVATURE_TABLE_CURVATURES + (cell + INT64_C(1)))) - before;
    (*result_0) = before + share * v2;
    (*result_1) = share_t * v2;
    return 0;
}

/* Tangent of ``relative_curvature``. */
static inline int64_t tangent_lateral_curvature__relative_curvature_t(double* result_0, double* result_1, array_double_1d tables, double y, double y_t, double abscissa, double abscissa_t)
{
    double v1;
    double v1_t;
    double wheel_t;
    double wheel;
    double v2;
    double v2_t;
    double rail_t;
    double rail;
    double v3;
    tangent_lateral_curvature__profile_curvature_t(&v1, &v1_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL_CURVATURE))), y, y_t);
    wheel_t = v1_t;
    wheel = v1;
    tangent_lateral_curvature__profile_curvature_t(&v2, &v2_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL_CURVATURE))), abscissa, abscissa_t);
    rail_t = v2_t;
    rail = v2;
    v3 = wheel + rail;
    (*result_0) = 0.5 * v3;
    (*result_1) = 0.5 * (wheel_t + rail_t);
    return 0;
}
