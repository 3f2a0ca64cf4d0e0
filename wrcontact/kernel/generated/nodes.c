/* Generated from normal/nodes.py by tools/transpile_kernel.py; change that one.
 *
 * Nodes across a region: gap, longitudinal curvature, and a prepared lateral curvature.
 *
 * Nodes are anchored at the minimum of the region, station + k h, with h a fixed share of the half-width of the
 * interpenetration. So a result depends on the pose alone and is smooth in it.
 */

#include "nodes.h"

/* Half the width of the window of the lateral curvature, in nodes. */
static inline int64_t nodes__window_nodes(array_double_1d tables)
{
    int64_t result;
    result = (int64_t)((int64_t)((*cspan_at(&tables, layout__TABLES_NODES))) * nodes__WINDOW + 0.5);
    return result;
}

/* Every so many of the nodes are traced on the profiles.
 *
 * All of them are traced where curvatures are read there, where chords lead to them, and for vertical
 * distances: on a steep side these rise too fast for a cubic over several nodes, which falls below zero
 * before.
 */
static inline int64_t nodes__node_stride(array_double_1d tables)
{
    int64_t kind;
    int64_t stride;
    stride = (int64_t)((*cspan_at(&tables, layout__TABLES_STRIDE)));
    kind = (int64_t)((*cspan_at(&tables, layout__TABLES_SEPARATION)));
    if ((kind == layout__SEPARATION_EQUIDISTANT_CHORD) || (kind == layout__SEPARATION_VERTICAL))
    {
        stride = INT64_C(1);
    }
    if ((int64_t)((*cspan_at(&tables, layout__TABLES_LATERAL))) != layout__LATERAL_ADAPTIVE)
    {
        stride = INT64_C(1);
    }
    return stride;
}

/* To what the abscissae of nodes with this ``spacing`` are traced [m]. */
static inline double nodes__trace_tolerance(double spacing)
{
    double tolerance;
    tolerance = nodes__TRACE_SHARE * spacing;
    if (tolerance > nodes__COARSEST_TRACE)
    {
        tolerance = nodes__COARSEST_TRACE;
    }
    return tolerance;
}

/* Gap and A at the nodes of a region, until the gap has risen above ``low_reach`` or ``high_reach`` [m]
 * on that side or the bound is passed, and so many nodes further as the window of the lateral curvature
 * needs.
 *
 * Where the lateral curvature is a prepared one, it is kept in nodes.B for
 * :func:`node_coefficients.weigh_nodes`.
 */
static inline int64_t nodes__lay_nodes(array_double_1d work, array_double_1d tables, array_double_1d state, int64_t region, int64_t nodes, double low_reach, double high_reach)
{
    double gap;
    double rate;
    double bend;
    double curvature;
    int64_t before;
    int64_t after;
    traces__start_traces(work, (*cspan_at(&work, region + layout__REGION_STATION)), (*cspan_at(&work, region + layout__REGION_RAIL)), (*cspan_at(&work, region + layout__REGION_WHEEL)));
    curves__open_origin(work, tables, region, (*cspan_at(&work, region + layout__REGION_SPACING)));
    separation__separation(&gap, &rate, &bend, &curvature, work, tables, state, (*cspan_at(&work, region + layout__REGION_STATION)), nodes__trace_tolerance((*cspan_at(&work, region + layout__REGION_SPACING))));
    (*cspan_at(&work, nodes + layout__NODES_GAP + INT64_C(128) + INT64_C(0))) = 0.0;
    (*cspan_at(&work, nodes + layout__NODES_A + INT64_C(128) + INT64_C(0))) = 0.5 * curvature;
    (*cspan_at(&work, nodes + layout__NODES_TURN + INT64_C(128) + INT64_C(0))) = nodes__turn_cosine(work, tables);
    if ((int64_t)((*cspan_at(&tables, layout__TABLES_LATERAL))) != layout__LATERAL_ADAPTIVE)
    {
        (*cspan_at(&work, nodes + layout__NODES_B + INT64_C(128) + INT64_C(0))) = lateral_curvature__relative_curvature(tables, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__WHEEL + layout__TRACE_ABSCISSA)), (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__RAIL + layout__TRACE_ABSCISSA)));
    }
    before = nodes__lay_side_nodes(work, tables, state, region, nodes, -INT64_C(1), low_reach, rate);
    (*cspan_at(&work, region + layout__REGION_FIRST)) = (double)(-before);
    after = nodes__lay_side_nodes(work, tables, state, region, nodes, INT64_C(1), high_reach, rate);
    (*cspan_at(&work, region + layout__REGION_LAST)) = (double)(after);
    return INT64_C(0);
}

/* Cosine of the angle between the rail's normal at the present trace and that of the open frame. */
static inline double nodes__turn_cosine(array_double_1d work, array_double_1d tables)
{
    double height;
    double slope;
    double result;
    profile_table__height_slope(&height, &slope, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__RAIL + layout__TRACE_ABSCISSA)));
    result = ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS)) + slope * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_SIN))) / sqrt(1.0 + slope * slope);
    return result;
}

/* Let the gap rise less where a region turns.
 *
 * A load displaces the surface beside it along the normal there by the cosine of the angle between the two
 * normals, so that what the load in the middle displaces is missing there: of the level that is left at a
 * node, the share 1 / cosine - 1 counts less as gap.
 */
static inline int64_t nodes__bring_nearer(array_double_1d work, int64_t region, int64_t nodes)
{
    int64_t k_end;
    int64_t k;
    double level;
    k_end = (int64_t)((*cspan_at(&work, region + layout__REGION_LAST))) + INT64_C(1);
    for (k = (int64_t)((*cspan_at(&work, region + layout__REGION_FIRST))); k < k_end; k += INT64_C(1))
    {
        level = (*cspan_at(&work, region + layout__REGION_LOCAL_PENETRATION)) - (*cspan_at(&work, nodes + layout__NODES_GAP + INT64_C(128) + k));
        if ((level > 0.0) && ((*cspan_at(&work, nodes + layout__NODES_TURN + INT64_C(128) + k)) > nodes__LEAST_TURN))
        {
            (*cspan_at(&work, nodes + layout__NODES_GAP + INT64_C(128) + k)) -= level * (1.0 / (*cspan_at(&work, nodes + layout__NODES_TURN + INT64_C(128) + k)) - 1.0);
        }
    }
    return INT64_C(0);
}

/* Trace node ``at`` on the profiles; its gap [m], NO_GAP where a profile has ended, and the gap's rate
 * [-].
 */
static inline int64_t nodes__trace_node(double* gap, double* rate, array_double_1d work, array_double_1d tables, array_double_1d state, int64_t region, int64_t nodes, int64_t at)
{
    double station;
    double bend;
    double curvature;
    station = (*cspan_at(&work, region + layout__REGION_STATION)) + (*cspan_at(&work, region + layout__REGION_SPACING)) * (double)(at);
    separation__separation(gap, rate, &bend, &curvature, work, tables, state, station, nodes__trace_tolerance((*cspan_at(&work, region + layout__REGION_SPACING))));
    if ((*gap) < contact_plane__NO_GAP)
    {
        (*cspan_at(&work, nodes + layout__NODES_GAP + INT64_C(128) + at)) = (*gap) - (*cspan_at(&work, region + layout__REGION_GAP));
        (*cspan_at(&work, nodes + layout__NODES_A + INT64_C(128) + at)) = 0.5 * curvature;
        (*cspan_at(&work, nodes + layout__NODES_TURN + INT64_C(128) + at)) = nodes__turn_cosine(work, tables);
        if ((int64_t)((*cspan_at(&tables, layout__TABLES_LATERAL))) != layout__LATERAL_ADAPTIVE)
        {
            (*cspan_at(&work, nodes + layout__NODES_B + INT64_C(128) + at)) = lateral_curvature__relative_curvature(tables, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__WHEEL + layout__TRACE_ABSCISSA)), (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__RAIL + layout__TRACE_ABSCISSA)));
        }
    }
    return 0;
}

/* Nodes in ``direction`` from the minimum, where the gap has this ``rate``; how many until the gap has
 * risen above ``reach`` [m] or the bound is passed.
 *
 * Every so many nodes one is traced (``node_stride``); those between are read off the cubic through gap and
 * slope there.
 */
static inline int64_t nodes__lay_side_nodes(array_double_1d work, array_double_1d tables, array_double_1d state, int64_t region, int64_t nodes, int64_t direction, double reach, double rate)
{
    int64_t stride;
    int64_t window;
    int64_t k;
    int64_t traced;
    int64_t step;
    int64_t left;
    int64_t ended;
    double gap;
    double next_rate;
    int64_t start;
    int64_t at;
    double station;
    int64_t passed;
    traces__start_traces(work, (*cspan_at(&work, region + layout__REGION_STATION)), (*cspan_at(&work, region + layout__REGION_RAIL)), (*cspan_at(&work, region + layout__REGION_WHEEL)));
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
            nodes__trace_node(&gap, &next_rate, work, tables, state, region, nodes, direction * (traced + step));
            if ((gap >= contact_plane__NO_GAP) && (step > INT64_C(1)))
            {
                /* a profile ends within this stretch: node by node from here */
                step = INT64_C(1);
                traces__start_traces(work, (*cspan_at(&work, region + layout__REGION_STATION)), (*cspan_at(&work, region + layout__REGION_RAIL)), (*cspan_at(&work, region + layout__REGION_WHEEL)));
                nodes__trace_node(&gap, &next_rate, work, tables, state, region, nodes, direction * (traced + step));
            }
            if (gap >= contact_plane__NO_GAP)
            {
                ended = INT64_C(1);
                nodes__end_region(work, region, direction, (*cspan_at(&work, region + layout__REGION_STATION)) + (*cspan_at(&work, region + layout__REGION_SPACING)) * (double)(direction * k));
            }
            else
            {
                start = direction * traced;
                nodes__fill_between(work, nodes, start, start + direction * step, step, (*cspan_at(&work, region + layout__REGION_SPACING)), rate, next_rate);
                rate = next_rate;
                traced += step;
            }
        }
        k += INT64_C(1);
        at = direction * k;
        station = (*cspan_at(&work, region + layout__REGION_STATION)) + (*cspan_at(&work, region + layout__REGION_SPACING)) * (double)(at);
        if (ended == INT64_C(1))
        {
            nodes__extrapolate_node(work, nodes, at, direction);
            if ((int64_t)((*cspan_at(&tables, layout__TABLES_LATERAL))) != layout__LATERAL_ADAPTIVE)
            {
                (*cspan_at(&work, nodes + layout__NODES_B + INT64_C(128) + at)) = (*cspan_at(&work, nodes + layout__NODES_B + INT64_C(128) + (at - direction)));
            }
        }
        if (passed > INT64_C(0))
        {
            left -= INT64_C(1);
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

/* Values at the ``count`` - 1 nodes between ``start`` and ``stop``, on a straight line. */
static inline int64_t nodes__fill_straight(array_double_1d work, int64_t values, int64_t start, int64_t stop, int64_t count)
{
    int64_t inward;
    double rise;
    int64_t i;
    inward = INT64_C(1);
    if (stop < start)
    {
        inward = -INT64_C(1);
    }
    rise = ((*cspan_at(&work, values + INT64_C(128) + stop)) - (*cspan_at(&work, values + INT64_C(128) + start))) / (double)(count);
    for (i = INT64_C(1); i < count; i += INT64_C(1))
    {
        (*cspan_at(&work, values + INT64_C(128) + (start + inward * i))) = (*cspan_at(&work, values + INT64_C(128) + start)) + rise * (double)(i);
    }
    return INT64_C(0);
}

/* Gap (cubic of Hermite) and A (linear) at the ``count`` - 1 nodes between two traced ones, ``start`` and
 * ``stop``, with their slopes.
 *
 * Beside a conformal stretch the gap can rise so suddenly that the cubic falls below zero before; no gap of
 * a region is smaller than that at its minimum.
 */
static inline int64_t nodes__fill_between(array_double_1d work, int64_t nodes, int64_t start, int64_t stop, int64_t count, double spacing, double start_rate, double stop_rate)
{
    double low;
    double rise;
    double width;
    double forward;
    double backward;
    int64_t inward;
    int64_t i;
    double x;
    double rest;
    double gap;
    low = (*cspan_at(&work, nodes + layout__NODES_GAP + INT64_C(128) + start));
    rise = (*cspan_at(&work, nodes + layout__NODES_GAP + INT64_C(128) + stop)) - low;
    width = spacing * (double)(stop - start);
    forward = start_rate * width - rise;
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
        gap = low + x * (rise + rest * (rest * forward - x * backward));
        if (gap < 0.0)
        {
            gap = 0.0;
        }
        (*cspan_at(&work, nodes + layout__NODES_GAP + INT64_C(128) + (start + inward * i))) = gap;
    }
    nodes__fill_straight(work, nodes + layout__NODES_A, start, stop, count);
    nodes__fill_straight(work, nodes + layout__NODES_TURN, start, stop, count);
    return INT64_C(0);
}

/* Bound the region at ``station`` [m]: beyond it a profile ends, or the outline of a strongly yawed wheel
 * folds back.  A bound that is known to lie before the next node stays.
 */
static inline int64_t nodes__end_region(array_double_1d work, int64_t region, int64_t direction, double station)
{
    if (direction > INT64_C(0))
    {
        if (station + (*cspan_at(&work, region + layout__REGION_SPACING)) < (*cspan_at(&work, region + layout__REGION_HIGH)))
        {
            (*cspan_at(&work, region + layout__REGION_HIGH)) = station;
        }
    }
    else if (station - (*cspan_at(&work, region + layout__REGION_SPACING)) > (*cspan_at(&work, region + layout__REGION_LOW)))
    {
        (*cspan_at(&work, region + layout__REGION_LOW)) = station;
    }
    return INT64_C(0);
}

/* Continue gap and A past an end, so that windows over it see the curvature before it. */
static inline int64_t nodes__extrapolate_node(array_double_1d work, int64_t nodes, int64_t at, int64_t direction)
{
    int64_t one;
    int64_t two;
    one = at - direction;
    if (at * direction > INT64_C(2))
    {
        two = one - direction;
        (*cspan_at(&work, nodes + layout__NODES_GAP + INT64_C(128) + at)) = 3.0 * (*cspan_at(&work, nodes + layout__NODES_GAP + INT64_C(128) + one)) - 3.0 * (*cspan_at(&work, nodes + layout__NODES_GAP + INT64_C(128) + two)) + (*cspan_at(&work, nodes + layout__NODES_GAP + INT64_C(128) + (two - direction)));
    }
    else
    {
        /* next to the minimum: take the other side's, or nothing if that is not known yet */
        (*cspan_at(&work, nodes + layout__NODES_GAP + INT64_C(128) + at)) = (*cspan_at(&work, nodes + layout__NODES_GAP + INT64_C(128) + one));
    }
    (*cspan_at(&work, nodes + layout__NODES_A + INT64_C(128) + at)) = (*cspan_at(&work, nodes + layout__NODES_A + INT64_C(128) + one));
    (*cspan_at(&work, nodes + layout__NODES_TURN + INT64_C(128) + at)) = (*cspan_at(&work, nodes + layout__NODES_TURN + INT64_C(128) + one));
    return INT64_C(0);
}
