/* Generated from contact_plane.py by tools/transpile_kernel.py; change that one.
 *
 * The geometry that a normal contact model needs, in the plane of the rigid contact point.
 *
 * Station s runs along the contact plane to the field side, from the contact point; heights n are measured along the
 * plane's normal, from rail to wheel.  The outline of the wheel (:mod:`locus`) and the rail profile are both read as
 * n(s): the profile abscissa that projects on s is found by Newton's method from the previous station, and the last
 * residual is removed by the curve's own slope, which leaves an error of second order in a small residual.
 */

#include "contact_plane.h"

/* Place the contact plane at wheel abscissa ``y``; the slope is the rail's, which is the outline's there. */
static int64_t contact_plane__open_frame(array_double_1d tables, array_double_1d work, int64_t at, double y, double shift)
{
    double z;
    double slope;
    double bend;
    double y_track;
    double z_track;
    double outline_slope;
    double abscissa;
    double height;
    double rail_slope;
    double rail_bend;
    double cosine;
    profile_table__height_slope_bend(&z, &slope, &bend, tables, (int64_t)((*cspan_at(&tables, layout__SET_WHEEL))), y);
    locus__outline_point(&y_track, &z_track, &outline_slope, work, at, y, z, slope);
    abscissa = y_track - (*cspan_at(&tables, layout__SET_RAIL_Y));
    profile_table__height_slope_bend(&height, &rail_slope, &rail_bend, tables, (int64_t)((*cspan_at(&tables, layout__SET_RAIL))), abscissa);
    cosine = 1.0 / sqrt(1.0 + rail_slope * rail_slope);
    (*cspan_at(&work, contact_plane__FRAME_ABSCISSA)) = abscissa;
    (*cspan_at(&work, contact_plane__FRAME_HEIGHT)) = height;
    (*cspan_at(&work, contact_plane__FRAME_Y)) = y;
    (*cspan_at(&work, contact_plane__FRAME_COS)) = cosine;
    (*cspan_at(&work, contact_plane__FRAME_SIN)) = rail_slope * cosine;
    (*cspan_at(&work, contact_plane__FRAME_SHIFT)) = shift;
    (*cspan_at(&work, contact_plane__FRAME_PLACE)) = (double)(at);
    contact_plane__start_tracer(work, 0.0, abscissa, y);
    return INT64_C(0);
}

/* Let the tracer stand at ``station`` with rail abscissa ``abscissa`` and wheel abscissa ``y`` [m]. */
static int64_t contact_plane__start_tracer(array_double_1d work, double station, double abscissa, double y)
{
    (*cspan_at(&work, contact_plane__TRACER_STATION)) = station;
    (*cspan_at(&work, contact_plane__TRACER_RAIL)) = abscissa;
    (*cspan_at(&work, contact_plane__TRACER_RAIL_RATE)) = (*cspan_at(&work, contact_plane__FRAME_COS));
    (*cspan_at(&work, contact_plane__TRACER_RAIL_BEND)) = 0.0;
    (*cspan_at(&work, contact_plane__TRACER_WHEEL)) = y;
    (*cspan_at(&work, contact_plane__TRACER_WHEEL_RATE)) = (*cspan_at(&work, contact_plane__FRAME_COS));
    (*cspan_at(&work, contact_plane__TRACER_WHEEL_BEND)) = 0.0;
    return INT64_C(0);
}

/* Curvature 1/R_x of the wheel along the track at a locus point [1/m].
 *
 * effective: of the surface cut by the plane of the track's x and the contact normal.  With e the track's x in the
 * wheelset frame, [(e1 cos(phi) - e3 sin(phi))^2 / r - r'' e2^2] / sqrt(1 + r'^2); without yaw cos(delta) / r, the
 * source's eq. (6.1).
 * basic: 1/r.
 */
static double contact_plane__longitudinal_curvature(array_double_1d tables, array_double_1d place, int64_t at, double z, double slope, double bend)
{
    double r;
    double sin_phi;
    double cos_phi;
    double e1;
    double e2;
    double e3;
    double around;
    double steep;
    double curvature;
    r = (*cspan_at(&place, at + locus__PLACE_RADIUS)) + z;
    curvature = 1.0 / r;
    if ((int64_t)((*cspan_at(&tables, layout__SET_LONGITUDINAL))) == layout__LONGITUDINAL_BASIC)
    {
        return curvature;
    }
    if ((*cspan_at(&place, at + locus__PLACE_YAWED)) == 0.0)
    {
        curvature = 1.0 / (r * sqrt(1.0 + slope * slope));
    }
    else
    {
        locus__around_wheel(&sin_phi, &cos_phi, place, at, slope);
        e1 = (*cspan_at(&place, at + locus__PLACE_COS_YAW));
        e2 = (*cspan_at(&place, at + locus__PLACE_SIN_YAW)) * (*cspan_at(&place, at + locus__PLACE_COS_ROLL));
        e3 = (*cspan_at(&place, at + locus__PLACE_SIN_YAW)) * (*cspan_at(&place, at + locus__PLACE_SIN_ROLL));
        around = e1 * cos_phi - e3 * sin_phi;
        steep = sqrt(1.0 + slope * slope);
        curvature = (around * around / r - bend * e2 * e2) / steep;
        if (curvature < contact_plane__CURVATURE_FLOOR / (r * steep))
        {
            curvature = contact_plane__CURVATURE_FLOOR / (r * steep);
        }
    }
    return curvature;
}

/* Height of the rail over the contact plane [m], its rate [-] and bend [1/m] at ``station``; and 1 if it exists. */
static int64_t contact_plane__trace_rail(double* ordinate, double* rate, double* result_2, int64_t* exists, array_double_1d tables, array_double_1d work, double station, double tolerance)
{
    int64_t rail;
    double cosine;
    double sine;
    double away;
    double u;
    double offset;
    double forward;
    double height;
    double slope;
    double bend;
    int64_t i;
    rail = (int64_t)((*cspan_at(&tables, layout__SET_RAIL)));
    cosine = (*cspan_at(&work, contact_plane__FRAME_COS));
    sine = (*cspan_at(&work, contact_plane__FRAME_SIN));
    away = station - (*cspan_at(&work, contact_plane__TRACER_STATION));
    u = (*cspan_at(&work, contact_plane__TRACER_RAIL)) + away * (*cspan_at(&work, contact_plane__TRACER_RAIL_RATE));
    if (fabs(away) < contact_plane__NEAR)
    {
        u += 0.5 * away * away * (*cspan_at(&work, contact_plane__TRACER_RAIL_BEND));
    }
    (*exists) = INT64_C(1);
    offset = 0.0;
    forward = 1.0;
    height = 0.0;
    slope = 0.0;
    bend = 0.0;
    for (i = INT64_C(0); i < contact_plane__TRACE_ITERATIONS; i += INT64_C(1))
    {
        if (u < (*cspan_at(&tables, rail + profile_table__START)))
        {
            u = (*cspan_at(&tables, rail + profile_table__START));
        }
        if (u > (*cspan_at(&tables, rail + profile_table__STOP)))
        {
            u = (*cspan_at(&tables, rail + profile_table__STOP));
        }
        profile_table__height_slope_bend(&height, &slope, &bend, tables, rail, u);
        forward = cosine + slope * sine;
        offset = (u - (*cspan_at(&work, contact_plane__FRAME_ABSCISSA))) * cosine + (height - (*cspan_at(&work, contact_plane__FRAME_HEIGHT))) * sine - station;
        if (fabs(offset) < tolerance)
        {
            break;
        }
        u -= offset / forward;
    }
    if (!((fabs(offset) < tolerance) && (forward > 0.0)))
    {
        (*exists) = INT64_C(0);
    }
    (*rate) = (sine - slope * cosine) / forward;
    (*ordinate) = (u - (*cspan_at(&work, contact_plane__FRAME_ABSCISSA))) * sine - (height - (*cspan_at(&work, contact_plane__FRAME_HEIGHT))) * cosine - offset * (*rate);
    (*cspan_at(&work, contact_plane__TRACER_RAIL)) = u - offset / forward;
    (*cspan_at(&work, contact_plane__TRACER_RAIL_RATE)) = 1.0 / forward;
    (*cspan_at(&work, contact_plane__TRACER_RAIL_BEND)) = (-bend) * sine / (forward * forward * forward);
    (*result_2) = (-bend) / (forward * forward * forward);
    return 0;
}

/* Height of the wheel over the contact plane [m], its rate [-], bend [1/m] and the wheel's 1/R_x [1/m] at
 * ``station``; and 1 if it exists.
 */
static int64_t contact_plane__trace_wheel(double* ordinate, double* rate, double* result_2, double* result_3, int64_t* exists, array_double_1d tables, array_double_1d work, double station, double tolerance)
{
    int64_t wheel;
    int64_t at;
    double cosine;
    double sine;
    double away;
    double y;
    double offset;
    double forward;
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
    double along;
    double outline_bend;
    wheel = (int64_t)((*cspan_at(&tables, layout__SET_WHEEL)));
    at = (int64_t)((*cspan_at(&work, contact_plane__FRAME_PLACE)));
    cosine = (*cspan_at(&work, contact_plane__FRAME_COS));
    sine = (*cspan_at(&work, contact_plane__FRAME_SIN));
    away = station - (*cspan_at(&work, contact_plane__TRACER_STATION));
    y = (*cspan_at(&work, contact_plane__TRACER_WHEEL)) + away * (*cspan_at(&work, contact_plane__TRACER_WHEEL_RATE));
    if (fabs(away) < contact_plane__NEAR)
    {
        y += 0.5 * away * away * (*cspan_at(&work, contact_plane__TRACER_WHEEL_BEND));
    }
    (*exists) = INT64_C(1);
    offset = 0.0;
    forward = 1.0;
    across = 0.0;
    up = 0.0;
    stretch = 1.0;
    z = 0.0;
    slope = 0.0;
    bend = 0.0;
    outline_slope = 0.0;
    outline_rate = 0.0;
    for (i = INT64_C(0); i < contact_plane__TRACE_ITERATIONS; i += INT64_C(1))
    {
        if (y < (*cspan_at(&tables, wheel + profile_table__START)))
        {
            y = (*cspan_at(&tables, wheel + profile_table__START));
        }
        if (y > (*cspan_at(&tables, wheel + profile_table__STOP)))
        {
            y = (*cspan_at(&tables, wheel + profile_table__STOP));
        }
        profile_table__height_slope_bend(&z, &slope, &bend, tables, wheel, y);
        locus__outline_jet(&y_track, &z_track, &outline_slope, &stretch, &outline_rate, work, at, y, z, slope, bend);
        across = y_track - (*cspan_at(&tables, layout__SET_RAIL_Y)) - (*cspan_at(&work, contact_plane__FRAME_ABSCISSA));
        up = z_track + (*cspan_at(&work, contact_plane__FRAME_SHIFT)) - (*cspan_at(&work, contact_plane__FRAME_HEIGHT));
        forward = stretch * (cosine + outline_slope * sine);
        offset = across * cosine + up * sine - station;
        if (fabs(offset) < tolerance)
        {
            break;
        }
        y -= offset / forward;
    }
    if (!((fabs(offset) < tolerance) && (forward > 0.0)))
    {
        (*exists) = INT64_C(0);
    }
    along = cosine + outline_slope * sine;
    (*rate) = (sine - outline_slope * cosine) / along;
    (*ordinate) = across * sine - up * cosine - offset * (*rate);
    outline_bend = outline_rate / (stretch * along * along * along);
    (*cspan_at(&work, contact_plane__TRACER_WHEEL)) = y - offset / forward;
    (*cspan_at(&work, contact_plane__TRACER_WHEEL_RATE)) = 1.0 / forward;
    (*cspan_at(&work, contact_plane__TRACER_WHEEL_BEND)) = (-outline_bend) * sine / stretch;
    (*result_2) = -outline_bend;
    (*result_3) = contact_plane__longitudinal_curvature(tables, work, at, z, slope, bend);
    return 0;
}

/* Gap g along the contact normal [m], dg/ds [-], d2g/ds2 [1/m] and the wheel's 1/R_x [1/m] at ``station`` [m].
 *
 * NO_GAP where a profile has ended.
 */
static int64_t contact_plane__normal_gap(double* gap, double* result_1, double* result_2, double* curvature, array_double_1d tables, array_double_1d work, array_double_1d state, double station, double tolerance)
{
    double rail_height;
    double rail_rate;
    double rail_bend;
    int64_t on_rail;
    double wheel_height;
    double wheel_rate;
    double wheel_bend;
    int64_t on_wheel;
    (*cspan_at(&state, layout__STATE_NODE_COUNT)) += 1.0;
    contact_plane__trace_rail(&rail_height, &rail_rate, &rail_bend, &on_rail, tables, work, station, tolerance);
    contact_plane__trace_wheel(&wheel_height, &wheel_rate, &wheel_bend, curvature, &on_wheel, tables, work, station, tolerance);
    (*cspan_at(&work, contact_plane__TRACER_STATION)) = station;
    (*gap) = wheel_height - rail_height;
    if ((on_rail == INT64_C(0)) || (on_wheel == INT64_C(0)))
    {
        (*gap) = contact_plane__NO_GAP;
    }
    (*result_1) = wheel_rate - rail_rate;
    (*result_2) = wheel_bend - rail_bend;
    return 0;
}
