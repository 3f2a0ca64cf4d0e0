/* Generated from tangent_contact_plane.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of contact_plane.py.
 */

#include "tangent_contact_plane.h"

/* Tangent of ``open_frame``. */
static inline int64_t tangent_contact_plane__open_frame_t(double* z, double* z_t, double* slope, double* slope_t, double* y_track, double* y_track_t, double* rail_slope, double* rail_slope_t, double* mismatch, double* mismatch_t, array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t at, double y, double y_t, double aside, double aside_t, double shift, double shift_t)
{
    double bend;
    double bend_t;
    double z_track;
    double z_track_t;
    double outline_slope;
    double outline_slope_t;
    double stretch;
    double stretch_t;
    double outline_rate;
    double outline_rate_t;
    double abscissa_t;
    double abscissa;
    double height;
    double height_t;
    double rail_bend;
    double rail_bend_t;
    double v1;
    double v2;
    double v3;
    double cosine_t;
    double cosine;
    double sine_t;
    double sine;
    tangent_profile_table__height_slope_bend_t(z, z_t, slope, slope_t, &bend, &bend_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL))), y, y_t);
    tangent_locus__outline_jet_t(y_track, y_track_t, &z_track, &z_track_t, &outline_slope, &outline_slope_t, &stretch, &stretch_t, &outline_rate, &outline_rate_t, work, work_t, at, y, y_t, (*z), (*z_t), (*slope), (*slope_t), bend, bend_t);
    (*y_track_t) = (*y_track_t) + aside_t;
    (*y_track) = (*y_track) + aside;
    abscissa_t = (*y_track_t);
    abscissa = (*y_track) - (*cspan_at(&tables, layout__TABLES_RAIL_Y));
    tangent_profile_table__height_slope_bend_t(&height, &height_t, rail_slope, rail_slope_t, &rail_bend, &rail_bend_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), abscissa, abscissa_t);
    v1 = 1.0 + (*rail_slope) * (*rail_slope);
    v2 = sqrt(v1);
    v3 = 1.0 / v2;
    cosine_t = (-v3) * tangent_rates__root_rate(v2, (*rail_slope_t) * (*rail_slope) + (*rail_slope) * (*rail_slope_t)) / v2;
    cosine = v3;
    sine_t = (*rail_slope_t) * cosine + (*rail_slope) * cosine_t;
    sine = (*rail_slope) * cosine;
    (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_ABSCISSA)) = abscissa_t;
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_ABSCISSA)) = abscissa;
    (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_HEIGHT)) = height_t;
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_HEIGHT)) = height;
    (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_Y)) = y_t;
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_Y)) = y;
    (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_COS)) = cosine_t;
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_COS)) = cosine;
    (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_SIN)) = sine_t;
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_SIN)) = sine;
    (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_SHIFT)) = shift_t;
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_SHIFT)) = shift;
    (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_PLACE)) = 0.0;
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_PLACE)) = (double)(at);
    (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_Z)) = (*z_t);
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_Z)) = (*z);
    (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_WHEEL_COS)) = (*cspan_at(&work_t, at + layout__PLACE_COS_ROLL)) * cosine + (*cspan_at(&work, at + layout__PLACE_COS_ROLL)) * cosine_t + ((*cspan_at(&work_t, at + layout__PLACE_SIN_ROLL)) * sine + (*cspan_at(&work, at + layout__PLACE_SIN_ROLL)) * sine_t);
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_WHEEL_COS)) = (*cspan_at(&work, at + layout__PLACE_COS_ROLL)) * cosine + (*cspan_at(&work, at + layout__PLACE_SIN_ROLL)) * sine;
    (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_WHEEL_SIN)) = (*cspan_at(&work_t, at + layout__PLACE_COS_ROLL)) * sine + (*cspan_at(&work, at + layout__PLACE_COS_ROLL)) * sine_t - ((*cspan_at(&work_t, at + layout__PLACE_SIN_ROLL)) * cosine + (*cspan_at(&work, at + layout__PLACE_SIN_ROLL)) * cosine_t);
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_WHEEL_SIN)) = (*cspan_at(&work, at + layout__PLACE_COS_ROLL)) * sine - (*cspan_at(&work, at + layout__PLACE_SIN_ROLL)) * cosine;
    (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_LIFT)) = z_track_t + shift_t - height_t;
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_LIFT)) = z_track + shift - height;
    (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_ASIDE)) = aside_t;
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_ASIDE)) = aside;
    (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_RAISED)) = 0.0;
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_RAISED)) = 0.0;
    (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_POSE)) = shift_t;
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_POSE)) = shift;
    (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_DEPTH)) = 0.0;
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_DEPTH)) = 0.0;
    (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_PRESSED)) = 0.0;
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_PRESSED)) = (double)(0);
    (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_BLUR)) = 0.0;
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_BLUR)) = 0.0;
    tangent_contact_plane__start_tracer_t(work, work_t, 0.0, 0.0, abscissa, abscissa_t, y, y_t);
    (*mismatch_t) = (*rail_slope_t) - outline_slope_t;
    (*mismatch) = (*rail_slope) - outline_slope;
    if (!(stretch > 0.0))
    {
        (*mismatch_t) = 0.0;
        (*mismatch) = gap__FOLDED;
    }
    return 0;
}

/* Tangent of ``start_tracer``. */
static inline int64_t tangent_contact_plane__start_tracer_t(array_double_1d work, array_double_1d work_t, double station, double station_t, double abscissa, double abscissa_t, double y, double y_t)
{
    (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_TRACER_STATION)) = station_t;
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_STATION)) = station;
    (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_TRACER_RAIL)) = abscissa_t;
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_RAIL)) = abscissa;
    (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_TRACER_RAIL_RATE)) = (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_COS));
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_RAIL_RATE)) = (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_COS));
    (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_TRACER_RAIL_BEND)) = 0.0;
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_RAIL_BEND)) = 0.0;
    (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_TRACER_WHEEL)) = y_t;
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_WHEEL)) = y;
    (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_TRACER_WHEEL_RATE)) = (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_COS));
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_WHEEL_RATE)) = (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_COS));
    (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_TRACER_WHEEL_BEND)) = 0.0;
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_WHEEL_BEND)) = 0.0;
    return INT64_C(0);
}

/* Tangent of ``longitudinal_curvature``. */
static inline int64_t tangent_contact_plane__longitudinal_curvature_t(double* curvature, double* curvature_t, array_double_1d tables, array_double_1d place, array_double_1d place_t, int64_t at, double z, double z_t, double slope, double slope_t, double bend, double bend_t)
{
    double r_t;
    double r;
    double v1;
    double v2;
    double v3;
    double v4;
    double v5;
    double sin_phi;
    double sin_phi_t;
    double cos_phi;
    double cos_phi_t;
    double e1_t;
    double e1;
    double e2_t;
    double e2;
    double e3_t;
    double e3;
    double around_t;
    double around;
    double v6;
    double v7;
    double steep_t;
    double steep;
    double v8;
    double v9;
    double v10;
    double v11;
    double v12;
    double v13;
    double v14;
    r_t = (*cspan_at(&place_t, at + layout__PLACE_RADIUS)) + z_t;
    r = (*cspan_at(&place, at + layout__PLACE_RADIUS)) + z;
    v1 = 1.0 / r;
    (*curvature_t) = (-v1) * r_t / r;
    (*curvature) = v1;
    if ((int64_t)((int64_t)((*cspan_at(&tables, layout__TABLES_LONGITUDINAL)))) == layout__LONGITUDINAL_BASIC)
    {
        return 0;
    }
    if (!((*cspan_at(&place, at + layout__PLACE_YAWED)) == 1.0))
    {
        v2 = 1.0 + slope * slope;
        v3 = sqrt(v2);
        v4 = r * v3;
        v5 = 1.0 / v4;
        (*curvature_t) = (-v5) * (r_t * v3 + r * tangent_rates__root_rate(v3, slope_t * slope + slope * slope_t)) / v4;
        (*curvature) = v5;
    }
    else
    {
        tangent_locus__around_wheel_t(&sin_phi, &sin_phi_t, &cos_phi, &cos_phi_t, place, place_t, at, slope, slope_t);
        e1_t = (*cspan_at(&place_t, at + layout__PLACE_COS_YAW));
        e1 = (*cspan_at(&place, at + layout__PLACE_COS_YAW));
        e2_t = (*cspan_at(&place_t, at + layout__PLACE_SIN_YAW)) * (*cspan_at(&place, at + layout__PLACE_COS_ROLL)) + (*cspan_at(&place, at + layout__PLACE_SIN_YAW)) * (*cspan_at(&place_t, at + layout__PLACE_COS_ROLL));
        e2 = (*cspan_at(&place, at + layout__PLACE_SIN_YAW)) * (*cspan_at(&place, at + layout__PLACE_COS_ROLL));
        e3_t = (*cspan_at(&place_t, at + layout__PLACE_SIN_YAW)) * (*cspan_at(&place, at + layout__PLACE_SIN_ROLL)) + (*cspan_at(&place, at + layout__PLACE_SIN_YAW)) * (*cspan_at(&place_t, at + layout__PLACE_SIN_ROLL));
        e3 = (*cspan_at(&place, at + layout__PLACE_SIN_YAW)) * (*cspan_at(&place, at + layout__PLACE_SIN_ROLL));
        around_t = e1_t * cos_phi + e1 * cos_phi_t - (e3_t * sin_phi + e3 * sin_phi_t);
        around = e1 * cos_phi - e3 * sin_phi;
        v6 = 1.0 + slope * slope;
        v7 = sqrt(v6);
        steep_t = tangent_rates__root_rate(v7, slope_t * slope + slope * slope_t);
        steep = v7;
        v8 = around * around;
        v9 = v8 / r;
        v10 = bend * e2;
        v11 = v9 - v10 * e2;
        v12 = v11 / steep;
        (*curvature_t) = ((around_t * around + around * around_t - v9 * r_t) / r - ((bend_t * e2 + bend * e2_t) * e2 + v10 * e2_t) - v12 * steep_t) / steep;
        (*curvature) = v12;
        if ((*curvature) < contact_plane__CURVATURE_FLOOR / (r * steep))
        {
            v13 = r * steep;
            v14 = contact_plane__CURVATURE_FLOOR / v13;
            (*curvature_t) = (-v14) * (r_t * steep + r * steep_t) / v13;
            (*curvature) = v14;
        }
    }
    return 0;
}

/* Tangent of ``first_abscissa``. */
static inline int64_t tangent_contact_plane__first_abscissa_t(double* u, double* u_t, array_double_1d work, array_double_1d work_t, int64_t tracer, double away, double away_t)
{
    double v1;
    double v2;
    (*u_t) = (*cspan_at(&work_t, tracer)) + (away_t * (*cspan_at(&work, tracer + INT64_C(1))) + away * (*cspan_at(&work_t, tracer + INT64_C(1))));
    (*u) = (*cspan_at(&work, tracer)) + away * (*cspan_at(&work, tracer + INT64_C(1)));
    if (fabs(away) < contact_plane__NEAR)
    {
        v1 = 0.5 * away;
        v2 = v1 * away;
        (*u_t) = (*u_t) + ((0.5 * away_t * away + v1 * away_t) * (*cspan_at(&work, tracer + INT64_C(2))) + v2 * (*cspan_at(&work_t, tracer + INT64_C(2))));
        (*u) = (*u) + v2 * (*cspan_at(&work, tracer + INT64_C(2)));
    }
    return 0;
}

/* Tangent of ``trace_profile``. */
static inline int64_t tangent_contact_plane__trace_profile_t(double* result_0, double* result_1, double* result_2, double* result_3, double* turn, double* turn_t, double* slope, double* slope_t, double* height, double* height_t, int64_t* exists, array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t profile, int64_t tracer, int64_t frame, double station, double station_t, double tolerance, double tolerance_t, double origin, double origin_t, double height_there, double height_there_t)
{
    double cosine_t;
    double cosine;
    double sine_t;
    double sine;
    double start;
    double stop;
    double v1;
    double v1_t;
    double u_t;
    double u;
    double offset_t;
    double offset;
    double forward_t;
    double forward;
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
    double v13;
    cosine_t = (*cspan_at(&work_t, frame));
    cosine = (*cspan_at(&work, frame));
    sine_t = (*cspan_at(&work_t, frame + INT64_C(1)));
    sine = (*cspan_at(&work, frame + INT64_C(1)));
    start = (*cspan_at(&tables, profile + layout__PROFILE_START));
    stop = (*cspan_at(&tables, profile + layout__PROFILE_STOP));
    tangent_contact_plane__first_abscissa_t(&v1, &v1_t, work, work_t, tracer, station - (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_STATION)), station_t - (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_TRACER_STATION)));
    u_t = v1_t;
    u = v1;
    (*exists) = INT64_C(0);
    offset_t = 0.0;
    offset = 0.0;
    forward_t = 0.0;
    forward = 1.0;
    (*height_t) = 0.0;
    (*height) = 0.0;
    (*slope_t) = 0.0;
    (*slope) = 0.0;
    bend_t = 0.0;
    bend = 0.0;
    for (i = INT64_C(0); i < contact_plane__TRACE_ITERATIONS; i += INT64_C(1))
    {
        if (u < start)
        {
            u_t = 0.0;
            u = start;
        }
        if (u > stop)
        {
            u_t = 0.0;
            u = stop;
        }
        tangent_profile_table__height_slope_bend_t(height, height_t, slope, slope_t, &bend, &bend_t, tables, profile, u, u_t);
        forward_t = cosine_t + ((*slope_t) * sine + (*slope) * sine_t);
        forward = cosine + (*slope) * sine;
        v2 = u - origin;
        v3 = (*height) - height_there;
        offset_t = (u_t - origin_t) * cosine + v2 * cosine_t + (((*height_t) - height_there_t) * sine + v3 * sine_t) - station_t;
        offset = v2 * cosine + v3 * sine - station;
        if (fabs(offset) < tolerance)
        {
            if (forward > 0.0)
            {
                (*exists) = INT64_C(1);
            }
            break;
        }
        v4 = offset / forward;
        u_t = u_t - (offset_t - v4 * forward_t) / forward;
        u = u - v4;
    }
    v5 = 1.0 / forward;
    along_t = (-v5) * forward_t / forward;
    along = v5;
    v6 = sine - (*slope) * cosine;
    rate_t = (sine_t - ((*slope_t) * cosine + (*slope) * cosine_t)) * along + v6 * along_t;
    rate = v6 * along;
    v7 = -bend;
    v8 = v7 * along;
    v9 = v8 * along;
    (*turn_t) = (((-bend_t) * along + v7 * along_t) * along + v8 * along_t) * along + v9 * along_t;
    (*turn) = v9 * along;
    (*cspan_at(&work_t, tracer)) = u_t - (offset_t * along + offset * along_t);
    (*cspan_at(&work, tracer)) = u - offset * along;
    (*cspan_at(&work_t, tracer + INT64_C(1))) = along_t;
    (*cspan_at(&work, tracer + INT64_C(1))) = along;
    (*cspan_at(&work_t, tracer + INT64_C(2))) = (*turn_t) * sine + (*turn) * sine_t;
    (*cspan_at(&work, tracer + INT64_C(2))) = (*turn) * sine;
    v10 = u - origin;
    v11 = (*height) - height_there;
    ordinate_t = (u_t - origin_t) * sine + v10 * sine_t - (((*height_t) - height_there_t) * cosine + v11 * cosine_t);
    ordinate = v10 * sine - v11 * cosine;
    v12 = 0.5 * offset;
    v13 = rate - v12 * (*turn);
    (*result_0) = ordinate - offset * v13;
    (*result_1) = ordinate_t - (offset_t * v13 + offset * (rate_t - (0.5 * offset_t * (*turn) + v12 * (*turn_t))));
    (*result_2) = rate - offset * (*turn);
    (*result_3) = rate_t - (offset_t * (*turn) + offset * (*turn_t));
    return 0;
}

/* Tangent of ``trace_rail``. */
static inline int64_t tangent_contact_plane__trace_rail_t(double* ordinate, double* ordinate_t, double* rate, double* rate_t, double* bend, double* bend_t, int64_t* exists, array_double_1d tables, array_double_1d work, array_double_1d work_t, double station, double station_t, double tolerance, double tolerance_t)
{
    double slope;
    double slope_t;
    double height;
    double height_t;
    tangent_contact_plane__trace_profile_t(ordinate, ordinate_t, rate, rate_t, bend, bend_t, &slope, &slope_t, &height, &height_t, exists, tables, work, work_t, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), contact_plane__TRACER_RAIL, contact_plane__AT_PLANE, station, station_t, tolerance, tolerance_t, (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_ABSCISSA)), (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_ABSCISSA)), (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_HEIGHT)), (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_HEIGHT)));
    return 0;
}

/* Tangent of ``trace_wheel``. */
static inline int64_t tangent_contact_plane__trace_wheel_t(double* ordinate, double* ordinate_t, double* rate, double* rate_t, double* bend, double* bend_t, double* curvature, double* curvature_t, int64_t* exists, array_double_1d tables, array_double_1d work, array_double_1d work_t, double station, double station_t, double tolerance, double tolerance_t)
{
    int64_t at;
    double lift_t;
    double lift;
    double slope;
    double slope_t;
    double z;
    double z_t;
    double v1;
    double v1_t;
    at = (int64_t)((*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_PLACE)));
    if (!((*cspan_at(&work, at + layout__PLACE_YAWED)) == 1.0))
    {
        lift_t = (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_LIFT));
        lift = (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_LIFT));
        tangent_contact_plane__trace_profile_t(ordinate, ordinate_t, rate, rate_t, bend, bend_t, &slope, &slope_t, &z, &z_t, exists, tables, work, work_t, (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL))), contact_plane__TRACER_WHEEL, contact_plane__AT_WHEEL_PLANE, station - lift * (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_SIN)), station_t - (lift_t * (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_SIN)) + lift * (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_SIN))), tolerance, tolerance_t, (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_Y)), (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_Y)), (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_Z)), (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_Z)));
        (*ordinate_t) = (*ordinate_t) - (lift_t * (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_COS)) + lift * (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_COS)));
        (*ordinate) = (*ordinate) - lift * (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_COS));
        tangent_contact_plane__longitudinal_curvature_t(&v1, &v1_t, tables, work, work_t, at, z, z_t, slope, slope_t, (*bend), (*bend_t));
        (*curvature_t) = v1_t;
        (*curvature) = v1;
    }
    else
    {
        tangent_contact_plane__trace_outline_t(ordinate, ordinate_t, rate, rate_t, bend, bend_t, curvature, curvature_t, exists, tables, work, work_t, at, station, station_t, tolerance, tolerance_t);
    }
    return 0;
}

/* Tangent of ``trace_outline``. */
static inline int64_t tangent_contact_plane__trace_outline_t(double* result_0, double* result_1, double* result_2, double* result_3, double* turn, double* turn_t, double* curvature, double* curvature_t, int64_t* exists, array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t at, double station, double station_t, double tolerance, double tolerance_t)
{
    int64_t wheel;
    double cosine_t;
    double cosine;
    double sine_t;
    double sine;
    double start;
    double stop;
    double left_t;
    double left;
    double above_t;
    double above;
    double v1;
    double v1_t;
    double y_t;
    double y;
    double offset_t;
    double offset;
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
    double v13;
    double v13_t;
    double v14;
    double v15;
    wheel = (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL)));
    cosine_t = (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_COS));
    cosine = (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_COS));
    sine_t = (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_SIN));
    sine = (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_SIN));
    start = (*cspan_at(&tables, wheel + layout__PROFILE_START));
    stop = (*cspan_at(&tables, wheel + layout__PROFILE_STOP));
    left_t = (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_ABSCISSA)) - (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_ASIDE));
    left = (*cspan_at(&tables, layout__TABLES_RAIL_Y)) + (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_ABSCISSA)) - (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_ASIDE));
    above_t = (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_SHIFT)) - (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_HEIGHT));
    above = (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_SHIFT)) - (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_HEIGHT));
    tangent_contact_plane__first_abscissa_t(&v1, &v1_t, work, work_t, contact_plane__TRACER_WHEEL, station - (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_STATION)), station_t - (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_TRACER_STATION)));
    y_t = v1_t;
    y = v1;
    (*exists) = INT64_C(0);
    offset_t = 0.0;
    offset = 0.0;
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
    for (i = INT64_C(0); i < contact_plane__TRACE_ITERATIONS; i += INT64_C(1))
    {
        if (y < start)
        {
            y_t = 0.0;
            y = start;
        }
        if (y > stop)
        {
            y_t = 0.0;
            y = stop;
        }
        tangent_profile_table__height_slope_bend_t(&z, &z_t, &slope, &slope_t, &bend, &bend_t, tables, wheel, y, y_t);
        tangent_locus__outline_jet_t(&y_track, &y_track_t, &z_track, &z_track_t, &outline_slope, &outline_slope_t, &stretch, &stretch_t, &outline_rate, &outline_rate_t, work, work_t, at, y, y_t, z, z_t, slope, slope_t, bend, bend_t);
        across_t = y_track_t - left_t;
        across = y_track - left;
        up_t = z_track_t + above_t;
        up = z_track + above;
        along_t = cosine_t + (outline_slope_t * sine + outline_slope * sine_t);
        along = cosine + outline_slope * sine;
        offset_t = across_t * cosine + across * cosine_t + (up_t * sine + up * sine_t) - station_t;
        offset = across * cosine + up * sine - station;
        if (fabs(offset) < tolerance)
        {
            if (stretch * along > 0.0)
            {
                (*exists) = INT64_C(1);
            }
            break;
        }
        v2 = stretch * along;
        v3 = offset / v2;
        y_t = y_t - (offset_t - v3 * (stretch_t * along + stretch * along_t)) / v2;
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
    (*turn_t) = ((((-outline_rate_t) * per_stretch + v7 * per_stretch_t) * per_along + v8 * per_along_t) * per_along + v9 * per_along_t) * per_along + v10 * per_along_t;
    (*turn) = v10 * per_along;
    v11 = offset * per_along;
    (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_TRACER_WHEEL)) = y_t - ((offset_t * per_along + offset * per_along_t) * per_stretch + v11 * per_stretch_t);
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_WHEEL)) = y - v11 * per_stretch;
    (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_TRACER_WHEEL_RATE)) = per_along_t * per_stretch + per_along * per_stretch_t;
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_WHEEL_RATE)) = per_along * per_stretch;
    v12 = (*turn) * sine;
    (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_TRACER_WHEEL_BEND)) = ((*turn_t) * sine + (*turn) * sine_t) * per_stretch + v12 * per_stretch_t;
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_WHEEL_BEND)) = v12 * per_stretch;
    tangent_contact_plane__longitudinal_curvature_t(&v13, &v13_t, tables, work, work_t, at, z, z_t, slope, slope_t, bend, bend_t);
    (*curvature_t) = v13_t;
    (*curvature) = v13;
    v14 = 0.5 * offset;
    v15 = rate - v14 * (*turn);
    (*result_0) = across * sine - up * cosine - offset * v15;
    (*result_1) = across_t * sine + across * sine_t - (up_t * cosine + up * cosine_t) - (offset_t * v15 + offset * (rate_t - (0.5 * offset_t * (*turn) + v14 * (*turn_t))));
    (*result_2) = rate - offset * (*turn);
    (*result_3) = rate_t - (offset_t * (*turn) + offset * (*turn_t));
    return 0;
}

/* Tangent of ``normal_gap``. */
static inline int64_t tangent_contact_plane__normal_gap_t(double* gap, double* gap_t, double* result_2, double* result_3, double* result_4, double* result_5, double* curvature, double* curvature_t, array_double_1d tables, array_double_1d work, array_double_1d work_t, array_double_1d state, double station, double station_t, double tolerance, double tolerance_t)
{
    double rail_height;
    double rail_height_t;
    double rail_rate;
    double rail_rate_t;
    double rail_bend;
    double rail_bend_t;
    int64_t on_rail;
    double wheel_height;
    double wheel_height_t;
    double wheel_rate;
    double wheel_rate_t;
    double wheel_bend;
    double wheel_bend_t;
    int64_t on_wheel;
    (*cspan_at(&state, layout__STATE_NODE_COUNT)) = (*cspan_at(&state, layout__STATE_NODE_COUNT)) + 1.0;
    tangent_contact_plane__trace_rail_t(&rail_height, &rail_height_t, &rail_rate, &rail_rate_t, &rail_bend, &rail_bend_t, &on_rail, tables, work, work_t, station, station_t, tolerance, tolerance_t);
    tangent_contact_plane__trace_wheel_t(&wheel_height, &wheel_height_t, &wheel_rate, &wheel_rate_t, &wheel_bend, &wheel_bend_t, curvature, curvature_t, &on_wheel, tables, work, work_t, station, station_t, tolerance, tolerance_t);
    (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_TRACER_STATION)) = station_t;
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_STATION)) = station;
    (*gap_t) = wheel_height_t - rail_height_t + (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_RAISED));
    (*gap) = wheel_height - rail_height + (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_RAISED));
    if ((on_rail == INT64_C(0)) || (on_wheel == INT64_C(0)))
    {
        (*gap_t) = 0.0;
        (*gap) = contact_plane__NO_GAP;
    }
    (*result_2) = wheel_rate - rail_rate;
    (*result_3) = wheel_rate_t - rail_rate_t;
    (*result_4) = wheel_bend - rail_bend;
    (*result_5) = wheel_bend_t - rail_bend_t;
    return 0;
}

/* Tangent of ``ridge_place``. */
static inline int64_t tangent_contact_plane__ridge_place_t(double* result_0, double* result_1, array_double_1d tables, array_double_1d work, array_double_1d work_t, double y, double y_t)
{
    int64_t at;
    double z;
    double z_t;
    double slope;
    double slope_t;
    double sin_phi;
    double sin_phi_t;
    double cos_phi;
    double cos_phi_t;
    double r_t;
    double r;
    double v1;
    double v2;
    double lateral_t;
    double lateral;
    double v3;
    at = (int64_t)((*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_PLACE)));
    tangent_profile_table__height_slope_t(&z, &z_t, &slope, &slope_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL))), y, y_t);
    tangent_locus__around_wheel_t(&sin_phi, &sin_phi_t, &cos_phi, &cos_phi_t, work, work_t, at, slope, slope_t);
    r_t = (*cspan_at(&work_t, at + layout__PLACE_RADIUS)) + z_t;
    r = (*cspan_at(&work, at + layout__PLACE_RADIUS)) + z;
    v1 = (*cspan_at(&work, at + layout__PLACE_ARM)) + y;
    v2 = r * cos_phi;
    lateral_t = ((*cspan_at(&work_t, at + layout__PLACE_ARM)) + y_t) * (*cspan_at(&work, at + layout__PLACE_COS_ROLL)) + v1 * (*cspan_at(&work_t, at + layout__PLACE_COS_ROLL)) - ((r_t * cos_phi + r * cos_phi_t) * (*cspan_at(&work, at + layout__PLACE_SIN_ROLL)) + v2 * (*cspan_at(&work_t, at + layout__PLACE_SIN_ROLL)));
    lateral = v1 * (*cspan_at(&work, at + layout__PLACE_COS_ROLL)) - v2 * (*cspan_at(&work, at + layout__PLACE_SIN_ROLL));
    v3 = (*cspan_at(&work, at + layout__PLACE_COS_YAW)) * r;
    (*result_0) = v3 * sin_phi - (*cspan_at(&work, at + layout__PLACE_SIN_YAW)) * lateral;
    (*result_1) = ((*cspan_at(&work_t, at + layout__PLACE_COS_YAW)) * r + (*cspan_at(&work, at + layout__PLACE_COS_YAW)) * r_t) * sin_phi + v3 * sin_phi_t - ((*cspan_at(&work_t, at + layout__PLACE_SIN_YAW)) * lateral + (*cspan_at(&work, at + layout__PLACE_SIN_YAW)) * lateral_t);
    return 0;
}
