/* Generated from tangent_nodes.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of nodes.py.
 */

#include "tangent_nodes.h"

/* Tangent of ``lay_nodes``. */
static inline int64_t tangent_nodes__lay_nodes_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, array_double_1d state, int64_t region, double low_reach, double low_reach_t, double high_reach, double high_reach_t, double spacing, double spacing_t, int64_t window, int64_t stride)
{
    int64_t block;
    int64_t gaps;
    int64_t longitudinal;
    double tolerance_t;
    double tolerance;
    int64_t prepared;
    double origin_t;
    double origin;
    double gap;
    double gap_t;
    double first_rate;
    double first_rate_t;
    double bend;
    double bend_t;
    double curvature;
    double curvature_t;
    int64_t k1;
    double v2;
    double v2_t;
    int64_t direction;
    double rate_t;
    double rate;
    double reach_t;
    double reach;
    int64_t k;
    int64_t traced;
    int64_t step;
    int64_t left;
    int64_t passed;
    int64_t ended;
    int64_t at;
    double v3;
    double next_rate;
    double next_rate_t;
    double v4;
    double v5;
    int64_t k6;
    double v7;
    double v7_t;
    double v8;
    double station_t;
    double station;
    int64_t k9;
    int64_t k10;
    block = layout__WORK_REGIONS + layout__REGION_SIZE * region;
    (*cspan_at(&work_t, block + layout__REGION_SPACING)) = spacing_t;
    (*cspan_at(&work, block + layout__REGION_SPACING)) = spacing;
    gaps = nodes__node_field(region, nodes__NODE_GAP);
    longitudinal = nodes__node_field(region, nodes__NODE_A);
    tolerance_t = nodes__TRACE_SHARE * spacing_t;
    tolerance = nodes__TRACE_SHARE * spacing;
    if (tolerance > nodes__FINEST_TRACE)
    {
        tolerance_t = 0.0;
        tolerance = nodes__FINEST_TRACE;
    }
    prepared = INT64_C(0);
    if ((int64_t)((*cspan_at(&tables, layout__TABLES_LATERAL))) != layout__LATERAL_ADAPTIVE)
    {
        prepared = INT64_C(1);
    }
    origin_t = (*cspan_at(&work_t, block + layout__REGION_STATION));
    origin = (*cspan_at(&work, block + layout__REGION_STATION));
    tangent_contact_plane__start_tracer_t(work, work_t, origin, origin_t, (*cspan_at(&work, block + layout__REGION_RAIL)), (*cspan_at(&work_t, block + layout__REGION_RAIL)), (*cspan_at(&work, block + layout__REGION_WHEEL)), (*cspan_at(&work_t, block + layout__REGION_WHEEL)));
    tangent_separation__open_origin_t(tables, work, work_t, origin, origin_t, (*cspan_at(&work, block + layout__REGION_GAP)), (*cspan_at(&work_t, block + layout__REGION_GAP)), (*cspan_at(&work, block + layout__REGION_RAIL)), (*cspan_at(&work_t, block + layout__REGION_RAIL)), (*cspan_at(&work, block + layout__REGION_WHEEL)), (*cspan_at(&work_t, block + layout__REGION_WHEEL)), spacing, spacing_t);
    tangent_separation__separation_t(&gap, &gap_t, &first_rate, &first_rate_t, &bend, &bend_t, &curvature, &curvature_t, tables, work, work_t, state, origin, origin_t, tolerance, tolerance_t);
    (*cspan_at(&work_t, gaps)) = 0.0;
    (*cspan_at(&work, gaps)) = 0.0;
    (*cspan_at(&work_t, longitudinal)) = 0.5 * curvature_t;
    (*cspan_at(&work, longitudinal)) = 0.5 * curvature;
    if (prepared == INT64_C(1))
    {
        k1 = nodes__node_field(region, nodes__NODE_B);
        tangent_lateral_curvature__relative_curvature_t(&v2, &v2_t, tables, (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_WHEEL)), (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_TRACER_WHEEL)), (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_RAIL)), (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_TRACER_RAIL)));
        (*cspan_at(&work_t, k1)) = v2_t;
        (*cspan_at(&work, k1)) = v2;
    }
    for (direction = -INT64_C(1); direction < INT64_C(2); direction += INT64_C(2))
    {
        tangent_contact_plane__start_tracer_t(work, work_t, origin, origin_t, (*cspan_at(&work, block + layout__REGION_RAIL)), (*cspan_at(&work_t, block + layout__REGION_RAIL)), (*cspan_at(&work, block + layout__REGION_WHEEL)), (*cspan_at(&work_t, block + layout__REGION_WHEEL)));
        rate_t = first_rate_t;
        rate = first_rate;
        reach_t = high_reach_t;
        reach = high_reach;
        if (direction < INT64_C(0))
        {
            reach_t = low_reach_t;
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
                v3 = (double)(at);
                tangent_separation__separation_t(&gap, &gap_t, &next_rate, &next_rate_t, &bend, &bend_t, &curvature, &curvature_t, tables, work, work_t, state, origin + spacing * v3, origin_t + spacing_t * v3, tolerance, tolerance_t);
                if ((gap >= contact_plane__NO_GAP) && (step > INT64_C(1)))
                {
                    step = INT64_C(1);
                    tangent_contact_plane__start_tracer_t(work, work_t, origin, origin_t, (*cspan_at(&work, block + layout__REGION_RAIL)), (*cspan_at(&work_t, block + layout__REGION_RAIL)), (*cspan_at(&work, block + layout__REGION_WHEEL)), (*cspan_at(&work_t, block + layout__REGION_WHEEL)));
                    at = direction * (traced + step);
                    v4 = (double)(at);
                    tangent_separation__separation_t(&gap, &gap_t, &next_rate, &next_rate_t, &bend, &bend_t, &curvature, &curvature_t, tables, work, work_t, state, origin + spacing * v4, origin_t + spacing_t * v4, tolerance, tolerance_t);
                }
                if (gap >= contact_plane__NO_GAP)
                {
                    ended = INT64_C(1);
                    v5 = (double)(direction * k);
                    tangent_nodes__end_region_t(work, work_t, block, direction, origin + spacing * v5, origin_t + spacing_t * v5);
                }
                else
                {
                    (*cspan_at(&work_t, gaps + at)) = gap_t - (*cspan_at(&work_t, block + layout__REGION_GAP));
                    (*cspan_at(&work, gaps + at)) = gap - (*cspan_at(&work, block + layout__REGION_GAP));
                    (*cspan_at(&work_t, longitudinal + at)) = 0.5 * curvature_t;
                    (*cspan_at(&work, longitudinal + at)) = 0.5 * curvature;
                    if (prepared == INT64_C(1))
                    {
                        k6 = nodes__node_field(region, nodes__NODE_B) + at;
                        tangent_lateral_curvature__relative_curvature_t(&v7, &v7_t, tables, (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_WHEEL)), (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_TRACER_WHEEL)), (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_RAIL)), (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_TRACER_RAIL)));
                        (*cspan_at(&work_t, k6)) = v7_t;
                        (*cspan_at(&work, k6)) = v7;
                    }
                    tangent_nodes__fill_between_t(work, work_t, gaps, longitudinal, direction * traced, at, step, spacing, spacing_t, rate, rate_t, next_rate, next_rate_t);
                    rate_t = next_rate_t;
                    rate = next_rate;
                    traced = traced + step;
                }
            }
            k = k + INT64_C(1);
            at = direction * k;
            v8 = (double)(at);
            station_t = origin_t + spacing_t * v8;
            station = origin + spacing * v8;
            if (ended == INT64_C(1))
            {
                tangent_nodes__extrapolate_node_t(work, work_t, gaps, longitudinal, at, direction);
                if (prepared == INT64_C(1))
                {
                    k9 = nodes__node_field(region, nodes__NODE_B) + at;
                    k10 = nodes__node_field(region, nodes__NODE_B) + at - direction;
                    (*cspan_at(&work_t, k9)) = (*cspan_at(&work_t, k10));
                    (*cspan_at(&work, k9)) = (*cspan_at(&work, k10));
                }
            }
            if (passed > INT64_C(0))
            {
                left = left - INT64_C(1);
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
            (*cspan_at(&work_t, block + layout__REGION_FIRST)) = 0.0;
            (*cspan_at(&work, block + layout__REGION_FIRST)) = (double)((double)(-passed));
        }
        else
        {
            (*cspan_at(&work_t, block + layout__REGION_LAST)) = 0.0;
            (*cspan_at(&work, block + layout__REGION_LAST)) = (double)((double)(passed));
        }
    }
    return INT64_C(0);
}

/* Tangent of ``fill_straight``. */
static inline int64_t tangent_nodes__fill_straight_t(array_double_1d work, array_double_1d work_t, int64_t field, int64_t start, int64_t stop, int64_t count)
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
    v1 = (*cspan_at(&work, field + stop)) - (*cspan_at(&work, field + start));
    v2 = (double)(count);
    rise_t = ((*cspan_at(&work_t, field + stop)) - (*cspan_at(&work_t, field + start))) / v2;
    rise = v1 / v2;
    for (i = INT64_C(1); i < count; i += INT64_C(1))
    {
        v3 = (double)(i);
        (*cspan_at(&work_t, field + start + inward * i)) = (*cspan_at(&work_t, field + start)) + rise_t * v3;
        (*cspan_at(&work, field + start + inward * i)) = (*cspan_at(&work, field + start)) + rise * v3;
    }
    return INT64_C(0);
}

/* Tangent of ``fill_between``. */
static inline int64_t tangent_nodes__fill_between_t(array_double_1d work, array_double_1d work_t, int64_t gaps, int64_t longitudinal, int64_t start, int64_t stop, int64_t count, double spacing, double spacing_t, double start_rate, double start_rate_t, double stop_rate, double stop_rate_t)
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
    low_t = (*cspan_at(&work_t, gaps + start));
    low = (*cspan_at(&work, gaps + start));
    rise_t = (*cspan_at(&work_t, gaps + stop)) - low_t;
    rise = (*cspan_at(&work, gaps + stop)) - low;
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
        (*cspan_at(&work_t, gaps + start + inward * i)) = gap_t;
        (*cspan_at(&work, gaps + start + inward * i)) = gap;
    }
    tangent_nodes__fill_straight_t(work, work_t, longitudinal, start, stop, count);
    return INT64_C(0);
}

/* Tangent of ``end_region``. */
static inline int64_t tangent_nodes__end_region_t(array_double_1d work, array_double_1d work_t, int64_t block, int64_t direction, double station, double station_t)
{
    if (direction > INT64_C(0))
    {
        if (station + (*cspan_at(&work, block + layout__REGION_SPACING)) < (*cspan_at(&work, block + layout__REGION_HIGH)))
        {
            (*cspan_at(&work_t, block + layout__REGION_HIGH)) = station_t;
            (*cspan_at(&work, block + layout__REGION_HIGH)) = station;
        }
    }
    else if (station - (*cspan_at(&work, block + layout__REGION_SPACING)) > (*cspan_at(&work, block + layout__REGION_LOW)))
    {
        (*cspan_at(&work_t, block + layout__REGION_LOW)) = station_t;
        (*cspan_at(&work, block + layout__REGION_LOW)) = station;
    }
    return INT64_C(0);
}

/* Tangent of ``extrapolate_node``. */
static inline int64_t tangent_nodes__extrapolate_node_t(array_double_1d work, array_double_1d work_t, int64_t gaps, int64_t longitudinal, int64_t at, int64_t direction)
{
    int64_t one;
    one = gaps + at - direction;
    if (at * direction > INT64_C(2))
    {
        (*cspan_at(&work_t, gaps + at)) = 3.0 * (*cspan_at(&work_t, one)) - 3.0 * (*cspan_at(&work_t, one - direction)) + (*cspan_at(&work_t, one - INT64_C(2) * direction));
        (*cspan_at(&work, gaps + at)) = 3.0 * (*cspan_at(&work, one)) - 3.0 * (*cspan_at(&work, one - direction)) + (*cspan_at(&work, one - INT64_C(2) * direction));
    }
    else
    {
        (*cspan_at(&work_t, gaps + at)) = (*cspan_at(&work_t, one));
        (*cspan_at(&work, gaps + at)) = (*cspan_at(&work, one));
    }
    (*cspan_at(&work_t, longitudinal + at)) = (*cspan_at(&work_t, longitudinal + at - direction));
    (*cspan_at(&work, longitudinal + at)) = (*cspan_at(&work, longitudinal + at - direction));
    return INT64_C(0);
}

/* Tangent of ``second_difference``. */
static inline int64_t tangent_nodes__second_difference_t(double* v5, double* result_1, array_double_1d work, array_double_1d work_t, int64_t at, double spacing, double spacing_t, int64_t window)
{
    double v1;
    double width_t;
    double width;
    double v2;
    double v3;
    double v4;
    v1 = (double)(window);
    width_t = spacing_t * v1;
    width = spacing * v1;
    v2 = (*cspan_at(&work, at + window)) - 2.0 * (*cspan_at(&work, at)) + (*cspan_at(&work, at - window));
    v3 = 2.0 * width;
    v4 = v3 * width;
    (*v5) = v2 / v4;
    (*result_1) = ((*cspan_at(&work_t, at + window)) - 2.0 * (*cspan_at(&work_t, at)) + (*cspan_at(&work_t, at - window)) - (*v5) * (2.0 * width_t * width + v3 * width_t)) / v4;
    return 0;
}

/* Tangent of ``secant_curvature``. */
static inline int64_t tangent_nodes__secant_curvature_t(double* v3, double* result_1, array_double_1d work, array_double_1d work_t, int64_t region, int64_t k, int64_t window, double middle, double middle_t)
{
    int64_t gaps;
    double spacing_t;
    double spacing;
    double v1;
    double s_t;
    double s;
    double v2;
    double v4;
    double width_t;
    double width;
    double v5;
    double v6;
    double edge_t;
    double edge;
    double v7;
    double v8;
    double v9;
    double v10;
    double v11;
    double v12;
    gaps = nodes__node_field(region, nodes__NODE_GAP);
    spacing_t = (*cspan_at(&work_t, layout__WORK_REGIONS + layout__REGION_SIZE * region + layout__REGION_SPACING));
    spacing = (*cspan_at(&work, layout__WORK_REGIONS + layout__REGION_SIZE * region + layout__REGION_SPACING));
    if ((k >= window) || (k <= -window))
    {
        v1 = (double)(k);
        s_t = spacing_t * v1;
        s = spacing * v1;
        v2 = s * s;
        (*v3) = (*cspan_at(&work, gaps + k)) / v2;
        (*result_1) = ((*cspan_at(&work_t, gaps + k)) - (*v3) * (s_t * s + s * s_t)) / v2;
        return 0;
    }
    v4 = (double)(window);
    width_t = spacing_t * v4;
    width = spacing * v4;
    v5 = width * width;
    v6 = (*cspan_at(&work, gaps + window)) / v5;
    edge_t = ((*cspan_at(&work_t, gaps + window)) - v6 * (width_t * width + width * width_t)) / v5;
    edge = v6;
    if (k < INT64_C(0))
    {
        v7 = width * width;
        v8 = (*cspan_at(&work, gaps - window)) / v7;
        edge_t = ((*cspan_at(&work_t, gaps - window)) - v8 * (width_t * width + width * width_t)) / v7;
        edge = v8;
    }
    v9 = edge - middle;
    v10 = fabs((double)(k));
    v11 = v9 * v10;
    v12 = (double)(window);
    (*v3) = middle + v11 / v12;
    (*result_1) = middle_t + (edge_t - middle_t) * v10 / v12;
    return 0;
}

/* Tangent of ``windowed_curvature``. */
static inline int64_t tangent_nodes__windowed_curvature_t(double* v4, double* result_1, double averaged, double averaged_t, double secant, double secant_t, double share, double share_t)
{
    double grown_t;
    double grown;
    double v1;
    double v2;
    double v3;
    if (averaged < nodes__WINDOW_FLOOR * secant)
    {
        averaged_t = nodes__WINDOW_FLOOR * secant_t;
        averaged = nodes__WINDOW_FLOOR * secant;
    }
    grown_t = secant_t;
    grown = secant;
    if (averaged > secant)
    {
        v1 = nodes__GROWTH * share;
        v2 = averaged - secant;
        grown_t = grown_t + (nodes__GROWTH * share_t * v2 + v1 * (averaged_t - secant_t));
        grown = grown + v1 * v2;
    }
    v3 = averaged * grown;
    (*v4) = sqrt(v3);
    (*result_1) = tangent_rates__root_rate((*v4), averaged_t * grown + averaged * grown_t);
    return 0;
}

/* Tangent of ``adaptive_curvatures``. */
static inline int64_t tangent_nodes__adaptive_curvatures_t(double* secant, double* secant_t, double* side, double* side_t, double* B, double* B_t, array_double_1d work, array_double_1d work_t, int64_t region, int64_t k, int64_t window, double middle, double middle_t, double mean, double mean_t, double least, double least_t)
{
    int64_t block;
    double spacing_t;
    double spacing;
    double v1;
    double v1_t;
    double v2;
    double v3;
    double v4;
    double share_t;
    double share;
    double v6;
    double v6_t;
    double v5;
    double v5_t;
    block = layout__WORK_REGIONS + layout__REGION_SIZE * region;
    spacing_t = (*cspan_at(&work_t, block + layout__REGION_SPACING));
    spacing = (*cspan_at(&work, block + layout__REGION_SPACING));
    tangent_nodes__secant_curvature_t(&v1, &v1_t, work, work_t, region, k, window, middle, middle_t);
    (*secant_t) = v1_t;
    (*secant) = v1;
    if ((*secant) < least)
    {
        (*secant_t) = least_t;
        (*secant) = least;
    }
    v2 = fabs((double)(k));
    v3 = v2 * spacing;
    v4 = v3 / mean;
    share_t = (v2 * spacing_t - v4 * mean_t) / mean;
    share = v4;
    if (share > 1.0)
    {
        share_t = 0.0;
        share = 1.0;
    }
    tangent_nodes__second_difference_t(&v6, &v6_t, work, work_t, nodes__node_field(region, nodes__NODE_GAP) + k, spacing, spacing_t, window);
    tangent_nodes__windowed_curvature_t(&v5, &v5_t, v6, v6_t, (*secant), (*secant_t), share, share_t);
    (*B_t) = v5_t;
    (*B) = v5;
    if ((*B) < least)
    {
        (*B_t) = least_t;
        (*B) = least;
    }
    (*side_t) = (*cspan_at(&work_t, block + layout__REGION_SIDE_HIGH));
    (*side) = (*cspan_at(&work, block + layout__REGION_SIDE_HIGH));
    if (k < INT64_C(0))
    {
        (*side_t) = (*cspan_at(&work_t, block + layout__REGION_SIDE_LOW));
        (*side) = (*cspan_at(&work, block + layout__REGION_SIDE_LOW));
    }
    if ((*side) < least)
    {
        (*side_t) = least_t;
        (*side) = least;
    }
    return 0;
}

/* Tangent of ``weigh_nodes``. */
static inline int64_t tangent_nodes__weigh_nodes_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t region, int64_t window)
{
    int64_t block;
    int64_t gaps;
    int64_t longitudinal;
    int64_t base;
    int64_t yawed;
    int64_t prepared;
    double alpha_turn_t;
    double alpha_turn;
    double beta_turn_t;
    double beta_turn;
    double nr_turn_t;
    double nr_turn;
    double spacing_t;
    double spacing;
    double v1;
    double mean_t;
    double mean;
    double v2;
    double v2_t;
    double middle_t;
    double middle;
    int64_t k_end;
    int64_t k;
    double A_t;
    double A;
    double least_t;
    double least;
    int64_t k3;
    double B_t;
    double B;
    double secant_t;
    double secant;
    double side_t;
    double side;
    double v5;
    double v4;
    double v4_t;
    double alpha_t;
    double alpha;
    double v7;
    double v6;
    double v6_t;
    double beta_t;
    double beta;
    double v9;
    double v8;
    double v8_t;
    double nr_t;
    double nr;
    int64_t k10;
    int64_t k11;
    int64_t k12;
    double v13;
    int64_t k14;
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
    alpha_turn_t = 0.0;
    alpha_turn = 1.0;
    beta_turn_t = 0.0;
    beta_turn = 1.0;
    nr_turn_t = 0.0;
    nr_turn = 1.0;
    if (yawed == INT64_C(1))
    {
        tangent_nodes__turn_region_t(&alpha_turn, &alpha_turn_t, &beta_turn, &beta_turn_t, &nr_turn, &nr_turn_t, tables, work, work_t, region);
    }
    spacing_t = (*cspan_at(&work_t, block + layout__REGION_SPACING));
    spacing = (*cspan_at(&work, block + layout__REGION_SPACING));
    v1 = (*cspan_at(&work, block + layout__REGION_WIDTH_LOW)) + (*cspan_at(&work, block + layout__REGION_WIDTH_HIGH));
    mean_t = 0.5 * ((*cspan_at(&work_t, block + layout__REGION_WIDTH_LOW)) + (*cspan_at(&work_t, block + layout__REGION_WIDTH_HIGH)));
    mean = 0.5 * v1;
    tangent_nodes__second_difference_t(&v2, &v2_t, work, work_t, gaps, spacing, spacing_t, window);
    middle_t = v2_t;
    middle = v2;
    if (middle < 0.0)
    {
        middle_t = 0.0;
        middle = 0.0;
    }
    k_end = (int64_t)((*cspan_at(&work, block + layout__REGION_LAST))) + INT64_C(1);
    for (k = (int64_t)((*cspan_at(&work, block + layout__REGION_FIRST))); k < k_end; k += INT64_C(1))
    {
        A_t = (*cspan_at(&work_t, longitudinal + k));
        A = (*cspan_at(&work, longitudinal + k));
        least_t = nodes__FLOOR * A_t;
        least = nodes__FLOOR * A;
        if (prepared == INT64_C(1))
        {
            k3 = nodes__node_field(region, nodes__NODE_B) + k;
            B_t = (*cspan_at(&work_t, k3));
            B = (*cspan_at(&work, k3));
            if (B < least)
            {
                B_t = least_t;
                B = least;
            }
            secant_t = B_t;
            secant = B;
            side_t = B_t;
            side = B;
        }
        else
        {
            tangent_nodes__adaptive_curvatures_t(&secant, &secant_t, &side, &side_t, &B, &B_t, work, work_t, region, k, window, middle, middle_t, mean, mean_t, least, least_t);
        }
        v5 = secant / A;
        tangent_hertz__table_value_t(&v4, &v4_t, tables, base, INT64_C(0), log(v5), (secant_t - v5 * A_t) / A / v5);
        alpha_t = v4_t;
        alpha = v4;
        v7 = A / side;
        tangent_hertz__table_value_t(&v6, &v6_t, tables, base, INT64_C(0), log(v7), (A_t - v7 * side_t) / side / v7);
        beta_t = v6_t;
        beta = v6;
        v9 = B / A;
        tangent_hertz__table_value_t(&v8, &v8_t, tables, base, INT64_C(6), log(v9), (B_t - v9 * A_t) / A / v9);
        nr_t = v8_t;
        nr = v8;
        if (yawed == INT64_C(1))
        {
            alpha_t = alpha_t * alpha_turn + alpha * alpha_turn_t;
            alpha = alpha * alpha_turn;
            beta_t = beta_t * beta_turn + beta * beta_turn_t;
            beta = beta * beta_turn;
            nr_t = nr_t * nr_turn + nr * nr_turn_t;
            nr = nr * nr_turn;
        }
        k10 = nodes__node_field(region, nodes__NODE_B) + k;
        (*cspan_at(&work_t, k10)) = B_t;
        (*cspan_at(&work, k10)) = B;
        k11 = nodes__node_field(region, nodes__NODE_RISE) + k;
        (*cspan_at(&work_t, k11)) = beta_t * (*cspan_at(&work, gaps + k)) + beta * (*cspan_at(&work_t, gaps + k));
        (*cspan_at(&work, k11)) = beta * (*cspan_at(&work, gaps + k));
        k12 = nodes__node_field(region, nodes__NODE_LINE) + k;
        v13 = (*cspan_at(&tables, layout__TABLES_CONTACT_MODULUS)) / nr;
        (*cspan_at(&work_t, k12)) = (-v13) * nr_t / nr;
        (*cspan_at(&work, k12)) = v13;
        k14 = nodes__node_field(region, nodes__NODE_LENGTH) + k;
        (*cspan_at(&work_t, k14)) = alpha_t * A + alpha * A_t;
        (*cspan_at(&work, k14)) = alpha * A;
    }
    return INT64_C(0);
}

/* Tangent of ``turn_region``. */
static inline int64_t tangent_nodes__turn_region_t(double* v5, double* result_1, double* v6, double* result_3, double* v7, double* result_5, array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t region)
{
    int64_t block;
    int64_t base;
    int64_t k1;
    double A_t;
    double A;
    double v2;
    double B_t;
    double B;
    double alpha;
    double alpha_t;
    double beta;
    double beta_t;
    double nr;
    double nr_t;
    double turned_alpha;
    double turned_alpha_t;
    double turned_beta;
    double turned_beta_t;
    double turned_nr;
    double turned_nr_t;
    double upright_A;
    double upright_A_t;
    double upright_B;
    double upright_B_t;
    double share;
    double share_t;
    double v3;
    double v4;
    block = layout__WORK_REGIONS + layout__REGION_SIZE * region;
    base = (int64_t)((*cspan_at(&tables, layout__TABLES_HERTZ)));
    k1 = nodes__node_field(region, nodes__NODE_A);
    A_t = (*cspan_at(&work_t, k1));
    A = (*cspan_at(&work, k1));
    v2 = (*cspan_at(&work, block + layout__REGION_SIDE_LOW)) + (*cspan_at(&work, block + layout__REGION_SIDE_HIGH));
    B_t = 0.5 * ((*cspan_at(&work_t, block + layout__REGION_SIDE_LOW)) + (*cspan_at(&work_t, block + layout__REGION_SIDE_HIGH)));
    B = 0.5 * v2;
    if (B < nodes__FLOOR * A)
    {
        B_t = nodes__FLOOR * A_t;
        B = nodes__FLOOR * A;
    }
    tangent_hertz__hertz_coefficients_t(&alpha, &alpha_t, &beta, &beta_t, &nr, &nr_t, tables, base, A, A_t, B, B_t);
    tangent_hertz__skewed_coefficients_t(&turned_alpha, &turned_alpha_t, &turned_beta, &turned_beta_t, &turned_nr, &turned_nr_t, tables, base, A, A_t, B, B_t, (*cspan_at(&work, block + layout__REGION_SLANT)), (*cspan_at(&work_t, block + layout__REGION_SLANT)));
    if ((int64_t)((*cspan_at(&tables, layout__TABLES_NORMAL_MODEL))) == layout__MODEL_ANALYN_STRIP)
    {
        tangent_hertz__upright_rule_t(&upright_A, &upright_A_t, &upright_B, &upright_B_t, &share, &share_t, tables, base, turned_alpha * A, turned_alpha_t * A + turned_alpha * A_t, turned_beta * B, turned_beta_t * B + turned_beta * B_t, turned_nr, turned_nr_t);
        v3 = upright_A / A;
        (*cspan_at(&work_t, block + layout__REGION_UPRIGHT_A)) = (upright_A_t - v3 * A_t) / A;
        (*cspan_at(&work, block + layout__REGION_UPRIGHT_A)) = v3;
        v4 = upright_B / B;
        (*cspan_at(&work_t, block + layout__REGION_UPRIGHT_B)) = (upright_B_t - v4 * B_t) / B;
        (*cspan_at(&work, block + layout__REGION_UPRIGHT_B)) = v4;
        (*cspan_at(&work_t, block + layout__REGION_UPRIGHT_SHARE)) = share_t;
        (*cspan_at(&work, block + layout__REGION_UPRIGHT_SHARE)) = share;
    }
    (*v5) = turned_alpha / alpha;
    (*v6) = turned_beta / beta;
    (*v7) = turned_nr / nr;
    (*result_1) = (turned_alpha_t - (*v5) * alpha_t) / alpha;
    (*result_3) = (turned_beta_t - (*v6) * beta_t) / beta;
    (*result_5) = (turned_nr_t - (*v7) * nr_t) / nr;
    return 0;
}
