/* Generated from normal/strip_zones.py by tools/transpile_kernel.py; change that one.
 *
 * Where wheel and rail overlap as they are laid: there the first strips lie.
 */

#include "strip_zones.h"

/* The zones of ``count`` regions, of which the deepest overlaps by ``deepest`` [m]. */
static inline int64_t strip_zones__find_zones(array_double_1d work, array_double_1d tables, array_double_1d state, int64_t count, double deepest)
{
    int64_t index;
    int64_t region;
    for (index = INT64_C(0); index < count; index += INT64_C(1))
    {
        region = layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * index;
        planes__enter_plane(work, region, index);
        strip_zones__measure_zone(work, tables, state, region, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_ZONES + layout__STRIP_ZONE_SIZE * index, deepest);
        planes__leave_plane(work, region);
    }
    return INT64_C(0);
}

/* The zone of a region whose frame is open; without width where nothing overlaps. */
static inline int64_t strip_zones__measure_zone(array_double_1d work, array_double_1d tables, array_double_1d state, int64_t region, int64_t zone, double deepest)
{
    double depth;
    double shallow;
    double level;
    double bend;
    double estimate;
    double high;
    double low;
    (*cspan_at(&work, zone + layout__STRIP_ZONE_START)) = (*cspan_at(&work, region + layout__REGION_OFFSET)) + (*cspan_at(&work, region + layout__REGION_STATION));
    (*cspan_at(&work, zone + layout__STRIP_ZONE_STOP)) = (*cspan_at(&work, zone + layout__STRIP_ZONE_START));
    depth = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_DEPTH));
    shallow = strip_zones__SHALLOW * deepest;
    if (shallow > strip_zones__OWN_SHALLOW * depth)
    {
        shallow = strip_zones__OWN_SHALLOW * depth;
    }
    level = depth - shallow;
    (*cspan_at(&work, zone + layout__STRIP_ZONE_LEVEL)) = 0.0;
    if (level > 0.0)
    {
        (*cspan_at(&work, zone + layout__STRIP_ZONE_LEVEL)) = level;
        bend = (*cspan_at(&work, region + layout__REGION_BEND));
        if (bend < (*cspan_at(&work, region + layout__REGION_CURVATURE)))
        {
            bend = (*cspan_at(&work, region + layout__REGION_CURVATURE));
        }
        estimate = sqrt(2.0 * level / bend);
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_BLUR)) = 0.0;
        high = zone_width__zone_width(work, tables, region, state, 1.0, level, estimate);
        low = zone_width__zone_width(work, tables, region, state, -1.0, level, high);
        (*cspan_at(&work, zone + layout__STRIP_ZONE_STOP)) = (*cspan_at(&work, zone + layout__STRIP_ZONE_START)) + high;
        (*cspan_at(&work, zone + layout__STRIP_ZONE_START)) -= low;
    }
    return INT64_C(0);
}
