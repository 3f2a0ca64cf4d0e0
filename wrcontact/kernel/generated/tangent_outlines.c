/* Generated from tangent_outlines.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of outlines.py.
 */

#include "tangent_outlines.h"

/* Tangent of ``fill_apart``. */
static inline int64_t tangent_outlines__fill_apart_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t index, double value, double value_t)
{
    if ((int64_t)((*cspan_at(&tables, layout__TABLES_STATIONS))) != layout__STATION_COUNT)
    {
        tangent_outline__fill_outline_t(work, work_t, outlines__outline_place(tables, work, index), (int64_t)((*cspan_at(&tables, layout__TABLES_STATIONS))), value, value_t);
    }
    return INT64_C(0);
}
