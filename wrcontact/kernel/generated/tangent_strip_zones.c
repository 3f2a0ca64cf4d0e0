/* Generated from tangent_strip_zones.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of strip_zones.py.
 */

#include "tangent_strip_zones.h"

/* Tangent of ``find_zones``. */
static inline int64_t tangent_strip_zones__find_zones_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, int64_t count, double deepest, double deepest_t)
{
    int64_t index;
    int64_t region;
    for (index = INT64_C(0); index < count; index += INT64_C(1))
    {
        region = layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * index;
        tangent_planes__enter_plane_t(work, work_t, region, index);
        tangent_strip_zones__measure_zone_t(work, work_t, tables, state, region, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_ZONES + layout__STRIP_ZONE_SIZE * index, deepest, deepest_t);
        tangent_planes__leave_plane_t(work, work_t, region);
    }
    return INT64_C(0);
}

/* Tangent of ``measure_zone``. */
static inline int64_t tangent_strip_zones__measure_zone_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, int64_t region, int64_t zone, double deepest, double deepest_t)
{
    double depth_t;
    double depth;
    double shallow_t;
    double shallow;
    double level_t;
    double level;
    double bend_t;
    double bend;
    double v1;
    double v2;
    double v3;
    double estimate_t;
    double estimate;
    double v4;
    double v4_t;
    double high_t;
    double high;
    double v5;
    double v5_t;
    double low_t;
    double low;
    (*cspan_at(&work_t, zone + layout__STRIP_ZONE_START)) = (*cspan_at(&work_t, region + layout__REGION_OFFSET)) + (*cspan_at(&work_t, region + layout__REGION_STATION));
    (*cspan_at(&work, zone + layout__STRIP_ZONE_START)) = (*cspan_at(&work, region + layout__REGION_OFFSET)) + (*cspan_at(&work, region + layout__REGION_STATION));
    (*cspan_at(&work_t, zone + layout__STRIP_ZONE_STOP)) = (*cspan_at(&work_t, zone + layout__STRIP_ZONE_START));
    (*cspan_at(&work, zone + layout__STRIP_ZONE_STOP)) = (*cspan_at(&work, zone + layout__STRIP_ZONE_START));
    depth_t = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_DEPTH));
    depth = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_DEPTH));
    shallow_t = strip_zones__SHALLOW * deepest_t;
    shallow = strip_zones__SHALLOW * deepest;
    if (shallow > strip_zones__OWN_SHALLOW * depth)
    {
        shallow_t = strip_zones__OWN_SHALLOW * depth_t;
        shallow = strip_zones__OWN_SHALLOW * depth;
    }
    level_t = depth_t - shallow_t;
    level = depth - shallow;
    (*cspan_at(&work_t, zone + layout__STRIP_ZONE_LEVEL)) = 0.0;
    (*cspan_at(&work, zone + layout__STRIP_ZONE_LEVEL)) = 0.0;
    if (level > 0.0)
    {
        (*cspan_at(&work_t, zone + layout__STRIP_ZONE_LEVEL)) = level_t;
        (*cspan_at(&work, zone + layout__STRIP_ZONE_LEVEL)) = level;
        bend_t = (*cspan_at(&work_t, region + layout__REGION_BEND));
        bend = (*cspan_at(&work, region + layout__REGION_BEND));
        if (bend < (*cspan_at(&work, region + layout__REGION_CURVATURE)))
        {
            bend_t = (*cspan_at(&work_t, region + layout__REGION_CURVATURE));
            bend = (*cspan_at(&work, region + layout__REGION_CURVATURE));
        }
        v1 = 2.0 * level;
        v2 = v1 / bend;
        v3 = sqrt(v2);
        estimate_t = tangent_rates__root_rate(v3, (2.0 * level_t - v2 * bend_t) / bend);
        estimate = v3;
        (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_BLUR)) = 0.0;
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_BLUR)) = 0.0;
        tangent_zone_width__width_rule_t(&v4, &v4_t, work, work_t, tables, region, state, 1.0, 0.0, level, level_t, estimate, estimate_t);
        high_t = v4_t;
        high = v4;
        tangent_zone_width__width_rule_t(&v5, &v5_t, work, work_t, tables, region, state, -1.0, 0.0, level, level_t, high, high_t);
        low_t = v5_t;
        low = v5;
        (*cspan_at(&work_t, zone + layout__STRIP_ZONE_STOP)) = (*cspan_at(&work_t, zone + layout__STRIP_ZONE_START)) + high_t;
        (*cspan_at(&work, zone + layout__STRIP_ZONE_STOP)) = (*cspan_at(&work, zone + layout__STRIP_ZONE_START)) + high;
        (*cspan_at(&work_t, zone + layout__STRIP_ZONE_START)) = (*cspan_at(&work_t, zone + layout__STRIP_ZONE_START)) - low_t;
        (*cspan_at(&work, zone + layout__STRIP_ZONE_START)) = (*cspan_at(&work, zone + layout__STRIP_ZONE_START)) - low;
    }
    return INT64_C(0);
}
