/* Generated from contact/pressed.py by tools/transpile_kernel.py; change that one.
 *
 * The overlap of a wheel that is pressed into its rail, along the rail's own normals.
 *
 * A wheel that comes down meets every part of the rail along another normal.  Where a patch reaches around a
 * corner one plane cannot hold that; so the overlap o of a pressed wheel is measured along the normal of each
 * rail point x, to where that line meets the wheel's outline (Y, Z) as it stands,
 *
 *     Y - x + (Z - z_rail(x)) m = 0,   o = (Z - z_rail - m (Y - x)) / sqrt(1 + m^2),   m = z_rail'(x)
 *
 * and stations run along the rail, by its arc length.  With slope m_w of the outline there and kappa of the rail
 *
 *     do/ds = (m_w - m) / (1 + m m_w)
 *
 * but for a factor 1 - kappa o, below 1 % and left out: kappa jumps where profiles are joined, and a slope must
 * not.  The deepest point of a region is a pair of points with one normal, and o does not depend on where
 * stations begin.
 */

#include "pressed.h"

/* As :func:`meet_wheel`, with the wheel's 1/R_x [1/m] there: wheel abscissa, overlap, its derivatives,
 * 1/R_x; and 1 if there is such a point, else 0.
 */
static OUT_OF_LINE int64_t pressed__normal_line(double* result_0, double* overlap, double* rise, double* rate, double* curvature, int64_t* found, array_double_1d work, array_double_1d tables, int64_t place, double abscissa, double y, double height, double tolerance)
{
    double z;
    double slope;
    double bend;
    pressed__meet_wheel(&y, overlap, rise, rate, &z, &slope, &bend, found, work, tables, place, abscissa, y, height, tolerance);
    (*curvature) = 0.0;
    if ((*found) == INT64_C(1))
    {
        (*curvature) = longitudinal_curvature__longitudinal_curvature(work, tables, place, z, slope, pressed__mean_bend(work, tables, y, bend));
    }
    (*result_0) = y;
    return 0;
}

/* Wheel abscissa [m] where the rail's normal at ``abscissa`` meets the wheel placed at ``place`` and
 * moved down by ``height``, sought from ``y`` to ``tolerance`` [m]; the overlap [m] and its
 * derivatives [-, 1/m] along the rail's arc; height, slope and bend of the wheel's profile there [m, -,
 * 1/m]; and 1 if there is such a point, else 0.
 */
static OUT_OF_LINE int64_t pressed__meet_wheel(double* result_0_0001, double* result_1, double* result_2, double* result_3_0001, double* result_4, double* result_5, double* result_6, int64_t* result_7_0001, array_double_1d work, array_double_1d tables, int64_t place, double abscissa, double y, double height, double tolerance)
{
    int64_t wheel;
    double z_rail;
    double m;
    double rail_bend;
    double cosine;
    double kappa;
    int64_t i;
    double z;
    double slope;
    double bend;
    double y_track;
    double z_track;
    double outline_slope;
    double stretch;
    double rate;
    double across;
    double down;
    double residual;
    double along;
    double move;
    double sharp;
    double overlap;
    double rise;
    double wheel_cos;
    double wheel_kappa;
    double steep;
    double rest;
    double turn;
    double relative_kappa;
    wheel = (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL)));
    profile_table__height_slope_bend(&z_rail, &m, &rail_bend, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), abscissa);
    cosine = 1.0 / sqrt(1.0 + m * m);
    kappa = rail_bend * cosine * cosine * cosine;
    for (i = INT64_C(0); i < pressed__LINE_ITERATIONS; i += INT64_C(1))
    {
        profile_table__height_slope_bend(&z, &slope, &bend, tables, wheel, y);
        locus__outline_jet(&y_track, &z_track, &outline_slope, &stretch, &rate, work, place, y, z, slope, bend);
        across = y_track - (*cspan_at(&tables, layout__TABLES_RAIL_Y)) - abscissa;
        down = z_track + height - z_rail;
        residual = across + down * m;
        along = stretch * (1.0 + m * outline_slope);
        if (!((along > 0.0) && (stretch > 0.0)))
        {
            (*result_0_0001) = y;
            (*result_1) = 0.0;
            (*result_2) = 0.0;
            (*result_3_0001) = 0.0;
            (*result_4) = 0.0;
            (*result_5) = 0.0;
            (*result_6) = 0.0;
            (*result_7_0001) = INT64_C(0);
            return 0;
        }
        move = (-residual) / along;
        sharp = tolerance;
        if ((i == pressed__LINE_ITERATIONS - INT64_C(1)) && (sharp < pressed__LINE_JOINT))
        {
            sharp = pressed__LINE_JOINT;
        }
        if (fabs(move) < sharp)
        {
            overlap = (down - m * across) * cosine;
            if (!(fabs(overlap) < pressed__FARTHEST))
            {
                (*result_0_0001) = y;
                (*result_1) = 0.0;
                (*result_2) = 0.0;
                (*result_3_0001) = 0.0;
                (*result_4) = 0.0;
                (*result_5) = 0.0;
                (*result_6) = 0.0;
                (*result_7_0001) = INT64_C(0);
                return 0;
            }
            rise = (outline_slope - m) / (1.0 + m * outline_slope);
            /* the angle between both curves changes by the wheel's curvature over its own arc less the rail's */
            wheel_cos = 1.0 / sqrt(1.0 + outline_slope * outline_slope);
            wheel_kappa = rate / stretch * wheel_cos * wheel_cos * wheel_cos;
            steep = 1.0 + rise * rise;
            /* from the wheel's point to the rail's normal: over the rail's tangent the overlap is a curve */
            rest = (-residual) * cosine;
            turn = wheel_kappa * steep * sqrt(steep) * rest;
            overlap += rest * (rise + 0.5 * turn);
            rise += turn;
            y += move;
            z += slope * move;
            slope += bend * move;
            relative_kappa = wheel_kappa * sqrt(steep) - kappa;
            (*result_0_0001) = y;
            (*result_1) = overlap;
            (*result_2) = rise;
            (*result_3_0001) = steep * relative_kappa;
            (*result_4) = z;
            (*result_5) = slope;
            (*result_6) = bend;
            (*result_7_0001) = INT64_C(1);
            return 0;
        }
        if (move > pressed__LINE_STEP)
        {
            move = pressed__LINE_STEP;
        }
        if (move < -pressed__LINE_STEP)
        {
            move = -pressed__LINE_STEP;
        }
        y += move;
        if (!((y >= (*cspan_at(&tables, wheel + layout__PROFILE_START))) && (y <= (*cspan_at(&tables, wheel + layout__PROFILE_STOP)))))
        {
            (*result_0_0001) = y;
            (*result_1) = 0.0;
            (*result_2) = 0.0;
            (*result_3_0001) = 0.0;
            (*result_4) = 0.0;
            (*result_5) = 0.0;
            (*result_6) = 0.0;
            (*result_7_0001) = INT64_C(0);
            return 0;
        }
    }
    (*result_0_0001) = y;
    (*result_1) = 0.0;
    (*result_2) = 0.0;
    (*result_3_0001) = 0.0;
    (*result_4) = 0.0;
    (*result_5) = 0.0;
    (*result_6) = 0.0;
    (*result_7_0001) = INT64_C(0);
    return 0;
}

/* Second derivative of the wheel profile [1/m] at ``y``, averaged over the frame's blur to either side
 * where that is set.
 *
 * With yaw it is part of the longitudinal curvature; taken at a point, it would jump when a profile's joint
 * passes a node.
 */
static OUT_OF_LINE double pressed__mean_bend(array_double_1d work, array_double_1d tables, double y, double bend)
{
    double blur;
    int64_t wheel;
    double low;
    double high;
    double z;
    double low_slope;
    double high_slope;
    blur = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_BLUR));
    if (blur > 0.0)
    {
        wheel = (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL)));
        low = y - blur;
        high = y + blur;
        if (low < (*cspan_at(&tables, wheel + layout__PROFILE_START)))
        {
            low = (*cspan_at(&tables, wheel + layout__PROFILE_START));
        }
        if (high > (*cspan_at(&tables, wheel + layout__PROFILE_STOP)))
        {
            high = (*cspan_at(&tables, wheel + layout__PROFILE_STOP));
        }
        profile_table__height_slope(&z, &low_slope, tables, wheel, low);
        profile_table__height_slope(&z, &high_slope, tables, wheel, high);
        bend = (high_slope - low_slope) / (high - low);
    }
    return bend;
}

/* How much smaller the overlap is at ``station`` [m] than the region's depth, plus the region's own gap
 * [m], with its derivatives [-, 1/m] and the wheel's 1/R_x [1/m]: as ``normal_gap``, for the open frame of a
 * pressed wheel.
 */
static OUT_OF_LINE int64_t pressed__pressed_gap(double* gap, double* rate, double* bend, double* curvature, array_double_1d work, array_double_1d tables, array_double_1d state, double station)
{
    int64_t rail;
    double way;
    double abscissa;
    int64_t trace;
    double estimate;
    double y;
    double overlap;
    double rise;
    double rise_rate;
    double found_curvature;
    int64_t found;
    (*cspan_at(&state, layout__STATE_NODE_COUNT)) += 1.0;
    rail = (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL)));
    way = station - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_STATION));
    abscissa = arc_length__rail_abscissa(tables, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__RAIL + layout__TRACE_ABSCISSA)), way);
    (*gap) = contact_plane__NO_GAP;
    (*rate) = 0.0;
    (*bend) = 0.0;
    (*curvature) = 1.0;
    if ((abscissa >= (*cspan_at(&tables, rail + layout__PROFILE_START))) && (abscissa <= (*cspan_at(&tables, rail + layout__PROFILE_STOP))))
    {
        trace = layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__WHEEL;
        estimate = (*cspan_at(&work, trace + layout__TRACE_ABSCISSA)) + way * (*cspan_at(&work, trace + layout__TRACE_RATE));
        pressed__normal_line(&y, &overlap, &rise, &rise_rate, &found_curvature, &found, work, tables, layout__WORK_CONTACT + layout__CONTACT_FRAME + (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLACE))), abscissa, estimate, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_HEIGHT)), pressed__NODE_SHARP);
        if (found == INT64_C(1))
        {
            (*gap) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAISED)) + (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_DEPTH)) - overlap;
            (*rate) = -rise;
            (*bend) = -rise_rate;
            (*curvature) = found_curvature;
            if (fabs(way) > pressed__LEAST_WAY)
            {
                (*cspan_at(&work, trace + layout__TRACE_RATE)) = (y - (*cspan_at(&work, trace + layout__TRACE_ABSCISSA))) / way;
            }
            (*cspan_at(&work, trace + layout__TRACE_ABSCISSA)) = y;
            (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__RAIL + layout__TRACE_ABSCISSA)) = abscissa;
            (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_STATION)) = station;
        }
    }
    return 0;
}
