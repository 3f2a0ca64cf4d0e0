/* Generated from tangent_deep_points.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of deep_points.py.
 */

#include "tangent_deep_points.h"

/* Tangent of ``copy_point``. */
static inline int64_t tangent_deep_points__copy_point_t(array_double_1d work, array_double_1d work_t, int64_t point, int64_t copy)
{
    (*cspan_at(&work_t, copy + layout__DEEP_POINT_RAIL)) = (*cspan_at(&work_t, point + layout__DEEP_POINT_RAIL));
    (*cspan_at(&work, copy + layout__DEEP_POINT_RAIL)) = (*cspan_at(&work, point + layout__DEEP_POINT_RAIL));
    (*cspan_at(&work_t, copy + layout__DEEP_POINT_WHEEL)) = (*cspan_at(&work_t, point + layout__DEEP_POINT_WHEEL));
    (*cspan_at(&work, copy + layout__DEEP_POINT_WHEEL)) = (*cspan_at(&work, point + layout__DEEP_POINT_WHEEL));
    (*cspan_at(&work_t, copy + layout__DEEP_POINT_DEPTH)) = (*cspan_at(&work_t, point + layout__DEEP_POINT_DEPTH));
    (*cspan_at(&work, copy + layout__DEEP_POINT_DEPTH)) = (*cspan_at(&work, point + layout__DEEP_POINT_DEPTH));
    (*cspan_at(&work_t, copy + layout__DEEP_POINT_SADDLE)) = (*cspan_at(&work_t, point + layout__DEEP_POINT_SADDLE));
    (*cspan_at(&work, copy + layout__DEEP_POINT_SADDLE)) = (*cspan_at(&work, point + layout__DEEP_POINT_SADDLE));
    (*cspan_at(&work_t, copy + layout__DEEP_POINT_BETWEEN)) = (*cspan_at(&work_t, point + layout__DEEP_POINT_BETWEEN));
    (*cspan_at(&work, copy + layout__DEEP_POINT_BETWEEN)) = (*cspan_at(&work, point + layout__DEEP_POINT_BETWEEN));
    return INT64_C(0);
}

/* Tangent of ``keep_deepest``. */
static inline int64_t tangent_deep_points__keep_deepest_t(array_double_1d work, array_double_1d work_t)
{
    tangent_deep_points__copy_point_t(work, work_t, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_POINTS + layout__DEEP_POINT_SIZE * deep_points__deepest_entry(work), layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_POINTS);
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_COUNT)) = 0.0;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_COUNT)) = 1.0;
    return INT64_C(0);
}
