/* Generated from tangent_pressed.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of pressed.py.
 */

#include "tangent_pressed.h"

/* Tangent of ``normal_line``. */
static inline int64_t tangent_pressed__normal_line_t(double* result_0_0001, double* result_1_0001, double* result_2, double* result_3, double* result_4, double* result_5, double* result_6_0001, double* result_7_0001, double* result_8, double* result_9, int64_t* result_10_0001, array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t at, double abscissa, double abscissa_t, double y, double y_t, double height, double height_t)
{
    int64_t rail;
    int64_t wheel;
    double z_rail;
    double z_rail_t;
    double m;
    double m_t;
    double rail_bend;
    double rail_bend_t;
    double v1;
    double v2;
    double v3;
    double cosine_t;
    double cosine;
    double v4;
    double v5;
    double kappa_t;
    double kappa;
    int64_t i;
    double z;
    double z_t;
    double slope;
    double slope_t;
    double bend;
    double bend_t;
    double y_track;
    double y_track_t;
    double z_track;
    double z_track_t;
    double outline_slope;
    double outline_slope_t;
    double stretch;
    double stretch_t;
    double rate;
    double rate_t;
    double across_t;
    double across;
    double down_t;
    double down;
    double rest_t;
    double rest;
    double v6;
    double along_t;
    double along;
    double v7;
    double v8;
    double move_t;
    double move;
    double sharp;
    double v9;
    double overlap_t;
    double overlap;
    double v10;
    double v11;
    double v12;
    double tangent_t;
    double tangent;
    double v13;
    double v14;
    double v15;
    double wheel_cos_t;
    double wheel_cos;
    double v16;
    double v17;
    double v18;
    double wheel_kappa_t;
    double wheel_kappa;
    double steep_t;
    double steep;
    double v19;
    double turn_t;
    double turn;
    double v21;
    double v21_t;
    double v20;
    double v20_t;
    double curvature_t;
    double curvature;
    rail = (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL)));
    wheel = (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL)));
    tangent_profile_table__height_slope_bend_t(&z_rail, &z_rail_t, &m, &m_t, &rail_bend, &rail_bend_t, tables, rail, abscissa, abscissa_t);
    v1 = 1.0 + m * m;
    v2 = sqrt(v1);
    v3 = 1.0 / v2;
    cosine_t = (-v3) * tangent_rates__root_rate(v2, m_t * m + m * m_t) / v2;
    cosine = v3;
    v4 = rail_bend * cosine;
    v5 = v4 * cosine;
    kappa_t = ((rail_bend_t * cosine + rail_bend * cosine_t) * cosine + v4 * cosine_t) * cosine + v5 * cosine_t;
    kappa = v5 * cosine;
    for (i = INT64_C(0); i < pressed__LINE_ITERATIONS; i += INT64_C(1))
    {
        tangent_profile_table__height_slope_bend_t(&z, &z_t, &slope, &slope_t, &bend, &bend_t, tables, wheel, y, y_t);
        tangent_locus__outline_jet_t(&y_track, &y_track_t, &z_track, &z_track_t, &outline_slope, &outline_slope_t, &stretch, &stretch_t, &rate, &rate_t, work, work_t, at, y, y_t, z, z_t, slope, slope_t, bend, bend_t);
        across_t = y_track_t - abscissa_t;
        across = y_track - (*cspan_at(&tables, layout__TABLES_RAIL_Y)) - abscissa;
        down_t = z_track_t + height_t - z_rail_t;
        down = z_track + height - z_rail;
        rest_t = across_t + (down_t * m + down * m_t);
        rest = across + down * m;
        v6 = 1.0 + m * outline_slope;
        along_t = stretch_t * v6 + stretch * (m_t * outline_slope + m * outline_slope_t);
        along = stretch * v6;
        if (!((along > 0.0) && (stretch > 0.0)))
        {
            (*result_0_0001) = y;
            (*result_1_0001) = y_t;
            (*result_2) = 0.0;
            (*result_3) = 0.0;
            (*result_4) = 0.0;
            (*result_5) = 0.0;
            (*result_6_0001) = 0.0;
            (*result_7_0001) = 0.0;
            (*result_8) = 0.0;
            (*result_9) = 0.0;
            (*result_10_0001) = INT64_C(0);
            return 0;
        }
        v7 = -rest;
        v8 = v7 / along;
        move_t = ((-rest_t) - v8 * along_t) / along;
        move = v8;
        sharp = pressed__LINE_SHARP;
        if (i == pressed__LINE_ITERATIONS - INT64_C(1))
        {
            sharp = pressed__LINE_JOINT;
        }
        if (fabs(move) < sharp)
        {
            v9 = down - m * across;
            overlap_t = (down_t - (m_t * across + m * across_t)) * cosine + v9 * cosine_t;
            overlap = v9 * cosine;
            if (!(fabs(overlap) < pressed__FARTHEST))
            {
                (*result_0_0001) = y;
                (*result_1_0001) = y_t;
                (*result_2) = 0.0;
                (*result_3) = 0.0;
                (*result_4) = 0.0;
                (*result_5) = 0.0;
                (*result_6_0001) = 0.0;
                (*result_7_0001) = 0.0;
                (*result_8) = 0.0;
                (*result_9) = 0.0;
                (*result_10_0001) = INT64_C(0);
                return 0;
            }
            v10 = outline_slope - m;
            v11 = 1.0 + m * outline_slope;
            v12 = v10 / v11;
            tangent_t = (outline_slope_t - m_t - v12 * (m_t * outline_slope + m * outline_slope_t)) / v11;
            tangent = v12;
            v13 = 1.0 + outline_slope * outline_slope;
            v14 = sqrt(v13);
            v15 = 1.0 / v14;
            wheel_cos_t = (-v15) * tangent_rates__root_rate(v14, outline_slope_t * outline_slope + outline_slope * outline_slope_t) / v14;
            wheel_cos = v15;
            v16 = rate / stretch;
            v17 = v16 * wheel_cos;
            v18 = v17 * wheel_cos;
            wheel_kappa_t = (((rate_t - v16 * stretch_t) / stretch * wheel_cos + v16 * wheel_cos_t) * wheel_cos + v17 * wheel_cos_t) * wheel_cos + v18 * wheel_cos_t;
            wheel_kappa = v18 * wheel_cos;
            steep_t = tangent_t * tangent + tangent * tangent_t;
            steep = 1.0 + tangent * tangent;
            v19 = sqrt(steep);
            turn_t = wheel_kappa_t * v19 + wheel_kappa * tangent_rates__root_rate(v19, steep_t) - kappa_t;
            turn = wheel_kappa * v19 - kappa;
            tangent_pressed__mean_bend_t(&v21, &v21_t, tables, work, work_t, y, y_t, bend, bend_t);
            tangent_contact_plane__longitudinal_curvature_t(&v20, &v20_t, tables, work, work_t, at, z, z_t, slope, slope_t, v21, v21_t);
            curvature_t = v20_t;
            curvature = v20;
            (*result_0_0001) = y;
            (*result_1_0001) = y_t;
            (*result_2) = overlap;
            (*result_3) = overlap_t;
            (*result_4) = tangent;
            (*result_5) = tangent_t;
            (*result_6_0001) = steep * turn;
            (*result_7_0001) = steep_t * turn + steep * turn_t;
            (*result_8) = curvature;
            (*result_9) = curvature_t;
            (*result_10_0001) = INT64_C(1);
            return 0;
        }
        if (move > pressed__LINE_STEP)
        {
            move_t = 0.0;
            move = pressed__LINE_STEP;
        }
        if (move < -pressed__LINE_STEP)
        {
            move_t = 0.0;
            move = -pressed__LINE_STEP;
        }
        y_t = y_t + move_t;
        y = y + move;
        if (!((y >= (*cspan_at(&tables, wheel + layout__PROFILE_START))) && (y <= (*cspan_at(&tables, wheel + layout__PROFILE_STOP)))))
        {
            (*result_0_0001) = y;
            (*result_1_0001) = y_t;
            (*result_2) = 0.0;
            (*result_3) = 0.0;
            (*result_4) = 0.0;
            (*result_5) = 0.0;
            (*result_6_0001) = 0.0;
            (*result_7_0001) = 0.0;
            (*result_8) = 0.0;
            (*result_9) = 0.0;
            (*result_10_0001) = INT64_C(0);
            return 0;
        }
    }
    (*result_0_0001) = y;
    (*result_1_0001) = y_t;
    (*result_2) = 0.0;
    (*result_3) = 0.0;
    (*result_4) = 0.0;
    (*result_5) = 0.0;
    (*result_6_0001) = 0.0;
    (*result_7_0001) = 0.0;
    (*result_8) = 0.0;
    (*result_9) = 0.0;
    (*result_10_0001) = INT64_C(0);
    return 0;
}

/* Tangent of ``mean_bend``. */
static inline int64_t tangent_pressed__mean_bend_t(double* result_0, double* result_1, array_double_1d tables, array_double_1d work, array_double_1d work_t, double y, double y_t, double bend, double bend_t)
{
    double blur_t;
    double blur;
    int64_t wheel;
    double low_t;
    double low;
    double high_t;
    double high;
    double z;
    double z_t;
    double low_slope;
    double low_slope_t;
    double high_slope;
    double high_slope_t;
    double v1;
    double v2;
    double v3;
    blur_t = (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_BLUR));
    blur = (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_BLUR));
    if (blur > 0.0)
    {
        wheel = (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL)));
        low_t = y_t - blur_t;
        low = y - blur;
        high_t = y_t + blur_t;
        high = y + blur;
        if (low < (*cspan_at(&tables, wheel + layout__PROFILE_START)))
        {
            low_t = 0.0;
            low = (*cspan_at(&tables, wheel + layout__PROFILE_START));
        }
        if (high > (*cspan_at(&tables, wheel + layout__PROFILE_STOP)))
        {
            high_t = 0.0;
            high = (*cspan_at(&tables, wheel + layout__PROFILE_STOP));
        }
        tangent_profile_table__height_slope_t(&z, &z_t, &low_slope, &low_slope_t, tables, wheel, low, low_t);
        tangent_profile_table__height_slope_t(&z, &z_t, &high_slope, &high_slope_t, tables, wheel, high, high_t);
        v1 = high_slope - low_slope;
        v2 = high - low;
        v3 = v1 / v2;
        bend_t = (high_slope_t - low_slope_t - v3 * (high_t - low_t)) / v2;
        bend = v3;
    }
    (*result_0) = bend;
    (*result_1) = bend_t;
    return 0;
}

/* Tangent of ``rail_speed``. */
static inline int64_t tangent_pressed__rail_speed_t(double* v2, double* result_1, array_double_1d tables, double abscissa, double abscissa_t)
{
    double height;
    double height_t;
    double slope;
    double slope_t;
    double v1;
    tangent_profile_table__height_slope_t(&height, &height_t, &slope, &slope_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), abscissa, abscissa_t);
    v1 = 1.0 + slope * slope;
    (*v2) = sqrt(v1);
    (*result_1) = tangent_rates__root_rate((*v2), slope_t * slope + slope * slope_t);
    return 0;
}

/* Tangent of ``rail_length``. */
static inline int64_t tangent_pressed__rail_length_t(double* result_0, double* result_1, array_double_1d tables, double start, double start_t, double stop, double stop_t)
{
    int64_t cells;
    double v1;
    double v2;
    double step_t;
    double step;
    double total_t;
    double total;
    double v3;
    double v3_t;
    double low_t;
    double low;
    int64_t i;
    double v4;
    double begin_t;
    double begin;
    double v5;
    double v5_t;
    double middle_t;
    double middle;
    double v6;
    double v6_t;
    double high_t;
    double high;
    double v7;
    cells = (int64_t)(fabs(stop - start) / pressed__ARC_STEP) + INT64_C(1);
    v1 = stop - start;
    v2 = (double)(cells);
    step_t = (stop_t - start_t) / v2;
    step = v1 / v2;
    total_t = 0.0;
    total = 0.0;
    tangent_pressed__rail_speed_t(&v3, &v3_t, tables, start, start_t);
    low_t = v3_t;
    low = v3;
    for (i = INT64_C(0); i < cells; i += INT64_C(1))
    {
        v4 = (double)(i);
        begin_t = start_t + step_t * v4;
        begin = start + step * v4;
        tangent_pressed__rail_speed_t(&v5, &v5_t, tables, begin + 0.5 * step, begin_t + 0.5 * step_t);
        middle_t = v5_t;
        middle = v5;
        tangent_pressed__rail_speed_t(&v6, &v6_t, tables, begin + step, begin_t + step_t);
        high_t = v6_t;
        high = v6;
        total_t = total_t + (low_t + 4.0 * middle_t + high_t);
        total = total + (low + 4.0 * middle + high);
        low_t = high_t;
        low = high;
    }
    v7 = total * step;
    (*result_0) = v7 / 6.0;
    (*result_1) = (total_t * step + total * step_t) / 6.0;
    return 0;
}

/* Tangent of ``rail_abscissa``. */
static inline int64_t tangent_pressed__rail_abscissa_t(double* x, double* x_t, array_double_1d tables, double start, double start_t, double length, double length_t)
{
    int64_t steps;
    double v1;
    double way_t;
    double way;
    int64_t step;
    double height;
    double height_t;
    double slope;
    double slope_t;
    double bend;
    double bend_t;
    double v2;
    double v3;
    double before_t;
    double before;
    double v4;
    double cosine_t;
    double cosine;
    double v5;
    double v6;
    double v7;
    double v8;
    double v9;
    double v10;
    double v11;
    double following_t;
    double following;
    int64_t i;
    double v13;
    double v12;
    double v12_t;
    double middle_t;
    double middle;
    double v14;
    double v14_t;
    double after_t;
    double after;
    double v15;
    double v16;
    double v17;
    double v18;
    double v19;
    double move_t;
    double move;
    steps = (int64_t)(fabs(length) / pressed__ARC_STEP) + INT64_C(1);
    v1 = (double)(steps);
    way_t = length_t / v1;
    way = length / v1;
    (*x_t) = start_t;
    (*x) = start;
    for (step = INT64_C(0); step < steps; step += INT64_C(1))
    {
        tangent_profile_table__height_slope_bend_t(&height, &height_t, &slope, &slope_t, &bend, &bend_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), (*x), (*x_t));
        v2 = 1.0 + slope * slope;
        v3 = sqrt(v2);
        before_t = tangent_rates__root_rate(v3, slope_t * slope + slope * slope_t);
        before = v3;
        v4 = 1.0 / before;
        cosine_t = (-v4) * before_t / before;
        cosine = v4;
        v5 = way * cosine;
        v6 = 0.5 * way;
        v7 = v6 * slope;
        v8 = v7 * bend;
        v9 = v8 * cosine;
        v10 = v9 * cosine;
        v11 = 1.0 - v10 * cosine;
        following_t = (*x_t) + ((way_t * cosine + way * cosine_t) * v11 + v5 * (-(((((0.5 * way_t * slope + v6 * slope_t) * bend + v7 * bend_t) * cosine + v8 * cosine_t) * cosine + v9 * cosine_t) * cosine + v10 * cosine_t)));
        following = (*x) + v5 * v11;
        for (i = INT64_C(0); i < pressed__LINE_ITERATIONS; i += INT64_C(1))
        {
            v13 = (*x) + following;
            tangent_pressed__rail_speed_t(&v12, &v12_t, tables, 0.5 * v13, 0.5 * ((*x_t) + following_t));
            middle_t = v12_t;
            middle = v12;
            tangent_pressed__rail_speed_t(&v14, &v14_t, tables, following, following_t);
            after_t = v14_t;
            after = v14;
            v15 = following - (*x);
            v16 = before + 4.0 * middle + after;
            v17 = v15 * v16;
            v18 = way - v17 / 6.0;
            v19 = v18 / after;
            move_t = (way_t - ((following_t - (*x_t)) * v16 + v15 * (before_t + 4.0 * middle_t + after_t)) / 6.0 - v19 * after_t) / after;
            move = v19;
            following_t = following_t + move_t;
            following = following + move;
            if (fabs(move) < pressed__ARC_SHARP)
            {
                break;
            }
        }
        (*x_t) = following_t;
        (*x) = following;
    }
    return 0;
}

/* Tangent of ``pressed_gap``. */
static inline int64_t tangent_pressed__pressed_gap_t(double* gap, double* gap_t, double* rate, double* rate_t, double* bend, double* bend_t, double* curvature, double* curvature_t, array_double_1d tables, array_double_1d work, array_double_1d work_t, array_double_1d state, double station, double station_t)
{
    int64_t rail;
    double way_t;
    double way;
    double v1;
    double v1_t;
    double abscissa_t;
    double abscissa;
    double y;
    double y_t;
    double overlap;
    double overlap_t;
    double rise;
    double rise_t;
    double turn;
    double turn_t;
    double found_curvature;
    double found_curvature_t;
    int64_t found;
    double v2;
    double v3;
    (*cspan_at(&state, layout__STATE_NODE_COUNT)) = (*cspan_at(&state, layout__STATE_NODE_COUNT)) + 1.0;
    rail = (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL)));
    way_t = station_t - (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_TRACER_STATION));
    way = station - (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_STATION));
    tangent_pressed__rail_abscissa_t(&v1, &v1_t, tables, (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_RAIL)), (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_TRACER_RAIL)), way, way_t);
    abscissa_t = v1_t;
    abscissa = v1;
    (*gap_t) = 0.0;
    (*gap) = contact_plane__NO_GAP;
    (*rate_t) = 0.0;
    (*rate) = 0.0;
    (*bend_t) = 0.0;
    (*bend) = 0.0;
    (*curvature_t) = 0.0;
    (*curvature) = 1.0;
    if ((abscissa >= (*cspan_at(&tables, rail + layout__PROFILE_START))) && (abscissa <= (*cspan_at(&tables, rail + layout__PROFILE_STOP))))
    {
        tangent_pressed__line_rule_t(&y, &y_t, &overlap, &overlap_t, &rise, &rise_t, &turn, &turn_t, &found_curvature, &found_curvature_t, &found, tables, work, work_t, (int64_t)((*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_PLACE))), abscissa, abscissa_t, (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_WHEEL)) + way * (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_WHEEL_RATE)), (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_TRACER_WHEEL)) + (way_t * (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_WHEEL_RATE)) + way * (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_TRACER_WHEEL_RATE))), (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_POSE)), (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_POSE)));
        if (found == INT64_C(1))
        {
            (*gap_t) = (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_RAISED)) + (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_DEPTH)) - overlap_t;
            (*gap) = (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_RAISED)) + (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_DEPTH)) - overlap;
            (*rate_t) = -rise_t;
            (*rate) = -rise;
            (*bend_t) = -turn_t;
            (*bend) = -turn;
            (*curvature_t) = found_curvature_t;
            (*curvature) = found_curvature;
            if (fabs(way) > pressed__LEAST_WAY)
            {
                v2 = y - (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_WHEEL));
                v3 = v2 / way;
                (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_TRACER_WHEEL_RATE)) = (y_t - (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_TRACER_WHEEL)) - v3 * way_t) / way;
                (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_WHEEL_RATE)) = v3;
            }
            (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_TRACER_WHEEL)) = y_t;
            (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_WHEEL)) = y;
            (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_TRACER_RAIL)) = abscissa_t;
            (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_RAIL)) = abscissa;
            (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_TRACER_STATION)) = station_t;
            (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_STATION)) = station;
        }
    }
    return 0;
}

/* Tangent of ``line_rule``. */
static inline int64_t tangent_pressed__line_rule_t(double* result_0, double* result_1, double* overlap, double* overlap_t, double* tangent, double* tangent_t, double* turn, double* turn_t, double* curvature, double* curvature_t, int64_t* found, array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t at, double abscissa, double abscissa_t, double y, double y_t, double height, double height_t)
{
    double z_rail;
    double z_rail_t;
    double m;
    double m_t;
    double rail_bend;
    double rail_bend_t;
    double z;
    double z_t;
    double slope;
    double slope_t;
    double bend;
    double bend_t;
    double y_track;
    double y_track_t;
    double z_track;
    double z_track_t;
    double outline_slope;
    double outline_slope_t;
    double stretch;
    double stretch_t;
    double rate;
    double rate_t;
    double v1;
    double rest_t;
    double rest;
    double v2;
    double v3;
    pressed__normal_line(&y, overlap, tangent, turn, curvature, found, tables, work, at, abscissa, y, height);
    y_t = 0.0;
    (*overlap_t) = 0.0;
    (*tangent_t) = 0.0;
    (*turn_t) = 0.0;
    (*curvature_t) = 0.0;
    if ((*found) == INT64_C(1))
    {
        tangent_profile_table__height_slope_bend_t(&z_rail, &z_rail_t, &m, &m_t, &rail_bend, &rail_bend_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), abscissa, abscissa_t);
        tangent_profile_table__height_slope_bend_t(&z, &z_t, &slope, &slope_t, &bend, &bend_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL))), y, y_t);
        tangent_locus__outline_jet_t(&y_track, &y_track_t, &z_track, &z_track_t, &outline_slope, &outline_slope_t, &stretch, &stretch_t, &rate, &rate_t, work, work_t, at, y, y_t, z, z_t, slope, slope_t, bend, bend_t);
        v1 = z_track + height - z_rail;
        rest_t = y_track_t - abscissa_t + ((z_track_t + height_t - z_rail_t) * m + v1 * m_t);
        rest = y_track - (*cspan_at(&tables, layout__TABLES_RAIL_Y)) - abscissa + v1 * m;
        v2 = -rest;
        v3 = stretch * (1.0 + m * outline_slope);
        y_t = (-rest_t) / v3;
        tangent_pressed__normal_line_t(&y, &y_t, overlap, overlap_t, tangent, tangent_t, turn, turn_t, curvature, curvature_t, found, tables, work, work_t, at, abscissa, abscissa_t, y, y_t, height, height_t);
    }
    (*result_0) = y;
    (*result_1) = y_t;
    return 0;
}
