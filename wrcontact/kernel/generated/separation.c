/* Generated from contact/separation.py by tools/transpile_kernel.py; change that one.
 *
 * The undeformed distance over a region's stations, measured in one of four ways.
 *
 * normal        along the normal of the contact plane, :mod:`contact_plane`; of a pressed wheel, along the
 *               rail's, :mod:`pressed`;
 * vertical      at common lateral track coordinate: station s stands for y = y_0 + s cos(plane's angle);
 * equidistant   between the points at arc length s from the region's minimum on both curves, along the mean of
 *               their normals;
 * chord         likewise, with points that a circle of radius h around the one before cuts out of the curve (the
 *               source).
 *
 * Except for the first, the wheel is moved so that its point at the region's minimum lies on the rail's, and the
 * smallest gap is added again: each region is a contact of its own, and only differences of coordinates count,
 * not where the wheelset is.
 */

#include "separation.h"

/* Vertical distance at ``station`` [m], its rate [-] and bend [1/m] over the stations, and 1 if it
 * exists.
 */
static OUT_OF_LINE int64_t separation__vertical_rise(double* result_0, double* result_1, double* result_2, int64_t* exists, array_double_1d work, array_double_1d tables, double station)
{
    double per_station;
    double lateral;
    double across;
    double rail_down;
    double rail_slope;
    double along;
    double rail_bend;
    double down;
    double slope;
    double stretch;
    double bend;
    per_station = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS));
    lateral = (station - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_ORIGIN + layout__ORIGIN_STATION))) * per_station;
    (*exists) = moves__move_across(work, tables, lateral);
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__RAIL + layout__TRACE_ABSCISSA)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_ORIGIN + layout__ORIGIN_POINTS + layout__POINT_SIZE * layout__RAIL + layout__POINT_Y)) + lateral;
    if (curves__within(tables, layout__RAIL, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__RAIL + layout__TRACE_ABSCISSA))) != (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__RAIL + layout__TRACE_ABSCISSA)))
    {
        (*exists) = INT64_C(0);
    }
    curves__curve_jet(&across, &rail_down, &rail_slope, &along, &rail_bend, work, tables, layout__RAIL, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__RAIL + layout__TRACE_ABSCISSA)));
    curves__curve_jet(&across, &down, &slope, &stretch, &bend, work, tables, layout__WHEEL, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__WHEEL + layout__TRACE_ABSCISSA)));
    bend = rail_bend - bend / stretch;
    (*result_0) = rail_down - down;
    (*result_1) = (rail_slope - slope) * per_station;
    (*result_2) = bend * per_station * per_station;
    return 0;
}

/* Distance along the mean of the normals between the points at ``station`` [m] on both curves, signed,
 * its rate [-] and bend [1/m] over the stations, and 1 if it exists.
 *
 * With angles theta of the tangents and n = (sin, -cos) of their mean, d = (p_w - p_r) n and
 *
 *     dd/ds = (t_w - t_r) n + (p_w - p_r) t (theta_w' + theta_r') / 2
 *
 * of which the last term is of third order in s.
 */
static OUT_OF_LINE int64_t separation__equidistant_rise(double* result_0, double* rate, double* result_2, int64_t* exists, array_double_1d work, array_double_1d tables, double station)
{
    int64_t on_rail;
    int64_t on_wheel;
    double across;
    double down;
    double slope;
    double stretch;
    double bend;
    double rail_cos;
    double rail_sin;
    double rail_curvature;
    double wheel_across;
    double wheel_down;
    double wheel_cos;
    double wheel_sin;
    double wheel_curvature;
    double cosine;
    double sine;
    double size;
    on_rail = moves__move_to_station(work, tables, layout__RAIL, station);
    on_wheel = moves__move_to_station(work, tables, layout__WHEEL, station);
    curves__curve_jet(&across, &down, &slope, &stretch, &bend, work, tables, layout__RAIL, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__RAIL + layout__TRACE_ABSCISSA)));
    rail_cos = 1.0 / sqrt(1.0 + slope * slope);
    rail_sin = slope * rail_cos;
    rail_curvature = bend * rail_cos * rail_cos * rail_cos;
    curves__curve_jet(&wheel_across, &wheel_down, &slope, &stretch, &bend, work, tables, layout__WHEEL, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__WHEEL + layout__TRACE_ABSCISSA)));
    wheel_cos = 1.0 / sqrt(1.0 + slope * slope);
    wheel_sin = slope * wheel_cos;
    wheel_curvature = bend / stretch * wheel_cos * wheel_cos * wheel_cos;
    across = wheel_across - across;
    down = wheel_down - down;
    cosine = wheel_cos + rail_cos;
    sine = wheel_sin + rail_sin;
    size = sqrt(cosine * cosine + sine * sine);
    cosine /= size;
    sine /= size;
    (*exists) = INT64_C(0);
    if ((on_rail == INT64_C(1)) && (on_wheel == INT64_C(1)) && (stretch > 0.0))
    {
        (*exists) = INT64_C(1);
    }
    (*rate) = (wheel_cos - rail_cos) * sine - (wheel_sin - rail_sin) * cosine;
    (*rate) += 0.5 * (across * cosine + down * sine) * (wheel_curvature + rail_curvature);
    (*result_0) = across * sine - down * cosine;
    (*result_2) = rail_curvature - wheel_curvature;
    return 0;
}

/* How much less deep a pressed wheel is at the rail's trace than at the contact point, since it is
 * pressed along the region's normal: depth (1 - cos(angle between the normals)) [m]; and its rate [-].
 */
static OUT_OF_LINE int64_t separation__depth_lost(double* result_0, double* result_1, array_double_1d work, array_double_1d tables)
{
    double height;
    double slope;
    double bend;
    double cosine;
    double along;
    double across;
    profile_table__height_slope_bend(&height, &slope, &bend, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__RAIL + layout__TRACE_ABSCISSA)));
    cosine = 1.0 / sqrt(1.0 + slope * slope);
    along = cosine * ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS)) + slope * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_SIN)));
    across = cosine * (slope * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS)) - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_SIN)));
    (*result_0) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_DEPTH)) * (1.0 - along);
    (*result_1) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_DEPTH)) * across * bend * cosine * cosine * cosine;
    return 0;
}

/* ``separation`` of any other kind than along the normal: with the wheel moved onto the rail at the
 * region's minimum.
 */
static OUT_OF_LINE int64_t separation__moved_separation(double* gap, double* rate, double* bend, double* curvature, array_double_1d work, array_double_1d tables, array_double_1d state, double station, int64_t kind)
{
    int64_t exists;
    double lost;
    double more;
    double y;
    double z;
    double slope;
    double wheel_bend;
    (*cspan_at(&state, layout__STATE_NODE_COUNT)) += 1.0;
    if (kind == layout__SEPARATION_VERTICAL)
    {
        separation__vertical_rise(gap, rate, bend, &exists, work, tables, station);
    }
    else
    {
        separation__equidistant_rise(gap, rate, bend, &exists, work, tables, station);
    }
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_STATION)) = station;
    (*gap) += (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_ORIGIN + layout__ORIGIN_GAP));
    if (((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PRESSED)) == 1.0) && (kind != layout__SEPARATION_VERTICAL))
    {
        separation__depth_lost(&lost, &more, work, tables);
        (*gap) += lost;
        (*rate) += more;
    }
    if (exists == INT64_C(0))
    {
        (*gap) = contact_plane__NO_GAP;
    }
    y = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__WHEEL + layout__TRACE_ABSCISSA));
    profile_table__height_slope_bend(&z, &slope, &wheel_bend, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL))), y);
    wheel_bend = pressed__mean_bend(work, tables, y, wheel_bend);
    (*curvature) = longitudinal_curvature__longitudinal_curvature(work, tables, layout__WORK_CONTACT + layout__CONTACT_FRAME + (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLACE))), z, slope, wheel_bend);
    return 0;
}

/* Undeformed distance g [m], dg/ds [-], d2g/ds2 [1/m] and the wheel's 1/R_x [1/m] at ``station`` [m],
 * measured as chosen; NO_GAP where a profile has ended.
 *
 * ``tolerance`` is that of :func:`normal_gap`; all else is satisfied to MOVE_SHARP.
 */
static inline int64_t separation__separation(double* gap, double* rate, double* bend, double* curvature, array_double_1d work, array_double_1d tables, array_double_1d state, double station, double tolerance)
{
    int64_t kind;
    kind = (int64_t)((*cspan_at(&tables, layout__TABLES_SEPARATION)));
    if ((kind == layout__SEPARATION_NORMAL) && (!((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PRESSED)) == 1.0)))
    {
        contact_plane__normal_gap(gap, rate, bend, curvature, work, tables, state, station, tolerance);
    }
    else if (kind == layout__SEPARATION_NORMAL)
    {
        pressed__pressed_gap(gap, rate, bend, curvature, work, tables, state, station);
    }
    else
    {
        separation__moved_separation(gap, rate, bend, curvature, work, tables, state, station, kind);
    }
    return 0;
}
