/* Generated from tangent_followed_overlaps.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of followed_overlaps.py.
 */

#include "tangent_followed_overlaps.h"

/* Tangent of ``keep_points``. */
static inline int64_t tangent_followed_overlaps__keep_points_t(array_double_1d work, array_double_1d work_t, int64_t kept)
{
    int64_t entry_end;
    int64_t entry;
    (*cspan_at(&work_t, kept + layout__DEEP_POINTS_COUNT)) = 0.0;
    (*cspan_at(&work, kept + layout__DEEP_POINTS_COUNT)) = (double)((int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_COUNT))));
    entry_end = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_COUNT)));
    for (entry = INT64_C(0); entry < entry_end; entry += INT64_C(1))
    {
        tangent_deep_points__copy_point_t(work, work_t, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_POINTS + layout__DEEP_POINT_SIZE * entry, kept + layout__DEEP_POINTS_POINTS + layout__DEEP_POINT_SIZE * entry);
    }
    return INT64_C(0);
}

/* Tangent of ``follow_overlaps``. */
static inline int64_t tangent_followed_overlaps__follow_overlaps_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t kept, int64_t place, double height, double height_t)
{
    int64_t entry_end;
    int64_t entry;
    int64_t point;
    double x_t;
    double x;
    double rail;
    double rail_t;
    double wheel;
    double wheel_t;
    double depth;
    double depth_t;
    int64_t turned;
    int64_t result;
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_HEIGHT)) = height_t;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_HEIGHT)) = height;
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_COUNT)) = 0.0;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_COUNT)) = (double)((int64_t)((*cspan_at(&work, kept + layout__DEEP_POINTS_COUNT))));
    entry_end = (int64_t)((*cspan_at(&work, kept + layout__DEEP_POINTS_COUNT)));
    for (entry = INT64_C(0); entry < entry_end; entry += INT64_C(1))
    {
        point = layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_POINTS + layout__DEEP_POINT_SIZE * entry;
        tangent_deep_points__copy_point_t(work, work_t, kept + layout__DEEP_POINTS_POINTS + layout__DEEP_POINT_SIZE * entry, point);
        x_t = (*cspan_at(&work_t, point + layout__DEEP_POINT_RAIL));
        x = (*cspan_at(&work, point + layout__DEEP_POINT_RAIL));
        tangent_touching__turning_point_t(&rail, &rail_t, &wheel, &wheel_t, &depth, &depth_t, &turned, work, work_t, tables, place, x - followed_overlaps__FOLLOWED, x_t, x + followed_overlaps__FOLLOWED, x_t, (*cspan_at(&work, point + layout__DEEP_POINT_WHEEL)), (*cspan_at(&work_t, point + layout__DEEP_POINT_WHEEL)), height, height_t, 1.0, 0.0);
        if ((turned == INT64_C(0)) || (!(depth > 0.0)))
        {
            return INT64_C(0);
        }
        (*cspan_at(&work_t, point + layout__DEEP_POINT_RAIL)) = rail_t;
        (*cspan_at(&work, point + layout__DEEP_POINT_RAIL)) = rail;
        (*cspan_at(&work_t, point + layout__DEEP_POINT_WHEEL)) = wheel_t;
        (*cspan_at(&work, point + layout__DEEP_POINT_WHEEL)) = wheel;
        (*cspan_at(&work_t, point + layout__DEEP_POINT_DEPTH)) = depth_t;
        (*cspan_at(&work, point + layout__DEEP_POINT_DEPTH)) = depth;
    }
    entry_end = (int64_t)((*cspan_at(&work, kept + layout__DEEP_POINTS_COUNT))) - INT64_C(1);
    for (entry = INT64_C(0); entry < entry_end; entry += INT64_C(1))
    {
        tangent_followed_overlaps__follow_saddle_t(work, work_t, tables, place, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_POINTS + layout__DEEP_POINT_SIZE * entry, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_POINTS + layout__DEEP_POINT_SIZE * (entry + INT64_C(1)), height, height_t);
    }
    result = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_COUNT)));
    return result;
}

/* Tangent of ``follow_saddle``. */
static inline int64_t tangent_followed_overlaps__follow_saddle_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t place, int64_t point, int64_t following, double height, double height_t)
{
    double v1;
    double y_t;
    double y;
    double reach_t;
    double reach;
    double x;
    double x_t;
    double depth;
    double depth_t;
    int64_t turned;
    double v2;
    v1 = (*cspan_at(&work, point + layout__DEEP_POINT_WHEEL)) + (*cspan_at(&work, following + layout__DEEP_POINT_WHEEL));
    y_t = 0.5 * ((*cspan_at(&work_t, point + layout__DEEP_POINT_WHEEL)) + (*cspan_at(&work_t, following + layout__DEEP_POINT_WHEEL)));
    y = 0.5 * v1;
    reach_t = 0.0;
    reach = followed_overlaps__FOLLOWED;
    if ((*cspan_at(&work, point + layout__DEEP_POINT_SADDLE)) - (*cspan_at(&work, point + layout__DEEP_POINT_RAIL)) < reach)
    {
        reach_t = (*cspan_at(&work_t, point + layout__DEEP_POINT_SADDLE)) - (*cspan_at(&work_t, point + layout__DEEP_POINT_RAIL));
        reach = (*cspan_at(&work, point + layout__DEEP_POINT_SADDLE)) - (*cspan_at(&work, point + layout__DEEP_POINT_RAIL));
    }
    if ((*cspan_at(&work, following + layout__DEEP_POINT_RAIL)) - (*cspan_at(&work, point + layout__DEEP_POINT_SADDLE)) < reach)
    {
        reach_t = (*cspan_at(&work_t, following + layout__DEEP_POINT_RAIL)) - (*cspan_at(&work_t, point + layout__DEEP_POINT_SADDLE));
        reach = (*cspan_at(&work, following + layout__DEEP_POINT_RAIL)) - (*cspan_at(&work, point + layout__DEEP_POINT_SADDLE));
    }
    tangent_touching__turning_point_t(&x, &x_t, &y, &y_t, &depth, &depth_t, &turned, work, work_t, tables, place, (*cspan_at(&work, point + layout__DEEP_POINT_SADDLE)) - reach, (*cspan_at(&work_t, point + layout__DEEP_POINT_SADDLE)) - reach_t, (*cspan_at(&work, point + layout__DEEP_POINT_SADDLE)) + reach, (*cspan_at(&work_t, point + layout__DEEP_POINT_SADDLE)) + reach_t, y, y_t, height, height_t, -1.0, 0.0);
    if (turned == INT64_C(0))
    {
        v2 = (*cspan_at(&work, point + layout__DEEP_POINT_WHEEL)) + (*cspan_at(&work, following + layout__DEEP_POINT_WHEEL));
        tangent_touching__turning_point_t(&x, &x_t, &y, &y_t, &depth, &depth_t, &turned, work, work_t, tables, place, (*cspan_at(&work, point + layout__DEEP_POINT_RAIL)), (*cspan_at(&work_t, point + layout__DEEP_POINT_RAIL)), (*cspan_at(&work, following + layout__DEEP_POINT_RAIL)), (*cspan_at(&work_t, following + layout__DEEP_POINT_RAIL)), 0.5 * v2, 0.5 * ((*cspan_at(&work_t, point + layout__DEEP_POINT_WHEEL)) + (*cspan_at(&work_t, following + layout__DEEP_POINT_WHEEL))), height, height_t, -1.0, 0.0);
    }
    (*cspan_at(&work_t, point + layout__DEEP_POINT_SADDLE)) = x_t;
    (*cspan_at(&work, point + layout__DEEP_POINT_SADDLE)) = x;
    (*cspan_at(&work_t, point + layout__DEEP_POINT_BETWEEN)) = depth_t;
    (*cspan_at(&work, point + layout__DEEP_POINT_BETWEEN)) = depth;
    return INT64_C(0);
}
