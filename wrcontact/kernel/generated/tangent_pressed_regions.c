/* Generated from tangent_pressed_regions.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of pressed_regions.py.
 */

#include "tangent_pressed_regions.h"

/* Tangent of ``touching_shift``. */
static inline int64_t tangent_pressed_regions__touching_shift_t(double* result_0, double* result_1, double* result_2, double* result_3, array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t place, int64_t point)
{
    double z;
    double z_t;
    double slope;
    double slope_t;
    double y_track;
    double y_track_t;
    double z_track;
    double z_track_t;
    double outline_slope;
    double outline_slope_t;
    double z_rail;
    double z_rail_t;
    double m;
    double m_t;
    tangent_profile_table__height_slope_t(&z, &z_t, &slope, &slope_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL))), (*cspan_at(&work, point + layout__DEEP_POINT_WHEEL)), (*cspan_at(&work_t, point + layout__DEEP_POINT_WHEEL)));
    tangent_locus__outline_point_t(&y_track, &y_track_t, &z_track, &z_track_t, &outline_slope, &outline_slope_t, work, work_t, place, (*cspan_at(&work, point + layout__DEEP_POINT_WHEEL)), (*cspan_at(&work_t, point + layout__DEEP_POINT_WHEEL)), z, z_t, slope, slope_t);
    tangent_profile_table__height_slope_t(&z_rail, &z_rail_t, &m, &m_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), (*cspan_at(&work, point + layout__DEEP_POINT_RAIL)), (*cspan_at(&work_t, point + layout__DEEP_POINT_RAIL)));
    (*result_0) = (*cspan_at(&work, point + layout__DEEP_POINT_RAIL)) + (*cspan_at(&tables, layout__TABLES_RAIL_Y)) - y_track;
    (*result_1) = (*cspan_at(&work_t, point + layout__DEEP_POINT_RAIL)) - y_track_t;
    (*result_2) = z_rail - z_track;
    (*result_3) = z_rail_t - z_track_t;
    return 0;
}

/* Tangent of ``press_frame``. */
static inline int64_t tangent_pressed_regions__press_frame_t(array_double_1d work, array_double_1d work_t, double height, double height_t, double depth, double depth_t, double gap, double gap_t)
{
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_HEIGHT)) = height_t;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_HEIGHT)) = height;
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_DEPTH)) = depth_t;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_DEPTH)) = depth;
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PRESSED)) = 0.0;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PRESSED)) = (double)(1);
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAISED)) = gap_t;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAISED)) = gap;
    return INT64_C(0);
}

/* Tangent of ``sink_wheel``. */
static inline int64_t tangent_pressed_regions__sink_wheel_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t side, array_double_1d state, double penetration, double penetration_t)
{
    double v1;
    double height_t;
    double height;
    int64_t n2;
    int64_t count;
    v1 = penetration / (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS));
    height_t = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_SHIFT)) + (penetration_t - v1 * (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS))) / (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS));
    height = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_SHIFT)) + v1;
    n2 = tangent_overlaps__overlaps_rule_t(work, work_t, tables, side, state, height, height_t);
    count = n2;
    tangent_pressed_regions__press_frame_t(work, work_t, height, height_t, penetration, penetration_t, 0.0, 0.0);
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_SUNK)) = 0.0;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_SUNK)) = (double)(1);
    return count;
}

/* Tangent of ``sink_deeper``. */
static inline int64_t tangent_pressed_regions__sink_deeper_t(array_double_1d work, array_double_1d work_t, int64_t count, double penetration, double penetration_t)
{
    double v1;
    double height_t;
    double height;
    int64_t index;
    int64_t region;
    v1 = penetration / (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS));
    height_t = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_SHIFT)) + (penetration_t - v1 * (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS))) / (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS));
    height = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_SHIFT)) + v1;
    tangent_pressed_regions__press_frame_t(work, work_t, height, height_t, penetration, penetration_t, 0.0, 0.0);
    tangent_planes__keep_frame_t(work, work_t, layout__REGION_LIMIT);
    for (index = INT64_C(0); index < count; index += INT64_C(1))
    {
        region = layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * index;
        tangent_planes__use_frame_t(work, work_t, index);
        tangent_pressed_regions__press_frame_t(work, work_t, height, height_t, (*cspan_at(&work, region + layout__REGION_ALIGNMENT)) * penetration - (*cspan_at(&work, region + layout__REGION_GAP)), (*cspan_at(&work_t, region + layout__REGION_ALIGNMENT)) * penetration + (*cspan_at(&work, region + layout__REGION_ALIGNMENT)) * penetration_t - (*cspan_at(&work_t, region + layout__REGION_GAP)), (*cspan_at(&work, region + layout__REGION_GAP)), (*cspan_at(&work_t, region + layout__REGION_GAP)));
        tangent_planes__keep_frame_t(work, work_t, index);
    }
    tangent_planes__use_frame_t(work, work_t, layout__REGION_LIMIT);
    return INT64_C(0);
}

/* Tangent of ``open_pressed_region``. */
static inline int64_t tangent_pressed_regions__open_pressed_region_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t region, int64_t point)
{
    double z_rail;
    double z_rail_t;
    double m;
    double m_t;
    (*cspan_at(&work_t, region + layout__REGION_STATION)) = 0.0;
    (*cspan_at(&work, region + layout__REGION_STATION)) = 0.0;
    (*cspan_at(&work_t, region + layout__REGION_GAP)) = 0.0;
    (*cspan_at(&work, region + layout__REGION_GAP)) = 0.0;
    (*cspan_at(&work_t, region + layout__REGION_RAIL)) = (*cspan_at(&work_t, point + layout__DEEP_POINT_RAIL));
    (*cspan_at(&work, region + layout__REGION_RAIL)) = (*cspan_at(&work, point + layout__DEEP_POINT_RAIL));
    (*cspan_at(&work_t, region + layout__REGION_WHEEL)) = (*cspan_at(&work_t, point + layout__DEEP_POINT_WHEEL));
    (*cspan_at(&work, region + layout__REGION_WHEEL)) = (*cspan_at(&work, point + layout__DEEP_POINT_WHEEL));
    tangent_profile_table__height_slope_t(&z_rail, &z_rail_t, &m, &m_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), (*cspan_at(&work, point + layout__DEEP_POINT_RAIL)), (*cspan_at(&work_t, point + layout__DEEP_POINT_RAIL)));
    tangent_regions__incline_region_t(work, work_t, tables, region, m, m_t);
    return INT64_C(0);
}

/* Tangent of ``give_own_frame``. */
static inline int64_t tangent_pressed_regions__give_own_frame_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t region, int64_t point)
{
    double cosine_t;
    double cosine;
    double abscissa_t;
    double abscissa;
    double height_t;
    double height;
    double depth_t;
    double depth;
    double aside;
    double aside_t;
    double shift;
    double shift_t;
    double n1;
    double n1_t;
    double n2;
    double n2_t;
    double n3;
    double n3_t;
    double n4;
    double n4_t;
    double n5;
    double n5_t;
    double v6;
    double v7;
    double v7_t;
    cosine_t = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS));
    cosine = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS));
    abscissa_t = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAIL + layout__POINT_Y));
    abscissa = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAIL + layout__POINT_Y));
    height_t = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_HEIGHT));
    height = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_HEIGHT));
    depth_t = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_DEPTH));
    depth = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_DEPTH));
    tangent_pressed_regions__touching_shift_t(&aside, &aside_t, &shift, &shift_t, work, work_t, tables, layout__WORK_CONTACT + layout__CONTACT_FRAME + (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLACE))), point);
    tangent_contact_plane__open_frame_t(&n1, &n1_t, &n2, &n2_t, &n3, &n3_t, &n4, &n4_t, &n5, &n5_t, work, work_t, tables, layout__WORK_CONTACT + layout__CONTACT_FRAME + (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLACE))), (*cspan_at(&work, point + layout__DEEP_POINT_WHEEL)), (*cspan_at(&work_t, point + layout__DEEP_POINT_WHEEL)), aside, aside_t, shift, shift_t);
    (*cspan_at(&work_t, region + layout__REGION_OWN)) = 0.0;
    (*cspan_at(&work, region + layout__REGION_OWN)) = (double)(1);
    v6 = (*cspan_at(&work, region + layout__REGION_COS)) / cosine;
    (*cspan_at(&work_t, region + layout__REGION_ALIGNMENT)) = ((*cspan_at(&work_t, region + layout__REGION_COS)) - v6 * cosine_t) / cosine;
    (*cspan_at(&work, region + layout__REGION_ALIGNMENT)) = v6;
    (*cspan_at(&work_t, region + layout__REGION_GAP)) = (*cspan_at(&work_t, region + layout__REGION_ALIGNMENT)) * depth + (*cspan_at(&work, region + layout__REGION_ALIGNMENT)) * depth_t - (*cspan_at(&work_t, point + layout__DEEP_POINT_DEPTH));
    (*cspan_at(&work, region + layout__REGION_GAP)) = (*cspan_at(&work, region + layout__REGION_ALIGNMENT)) * depth - (*cspan_at(&work, point + layout__DEEP_POINT_DEPTH));
    tangent_arc_length__rail_length_t(&v7, &v7_t, tables, abscissa, abscissa_t, (*cspan_at(&work, point + layout__DEEP_POINT_RAIL)), (*cspan_at(&work_t, point + layout__DEEP_POINT_RAIL)));
    (*cspan_at(&work_t, region + layout__REGION_OFFSET)) = v7_t;
    (*cspan_at(&work, region + layout__REGION_OFFSET)) = v7;
    tangent_pressed_regions__press_frame_t(work, work_t, height, height_t, (*cspan_at(&work, point + layout__DEEP_POINT_DEPTH)), (*cspan_at(&work_t, point + layout__DEEP_POINT_DEPTH)), (*cspan_at(&work, region + layout__REGION_GAP)), (*cspan_at(&work_t, region + layout__REGION_GAP)));
    return INT64_C(0);
}

/* Tangent of ``gather_overlaps``. */
static inline int64_t tangent_pressed_regions__gather_overlaps_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state)
{
    int64_t contact;
    int64_t index;
    int64_t region;
    int64_t point;
    double gap;
    double gap_t;
    double rate;
    double rate_t;
    double bend;
    double bend_t;
    double curvature;
    double curvature_t;
    double v1;
    double v1_t;
    double v2;
    double v2_t;
    int64_t count;
    count = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_COUNT)));
    contact = deep_points__deepest_entry(work);
    tangent_planes__keep_frame_t(work, work_t, layout__REGION_LIMIT);
    for (index = INT64_C(0); index < count; index += INT64_C(1))
    {
        region = layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * index;
        point = layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_POINTS + layout__DEEP_POINT_SIZE * index;
        tangent_pressed_regions__open_pressed_region_t(work, work_t, tables, region, point);
        if ((index != contact) || ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_SUNK)) == 1.0))
        {
            tangent_pressed_regions__give_own_frame_t(work, work_t, tables, region, point);
        }
        tangent_traces__start_traces_t(work, work_t, 0.0, 0.0, (*cspan_at(&work, point + layout__DEEP_POINT_RAIL)), (*cspan_at(&work_t, point + layout__DEEP_POINT_RAIL)), (*cspan_at(&work, point + layout__DEEP_POINT_WHEEL)), (*cspan_at(&work_t, point + layout__DEEP_POINT_WHEEL)));
        tangent_pressed__pressed_gap_t(&gap, &gap_t, &rate, &rate_t, &bend, &bend_t, &curvature, &curvature_t, work, work_t, tables, state, 0.0, 0.0);
        (*cspan_at(&work_t, region + layout__REGION_BEND)) = bend_t;
        (*cspan_at(&work, region + layout__REGION_BEND)) = bend;
        (*cspan_at(&work_t, region + layout__REGION_CURVATURE)) = curvature_t;
        (*cspan_at(&work, region + layout__REGION_CURVATURE)) = curvature;
        (*cspan_at(&work_t, region + layout__REGION_LOW)) = 0.0;
        (*cspan_at(&work, region + layout__REGION_LOW)) = -regions__BEYOND;
        (*cspan_at(&work_t, region + layout__REGION_HIGH)) = 0.0;
        (*cspan_at(&work, region + layout__REGION_HIGH)) = regions__BEYOND;
        if (index > INT64_C(0))
        {
            tangent_arc_length__rail_length_t(&v1, &v1_t, tables, (*cspan_at(&work, point + layout__DEEP_POINT_RAIL)), (*cspan_at(&work_t, point + layout__DEEP_POINT_RAIL)), (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_POINTS + layout__DEEP_POINT_SIZE * (index - INT64_C(1)) + layout__DEEP_POINT_SADDLE)), (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_POINTS + layout__DEEP_POINT_SIZE * (index - INT64_C(1)) + layout__DEEP_POINT_SADDLE)));
            (*cspan_at(&work_t, region + layout__REGION_LOW)) = v1_t;
            (*cspan_at(&work, region + layout__REGION_LOW)) = v1;
        }
        if (index < count - INT64_C(1))
        {
            tangent_arc_length__rail_length_t(&v2, &v2_t, tables, (*cspan_at(&work, point + layout__DEEP_POINT_RAIL)), (*cspan_at(&work_t, point + layout__DEEP_POINT_RAIL)), (*cspan_at(&work, point + layout__DEEP_POINT_SADDLE)), (*cspan_at(&work_t, point + layout__DEEP_POINT_SADDLE)));
            (*cspan_at(&work_t, region + layout__REGION_HIGH)) = v2_t;
            (*cspan_at(&work, region + layout__REGION_HIGH)) = v2;
        }
        tangent_planes__keep_frame_t(work, work_t, index);
        tangent_planes__use_frame_t(work, work_t, layout__REGION_LIMIT);
    }
    if (count > INT64_C(1))
    {
        tangent_planes__locate_along_track_t(work, work_t, tables, count);
    }
    return count;
}
