/* Generated from tangent_planes.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of planes.py.
 */

#include "tangent_planes.h"

/* Tangent of ``keep_frame``. */
static inline int64_t tangent_planes__keep_frame_t(array_double_1d work, array_double_1d work_t, int64_t slot)
{
    int64_t kept;
    int64_t i;
    kept = layout__WORK_CONTACT + layout__CONTACT_FRAMES + INT64_C(26) * slot;
    for (i = INT64_C(0); i < layout__FRAME_SIZE; i += INT64_C(1))
    {
        (*cspan_at(&work_t, kept + i)) = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + i));
        (*cspan_at(&work, kept + i)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + i));
    }
    return INT64_C(0);
}

/* Tangent of ``use_frame``. */
static inline int64_t tangent_planes__use_frame_t(array_double_1d work, array_double_1d work_t, int64_t slot)
{
    int64_t kept;
    int64_t i;
    kept = layout__WORK_CONTACT + layout__CONTACT_FRAMES + INT64_C(26) * slot;
    for (i = INT64_C(0); i < layout__FRAME_SIZE; i += INT64_C(1))
    {
        (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + i)) = (*cspan_at(&work_t, kept + i));
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + i)) = (*cspan_at(&work, kept + i));
    }
    return INT64_C(0);
}

/* Tangent of ``bound_abscissa``. */
static inline int64_t tangent_planes__bound_abscissa_t(double* abscissa, double* abscissa_t, array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t region, array_double_1d state, double bound, double bound_t)
{
    double gap;
    double gap_t;
    double rate;
    double rate_t;
    double bend;
    double bend_t;
    double curvature;
    double curvature_t;
    (*abscissa_t) = bound_t;
    (*abscissa) = bound;
    if (fabs(bound) < regions__BEYOND)
    {
        tangent_traces__start_traces_t(work, work_t, (*cspan_at(&work, region + layout__REGION_STATION)), (*cspan_at(&work_t, region + layout__REGION_STATION)), (*cspan_at(&work, region + layout__REGION_RAIL)), (*cspan_at(&work_t, region + layout__REGION_RAIL)), (*cspan_at(&work, region + layout__REGION_WHEEL)), (*cspan_at(&work_t, region + layout__REGION_WHEEL)));
        tangent_contact_plane__normal_gap_t(&gap, &gap_t, &rate, &rate_t, &bend, &bend_t, &curvature, &curvature_t, work, work_t, tables, state, bound, bound_t, regions__PLACE_TRACE, 0.0);
        (*abscissa_t) = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__RAIL + layout__TRACE_ABSCISSA));
        (*abscissa) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__RAIL + layout__TRACE_ABSCISSA));
    }
    return 0;
}

/* Tangent of ``bound_station``. */
static inline int64_t tangent_planes__bound_station_t(double* station, double* station_t, array_double_1d work, array_double_1d work_t, array_double_1d tables, double abscissa, double abscissa_t)
{
    double height;
    double height_t;
    double slope;
    double slope_t;
    double v1;
    double v2;
    (*station_t) = abscissa_t;
    (*station) = abscissa;
    if (fabs(abscissa) < regions__BEYOND)
    {
        tangent_profile_table__height_slope_t(&height, &height_t, &slope, &slope_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), abscissa, abscissa_t);
        v1 = abscissa - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAIL + layout__POINT_Y));
        v2 = height - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAIL + layout__POINT_Z));
        (*station_t) = (abscissa_t - (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAIL + layout__POINT_Y))) * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS)) + v1 * (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS)) + ((height_t - (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAIL + layout__POINT_Z))) * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_SIN)) + v2 * (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_SIN)));
        (*station) = v1 * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS)) + v2 * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_SIN));
    }
    return 0;
}

/* Tangent of ``own_plane``. */
static inline int64_t tangent_planes__own_plane_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t region, int64_t slot, array_double_1d state)
{
    double y;
    double y_t;
    double abscissa;
    double abscissa_t;
    double depth;
    double depth_t;
    double aside;
    double aside_t;
    double shift;
    double shift_t;
    double v1;
    double v1_t;
    double low_t;
    double low;
    double v2;
    double v2_t;
    double high_t;
    double high;
    double cosine_t;
    double cosine;
    double sine_t;
    double sine;
    double height;
    double height_t;
    double slope;
    double slope_t;
    double v3;
    double v3_t;
    double z;
    double z_t;
    double y_track;
    double y_track_t;
    double rail_slope;
    double rail_slope_t;
    double mismatch;
    double mismatch_t;
    double gap;
    double gap_t;
    double rate;
    double rate_t;
    double bend;
    double bend_t;
    double curvature;
    double curvature_t;
    double v4;
    double v4_t;
    double v5;
    double v5_t;
    int64_t found;
    tangent_touching__pair_rule_t(&y, &y_t, &abscissa, &abscissa_t, &depth, &depth_t, &aside, &aside_t, &shift, &shift_t, &found, work, work_t, tables, layout__WORK_CONTACT + layout__CONTACT_FRAME + (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLACE))), (*cspan_at(&work, region + layout__REGION_WHEEL)), (*cspan_at(&work_t, region + layout__REGION_WHEEL)), (*cspan_at(&work, region + layout__REGION_RAIL)), (*cspan_at(&work_t, region + layout__REGION_RAIL)), (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_SHIFT)), (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_SHIFT)));
    if (found == INT64_C(1))
    {
        tangent_planes__bound_abscissa_t(&v1, &v1_t, work, work_t, tables, region, state, (*cspan_at(&work, region + layout__REGION_LOW)), (*cspan_at(&work_t, region + layout__REGION_LOW)));
        low_t = v1_t;
        low = v1;
        tangent_planes__bound_abscissa_t(&v2, &v2_t, work, work_t, tables, region, state, (*cspan_at(&work, region + layout__REGION_HIGH)), (*cspan_at(&work_t, region + layout__REGION_HIGH)));
        high_t = v2_t;
        high = v2;
        tangent_planes__keep_frame_t(work, work_t, layout__REGION_LIMIT);
        cosine_t = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS));
        cosine = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS));
        sine_t = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_SIN));
        sine = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_SIN));
        (*cspan_at(&work_t, region + layout__REGION_STATION)) = 0.0;
        (*cspan_at(&work, region + layout__REGION_STATION)) = 0.0;
        (*cspan_at(&work_t, region + layout__REGION_RAIL)) = abscissa_t;
        (*cspan_at(&work, region + layout__REGION_RAIL)) = abscissa;
        (*cspan_at(&work_t, region + layout__REGION_WHEEL)) = y_t;
        (*cspan_at(&work, region + layout__REGION_WHEEL)) = y;
        tangent_profile_table__height_slope_t(&height, &height_t, &slope, &slope_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), abscissa, abscissa_t);
        tangent_regions__incline_region_t(work, work_t, tables, region, slope, slope_t);
        (*cspan_at(&work_t, region + layout__REGION_OWN)) = 0.0;
        (*cspan_at(&work, region + layout__REGION_OWN)) = (double)(1);
        tangent_arc_length__rail_length_t(&v3, &v3_t, tables, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAIL + layout__POINT_Y)), (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAIL + layout__POINT_Y)), abscissa, abscissa_t);
        (*cspan_at(&work_t, region + layout__REGION_OFFSET)) = v3_t;
        (*cspan_at(&work, region + layout__REGION_OFFSET)) = v3;
        (*cspan_at(&work_t, region + layout__REGION_ALIGNMENT)) = (*cspan_at(&work_t, region + layout__REGION_COS)) * cosine + (*cspan_at(&work, region + layout__REGION_COS)) * cosine_t + ((*cspan_at(&work_t, region + layout__REGION_SIN)) * sine + (*cspan_at(&work, region + layout__REGION_SIN)) * sine_t);
        (*cspan_at(&work, region + layout__REGION_ALIGNMENT)) = (*cspan_at(&work, region + layout__REGION_COS)) * cosine + (*cspan_at(&work, region + layout__REGION_SIN)) * sine;
        (*cspan_at(&work_t, region + layout__REGION_GAP)) = -depth_t;
        (*cspan_at(&work, region + layout__REGION_GAP)) = -depth;
        tangent_contact_plane__open_frame_t(&z, &z_t, &slope, &slope_t, &y_track, &y_track_t, &rail_slope, &rail_slope_t, &mismatch, &mismatch_t, work, work_t, tables, layout__WORK_CONTACT + layout__CONTACT_FRAME + (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLACE))), y, y_t, aside, aside_t, shift, shift_t);
        (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAISED)) = (*cspan_at(&work_t, region + layout__REGION_GAP));
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAISED)) = (*cspan_at(&work, region + layout__REGION_GAP));
        tangent_contact_plane__normal_gap_t(&gap, &gap_t, &rate, &rate_t, &bend, &bend_t, &curvature, &curvature_t, work, work_t, tables, state, 0.0, 0.0, regions__PLACE_TRACE, 0.0);
        (*cspan_at(&work_t, region + layout__REGION_BEND)) = bend_t;
        (*cspan_at(&work, region + layout__REGION_BEND)) = bend;
        (*cspan_at(&work_t, region + layout__REGION_CURVATURE)) = curvature_t;
        (*cspan_at(&work, region + layout__REGION_CURVATURE)) = curvature;
        tangent_planes__bound_station_t(&v4, &v4_t, work, work_t, tables, low, low_t);
        (*cspan_at(&work_t, region + layout__REGION_LOW)) = v4_t;
        (*cspan_at(&work, region + layout__REGION_LOW)) = v4;
        tangent_planes__bound_station_t(&v5, &v5_t, work, work_t, tables, high, high_t);
        (*cspan_at(&work_t, region + layout__REGION_HIGH)) = v5_t;
        (*cspan_at(&work, region + layout__REGION_HIGH)) = v5;
        tangent_planes__keep_frame_t(work, work_t, slot);
        tangent_planes__use_frame_t(work, work_t, layout__REGION_LIMIT);
    }
    return found;
}

/* Tangent of ``give_planes``. */
static inline int64_t tangent_planes__give_planes_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, int64_t count)
{
    int64_t own;
    int64_t index;
    int64_t region;
    int64_t n1;
    own = INT64_C(0);
    for (index = INT64_C(0); index < count; index += INT64_C(1))
    {
        region = layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * index;
        if (planes__needs_own_plane(work, region) == INT64_C(1))
        {
            n1 = tangent_planes__own_plane_t(work, work_t, tables, region, index, state);
            own = own + n1;
        }
    }
    if (own > INT64_C(0))
    {
        tangent_planes__locate_along_track_t(work, work_t, tables, count);
    }
    return INT64_C(0);
}

/* Tangent of ``locate_along_track``. */
static inline int64_t tangent_planes__locate_along_track_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t count)
{
    int64_t index;
    int64_t region;
    double v1;
    double v1_t;
    for (index = INT64_C(0); index < count; index += INT64_C(1))
    {
        region = layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * index;
        tangent_locus__outline_x_t(&v1, &v1_t, work, work_t, tables, layout__WORK_CONTACT + layout__CONTACT_FRAME + (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLACE))), (*cspan_at(&work, region + layout__REGION_WHEEL)), (*cspan_at(&work_t, region + layout__REGION_WHEEL)));
        (*cspan_at(&work_t, region + layout__REGION_X_TRACK)) = v1_t;
        (*cspan_at(&work, region + layout__REGION_X_TRACK)) = v1;
    }
    return INT64_C(0);
}

/* Tangent of ``enter_plane``. */
static inline int64_t tangent_planes__enter_plane_t(array_double_1d work, array_double_1d work_t, int64_t region, int64_t slot)
{
    if ((*cspan_at(&work, region + layout__REGION_OWN)) == 1.0)
    {
        tangent_planes__use_frame_t(work, work_t, slot);
    }
    return INT64_C(0);
}

/* Tangent of ``leave_plane``. */
static inline int64_t tangent_planes__leave_plane_t(array_double_1d work, array_double_1d work_t, int64_t region)
{
    if ((*cspan_at(&work, region + layout__REGION_OWN)) == 1.0)
    {
        tangent_planes__use_frame_t(work, work_t, layout__REGION_LIMIT);
    }
    return INT64_C(0);
}
