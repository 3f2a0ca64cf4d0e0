/* Generated from tangent_contact_plane.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of contact_plane.py.
 */

#include "tangent_contact_plane.h"

/* Tangent of ``open_frame``. */
static inline int64_t tangent_contact_plane__open_frame_t(double* z, double* z_t, double* slope, double* slope_t, double* y_track, double* y_track_t, double* rail_slope, double* rail_slope_t, double* mismatch, double* mismatch_t, array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t place, double y, double y_t, double aside, double aside_t, double shift, double shift_t)
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
    tangent_locus__outline_jet_t(y_track, y_track_t, &z_track, &z_track_t, &outline_slope, &outline_slope_t, &stretch, &stretch_t, &outline_rate, &outline_rate_t, work, work_t, place, y, y_t, (*z), (*z_t), (*slope), (*slope_t), bend, bend_t);
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
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAIL + layout__POINT_Y)) = abscissa_t;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAIL + layout__POINT_Y)) = abscissa;
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAIL + layout__POINT_Z)) = height_t;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAIL + layout__POINT_Z)) = height;
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_WHEEL + layout__POINT_Y)) = y_t;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_WHEEL + layout__POINT_Y)) = y;
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_WHEEL + layout__POINT_Z)) = (*z_t);
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_WHEEL + layout__POINT_Z)) = (*z);
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS)) = cosine_t;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS)) = cosine;
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_SIN)) = sine_t;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_SIN)) = sine;
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_WHEEL_PLANE + layout__DIRECTION_COS)) = (*cspan_at(&work_t, place + layout__PLACE_COS_ROLL)) * cosine + (*cspan_at(&work, place + layout__PLACE_COS_ROLL)) * cosine_t + ((*cspan_at(&work_t, place + layout__PLACE_SIN_ROLL)) * sine + (*cspan_at(&work, place + layout__PLACE_SIN_ROLL)) * sine_t);
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_WHEEL_PLANE + layout__DIRECTION_COS)) = (*cspan_at(&work, place + layout__PLACE_COS_ROLL)) * cosine + (*cspan_at(&work, place + layout__PLACE_SIN_ROLL)) * sine;
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_WHEEL_PLANE + layout__DIRECTION_SIN)) = (*cspan_at(&work_t, place + layout__PLACE_COS_ROLL)) * sine + (*cspan_at(&work, place + layout__PLACE_COS_ROLL)) * sine_t - ((*cspan_at(&work_t, place + layout__PLACE_SIN_ROLL)) * cosine + (*cspan_at(&work, place + layout__PLACE_SIN_ROLL)) * cosine_t);
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_WHEEL_PLANE + layout__DIRECTION_SIN)) = (*cspan_at(&work, place + layout__PLACE_COS_ROLL)) * sine - (*cspan_at(&work, place + layout__PLACE_SIN_ROLL)) * cosine;
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLACE)) = 0.0;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLACE)) = (double)(place - (layout__WORK_CONTACT + layout__CONTACT_FRAME));
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_ASIDE)) = aside_t;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_ASIDE)) = aside;
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_SHIFT)) = shift_t;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_SHIFT)) = shift;
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_LIFT)) = z_track_t + shift_t - height_t;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_LIFT)) = z_track + shift - height;
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAISED)) = 0.0;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAISED)) = 0.0;
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PRESSED)) = 0.0;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PRESSED)) = (double)(0);
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_SUNK)) = 0.0;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_SUNK)) = (double)(0);
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_HEIGHT)) = shift_t;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_HEIGHT)) = shift;
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_DEPTH)) = 0.0;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_DEPTH)) = 0.0;
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_BLUR)) = 0.0;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_BLUR)) = 0.0;
    tangent_traces__start_traces_t(work, work_t, 0.0, 0.0, abscissa, abscissa_t, y, y_t);
    (*mismatch_t) = (*rail_slope_t) - outline_slope_t;
    (*mismatch) = (*rail_slope) - outline_slope;
    if (!(stretch > 0.0))
    {
        (*mismatch_t) = 0.0;
        (*mismatch) = gap__FOLDED;
    }
    return 0;
}

/* Tangent of ``normal_gap``. */
static inline int64_t tangent_contact_plane__normal_gap_t(double* gap, double* gap_t, double* result_2, double* result_3, double* result_4, double* result_5, double* curvature, double* curvature_t, array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, double station, double station_t, double tolerance, double tolerance_t)
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
    tangent_traces__trace_rail_t(&rail_height, &rail_height_t, &rail_rate, &rail_rate_t, &rail_bend, &rail_bend_t, &on_rail, work, work_t, tables, station, station_t, tolerance, tolerance_t);
    tangent_traces__trace_wheel_t(&wheel_height, &wheel_height_t, &wheel_rate, &wheel_rate_t, &wheel_bend, &wheel_bend_t, curvature, curvature_t, &on_wheel, work, work_t, tables, station, station_t, tolerance, tolerance_t);
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_STATION)) = station_t;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_STATION)) = station;
    (*gap_t) = wheel_height_t - rail_height_t + (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAISED));
    (*gap) = wheel_height - rail_height + (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAISED));
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
