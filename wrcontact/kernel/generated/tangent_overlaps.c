/* Generated from tangent_overlaps.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of overlaps.py.
 */

#include "tangent_overlaps.h"

/* Tangent of ``turning_rule``. */
static inline int64_t tangent_overlaps__turning_rule_t(double* found_x, double* found_x_t, double* result_2, double* result_3, double* overlap, double* overlap_t, int64_t* found, array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t place, double x, double x_t, double y, double y_t, double height, double height_t)
{
    double rise;
    double rise_t;
    double rate;
    double rate_t;
    double z;
    double z_t;
    double slope;
    double slope_t;
    double bend;
    double bend_t;
    double more;
    double more_t;
    double change;
    double v1;
    x_t = 0.0;
    (*found_x_t) = x_t;
    (*found_x) = x;
    tangent_pressed__meet_rule_t(&y, &y_t, overlap, overlap_t, &rise, &rise_t, &rate, &rate_t, &z, &z_t, &slope, &slope_t, &bend, &bend_t, found, work, work_t, tables, place, x, x_t, y, 0.0, height, height_t, pressed__LINE_SHARP, 0.0);
    if ((*found) == INT64_C(1))
    {
        tangent_pressed__meet_rule_t(&y, &y_t, overlap, overlap_t, &more, &more_t, &rate, &rate_t, &z, &z_t, &slope, &slope_t, &bend, &bend_t, found, work, work_t, tables, place, x, 1.0, y, 0.0, height, height_t, pressed__LINE_SHARP, 0.0);
        change = more_t - rise_t;
        if (change != 0.0)
        {
            v1 = -rise;
            (*found_x_t) = (-rise_t) / change;
            (*found_x) = x;
        }
        tangent_pressed__meet_rule_t(&y, &y_t, overlap, overlap_t, &more, &more_t, &rate, &rate_t, &z, &z_t, &slope, &slope_t, &bend, &bend_t, found, work, work_t, tables, place, (*found_x), (*found_x_t), y, 0.0, height, height_t, pressed__LINE_SHARP, 0.0);
    }
    (*result_2) = y;
    (*result_3) = y_t;
    return 0;
}

/* Tangent of ``overlaps_rule``. */
static inline int64_t tangent_overlaps__overlaps_rule_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t side, array_double_1d state, double height, double height_t)
{
    int64_t n1;
    int64_t entry;
    int64_t point;
    double x;
    double x_t;
    double y;
    double y_t;
    double depth;
    double depth_t;
    int64_t found;
    int64_t following;
    double v2;
    int64_t count;
    n1 = overlaps__find_overlaps(work, tables, side, state, height);
    count = n1;
    for (entry = INT64_C(0); entry < count; entry += INT64_C(1))
    {
        point = layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_POINTS + layout__DEEP_POINT_SIZE * entry;
        tangent_overlaps__turning_rule_t(&x, &x_t, &y, &y_t, &depth, &depth_t, &found, work, work_t, tables, side + layout__SIDE_SEARCH_PLACE, (*cspan_at(&work, point + layout__DEEP_POINT_RAIL)), (*cspan_at(&work_t, point + layout__DEEP_POINT_RAIL)), (*cspan_at(&work, point + layout__DEEP_POINT_WHEEL)), (*cspan_at(&work_t, point + layout__DEEP_POINT_WHEEL)), height, height_t);
        (*cspan_at(&work_t, point + layout__DEEP_POINT_RAIL)) = x_t;
        (*cspan_at(&work_t, point + layout__DEEP_POINT_WHEEL)) = y_t;
        (*cspan_at(&work_t, point + layout__DEEP_POINT_DEPTH)) = depth_t;
    }
    for (entry = INT64_C(0); entry < count - INT64_C(1); entry += INT64_C(1))
    {
        point = layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_POINTS + layout__DEEP_POINT_SIZE * entry;
        following = layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_POINTS + layout__DEEP_POINT_SIZE * (entry + INT64_C(1));
        v2 = (*cspan_at(&work, point + layout__DEEP_POINT_WHEEL)) + (*cspan_at(&work, following + layout__DEEP_POINT_WHEEL));
        tangent_overlaps__turning_rule_t(&x, &x_t, &y, &y_t, &depth, &depth_t, &found, work, work_t, tables, side + layout__SIDE_SEARCH_PLACE, (*cspan_at(&work, point + layout__DEEP_POINT_SADDLE)), (*cspan_at(&work_t, point + layout__DEEP_POINT_SADDLE)), 0.5 * v2, 0.5 * ((*cspan_at(&work_t, point + layout__DEEP_POINT_WHEEL)) + (*cspan_at(&work_t, following + layout__DEEP_POINT_WHEEL))), height, height_t);
        (*cspan_at(&work_t, point + layout__DEEP_POINT_SADDLE)) = x_t;
        (*cspan_at(&work_t, point + layout__DEEP_POINT_BETWEEN)) = depth_t;
    }
    return count;
}
