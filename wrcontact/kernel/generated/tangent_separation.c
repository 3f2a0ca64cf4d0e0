/* Generated from tangent_separation.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of separation.py.
 */

#include "tangent_separation.h"

/* Tangent of ``curve_jet``. */
static inline int64_t tangent_separation__curve_jet_t(double* across, double* across_t, double* down, double* down_t, double* slope, double* slope_t, double* stretch, double* stretch_t, double* bend, double* bend_t, array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t tracer, double u, double u_t)
{
    double z;
    double z_t;
    double y_track;
    double y_track_t;
    double z_track;
    double z_track_t;
    tangent_profile_table__height_slope_bend_t(&z, &z_t, slope, slope_t, bend, bend_t, tables, separation__curve_profile(tables, tracer), u, u_t);
    (*across_t) = u_t - (*cspan_at(&work_t, layout__WORK_ORIGIN + layout__ORIGIN_RAIL + INT64_C(0)));
    (*across) = u - (*cspan_at(&work, layout__WORK_ORIGIN + layout__ORIGIN_RAIL + INT64_C(0)));
    (*down_t) = z_t - (*cspan_at(&work_t, layout__WORK_ORIGIN + layout__ORIGIN_RAIL + INT64_C(1)));
    (*down) = z - (*cspan_at(&work, layout__WORK_ORIGIN + layout__ORIGIN_RAIL + INT64_C(1)));
    (*stretch_t) = 0.0;
    (*stretch) = 1.0;
    if (tracer == contact_plane__TRACER_WHEEL)
    {
        tangent_locus__outline_jet_t(&y_track, &y_track_t, &z_track, &z_track_t, slope, slope_t, stretch, stretch_t, bend, bend_t, work, work_t, (int64_t)((*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_PLACE))), u, u_t, z, z_t, (*slope), (*slope_t), (*bend), (*bend_t));
        (*across_t) = y_track_t - (*cspan_at(&work_t, layout__WORK_ORIGIN + layout__ORIGIN_WHEEL + INT64_C(0)));
        (*across) = y_track - (*cspan_at(&work, layout__WORK_ORIGIN + layout__ORIGIN_WHEEL + INT64_C(0)));
        (*down_t) = z_track_t - (*cspan_at(&work_t, layout__WORK_ORIGIN + layout__ORIGIN_WHEEL + INT64_C(1)));
        (*down) = z_track - (*cspan_at(&work, layout__WORK_ORIGIN + layout__ORIGIN_WHEEL + INT64_C(1)));
    }
    return 0;
}

/* Tangent of ``curve_speed``. */
static inline int64_t tangent_separation__curve_speed_t(double* speed, double* speed_t, array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t tracer, double u, double u_t)
{
    int64_t at;
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
    at = (int64_t)((*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_PLACE)));
    if ((tracer == contact_plane__TRACER_RAIL) || (!((*cspan_at(&work, at + layout__PLACE_YAWED)) == 1.0)))
    {
        tangent_profile_table__height_slope_t(&z, &z_t, &slope, &slope_t, tables, separation__curve_profile(tables, tracer), u, u_t);
        v1 = 1.0 + slope * slope;
        v2 = sqrt(v1);
        (*speed_t) = tangent_rates__root_rate(v2, slope_t * slope + slope * slope_t);
        (*speed) = v2;
    }
    else
    {
        tangent_separation__curve_jet_t(&across, &across_t, &down, &down_t, &slope, &slope_t, &stretch, &stretch_t, &bend, &bend_t, tables, work, work_t, tracer, u, u_t);
        v3 = 1.0 + slope * slope;
        v4 = sqrt(v3);
        (*speed_t) = stretch_t * v4 + stretch * tangent_rates__root_rate(v4, slope_t * slope + slope * slope_t);
        (*speed) = stretch * v4;
    }
    return 0;
}

/* Tangent of ``panel_length``. */
static inline int64_t tangent_separation__panel_length_t(double* result_0, double* result_1, array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t tracer, double low, double low_t, double high, double high_t)
{
    double v1;
    double middle_t;
    double middle;
    double v2;
    double half_t;
    double half;
    double total_t;
    double total;
    int64_t i;
    double v3;
    double side_t;
    double side;
    int64_t k;
    double away;
    double weight;
    double v4;
    double v4_t;
    v1 = low + high;
    middle_t = 0.5 * (low_t + high_t);
    middle = 0.5 * v1;
    v2 = high - low;
    half_t = 0.5 * (high_t - low_t);
    half = 0.5 * v2;
    total_t = 0.0;
    total = 0.0;
    for (i = -INT64_C(1); i < INT64_C(2); i += INT64_C(2))
    {
        v3 = (double)(i);
        side_t = half_t * v3;
        side = half * v3;
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
            tangent_separation__curve_speed_t(&v4, &v4_t, tables, work, work_t, tracer, middle + side * away, middle_t + side_t * away);
            total_t = total_t + weight * v4_t;
            total = total + weight * v4;
        }
    }
    (*result_0) = half * total;
    (*result_1) = half_t * total + half * total_t;
    return 0;
}

/* Tangent of ``arc_length``. */
static inline int64_t tangent_separation__arc_length_t(double* total, double* total_t, array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t tracer, double start, double start_t, double stop, double stop_t)
{
    double low_t;
    double low;
    double high_t;
    double high;
    int64_t piece;
    double end_t;
    double end;
    double v1;
    double v1_t;
    low_t = start_t;
    low = start;
    high_t = stop_t;
    high = stop;
    if (stop < start)
    {
        low_t = stop_t;
        low = stop;
        high_t = start_t;
        high = start;
    }
    (*total_t) = 0.0;
    (*total) = 0.0;
    piece = profile_table__find_piece(tables, separation__curve_profile(tables, tracer), low);
    while(low < high)
    {
        end_t = high_t;
        end = high;
        piece = piece + layout__PIECE_SIZE;
        if ((*cspan_at(&tables, piece + layout__PIECE_START)) < high)
        {
            end_t = 0.0;
            end = (*cspan_at(&tables, piece + layout__PIECE_START));
        }
        tangent_separation__panel_length_t(&v1, &v1_t, tables, work, work_t, tracer, low, low_t, end, end_t);
        (*total_t) = (*total_t) + v1_t;
        (*total) = (*total) + v1;
        low_t = end_t;
        low = end;
    }
    if (stop < start)
    {
        (*total_t) = -(*total_t);
        (*total) = -(*total);
    }
    return 0;
}

/* Tangent of ``within``. */
static inline int64_t tangent_separation__within_t(double* result_0, double* result_1, array_double_1d tables, int64_t tracer, double u, double u_t)
{
    int64_t profile;
    profile = separation__curve_profile(tables, tracer);
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
static inline int64_t tangent_separation__open_origin_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, double station, double station_t, double gap, double gap_t, double abscissa, double abscissa_t, double y, double y_t, double spacing, double spacing_t)
{
    if ((int64_t)((int64_t)((*cspan_at(&tables, layout__TABLES_SEPARATION)))) != layout__SEPARATION_NORMAL)
    {
        (*cspan_at(&work_t, layout__WORK_ORIGIN + layout__ORIGIN_STATION)) = station_t;
        (*cspan_at(&work, layout__WORK_ORIGIN + layout__ORIGIN_STATION)) = station;
        (*cspan_at(&work_t, layout__WORK_ORIGIN + layout__ORIGIN_GAP)) = gap_t;
        (*cspan_at(&work, layout__WORK_ORIGIN + layout__ORIGIN_GAP)) = gap;
        (*cspan_at(&work_t, layout__WORK_ORIGIN + layout__ORIGIN_SPACING)) = 0.0;
        (*cspan_at(&work, layout__WORK_ORIGIN + layout__ORIGIN_SPACING)) = 0.0;
        if ((int64_t)((int64_t)((*cspan_at(&tables, layout__TABLES_SEPARATION)))) == layout__SEPARATION_EQUIDISTANT_CHORD)
        {
            (*cspan_at(&work_t, layout__WORK_ORIGIN + layout__ORIGIN_SPACING)) = spacing_t;
            (*cspan_at(&work, layout__WORK_ORIGIN + layout__ORIGIN_SPACING)) = spacing;
        }
        tangent_separation__open_curve_t(tables, work, work_t, contact_plane__TRACER_RAIL, separation__AT_RAIL_ORIGIN, abscissa, abscissa_t);
        tangent_separation__open_curve_t(tables, work, work_t, contact_plane__TRACER_WHEEL, separation__AT_WHEEL_ORIGIN, y, y_t);
    }
    return INT64_C(0);
}

/* Tangent of ``open_curve``. */
static inline int64_t tangent_separation__open_curve_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t tracer, int64_t origin, double u, double u_t)
{
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
    (*cspan_at(&work_t, origin)) = 0.0;
    (*cspan_at(&work, origin)) = 0.0;
    (*cspan_at(&work_t, origin + INT64_C(1))) = 0.0;
    (*cspan_at(&work, origin + INT64_C(1))) = 0.0;
    tangent_separation__curve_jet_t(&across, &across_t, &down, &down_t, &slope, &slope_t, &stretch, &stretch_t, &bend, &bend_t, tables, work, work_t, tracer, u, u_t);
    (*cspan_at(&work_t, origin)) = across_t;
    (*cspan_at(&work, origin)) = across;
    (*cspan_at(&work_t, origin + INT64_C(1))) = down_t;
    (*cspan_at(&work, origin + INT64_C(1))) = down;
    return INT64_C(0);
}

/* Tangent of ``move_station``. */
static inline int64_t tangent_separation__move_station_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t tracer, double station, double station_t)
{
    double way_t;
    double way;
    double spacing_t;
    double spacing;
    int64_t n1;
    double chord_t;
    double chord;
    int64_t i;
    int64_t n2;
    int64_t exists;
    way_t = station_t - (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_TRACER_STATION));
    way = station - (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_STATION));
    spacing_t = (*cspan_at(&work_t, layout__WORK_ORIGIN + layout__ORIGIN_SPACING));
    spacing = (*cspan_at(&work, layout__WORK_ORIGIN + layout__ORIGIN_SPACING));
    exists = INT64_C(1);
    if (spacing == 0.0)
    {
        n1 = tangent_separation__arc_rule_t(tables, work, work_t, tracer, way, way_t);
        exists = n1;
    }
    else
    {
        chord_t = spacing_t;
        chord = spacing;
        if (way < 0.0)
        {
            chord_t = -spacing_t;
            chord = -spacing;
        }
        for (i = INT64_C(0); i < (int64_t)(fabs(way) / spacing + 0.5); i += INT64_C(1))
        {
            if (exists == INT64_C(1))
            {
                n2 = tangent_separation__chord_rule_t(tables, work, work_t, tracer, chord, chord_t);
                exists = n2;
            }
        }
    }
    return exists;
}

/* Tangent of ``vertical_rise``. */
static inline int64_t tangent_separation__vertical_rise_t(double* result_0, double* result_1, double* result_2, double* result_3, double* result_4, double* result_5, int64_t* exists, array_double_1d tables, array_double_1d work, array_double_1d work_t, double station, double station_t)
{
    double per_station_t;
    double per_station;
    double v1;
    double lateral_t;
    double lateral;
    int64_t n2;
    double across;
    double across_t;
    double rail_down;
    double rail_down_t;
    double rail_slope;
    double rail_slope_t;
    double along;
    double along_t;
    double rail_bend;
    double rail_bend_t;
    double down;
    double down_t;
    double slope;
    double slope_t;
    double stretch;
    double stretch_t;
    double bend;
    double bend_t;
    double v3;
    double v4;
    double v5;
    per_station_t = (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_COS));
    per_station = (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_COS));
    v1 = station - (*cspan_at(&work, layout__WORK_ORIGIN + layout__ORIGIN_STATION));
    lateral_t = (station_t - (*cspan_at(&work_t, layout__WORK_ORIGIN + layout__ORIGIN_STATION))) * per_station + v1 * per_station_t;
    lateral = v1 * per_station;
    n2 = tangent_separation__across_rule_t(tables, work, work_t, lateral, lateral_t);
    (*exists) = n2;
    (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_TRACER_RAIL)) = (*cspan_at(&work_t, layout__WORK_ORIGIN + layout__ORIGIN_RAIL + INT64_C(0))) + lateral_t;
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_RAIL)) = (*cspan_at(&work, layout__WORK_ORIGIN + layout__ORIGIN_RAIL + INT64_C(0))) + lateral;
    if (separation__within(tables, contact_plane__TRACER_RAIL, (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_RAIL))) != (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_RAIL)))
    {
        (*exists) = INT64_C(0);
    }
    tangent_separation__curve_jet_t(&across, &across_t, &rail_down, &rail_down_t, &rail_slope, &rail_slope_t, &along, &along_t, &rail_bend, &rail_bend_t, tables, work, work_t, contact_plane__TRACER_RAIL, (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_RAIL)), (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_TRACER_RAIL)));
    tangent_separation__curve_jet_t(&across, &across_t, &down, &down_t, &slope, &slope_t, &stretch, &stretch_t, &bend, &bend_t, tables, work, work_t, contact_plane__TRACER_WHEEL, (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_WHEEL)), (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_TRACER_WHEEL)));
    v3 = bend / stretch;
    bend_t = rail_bend_t - (bend_t - v3 * stretch_t) / stretch;
    bend = rail_bend - v3;
    v4 = rail_slope - slope;
    v5 = bend * per_station;
    (*result_0) = rail_down - down;
    (*result_1) = rail_down_t - down_t;
    (*result_2) = v4 * per_station;
    (*result_3) = (rail_slope_t - slope_t) * per_station + v4 * per_station_t;
    (*result_4) = v5 * per_station;
    (*result_5) = (bend_t * per_station + bend * per_station_t) * per_station + v5 * per_station_t;
    return 0;
}

/* Tangent of ``equidistant_rise``. */
static inline int64_t tangent_separation__equidistant_rise_t(double* result_0, double* result_1, double* rate, double* rate_t, double* result_4, double* result_5, int64_t* exists, array_double_1d tables, array_double_1d work, array_double_1d work_t, double station, double station_t)
{
    int64_t n1;
    int64_t on_rail;
    int64_t n2;
    int64_t on_wheel;
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
    double v3;
    double v4;
    double v5;
    double rail_cos_t;
    double rail_cos;
    double rail_sin_t;
    double rail_sin;
    double v6;
    double v7;
    double rail_turn_t;
    double rail_turn;
    double wheel_across;
    double wheel_across_t;
    double wheel_down;
    double wheel_down_t;
    double v8;
    double v9;
    double v10;
    double wheel_cos_t;
    double wheel_cos;
    double wheel_sin_t;
    double wheel_sin;
    double v11;
    double v12;
    double v13;
    double wheel_turn_t;
    double wheel_turn;
    double cosine_t;
    double cosine;
    double sine_t;
    double sine;
    double v14;
    double v15;
    double size_t;
    double size;
    double v16;
    double v17;
    double v18;
    double v19;
    double v20;
    double v21;
    double v22;
    n1 = tangent_separation__move_station_t(tables, work, work_t, contact_plane__TRACER_RAIL, station, station_t);
    on_rail = n1;
    n2 = tangent_separation__move_station_t(tables, work, work_t, contact_plane__TRACER_WHEEL, station, station_t);
    on_wheel = n2;
    tangent_separation__curve_jet_t(&across, &across_t, &down, &down_t, &slope, &slope_t, &stretch, &stretch_t, &bend, &bend_t, tables, work, work_t, contact_plane__TRACER_RAIL, (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_RAIL)), (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_TRACER_RAIL)));
    v3 = 1.0 + slope * slope;
    v4 = sqrt(v3);
    v5 = 1.0 / v4;
    rail_cos_t = (-v5) * tangent_rates__root_rate(v4, slope_t * slope + slope * slope_t) / v4;
    rail_cos = v5;
    rail_sin_t = slope_t * rail_cos + slope * rail_cos_t;
    rail_sin = slope * rail_cos;
    v6 = bend * rail_cos;
    v7 = v6 * rail_cos;
    rail_turn_t = ((bend_t * rail_cos + bend * rail_cos_t) * rail_cos + v6 * rail_cos_t) * rail_cos + v7 * rail_cos_t;
    rail_turn = v7 * rail_cos;
    tangent_separation__curve_jet_t(&wheel_across, &wheel_across_t, &wheel_down, &wheel_down_t, &slope, &slope_t, &stretch, &stretch_t, &bend, &bend_t, tables, work, work_t, contact_plane__TRACER_WHEEL, (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_WHEEL)), (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_TRACER_WHEEL)));
    v8 = 1.0 + slope * slope;
    v9 = sqrt(v8);
    v10 = 1.0 / v9;
    wheel_cos_t = (-v10) * tangent_rates__root_rate(v9, slope_t * slope + slope * slope_t) / v9;
    wheel_cos = v10;
    wheel_sin_t = slope_t * wheel_cos + slope * wheel_cos_t;
    wheel_sin = slope * wheel_cos;
    v11 = bend / stretch;
    v12 = v11 * wheel_cos;
    v13 = v12 * wheel_cos;
    wheel_turn_t = (((bend_t - v11 * stretch_t) / stretch * wheel_cos + v11 * wheel_cos_t) * wheel_cos + v12 * wheel_cos_t) * wheel_cos + v13 * wheel_cos_t;
    wheel_turn = v13 * wheel_cos;
    across_t = wheel_across_t - across_t;
    across = wheel_across - across;
    down_t = wheel_down_t - down_t;
    down = wheel_down - down;
    cosine_t = wheel_cos_t + rail_cos_t;
    cosine = wheel_cos + rail_cos;
    sine_t = wheel_sin_t + rail_sin_t;
    sine = wheel_sin + rail_sin;
    v14 = cosine * cosine + sine * sine;
    v15 = sqrt(v14);
    size_t = tangent_rates__root_rate(v15, cosine_t * cosine + cosine * cosine_t + (sine_t * sine + sine * sine_t));
    size = v15;
    v16 = cosine / size;
    cosine_t = (cosine_t - v16 * size_t) / size;
    cosine = v16;
    v17 = sine / size;
    sine_t = (sine_t - v17 * size_t) / size;
    sine = v17;
    (*exists) = INT64_C(0);
    if ((on_rail == INT64_C(1)) && (on_wheel == INT64_C(1)) && (stretch > 0.0))
    {
        (*exists) = INT64_C(1);
    }
    v18 = wheel_cos - rail_cos;
    v19 = wheel_sin - rail_sin;
    (*rate_t) = (wheel_cos_t - rail_cos_t) * sine + v18 * sine_t - ((wheel_sin_t - rail_sin_t) * cosine + v19 * cosine_t);
    (*rate) = v18 * sine - v19 * cosine;
    v20 = across * cosine + down * sine;
    v21 = 0.5 * v20;
    v22 = wheel_turn + rail_turn;
    (*rate_t) = (*rate_t) + (0.5 * (across_t * cosine + across * cosine_t + (down_t * sine + down * sine_t)) * v22 + v21 * (wheel_turn_t + rail_turn_t));
    (*rate) = (*rate) + v21 * v22;
    (*result_0) = across * sine - down * cosine;
    (*result_1) = across_t * sine + across * sine_t - (down_t * cosine + down * cosine_t);
    (*result_4) = rail_turn - wheel_turn;
    (*result_5) = rail_turn_t - wheel_turn_t;
    return 0;
}

/* Tangent of ``lean_away``. */
static inline int64_t tangent_separation__lean_away_t(double* result_0, double* result_1, double* result_2, double* result_3, array_double_1d tables, array_double_1d work, array_double_1d work_t)
{
    double height;
    double height_t;
    double slope;
    double slope_t;
    double bend;
    double bend_t;
    double v1;
    double v2;
    double v3;
    double cosine_t;
    double cosine;
    double v4;
    double along_t;
    double along;
    double v5;
    double across_t;
    double across;
    double v6;
    double v7;
    double v8;
    double v9;
    double v10;
    tangent_profile_table__height_slope_bend_t(&height, &height_t, &slope, &slope_t, &bend, &bend_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_RAIL)), (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_TRACER_RAIL)));
    v1 = 1.0 + slope * slope;
    v2 = sqrt(v1);
    v3 = 1.0 / v2;
    cosine_t = (-v3) * tangent_rates__root_rate(v2, slope_t * slope + slope * slope_t) / v2;
    cosine = v3;
    v4 = (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_COS)) + slope * (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_SIN));
    along_t = cosine_t * v4 + cosine * ((*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_COS)) + (slope_t * (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_SIN)) + slope * (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_SIN))));
    along = cosine * v4;
    v5 = slope * (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_COS)) - (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_SIN));
    across_t = cosine_t * v5 + cosine * (slope_t * (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_COS)) + slope * (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_COS)) - (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_SIN)));
    across = cosine * v5;
    v6 = 1.0 - along;
    v7 = (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_DEPTH)) * across;
    v8 = v7 * bend;
    v9 = v8 * cosine;
    v10 = v9 * cosine;
    (*result_0) = (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_DEPTH)) * v6;
    (*result_1) = (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_DEPTH)) * v6 + (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_DEPTH)) * (-along_t);
    (*result_2) = v10 * cosine;
    (*result_3) = (((((*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_DEPTH)) * across + (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_DEPTH)) * across_t) * bend + v7 * bend_t) * cosine + v8 * cosine_t) * cosine + v9 * cosine_t) * cosine + v10 * cosine_t;
    return 0;
}

/* Tangent of ``moved_separation``. */
static inline int64_t tangent_separation__moved_separation_t(double* gap, double* gap_t, double* rate, double* rate_t, double* bend, double* bend_t, double* curvature, double* curvature_t, array_double_1d tables, array_double_1d work, array_double_1d work_t, array_double_1d state, double station, double station_t, int64_t kind)
{
    int64_t exists;
    double lack;
    double lack_t;
    double more;
    double more_t;
    double z;
    double z_t;
    double slope;
    double slope_t;
    double wheel_bend;
    double wheel_bend_t;
    double v1;
    double v1_t;
    double v2;
    double v2_t;
    (*cspan_at(&state, layout__STATE_NODE_COUNT)) = (*cspan_at(&state, layout__STATE_NODE_COUNT)) + 1.0;
    if (kind == layout__SEPARATION_VERTICAL)
    {
        tangent_separation__vertical_rise_t(gap, gap_t, rate, rate_t, bend, bend_t, &exists, tables, work, work_t, station, station_t);
    }
    else
    {
        tangent_separation__equidistant_rise_t(gap, gap_t, rate, rate_t, bend, bend_t, &exists, tables, work, work_t, station, station_t);
    }
    (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_TRACER_STATION)) = station_t;
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_STATION)) = station;
    (*gap_t) = (*gap_t) + (*cspan_at(&work_t, layout__WORK_ORIGIN + layout__ORIGIN_GAP));
    (*gap) = (*gap) + (*cspan_at(&work, layout__WORK_ORIGIN + layout__ORIGIN_GAP));
    if (((*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_PRESSED)) == 1.0) && (kind != layout__SEPARATION_VERTICAL))
    {
        tangent_separation__lean_away_t(&lack, &lack_t, &more, &more_t, tables, work, work_t);
        (*gap_t) = (*gap_t) + lack_t;
        (*gap) = (*gap) + lack;
        (*rate_t) = (*rate_t) + more_t;
        (*rate) = (*rate) + more;
    }
    if (exists == INT64_C(0))
    {
        (*gap_t) = 0.0;
        (*gap) = contact_plane__NO_GAP;
    }
    tangent_profile_table__height_slope_bend_t(&z, &z_t, &slope, &slope_t, &wheel_bend, &wheel_bend_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL))), (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_WHEEL)), (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_TRACER_WHEEL)));
    tangent_pressed__mean_bend_t(&v1, &v1_t, tables, work, work_t, (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_WHEEL)), (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_TRACER_WHEEL)), wheel_bend, wheel_bend_t);
    wheel_bend_t = v1_t;
    wheel_bend = v1;
    tangent_contact_plane__longitudinal_curvature_t(&v2, &v2_t, tables, work, work_t, (int64_t)((*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_PLACE))), z, z_t, slope, slope_t, wheel_bend, wheel_bend_t);
    (*curvature_t) = v2_t;
    (*curvature) = v2;
    return 0;
}

/* Tangent of ``separation``. */
static inline int64_t tangent_separation__separation_t(double* gap, double* gap_t, double* rate, double* rate_t, double* bend, double* bend_t, double* curvature, double* curvature_t, array_double_1d tables, array_double_1d work, array_double_1d work_t, array_double_1d state, double station, double station_t, double tolerance, double tolerance_t)
{
    int64_t kind;
    kind = (int64_t)((int64_t)((*cspan_at(&tables, layout__TABLES_SEPARATION))));
    if ((kind == layout__SEPARATION_NORMAL) && (!((*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_PRESSED)) == 1.0)))
    {
        tangent_contact_plane__normal_gap_t(gap, gap_t, rate, rate_t, bend, bend_t, curvature, curvature_t, tables, work, work_t, state, station, station_t, tolerance, tolerance_t);
    }
    else if (kind == layout__SEPARATION_NORMAL)
    {
        tangent_pressed__pressed_gap_t(gap, gap_t, rate, rate_t, bend, bend_t, curvature, curvature_t, tables, work, work_t, state, station, station_t);
    }
    else
    {
        tangent_separation__moved_separation_t(gap, gap_t, rate, rate_t, bend, bend_t, curvature, curvature_t, tables, work, work_t, state, station, station_t, kind);
    }
    return 0;
}

/* Tangent of ``arc_rule``. */
static inline int64_t tangent_separation__arc_rule_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t tracer, double length, double length_t)
{
    double start_t;
    double start;
    int64_t n1;
    double u;
    double v2;
    double place_t;
    double place;
    double v3;
    double v3_t;
    double v4;
    int64_t exists;
    start_t = (*cspan_at(&work_t, tracer));
    start = (*cspan_at(&work, tracer));
    n1 = separation__move_arc(tables, work, tracer, length);
    exists = n1;
    if (exists == INT64_C(1))
    {
        u = (*cspan_at(&work, tracer));
        v2 = separation__curve_speed(tables, work, tracer, u);
        place_t = length_t / v2;
        place = length / v2;
        if (u == start)
        {
            place_t = start_t + place_t;
            place = start + place;
        }
        else
        {
            tangent_separation__arc_length_t(&v3, &v3_t, tables, work, work_t, tracer, start, start_t, u, 0.0);
            v4 = separation__curve_speed(tables, work, tracer, u);
            place_t = place_t - v3_t / v4;
            place = place - v3 / v4;
        }
        (*cspan_at(&work_t, tracer)) = place_t;
        (*cspan_at(&work, tracer)) = u;
    }
    return exists;
}

/* Tangent of ``chord_rule``. */
static inline int64_t tangent_separation__chord_rule_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t tracer, double chord, double chord_t)
{
    double from_across;
    double from_across_t;
    double from_down;
    double from_down_t;
    double slope;
    double slope_t;
    double stretch;
    double stretch_t;
    double bend;
    double bend_t;
    int64_t n1;
    double u;
    double across;
    double across_t;
    double down;
    double down_t;
    double v2;
    double v3;
    double length_t;
    double length;
    double v4;
    double along_t;
    double along;
    double v5;
    double v6;
    int64_t exists;
    tangent_separation__curve_jet_t(&from_across, &from_across_t, &from_down, &from_down_t, &slope, &slope_t, &stretch, &stretch_t, &bend, &bend_t, tables, work, work_t, tracer, (*cspan_at(&work, tracer)), (*cspan_at(&work_t, tracer)));
    n1 = separation__move_chord(tables, work, tracer, chord);
    exists = n1;
    if (exists == INT64_C(1))
    {
        u = (*cspan_at(&work, tracer));
        tangent_separation__curve_jet_t(&across, &across_t, &down, &down_t, &slope, &slope_t, &stretch, &stretch_t, &bend, &bend_t, tables, work, work_t, tracer, u, 0.0);
        across_t = across_t - from_across_t;
        across = across - from_across;
        down_t = down_t - from_down_t;
        down = down - from_down;
        v2 = across * across + down * down;
        v3 = sqrt(v2);
        length_t = tangent_rates__root_rate(v3, across_t * across + across * across_t + (down_t * down + down * down_t));
        length = v3;
        v4 = across + slope * down;
        along_t = (across_t + (slope_t * down + slope * down_t)) * stretch + v4 * stretch_t;
        along = v4 * stretch;
        v5 = -(length - fabs(chord));
        v6 = length / along;
        (*cspan_at(&work_t, tracer)) = (-(length_t - tangent_rates__size_rate(chord, chord_t))) * v6;
        (*cspan_at(&work, tracer)) = u;
    }
    return exists;
}

/* Tangent of ``across_rule``. */
static inline int64_t tangent_separation__across_rule_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, double lateral, double lateral_t)
{
    int64_t n1;
    double u;
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
    double v2;
    int64_t exists;
    n1 = separation__move_across(tables, work, lateral);
    exists = n1;
    if (exists == INT64_C(1))
    {
        u = (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_WHEEL));
        tangent_separation__curve_jet_t(&across, &across_t, &down, &down_t, &slope, &slope_t, &stretch, &stretch_t, &bend, &bend_t, tables, work, work_t, contact_plane__TRACER_WHEEL, u, 0.0);
        v2 = -(across - lateral);
        (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_TRACER_WHEEL)) = (-(across_t - lateral_t)) / stretch;
        (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_WHEEL)) = u;
    }
    return exists;
}
