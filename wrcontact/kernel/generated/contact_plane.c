/* Generated from contact/contact_plane.py by tools/transpile_kernel.py; change that one.
 *
 * The geometry that a normal contact model needs, in the plane of the rigid contact point.
 *
 * Station s runs along the contact plane to the field side, from the contact point; heights n are measured along the
 * plane's normal, from rail to wheel.  The outline of the wheel (:mod:`locus`) and the rail profile are both read as
 * n(s): the profile abscissa that projects on s is found by Newton's method from the previous station, and the last
 * residual is removed by the curve's own slope and bend, which leaves an error of third order in a small residual.
 */

#include "contact_plane.h"

/* Place the contact plane at wheel abscissa ``y``; the slope is the rail's, which is the outline's there.
 *
 * aside, shift : lateral and vertical shift that let the wheel touch the rail there [m].
 *
 * Returns what describes the point: wheel height [m] and slope [-], lateral track coordinate [m], rail slope [-], and how
 * much the slopes of rail and outline differ [-], FOLDED as in :mod:`gap`.
 */
static inline int64_t contact_plane__open_frame(double* z, double* slope, double* y_track, double* rail_slope, double* mismatch, array_double_1d tables, array_double_1d work, int64_t at, double y, double aside, double shift)
{
    double bend;
    double z_track;
    double outline_slope;
    double stretch;
    double outline_rate;
    double abscissa;
    double height;
    double rail_bend;
    double cosine;
    double sine;
    profile_table__height_slope_bend(z, slope, &bend, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL))), y);
    locus__outline_jet(y_track, &z_track, &outline_slope, &stretch, &outline_rate, work, at, y, (*z), (*slope), bend);
    (*y_track) += aside;
    abscissa = (*y_track) - (*cspan_at(&tables, layout__TABLES_RAIL_Y));
    profile_table__height_slope_bend(&height, rail_slope, &rail_bend, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), abscissa);
    cosine = 1.0 / sqrt(1.0 + (*rail_slope) * (*rail_slope));
    sine = (*rail_slope) * cosine;
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_ABSCISSA)) = abscissa;
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_HEIGHT)) = height;
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_Y)) = y;
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_COS)) = cosine;
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_SIN)) = sine;
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_SHIFT)) = shift;
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_PLACE)) = (double)(at);
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_Z)) = (*z);
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_WHEEL_COS)) = (*cspan_at(&work, at + layout__PLACE_COS_ROLL)) * cosine + (*cspan_at(&work, at + layout__PLACE_SIN_ROLL)) * sine;
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_WHEEL_SIN)) = (*cspan_at(&work, at + layout__PLACE_COS_ROLL)) * sine - (*cspan_at(&work, at + layout__PLACE_SIN_ROLL)) * cosine;
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_LIFT)) = z_track + shift - height;
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_ASIDE)) = aside;
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_RAISED)) = 0.0;
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_POSE)) = shift;
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_DEPTH)) = 0.0;
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_PRESSED)) = (double)(0);
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_BLUR)) = 0.0;
    contact_plane__start_tracer(work, 0.0, abscissa, y);
    (*mismatch) = (*rail_slope) - outline_slope;
    if (!(stretch > 0.0))
    {
        (*mismatch) = gap__FOLDED;
    }
    return 0;
}

/* Let the tracer stand at ``station`` with rail abscissa ``abscissa`` and wheel abscissa ``y`` [m]. */
static inline int64_t contact_plane__start_tracer(array_double_1d work, double station, double abscissa, double y)
{
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_STATION)) = station;
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_RAIL)) = abscissa;
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_RAIL_RATE)) = (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_COS));
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_RAIL_BEND)) = 0.0;
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_WHEEL)) = y;
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_WHEEL_RATE)) = (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_COS));
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_WHEEL_BEND)) = 0.0;
    return INT64_C(0);
}

/* Curvature 1/R_x of the wheel along the track at a locus point [1/m].
 *
 * effective: of the surface cut by the plane of the track's x and the contact normal.  With e the track's x in the
 * wheelset frame, [(e1 cos(phi) - e3 sin(phi))^2 / r - r'' e2^2] / sqrt(1 + r'^2); without yaw cos(delta) / r, the
 * source's eq. (6.1).
 * basic: 1/r.
 */
static inline double contact_plane__longitudinal_curvature(array_double_1d tables, array_double_1d place, int64_t at, double z, double slope, double bend)
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
    r = (*cspan_at(&place, at + layout__PLACE_RADIUS)) + z;
    curvature = 1.0 / r;
    if ((int64_t)((int64_t)((*cspan_at(&tables, layout__TABLES_LONGITUDINAL)))) == layout__LONGITUDINAL_BASIC)
    {
        return curvature;
    }
    if (!((*cspan_at(&place, at + layout__PLACE_YAWED)) == 1.0))
    {
        curvature = 1.0 / (r * sqrt(1.0 + slope * slope));
    }
    else
    {
        locus__around_wheel(&sin_phi, &cos_phi, place, at, slope);
        e1 = (*cspan_at(&place, at + layout__PLACE_COS_YAW));
        e2 = (*cspan_at(&place, at + layout__PLACE_SIN_YAW)) * (*cspan_at(&place, at + layout__PLACE_COS_ROLL));
        e3 = (*cspan_at(&place, at + layout__PLACE_SIN_YAW)) * (*cspan_at(&place, at + layout__PLACE_SIN_ROLL));
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

/* Profile abscissa ``away`` from the tracer's station [m]; ``tracer`` is TRACER_RAIL or TRACER_WHEEL. */
static inline double contact_plane__first_abscissa(array_double_1d work, int64_t tracer, double away)
{
    double u;
    u = (*cspan_at(&work, tracer)) + away * (*cspan_at(&work, tracer + INT64_C(1)));
    if (fabs(away) < contact_plane__NEAR)
    {
        u += 0.5 * away * away * (*cspan_at(&work, tracer + INT64_C(2)));
    }
    return u;
}

/* Height of a profile over the contact plane [m], its rate [-] and bend [1/m] at ``station``, its slope there [-], its
 * height [m], and 1 if it exists.
 *
 * tracer : TRACER_RAIL or TRACER_WHEEL.
 * frame : where cosine and sine of the plane's angle against the profile stand.
 * origin, height_there : the profile's point at station zero [m].
 */
static inline int64_t contact_plane__trace_profile(double* result_0, double* result_1, double* turn, double* slope, double* height, int64_t* exists, array_double_1d tables, array_double_1d work, int64_t profile, int64_t tracer, int64_t frame, double station, double tolerance, double origin, double height_there)
{
    double cosine;
    double sine;
    double start;
    double stop;
    double u;
    double offset;
    double forward;
    double bend;
    int64_t i;
    double along;
    double rate;
    double ordinate;
    cosine = (*cspan_at(&work, frame));
    sine = (*cspan_at(&work, frame + INT64_C(1)));
    start = (*cspan_at(&tables, profile + layout__PROFILE_START));
    stop = (*cspan_at(&tables, profile + layout__PROFILE_STOP));
    u = contact_plane__first_abscissa(work, tracer, station - (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_STATION)));
    (*exists) = INT64_C(0);
    offset = 0.0;
    forward = 1.0;
    (*height) = 0.0;
    (*slope) = 0.0;
    bend = 0.0;
    for (i = INT64_C(0); i < contact_plane__TRACE_ITERATIONS; i += INT64_C(1))
    {
        if (u < start)
        {
            u = start;
        }
        if (u > stop)
        {
            u = stop;
        }
        profile_table__height_slope_bend(height, slope, &bend, tables, profile, u);
        forward = cosine + (*slope) * sine;
        offset = (u - origin) * cosine + ((*height) - height_there) * sine - station;
        if (fabs(offset) < tolerance)
        {
            if (forward > 0.0)
            {
                (*exists) = INT64_C(1);
            }
            break;
        }
        u -= offset / forward;
    }
    along = 1.0 / forward;
    rate = (sine - (*slope) * cosine) * along;
    (*turn) = (-bend) * along * along * along;
    (*cspan_at(&work, tracer)) = u - offset * along;
    (*cspan_at(&work, tracer + INT64_C(1))) = along;
    (*cspan_at(&work, tracer + INT64_C(2))) = (*turn) * sine;
    ordinate = (u - origin) * sine - ((*height) - height_there) * cosine;
    (*result_0) = ordinate - offset * (rate - 0.5 * offset * (*turn));
    (*result_1) = rate - offset * (*turn);
    return 0;
}

/* Height of the rail over the contact plane [m], its rate [-] and bend [1/m] at ``station``; and 1 if it exists. */
static inline int64_t contact_plane__trace_rail(double* ordinate, double* rate, double* bend, int64_t* exists, array_double_1d tables, array_double_1d work, double station, double tolerance)
{
    double slope;
    double height;
    contact_plane__trace_profile(ordinate, rate, bend, &slope, &height, exists, tables, work, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), contact_plane__TRACER_RAIL, contact_plane__AT_PLANE, station, tolerance, (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_ABSCISSA)), (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_HEIGHT)));
    return 0;
}

/* Height of the wheel over the contact plane [m], its rate [-], bend [1/m] and the wheel's 1/R_x [1/m] at
 * ``station``; and 1 if it exists.
 *
 * Without yaw the outline is the profile, turned by the roll.
 */
static inline int64_t contact_plane__trace_wheel(double* ordinate, double* rate, double* bend, double* curvature, int64_t* exists, array_double_1d tables, array_double_1d work, double station, double tolerance)
{
    int64_t at;
    double lift;
    double slope;
    double z;
    at = (int64_t)((*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_PLACE)));
    if (!((*cspan_at(&work, at + layout__PLACE_YAWED)) == 1.0))
    {
        lift = (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_LIFT));
        contact_plane__trace_profile(ordinate, rate, bend, &slope, &z, exists, tables, work, (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL))), contact_plane__TRACER_WHEEL, contact_plane__AT_WHEEL_PLANE, station - lift * (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_SIN)), tolerance, (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_Y)), (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_Z)));
        (*ordinate) -= lift * (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_COS));
        (*curvature) = contact_plane__longitudinal_curvature(tables, work, at, z, slope, (*bend));
    }
    else
    {
        contact_plane__trace_outline(ordinate, rate, bend, curvature, exists, tables, work, at, station, tolerance);
    }
    return 0;
}

/* ``trace_wheel`` with yaw. */
static inline int64_t contact_plane__trace_outline(double* result_0, double* result_1, double* turn, double* curvature, int64_t* exists, array_double_1d tables, array_double_1d work, int64_t at, double station, double tolerance)
{
    int64_t wheel;
    double cosine;
    double sine;
    double start;
    double stop;
    double left;
    double above;
    double y;
    double offset;
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
    wheel = (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL)));
    cosine = (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_COS));
    sine = (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_SIN));
    start = (*cspan_at(&tables, wheel + layout__PROFILE_START));
    stop = (*cspan_at(&tables, wheel + layout__PROFILE_STOP));
    left = (*cspan_at(&tables, layout__TABLES_RAIL_Y)) + (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_ABSCISSA)) - (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_ASIDE));
    above = (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_SHIFT)) - (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_HEIGHT));
    y = contact_plane__first_abscissa(work, contact_plane__TRACER_WHEEL, station - (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_STATION)));
    (*exists) = INT64_C(0);
    offset = 0.0;
    along = 1.0;
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
        if (y < start)
        {
            y = start;
        }
        if (y > stop)
        {
            y = stop;
        }
        profile_table__height_slope_bend(&z, &slope, &bend, tables, wheel, y);
        locus__outline_jet(&y_track, &z_track, &outline_slope, &stretch, &outline_rate, work, at, y, z, slope, bend);
        across = y_track - left;
        up = z_track + above;
        along = cosine + outline_slope * sine;
        offset = across * cosine + up * sine - station;
        if (fabs(offset) < tolerance)
        {
            if (stretch * along > 0.0)
            {
                (*exists) = INT64_C(1);
            }
            break;
        }
        y -= offset / (stretch * along);
    }
    per_along = 1.0 / along;
    per_stretch = 1.0 / stretch;
    rate = (sine - outline_slope * cosine) * per_along;
    (*turn) = (-outline_rate) * per_stretch * per_along * per_along * per_along;
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_WHEEL)) = y - offset * per_along * per_stretch;
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_WHEEL_RATE)) = per_along * per_stretch;
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_WHEEL_BEND)) = (*turn) * sine * per_stretch;
    (*curvature) = contact_plane__longitudinal_curvature(tables, work, at, z, slope, bend);
    (*result_0) = across * sine - up * cosine - offset * (rate - 0.5 * offset * (*turn));
    (*result_1) = rate - offset * (*turn);
    return 0;
}

/* Gap g along the contact normal [m], dg/ds [-], d2g/ds2 [1/m] and the wheel's 1/R_x [1/m] at ``station`` [m].
 *
 * NO_GAP where a profile has ended.
 */
static inline int64_t contact_plane__normal_gap(double* gap, double* result_1, double* result_2, double* curvature, array_double_1d tables, array_double_1d work, array_double_1d state, double station, double tolerance)
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
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_STATION)) = station;
    (*gap) = wheel_height - rail_height + (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_RAISED));
    if ((on_rail == INT64_C(0)) || (on_wheel == INT64_C(0)))
    {
        (*gap) = contact_plane__NO_GAP;
    }
    (*result_1) = wheel_rate - rail_rate;
    (*result_2) = wheel_bend - rail_bend;
    return 0;
}

/* 1 if the wheel of the open frame is yawed, else 0. */
static inline int64_t contact_plane__is_yawed(array_double_1d work)
{
    int64_t at;
    int64_t yawed;
    at = (int64_t)((*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_PLACE)));
    yawed = INT64_C(0);
    if ((*cspan_at(&work, at + layout__PLACE_YAWED)) == 1.0)
    {
        yawed = INT64_C(1);
    }
    return yawed;
}

/* Track coordinate x [m] of the wheel's outline at wheel abscissa ``y`` [m]. */
static inline double contact_plane__ridge_place(array_double_1d tables, array_double_1d work, double y)
{
    int64_t at;
    double z;
    double slope;
    double sin_phi;
    double cos_phi;
    double r;
    double lateral;
    double result;
    at = (int64_t)((*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_PLACE)));
    profile_table__height_slope(&z, &slope, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL))), y);
    locus__around_wheel(&sin_phi, &cos_phi, work, at, slope);
    r = (*cspan_at(&work, at + layout__PLACE_RADIUS)) + z;
    lateral = ((*cspan_at(&work, at + layout__PLACE_ARM)) + y) * (*cspan_at(&work, at + layout__PLACE_COS_ROLL)) - r * cos_phi * (*cspan_at(&work, at + layout__PLACE_SIN_ROLL));
    result = (*cspan_at(&work, at + layout__PLACE_COS_YAW)) * r * sin_phi - (*cspan_at(&work, at + layout__PLACE_SIN_YAW)) * lateral;
    return result;
}
