/* Generated from tangent_regions.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of regions.py.
 */

#include "tangent_regions.h"

/* Tangent of ``incline_region``. */
static inline int64_t tangent_regions__incline_region_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t region, double slope, double slope_t)
{
    double v1;
    double v2;
    double v3;
    double cosine_t;
    double cosine;
    double v4;
    double v4_t;
    v1 = 1.0 + slope * slope;
    v2 = sqrt(v1);
    v3 = 1.0 / v2;
    cosine_t = (-v3) * tangent_rates__root_rate(v2, slope_t * slope + slope * slope_t) / v2;
    cosine = v3;
    (*cspan_at(&work_t, region + layout__REGION_INCLINATION)) = slope_t;
    (*cspan_at(&work, region + layout__REGION_INCLINATION)) = slope;
    (*cspan_at(&work_t, region + layout__REGION_OWN)) = 0.0;
    (*cspan_at(&work, region + layout__REGION_OWN)) = (double)(0);
    (*cspan_at(&work_t, region + layout__REGION_ALIGNMENT)) = 0.0;
    (*cspan_at(&work, region + layout__REGION_ALIGNMENT)) = 1.0;
    (*cspan_at(&work_t, region + layout__REGION_OFFSET)) = 0.0;
    (*cspan_at(&work, region + layout__REGION_OFFSET)) = 0.0;
    (*cspan_at(&work_t, region + layout__REGION_COS)) = cosine_t;
    (*cspan_at(&work, region + layout__REGION_COS)) = cosine;
    (*cspan_at(&work_t, region + layout__REGION_SIN)) = slope_t * cosine + slope * cosine_t;
    (*cspan_at(&work, region + layout__REGION_SIN)) = slope * cosine;
    (*cspan_at(&work_t, region + layout__REGION_SHARE)) = 0.0;
    (*cspan_at(&work, region + layout__REGION_SHARE)) = 1.0;
    if ((int64_t)((*cspan_at(&tables, layout__TABLES_LOAD))) == layout__LOAD_VERTICAL)
    {
        tangent_rails__upright_share_t(&v4, &v4_t, work, work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLACE))), cosine, cosine_t, (*cspan_at(&work, region + layout__REGION_SIN)), (*cspan_at(&work_t, region + layout__REGION_SIN)));
        (*cspan_at(&work_t, region + layout__REGION_SHARE)) = v4_t;
        (*cspan_at(&work, region + layout__REGION_SHARE)) = v4;
    }
    return INT64_C(0);
}

/* Tangent of ``measure_contact``. */
static inline int64_t tangent_regions__measure_contact_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state)
{
    double gap;
    double gap_t;
    double rate;
    double rate_t;
    double bend;
    double bend_t;
    double curvature;
    double curvature_t;
    tangent_contact_plane__normal_gap_t(&gap, &gap_t, &rate, &rate_t, &bend, &bend_t, &curvature, &curvature_t, work, work_t, tables, state, 0.0, 0.0, regions__PLACE_TRACE, 0.0);
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_BEND)) = bend_t;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_BEND)) = bend;
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_CURVATURE)) = curvature_t;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_CURVATURE)) = curvature;
    return INT64_C(0);
}

/* Tangent of ``open_contact_region``. */
static inline int64_t tangent_regions__open_contact_region_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t region)
{
    double v1;
    (*cspan_at(&work_t, region + layout__REGION_STATION)) = 0.0;
    (*cspan_at(&work, region + layout__REGION_STATION)) = 0.0;
    (*cspan_at(&work_t, region + layout__REGION_GAP)) = 0.0;
    (*cspan_at(&work, region + layout__REGION_GAP)) = 0.0;
    (*cspan_at(&work_t, region + layout__REGION_RAIL)) = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAIL + layout__POINT_Y));
    (*cspan_at(&work, region + layout__REGION_RAIL)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAIL + layout__POINT_Y));
    (*cspan_at(&work_t, region + layout__REGION_WHEEL)) = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_WHEEL + layout__POINT_Y));
    (*cspan_at(&work, region + layout__REGION_WHEEL)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_WHEEL + layout__POINT_Y));
    (*cspan_at(&work_t, region + layout__REGION_BEND)) = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_BEND));
    (*cspan_at(&work, region + layout__REGION_BEND)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_BEND));
    (*cspan_at(&work_t, region + layout__REGION_CURVATURE)) = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_CURVATURE));
    (*cspan_at(&work, region + layout__REGION_CURVATURE)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_CURVATURE));
    (*cspan_at(&work_t, region + layout__REGION_LOW)) = 0.0;
    (*cspan_at(&work, region + layout__REGION_LOW)) = -regions__BEYOND;
    (*cspan_at(&work_t, region + layout__REGION_HIGH)) = 0.0;
    (*cspan_at(&work, region + layout__REGION_HIGH)) = regions__BEYOND;
    v1 = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_SIN)) / (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS));
    tangent_regions__incline_region_t(work, work_t, tables, region, v1, ((*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_SIN)) - v1 * (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS))) / (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS)));
    return INT64_C(0);
}
