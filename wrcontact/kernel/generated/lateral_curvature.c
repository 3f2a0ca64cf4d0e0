/* Generated from surface/lateral_curvature.py by tools/transpile_kernel.py; change that one.
 *
 * Lateral curvatures of wheel and rail profile, prepared once (prepare/curvatures.py) and read off along
 * them.
 */

#include "lateral_curvature.h"

/* Curvature [1/m] of the profile at ``y`` [m], linear between two values; beyond an end, the value at
 * that end.
 */
static inline double lateral_curvature__profile_curvature(array_double_1d tables, int64_t table, double y)
{
    int64_t cell;
    double share;
    double before;
    double result;
    table_cell__table_cell(&cell, &share, (y - (*cspan_at(&tables, table + layout__CURVATURE_TABLE_START))) * (*cspan_at(&tables, table + layout__CURVATURE_TABLE_PER_METRE)), (*cspan_at(&tables, table + layout__CURVATURE_TABLE_COUNT)) - 1.0);
    before = (*cspan_at(&tables, table + layout__CURVATURE_TABLE_CURVATURES + cell));
    result = before + share * ((*cspan_at(&tables, table + layout__CURVATURE_TABLE_CURVATURES + (cell + INT64_C(1)))) - before);
    return result;
}

/* B = (kappa_wheel + kappa_rail) / 2 [1/m] at wheel abscissa ``y`` and rail abscissa ``abscissa`` [m],
 * the source's eq. (6.5).
 */
static inline double lateral_curvature__relative_curvature(array_double_1d tables, double y, double abscissa)
{
    double wheel;
    double rail;
    wheel = lateral_curvature__profile_curvature(tables, (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL_CURVATURE))), y);
    rail = lateral_curvature__profile_curvature(tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL_CURVATURE))), abscissa);
    return 0.5 * (wheel + rail);
}
