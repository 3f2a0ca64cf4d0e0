/* Generated from contact/curves.py by tools/transpile_kernel.py; change that one.
 *
 * Rail and wheel as two curves across the track, each over its profile's abscissa, for separations measured
 * along them.
 *
 * The wheel's curve is its outline (:mod:`locus`); without yaw that is the profile, turned by the roll.
 * ``curve`` is RAIL or WHEEL, and its present abscissa is that of the frame's trace.  Coordinates are those from
 * the origin of the region.
 */

#include "curves.h"

/* The profile of a curve. */
static OUT_OF_LINE int64_t curves__curve_profile(array_double_1d tables, int64_t curve)
{
    int64_t profile;
    profile = (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL)));
    if (curve == layout__RAIL)
    {
        profile = (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL)));
    }
    return profile;
}

/* Point of a curve from its origin, across and down [m], its slope [-], and along the profile abscissa
 * ``u`` the derivatives of the lateral coordinate [-] and of the slope [1/m].
 */
static OUT_OF_LINE int64_t curves__curve_jet(double* across, double* down, double* slope, double* stretch, double* bend, array_double_1d work, array_double_1d tables, int64_t curve, double u)
{
    double z;
    double y_track;
    double z_track;
    profile_table__height_slope_bend(&z, slope, bend, tables, curves__curve_profile(tables, curve), u);
    (*across) = u - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_ORIGIN + layout__ORIGIN_POINTS + layout__POINT_SIZE * layout__RAIL + layout__POINT_Y));
    (*down) = z - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_ORIGIN + layout__ORIGIN_POINTS + layout__POINT_SIZE * layout__RAIL + layout__POINT_Z));
    (*stretch) = 1.0;
    if (curve == layout__WHEEL)
    {
        locus__outline_jet(&y_track, &z_track, slope, stretch, bend, work, layout__WORK_CONTACT + layout__CONTACT_FRAME + (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLACE))), u, z, (*slope), (*bend));
        (*across) = y_track - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_ORIGIN + layout__ORIGIN_POINTS + layout__POINT_SIZE * layout__WHEEL + layout__POINT_Y));
        (*down) = z_track - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_ORIGIN + layout__ORIGIN_POINTS + layout__POINT_SIZE * layout__WHEEL + layout__POINT_Z));
    }
    return 0;
}

/* Arc length per profile abscissa [-]; of an outline that folds back it is negative.  A roll does not
 * change it.
 */
static OUT_OF_LINE double curves__curve_speed(array_double_1d work, array_double_1d tables, int64_t curve, double u)
{
    double z;
    double slope;
    double across;
    double down;
    double stretch;
    double bend;
    double speed;
    speed = 1.0;
    if ((curve == layout__RAIL) || (!((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLACE))) + layout__PLACE_YAWED)) == 1.0)))
    {
        profile_table__height_slope(&z, &slope, tables, curves__curve_profile(tables, curve), u);
        speed = sqrt(1.0 + slope * slope);
    }
    else
    {
        curves__curve_jet(&across, &down, &slope, &stretch, &bend, work, tables, curve, u);
        speed = stretch * sqrt(1.0 + slope * slope);
    }
    return speed;
}

/* ``u``, or the end of the profile that it lies beyond [m]. */
static OUT_OF_LINE double curves__within(array_double_1d tables, int64_t curve, double u)
{
    int64_t profile;
    profile = curves__curve_profile(tables, curve);
    if (u < (*cspan_at(&tables, profile + layout__PROFILE_START)))
    {
        u = (*cspan_at(&tables, profile + layout__PROFILE_START));
    }
    if (u > (*cspan_at(&tables, profile + layout__PROFILE_STOP)))
    {
        u = (*cspan_at(&tables, profile + layout__PROFILE_STOP));
    }
    return u;
}

/* Measure from the minimum of ``region``; chords, if any, are as long as ``spacing`` [m], or arcs where
 * that is 0.
 */
static OUT_OF_LINE int64_t curves__open_origin(array_double_1d work, array_double_1d tables, int64_t region, double spacing)
{
    if ((int64_t)((*cspan_at(&tables, layout__TABLES_SEPARATION))) != layout__SEPARATION_NORMAL)
    {
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_ORIGIN + layout__ORIGIN_STATION)) = (*cspan_at(&work, region + layout__REGION_STATION));
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_ORIGIN + layout__ORIGIN_GAP)) = (*cspan_at(&work, region + layout__REGION_GAP));
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_ORIGIN + layout__ORIGIN_SPACING)) = 0.0;
        if ((int64_t)((*cspan_at(&tables, layout__TABLES_SEPARATION))) == layout__SEPARATION_EQUIDISTANT_CHORD)
        {
            (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_ORIGIN + layout__ORIGIN_SPACING)) = spacing;
        }
        curves__open_curve(work, tables, layout__RAIL, (*cspan_at(&work, region + layout__REGION_RAIL)));
        curves__open_curve(work, tables, layout__WHEEL, (*cspan_at(&work, region + layout__REGION_WHEEL)));
    }
    return INT64_C(0);
}

/* Let the origin of a curve be its point at abscissa ``u`` [m]. */
static OUT_OF_LINE int64_t curves__open_curve(array_double_1d work, array_double_1d tables, int64_t curve, double u)
{
    int64_t point;
    double across;
    double down;
    double slope;
    double stretch;
    double bend;
    point = layout__WORK_CONTACT + layout__CONTACT_ORIGIN + layout__ORIGIN_POINTS + layout__POINT_SIZE * curve;
    (*cspan_at(&work, point + layout__POINT_Y)) = 0.0;
    (*cspan_at(&work, point + layout__POINT_Z)) = 0.0;
    curves__curve_jet(&across, &down, &slope, &stretch, &bend, work, tables, curve, u);
    (*cspan_at(&work, point + layout__POINT_Y)) = across;
    (*cspan_at(&work, point + layout__POINT_Z)) = down;
    return INT64_C(0);
}
