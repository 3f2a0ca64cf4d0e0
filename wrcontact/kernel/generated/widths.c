/* Generated from normal/widths.py by tools/transpile_kernel.py; change that one.
 *
 * How wide the interpenetration of a region is, and the lateral curvatures that follow from it.
 */

#include "widths.h"

/* Half-widths of a region's interpenetration at this local penetration [m], the lateral curvatures on
 * both sides that follow from them, and the station its load is thought to act at.
 */
static inline int64_t widths__measure_widths(array_double_1d work, array_double_1d tables, array_double_1d state, int64_t region, double local_penetration)
{
    double bend;
    double low;
    double high;
    double grown;
    double high_reached;
    double slant;
    double start;
    int64_t yawed;
    /* the first guess: the gap's own second derivative, as far as it is a usual one */
    bend = (*cspan_at(&work, region + layout__REGION_BEND));
    if (bend < widths__LEAST_BEND * (*cspan_at(&work, region + layout__REGION_CURVATURE)))
    {
        bend = widths__LEAST_BEND * (*cspan_at(&work, region + layout__REGION_CURVATURE));
    }
    if (bend > widths__MOST_BEND * (*cspan_at(&work, region + layout__REGION_CURVATURE)))
    {
        bend = widths__MOST_BEND * (*cspan_at(&work, region + layout__REGION_CURVATURE));
    }
    low = sqrt(2.0 * local_penetration / bend);
    high = low;
    if ((*cspan_at(&work, region + layout__REGION_WIDTH_PENETRATION)) > 0.0)
    {
        grown = sqrt(local_penetration / (*cspan_at(&work, region + layout__REGION_WIDTH_PENETRATION)));
        low = (*cspan_at(&work, region + layout__REGION_WIDTH_LOW)) * grown;
        high = (*cspan_at(&work, region + layout__REGION_WIDTH_HIGH)) * grown;
    }
    high = zone_width__zone_width(work, tables, region, state, 1.0, local_penetration, high);
    high_reached = (*cspan_at(&work, region + layout__REGION_REACHED));
    slant = 0.0;
    start = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_STATION));
    yawed = contact_plane__is_yawed(work);
    if (yawed == INT64_C(1))
    {
        slant = locus__outline_x(work, tables, layout__WORK_CONTACT + layout__CONTACT_FRAME + (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLACE))), (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__WHEEL + layout__TRACE_ABSCISSA)));
    }
    if (!((*cspan_at(&work, region + layout__REGION_WIDTH_PENETRATION)) > 0.0))
    {
        low = high;
    }
    low = zone_width__zone_width(work, tables, region, state, -1.0, local_penetration, low);
    if (yawed == INT64_C(1))
    {
        slant -= locus__outline_x(work, tables, layout__WORK_CONTACT + layout__CONTACT_FRAME + (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLACE))), (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__WHEEL + layout__TRACE_ABSCISSA)));
        if (start > (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_STATION)))
        {
            (*cspan_at(&work, region + layout__REGION_SLANT)) = slant / (start - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_STATION)));
        }
    }
    (*cspan_at(&work, region + layout__REGION_SIDE_HIGH)) = widths__side_curvature(high_reached, high, 0.5 * (low + high));
    (*cspan_at(&work, region + layout__REGION_SIDE_LOW)) = widths__side_curvature((*cspan_at(&work, region + layout__REGION_REACHED)), low, 0.5 * (low + high));
    (*cspan_at(&work, region + layout__REGION_WIDTH_HIGH)) = high;
    (*cspan_at(&work, region + layout__REGION_WIDTH_LOW)) = low;
    (*cspan_at(&work, region + layout__REGION_WIDTH_PENETRATION)) = local_penetration;
    (*cspan_at(&work, region + layout__REGION_MIDDLE)) = (*cspan_at(&work, region + layout__REGION_STATION)) + 0.5 * (high - low);
    return INT64_C(0);
}

/* g / w^2 [1/m] where the gap has risen to g = ``reached`` [m] at the half-width w = ``own`` [m],
 * enlarged where that side is the narrower, up to NARROWER times.
 */
static inline double widths__side_curvature(double reached, double own, double mean)
{
    double ratio;
    double curvature;
    curvature = 0.0;
    if (own > 0.0)
    {
        ratio = mean / own;
        if (ratio > widths__NARROWER)
        {
            ratio = widths__NARROWER;
        }
        curvature = reached / (own * own) * ratio * ratio;
    }
    return curvature;
}
