/* Generated from tangent_zone_width.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of zone_width.py.
 */

#include "tangent_zone_width.h"

/* Tangent of ``width_limit``. */
static inline int64_t tangent_zone_width__width_limit_t(double* limit, double* limit_t, array_double_1d work, array_double_1d work_t, int64_t region, double direction, double direction_t)
{
    (*limit_t) = (*cspan_at(&work_t, region + layout__REGION_HIGH)) - (*cspan_at(&work_t, region + layout__REGION_STATION));
    (*limit) = (*cspan_at(&work, region + layout__REGION_HIGH)) - (*cspan_at(&work, region + layout__REGION_STATION));
    if (direction < 0.0)
    {
        (*limit_t) = (*cspan_at(&work_t, region + layout__REGION_STATION)) - (*cspan_at(&work_t, region + layout__REGION_LOW));
        (*limit) = (*cspan_at(&work, region + layout__REGION_STATION)) - (*cspan_at(&work, region + layout__REGION_LOW));
    }
    return 0;
}

/* Tangent of ``width_tolerance``. */
static inline int64_t tangent_zone_width__width_tolerance_t(double* tolerance, double* tolerance_t, double estimate, double estimate_t)
{
    (*tolerance_t) = zone_width__TRACE_OF_WIDTH * estimate_t;
    (*tolerance) = zone_width__TRACE_OF_WIDTH * estimate;
    if ((*tolerance) > zone_width__WIDTH_TRACE)
    {
        (*tolerance_t) = 0.0;
        (*tolerance) = zone_width__WIDTH_TRACE;
    }
    return 0;
}

/* Tangent of ``zone_width``. */
static inline int64_t tangent_zone_width__zone_width_t(double* result_0_0001, double* result_1_0001, array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t region, array_double_1d state, double direction, double direction_t, double level, double level_t, double estimate, double estimate_t)
{
    double v1;
    double v1_t;
    double limit_t;
    double limit;
    double v2;
    double v2_t;
    double tolerance_t;
    double tolerance;
    double v3;
    double root_t;
    double root;
    double low_t;
    double low;
    double high_t;
    double high;
    double width_t;
    double width;
    double station_t;
    double station;
    double abscissa_t;
    double abscissa;
    double y_t;
    double y;
    double near;
    int64_t i;
    double gap;
    double gap_t;
    double rate;
    double rate_t;
    double bend;
    double bend_t;
    double curvature;
    double curvature_t;
    double rise_t;
    double rise;
    double following_t;
    double following;
    double sharp;
    double v4;
    double v5;
    double square_t;
    double square;
    double v6;
    double v7;
    double v8;
    double v9;
    double v10;
    double newton_t;
    double newton;
    tangent_zone_width__width_limit_t(&v1, &v1_t, work, work_t, region, direction, direction_t);
    limit_t = v1_t;
    limit = v1;
    tangent_traces__start_traces_t(work, work_t, (*cspan_at(&work, region + layout__REGION_STATION)), (*cspan_at(&work_t, region + layout__REGION_STATION)), (*cspan_at(&work, region + layout__REGION_RAIL)), (*cspan_at(&work_t, region + layout__REGION_RAIL)), (*cspan_at(&work, region + layout__REGION_WHEEL)), (*cspan_at(&work_t, region + layout__REGION_WHEEL)));
    tangent_curves__open_origin_t(work, work_t, tables, region, 0.0, 0.0);
    tangent_zone_width__width_tolerance_t(&v2, &v2_t, estimate, estimate_t);
    tolerance_t = v2_t;
    tolerance = v2;
    v3 = sqrt(level);
    root_t = tangent_rates__root_rate(v3, level_t);
    root = v3;
    low_t = 0.0;
    low = 0.0;
    high_t = 0.0;
    high = -1.0;
    width_t = estimate_t;
    width = estimate;
    (*cspan_at(&work_t, region + layout__REGION_REACHED)) = 0.0;
    (*cspan_at(&work, region + layout__REGION_REACHED)) = 0.0;
    station_t = (*cspan_at(&work_t, region + layout__REGION_STATION));
    station = (*cspan_at(&work, region + layout__REGION_STATION));
    abscissa_t = (*cspan_at(&work_t, region + layout__REGION_RAIL));
    abscissa = (*cspan_at(&work, region + layout__REGION_RAIL));
    y_t = (*cspan_at(&work_t, region + layout__REGION_WHEEL));
    y = (*cspan_at(&work, region + layout__REGION_WHEEL));
    near = zone_width__WIDTH_SHARP;
    if ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PRESSED)) == 1.0)
    {
        near = zone_width__PRESSED_SHARP;
    }
    for (i = INT64_C(0); i < zone_width__WIDTH_ITERATIONS; i += INT64_C(1))
    {
        if (width > limit)
        {
            width_t = limit_t;
            width = limit;
        }
        tangent_separation__separation_t(&gap, &gap_t, &rate, &rate_t, &bend, &bend_t, &curvature, &curvature_t, work, work_t, tables, state, (*cspan_at(&work, region + layout__REGION_STATION)) + direction * width, (*cspan_at(&work_t, region + layout__REGION_STATION)) + (direction_t * width + direction * width_t), tolerance, tolerance_t);
        if (gap >= contact_plane__NO_GAP)
        {
            tangent_traces__start_traces_t(work, work_t, station, station_t, abscissa, abscissa_t, y, y_t);
        }
        else
        {
            station_t = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_STATION));
            station = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_STATION));
            abscissa_t = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__RAIL + layout__TRACE_ABSCISSA));
            abscissa = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__RAIL + layout__TRACE_ABSCISSA));
            y_t = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__WHEEL + layout__TRACE_ABSCISSA));
            y = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__WHEEL + layout__TRACE_ABSCISSA));
        }
        rise_t = gap_t - (*cspan_at(&work_t, region + layout__REGION_GAP));
        rise = gap - (*cspan_at(&work, region + layout__REGION_GAP));
        if (rise < level)
        {
            low_t = width_t;
            low = width;
            (*cspan_at(&work_t, region + layout__REGION_REACHED)) = rise_t;
            (*cspan_at(&work, region + layout__REGION_REACHED)) = rise;
            if (width >= limit)
            {
                (*result_0_0001) = limit;
                (*result_1_0001) = limit_t;
                return 0;
            }
        }
        else
        {
            high_t = width_t;
            high = width;
        }
        following_t = 2.0 * width_t;
        following = 2.0 * width;
        sharp = zone_width__HALVED_SHARP;
        if (high > 0.0)
        {
            v4 = low + high;
            following_t = 0.5 * (low_t + high_t);
            following = 0.5 * v4;
        }
        if ((rise > 0.0) && (rate * direction > 0.0))
        {
            v5 = sqrt(rise);
            square_t = tangent_rates__root_rate(v5, rise_t);
            square = v5;
            v6 = root - square;
            v7 = v6 * 2.0;
            v8 = v7 * square;
            v9 = rate * direction;
            v10 = v8 / v9;
            newton_t = width_t + ((root_t - square_t) * 2.0 * square + v7 * square_t - v10 * (rate_t * direction + rate * direction_t)) / v9;
            newton = width + v10;
            if ((newton > low) && (newton < 4.0 * width) && ((high < 0.0) || (newton < high)))
            {
                following_t = newton_t;
                following = newton;
                sharp = near;
            }
        }
        if (fabs(following - width) < sharp * width)
        {
            if (sharp == near)
            {
                (*cspan_at(&work_t, region + layout__REGION_REACHED)) = level_t;
                (*cspan_at(&work, region + layout__REGION_REACHED)) = level;
            }
            (*result_0_0001) = following;
            (*result_1_0001) = following_t;
            return 0;
        }
        width_t = following_t;
        width = following;
    }
    (*result_0_0001) = width;
    (*result_1_0001) = width_t;
    return 0;
}

/* Tangent of ``width_rule``. */
static inline int64_t tangent_zone_width__width_rule_t(double* width, double* width_t, array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t region, array_double_1d state, double direction, double direction_t, double level, double level_t, double estimate, double estimate_t)
{
    double v1;
    double v1_t;
    double v2;
    double v2_t;
    double limit_t;
    double limit;
    double inner;
    double v3;
    double v3_t;
    double tolerance_t;
    double tolerance;
    double gap;
    double gap_t;
    double rate;
    double rate_t;
    double rail_rate;
    double wheel_rate;
    double missing;
    double moved;
    double x_t;
    double x;
    double y_t;
    double y;
    double out;
    tangent_zone_width__zone_width_t(&v1, &v1_t, work, work_t, tables, region, state, direction, direction_t, level, level_t, estimate, estimate_t);
    (*width_t) = v1_t;
    (*width) = v1;
    tangent_zone_width__width_limit_t(&v2, &v2_t, work, work_t, region, direction, direction_t);
    limit_t = v2_t;
    limit = v2;
    if (((*width) < limit) && ((*cspan_at(&work, region + layout__REGION_REACHED)) != level))
    {
        inner = (*width) * (1.0 - 10.0 * zone_width__HALVED_SHARP);
        tangent_zone_width__width_tolerance_t(&v3, &v3_t, estimate, 0.0);
        tolerance_t = v3_t;
        tolerance = v3;
        tangent_zone_width__width_jet_t(&gap, &gap_t, &rate, &rate_t, work, work_t, tables, region, state, direction, direction_t, inner, 0.0, tolerance, tolerance_t);
        rail_rate = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__RAIL + layout__TRACE_ABSCISSA));
        wheel_rate = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__WHEEL + layout__TRACE_ABSCISSA));
        missing = level_t - gap_t + (*cspan_at(&work_t, region + layout__REGION_GAP));
        moved = 0.0;
        if (rate * direction > 0.0)
        {
            moved = missing / (rate * direction);
        }
        tangent_zone_width__width_jet_t(&gap, &gap_t, &rate, &rate_t, work, work_t, tables, region, state, direction, direction_t, inner, 1.0, tolerance, tolerance_t);
        x_t = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__RAIL + layout__TRACE_ABSCISSA));
        x = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__RAIL + layout__TRACE_ABSCISSA));
        y_t = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__WHEEL + layout__TRACE_ABSCISSA));
        y = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__WHEEL + layout__TRACE_ABSCISSA));
        out = x_t - rail_rate;
        if ((out != 0.0) && ((x < (*cspan_at(&tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))) + layout__PROFILE_START)) + zone_width__WIDTH_TRACE) || (x > (*cspan_at(&tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))) + layout__PROFILE_STOP)) - zone_width__WIDTH_TRACE)))
        {
            moved = (-rail_rate) / out;
        }
        out = y_t - wheel_rate;
        if ((out != 0.0) && ((y < (*cspan_at(&tables, (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL))) + layout__PROFILE_START)) + zone_width__WIDTH_TRACE) || (y > (*cspan_at(&tables, (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL))) + layout__PROFILE_STOP)) - zone_width__WIDTH_TRACE)))
        {
            moved = (-wheel_rate) / out;
        }
        tangent_zone_width__width_jet_t(&gap, &gap_t, &rate, &rate_t, work, work_t, tables, region, state, direction, direction_t, inner, moved, tolerance, tolerance_t);
        (*width_t) = moved;
        (*cspan_at(&work_t, region + layout__REGION_REACHED)) = gap_t - (*cspan_at(&work_t, region + layout__REGION_GAP));
    }
    return 0;
}

/* Tangent of ``width_jet``. */
static inline int64_t tangent_zone_width__width_jet_t(double* gap, double* gap_t, double* rate, double* rate_t, array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t region, array_double_1d state, double direction, double direction_t, double width, double width_t, double tolerance, double tolerance_t)
{
    double bend;
    double bend_t;
    double curvature;
    double curvature_t;
    tangent_traces__start_traces_t(work, work_t, (*cspan_at(&work, region + layout__REGION_STATION)), (*cspan_at(&work_t, region + layout__REGION_STATION)), (*cspan_at(&work, region + layout__REGION_RAIL)), (*cspan_at(&work_t, region + layout__REGION_RAIL)), (*cspan_at(&work, region + layout__REGION_WHEEL)), (*cspan_at(&work_t, region + layout__REGION_WHEEL)));
    tangent_separation__separation_t(gap, gap_t, rate, rate_t, &bend, &bend_t, &curvature, &curvature_t, work, work_t, tables, state, (*cspan_at(&work, region + layout__REGION_STATION)) + direction * width, (*cspan_at(&work_t, region + layout__REGION_STATION)) + (direction_t * width + direction * width_t), tolerance, tolerance_t);
    return 0;
}
