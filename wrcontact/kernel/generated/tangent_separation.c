/* Generated from tangent_separation.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of separation.py.
 */

#include "tangent_separation.h"

/* Tangent of ``vertical_rise``. */
static inline int64_t tangent_separation__vertical_rise_t(double* result_0, double* result_1, double* result_2, double* result_3, double* result_4, double* result_5, int64_t* exists, array_double_1d work, array_double_1d work_t, array_double_1d tables, double station, double station_t)
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
    per_station_t = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS));
    per_station = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS));
    v1 = station - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_ORIGIN + layout__ORIGIN_STATION));
    lateral_t = (station_t - (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_ORIGIN + layout__ORIGIN_STATION))) * per_station + v1 * per_station_t;
    lateral = v1 * per_station;
    n2 = tangent_moves__across_rule_t(work, work_t, tables, lateral, lateral_t);
    (*exists) = n2;
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__RAIL + layout__TRACE_ABSCISSA)) = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_ORIGIN + layout__ORIGIN_POINTS + layout__POINT_SIZE * layout__RAIL + layout__POINT_Y)) + lateral_t;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__RAIL + layout__TRACE_ABSCISSA)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_ORIGIN + layout__ORIGIN_POINTS + layout__POINT_SIZE * layout__RAIL + layout__POINT_Y)) + lateral;
    if (curves__within(tables, layout__RAIL, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__RAIL + layout__TRACE_ABSCISSA))) != (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__RAIL + layout__TRACE_ABSCISSA)))
    {
        (*exists) = INT64_C(0);
    }
    tangent_curves__curve_jet_t(&across, &across_t, &rail_down, &rail_down_t, &rail_slope, &rail_slope_t, &along, &along_t, &rail_bend, &rail_bend_t, work, work_t, tables, layout__RAIL, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__RAIL + layout__TRACE_ABSCISSA)), (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__RAIL + layout__TRACE_ABSCISSA)));
    tangent_curves__curve_jet_t(&across, &across_t, &down, &down_t, &slope, &slope_t, &stretch, &stretch_t, &bend, &bend_t, work, work_t, tables, layout__WHEEL, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__WHEEL + layout__TRACE_ABSCISSA)), (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__WHEEL + layout__TRACE_ABSCISSA)));
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
static inline int64_t tangent_separation__equidistant_rise_t(double* result_0, double* result_1, double* rate, double* rate_t, double* result_4, double* result_5, int64_t* exists, array_double_1d work, array_double_1d work_t, array_double_1d tables, double station, double station_t)
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
    double rail_curvature_t;
    double rail_curvature;
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
    double wheel_curvature_t;
    double wheel_curvature;
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
    n1 = tangent_moves__move_to_station_t(work, work_t, tables, layout__RAIL, station, station_t);
    on_rail = n1;
    n2 = tangent_moves__move_to_station_t(work, work_t, tables, layout__WHEEL, station, station_t);
    on_wheel = n2;
    tangent_curves__curve_jet_t(&across, &across_t, &down, &down_t, &slope, &slope_t, &stretch, &stretch_t, &bend, &bend_t, work, work_t, tables, layout__RAIL, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__RAIL + layout__TRACE_ABSCISSA)), (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__RAIL + layout__TRACE_ABSCISSA)));
    v3 = 1.0 + slope * slope;
    v4 = sqrt(v3);
    v5 = 1.0 / v4;
    rail_cos_t = (-v5) * tangent_rates__root_rate(v4, slope_t * slope + slope * slope_t) / v4;
    rail_cos = v5;
    rail_sin_t = slope_t * rail_cos + slope * rail_cos_t;
    rail_sin = slope * rail_cos;
    v6 = bend * rail_cos;
    v7 = v6 * rail_cos;
    rail_curvature_t = ((bend_t * rail_cos + bend * rail_cos_t) * rail_cos + v6 * rail_cos_t) * rail_cos + v7 * rail_cos_t;
    rail_curvature = v7 * rail_cos;
    tangent_curves__curve_jet_t(&wheel_across, &wheel_across_t, &wheel_down, &wheel_down_t, &slope, &slope_t, &stretch, &stretch_t, &bend, &bend_t, work, work_t, tables, layout__WHEEL, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__WHEEL + layout__TRACE_ABSCISSA)), (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__WHEEL + layout__TRACE_ABSCISSA)));
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
    wheel_curvature_t = (((bend_t - v11 * stretch_t) / stretch * wheel_cos + v11 * wheel_cos_t) * wheel_cos + v12 * wheel_cos_t) * wheel_cos + v13 * wheel_cos_t;
    wheel_curvature = v13 * wheel_cos;
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
    v22 = wheel_curvature + rail_curvature;
    (*rate_t) = (*rate_t) + (0.5 * (across_t * cosine + across * cosine_t + (down_t * sine + down * sine_t)) * v22 + v21 * (wheel_curvature_t + rail_curvature_t));
    (*rate) = (*rate) + v21 * v22;
    (*result_0) = across * sine - down * cosine;
    (*result_1) = across_t * sine + across * sine_t - (down_t * cosine + down * cosine_t);
    (*result_4) = rail_curvature - wheel_curvature;
    (*result_5) = rail_curvature_t - wheel_curvature_t;
    return 0;
}

/* Tangent of ``depth_lost``. */
static inline int64_t tangent_separation__depth_lost_t(double* result_0, double* result_1, double* result_2, double* result_3, array_double_1d work, array_double_1d work_t, array_double_1d tables)
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
    tangent_profile_table__height_slope_bend_t(&height, &height_t, &slope, &slope_t, &bend, &bend_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__RAIL + layout__TRACE_ABSCISSA)), (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__RAIL + layout__TRACE_ABSCISSA)));
    v1 = 1.0 + slope * slope;
    v2 = sqrt(v1);
    v3 = 1.0 / v2;
    cosine_t = (-v3) * tangent_rates__root_rate(v2, slope_t * slope + slope * slope_t) / v2;
    cosine = v3;
    v4 = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS)) + slope * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_SIN));
    along_t = cosine_t * v4 + cosine * ((*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS)) + (slope_t * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_SIN)) + slope * (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_SIN))));
    along = cosine * v4;
    v5 = slope * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS)) - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_SIN));
    across_t = cosine_t * v5 + cosine * (slope_t * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS)) + slope * (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS)) - (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_SIN)));
    across = cosine * v5;
    v6 = 1.0 - along;
    v7 = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_DEPTH)) * across;
    v8 = v7 * bend;
    v9 = v8 * cosine;
    v10 = v9 * cosine;
    (*result_0) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_DEPTH)) * v6;
    (*result_1) = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_DEPTH)) * v6 + (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_DEPTH)) * (-along_t);
    (*result_2) = v10 * cosine;
    (*result_3) = (((((*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_DEPTH)) * across + (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_DEPTH)) * across_t) * bend + v7 * bend_t) * cosine + v8 * cosine_t) * cosine + v9 * cosine_t) * cosine + v10 * cosine_t;
    return 0;
}

/* Tangent of ``moved_separation``. */
static inline int64_t tangent_separation__moved_separation_t(double* gap, double* gap_t, double* rate, double* rate_t, double* bend, double* bend_t, double* curvature, double* curvature_t, array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, double station, double station_t, int64_t kind)
{
    int64_t exists;
    double lost;
    double lost_t;
    double more;
    double more_t;
    double y_t;
    double y;
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
        tangent_separation__vertical_rise_t(gap, gap_t, rate, rate_t, bend, bend_t, &exists, work, work_t, tables, station, station_t);
    }
    else
    {
        tangent_separation__equidistant_rise_t(gap, gap_t, rate, rate_t, bend, bend_t, &exists, work, work_t, tables, station, station_t);
    }
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_STATION)) = station_t;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_STATION)) = station;
    (*gap_t) = (*gap_t) + (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_ORIGIN + layout__ORIGIN_GAP));
    (*gap) = (*gap) + (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_ORIGIN + layout__ORIGIN_GAP));
    if (((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PRESSED)) == 1.0) && (kind != layout__SEPARATION_VERTICAL))
    {
        tangent_separation__depth_lost_t(&lost, &lost_t, &more, &more_t, work, work_t, tables);
        (*gap_t) = (*gap_t) + lost_t;
        (*gap) = (*gap) + lost;
        (*rate_t) = (*rate_t) + more_t;
        (*rate) = (*rate) + more;
    }
    if (exists == INT64_C(0))
    {
        (*gap_t) = 0.0;
        (*gap) = contact_plane__NO_GAP;
    }
    y_t = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__WHEEL + layout__TRACE_ABSCISSA));
    y = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__WHEEL + layout__TRACE_ABSCISSA));
    tangent_profile_table__height_slope_bend_t(&z, &z_t, &slope, &slope_t, &wheel_bend, &wheel_bend_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL))), y, y_t);
    tangent_pressed__mean_bend_t(&v1, &v1_t, work, work_t, tables, y, y_t, wheel_bend, wheel_bend_t);
    wheel_bend_t = v1_t;
    wheel_bend = v1;
    tangent_longitudinal_curvature__longitudinal_curvature_t(&v2, &v2_t, work, work_t, tables, layout__WORK_CONTACT + layout__CONTACT_FRAME + (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLACE))), z, z_t, slope, slope_t, wheel_bend, wheel_bend_t);
    (*curvature_t) = v2_t;
    (*curvature) = v2;
    return 0;
}

/* Tangent of ``separation``. */
static inline int64_t tangent_separation__separation_t(double* gap, double* gap_t, double* rate, double* rate_t, double* bend, double* bend_t, double* curvature, double* curvature_t, array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, double station, double station_t, double tolerance, double tolerance_t)
{
    int64_t kind;
    kind = (int64_t)((*cspan_at(&tables, layout__TABLES_SEPARATION)));
    if ((kind == layout__SEPARATION_NORMAL) && (!((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PRESSED)) == 1.0)))
    {
        tangent_contact_plane__normal_gap_t(gap, gap_t, rate, rate_t, bend, bend_t, curvature, curvature_t, work, work_t, tables, state, station, station_t, tolerance, tolerance_t);
    }
    else if (kind == layout__SEPARATION_NORMAL)
    {
        tangent_pressed__pressed_gap_t(gap, gap_t, rate, rate_t, bend, bend_t, curvature, curvature_t, work, work_t, tables, state, station, station_t);
    }
    else
    {
        tangent_separation__moved_separation_t(gap, gap_t, rate, rate_t, bend, bend_t, curvature, curvature_t, work, work_t, tables, state, station, station_t, kind);
    }
    return 0;
}
