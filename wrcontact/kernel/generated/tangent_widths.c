/* Generated from tangent_widths.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of widths.py.
 */

#include "tangent_widths.h"

/* Tangent of ``measure_widths``. */
static inline int64_t tangent_widths__measure_widths_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, int64_t region, double local_penetration, double local_penetration_t)
{
    double bend_t;
    double bend;
    double v1;
    double v2;
    double v3;
    double low_t;
    double low;
    double high_t;
    double high;
    double v4;
    double v5;
    double grown_t;
    double grown;
    double v6;
    double v6_t;
    double high_reached_t;
    double high_reached;
    double slant_t;
    double slant;
    double start_t;
    double start;
    int64_t yawed;
    double v7;
    double v7_t;
    double v8;
    double v8_t;
    double v9;
    double v9_t;
    double v10;
    double v11;
    double v13;
    double v12;
    double v12_t;
    double v15;
    double v14;
    double v14_t;
    double v16;
    bend_t = (*cspan_at(&work_t, region + layout__REGION_BEND));
    bend = (*cspan_at(&work, region + layout__REGION_BEND));
    if (bend < widths__LEAST_BEND * (*cspan_at(&work, region + layout__REGION_CURVATURE)))
    {
        bend_t = widths__LEAST_BEND * (*cspan_at(&work_t, region + layout__REGION_CURVATURE));
        bend = widths__LEAST_BEND * (*cspan_at(&work, region + layout__REGION_CURVATURE));
    }
    if (bend > widths__MOST_BEND * (*cspan_at(&work, region + layout__REGION_CURVATURE)))
    {
        bend_t = widths__MOST_BEND * (*cspan_at(&work_t, region + layout__REGION_CURVATURE));
        bend = widths__MOST_BEND * (*cspan_at(&work, region + layout__REGION_CURVATURE));
    }
    v1 = 2.0 * local_penetration;
    v2 = v1 / bend;
    v3 = sqrt(v2);
    low_t = tangent_rates__root_rate(v3, (2.0 * local_penetration_t - v2 * bend_t) / bend);
    low = v3;
    high_t = low_t;
    high = low;
    if ((*cspan_at(&work, region + layout__REGION_WIDTH_PENETRATION)) > 0.0)
    {
        v4 = local_penetration / (*cspan_at(&work, region + layout__REGION_WIDTH_PENETRATION));
        v5 = sqrt(v4);
        grown_t = tangent_rates__root_rate(v5, (local_penetration_t - v4 * (*cspan_at(&work_t, region + layout__REGION_WIDTH_PENETRATION))) / (*cspan_at(&work, region + layout__REGION_WIDTH_PENETRATION)));
        grown = v5;
        low_t = (*cspan_at(&work_t, region + layout__REGION_WIDTH_LOW)) * grown + (*cspan_at(&work, region + layout__REGION_WIDTH_LOW)) * grown_t;
        low = (*cspan_at(&work, region + layout__REGION_WIDTH_LOW)) * grown;
        high_t = (*cspan_at(&work_t, region + layout__REGION_WIDTH_HIGH)) * grown + (*cspan_at(&work, region + layout__REGION_WIDTH_HIGH)) * grown_t;
        high = (*cspan_at(&work, region + layout__REGION_WIDTH_HIGH)) * grown;
    }
    tangent_zone_width__width_rule_t(&v6, &v6_t, work, work_t, tables, region, state, 1.0, 0.0, local_penetration, local_penetration_t, high, high_t);
    high_t = v6_t;
    high = v6;
    high_reached_t = (*cspan_at(&work_t, region + layout__REGION_REACHED));
    high_reached = (*cspan_at(&work, region + layout__REGION_REACHED));
    slant_t = 0.0;
    slant = 0.0;
    start_t = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_STATION));
    start = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_STATION));
    yawed = contact_plane__is_yawed(work);
    if (yawed == INT64_C(1))
    {
        tangent_locus__outline_x_t(&v7, &v7_t, work, work_t, tables, layout__WORK_CONTACT + layout__CONTACT_FRAME + (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLACE))), (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__WHEEL + layout__TRACE_ABSCISSA)), (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__WHEEL + layout__TRACE_ABSCISSA)));
        slant_t = v7_t;
        slant = v7;
    }
    if (!((*cspan_at(&work, region + layout__REGION_WIDTH_PENETRATION)) > 0.0))
    {
        low_t = high_t;
        low = high;
    }
    tangent_zone_width__width_rule_t(&v8, &v8_t, work, work_t, tables, region, state, -1.0, 0.0, local_penetration, local_penetration_t, low, low_t);
    low_t = v8_t;
    low = v8;
    if (yawed == INT64_C(1))
    {
        tangent_locus__outline_x_t(&v9, &v9_t, work, work_t, tables, layout__WORK_CONTACT + layout__CONTACT_FRAME + (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLACE))), (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__WHEEL + layout__TRACE_ABSCISSA)), (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__WHEEL + layout__TRACE_ABSCISSA)));
        slant_t = slant_t - v9_t;
        slant = slant - v9;
        if (start > (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_STATION)))
        {
            v10 = start - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_STATION));
            v11 = slant / v10;
            (*cspan_at(&work_t, region + layout__REGION_SLANT)) = (slant_t - v11 * (start_t - (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_STATION)))) / v10;
            (*cspan_at(&work, region + layout__REGION_SLANT)) = v11;
        }
    }
    v13 = low + high;
    tangent_widths__side_curvature_t(&v12, &v12_t, high_reached, high_reached_t, high, high_t, 0.5 * v13, 0.5 * (low_t + high_t));
    (*cspan_at(&work_t, region + layout__REGION_SIDE_HIGH)) = v12_t;
    (*cspan_at(&work, region + layout__REGION_SIDE_HIGH)) = v12;
    v15 = low + high;
    tangent_widths__side_curvature_t(&v14, &v14_t, (*cspan_at(&work, region + layout__REGION_REACHED)), (*cspan_at(&work_t, region + layout__REGION_REACHED)), low, low_t, 0.5 * v15, 0.5 * (low_t + high_t));
    (*cspan_at(&work_t, region + layout__REGION_SIDE_LOW)) = v14_t;
    (*cspan_at(&work, region + layout__REGION_SIDE_LOW)) = v14;
    (*cspan_at(&work_t, region + layout__REGION_WIDTH_HIGH)) = high_t;
    (*cspan_at(&work, region + layout__REGION_WIDTH_HIGH)) = high;
    (*cspan_at(&work_t, region + layout__REGION_WIDTH_LOW)) = low_t;
    (*cspan_at(&work, region + layout__REGION_WIDTH_LOW)) = low;
    (*cspan_at(&work_t, region + layout__REGION_WIDTH_PENETRATION)) = local_penetration_t;
    (*cspan_at(&work, region + layout__REGION_WIDTH_PENETRATION)) = local_penetration;
    v16 = high - low;
    (*cspan_at(&work_t, region + layout__REGION_MIDDLE)) = (*cspan_at(&work_t, region + layout__REGION_STATION)) + 0.5 * (high_t - low_t);
    (*cspan_at(&work, region + layout__REGION_MIDDLE)) = (*cspan_at(&work, region + layout__REGION_STATION)) + 0.5 * v16;
    return INT64_C(0);
}

/* Tangent of ``side_curvature``. */
static inline int64_t tangent_widths__side_curvature_t(double* curvature, double* curvature_t, double reached, double reached_t, double own, double own_t, double mean, double mean_t)
{
    double v1;
    double ratio_t;
    double ratio;
    double v2;
    double v3;
    double v4;
    (*curvature_t) = 0.0;
    (*curvature) = 0.0;
    if (own > 0.0)
    {
        v1 = mean / own;
        ratio_t = (mean_t - v1 * own_t) / own;
        ratio = v1;
        if (ratio > widths__NARROWER)
        {
            ratio_t = 0.0;
            ratio = widths__NARROWER;
        }
        v2 = own * own;
        v3 = reached / v2;
        v4 = v3 * ratio;
        (*curvature_t) = ((reached_t - v3 * (own_t * own + own * own_t)) / v2 * ratio + v3 * ratio_t) * ratio + v4 * ratio_t;
        (*curvature) = v4 * ratio;
    }
    return 0;
}
