/* Generated from contact/pressed.py by tools/transpile_kernel.py; change that one.
 *
 * The overlap of a wheel that is pressed into its rail, along the rail's own normals.
 *
 * A wheel that comes down meets every part of the rail along another normal.  Where a patch reaches around a corner one plane
 * cannot hold that; so the overlap o of a pressed wheel is measured along the normal of each rail point x, to where that line
 * meets the wheel's outline (Y, Z) as it stands,
 *
 *     Y - x + (Z - z_rail(x)) m = 0,   o = (Z - z_rail - m (Y - x)) / sqrt(1 + m^2),   m = z_rail'(x)
 *
 * and stations run along the rail, by its arc length.  With slope m_w of the outline there and kappa of the rail
 *
 *     do/ds = (m_w - m) / (1 + m m_w)
 *
 * but for a factor 1 - kappa o, below 1 % and left out: kappa jumps where profiles are joined, and a slope must not.  The
 * deepest point of a region is a pair of points with one normal, and o does not ask where stations begin.
 */

#include "pressed.h"

/* Wheel abscissa [m] where the rail's normal at ``abscissa`` meets the wheel placed at ``at`` and moved down by
 * ``height``, looked for from ``y``; the overlap [m], its derivatives [-, 1/m] along the rail's arc, the wheel's 1/R_x [1/m];
 * and 1 if there is such a point, else 0.
 */
static OUT_OF_LINE int64_t pressed__normal_line(double* result_0_0001, double* result_1, double* result_2, double* result_3_0001, double* result_4, int64_t* result_5_0001, array_double_1d tables, array_double_1d work, int64_t at, double abscissa, double y, double height)
{
    int64_t rail;
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
    double rest;
    double along;
    double move;
    double sharp;
    double overlap;
    double tangent;
    double wheel_cos;
    double wheel_kappa;
    double steep;
    double turn;
    double curvature;
    rail = (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL)));
    wheel = (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL)));
    profile_table__height_slope_bend(&z_rail, &m, &rail_bend, tables, rail, abscissa);
    cosine = 1.0 / sqrt(1.0 + m * m);
    kappa = rail_bend * cosine * cosine * cosine;
    for (i = INT64_C(0); i < pressed__LINE_ITERATIONS; i += INT64_C(1))
    {
        profile_table__height_slope_bend(&z, &slope, &bend, tables, wheel, y);
        locus__outline_jet(&y_track, &z_track, &outline_slope, &stretch, &rate, work, at, y, z, slope, bend);
        across = y_track - (*cspan_at(&tables, layout__TABLES_RAIL_Y)) - abscissa;
        down = z_track + height - z_rail;
        rest = across + down * m;
        along = stretch * (1.0 + m * outline_slope);
        if (!((along > 0.0) && (stretch > 0.0)))
        {
            (*result_0_0001) = y;
            (*result_1) = 0.0;
            (*result_2) = 0.0;
            (*result_3_0001) = 0.0;
            (*result_4) = 0.0;
            (*result_5_0001) = INT64_C(0);
            return 0;
        }
        move = (-rest) / along;
        sharp = pressed__LINE_SHARP;
        if (i == pressed__LINE_ITERATIONS - INT64_C(1))
        {
            /* at a joint of the profile Newton's method can go to and fro between both sides */
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
                (*result_5_0001) = INT64_C(0);
                return 0;
            }
            tangent = (outline_slope - m) / (1.0 + m * outline_slope);
            /* the angle between both curves turns by the wheel's curvature over its own arc less the rail's */
            wheel_cos = 1.0 / sqrt(1.0 + outline_slope * outline_slope);
            wheel_kappa = rate / stretch * wheel_cos * wheel_cos * wheel_cos;
            steep = 1.0 + tangent * tangent;
            turn = wheel_kappa * sqrt(steep) - kappa;
            curvature = contact_plane__longitudinal_curvature(tables, work, at, z, slope, pressed__mean_bend(tables, work, y, bend));
            (*result_0_0001) = y;
            (*result_1) = overlap;
            (*result_2) = tangent;
            (*result_3_0001) = steep * turn;
            (*result_4) = curvature;
            (*result_5_0001) = INT64_C(1);
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
            (*result_5_0001) = INT64_C(0);
            return 0;
        }
    }
    (*result_0_0001) = y;
    (*result_1) = 0.0;
    (*result_2) = 0.0;
    (*result_3_0001) = 0.0;
    (*result_4) = 0.0;
    (*result_5_0001) = INT64_C(0);
    return 0;
}

/* Second derivative of the wheel profile [1/m] at ``y``, averaged over FRAME_BLUR to either side where that is set.
 *
 * With yaw it is part of the longitudinal curvature; taken at a point, it would jump when a profile's joint passes a node.
 */
static OUT_OF_LINE double pressed__mean_bend(array_double_1d tables, array_double_1d work, double y, double bend)
{
    double blur;
    int64_t wheel;
    double low;
    double high;
    double z;
    double low_slope;
    double high_slope;
    blur = (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_BLUR));
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

/* Arc length per abscissa of the rail [-]. */
static OUT_OF_LINE double pressed__rail_speed(array_double_1d tables, double abscissa)
{
    double height;
    double slope;
    profile_table__height_slope(&height, &slope, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), abscissa);
    return sqrt(1.0 + slope * slope);
}

/* Length of the rail profile between two abscissae [m], negative where ``stop`` is the smaller. */
static OUT_OF_LINE double pressed__rail_length(array_double_1d tables, double start, double stop)
{
    int64_t cells;
    double step;
    double total;
    double low;
    int64_t i;
    double begin;
    double middle;
    double high;
    cells = (int64_t)(fabs(stop - start) / pressed__ARC_STEP) + INT64_C(1);
    step = (stop - start) / (double)(cells);
    total = 0.0;
    low = pressed__rail_speed(tables, start);
    for (i = INT64_C(0); i < cells; i += INT64_C(1))
    {
        begin = start + step * (double)(i);
        middle = pressed__rail_speed(tables, begin + 0.5 * step);
        high = pressed__rail_speed(tables, begin + step);
        total += low + 4.0 * middle + high;
        low = high;
    }
    return total * step / 6.0;
}

/* Abscissa [m] of the rail at ``length`` [m] of arc from ``start``: in steps of no more than ARC_STEP, each a parabola's
 * guess put right by Newton's method on Simpson's rule.
 */
static OUT_OF_LINE double pressed__rail_abscissa(array_double_1d tables, double start, double length)
{
    int64_t steps;
    double way;
    int64_t step;
    double height;
    double slope;
    double bend;
    double before;
    double cosine;
    double following;
    int64_t i;
    double middle;
    double after;
    double move;
    double x;
    steps = (int64_t)(fabs(length) / pressed__ARC_STEP) + INT64_C(1);
    way = length / (double)(steps);
    x = start;
    for (step = INT64_C(0); step < steps; step += INT64_C(1))
    {
        profile_table__height_slope_bend(&height, &slope, &bend, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), x);
        before = sqrt(1.0 + slope * slope);
        cosine = 1.0 / before;
        following = x + way * cosine * (1.0 - 0.5 * way * slope * bend * cosine * cosine * cosine);
        for (i = INT64_C(0); i < pressed__LINE_ITERATIONS; i += INT64_C(1))
        {
            middle = pressed__rail_speed(tables, 0.5 * (x + following));
            after = pressed__rail_speed(tables, following);
            move = (way - (following - x) * (before + 4.0 * middle + after) / 6.0) / after;
            following += move;
            if (fabs(move) < pressed__ARC_SHARP)
            {
                break;
            }
        }
        x = following;
    }
    return x;
}

/* What the overlap lacks of the region's depth at ``station`` [m], raised by the region's own gap, with its derivatives
 * [-, 1/m] and the wheel's 1/R_x [1/m]: as ``normal_gap``, for the open frame of a pressed wheel.
 */
static OUT_OF_LINE int64_t pressed__pressed_gap(double* gap, double* rate, double* bend, double* curvature, array_double_1d tables, array_double_1d work, array_double_1d state, double station)
{
    int64_t rail;
    double way;
    double abscissa;
    double y;
    double overlap;
    double rise;
    double turn;
    double found_curvature;
    int64_t found;
    (*cspan_at(&state, layout__STATE_NODE_COUNT)) += 1.0;
    rail = (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL)));
    way = station - (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_STATION));
    abscissa = pressed__rail_abscissa(tables, (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_RAIL)), way);
    (*gap) = contact_plane__NO_GAP;
    (*rate) = 0.0;
    (*bend) = 0.0;
    (*curvature) = 1.0;
    if ((abscissa >= (*cspan_at(&tables, rail + layout__PROFILE_START))) && (abscissa <= (*cspan_at(&tables, rail + layout__PROFILE_STOP))))
    {
        pressed__normal_line(&y, &overlap, &rise, &turn, &found_curvature, &found, tables, work, (int64_t)((*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_PLACE))), abscissa, (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_WHEEL)) + way * (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_WHEEL_RATE)), (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_POSE)));
        if (found == INT64_C(1))
        {
            (*gap) = (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_RAISED)) + (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_DEPTH)) - overlap;
            (*rate) = -rise;
            (*bend) = -turn;
            (*curvature) = found_curvature;
            if (fabs(way) > pressed__LEAST_WAY)
            {
                (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_WHEEL_RATE)) = (y - (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_WHEEL))) / way;
            }
            (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_WHEEL)) = y;
            (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_RAIL)) = abscissa;
            (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_STATION)) = station;
        }
    }
    return 0;
}
