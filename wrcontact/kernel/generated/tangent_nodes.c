/* Generated from tangent_nodes.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of nodes.py.
 */

#include "tangent_nodes.h"

/* Tangent of ``trace_tolerance``. */
static inline int64_t tangent_nodes__trace_tolerance_t(double* tolerance, double* tolerance_t, double spacing, double spacing_t)
{
    (*tolerance_t) = nodes__TRACE_SHARE * spacing_t;
    (*tolerance) = nodes__TRACE_SHARE * spacing;
    if ((*tolerance) > nodes__COARSEST_TRACE)
    {
        (*tolerance_t) = 0.0;
        (*tolerance) = nodes__COARSEST_TRACE;
    }
    return 0;
}

/* Tangent of ``lay_nodes``. */
static inline int64_t tangent_nodes__lay_nodes_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, int64_t region, int64_t nodes, double low_reach, double low_reach_t, double high_reach, double high_reach_t)
{
    double v1;
    double v1_t;
    double gap;
    double gap_t;
    double rate;
    double rate_t;
    double bend;
    double bend_t;
    double curvature;
    double curvature_t;
    double v2;
    double v2_t;
    double v3;
    double v3_t;
    int64_t n4;
    int64_t before;
    int64_t n5;
    int64_t after;
    tangent_traces__start_traces_t(work, work_t, (*cspan_at(&work, region + layout__REGION_STATION)), (*cspan_at(&work_t, region + layout__REGION_STATION)), (*cspan_at(&work, region + layout__REGION_RAIL)), (*cspan_at(&work_t, region + layout__REGION_RAIL)), (*cspan_at(&work, region + layout__REGION_WHEEL)), (*cspan_at(&work_t, region + layout__REGION_WHEEL)));
    tangent_curves__open_origin_t(work, work_t, tables, region, (*cspan_at(&work, region + layout__REGION_SPACING)), (*cspan_at(&work_t, region + layout__REGION_SPACING)));
    tangent_nodes__trace_tolerance_t(&v1, &v1_t, (*cspan_at(&work, region + layout__REGION_SPACING)), (*cspan_at(&work_t, region + layout__REGION_SPACING)));
    tangent_separation__separation_t(&gap, &gap_t, &rate, &rate_t, &bend, &bend_t, &curvature, &curvature_t, work, work_t, tables, state, (*cspan_at(&work, region + layout__REGION_STATION)), (*cspan_at(&work_t, region + layout__REGION_STATION)), v1, v1_t);
    (*cspan_at(&work_t, nodes + layout__NODES_GAP + INT64_C(128) + INT64_C(0))) = 0.0;
    (*cspan_at(&work, nodes + layout__NODES_GAP + INT64_C(128) + INT64_C(0))) = 0.0;
    (*cspan_at(&work_t, nodes + layout__NODES_A + INT64_C(128) + INT64_C(0))) = 0.5 * curvature_t;
    (*cspan_at(&work, nodes + layout__NODES_A + INT64_C(128) + INT64_C(0))) = 0.5 * curvature;
    tangent_nodes__turn_cosine_t(&v2, &v2_t, work, work_t, tables);
    (*cspan_at(&work_t, nodes + layout__NODES_TURN + INT64_C(128) + INT64_C(0))) = v2_t;
    (*cspan_at(&work, nodes + layout__NODES_TURN + INT64_C(128) + INT64_C(0))) = v2;
    if ((int64_t)((*cspan_at(&tables, layout__TABLES_LATERAL))) != layout__LATERAL_ADAPTIVE)
    {
        tangent_lateral_curvature__relative_curvature_t(&v3, &v3_t, tables, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__WHEEL + layout__TRACE_ABSCISSA)), (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__WHEEL + layout__TRACE_ABSCISSA)), (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__RAIL + layout__TRACE_ABSCISSA)), (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__RAIL + layout__TRACE_ABSCISSA)));
        (*cspan_at(&work_t, nodes + layout__NODES_B + INT64_C(128) + INT64_C(0))) = v3_t;
        (*cspan_at(&work, nodes + layout__NODES_B + INT64_C(128) + INT64_C(0))) = v3;
    }
    n4 = tangent_nodes__lay_side_nodes_t(work, work_t, tables, state, region, nodes, -INT64_C(1), low_reach, low_reach_t, rate, rate_t);
    before = n4;
    (*cspan_at(&work_t, region + layout__REGION_FIRST)) = 0.0;
    (*cspan_at(&work, region + layout__REGION_FIRST)) = (double)(-before);
    n5 = tangent_nodes__lay_side_nodes_t(work, work_t, tables, state, region, nodes, INT64_C(1), high_reach, high_reach_t, rate, rate_t);
    after = n5;
    (*cspan_at(&work_t, region + layout__REGION_LAST)) = 0.0;
    (*cspan_at(&work, region + layout__REGION_LAST)) = (double)(after);
    return INT64_C(0);
}

/* Tangent of ``turn_cosine``. */
static inline int64_t tangent_nodes__turn_cosine_t(double* v4, double* result_1, array_double_1d work, array_double_1d work_t, array_double_1d tables)
{
    double height;
    double height_t;
    double slope;
    double slope_t;
    double v1;
    double v2;
    double v3;
    tangent_profile_table__height_slope_t(&height, &height_t, &slope, &slope_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__RAIL + layout__TRACE_ABSCISSA)), (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__RAIL + layout__TRACE_ABSCISSA)));
    v1 = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS)) + slope * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_SIN));
    v2 = 1.0 + slope * slope;
    v3 = sqrt(v2);
    (*v4) = v1 / v3;
    (*result_1) = ((*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS)) + (slope_t * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_SIN)) + slope * (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_SIN))) - (*v4) * tangent_rates__root_rate(v3, slope_t * slope + slope * slope_t)) / v3;
    return 0;
}

/* Tangent of ``bring_nearer``. */
static inline int64_t tangent_nodes__bring_nearer_t(array_double_1d work, array_double_1d work_t, int64_t region, int64_t nodes)
{
    int64_t k_end;
    int64_t k;
    double level_t;
    double level;
    double v1;
    double v2;
    k_end = (int64_t)((*cspan_at(&work, region + layout__REGION_LAST))) + INT64_C(1);
    for (k = (int64_t)((*cspan_at(&work, region + layout__REGION_FIRST))); k < k_end; k += INT64_C(1))
    {
        level_t = (*cspan_at(&work_t, region + layout__REGION_LOCAL_PENETRATION)) - (*cspan_at(&work_t, nodes + layout__NODES_GAP + INT64_C(128) + k));
        level = (*cspan_at(&work, region + layout__REGION_LOCAL_PENETRATION)) - (*cspan_at(&work, nodes + layout__NODES_GAP + INT64_C(128) + k));
        if ((level > 0.0) && ((*cspan_at(&work, nodes + layout__NODES_TURN + INT64_C(128) + k)) > nodes__LEAST_TURN))
        {
            v1 = 1.0 / (*cspan_at(&work, nodes + layout__NODES_TURN + INT64_C(128) + k));
            v2 = v1 - 1.0;
            (*cspan_at(&work_t, nodes + layout__NODES_GAP + INT64_C(128) + k)) = (*cspan_at(&work_t, nodes + layout__NODES_GAP + INT64_C(128) + k)) - (level_t * v2 + level * ((-v1) * (*cspan_at(&work_t, nodes + layout__NODES_TURN + INT64_C(128) + k)) / (*cspan_at(&work, nodes + layout__NODES_TURN + INT64_C(128) + k))));
            (*cspan_at(&work, nodes + layout__NODES_GAP + INT64_C(128) + k)) = (*cspan_at(&work, nodes + layout__NODES_GAP + INT64_C(128) + k)) - level * v2;
        }
    }
    return INT64_C(0);
}

/* Tangent of ``trace_node``. */
static inline int64_t tangent_nodes__trace_node_t(double* gap, double* gap_t, double* rate, double* rate_t, array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, int64_t region, int64_t nodes, int64_t at)
{
    double v1;
    double station_t;
    double station;
    double v2;
    double v2_t;
    double bend;
    double bend_t;
    double curvature;
    double curvature_t;
    double v3;
    double v3_t;
    double v4;
    double v4_t;
    v1 = (double)(at);
    station_t = (*cspan_at(&work_t, region + layout__REGION_STATION)) + (*cspan_at(&work_t, region + layout__REGION_SPACING)) * v1;
    station = (*cspan_at(&work, region + layout__REGION_STATION)) + (*cspan_at(&work, region + layout__REGION_SPACING)) * v1;
    tangent_nodes__trace_tolerance_t(&v2, &v2_t, (*cspan_at(&work, region + layout__REGION_SPACING)), (*cspan_at(&work_t, region + layout__REGION_SPACING)));
    tangent_separation__separation_t(gap, gap_t, rate, rate_t, &bend, &bend_t, &curvature, &curvature_t, work, work_t, tables, state, station, station_t, v2, v2_t);
    if ((*gap) < contact_plane__NO_GAP)
    {
        (*cspan_at(&work_t, nodes + layout__NODES_GAP + INT64_C(128) + at)) = (*gap_t) - (*cspan_at(&work_t, region + layout__REGION_GAP));
        (*cspan_at(&work, nodes + layout__NODES_GAP + INT64_C(128) + at)) = (*gap) - (*cspan_at(&work, region + layout__REGION_GAP));
        (*cspan_at(&work_t, nodes + layout__NODES_A + INT64_C(128) + at)) = 0.5 * curvature_t;
        (*cspan_at(&work, nodes + layout__NODES_A + INT64_C(128) + at)) = 0.5 * curvature;
        tangent_nodes__turn_cosine_t(&v3, &v3_t, work, work_t, tables);
        (*cspan_at(&work_t, nodes + layout__NODES_TURN + INT64_C(128) + at)) = v3_t;
        (*cspan_at(&work, nodes + layout__NODES_TURN + INT64_C(128) + at)) = v3;
        if ((int64_t)((*cspan_at(&tables, layout__TABLES_LATERAL))) != layout__LATERAL_ADAPTIVE)
        {
            tangent_lateral_curvature__relative_curvature_t(&v4, &v4_t, tables, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__WHEEL + layout__TRACE_ABSCISSA)), (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__WHEEL + layout__TRACE_ABSCISSA)), (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__RAIL + layout__TRACE_ABSCISSA)), (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__RAIL + layout__TRACE_ABSCISSA)));
            (*cspan_at(&work_t, nodes + layout__NODES_B + INT64_C(128) + at)) = v4_t;
            (*cspan_at(&work, nodes + layout__NODES_B + INT64_C(128) + at)) = v4;
        }
    }
    return 0;
}

/* Tangent of ``lay_side_nodes``. */
static inline int64_t tangent_nodes__lay_side_nodes_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, int64_t region, int64_t nodes, int64_t direction, double reach, double reach_t, double rate, double rate_t)
{
    int64_t stride;
    int64_t window;
    int64_t k;
    int64_t traced;
    int64_t step;
    int64_t left;
    int64_t ended;
    double gap;
    double gap_t;
    double next_rate;
    double next_rate_t;
    double v1;
    int64_t start;
    int64_t at;
    double v2;
    double station_t;
    double station;
    int64_t passed;
    tangent_traces__start_traces_t(work, work_t, (*cspan_at(&work, region + layout__REGION_STATION)), (*cspan_at(&work_t, region + layout__REGION_STATION)), (*cspan_at(&work, region + layout__REGION_RAIL)), (*cspan_at(&work_t, region + layout__REGION_RAIL)), (*cspan_at(&work, region + layout__REGION_WHEEL)), (*cspan_at(&work_t, region + layout__REGION_WHEEL)));
    stride = nodes__node_stride(tables);
    window = nodes__window_nodes(tables);
    k = INT64_C(0);
    traced = INT64_C(0);
    step = stride;
    left = window;
    passed = INT64_C(0);
    ended = INT64_C(0);
    while((left > INT64_C(0)) && (k < layout__NODE_LIMIT - layout__NODE_MIDDLE - INT64_C(2) - stride))
    {
        if ((k == traced) && (ended == INT64_C(0)))
        {
            tangent_nodes__trace_node_t(&gap, &gap_t, &next_rate, &next_rate_t, work, work_t, tables, state, region, nodes, direction * (traced + step));
            if ((gap >= contact_plane__NO_GAP) && (step > INT64_C(1)))
            {
                step = INT64_C(1);
                tangent_traces__start_traces_t(work, work_t, (*cspan_at(&work, region + layout__REGION_STATION)), (*cspan_at(&work_t, region + layout__REGION_STATION)), (*cspan_at(&work, region + layout__REGION_RAIL)), (*cspan_at(&work_t, region + layout__REGION_RAIL)), (*cspan_at(&work, region + layout__REGION_WHEEL)), (*cspan_at(&work_t, region + layout__REGION_WHEEL)));
                tangent_nodes__trace_node_t(&gap, &gap_t, &next_rate, &next_rate_t, work, work_t, tables, state, region, nodes, direction * (traced + step));
            }
            if (gap >= contact_plane__NO_GAP)
            {
                ended = INT64_C(1);
                v1 = (double)(direction * k);
                tangent_nodes__end_region_t(work, work_t, region, direction, (*cspan_at(&work, region + layout__REGION_STATION)) + (*cspan_at(&work, region + layout__REGION_SPACING)) * v1, (*cspan_at(&work_t, region + layout__REGION_STATION)) + (*cspan_at(&work_t, region + layout__REGION_SPACING)) * v1);
            }
            else
            {
                start = direction * traced;
                tangent_nodes__fill_between_t(work, work_t, nodes, start, start + direction * step, step, (*cspan_at(&work, region + layout__REGION_SPACING)), (*cspan_at(&work_t, region + layout__REGION_SPACING)), rate, rate_t, next_rate, next_rate_t);
                rate_t = next_rate_t;
                rate = next_rate;
                traced = traced + step;
            }
        }
        k = k + INT64_C(1);
        at = direction * k;
        v2 = (double)(at);
        station_t = (*cspan_at(&work_t, region + layout__REGION_STATION)) + (*cspan_at(&work_t, region + layout__REGION_SPACING)) * v2;
        station = (*cspan_at(&work, region + layout__REGION_STATION)) + (*cspan_at(&work, region + layout__REGION_SPACING)) * v2;
        if (ended == INT64_C(1))
        {
            tangent_nodes__extrapolate_node_t(work, work_t, nodes, at, direction);
            if ((int64_t)((*cspan_at(&tables, layout__TABLES_LATERAL))) != layout__LATERAL_ADAPTIVE)
            {
                (*cspan_at(&work_t, nodes + layout__NODES_B + INT64_C(128) + at)) = (*cspan_at(&work_t, nodes + layout__NODES_B + INT64_C(128) + (at - direction)));
                (*cspan_at(&work, nodes + layout__NODES_B + INT64_C(128) + at)) = (*cspan_at(&work, nodes + layout__NODES_B + INT64_C(128) + (at - direction)));
            }
        }
        if (passed > INT64_C(0))
        {
            left = left - INT64_C(1);
        }
        else if ((ended == INT64_C(1)) || ((*cspan_at(&work, nodes + layout__NODES_GAP + INT64_C(128) + at)) > reach))
        {
            passed = k;
        }
        else if ((station > (*cspan_at(&work, region + layout__REGION_HIGH))) || (station < (*cspan_at(&work, region + layout__REGION_LOW))))
        {
            passed = k;
        }
    }
    if (passed == INT64_C(0))
    {
        passed = k - window;
    }
    return passed;
}

/* Tangent of ``fill_straight``. */
static inline int64_t tangent_nodes__fill_straight_t(array_double_1d work, array_double_1d work_t, int64_t values, int64_t start, int64_t stop, int64_t count)
{
    int64_t inward;
    double v1;
    double v2;
    double rise_t;
    double rise;
    int64_t i;
    double v3;
    inward = INT64_C(1);
    if (stop < start)
    {
        inward = -INT64_C(1);
    }
    v1 = (*cspan_at(&work, values + INT64_C(128) + stop)) - (*cspan_at(&work, values + INT64_C(128) + start));
    v2 = (double)(count);
    rise_t = ((*cspan_at(&work_t, values + INT64_C(128) + stop)) - (*cspan_at(&work_t, values + INT64_C(128) + start))) / v2;
    rise = v1 / v2;
    for (i = INT64_C(1); i < count; i += INT64_C(1))
    {
        v3 = (double)(i);
        (*cspan_at(&work_t, values + INT64_C(128) + (start + inward * i))) = (*cspan_at(&work_t, values + INT64_C(128) + start)) + rise_t * v3;
        (*cspan_at(&work, values + INT64_C(128) + (start + inward * i))) = (*cspan_at(&work, values + INT64_C(128) + start)) + rise * v3;
    }
    return INT64_C(0);
}

/* Tangent of ``fill_between``. */
static inline int64_t tangent_nodes__fill_between_t(array_double_1d work, array_double_1d work_t, int64_t nodes, int64_t start, int64_t stop, int64_t count, double spacing, double spacing_t, double start_rate, double start_rate_t, double stop_rate, double stop_rate_t)
{
    double low_t;
    double low;
    double rise_t;
    double rise;
    double v1;
    double width_t;
    double width;
    double forward_t;
    double forward;
    double backward_t;
    double backward;
    int64_t inward;
    int64_t i;
    double x;
    double rest;
    double v2;
    double v3;
    double gap_t;
    double gap;
    low_t = (*cspan_at(&work_t, nodes + layout__NODES_GAP + INT64_C(128) + start));
    low = (*cspan_at(&work, nodes + layout__NODES_GAP + INT64_C(128) + start));
    rise_t = (*cspan_at(&work_t, nodes + layout__NODES_GAP + INT64_C(128) + stop)) - low_t;
    rise = (*cspan_at(&work, nodes + layout__NODES_GAP + INT64_C(128) + stop)) - low;
    v1 = (double)(stop - start);
    width_t = spacing_t * v1;
    width = spacing * v1;
    forward_t = start_rate_t * width + start_rate * width_t - rise_t;
    forward = start_rate * width - rise;
    backward_t = stop_rate_t * width + stop_rate * width_t - rise_t;
    backward = stop_rate * width - rise;
    inward = INT64_C(1);
    if (stop < start)
    {
        inward = -INT64_C(1);
    }
    for (i = INT64_C(1); i < count; i += INT64_C(1))
    {
        x = (double)(i) / (double)(count);
        rest = 1.0 - x;
        v2 = rest * forward - x * backward;
        v3 = rise + rest * v2;
        gap_t = low_t + x * (rise_t + rest * (rest * forward_t - x * backward_t));
        gap = low + x * v3;
        if (gap < 0.0)
        {
            gap_t = 0.0;
            gap = 0.0;
        }
        (*cspan_at(&work_t, nodes + layout__NODES_GAP + INT64_C(128) + (start + inward * i))) = gap_t;
        (*cspan_at(&work, nodes + layout__NODES_GAP + INT64_C(128) + (start + inward * i))) = gap;
    }
    tangent_nodes__fill_straight_t(work, work_t, nodes + layout__NODES_A, start, stop, count);
    tangent_nodes__fill_straight_t(work, work_t, nodes + layout__NODES_TURN, start, stop, count);
    return INT64_C(0);
}

/* Tangent of ``end_region``. */
static inline int64_t tangent_nodes__end_region_t(array_double_1d work, array_double_1d work_t, int64_t region, int64_t direction, double station, double station_t)
{
    if (direction > INT64_C(0))
    {
        if (station + (*cspan_at(&work, region + layout__REGION_SPACING)) < (*cspan_at(&work, region + layout__REGION_HIGH)))
        {
            (*cspan_at(&work_t, region + layout__REGION_HIGH)) = station_t;
            (*cspan_at(&work, region + layout__REGION_HIGH)) = station;
        }
    }
    else if (station - (*cspan_at(&work, region + layout__REGION_SPACING)) > (*cspan_at(&work, region + layout__REGION_LOW)))
    {
        (*cspan_at(&work_t, region + layout__REGION_LOW)) = station_t;
        (*cspan_at(&work, region + layout__REGION_LOW)) = station;
    }
    return INT64_C(0);
}

/* Tangent of ``extrapolate_node``. */
static inline int64_t tangent_nodes__extrapolate_node_t(array_double_1d work, array_double_1d work_t, int64_t nodes, int64_t at, int64_t direction)
{
    int64_t one;
    int64_t two;
    one = at - direction;
    if (at * direction > INT64_C(2))
    {
        two = one - direction;
        (*cspan_at(&work_t, nodes + layout__NODES_GAP + INT64_C(128) + at)) = 3.0 * (*cspan_at(&work_t, nodes + layout__NODES_GAP + INT64_C(128) + one)) - 3.0 * (*cspan_at(&work_t, nodes + layout__NODES_GAP + INT64_C(128) + two)) + (*cspan_at(&work_t, nodes + layout__NODES_GAP + INT64_C(128) + (two - direction)));
        (*cspan_at(&work, nodes + layout__NODES_GAP + INT64_C(128) + at)) = 3.0 * (*cspan_at(&work, nodes + layout__NODES_GAP + INT64_C(128) + one)) - 3.0 * (*cspan_at(&work, nodes + layout__NODES_GAP + INT64_C(128) + two)) + (*cspan_at(&work, nodes + layout__NODES_GAP + INT64_C(128) + (two - direction)));
    }
    else
    {
        (*cspan_at(&work_t, nodes + layout__NODES_GAP + INT64_C(128) + at)) = (*cspan_at(&work_t, nodes + layout__NODES_GAP + INT64_C(128) + one));
        (*cspan_at(&work, nodes + layout__NODES_GAP + INT64_C(128) + at)) = (*cspan_at(&work, nodes + layout__NODES_GAP + INT64_C(128) + one));
    }
    (*cspan_at(&work_t, nodes + layout__NODES_A + INT64_C(128) + at)) = (*cspan_at(&work_t, nodes + layout__NODES_A + INT64_C(128) + one));
    (*cspan_at(&work, nodes + layout__NODES_A + INT64_C(128) + at)) = (*cspan_at(&work, nodes + layout__NODES_A + INT64_C(128) + one));
    (*cspan_at(&work_t, nodes + layout__NODES_TURN + INT64_C(128) + at)) = (*cspan_at(&work_t, nodes + layout__NODES_TURN + INT64_C(128) + one));
    (*cspan_at(&work, nodes + layout__NODES_TURN + INT64_C(128) + at)) = (*cspan_at(&work, nodes + layout__NODES_TURN + INT64_C(128) + one));
    return INT64_C(0);
}
