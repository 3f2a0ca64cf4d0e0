/* Generated from tangent_traces.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of traces.py.
 */

#include "tangent_traces.h"

/* Tangent of ``start_traces``. */
static inline int64_t tangent_traces__start_traces_t(array_double_1d work, array_double_1d work_t, double station, double station_t, double abscissa, double abscissa_t, double y, double y_t)
{
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_STATION)) = station_t;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_STATION)) = station;
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__RAIL + layout__TRACE_ABSCISSA)) = abscissa_t;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__RAIL + layout__TRACE_ABSCISSA)) = abscissa;
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__RAIL + layout__TRACE_RATE)) = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS));
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__RAIL + layout__TRACE_RATE)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS));
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__RAIL + layout__TRACE_BEND)) = 0.0;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__RAIL + layout__TRACE_BEND)) = 0.0;
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__WHEEL + layout__TRACE_ABSCISSA)) = y_t;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__WHEEL + layout__TRACE_ABSCISSA)) = y;
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__WHEEL + layout__TRACE_RATE)) = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS));
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__WHEEL + layout__TRACE_RATE)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS));
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__WHEEL + layout__TRACE_BEND)) = 0.0;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__WHEEL + layout__TRACE_BEND)) = 0.0;
    return INT64_C(0);
}

/* Tangent of ``first_abscissa``. */
static inline int64_t tangent_traces__first_abscissa_t(double* u, double* u_t, array_double_1d work, array_double_1d work_t, int64_t trace, double away, double away_t)
{
    double v1;
    double v2;
    (*u_t) = (*cspan_at(&work_t, trace + layout__TRACE_ABSCISSA)) + (away_t * (*cspan_at(&work, trace + layout__TRACE_RATE)) + away * (*cspan_at(&work_t, trace + layout__TRACE_RATE)));
    (*u) = (*cspan_at(&work, trace + layout__TRACE_ABSCISSA)) + away * (*cspan_at(&work, trace + layout__TRACE_RATE));
    if (fabs(away) < traces__EXTRAPOLATED)
    {
        v1 = 0.5 * away;
        v2 = v1 * away;
        (*u_t) = (*u_t) + ((0.5 * away_t * away + v1 * away_t) * (*cspan_at(&work, trace + layout__TRACE_BEND)) + v2 * (*cspan_at(&work_t, trace + layout__TRACE_BEND)));
        (*u) = (*u) + v2 * (*cspan_at(&work, trace + layout__TRACE_BEND));
    }
    return 0;
}

/* Tangent of ``trace_profile``. */
static inline int64_t tangent_traces__trace_profile_t(double* result_0, double* result_1, double* result_2, double* result_3, double* ordinate_bend, double* ordinate_bend_t, double* result_6, double* result_7, double* result_8, double* result_9, int64_t* exists, array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t profile, int64_t point, int64_t plane, int64_t trace, double station, double station_t, double tolerance, double tolerance_t)
{
    double v1;
    double v1_t;
    double u_t;
    double u;
    double excess_t;
    double excess;
    double forward_t;
    double forward;
    double height_t;
    double height;
    double slope_t;
    double slope;
    double bend_t;
    double bend;
    int64_t i;
    double v2;
    double v3;
    double v4;
    double v5;
    double along_t;
    double along;
    double v6;
    double rate_t;
    double rate;
    double v7;
    double v8;
    double v9;
    double v10;
    double v11;
    double ordinate_t;
    double ordinate;
    double v12;
    double move_t;
    double move;
    double v13;
    double v14;
    tangent_traces__first_abscissa_t(&v1, &v1_t, work, work_t, trace, station - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_STATION)), station_t - (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_STATION)));
    u_t = v1_t;
    u = v1;
    (*exists) = INT64_C(0);
    excess_t = 0.0;
    excess = 0.0;
    forward_t = 0.0;
    forward = 1.0;
    height_t = 0.0;
    height = 0.0;
    slope_t = 0.0;
    slope = 0.0;
    bend_t = 0.0;
    bend = 0.0;
    for (i = INT64_C(0); i < traces__TRACE_ITERATIONS; i += INT64_C(1))
    {
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
        tangent_profile_table__height_slope_bend_t(&height, &height_t, &slope, &slope_t, &bend, &bend_t, tables, profile, u, u_t);
        forward_t = (*cspan_at(&work_t, plane + layout__DIRECTION_COS)) + (slope_t * (*cspan_at(&work, plane + layout__DIRECTION_SIN)) + slope * (*cspan_at(&work_t, plane + layout__DIRECTION_SIN)));
        forward = (*cspan_at(&work, plane + layout__DIRECTION_COS)) + slope * (*cspan_at(&work, plane + layout__DIRECTION_SIN));
        v2 = u - (*cspan_at(&work, point + layout__POINT_Y));
        v3 = height - (*cspan_at(&work, point + layout__POINT_Z));
        excess_t = (u_t - (*cspan_at(&work_t, point + layout__POINT_Y))) * (*cspan_at(&work, plane + layout__DIRECTION_COS)) + v2 * (*cspan_at(&work_t, plane + layout__DIRECTION_COS)) + ((height_t - (*cspan_at(&work_t, point + layout__POINT_Z))) * (*cspan_at(&work, plane + layout__DIRECTION_SIN)) + v3 * (*cspan_at(&work_t, plane + layout__DIRECTION_SIN))) - station_t;
        excess = v2 * (*cspan_at(&work, plane + layout__DIRECTION_COS)) + v3 * (*cspan_at(&work, plane + layout__DIRECTION_SIN)) - station;
        if (fabs(excess) < tolerance)
        {
            if (forward > 0.0)
            {
                (*exists) = INT64_C(1);
            }
            break;
        }
        v4 = excess / forward;
        u_t = u_t - (excess_t - v4 * forward_t) / forward;
        u = u - v4;
    }
    v5 = 1.0 / forward;
    along_t = (-v5) * forward_t / forward;
    along = v5;
    v6 = (*cspan_at(&work, plane + layout__DIRECTION_SIN)) - slope * (*cspan_at(&work, plane + layout__DIRECTION_COS));
    rate_t = ((*cspan_at(&work_t, plane + layout__DIRECTION_SIN)) - (slope_t * (*cspan_at(&work, plane + layout__DIRECTION_COS)) + slope * (*cspan_at(&work_t, plane + layout__DIRECTION_COS)))) * along + v6 * along_t;
    rate = v6 * along;
    v7 = -bend;
    v8 = v7 * along;
    v9 = v8 * along;
    (*ordinate_bend_t) = (((-bend_t) * along + v7 * along_t) * along + v8 * along_t) * along + v9 * along_t;
    (*ordinate_bend) = v9 * along;
    (*cspan_at(&work_t, trace + layout__TRACE_ABSCISSA)) = u_t - (excess_t * along + excess * along_t);
    (*cspan_at(&work, trace + layout__TRACE_ABSCISSA)) = u - excess * along;
    (*cspan_at(&work_t, trace + layout__TRACE_RATE)) = along_t;
    (*cspan_at(&work, trace + layout__TRACE_RATE)) = along;
    (*cspan_at(&work_t, trace + layout__TRACE_BEND)) = (*ordinate_bend_t) * (*cspan_at(&work, plane + layout__DIRECTION_SIN)) + (*ordinate_bend) * (*cspan_at(&work_t, plane + layout__DIRECTION_SIN));
    (*cspan_at(&work, trace + layout__TRACE_BEND)) = (*ordinate_bend) * (*cspan_at(&work, plane + layout__DIRECTION_SIN));
    v10 = u - (*cspan_at(&work, point + layout__POINT_Y));
    v11 = height - (*cspan_at(&work, point + layout__POINT_Z));
    ordinate_t = (u_t - (*cspan_at(&work_t, point + layout__POINT_Y))) * (*cspan_at(&work, plane + layout__DIRECTION_SIN)) + v10 * (*cspan_at(&work_t, plane + layout__DIRECTION_SIN)) - ((height_t - (*cspan_at(&work_t, point + layout__POINT_Z))) * (*cspan_at(&work, plane + layout__DIRECTION_COS)) + v11 * (*cspan_at(&work_t, plane + layout__DIRECTION_COS)));
    ordinate = v10 * (*cspan_at(&work, plane + layout__DIRECTION_SIN)) - v11 * (*cspan_at(&work, plane + layout__DIRECTION_COS));
    v12 = -excess;
    move_t = (-excess_t) * along + v12 * along_t;
    move = v12 * along;
    v13 = 0.5 * excess;
    v14 = rate - v13 * (*ordinate_bend);
    (*result_0) = ordinate - excess * v14;
    (*result_1) = ordinate_t - (excess_t * v14 + excess * (rate_t - (0.5 * excess_t * (*ordinate_bend) + v13 * (*ordinate_bend_t))));
    (*result_2) = rate - excess * (*ordinate_bend);
    (*result_3) = rate_t - (excess_t * (*ordinate_bend) + excess * (*ordinate_bend_t));
    (*result_6) = slope + move * bend;
    (*result_7) = slope_t + (move_t * bend + move * bend_t);
    (*result_8) = height + move * slope;
    (*result_9) = height_t + (move_t * slope + move * slope_t);
    return 0;
}

/* Tangent of ``trace_rail``. */
static inline int64_t tangent_traces__trace_rail_t(double* ordinate, double* ordinate_t, double* rate, double* rate_t, double* bend, double* bend_t, int64_t* exists, array_double_1d work, array_double_1d work_t, array_double_1d tables, double station, double station_t, double tolerance, double tolerance_t)
{
    double slope;
    double slope_t;
    double height;
    double height_t;
    tangent_traces__trace_profile_t(ordinate, ordinate_t, rate, rate_t, bend, bend_t, &slope, &slope_t, &height, &height_t, exists, tables, work, work_t, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAIL, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__RAIL, station, station_t, tolerance, tolerance_t);
    return 0;
}

/* Tangent of ``trace_wheel``. */
static inline int64_t tangent_traces__trace_wheel_t(double* ordinate, double* ordinate_t, double* rate, double* rate_t, double* bend, double* bend_t, double* curvature, double* curvature_t, int64_t* exists, array_double_1d work, array_double_1d work_t, array_double_1d tables, double station, double station_t, double tolerance, double tolerance_t)
{
    int64_t place;
    double lifted_t;
    double lifted;
    double slope;
    double slope_t;
    double z;
    double z_t;
    double v1;
    double v1_t;
    place = layout__WORK_CONTACT + layout__CONTACT_FRAME + (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLACE)));
    if (!((*cspan_at(&work, place + layout__PLACE_YAWED)) == 1.0))
    {
        lifted_t = station_t - ((*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_LIFT)) * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_SIN)) + (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_LIFT)) * (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_SIN)));
        lifted = station - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_LIFT)) * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_SIN));
        tangent_traces__trace_profile_t(ordinate, ordinate_t, rate, rate_t, bend, bend_t, &slope, &slope_t, &z, &z_t, exists, tables, work, work_t, (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL))), layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_WHEEL, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_WHEEL_PLANE, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__WHEEL, lifted, lifted_t, tolerance, tolerance_t);
        (*ordinate_t) = (*ordinate_t) - ((*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_LIFT)) * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS)) + (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_LIFT)) * (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS)));
        (*ordinate) = (*ordinate) - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_LIFT)) * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS));
        tangent_longitudinal_curvature__longitudinal_curvature_t(&v1, &v1_t, work, work_t, tables, place, z, z_t, slope, slope_t, (*bend), (*bend_t));
        (*curvature_t) = v1_t;
        (*curvature) = v1;
    }
    else
    {
        tangent_traces__trace_outline_t(ordinate, ordinate_t, rate, rate_t, bend, bend_t, curvature, curvature_t, exists, work, work_t, tables, station, station_t, tolerance, tolerance_t);
    }
    return 0;
}

/* Tangent of ``trace_outline``. */
static inline int64_t tangent_traces__trace_outline_t(double* ordinate, double* ordinate_t, double* result_2, double* result_3, double* ordinate_bend, double* ordinate_bend_t, double* curvature, double* curvature_t, int64_t* exists, array_double_1d work, array_double_1d work_t, array_double_1d tables, double station, double station_t, double tolerance, double tolerance_t)
{
    int64_t wheel;
    int64_t place;
    int64_t trace;
    double cosine_t;
    double cosine;
    double sine_t;
    double sine;
    double left_t;
    double left;
    double above_t;
    double above;
    double v1;
    double v1_t;
    double y_t;
    double y;
    double excess_t;
    double excess;
    double along_t;
    double along;
    double across_t;
    double across;
    double up_t;
    double up;
    double stretch_t;
    double stretch;
    double z_t;
    double z;
    double slope_t;
    double slope;
    double bend_t;
    double bend;
    double outline_slope_t;
    double outline_slope;
    double outline_rate_t;
    double outline_rate;
    int64_t i;
    double y_track;
    double y_track_t;
    double z_track;
    double z_track_t;
    double v2;
    double v3;
    double v4;
    double per_along_t;
    double per_along;
    double v5;
    double per_stretch_t;
    double per_stretch;
    double v6;
    double rate_t;
    double rate;
    double v7;
    double v8;
    double v9;
    double v10;
    double v11;
    double v12;
    double move_t;
    double move;
    double v13;
    double v14;
    double v14_t;
    double v15;
    double v16;
    wheel = (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL)));
    place = layout__WORK_CONTACT + layout__CONTACT_FRAME + (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLACE)));
    trace = layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__WHEEL;
    cosine_t = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS));
    cosine = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS));
    sine_t = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_SIN));
    sine = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_SIN));
    left_t = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAIL + layout__POINT_Y)) - (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_ASIDE));
    left = (*cspan_at(&tables, layout__TABLES_RAIL_Y)) + (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAIL + layout__POINT_Y)) - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_ASIDE));
    above_t = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_SHIFT)) - (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAIL + layout__POINT_Z));
    above = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_SHIFT)) - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAIL + layout__POINT_Z));
    tangent_traces__first_abscissa_t(&v1, &v1_t, work, work_t, trace, station - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_STATION)), station_t - (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_STATION)));
    y_t = v1_t;
    y = v1;
    (*exists) = INT64_C(0);
    excess_t = 0.0;
    excess = 0.0;
    along_t = 0.0;
    along = 1.0;
    across_t = 0.0;
    across = 0.0;
    up_t = 0.0;
    up = 0.0;
    stretch_t = 0.0;
    stretch = 1.0;
    z_t = 0.0;
    z = 0.0;
    slope_t = 0.0;
    slope = 0.0;
    bend_t = 0.0;
    bend = 0.0;
    outline_slope_t = 0.0;
    outline_slope = 0.0;
    outline_rate_t = 0.0;
    outline_rate = 0.0;
    for (i = INT64_C(0); i < traces__TRACE_ITERATIONS; i += INT64_C(1))
    {
        if (y < (*cspan_at(&tables, wheel + layout__PROFILE_START)))
        {
            y_t = 0.0;
            y = (*cspan_at(&tables, wheel + layout__PROFILE_START));
        }
        if (y > (*cspan_at(&tables, wheel + layout__PROFILE_STOP)))
        {
            y_t = 0.0;
            y = (*cspan_at(&tables, wheel + layout__PROFILE_STOP));
        }
        tangent_profile_table__height_slope_bend_t(&z, &z_t, &slope, &slope_t, &bend, &bend_t, tables, wheel, y, y_t);
        tangent_locus__outline_jet_t(&y_track, &y_track_t, &z_track, &z_track_t, &outline_slope, &outline_slope_t, &stretch, &stretch_t, &outline_rate, &outline_rate_t, work, work_t, place, y, y_t, z, z_t, slope, slope_t, bend, bend_t);
        across_t = y_track_t - left_t;
        across = y_track - left;
        up_t = z_track_t + above_t;
        up = z_track + above;
        along_t = cosine_t + (outline_slope_t * sine + outline_slope * sine_t);
        along = cosine + outline_slope * sine;
        excess_t = across_t * cosine + across * cosine_t + (up_t * sine + up * sine_t) - station_t;
        excess = across * cosine + up * sine - station;
        if (fabs(excess) < tolerance)
        {
            if (stretch * along > 0.0)
            {
                (*exists) = INT64_C(1);
            }
            break;
        }
        v2 = stretch * along;
        v3 = excess / v2;
        y_t = y_t - (excess_t - v3 * (stretch_t * along + stretch * along_t)) / v2;
        y = y - v3;
    }
    v4 = 1.0 / along;
    per_along_t = (-v4) * along_t / along;
    per_along = v4;
    v5 = 1.0 / stretch;
    per_stretch_t = (-v5) * stretch_t / stretch;
    per_stretch = v5;
    v6 = sine - outline_slope * cosine;
    rate_t = (sine_t - (outline_slope_t * cosine + outline_slope * cosine_t)) * per_along + v6 * per_along_t;
    rate = v6 * per_along;
    v7 = -outline_rate;
    v8 = v7 * per_stretch;
    v9 = v8 * per_along;
    v10 = v9 * per_along;
    (*ordinate_bend_t) = ((((-outline_rate_t) * per_stretch + v7 * per_stretch_t) * per_along + v8 * per_along_t) * per_along + v9 * per_along_t) * per_along + v10 * per_along_t;
    (*ordinate_bend) = v10 * per_along;
    v11 = -excess;
    v12 = v11 * per_along;
    move_t = ((-excess_t) * per_along + v11 * per_along_t) * per_stretch + v12 * per_stretch_t;
    move = v12 * per_stretch;
    (*cspan_at(&work_t, trace + layout__TRACE_ABSCISSA)) = y_t + move_t;
    (*cspan_at(&work, trace + layout__TRACE_ABSCISSA)) = y + move;
    (*cspan_at(&work_t, trace + layout__TRACE_RATE)) = per_along_t * per_stretch + per_along * per_stretch_t;
    (*cspan_at(&work, trace + layout__TRACE_RATE)) = per_along * per_stretch;
    v13 = (*ordinate_bend) * sine;
    (*cspan_at(&work_t, trace + layout__TRACE_BEND)) = ((*ordinate_bend_t) * sine + (*ordinate_bend) * sine_t) * per_stretch + v13 * per_stretch_t;
    (*cspan_at(&work, trace + layout__TRACE_BEND)) = v13 * per_stretch;
    tangent_longitudinal_curvature__longitudinal_curvature_t(&v14, &v14_t, work, work_t, tables, place, z + move * slope, z_t + (move_t * slope + move * slope_t), slope + move * bend, slope_t + (move_t * bend + move * bend_t), bend, bend_t);
    (*curvature_t) = v14_t;
    (*curvature) = v14;
    v15 = 0.5 * excess;
    v16 = rate - v15 * (*ordinate_bend);
    (*ordinate_t) = across_t * sine + across * sine_t - (up_t * cosine + up * cosine_t) - (excess_t * v16 + excess * (rate_t - (0.5 * excess_t * (*ordinate_bend) + v15 * (*ordinate_bend_t))));
    (*ordinate) = across * sine - up * cosine - excess * v16;
    (*result_2) = rate - excess * (*ordinate_bend);
    (*result_3) = rate_t - (excess_t * (*ordinate_bend) + excess * (*ordinate_bend_t));
    return 0;
}
