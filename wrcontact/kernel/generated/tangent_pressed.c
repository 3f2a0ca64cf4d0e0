/* Generated from tangent_pressed.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of pressed.py.
 */

#include "tangent_pressed.h"

/* Tangent of ``normal_line``. */
static inline int64_t tangent_pressed__normal_line_t(double* result_0, double* result_1, double* overlap, double* overlap_t, double* rise, double* rise_t, double* rate, double* rate_t, double* curvature, double* curvature_t, int64_t* found, array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t place, double abscissa, double abscissa_t, double y, double y_t, double height, double height_t, double tolerance, double tolerance_t)
{
    double z;
    double z_t;
    double slope;
    double slope_t;
    double bend;
    double bend_t;
    double v2;
    double v2_t;
    double v1;
    double v1_t;
    tangent_pressed__meet_rule_t(&y, &y_t, overlap, overlap_t, rise, rise_t, rate, rate_t, &z, &z_t, &slope, &slope_t, &bend, &bend_t, found, work, work_t, tables, place, abscissa, abscissa_t, y, y_t, height, height_t, tolerance, tolerance_t);
    (*curvature_t) = 0.0;
    (*curvature) = 0.0;
    if ((*found) == INT64_C(1))
    {
        tangent_pressed__mean_bend_t(&v2, &v2_t, work, work_t, tables, y, y_t, bend, bend_t);
        tangent_longitudinal_curvature__longitudinal_curvature_t(&v1, &v1_t, work, work_t, tables, place, z, z_t, slope, slope_t, v2, v2_t);
        (*curvature_t) = v1_t;
        (*curvature) = v1;
    }
    (*result_0) = y;
    (*result_1) = y_t;
    return 0;
}

/* Tangent of ``meet_wheel``. */
static inline int64_t tangent_pressed__meet_wheel_t(double* result_0_0001, double* result_1_0001, double* result_2, double* result_3, double* result_4, double* result_5, double* result_6_0001, double* result_7_0001, double* result_8, double* result_9, double* result_10, double* result_11, double* result_12, double* result_13, int64_t* result_14_0001, array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t place, double abscissa, double abscissa_t, double y, double y_t, double height, double height_t, double tolerance, double tolerance_t)
{
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
    double residual_t;
    double residual;
    double v6;
    double along_t;
    double along;
    double v7;
    double v8;
    double move_t;
    double move;
    double sharp_t;
    double sharp;
    double v9;
    double overlap_t;
    double overlap;
    double v10;
    double v11;
    double v12;
    double rise_t;
    double rise;
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
    double rest_t;
    double rest;
    double v20;
    double v21;
    double v22;
    double turn_t;
    double turn;
    double v23;
    double v24;
    double relative_kappa_t;
    double relative_kappa;
    wheel = (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL)));
    tangent_profile_table__height_slope_bend_t(&z_rail, &z_rail_t, &m, &m_t, &rail_bend, &rail_bend_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), abscissa, abscissa_t);
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
        tangent_locus__outline_jet_t(&y_track, &y_track_t, &z_track, &z_track_t, &outline_slope, &outline_slope_t, &stretch, &stretch_t, &rate, &rate_t, work, work_t, place, y, y_t, z, z_t, slope, slope_t, bend, bend_t);
        across_t = y_track_t - abscissa_t;
        across = y_track - (*cspan_at(&tables, layout__TABLES_RAIL_Y)) - abscissa;
        down_t = z_track_t + height_t - z_rail_t;
        down = z_track + height - z_rail;
        residual_t = across_t + (down_t * m + down * m_t);
        residual = across + down * m;
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
            (*result_10) = 0.0;
            (*result_11) = 0.0;
            (*result_12) = 0.0;
            (*result_13) = 0.0;
            (*result_14_0001) = INT64_C(0);
            return 0;
        }
        v7 = -residual;
        v8 = v7 / along;
        move_t = ((-residual_t) - v8 * along_t) / along;
        move = v8;
        sharp_t = tolerance_t;
        sharp = tolerance;
        if ((i == pressed__LINE_ITERATIONS - INT64_C(1)) && (sharp < pressed__LINE_JOINT))
        {
            sharp_t = 0.0;
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
                (*result_10) = 0.0;
                (*result_11) = 0.0;
                (*result_12) = 0.0;
                (*result_13) = 0.0;
                (*result_14_0001) = INT64_C(0);
                return 0;
            }
            v10 = outline_slope - m;
            v11 = 1.0 + m * outline_slope;
            v12 = v10 / v11;
            rise_t = (outline_slope_t - m_t - v12 * (m_t * outline_slope + m * outline_slope_t)) / v11;
            rise = v12;
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
            steep_t = rise_t * rise + rise * rise_t;
            steep = 1.0 + rise * rise;
            v19 = -residual;
            rest_t = (-residual_t) * cosine + v19 * cosine_t;
            rest = v19 * cosine;
            v20 = wheel_kappa * steep;
            v21 = sqrt(steep);
            v22 = v20 * v21;
            turn_t = ((wheel_kappa_t * steep + wheel_kappa * steep_t) * v21 + v20 * tangent_rates__root_rate(v21, steep_t)) * rest + v22 * rest_t;
            turn = v22 * rest;
            v23 = rise + 0.5 * turn;
            overlap_t = overlap_t + (rest_t * v23 + rest * (rise_t + 0.5 * turn_t));
            overlap = overlap + rest * v23;
            rise_t = rise_t + turn_t;
            rise = rise + turn;
            y_t = y_t + move_t;
            y = y + move;
            z_t = z_t + (slope_t * move + slope * move_t);
            z = z + slope * move;
            slope_t = slope_t + (bend_t * move + bend * move_t);
            slope = slope + bend * move;
            v24 = sqrt(steep);
            relative_kappa_t = wheel_kappa_t * v24 + wheel_kappa * tangent_rates__root_rate(v24, steep_t) - kappa_t;
            relative_kappa = wheel_kappa * v24 - kappa;
            (*result_0_0001) = y;
            (*result_1_0001) = y_t;
            (*result_2) = overlap;
            (*result_3) = overlap_t;
            (*result_4) = rise;
            (*result_5) = rise_t;
            (*result_6_0001) = steep * relative_kappa;
            (*result_7_0001) = steep_t * relative_kappa + steep * relative_kappa_t;
            (*result_8) = z;
            (*result_9) = z_t;
            (*result_10) = slope;
            (*result_11) = slope_t;
            (*result_12) = bend;
            (*result_13) = bend_t;
            (*result_14_0001) = INT64_C(1);
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
            (*result_10) = 0.0;
            (*result_11) = 0.0;
            (*result_12) = 0.0;
            (*result_13) = 0.0;
            (*result_14_0001) = INT64_C(0);
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
    (*result_10) = 0.0;
    (*result_11) = 0.0;
    (*result_12) = 0.0;
    (*result_13) = 0.0;
    (*result_14_0001) = INT64_C(0);
    return 0;
}

/* Tangent of ``mean_bend``. */
static inline int64_t tangent_pressed__mean_bend_t(double* result_0, double* result_1, array_double_1d work, array_double_1d work_t, array_double_1d tables, double y, double y_t, double bend, double bend_t)
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
    blur_t = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_BLUR));
    blur = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_BLUR));
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

/* Tangent of ``pressed_gap``. */
static inline int64_t tangent_pressed__pressed_gap_t(double* gap, double* gap_t, double* rate, double* rate_t, double* bend, double* bend_t, double* curvature, double* curvature_t, array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, double station, double station_t)
{
    int64_t rail;
    double way_t;
    double way;
    double v1;
    double v1_t;
    double abscissa_t;
    double abscissa;
    int64_t trace;
    double estimate_t;
    double estimate;
    double y;
    double y_t;
    double overlap;
    double overlap_t;
    double rise;
    double rise_t;
    double rise_rate;
    double rise_rate_t;
    double found_curvature;
    double found_curvature_t;
    int64_t found;
    double v2;
    double v3;
    (*cspan_at(&state, layout__STATE_NODE_COUNT)) = (*cspan_at(&state, layout__STATE_NODE_COUNT)) + 1.0;
    rail = (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL)));
    way_t = station_t - (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_STATION));
    way = station - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_STATION));
    tangent_arc_length__rail_abscissa_t(&v1, &v1_t, tables, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__RAIL + layout__TRACE_ABSCISSA)), (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__RAIL + layout__TRACE_ABSCISSA)), way, way_t);
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
        trace = layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__WHEEL;
        estimate_t = (*cspan_at(&work_t, trace + layout__TRACE_ABSCISSA)) + (way_t * (*cspan_at(&work, trace + layout__TRACE_RATE)) + way * (*cspan_at(&work_t, trace + layout__TRACE_RATE)));
        estimate = (*cspan_at(&work, trace + layout__TRACE_ABSCISSA)) + way * (*cspan_at(&work, trace + layout__TRACE_RATE));
        tangent_pressed__normal_line_t(&y, &y_t, &overlap, &overlap_t, &rise, &rise_t, &rise_rate, &rise_rate_t, &found_curvature, &found_curvature_t, &found, work, work_t, tables, layout__WORK_CONTACT + layout__CONTACT_FRAME + (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLACE))), abscissa, abscissa_t, estimate, estimate_t, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_HEIGHT)), (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_HEIGHT)), pressed__NODE_SHARP, 0.0);
        if (found == INT64_C(1))
        {
            (*gap_t) = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAISED)) + (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_DEPTH)) - overlap_t;
            (*gap) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAISED)) + (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_DEPTH)) - overlap;
            (*rate_t) = -rise_t;
            (*rate) = -rise;
            (*bend_t) = -rise_rate_t;
            (*bend) = -rise_rate;
            (*curvature_t) = found_curvature_t;
            (*curvature) = found_curvature;
            if (fabs(way) > pressed__LEAST_WAY)
            {
                v2 = y - (*cspan_at(&work, trace + layout__TRACE_ABSCISSA));
                v3 = v2 / way;
                (*cspan_at(&work_t, trace + layout__TRACE_RATE)) = (y_t - (*cspan_at(&work_t, trace + layout__TRACE_ABSCISSA)) - v3 * way_t) / way;
                (*cspan_at(&work, trace + layout__TRACE_RATE)) = v3;
            }
            (*cspan_at(&work_t, trace + layout__TRACE_ABSCISSA)) = y_t;
            (*cspan_at(&work, trace + layout__TRACE_ABSCISSA)) = y;
            (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__RAIL + layout__TRACE_ABSCISSA)) = abscissa_t;
            (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__RAIL + layout__TRACE_ABSCISSA)) = abscissa;
            (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_STATION)) = station_t;
            (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_STATION)) = station;
        }
    }
    return 0;
}

/* Tangent of ``meet_rule``. */
static inline int64_t tangent_pressed__meet_rule_t(double* result_0, double* result_1, double* overlap, double* overlap_t, double* rise, double* rise_t, double* rate, double* rate_t, double* z, double* z_t, double* slope, double* slope_t, double* bend, double* bend_t, int64_t* found, array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t place, double abscissa, double abscissa_t, double y, double y_t, double height, double height_t, double tolerance, double tolerance_t)
{
    double z_rail;
    double z_rail_t;
    double m;
    double m_t;
    double rail_bend;
    double rail_bend_t;
    double y_track;
    double y_track_t;
    double z_track;
    double z_track_t;
    double outline_slope;
    double outline_slope_t;
    double stretch;
    double stretch_t;
    double v1;
    double residual_t;
    double residual;
    double v2;
    double v3;
    pressed__meet_wheel(&y, overlap, rise, rate, z, slope, bend, found, work, tables, place, abscissa, y, height, tolerance);
    y_t = 0.0;
    (*overlap_t) = 0.0;
    (*rise_t) = 0.0;
    (*rate_t) = 0.0;
    (*z_t) = 0.0;
    (*slope_t) = 0.0;
    (*bend_t) = 0.0;
    if ((*found) == INT64_C(1))
    {
        tangent_profile_table__height_slope_bend_t(&z_rail, &z_rail_t, &m, &m_t, &rail_bend, &rail_bend_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), abscissa, abscissa_t);
        tangent_profile_table__height_slope_bend_t(z, z_t, slope, slope_t, bend, bend_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL))), y, y_t);
        tangent_locus__outline_jet_t(&y_track, &y_track_t, &z_track, &z_track_t, &outline_slope, &outline_slope_t, &stretch, &stretch_t, rate, rate_t, work, work_t, place, y, y_t, (*z), (*z_t), (*slope), (*slope_t), (*bend), (*bend_t));
        v1 = z_track + height - z_rail;
        residual_t = y_track_t - abscissa_t + ((z_track_t + height_t - z_rail_t) * m + v1 * m_t);
        residual = y_track - (*cspan_at(&tables, layout__TABLES_RAIL_Y)) - abscissa + v1 * m;
        v2 = -residual;
        v3 = stretch * (1.0 + m * outline_slope);
        y_t = (-residual_t) / v3;
        tangent_pressed__meet_wheel_t(&y, &y_t, overlap, overlap_t, rise, rise_t, rate, rate_t, z, z_t, slope, slope_t, bend, bend_t, found, work, work_t, tables, place, abscissa, abscissa_t, y, y_t, height, height_t, tolerance, tolerance_t);
    }
    (*result_0) = y;
    (*result_1) = y_t;
    return 0;
}
