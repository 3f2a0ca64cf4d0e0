/* Generated from tangent_outline.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of outline.py.
 */

#include "tangent_outline.h"

/* Tangent of ``fill_apart``. */
static inline int64_t tangent_outline__fill_apart_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t out, double value, double value_t)
{
    int64_t stations;
    int64_t place;
    int64_t i;
    stations = (int64_t)((*cspan_at(&tables, layout__TABLES_STATIONS)));
    if (stations != layout__STATION_COUNT)
    {
        place = outline__outline_place(tables, work, out);
        for (i = INT64_C(0); i < INT64_C(3) * stations; i += INT64_C(1))
        {
            (*cspan_at(&work_t, place + i)) = value_t;
            (*cspan_at(&work, place + i)) = value;
        }
    }
    return INT64_C(0);
}
