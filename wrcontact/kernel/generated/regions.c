/* Generated from contact/regions.py by tools/transpile_kernel.py; change that one.
 *
 * The region around a contact point or a deepest point, and what belongs to its inclination.
 */

#include "regions.h"

/* Give a region in the contact point's plane its inclination, the rail's ``slope`` there, and what
 * follows from it.
 */
static inline int64_t regions__incline_region(array_double_1d work, array_double_1d tables, int64_t region, double slope)
{
    double cosine;
    cosine = 1.0 / sqrt(1.0 + slope * slope);
    (*cspan_at(&work, region + layout__REGION_INCLINATION)) = slope;
    (*cspan_at(&work, region + layout__REGION_OWN)) = (double)(0);
    (*cspan_at(&work, region + layout__REGION_ALIGNMENT)) = 1.0;
    (*cspan_at(&work, region + layout__REGION_OFFSET)) = 0.0;
    (*cspan_at(&work, region + layout__REGION_COS)) = cosine;
    (*cspan_at(&work, region + layout__REGION_SIN)) = slope * cosine;
    (*cspan_at(&work, region + layout__REGION_SHARE)) = 1.0;
    if ((int64_t)((*cspan_at(&tables, layout__TABLES_LOAD))) == layout__LOAD_VERTICAL)
    {
        (*cspan_at(&work, region + layout__REGION_SHARE)) = rails__upright_share(work, layout__WORK_CONTACT + layout__CONTACT_FRAME + (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLACE))), cosine, (*cspan_at(&work, region + layout__REGION_SIN)));
    }
    return INT64_C(0);
}

/* Note in the open frame how the gap bends at the contact point, and the wheel's 1/R_x. */
static inline int64_t regions__measure_contact(array_double_1d work, array_double_1d tables, array_double_1d state)
{
    double gap;
    double rate;
    double bend;
    double curvature;
    contact_plane__normal_gap(&gap, &rate, &bend, &curvature, work, tables, state, 0.0, regions__PLACE_TRACE);
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_BEND)) = bend;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_CURVATURE)) = curvature;
    return INT64_C(0);
}

/* The region of the rigid contact point itself, station and gap zero. */
static inline int64_t regions__open_contact_region(array_double_1d work, array_double_1d tables, int64_t region)
{
    (*cspan_at(&work, region + layout__REGION_STATION)) = 0.0;
    (*cspan_at(&work, region + layout__REGION_GAP)) = 0.0;
    (*cspan_at(&work, region + layout__REGION_RAIL)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAIL + layout__POINT_Y));
    (*cspan_at(&work, region + layout__REGION_WHEEL)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_WHEEL + layout__POINT_Y));
    (*cspan_at(&work, region + layout__REGION_BEND)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_BEND));
    (*cspan_at(&work, region + layout__REGION_CURVATURE)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_CURVATURE));
    (*cspan_at(&work, region + layout__REGION_LOW)) = -regions__BEYOND;
    (*cspan_at(&work, region + layout__REGION_HIGH)) = regions__BEYOND;
    regions__incline_region(work, tables, region, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_SIN)) / (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS)));
    return INT64_C(0);
}
