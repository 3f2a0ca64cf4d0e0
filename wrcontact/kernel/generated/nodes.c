/* Generated from nodes.py by tools/transpile_kernel.py; change that one.
 *
 * Nodes across a region: gap, longitudinal and lateral curvature, and from them ANALYN's coefficients.
 *
 * Nodes are anchored at the region's minimum, station + k h, with h a fixed share of the half-width of the
 * interpenetration; so a result depends on the pose alone and moves smoothly with it.
 *
 * Lateral curvature.  Second differences over a window w (the curvature averaged with a triangle of half-width w) are
 * smooth but blind to what lies beyond; the secant g/s^2 knows how far the surfaces have parted but lags behind.  With
 * B_t and B_s these two,
 *
 *     B = sqrt(B_t max(B_t, B_s)),   B_t, B_s >= FLOOR A
 *
 * follows a sharp joint (B_t) and keeps a patch from growing where B_t falls to zero or below (B_s).
 */

#include "nodes.h"

/* Offset of node 0 of a region's ``field`` in the workspace. */
static inline int64_t nodes__node_field(int64_t region, int64_t field)
{
    return layout__WORK_NODES + (region * layout__NODE_FIELDS + field) * layout__NODE_LIMIT + layout__NODE_MIDDLE;
}

/* Gap and A at the region's nodes, until the gap has risen above COVER ``level`` or the bound is passed, and
 * ``window`` nodes further.
 */
static inline int64_t nodes__lay_nodes(array_double_1d tables, array_double_1d work, array_double_1d state, int64_t region, double level, double spacing, int64_t window)
{
    int64_t block;
    int64_t gaps;
    int64_t longitudinal;
    double tolerance;
    double origin;
    double gap;
    double rate;
    double bend;
    double curvature;
    int64_t direction;
    int64_t k;
    int64_t left;
    int64_t passed;
    int64_t ended;
    int64_t at;
    double station;
    block = regions__region_block(region);
    (*cspan_at(&work, block + regions__REGION_SPACING)) = spacing;
    gaps = nodes__node_field(region, nodes__NODE_GAP);
    longitudinal = nodes__node_field(region, nodes__NODE_A);
    tolerance = nodes__TRACE_SHARE * spacing;
    if (tolerance > nodes__FINEST_TRACE)
    {
        tolerance = nodes__FINEST_TRACE;
    }
    origin = (*cspan_at(&work, block + regions__REGION_STATION));
    contact_plane__start_tracer(work, origin, (*cspan_at(&work, block + regions__REGION_RAIL)), (*cspan_at(&work, block + regions__REGION_WHEEL)));
    contact_plane__normal_gap(&gap, &rate, &bend, &curvature, tables, work, state, origin, tolerance);
    (*cspan_at(&work, gaps)) = 0.0;
    (*cspan_at(&work, longitudinal)) = 0.5 * curvature;
    for (direction = -INT64_C(1); direction < INT64_C(2); direction += INT64_C(2))
    {
        contact_plane__start_tracer(work, origin, (*cspan_at(&work, block + regions__REGION_RAIL)), (*cspan_at(&work, block + regions__REGION_WHEEL)));
        k = INT64_C(0);
        left = window;
        passed = INT64_C(0);
        ended = INT64_C(0);
        while((left > INT64_C(0)) && (k < layout__NODE_LIMIT - layout__NODE_MIDDLE - INT64_C(2)))
        {
            k += INT64_C(1);
            at = direction * k;
            station = origin + spacing * (double)(at);
            if (ended == INT64_C(0))
            {
                contact_plane__normal_gap(&gap, &rate, &bend, &curvature, tables, work, state, station, tolerance);
                if (gap >= contact_plane__NO_GAP)
                {
                    ended = INT64_C(1);
                    nodes__end_region(work, block, direction, station - spacing * (double)(direction));
                }
            }
            if (ended == INT64_C(0))
            {
                (*cspan_at(&work, gaps + at)) = gap - (*cspan_at(&work, block + regions__REGION_GAP));
                (*cspan_at(&work, longitudinal + at)) = 0.5 * curvature;
            }
            else
            {
                nodes__extrapolate_node(work, gaps, longitudinal, at, direction);
            }
            if (passed > INT64_C(0))
            {
                left -= INT64_C(1);
            }
            else if ((ended == INT64_C(1)) || ((*cspan_at(&work, gaps + at)) > nodes__COVER * level))
            {
                passed = k;
            }
            else if ((station > (*cspan_at(&work, block + regions__REGION_HIGH))) || (station < (*cspan_at(&work, block + regions__REGION_LOW))))
            {
                passed = k;
            }
        }
        if (passed == INT64_C(0))
        {
            passed = k - window;
        }
        if (direction < INT64_C(0))
        {
            (*cspan_at(&work, block + regions__REGION_FIRST)) = (double)(-passed);
        }
        else
        {
            (*cspan_at(&work, block + regions__REGION_LAST)) = (double)(passed);
        }
    }
    return INT64_C(0);
}

/* Bound the region at ``station``: beyond it a profile ends, or the outline of a strongly yawed wheel folds back. */
static inline int64_t nodes__end_region(array_double_1d work, int64_t block, int64_t direction, double station)
{
    if (direction > INT64_C(0))
    {
        if (station < (*cspan_at(&work, block + regions__REGION_HIGH)))
        {
            (*cspan_at(&work, block + regions__REGION_HIGH)) = station;
        }
    }
    else if (station > (*cspan_at(&work, block + regions__REGION_LOW)))
    {
        (*cspan_at(&work, block + regions__REGION_LOW)) = station;
    }
    return INT64_C(0);
}

/* Continue gap and A past an end, so that windows over it see the curvature before it. */
static inline int64_t nodes__extrapolate_node(array_double_1d work, int64_t gaps, int64_t longitudinal, int64_t at, int64_t direction)
{
    int64_t one;
    one = gaps + at - direction;
    if (at * direction > INT64_C(2))
    {
        (*cspan_at(&work, gaps + at)) = 3.0 * (*cspan_at(&work, one)) - 3.0 * (*cspan_at(&work, one - direction)) + (*cspan_at(&work, one - INT64_C(2) * direction));
    }
    else
    {
        /* next to the minimum: take the other side's, or nothing if that is not known yet */
        (*cspan_at(&work, gaps + at)) = (*cspan_at(&work, one));
    }
    (*cspan_at(&work, longitudinal + at)) = (*cspan_at(&work, longitudinal + at - direction));
    return INT64_C(0);
}

/* Half the second derivative [1/m] of the field at ``at``, averaged with a triangle of half-width window h. */
static inline double nodes__second_difference(array_double_1d work, int64_t at, double spacing, int64_t window)
{
    double width;
    double result;
    width = spacing * (double)(window);
    result = ((*cspan_at(&work, at + window)) - 2.0 * (*cspan_at(&work, at)) + (*cspan_at(&work, at - window))) / (2.0 * width * width);
    return result;
}

/* B [1/m] at node ``k``: see the head of this file. */
static inline double nodes__lateral_curvature(array_double_1d work, int64_t region, int64_t k, int64_t window)
{
    int64_t gaps;
    double spacing;
    double least;
    double averaged;
    double secant;
    double s;
    double width;
    double middle;
    double edge;
    double share;
    gaps = nodes__node_field(region, nodes__NODE_GAP);
    spacing = (*cspan_at(&work, regions__region_block(region) + regions__REGION_SPACING));
    least = nodes__FLOOR * (*cspan_at(&work, nodes__node_field(region, nodes__NODE_A) + k));
    averaged = nodes__second_difference(work, gaps + k, spacing, window);
    if (!(averaged > least))
    {
        averaged = least;
    }
    secant = 0.0;
    if ((k >= window) || (k <= -window))
    {
        s = spacing * (double)(k);
        secant = (*cspan_at(&work, gaps + k)) / (s * s);
    }
    else
    {
        width = spacing * (double)(window);
        middle = nodes__second_difference(work, gaps, spacing, window);
        if (middle < 0.0)
        {
            middle = 0.0;
        }
        edge = (*cspan_at(&work, gaps + window)) / (width * width);
        if (k < INT64_C(0))
        {
            edge = (*cspan_at(&work, gaps - window)) / (width * width);
        }
        share = fabs((double)(k)) / (double)(window);
        secant = middle + (edge - middle) * share;
    }
    if (!(secant > averaged))
    {
        secant = averaged;
    }
    return sqrt(averaged * secant);
}

/* ANALYN's coefficients at the region's nodes: (1 + beta) g, E* /(n r) and (1 + alpha) A. */
static inline int64_t nodes__weigh_nodes(array_double_1d tables, array_double_1d work, int64_t region, int64_t window)
{
    int64_t block;
    int64_t gaps;
    int64_t longitudinal;
    int64_t rises;
    int64_t lines;
    int64_t lengths;
    int64_t base;
    int64_t k_end;
    int64_t k;
    double A;
    double B;
    double one_alpha;
    double one_beta;
    double nr;
    block = regions__region_block(region);
    gaps = nodes__node_field(region, nodes__NODE_GAP);
    longitudinal = nodes__node_field(region, nodes__NODE_A);
    rises = nodes__node_field(region, nodes__NODE_RISE);
    lines = nodes__node_field(region, nodes__NODE_LINE);
    lengths = nodes__node_field(region, nodes__NODE_LENGTH);
    base = (int64_t)((*cspan_at(&tables, layout__SET_HERTZ)));
    k_end = (int64_t)((*cspan_at(&work, block + regions__REGION_LAST))) + INT64_C(1);
    for (k = (int64_t)((*cspan_at(&work, block + regions__REGION_FIRST))); k < k_end; k += INT64_C(1))
    {
        A = (*cspan_at(&work, longitudinal + k));
        B = nodes__lateral_curvature(work, region, k, window);
        hertz__hertz_coefficients(&one_alpha, &one_beta, &nr, tables, base, A, B);
        (*cspan_at(&work, rises + k)) = one_beta * (*cspan_at(&work, gaps + k));
        (*cspan_at(&work, lines + k)) = (*cspan_at(&tables, layout__SET_CONTACT_MODULUS)) / nr;
        (*cspan_at(&work, lengths + k)) = one_alpha * A;
    }
    return INT64_C(0);
}
