/* Generated from tangent_curves.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of curves.py.
 */

#include "tangent_curves.h"

/* Tangent of ``curve_jet``. */
static inline int64_t tangent_curves__curve_jet_t(double* across, double* across_t, double* down, double* down_t, double* slope, double* slope_t, double* stretch, double* stretch_t, double* bend, double* bend_t, array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t curve, double u, double u_t)
{
    double z;
    double z_t;
    double y_track;
    double y_track_t;
    double z_track;
    double z_track_t;
    tangent_profile_table__height_slope_bend_t(&z, &z_t, slope, slope_t, bend, bend_t, tables, curves__curve_profile(tables, curve), u, u_t);
    (*across_t) = u_t - (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_ORIGIN + layout__ORIGIN_POINTS + layout__POINT_SIZE * layout__RAIL + layout__POINT_Y));
    (*across) = u - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_ORIGIN + layout__ORIGIN_POINTS + layout__POINT_SIZE * layout__RAIL + layout__POINT_Y));
    (*down_t) = z_t - (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_ORIGIN + layout__ORIGIN_POINTS + layout__POINT_SIZE * layout__RAIL + layout__POINT_Z));
    (*down) = z - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_ORIGIN + layout__ORIGIN_POINTS + layout__POINT_SIZE * layout__RAIL + layout__POINT_Z));
    (*stretch_t) = 0.0;
    (*stretch) = 1.0;
    if (curve == layout__WHEEL)
    {
        tangent_locus__outline_jet_t(&y_track, &y_track_t, &z_track, &z_track_t, slope, slope_t, stretch, stretch_t, bend, bend_t, work, work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLACE))), u, u_t, z, z_t, (*slope), (*slope_t), (*bend), (*bend_t));
        (*across_t) = y_track_t - (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_ORIGIN + layout__ORIGIN_POINTS + layout__POINT_SIZE * layout__WHEEL + layout__POINT_Y));
        (*across) = y_track - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_ORIGIN + layout__ORIGIN_POINTS + layout__POINT_SIZE * layout__WHEEL + layout__POINT_Y));
        (*down_t) = z_track_t - (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_ORIGIN + layout__ORIGIN_POINTS + layout__POINT_SIZE * layout__WHEEL + layout__POINT_Z));
        (*down) = z_track - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_ORIGIN + layout__ORIGIN_POINTS + layout__POINT_SIZE * layout__WHEEL + layout__POINT_Z));
    }
    return 0;
}

/* Tangent of ``curve_speed``. */
static inline int64_t tangent_curves__curve_speed_t(double* speed, double* speed_t, array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t curve, double u, double u_t)
{
    double z;
    double z_t;
    double slope;
    double slope_t;
    double v1;
    double v2;
    double across;
    double across_t;
    double down;
    double down_t;
    double stretch;
    double stretch_t;
    double bend;
    double bend_t;
    double v3;
    double v4;
    (*speed_t) = 0.0;
    (*speed) = 1.0;
    if ((curve == layout__RAIL) || (!((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLACE))) + layout__PLACE_YAWED)) == 1.0)))
    {
        tangent_profile_table__height_slope_t(&z, &z_t, &slope, &slope_t, tables, curves__curve_profile(tables, curve), u, u_t);
        v1 = 1.0 + slope * slope;
        v2 = sqrt(v1);
        (*speed_t) = tangent_rates__root_rate(v2, slope_t * slope + slope * slope_t);
        (*speed) = v2;
    }
    else
    {
        tangent_curves__curve_jet_t(&across, &across_t, &down, &down_t, &slope, &slope_t, &stretch, &stretch_t, &bend, &bend_t, work, work_t, tables, curve, u, u_t);
        v3 = 1.0 + slope * slope;
        v4 = sqrt(v3);
        (*speed_t) = stretch_t * v4 + stretch * tangent_rates__root_rate(v4, slope_t * slope + slope * slope_t);
        (*speed) = stretch * v4;
    }
    return 0;
}

/* Tangent of ``within``. */
static inline int64_t tangent_curves__within_t(double* result_0, double* result_1, array_double_1d tables, int64_t curve, double u, double u_t)
{
    int64_t profile;
    profile = curves__curve_profile(tables, curve);
    if (u < (*cspan_at(&tables, profile + layout__PROFILE_START)))
    {
        u_t = 0.0;
        u = (*cspan_at(&tables, profile + layout__PROFILE_START));
    }
    if (u > (*cspan_at(&tables, profile + layout__PROFILE_STOP)))
    {
        u_t = 0.0;
        u = (*cspan_at(&tables, profile + layout__PROFILE_STOP));
    }
    (*result_0) = u;
    (*result_1) = u_t;
    return 0;
}

/* Tangent of ``open_origin``. */
static inline int64_t tangent_curves__open_origin_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t region, double spacing, double spacing_t)
{
    if ((int64_t)((*cspan_at(&tables, layout__TABLES_SEPARATION))) != layout__SEPARATION_NORMAL)
    {
        (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_ORIGIN + layout__ORIGIN_STATION)) = (*cspan_at(&work_t, region + layout__REGION_STATION));
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_ORIGIN + layout__ORIGIN_STATION)) = (*cspan_at(&work, region + layout__REGION_STATION));
        (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_ORIGIN + layout__ORIGIN_GAP)) = (*cspan_at(&work_t, region + layout__REGION_GAP));
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_ORIGIN + layout__ORIGIN_GAP)) = (*cspan_at(&work, region + layout__REGION_GAP));
        (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_ORIGIN + layout__ORIGIN_SPACING)) = 0.0;
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_ORIGIN + layout__ORIGIN_SPACING)) = 0.0;
        if ((int64_t)((*cspan_at(&tables, layout__TABLES_SEPARATION))) == layout__SEPARATION_EQUIDISTANT_CHORD)
        {
            (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_ORIGIN + layout__ORIGIN_SPACING)) = spacing_t;
            (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_ORIGIN + layout__ORIGIN_SPACING)) = spacing;
        }
        tangent_curves__open_curve_t(work, work_t, tables, layout__RAIL, (*cspan_at(&work, region + layout__REGION_RAIL)), (*cspan_at(&work_t, region + layout__REGION_RAIL)));
        tangent_curves__open_curve_t(work, work_t, tables, layout__WHEEL, (*cspan_at(&work, region + layout__REGION_WHEEL)), (*cspan_at(&work_t, region + layout__REGION_WHEEL)));
    }
    return INT64_C(0);
}

/* Tangent of ``open_curve``. */
static inline int64_t tangent_curves__open_curve_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t curve, double u, double u_t)
{
    int64_t point;
    double across;
    double across_t;
    double down;
    double down_t;
    double slope;
    double slope_t;
    double stretch;
    double stretch_t;
    double bend;
    double bend_t;
    point = layout__WORK_CONTACT + layout__CONTACT_ORIGIN + layout__ORIGIN_POINTS + layout__POINT_SIZE * curve;
    (*cspan_at(&work_t, point + layout__POINT_Y)) = 0.0;
    (*cspan_at(&work, point + layout__POINT_Y)) = 0.0;
    (*cspan_at(&work_t, point + layout__POINT_Z)) = 0.0;
    (*cspan_at(&work, point + layout__POINT_Z)) = 0.0;
    tangent_curves__curve_jet_t(&across, &across_t, &down, &down_t, &slope, &slope_t, &stretch, &stretch_t, &bend, &bend_t, work, work_t, tables, curve, u, u_t);
    (*cspan_at(&work_t, point + layout__POINT_Y)) = across_t;
    (*cspan_at(&work, point + layout__POINT_Y)) = across;
    (*cspan_at(&work_t, point + layout__POINT_Z)) = down_t;
    (*cspan_at(&work, point + layout__POINT_Z)) = down;
    return INT64_C(0);
}
