/* Generated from contact/separation.py by tools/transpile_kernel.py; change that one.
 *
 * The undeformed distance over a region's stations, measured in one of four ways.
 *
 * normal        along the normal of the contact plane, :mod:`contact_plane`; of a pressed wheel, along the rail's, :mod:`pressed`;
 * vertical      at common lateral track coordinate: station s stands for y = y_0 + s cos(plane's angle);
 * equidistant   between the points at arc length s from the region's minimum on both curves, along the mean of their normals;
 * chord         likewise, with points that a circle of radius h around the one before cuts out of the curve (the source).
 *
 * Except for the first, the wheel is moved so that its point at the region's minimum lies on the rail's, and the smallest gap
 * is added again: each region is a contact of its own, and only differences of coordinates count, not where the wheelset is.
 * The wheel's curve is its outline (:mod:`locus`); without yaw that is the profile, turned by the roll.
 */

#include "separation.h"

/* The profile that ``tracer``, TRACER_RAIL or TRACER_WHEEL, moves on. */
static OUT_OF_LINE int64_t separation__curve_profile(array_double_1d tables, int64_t tracer)
{
    int64_t profile;
    profile = (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL)));
    if (tracer == contact_plane__TRACER_RAIL)
    {
        profile = (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL)));
    }
    return profile;
}

/* Point of a curve from its origin, across and down [m], its slope [-], and along the profile abscissa ``u`` the
 * derivatives of the lateral coordinate [-] and of the slope [1/m].  ``tracer``: TRACER_RAIL or TRACER_WHEEL.
 */
static OUT_OF_LINE int64_t separation__curve_jet(double* across, double* down, double* slope, double* stretch, double* bend, array_double_1d tables, array_double_1d work, int64_t tracer, double u)
{
    double z;
    double y_track;
    double z_track;
    profile_table__height_slope_bend(&z, slope, bend, tables, separation__curve_profile(tables, tracer), u);
    (*across) = u - (*cspan_at(&work, layout__WORK_ORIGIN + layout__ORIGIN_RAIL + INT64_C(0)));
    (*down) = z - (*cspan_at(&work, layout__WORK_ORIGIN + layout__ORIGIN_RAIL + INT64_C(1)));
    (*stretch) = 1.0;
    if (tracer == contact_plane__TRACER_WHEEL)
    {
        locus__outline_jet(&y_track, &z_track, slope, stretch, bend, work, (int64_t)((*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_PLACE))), u, z, (*slope), (*bend));
        (*across) = y_track - (*cspan_at(&work, layout__WORK_ORIGIN + layout__ORIGIN_WHEEL + INT64_C(0)));
        (*down) = z_track - (*cspan_at(&work, layout__WORK_ORIGIN + layout__ORIGIN_WHEEL + INT64_C(1)));
    }
    return 0;
}

/* Arc length per profile abscissa [-]; of an outline that folds back it is negative.  A roll does not change it. */
static OUT_OF_LINE double separation__curve_speed(array_double_1d tables, array_double_1d work, int64_t tracer, double u)
{
    int64_t at;
    double z;
    double slope;
    double across;
    double down;
    double stretch;
    double bend;
    double speed;
    speed = 1.0;
    at = (int64_t)((*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_PLACE)));
    if ((tracer == contact_plane__TRACER_RAIL) || (!((*cspan_at(&work, at + layout__PLACE_YAWED)) == 1.0)))
    {
        profile_table__height_slope(&z, &slope, tables, separation__curve_profile(tables, tracer), u);
        speed = sqrt(1.0 + slope * slope);
    }
    else
    {
        separation__curve_jet(&across, &down, &slope, &stretch, &bend, tables, work, tracer, u);
        speed = stretch * sqrt(1.0 + slope * slope);
    }
    return speed;
}

/* Arc length [m] between abscissae within one piece of the profile; Gauss with six points. */
static OUT_OF_LINE double separation__panel_length(array_double_1d tables, array_double_1d work, int64_t tracer, double low, double high)
{
    double middle;
    double half;
    double total;
    int64_t i;
    double side;
    int64_t k;
    double away;
    double weight;
    middle = 0.5 * (low + high);
    half = 0.5 * (high - low);
    total = 0.0;
    for (i = -INT64_C(1); i < INT64_C(2); i += INT64_C(2))
    {
        side = half * (double)(i);
        for (k = INT64_C(0); k < INT64_C(3); k += INT64_C(1))
        {
            away = separation__GAUSS_1;
            weight = separation__WEIGHT_1;
            if (k == INT64_C(1))
            {
                away = separation__GAUSS_2;
                weight = separation__WEIGHT_2;
            }
            if (k == INT64_C(2))
            {
                away = separation__GAUSS_3;
                weight = separation__WEIGHT_3;
            }
            total += weight * separation__curve_speed(tables, work, tracer, middle + side * away);
        }
    }
    return half * total;
}

/* Arc length [m] of a curve from abscissa ``start`` to ``stop``, negative where that is the smaller one.
 *
 * Piece by piece: within one the curve has all derivatives, at the ends its curvature may jump.
 */
static OUT_OF_LINE double separation__arc_length(array_double_1d tables, array_double_1d work, int64_t tracer, double start, double stop)
{
    double low;
    double high;
    int64_t piece;
    double end;
    double total;
    low = start;
    high = stop;
    if (stop < start)
    {
        low = stop;
        high = start;
    }
    total = 0.0;
    piece = profile_table__find_piece(tables, separation__curve_profile(tables, tracer), low);
    while(low < high)
    {
        end = high;
        piece = piece + layout__PIECE_SIZE;
        if ((*cspan_at(&tables, piece + layout__PIECE_START)) < high)
        {
            end = (*cspan_at(&tables, piece + layout__PIECE_START));
        }
        total += separation__panel_length(tables, work, tracer, low, end);
        low = end;
    }
    if (stop < start)
    {
        total = -total;
    }
    return total;
}

/* ``u``, or the end of the profile that it lies beyond. */
static OUT_OF_LINE double separation__within(array_double_1d tables, int64_t tracer, double u)
{
    int64_t profile;
    profile = separation__curve_profile(tables, tracer);
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

/* Measure from the minimum at ``station`` with rail abscissa ``abscissa`` and wheel abscissa ``y`` [m]; chords, if any,
 * are as long as ``spacing`` [m], or arcs where that is 0.
 */
static OUT_OF_LINE int64_t separation__open_origin(array_double_1d tables, array_double_1d work, double station, double gap, double abscissa, double y, double spacing)
{
    if ((int64_t)((int64_t)((*cspan_at(&tables, layout__TABLES_SEPARATION)))) != layout__SEPARATION_NORMAL)
    {
        (*cspan_at(&work, layout__WORK_ORIGIN + layout__ORIGIN_STATION)) = station;
        (*cspan_at(&work, layout__WORK_ORIGIN + layout__ORIGIN_GAP)) = gap;
        (*cspan_at(&work, layout__WORK_ORIGIN + layout__ORIGIN_SPACING)) = 0.0;
        if ((int64_t)((int64_t)((*cspan_at(&tables, layout__TABLES_SEPARATION)))) == layout__SEPARATION_EQUIDISTANT_CHORD)
        {
            (*cspan_at(&work, layout__WORK_ORIGIN + layout__ORIGIN_SPACING)) = spacing;
        }
        separation__open_curve(tables, work, contact_plane__TRACER_RAIL, separation__AT_RAIL_ORIGIN, abscissa);
        separation__open_curve(tables, work, contact_plane__TRACER_WHEEL, separation__AT_WHEEL_ORIGIN, y);
    }
    return INT64_C(0);
}

/* Let the curve's origin, at ``origin`` in the workspace, be its point at abscissa ``u`` [m]. */
static OUT_OF_LINE int64_t separation__open_curve(array_double_1d tables, array_double_1d work, int64_t tracer, int64_t origin, double u)
{
    double across;
    double down;
    double slope;
    double stretch;
    double bend;
    (*cspan_at(&work, origin)) = 0.0;
    (*cspan_at(&work, origin + INT64_C(1))) = 0.0;
    separation__curve_jet(&across, &down, &slope, &stretch, &bend, tables, work, tracer, u);
    (*cspan_at(&work, origin)) = across;
    (*cspan_at(&work, origin + INT64_C(1))) = down;
    return INT64_C(0);
}

/* Move a curve's abscissa by ``length`` [m] of arc, by Newton's method; 1 if the curve is that long, else 0. */
static OUT_OF_LINE int64_t separation__move_arc(array_double_1d tables, array_double_1d work, int64_t tracer, double length)
{
    double u;
    double rest;
    int64_t i;
    double speed;
    double following;
    u = (*cspan_at(&work, tracer));
    rest = length;
    for (i = INT64_C(0); i < separation__ITERATIONS; i += INT64_C(1))
    {
        if (fabs(rest) < separation__SHARP)
        {
            (*cspan_at(&work, tracer)) = u;
            return INT64_C(1);
        }
        speed = separation__curve_speed(tables, work, tracer, u);
        if (!(speed > 0.0))
        {
            return INT64_C(0);
        }
        following = separation__within(tables, tracer, u + rest / speed);
        if (following == u)
        {
            return INT64_C(0);
        }
        rest -= separation__arc_length(tables, work, tracer, u, following);
        u = following;
    }
    return INT64_C(0);
}

/* Move a curve's abscissa to where a circle of radius abs(``chord``) [m] around the point cuts the curve, forward where
 * ``chord`` is positive; 1 if it does, else 0.
 */
static OUT_OF_LINE int64_t separation__move_chord(array_double_1d tables, array_double_1d work, int64_t tracer, double chord)
{
    double from_across;
    double from_down;
    double slope;
    double stretch;
    double bend;
    double u;
    int64_t i;
    double across;
    double down;
    double length;
    double along;
    double following;
    separation__curve_jet(&from_across, &from_down, &slope, &stretch, &bend, tables, work, tracer, (*cspan_at(&work, tracer)));
    if (!(stretch > 0.0))
    {
        return INT64_C(0);
    }
    u = separation__within(tables, tracer, (*cspan_at(&work, tracer)) + chord / (stretch * sqrt(1.0 + slope * slope)));
    for (i = INT64_C(0); i < separation__ITERATIONS; i += INT64_C(1))
    {
        separation__curve_jet(&across, &down, &slope, &stretch, &bend, tables, work, tracer, u);
        across -= from_across;
        down -= from_down;
        length = sqrt(across * across + down * down);
        if (fabs(length - fabs(chord)) < separation__SHARP)
        {
            (*cspan_at(&work, tracer)) = u;
            return INT64_C(1);
        }
        along = (across + slope * down) * stretch;
        if (!(along * chord > 0.0))
        {
            return INT64_C(0);
        }
        following = separation__within(tables, tracer, u - (length - fabs(chord)) * length / along);
        if (following == u)
        {
            return INT64_C(0);
        }
        u = following;
    }
    return INT64_C(0);
}

/* Move a curve's abscissa from the tracer's station to ``station`` [m], by arc or by chords; 1 if there is one. */
static OUT_OF_LINE int64_t separation__move_station(array_double_1d tables, array_double_1d work, int64_t tracer, double station)
{
    double way;
    double spacing;
    double chord;
    int64_t i;
    int64_t exists;
    way = station - (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_STATION));
    spacing = (*cspan_at(&work, layout__WORK_ORIGIN + layout__ORIGIN_SPACING));
    exists = INT64_C(1);
    if (spacing == 0.0)
    {
        exists = separation__move_arc(tables, work, tracer, way);
    }
    else
    {
        chord = spacing;
        if (way < 0.0)
        {
            chord = -spacing;
        }
        for (i = INT64_C(0); i < (int64_t)(fabs(way) / spacing + 0.5); i += INT64_C(1))
        {
            if (exists == INT64_C(1))
            {
                exists = separation__move_chord(tables, work, tracer, chord);
            }
        }
    }
    return exists;
}

/* Move the wheel's abscissa to where its outline is ``lateral`` [m] from the origin, by Newton's method; 1 if there is
 * such a place, else 0.
 */
static OUT_OF_LINE int64_t separation__move_across(array_double_1d tables, array_double_1d work, double lateral)
{
    double u;
    int64_t i;
    double across;
    double down;
    double slope;
    double stretch;
    double bend;
    double following;
    u = separation__within(tables, contact_plane__TRACER_WHEEL, (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_WHEEL)));
    for (i = INT64_C(0); i < separation__ITERATIONS; i += INT64_C(1))
    {
        separation__curve_jet(&across, &down, &slope, &stretch, &bend, tables, work, contact_plane__TRACER_WHEEL, u);
        if (!(stretch > 0.0))
        {
            return INT64_C(0);
        }
        if (fabs(across - lateral) < separation__SHARP)
        {
            (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_WHEEL)) = u;
            return INT64_C(1);
        }
        following = separation__within(tables, contact_plane__TRACER_WHEEL, u - (across - lateral) / stretch);
        if (following == u)
        {
            return INT64_C(0);
        }
        u = following;
    }
    return INT64_C(0);
}

/* Vertical distance at ``station`` [m], its rate [-] and bend [1/m] over the stations, and 1 if it exists. */
static OUT_OF_LINE int64_t separation__vertical_rise(double* result_0, double* result_1, double* result_2, int64_t* exists, array_double_1d tables, array_double_1d work, double station)
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
    per_station = (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_COS));
    lateral = (station - (*cspan_at(&work, layout__WORK_ORIGIN + layout__ORIGIN_STATION))) * per_station;
    (*exists) = separation__move_across(tables, work, lateral);
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_RAIL)) = (*cspan_at(&work, layout__WORK_ORIGIN + layout__ORIGIN_RAIL + INT64_C(0))) + lateral;
    if (separation__within(tables, contact_plane__TRACER_RAIL, (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_RAIL))) != (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_RAIL)))
    {
        (*exists) = INT64_C(0);
    }
    separation__curve_jet(&across, &rail_down, &rail_slope, &along, &rail_bend, tables, work, contact_plane__TRACER_RAIL, (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_RAIL)));
    separation__curve_jet(&across, &down, &slope, &stretch, &bend, tables, work, contact_plane__TRACER_WHEEL, (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_WHEEL)));
    bend = rail_bend - bend / stretch;
    (*result_0) = rail_down - down;
    (*result_1) = (rail_slope - slope) * per_station;
    (*result_2) = bend * per_station * per_station;
    return 0;
}

/* Distance along the mean of the normals between the points at ``station`` [m] on both curves, signed, its rate [-] and
 * bend [1/m] over the stations, and 1 if it exists.
 *
 * With angles theta of the tangents and n = (sin, -cos) of their mean, d = (p_w - p_r) n and
 *
 *     dd/ds = (t_w - t_r) n + (p_w - p_r) t (theta_w' + theta_r') / 2
 *
 * of which the last term is of third order in s.
 */
static OUT_OF_LINE int64_t separation__equidistant_rise(double* result_0, double* rate, double* result_2, int64_t* exists, array_double_1d tables, array_double_1d work, double station)
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
    double rail_turn;
    double wheel_across;
    double wheel_down;
    double wheel_cos;
    double wheel_sin;
    double wheel_turn;
    double cosine;
    double sine;
    double size;
    on_rail = separation__move_station(tables, work, contact_plane__TRACER_RAIL, station);
    on_wheel = separation__move_station(tables, work, contact_plane__TRACER_WHEEL, station);
    separation__curve_jet(&across, &down, &slope, &stretch, &bend, tables, work, contact_plane__TRACER_RAIL, (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_RAIL)));
    rail_cos = 1.0 / sqrt(1.0 + slope * slope);
    rail_sin = slope * rail_cos;
    rail_turn = bend * rail_cos * rail_cos * rail_cos;
    separation__curve_jet(&wheel_across, &wheel_down, &slope, &stretch, &bend, tables, work, contact_plane__TRACER_WHEEL, (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_WHEEL)));
    wheel_cos = 1.0 / sqrt(1.0 + slope * slope);
    wheel_sin = slope * wheel_cos;
    wheel_turn = bend / stretch * wheel_cos * wheel_cos * wheel_cos;
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
    (*rate) += 0.5 * (across * cosine + down * sine) * (wheel_turn + rail_turn);
    (*result_0) = across * sine - down * cosine;
    (*result_2) = rail_turn - wheel_turn;
    return 0;
}

/* What a pressed wheel's depth lacks at the tracer's point, depth (1 - cos(angle between the normals)) [m], since it is
 * pressed along the region's normal; and its rate [-].
 */
static OUT_OF_LINE int64_t separation__lean_away(double* result_0, double* result_1, array_double_1d tables, array_double_1d work)
{
    double height;
    double slope;
    double bend;
    double cosine;
    double along;
    double across;
    profile_table__height_slope_bend(&height, &slope, &bend, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_RAIL)));
    cosine = 1.0 / sqrt(1.0 + slope * slope);
    along = cosine * ((*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_COS)) + slope * (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_SIN)));
    across = cosine * (slope * (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_COS)) - (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_SIN)));
    (*result_0) = (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_DEPTH)) * (1.0 - along);
    (*result_1) = (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_DEPTH)) * across * bend * cosine * cosine * cosine;
    return 0;
}

/* ``separation`` of any other kind than along the normal: with the wheel moved onto the rail at the region's minimum. */
static OUT_OF_LINE int64_t separation__moved_separation(double* gap, double* rate, double* bend, double* curvature, array_double_1d tables, array_double_1d work, array_double_1d state, double station, int64_t kind)
{
    int64_t exists;
    double lack;
    double more;
    double z;
    double slope;
    double wheel_bend;
    (*cspan_at(&state, layout__STATE_NODE_COUNT)) += 1.0;
    if (kind == layout__SEPARATION_VERTICAL)
    {
        separation__vertical_rise(gap, rate, bend, &exists, tables, work, station);
    }
    else
    {
        separation__equidistant_rise(gap, rate, bend, &exists, tables, work, station);
    }
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_STATION)) = station;
    (*gap) += (*cspan_at(&work, layout__WORK_ORIGIN + layout__ORIGIN_GAP));
    if (((*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_PRESSED)) == 1.0) && (kind != layout__SEPARATION_VERTICAL))
    {
        separation__lean_away(&lack, &more, tables, work);
        (*gap) += lack;
        (*rate) += more;
    }
    if (exists == INT64_C(0))
    {
        (*gap) = contact_plane__NO_GAP;
    }
    profile_table__height_slope_bend(&z, &slope, &wheel_bend, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL))), (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_WHEEL)));
    wheel_bend = pressed__mean_bend(tables, work, (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_WHEEL)), wheel_bend);
    (*curvature) = contact_plane__longitudinal_curvature(tables, work, (int64_t)((*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_PLACE))), z, slope, wheel_bend);
    return 0;
}

/* Undeformed distance g [m], dg/ds [-], d2g/ds2 [1/m] and the wheel's 1/R_x [1/m] at ``station`` [m], measured as chosen;
 * NO_GAP where a profile has ended.
 *
 * ``tolerance`` is that of :func:`normal_gap`; all else is met to SHARP.
 */
static inline int64_t separation__separation(double* gap, double* rate, double* bend, double* curvature, array_double_1d tables, array_double_1d work, array_double_1d state, double station, double tolerance)
{
    int64_t kind;
    kind = (int64_t)((int64_t)((*cspan_at(&tables, layout__TABLES_SEPARATION))));
    if ((kind == layout__SEPARATION_NORMAL) && (!((*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_PRESSED)) == 1.0)))
    {
        contact_plane__normal_gap(gap, rate, bend, curvature, tables, work, state, station, tolerance);
    }
    else if (kind == layout__SEPARATION_NORMAL)
    {
        pressed__pressed_gap(gap, rate, bend, curvature, tables, work, state, station);
    }
    else
    {
        separation__moved_separation(gap, rate, bend, curvature, tables, work, state, station, kind);
    }
    return 0;
}
