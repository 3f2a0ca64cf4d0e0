/* Generated from contact/contact_plane.py by tools/transpile_kernel.py; change that one.
 *
 * The plane of a contact, and the gap of wheel and rail along its normal.
 */

#include "contact_plane.h"

/* Place the contact plane at wheel abscissa ``y`` [m]; the slope is the rail's, which is the outline's
 * there.
 *
 * aside, shift : lateral and vertical shift that let the wheel touch the rail there [m].
 *
 * Returns what describes the point: wheel height [m] and slope [-], lateral track coordinate [m], rail slope
 * [-], and how much the slopes of rail and outline differ [-], FOLDED as in :mod:`gap`.
 */
static inline int64_t contact_plane__open_frame(double* z, double* slope, double* y_track, double* rail_slope, double* mismatch, array_double_1d work, array_double_1d tables, int64_t place, double y, double aside, double shift)
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
    locus__outline_jet(y_track, &z_track, &outline_slope, &stretch, &outline_rate, work, place, y, (*z), (*slope), bend);
    (*y_track) += aside;
    abscissa = (*y_track) - (*cspan_at(&tables, layout__TABLES_RAIL_Y));
    profile_table__height_slope_bend(&height, rail_slope, &rail_bend, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), abscissa);
    cosine = 1.0 / sqrt(1.0 + (*rail_slope) * (*rail_slope));
    sine = (*rail_slope) * cosine;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAIL + layout__POINT_Y)) = abscissa;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAIL + layout__POINT_Z)) = height;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_WHEEL + layout__POINT_Y)) = y;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_WHEEL + layout__POINT_Z)) = (*z);
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS)) = cosine;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_SIN)) = sine;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_WHEEL_PLANE + layout__DIRECTION_COS)) = (*cspan_at(&work, place + layout__PLACE_COS_ROLL)) * cosine + (*cspan_at(&work, place + layout__PLACE_SIN_ROLL)) * sine;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_WHEEL_PLANE + layout__DIRECTION_SIN)) = (*cspan_at(&work, place + layout__PLACE_COS_ROLL)) * sine - (*cspan_at(&work, place + layout__PLACE_SIN_ROLL)) * cosine;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLACE)) = (double)(place - (layout__WORK_CONTACT + layout__CONTACT_FRAME));
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_ASIDE)) = aside;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_SHIFT)) = shift;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_LIFT)) = z_track + shift - height;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAISED)) = 0.0;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PRESSED)) = (double)(0);
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_SUNK)) = (double)(0);
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_HEIGHT)) = shift;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_DEPTH)) = 0.0;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_BLUR)) = 0.0;
    traces__start_traces(work, 0.0, abscissa, y);
    (*mismatch) = (*rail_slope) - outline_slope;
    if (!(stretch > 0.0))
    {
        (*mismatch) = gap__FOLDED;
    }
    return 0;
}

/* Gap g along the contact normal [m], dg/ds [-], d2g/ds2 [1/m] and the wheel's 1/R_x [1/m] at ``station``
 * [m].
 *
 * NO_GAP where a profile has ended.  ``tolerance`` [m] is that of the stations of wheel and rail.
 */
static inline int64_t contact_plane__normal_gap(double* gap, double* result_1, double* result_2, double* curvature, array_double_1d work, array_double_1d tables, array_double_1d state, double station, double tolerance)
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
    traces__trace_rail(&rail_height, &rail_rate, &rail_bend, &on_rail, work, tables, station, tolerance);
    traces__trace_wheel(&wheel_height, &wheel_rate, &wheel_bend, curvature, &on_wheel, work, tables, station, tolerance);
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_STATION)) = station;
    (*gap) = wheel_height - rail_height + (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAISED));
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
    int64_t yawed;
    yawed = INT64_C(0);
    if ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLACE))) + layout__PLACE_YAWED)) == 1.0)
    {
        yawed = INT64_C(1);
    }
    return yawed;
}
