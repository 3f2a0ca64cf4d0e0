/* Generated from normal/nodes.py by tools/transpile_kernel.py; change that one.
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
 *
 * That is the lateral curvature "adaptive".  "smooth" and "rough" are the source's, prepared for each profile
 * (:mod:`lateral_curvature`), one B in all three places; where it is below FLOOR A it counts as that.
 */

#include "nodes.h"

/* Offset of node 0 of a region's ``field`` in the workspace. */
static inline int64_t nodes__node_field(int64_t region, int64_t field)
{
    return layout__WORK_NODES + (region * layout__NODE_FIELDS + field) * layout__NODE_LIMIT + layout__NODE_MIDDLE;
}

/* Gap and A at the region's nodes, until the gap has risen above ``low_reach`` or ``high_reach`` on that side or the
 * bound is passed, and ``window`` nodes further.
 *
 * Every ``stride``-th node is traced on the profiles; those between are read off the cubic through gap and slope there.
 * Where the lateral curvature is a prepared one, it is kept in NODE_B for :func:`weigh_nodes`.
 */
static inline int64_t nodes__lay_nodes(array_double_1d tables, array_double_1d work, array_double_1d state, int64_t region, double low_reach, double high_reach, double spacing, int64_t window, int64_t stride)
{
    int64_t block;
    int64_t gaps;
    int64_t longitudinal;
    double tolerance;
    int64_t prepared;
    double origin;
    double gap;
    double first_rate;
    double bend;
    double curvature;
    int64_t direction;
    double rate;
    double reach;
    int64_t k;
    int64_t traced;
    int64_t step;
    int64_t left;
    int64_t passed;
    int64_t ended;
    int64_t at;
    double next_rate;
    double station;
    block = layout__WORK_REGIONS + layout__REGION_SIZE * region;
    (*cspan_at(&work, block + layout__REGION_SPACING)) = spacing;
    gaps = nodes__node_field(region, nodes__NODE_GAP);
    longitudinal = nodes__node_field(region, nodes__NODE_A);
    tolerance = nodes__TRACE_SHARE * spacing;
    if (tolerance > nodes__FINEST_TRACE)
    {
        tolerance = nodes__FINEST_TRACE;
    }
    prepared = INT64_C(0);
    if ((int64_t)((*cspan_at(&tables, layout__TABLES_LATERAL))) != layout__LATERAL_ADAPTIVE)
    {
        prepared = INT64_C(1);
    }
    origin = (*cspan_at(&work, block + layout__REGION_STATION));
    contact_plane__start_tracer(work, origin, (*cspan_at(&work, block + layout__REGION_RAIL)), (*cspan_at(&work, block + layout__REGION_WHEEL)));
    separation__open_origin(tables, work, origin, (*cspan_at(&work, block + layout__REGION_GAP)), (*cspan_at(&work, block + layout__REGION_RAIL)), (*cspan_at(&work, block + layout__REGION_WHEEL)), spacing);
    separation__separation(&gap, &first_rate, &bend, &curvature, tables, work, state, origin, tolerance);
    (*cspan_at(&work, gaps)) = 0.0;
    (*cspan_at(&work, longitudinal)) = 0.5 * curvature;
    if (prepared == INT64_C(1))
    {
        (*cspan_at(&work, nodes__node_field(region, nodes__NODE_B))) = lateral_curvature__relative_curvature(tables, (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_WHEEL)), (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_RAIL)));
    }
    for (direction = -INT64_C(1); direction < INT64_C(2); direction += INT64_C(2))
    {
        contact_plane__start_tracer(work, origin, (*cspan_at(&work, block + layout__REGION_RAIL)), (*cspan_at(&work, block + layout__REGION_WHEEL)));
        rate = first_rate;
        reach = high_reach;
        if (direction < INT64_C(0))
        {
            reach = low_reach;
        }
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
                at = direction * (traced + step);
                separation__separation(&gap, &next_rate, &bend, &curvature, tables, work, state, origin + spacing * (double)(at), tolerance);
                if ((gap >= contact_plane__NO_GAP) && (step > INT64_C(1)))
                {
                    /* a profile ends within this stretch: node by node from here */
                    step = INT64_C(1);
                    contact_plane__start_tracer(work, origin, (*cspan_at(&work, block + layout__REGION_RAIL)), (*cspan_at(&work, block + layout__REGION_WHEEL)));
                    at = direction * (traced + step);
                    separation__separation(&gap, &next_rate, &bend, &curvature, tables, work, state, origin + spacing * (double)(at), tolerance);
                }
                if (gap >= contact_plane__NO_GAP)
                {
                    ended = INT64_C(1);
                    nodes__end_region(work, block, direction, origin + spacing * (double)(direction * k));
                }
                else
                {
                    (*cspan_at(&work, gaps + at)) = gap - (*cspan_at(&work, block + layout__REGION_GAP));
                    (*cspan_at(&work, longitudinal + at)) = 0.5 * curvature;
                    if (prepared == INT64_C(1))
                    {
                        (*cspan_at(&work, nodes__node_field(region, nodes__NODE_B) + at)) = lateral_curvature__relative_curvature(tables, (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_WHEEL)), (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_RAIL)));
                    }
                    nodes__fill_between(work, gaps, longitudinal, direction * traced, at, step, spacing, rate, next_rate);
                    rate = next_rate;
                    traced += step;
                }
            }
            k += INT64_C(1);
            at = direction * k;
            station = origin + spacing * (double)(at);
            if (ended == INT64_C(1))
            {
                nodes__extrapolate_node(work, gaps, longitudinal, at, direction);
                if (prepared == INT64_C(1))
                {
                    (*cspan_at(&work, nodes__node_field(region, nodes__NODE_B) + at)) = (*cspan_at(&work, nodes__node_field(region, nodes__NODE_B) + at - direction));
                }
            }
            if (passed > INT64_C(0))
            {
                left -= INT64_C(1);
            }
            else if ((ended == INT64_C(1)) || ((*cspan_at(&work, gaps + at)) > reach))
            {
                passed = k;
            }
            else if ((station > (*cspan_at(&work, block + layout__REGION_HIGH))) || (station < (*cspan_at(&work, block + layout__REGION_LOW))))
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
            (*cspan_at(&work, block + layout__REGION_FIRST)) = (double)((double)(-passed));
        }
        else
        {
            (*cspan_at(&work, block + layout__REGION_LAST)) = (double)((double)(passed));
        }
    }
    return INT64_C(0);
}

/* ``field`` at the ``count`` - 1 nodes between two, on a straight line. */
static inline int64_t nodes__fill_straight(array_double_1d work, int64_t field, int64_t start, int64_t stop, int64_t count)
{
    int64_t inward;
    double rise;
    int64_t i;
    inward = INT64_C(1);
    if (stop < start)
    {
        inward = -INT64_C(1);
    }
    rise = ((*cspan_at(&work, field + stop)) - (*cspan_at(&work, field + start))) / (double)(count);
    for (i = INT64_C(1); i < count; i += INT64_C(1))
    {
        (*cspan_at(&work, field + start + inward * i)) = (*cspan_at(&work, field + start)) + rise * (double)(i);
    }
    return INT64_C(0);
}

/* Gap (cubic of Hermite) and A (linear) at the ``count`` - 1 nodes between two traced ones with their slopes.
 *
 * Behind a conformal stretch the gap can rise so suddenly that the cubic falls below zero before; no gap of a region is smaller
 * than that at its minimum.
 */
static inline int64_t nodes__fill_between(array_double_1d work, int64_t gaps, int64_t longitudinal, int64_t start, int64_t stop, int64_t count, double spacing, double start_rate, double stop_rate)
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
    low = (*cspan_at(&work, gaps + start));
    rise = (*cspan_at(&work, gaps + stop)) - low;
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
        (*cspan_at(&work, gaps + start + inward * i)) = gap;
    }
    nodes__fill_straight(work, longitudinal, start, stop, count);
    return INT64_C(0);
}

/* Bound the region at ``station``: beyond it a profile ends, or the outline of a strongly yawed wheel folds back.  A bound
 * that is known to lie before the next node stays.
 */
static inline int64_t nodes__end_region(array_double_1d work, int64_t block, int64_t direction, double station)
{
    if (direction > INT64_C(0))
    {
        if (station + (*cspan_at(&work, block + layout__REGION_SPACING)) < (*cspan_at(&work, block + layout__REGION_HIGH)))
        {
            (*cspan_at(&work, block + layout__REGION_HIGH)) = station;
        }
    }
    else if (station - (*cspan_at(&work, block + layout__REGION_SPACING)) > (*cspan_at(&work, block + layout__REGION_LOW)))
    {
        (*cspan_at(&work, block + layout__REGION_LOW)) = station;
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

/* g / s^2 [1/m] at node ``k``; within the window a blend from ``middle`` to the secant at its end. */
static inline double nodes__secant_curvature(array_double_1d work, int64_t region, int64_t k, int64_t window, double middle)
{
    int64_t gaps;
    double spacing;
    double s;
    double width;
    double edge;
    double result;
    gaps = nodes__node_field(region, nodes__NODE_GAP);
    spacing = (*cspan_at(&work, layout__WORK_REGIONS + layout__REGION_SIZE * region + layout__REGION_SPACING));
    if ((k >= window) || (k <= -window))
    {
        s = spacing * (double)(k);
        result = (*cspan_at(&work, gaps + k)) / (s * s);
        return result;
    }
    width = spacing * (double)(window);
    edge = (*cspan_at(&work, gaps + window)) / (width * width);
    if (k < INT64_C(0))
    {
        edge = (*cspan_at(&work, gaps - window)) / (width * width);
    }
    return middle + (edge - middle) * fabs((double)(k)) / (double)(window);
}

/* sqrt(B_w (B_s + GROWTH share max(B_w - B_s, 0))) [1/m], with B_w not below WINDOW_FLOOR B_s. */
static inline double nodes__windowed_curvature(double averaged, double secant, double share)
{
    double grown;
    if (averaged < nodes__WINDOW_FLOOR * secant)
    {
        averaged = nodes__WINDOW_FLOOR * secant;
    }
    grown = secant;
    if (averaged > secant)
    {
        grown += nodes__GROWTH * share * (averaged - secant);
    }
    return sqrt(averaged * grown);
}

/* The three lateral curvatures [1/m] at node ``k``, for 1 + alpha, 1 + beta and n r: secant, side and window; none
 * below ``least``.
 */
static inline int64_t nodes__adaptive_curvatures(double* secant, double* side, double* B, array_double_1d work, int64_t region, int64_t k, int64_t window, double middle, double mean, double least)
{
    int64_t block;
    double spacing;
    double share;
    block = layout__WORK_REGIONS + layout__REGION_SIZE * region;
    spacing = (*cspan_at(&work, block + layout__REGION_SPACING));
    (*secant) = nodes__secant_curvature(work, region, k, window, middle);
    if ((*secant) < least)
    {
        (*secant) = least;
    }
    share = fabs((double)(k)) * spacing / mean;
    if (share > 1.0)
    {
        share = 1.0;
    }
    (*B) = nodes__windowed_curvature(nodes__second_difference(work, nodes__node_field(region, nodes__NODE_GAP) + k, spacing, window), (*secant), share);
    if ((*B) < least)
    {
        (*B) = least;
    }
    (*side) = (*cspan_at(&work, block + layout__REGION_SIDE_HIGH));
    if (k < INT64_C(0))
    {
        (*side) = (*cspan_at(&work, block + layout__REGION_SIDE_LOW));
    }
    if ((*side) < least)
    {
        (*side) = least;
    }
    return 0;
}

/* ANALYN's coefficients at the region's nodes: (1 + beta) g, E* /(n r) and (1 + alpha) A, each with its own B, or all
 * with the prepared one.
 */
static inline int64_t nodes__weigh_nodes(array_double_1d tables, array_double_1d work, int64_t region, int64_t window)
{
    int64_t block;
    int64_t gaps;
    int64_t longitudinal;
    int64_t base;
    int64_t yawed;
    int64_t prepared;
    double alpha_turn;
    double beta_turn;
    double nr_turn;
    double spacing;
    double mean;
    double middle;
    int64_t k_end;
    int64_t k;
    double A;
    double least;
    double B;
    double secant;
    double side;
    double alpha;
    double beta;
    double nr;
    block = layout__WORK_REGIONS + layout__REGION_SIZE * region;
    gaps = nodes__node_field(region, nodes__NODE_GAP);
    longitudinal = nodes__node_field(region, nodes__NODE_A);
    base = (int64_t)((*cspan_at(&tables, layout__TABLES_HERTZ)));
    yawed = contact_plane__is_yawed(work);
    prepared = INT64_C(0);
    if ((int64_t)((*cspan_at(&tables, layout__TABLES_LATERAL))) != layout__LATERAL_ADAPTIVE)
    {
        prepared = INT64_C(1);
    }
    alpha_turn = 1.0;
    beta_turn = 1.0;
    nr_turn = 1.0;
    if (yawed == INT64_C(1))
    {
        nodes__turn_region(&alpha_turn, &beta_turn, &nr_turn, tables, work, region);
    }
    spacing = (*cspan_at(&work, block + layout__REGION_SPACING));
    mean = 0.5 * ((*cspan_at(&work, block + layout__REGION_WIDTH_LOW)) + (*cspan_at(&work, block + layout__REGION_WIDTH_HIGH)));
    middle = nodes__second_difference(work, gaps, spacing, window);
    if (middle < 0.0)
    {
        middle = 0.0;
    }
    k_end = (int64_t)((*cspan_at(&work, block + layout__REGION_LAST))) + INT64_C(1);
    for (k = (int64_t)((*cspan_at(&work, block + layout__REGION_FIRST))); k < k_end; k += INT64_C(1))
    {
        A = (*cspan_at(&work, longitudinal + k));
        least = nodes__FLOOR * A;
        if (prepared == INT64_C(1))
        {
            B = (*cspan_at(&work, nodes__node_field(region, nodes__NODE_B) + k));
            if (B < least)
            {
                B = least;
            }
            secant = B;
            side = B;
        }
        else
        {
            nodes__adaptive_curvatures(&secant, &side, &B, work, region, k, window, middle, mean, least);
        }
        alpha = hertz__table_value(tables, base, INT64_C(0), log(secant / A));
        beta = hertz__table_value(tables, base, INT64_C(0), log(A / side));
        nr = hertz__table_value(tables, base, INT64_C(6), log(B / A));
        if (yawed == INT64_C(1))
        {
            alpha *= alpha_turn;
            beta *= beta_turn;
            nr *= nr_turn;
        }
        (*cspan_at(&work, nodes__node_field(region, nodes__NODE_B) + k)) = B;
        (*cspan_at(&work, nodes__node_field(region, nodes__NODE_RISE) + k)) = beta * (*cspan_at(&work, gaps + k));
        (*cspan_at(&work, nodes__node_field(region, nodes__NODE_LINE) + k)) = (*cspan_at(&tables, layout__TABLES_CONTACT_MODULUS)) / nr;
        (*cspan_at(&work, nodes__node_field(region, nodes__NODE_LENGTH) + k)) = alpha * A;
    }
    return INT64_C(0);
}

/* What the slant of a yawed wheel's ridge makes of 1 + alpha, 1 + beta and n r: factors for all nodes of the region,
 * from its mean slant and curvature; and for the strips the upright ellipse that cuts into the same ones.
 */
static inline int64_t nodes__turn_region(double* result_0, double* result_1, double* result_2, array_double_1d tables, array_double_1d work, int64_t region)
{
    int64_t block;
    int64_t base;
    double A;
    double B;
    double alpha;
    double beta;
    double nr;
    double turned_alpha;
    double turned_beta;
    double turned_nr;
    double upright_A;
    double upright_B;
    double share;
    block = layout__WORK_REGIONS + layout__REGION_SIZE * region;
    base = (int64_t)((*cspan_at(&tables, layout__TABLES_HERTZ)));
    A = (*cspan_at(&work, nodes__node_field(region, nodes__NODE_A)));
    B = 0.5 * ((*cspan_at(&work, block + layout__REGION_SIDE_LOW)) + (*cspan_at(&work, block + layout__REGION_SIDE_HIGH)));
    if (B < nodes__FLOOR * A)
    {
        B = nodes__FLOOR * A;
    }
    hertz__hertz_coefficients(&alpha, &beta, &nr, tables, base, A, B);
    hertz__skewed_coefficients(&turned_alpha, &turned_beta, &turned_nr, tables, base, A, B, (*cspan_at(&work, block + layout__REGION_SLANT)));
    if ((int64_t)((*cspan_at(&tables, layout__TABLES_NORMAL_MODEL))) == layout__MODEL_ANALYN_STRIP)
    {
        hertz__upright_coefficients(&upright_A, &upright_B, &share, tables, base, turned_alpha * A, turned_beta * B, turned_nr);
        (*cspan_at(&work, block + layout__REGION_UPRIGHT_A)) = upright_A / A;
        (*cspan_at(&work, block + layout__REGION_UPRIGHT_B)) = upright_B / B;
        (*cspan_at(&work, block + layout__REGION_UPRIGHT_SHARE)) = share;
    }
    (*result_0) = turned_alpha / alpha;
    (*result_1) = turned_beta / beta;
    (*result_2) = turned_nr / nr;
    return 0;
}
