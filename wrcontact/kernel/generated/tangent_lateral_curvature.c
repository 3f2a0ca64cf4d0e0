/* Generated from tangent_lateral_curvature.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of lateral_curvature.py.
 */

#include "tangent_lateral_curvature.h"

/* Tangent of ``profile_curvature``. */
static inline int64_t tangent_lateral_curvature__profile_curvature_t(double* result_0, double* result_1, array_double_1d tables, int64_t table, double y, double y_t)
{
    double v1;
    double u_t;
    double u;
    double last;
    int64_t cell;
    double before;
    double v2;
    double v3;
    v1 = y - (*cspan_at(&tables, table + layout__CURVATURE_TABLE_START));
    u_t = y_t * (*cspan_at(&tables, table + layout__CURVATURE_TABLE_PER_METRE));
    u = v1 * (*cspan_at(&tables, table + layout__CURVATURE_TABLE_PER_METRE));
    last = (*cspan_at(&tables, table + layout__CURVATURE_TABLE_COUNT)) - 1.0;
    if (!(u > 0.0))
    {
        u_t = 0.0;
        u = 0.0;
    }
    if (u > last)
    {
        u_t = 0.0;
        u = last;
    }
    cell = (int64_t)(u);
    if (cell > (int64_t)(last) - INT64_C(1))
    {
        cell = (int64_t)(last) - INT64_C(1);
    }
    before = (*cspan_at(&tables, table + layout__CURVATURE_TABLE_CURVATURES + cell));
    v2 = u - (double)(cell);
    v3 = (*cspan_at(&tables, table + layout__CURVATURE_TABLE_CURVATURES + (cell + INT64_C(1)))) - before;
    (*result_0) = before + v2 * v3;
    (*result_1) = u_t * v3;
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
