/* Generated from contact/traces.py by tools/transpile_kernel.py; change that one.
 *
 * Wheel and rail as heights over the contact plane, traced from station to station.
 *
 * Station s runs along the contact plane to the field side, from the contact point; heights n are measured along
 * the plane's normal, from rail to wheel.  The outline of the wheel (:mod:`locus`) and the rail profile are both
 * read as n(s): the profile abscissa that projects on s is found by Newton's method from the previous station,
 * and the last residual is removed by the curve's own slope and bend, which leaves an error of third order in a
 * small residual.
 */

#include "traces.h"

/* Let the traces begin at ``station`` with rail abscissa ``abscissa`` and wheel abscissa ``y`` [m]. */
static inline int64_t traces__start_traces(array_double_1d work, double station, double abscissa, double y)
{
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_STATION)) = station;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__RAIL + layout__TRACE_ABSCISSA)) = abscissa;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__RAIL + layout__TRACE_RATE)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS));
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__RAIL + layout__TRACE_BEND)) = 0.0;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__WHEEL + layout__TRACE_ABSCISSA)) = y;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__WHEEL + layout__TRACE_RATE)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS));
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__WHEEL + layout__TRACE_BEND)) = 0.0;
    return INT64_C(0);
}

/* Estimated profile abscissa [m] at a distance ``away`` from the station of the trace [m]. */
static inline double traces__first_abscissa(array_double_1d work, int64_t trace, double away)
{
    double u;
    u = (*cspan_at(&work, trace + layout__TRACE_ABSCISSA)) + away * (*cspan_at(&work, trace + layout__TRACE_RATE));
    if (fabs(away) < traces__EXTRAPOLATED)
    {
        u += 0.5 * away * away * (*cspan_at(&work, trace + layout__TRACE_BEND));
    }
    return u;
}

/* Height of a profile over the contact plane [m], its rate [-] and bend [1/m] at ``station``, its slope
 * there [-], its height [m], and 1 if it exists.
 *
 * point : the profile's point at station zero.
 * plane : inclination of the contact plane in the profile's coordinates.
 */
static inline int64_t traces__trace_profile(double* result_0, double* result_1, double* ordinate_bend, double* result_3, double* result_4, int64_t* exists, array_double_1d tables, array_double_1d work, int64_t profile, int64_t point, int64_t plane, int64_t trace, double station, double tolerance)
{
    double u;
    double excess;
    double forward;
    double height;
    double slope;
    double bend;
    int64_t i;
    double along;
    double rate;
    double ordinate;
    double move;
    u = traces__first_abscissa(work, trace, station - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_STATION)));
    (*exists) = INT64_C(0);
    excess = 0.0;
    forward = 1.0;
    height = 0.0;
    slope = 0.0;
    bend = 0.0;
    for (i = INT64_C(0); i < traces__TRACE_ITERATIONS; i += INT64_C(1))
    {
        if (u < (*cspan_at(&tables, profile + layout__PROFILE_START)))
        {
            u = (*cspan_at(&tables, profile + layout__PROFILE_START));
        }
        if (u > (*cspan_at(&tables, profile + layout__PROFILE_STOP)))
        {
            u = (*cspan_at(&tables, profile + layout__PROFILE_STOP));
        }
        profile_table__height_slope_bend(&height, &slope, &bend, tables, profile, u);
        forward = (*cspan_at(&work, plane + layout__DIRECTION_COS)) + slope * (*cspan_at(&work, plane + layout__DIRECTION_SIN));
        excess = (u - (*cspan_at(&work, point + layout__POINT_Y))) * (*cspan_at(&work, plane + layout__DIRECTION_COS)) + (height - (*cspan_at(&work, point + layout__POINT_Z))) * (*cspan_at(&work, plane + layout__DIRECTION_SIN)) - station;
        if (fabs(excess) < tolerance)
        {
            if (forward > 0.0)
            {
                (*exists) = INT64_C(1);
            }
            break;
        }
        u -= excess / forward;
    }
    along = 1.0 / forward;
    rate = ((*cspan_at(&work, plane + layout__DIRECTION_SIN)) - slope * (*cspan_at(&work, plane + layout__DIRECTION_COS))) * along;
    (*ordinate_bend) = (-bend) * along * along * along;
    (*cspan_at(&work, trace + layout__TRACE_ABSCISSA)) = u - excess * along;
    (*cspan_at(&work, trace + layout__TRACE_RATE)) = along;
    (*cspan_at(&work, trace + layout__TRACE_BEND)) = (*ordinate_bend) * (*cspan_at(&work, plane + layout__DIRECTION_SIN));
    ordinate = (u - (*cspan_at(&work, point + layout__POINT_Y))) * (*cspan_at(&work, plane + layout__DIRECTION_SIN)) - (height - (*cspan_at(&work, point + layout__POINT_Z))) * (*cspan_at(&work, plane + layout__DIRECTION_COS));
    move = (-excess) * along;
    (*result_0) = ordinate - excess * (rate - 0.5 * excess * (*ordinate_bend));
    (*result_1) = rate - excess * (*ordinate_bend);
    (*result_3) = slope + move * bend;
    (*result_4) = height + move * slope;
    return 0;
}

/* Height of the rail over the contact plane [m], its rate [-] and bend [1/m] at ``station``; and 1 if it
 * exists.
 */
static inline int64_t traces__trace_rail(double* ordinate, double* rate, double* bend, int64_t* exists, array_double_1d work, array_double_1d tables, double station, double tolerance)
{
    double slope;
    double height;
    traces__trace_profile(ordinate, rate, bend, &slope, &height, exists, tables, work, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAIL, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__RAIL, station, tolerance);
    return 0;
}

/* Height of the wheel over the contact plane [m], its rate [-], bend [1/m] and the wheel's 1/R_x [1/m] at
 * ``station``; and 1 if it exists.
 *
 * Without yaw the outline is the profile, turned by the roll.
 */
static inline int64_t traces__trace_wheel(double* ordinate, double* rate, double* bend, double* curvature, int64_t* exists, array_double_1d work, array_double_1d tables, double station, double tolerance)
{
    int64_t place;
    double lifted;
    double slope;
    double z;
    place = layout__WORK_CONTACT + layout__CONTACT_FRAME + (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLACE)));
    if (!((*cspan_at(&work, place + layout__PLACE_YAWED)) == 1.0))
    {
        lifted = station - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_LIFT)) * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_SIN));
        traces__trace_profile(ordinate, rate, bend, &slope, &z, exists, tables, work, (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL))), layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_WHEEL, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_WHEEL_PLANE, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__WHEEL, lifted, tolerance);
        (*ordinate) -= (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_LIFT)) * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS));
        (*curvature) = longitudinal_curvature__longitudinal_curvature(work, tables, place, z, slope, (*bend));
    }
    else
    {
        traces__trace_outline(ordinate, rate, bend, curvature, exists, work, tables, station, tolerance);
    }
    return 0;
}

/* ``trace_wheel`` with yaw. */
static inline int64_t traces__trace_outline(double* ordinate, double* result_1, double* ordinate_bend, double* curvature, int64_t* exists, array_double_1d work, array_double_1d tables, double station, double tolerance)
{
    int64_t wheel;
    int64_t place;
    int64_t trace;
    double cosine;
    double sine;
    double left;
    double above;
    double y;
    double excess;
    double along;
    double across;
    double up;
    double stretch;
    double z;
    double slope;
    double bend;
    double outline_slope;
    double outline_rate;
    int64_t i;
    double y_track;
    double z_track;
    double per_along;
    double per_stretch;
    double rate;
    double move;
    wheel = (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL)));
    place = layout__WORK_CONTACT + layout__CONTACT_FRAME + (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLACE)));
    trace = layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__WHEEL;
    cosine = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS));
    sine = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_SIN));
    left = (*cspan_at(&tables, layout__TABLES_RAIL_Y)) + (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAIL + layout__POINT_Y)) - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_ASIDE));
    above = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_SHIFT)) - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAIL + layout__POINT_Z));
    y = traces__first_abscissa(work, trace, station - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_STATION)));
    (*exists) = INT64_C(0);
    excess = 0.0;
    along = 1.0;
    across = 0.0;
    up = 0.0;
    stretch = 1.0;
    z = 0.0;
    slope = 0.0;
    bend = 0.0;
    outline_slope = 0.0;
    outline_rate = 0.0;
    for (i = INT64_C(0); i < traces__TRACE_ITERATIONS; i += INT64_C(1))
    {
        if (y < (*cspan_at(&tables, wheel + layout__PROFILE_START)))
        {
            y = (*cspan_at(&tables, wheel + layout__PROFILE_START));
        }
        if (y > (*cspan_at(&tables, wheel + layout__PROFILE_STOP)))
        {
            y = (*cspan_at(&tables, wheel + layout__PROFILE_STOP));
        }
        profile_table__height_slope_bend(&z, &slope, &bend, tables, wheel, y);
        locus__outline_jet(&y_track, &z_track, &outline_slope, &stretch, &outline_rate, work, place, y, z, slope, bend);
        across = y_track - left;
        up = z_track + above;
        along = cosine + outline_slope * sine;
        excess = across * cosine + up * sine - station;
        if (fabs(excess) < tolerance)
        {
            if (stretch * along > 0.0)
            {
                (*exists) = INT64_C(1);
            }
            break;
        }
        y -= excess / (stretch * along);
    }
    per_along = 1.0 / along;
    per_stretch = 1.0 / stretch;
    rate = (sine - outline_slope * cosine) * per_along;
    (*ordinate_bend) = (-outline_rate) * per_stretch * per_along * per_along * per_along;
    move = (-excess) * per_along * per_stretch;
    (*cspan_at(&work, trace + layout__TRACE_ABSCISSA)) = y + move;
    (*cspan_at(&work, trace + layout__TRACE_RATE)) = per_along * per_stretch;
    (*cspan_at(&work, trace + layout__TRACE_BEND)) = (*ordinate_bend) * sine * per_stretch;
    (*curvature) = longitudinal_curvature__longitudinal_curvature(work, tables, place, z + move * slope, slope + move * bend, bend);
    (*ordinate) = across * sine - up * cosine - excess * (rate - 0.5 * excess * (*ordinate_bend));
    (*result_1) = rate - excess * (*ordinate_bend);
    return 0;
}
