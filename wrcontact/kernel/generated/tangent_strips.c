/* Generated from tangent_strips.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of strips.py.
 */

#include "tangent_strips.h"

/* Tangent of ``zone_excess``. */
static inline int64_t tangent_strips__zone_excess_t(double* below, double* below_t, array_double_1d work, array_double_1d work_t, int64_t block, int64_t gaps, int64_t rises, int64_t k, double penetration, double penetration_t)
{
    double level_t;
    double level;
    double beyond_t;
    double beyond;
    (*below_t) = strips__ZONE * penetration_t - (*cspan_at(&work_t, block + layout__REGION_GAP)) - (*cspan_at(&work_t, gaps + k));
    (*below) = strips__ZONE * penetration - (*cspan_at(&work, block + layout__REGION_GAP)) - (*cspan_at(&work, gaps + k));
    level_t = (*cspan_at(&work_t, block + layout__REGION_LEVEL)) - (*cspan_at(&work_t, rises + k));
    level = (*cspan_at(&work, block + layout__REGION_LEVEL)) - (*cspan_at(&work, rises + k));
    beyond_t = level_t + strips__BEYOND * penetration_t;
    beyond = level + strips__BEYOND * penetration;
    if (beyond < (*below))
    {
        (*below_t) = beyond_t;
        (*below) = beyond;
    }
    if (level > (*below))
    {
        (*below_t) = level_t;
        (*below) = level;
    }
    return 0;
}

/* Tangent of ``zone_end``. */
static inline int64_t tangent_strips__zone_end_t(double* station, double* station_t, array_double_1d work, array_double_1d work_t, int64_t region, int64_t direction, double penetration, double penetration_t)
{
    int64_t block;
    int64_t gaps;
    int64_t rises;
    int64_t last;
    double bound_t;
    double bound;
    double v1;
    double v1_t;
    double inner_t;
    double inner;
    double reach_t;
    double reach;
    int64_t k;
    double v2;
    double v2_t;
    double outer_t;
    double outer;
    double v3;
    double v4;
    double v5;
    double v6;
    block = layout__WORK_REGIONS + layout__REGION_SIZE * region;
    gaps = nodes__node_field(region, nodes__NODE_GAP);
    rises = nodes__node_field(region, nodes__NODE_RISE);
    last = (int64_t)((*cspan_at(&work, block + layout__REGION_LAST)));
    bound_t = (*cspan_at(&work_t, block + layout__REGION_HIGH));
    bound = (*cspan_at(&work, block + layout__REGION_HIGH));
    if (direction < INT64_C(0))
    {
        last = -(int64_t)((*cspan_at(&work, block + layout__REGION_FIRST)));
        bound_t = (*cspan_at(&work_t, block + layout__REGION_LOW));
        bound = (*cspan_at(&work, block + layout__REGION_LOW));
    }
    tangent_strips__zone_excess_t(&v1, &v1_t, work, work_t, block, gaps, rises, INT64_C(0), penetration, penetration_t);
    inner_t = v1_t;
    inner = v1;
    reach_t = 0.0;
    reach = 0.0;
    if (inner > 0.0)
    {
        reach_t = 0.0;
        reach = (double)(last);
        for (k = INT64_C(1); k < last + INT64_C(1); k += INT64_C(1))
        {
            tangent_strips__zone_excess_t(&v2, &v2_t, work, work_t, block, gaps, rises, direction * k, penetration, penetration_t);
            outer_t = v2_t;
            outer = v2;
            if (outer <= 0.0)
            {
                v3 = inner - outer;
                v4 = inner / v3;
                reach_t = (inner_t - v4 * (inner_t - outer_t)) / v3;
                reach = (double)(k - INT64_C(1)) + v4;
                break;
            }
            inner_t = outer_t;
            inner = outer;
        }
    }
    v5 = (double)(direction);
    v6 = v5 * reach;
    (*station_t) = (*cspan_at(&work_t, block + layout__REGION_STATION)) + (v5 * reach_t * (*cspan_at(&work, block + layout__REGION_SPACING)) + v6 * (*cspan_at(&work_t, block + layout__REGION_SPACING)));
    (*station) = (*cspan_at(&work, block + layout__REGION_STATION)) + v6 * (*cspan_at(&work, block + layout__REGION_SPACING));
    if (((*station) - bound) * (double)(direction) > 0.0)
    {
        (*station_t) = bound_t;
        (*station) = bound;
    }
    return 0;
}

/* Tangent of ``node_weight``. */
static inline int64_t tangent_strips__node_weight_t(double* weight, double* weight_t, array_double_1d work, array_double_1d work_t, int64_t region, int64_t k, double penetration, double penetration_t)
{
    int64_t block;
    int64_t k1;
    double v2;
    double v3;
    double share_t;
    double share;
    int64_t k4;
    double v5;
    double v6;
    block = layout__WORK_REGIONS + layout__REGION_SIZE * region;
    k1 = nodes__node_field(region, nodes__NODE_GAP) + k;
    v2 = (*cspan_at(&work, block + layout__REGION_GAP)) + (*cspan_at(&work, k1));
    v3 = v2 / penetration;
    share_t = -(((*cspan_at(&work_t, block + layout__REGION_GAP)) + (*cspan_at(&work_t, k1)) - v3 * penetration_t) / penetration);
    share = 1.0 - v3;
    (*weight_t) = 0.0;
    (*weight) = 0.0;
    if (share > 0.0)
    {
        k4 = nodes__node_field(region, nodes__NODE_B) + k;
        v5 = (*cspan_at(&work, k4)) * share;
        v6 = sqrt(v5);
        (*weight_t) = tangent_rates__root_rate(v6, (*cspan_at(&work_t, k4)) * share + (*cspan_at(&work, k4)) * share_t);
        (*weight) = v6;
    }
    return 0;
}

/* Tangent of ``cell_overlap``. */
static inline int64_t tangent_strips__cell_overlap_t(double* result_0, double* result_1, double* start, double* start_t, array_double_1d work, array_double_1d work_t, int64_t block, int64_t k)
{
    double spacing_t;
    double spacing;
    double v1;
    double stop_t;
    double stop;
    spacing_t = (*cspan_at(&work_t, block + layout__REGION_SPACING));
    spacing = (*cspan_at(&work, block + layout__REGION_SPACING));
    v1 = (double)(k);
    (*start_t) = (*cspan_at(&work_t, block + layout__REGION_STATION)) + spacing_t * v1;
    (*start) = (*cspan_at(&work, block + layout__REGION_STATION)) + spacing * v1;
    stop_t = (*start_t) + spacing_t;
    stop = (*start) + spacing;
    if ((*start) < (*cspan_at(&work, block + layout__REGION_START)))
    {
        (*start_t) = (*cspan_at(&work_t, block + layout__REGION_START));
        (*start) = (*cspan_at(&work, block + layout__REGION_START));
    }
    if (stop > (*cspan_at(&work, block + layout__REGION_STOP)))
    {
        stop_t = (*cspan_at(&work_t, block + layout__REGION_STOP));
        stop = (*cspan_at(&work, block + layout__REGION_STOP));
    }
    (*result_0) = stop - (*start);
    (*result_1) = stop_t - (*start_t);
    return 0;
}

/* Tangent of ``weigh_region``. */
static inline int64_t tangent_strips__weigh_region_t(double* total, double* total_t, array_double_1d work, array_double_1d work_t, int64_t region, double penetration, double penetration_t)
{
    int64_t block;
    double v1;
    double v1_t;
    double before_t;
    double before;
    int64_t k_end;
    int64_t k;
    double v2;
    double v2_t;
    double after_t;
    double after;
    double length;
    double length_t;
    double start;
    double start_t;
    double v3;
    double v4;
    block = layout__WORK_REGIONS + layout__REGION_SIZE * region;
    (*total_t) = 0.0;
    (*total) = 0.0;
    tangent_strips__node_weight_t(&v1, &v1_t, work, work_t, region, (int64_t)((*cspan_at(&work, block + layout__REGION_FIRST))), penetration, penetration_t);
    before_t = v1_t;
    before = v1;
    k_end = (int64_t)((*cspan_at(&work, block + layout__REGION_LAST)));
    for (k = (int64_t)((*cspan_at(&work, block + layout__REGION_FIRST))); k < k_end; k += INT64_C(1))
    {
        tangent_strips__node_weight_t(&v2, &v2_t, work, work_t, region, k + INT64_C(1), penetration, penetration_t);
        after_t = v2_t;
        after = v2;
        tangent_strips__cell_overlap_t(&length, &length_t, &start, &start_t, work, work_t, block, k);
        if (length > 0.0)
        {
            v3 = before + after;
            v4 = 0.5 * v3;
            (*total_t) = (*total_t) + (0.5 * (before_t + after_t) * length + v4 * length_t);
            (*total) = (*total) + v4 * length;
        }
        before_t = after_t;
        before = after;
    }
    return 0;
}

/* Tangent of ``place_strips``. */
static inline int64_t tangent_strips__place_strips_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t count, double penetration, double penetration_t)
{
    double weight_t;
    double weight;
    double width_t;
    double width;
    int64_t region;
    int64_t block;
    double share_t;
    double share;
    double v1;
    double v1_t;
    double v2;
    double v2_t;
    double v3;
    double v3_t;
    double length_t;
    double length;
    double v4;
    double even_t;
    double even;
    double v5;
    double v6;
    double graded_t;
    double graded;
    int64_t own;
    int64_t n7;
    int64_t strips;
    weight_t = 0.0;
    weight = 0.0;
    width_t = 0.0;
    width = 0.0;
    for (region = INT64_C(0); region < count; region += INT64_C(1))
    {
        block = layout__WORK_REGIONS + layout__REGION_SIZE * region;
        share_t = (*cspan_at(&work_t, block + layout__REGION_TURN)) * penetration + (*cspan_at(&work, block + layout__REGION_TURN)) * penetration_t;
        share = (*cspan_at(&work, block + layout__REGION_TURN)) * penetration;
        tangent_strips__zone_end_t(&v1, &v1_t, work, work_t, region, -INT64_C(1), share, share_t);
        (*cspan_at(&work_t, block + layout__REGION_START)) = v1_t;
        (*cspan_at(&work, block + layout__REGION_START)) = v1;
        tangent_strips__zone_end_t(&v2, &v2_t, work, work_t, region, INT64_C(1), share, share_t);
        (*cspan_at(&work_t, block + layout__REGION_STOP)) = v2_t;
        (*cspan_at(&work, block + layout__REGION_STOP)) = v2;
        tangent_strips__weigh_region_t(&v3, &v3_t, work, work_t, region, share, share_t);
        (*cspan_at(&work_t, block + layout__REGION_WEIGHT)) = v3_t;
        (*cspan_at(&work, block + layout__REGION_WEIGHT)) = v3;
        weight_t = weight_t + (*cspan_at(&work_t, block + layout__REGION_WEIGHT));
        weight = weight + (*cspan_at(&work, block + layout__REGION_WEIGHT));
        width_t = width_t + ((*cspan_at(&work_t, block + layout__REGION_STOP)) - (*cspan_at(&work_t, block + layout__REGION_START)));
        width = width + ((*cspan_at(&work, block + layout__REGION_STOP)) - (*cspan_at(&work, block + layout__REGION_START)));
    }
    strips = INT64_C(0);
    for (region = INT64_C(0); region < count; region += INT64_C(1))
    {
        block = layout__WORK_REGIONS + layout__REGION_SIZE * region;
        length_t = (*cspan_at(&work_t, block + layout__REGION_STOP)) - (*cspan_at(&work_t, block + layout__REGION_START));
        length = (*cspan_at(&work, block + layout__REGION_STOP)) - (*cspan_at(&work, block + layout__REGION_START));
        if ((length > 0.0) && (weight > 0.0))
        {
            v4 = strips__EVEN / width;
            even_t = (-v4) * width_t / width;
            even = v4;
            v5 = 1.0 - strips__EVEN;
            v6 = v5 / weight;
            graded_t = (-v6) * weight_t / weight;
            graded = v6;
            share_t = even_t * length + even * length_t + (graded_t * (*cspan_at(&work, block + layout__REGION_WEIGHT)) + graded * (*cspan_at(&work_t, block + layout__REGION_WEIGHT)));
            share = even * length + graded * (*cspan_at(&work, block + layout__REGION_WEIGHT));
            own = (int64_t)((*cspan_at(&tables, layout__TABLES_STRIPS)) * share + 0.5);
            if (own < strips__LEAST)
            {
                own = strips__LEAST;
            }
            n7 = tangent_strips__divide_zone_t(work, work_t, region, (*cspan_at(&work, block + layout__REGION_TURN)) * penetration, (*cspan_at(&work_t, block + layout__REGION_TURN)) * penetration + (*cspan_at(&work, block + layout__REGION_TURN)) * penetration_t, strips, own, even, even_t, graded, graded_t, share, share_t);
            strips = n7;
        }
    }
    return strips;
}

/* Tangent of ``divide_zone``. */
static inline int64_t tangent_strips__divide_zone_t(array_double_1d work, array_double_1d work_t, int64_t region, double penetration, double penetration_t, int64_t strips, int64_t own, double even, double even_t, double graded, double graded_t, double share, double share_t)
{
    int64_t block;
    int64_t stations;
    int64_t widths;
    int64_t regions;
    double offset_t;
    double offset;
    double v1;
    double each_t;
    double each;
    double done_t;
    double done;
    int64_t made;
    double edge_t;
    double edge;
    double v2;
    double v2_t;
    double before_t;
    double before;
    int64_t k_end;
    int64_t k;
    double v3;
    double v3_t;
    double after_t;
    double after;
    double length;
    double length_t;
    double start;
    double start_t;
    double v4;
    double v5;
    double density_t;
    double density;
    double v6;
    double v7;
    double v8;
    double cut_t;
    double cut;
    double v9;
    double v10;
    double v11;
    double v12;
    block = layout__WORK_REGIONS + layout__REGION_SIZE * region;
    stations = strips__strip_field(strips__STRIP_STATION);
    widths = strips__strip_field(strips__STRIP_WIDTH);
    regions = strips__strip_field(strips__STRIP_REGION);
    offset_t = (*cspan_at(&work_t, block + layout__REGION_OFFSET));
    offset = (*cspan_at(&work, block + layout__REGION_OFFSET));
    v1 = (double)(own);
    each_t = share_t / v1;
    each = share / v1;
    done_t = 0.0;
    done = 0.0;
    made = INT64_C(0);
    edge_t = (*cspan_at(&work_t, block + layout__REGION_START));
    edge = (*cspan_at(&work, block + layout__REGION_START));
    tangent_strips__node_weight_t(&v2, &v2_t, work, work_t, region, (int64_t)((*cspan_at(&work, block + layout__REGION_FIRST))), penetration, penetration_t);
    before_t = v2_t;
    before = v2;
    k_end = (int64_t)((*cspan_at(&work, block + layout__REGION_LAST)));
    for (k = (int64_t)((*cspan_at(&work, block + layout__REGION_FIRST))); k < k_end; k += INT64_C(1))
    {
        tangent_strips__node_weight_t(&v3, &v3_t, work, work_t, region, k + INT64_C(1), penetration, penetration_t);
        after_t = v3_t;
        after = v3;
        tangent_strips__cell_overlap_t(&length, &length_t, &start, &start_t, work, work_t, block, k);
        if (length > 0.0)
        {
            v4 = graded * 0.5;
            v5 = before + after;
            density_t = even_t + (graded_t * 0.5 * v5 + v4 * (before_t + after_t));
            density = even + v4 * v5;
            while((made < own - INT64_C(1)) && (done + density * length >= each * (double)(made + INT64_C(1))))
            {
                v6 = (double)(made + INT64_C(1));
                v7 = each * v6 - done;
                v8 = v7 / density;
                cut_t = start_t + (each_t * v6 - done_t - v8 * density_t) / density;
                cut = start + v8;
                v9 = edge + cut;
                (*cspan_at(&work_t, stations + strips + made)) = offset_t + 0.5 * (edge_t + cut_t);
                (*cspan_at(&work, stations + strips + made)) = offset + 0.5 * v9;
                (*cspan_at(&work_t, widths + strips + made)) = cut_t - edge_t;
                (*cspan_at(&work, widths + strips + made)) = cut - edge;
                (*cspan_at(&work_t, regions + strips + made)) = 0.0;
                (*cspan_at(&work, regions + strips + made)) = (double)(region);
                edge_t = cut_t;
                edge = cut;
                made = made + INT64_C(1);
            }
            done_t = done_t + (density_t * length + density * length_t);
            done = done + density * length;
        }
        before_t = after_t;
        before = after;
    }
    while(made < own)
    {
        v10 = (*cspan_at(&work, block + layout__REGION_STOP)) - edge;
        v11 = (double)(own - made);
        cut_t = edge_t + ((*cspan_at(&work_t, block + layout__REGION_STOP)) - edge_t) / v11;
        cut = edge + v10 / v11;
        v12 = edge + cut;
        (*cspan_at(&work_t, stations + strips + made)) = offset_t + 0.5 * (edge_t + cut_t);
        (*cspan_at(&work, stations + strips + made)) = offset + 0.5 * v12;
        (*cspan_at(&work_t, widths + strips + made)) = cut_t - edge_t;
        (*cspan_at(&work, widths + strips + made)) = cut - edge;
        (*cspan_at(&work_t, regions + strips + made)) = 0.0;
        (*cspan_at(&work, regions + strips + made)) = (double)(region);
        edge_t = cut_t;
        edge = cut;
        made = made + INT64_C(1);
    }
    return strips + own;
}

/* Tangent of ``join_strips``. */
static inline int64_t tangent_strips__join_strips_t(array_double_1d work, array_double_1d work_t, int64_t strips)
{
    int64_t stations;
    int64_t widths;
    int64_t i;
    double joined;
    double v1;
    double reach_t;
    double reach;
    int64_t k2;
    stations = strips__strip_field(strips__STRIP_STATION);
    widths = strips__strip_field(strips__STRIP_WIDTH);
    for (i = INT64_C(0); i < strips; i += INT64_C(1))
    {
        joined = 0.0;
        if (i < strips - INT64_C(1))
        {
            v1 = (*cspan_at(&work, widths + i)) + (*cspan_at(&work, widths + i + INT64_C(1)));
            reach_t = 0.5 * ((*cspan_at(&work_t, widths + i)) + (*cspan_at(&work_t, widths + i + INT64_C(1))));
            reach = 0.5 * v1;
            if ((*cspan_at(&work, stations + i + INT64_C(1))) - (*cspan_at(&work, stations + i)) < reach * (1.0 + strips__TOUCHING))
            {
                joined = 1.0;
            }
        }
        k2 = strips__strip_field(strips__STRIP_JOINED) + i;
        (*cspan_at(&work_t, k2)) = 0.0;
        (*cspan_at(&work, k2)) = joined;
    }
    return INT64_C(0);
}

/* Tangent of ``cubic_through``. */
static inline int64_t tangent_strips__cubic_through_t(double* result_0, double* result_1, double before, double before_t, double low, double low_t, double high, double high_t, double after, double after_t, double x, double x_t)
{
    double v1;
    double bend_t;
    double bend;
    double v2;
    double third_t;
    double third;
    double v3;
    double v4;
    double v5;
    double v6;
    v1 = before - 2.0 * low + high;
    bend_t = 0.5 * (before_t - 2.0 * low_t + high_t);
    bend = 0.5 * v1;
    v2 = after - 3.0 * high + 3.0 * low - before;
    third_t = (after_t - 3.0 * high_t + 3.0 * low_t - before_t) / 6.0;
    third = v2 / 6.0;
    v3 = x - 1.0;
    v4 = x + 1.0;
    v5 = bend + v4 * third;
    v6 = high - low + v3 * v5;
    (*result_0) = low + x * v6;
    (*result_1) = low_t + (x_t * v6 + x * (high_t - low_t + (x_t * v5 + v3 * (bend_t + (x_t * third + v4 * third_t)))));
    return 0;
}

/* Tangent of ``cubic_value``. */
static inline int64_t tangent_strips__cubic_value_t(double* v1, double* v1_t, array_double_1d work, array_double_1d work_t, int64_t at, double x, double x_t)
{
    tangent_strips__cubic_through_t(v1, v1_t, (*cspan_at(&work, at - INT64_C(1))), (*cspan_at(&work_t, at - INT64_C(1))), (*cspan_at(&work, at)), (*cspan_at(&work_t, at)), (*cspan_at(&work, at + INT64_C(1))), (*cspan_at(&work_t, at + INT64_C(1))), (*cspan_at(&work, at + INT64_C(2))), (*cspan_at(&work_t, at + INT64_C(2))), x, x_t);
    return 0;
}

/* Tangent of ``locate_strip``. */
static inline int64_t tangent_strips__locate_strip_t(int64_t* region, int64_t* k, double* x, double* x_t, array_double_1d work, array_double_1d work_t, int64_t i)
{
    int64_t block;
    int64_t k1;
    double v2;
    double v3;
    double u_t;
    double u;
    double v4;
    double v4_t;
    double gap_t;
    double gap;
    int64_t k5;
    int64_t k6;
    double v7;
    double v7_t;
    int64_t k8;
    double turn_t;
    double turn;
    int64_t k9;
    int64_t k10;
    int64_t k11;
    (*region) = (int64_t)((*cspan_at(&work, strips__strip_field(strips__STRIP_REGION) + i)));
    block = layout__WORK_REGIONS + layout__REGION_SIZE * (*region);
    k1 = strips__strip_field(strips__STRIP_STATION) + i;
    v2 = (*cspan_at(&work, k1)) - (*cspan_at(&work, block + layout__REGION_OFFSET)) - (*cspan_at(&work, block + layout__REGION_STATION));
    v3 = v2 / (*cspan_at(&work, block + layout__REGION_SPACING));
    u_t = ((*cspan_at(&work_t, k1)) - (*cspan_at(&work_t, block + layout__REGION_OFFSET)) - (*cspan_at(&work_t, block + layout__REGION_STATION)) - v3 * (*cspan_at(&work_t, block + layout__REGION_SPACING))) / (*cspan_at(&work, block + layout__REGION_SPACING));
    u = v3;
    (*k) = (int64_t)(u + (double)(layout__NODE_MIDDLE)) - layout__NODE_MIDDLE;
    if ((*k) > (int64_t)((*cspan_at(&work, block + layout__REGION_LAST))) - INT64_C(1))
    {
        (*k) = (int64_t)((*cspan_at(&work, block + layout__REGION_LAST))) - INT64_C(1);
    }
    if ((*k) < (int64_t)((*cspan_at(&work, block + layout__REGION_FIRST))))
    {
        (*k) = (int64_t)((*cspan_at(&work, block + layout__REGION_FIRST)));
    }
    (*x_t) = u_t;
    (*x) = u - (double)((*k));
    tangent_strips__cubic_value_t(&v4, &v4_t, work, work_t, nodes__node_field((*region), nodes__NODE_GAP) + (*k), (*x), (*x_t));
    gap_t = v4_t;
    gap = v4;
    if (gap < 0.0)
    {
        gap_t = 0.0;
        gap = 0.0;
    }
    k5 = strips__strip_field(strips__STRIP_GAP) + i;
    (*cspan_at(&work_t, k5)) = (*cspan_at(&work_t, block + layout__REGION_GAP)) + gap_t;
    (*cspan_at(&work, k5)) = (*cspan_at(&work, block + layout__REGION_GAP)) + gap;
    k6 = strips__strip_field(strips__STRIP_A) + i;
    tangent_strips__node_value_t(&v7, &v7_t, work, work_t, (*region), nodes__NODE_A, (*k), (*x), (*x_t));
    (*cspan_at(&work_t, k6)) = v7_t;
    (*cspan_at(&work, k6)) = v7;
    k8 = strips__strip_field(strips__STRIP_TURN) + i;
    (*cspan_at(&work_t, k8)) = (*cspan_at(&work_t, block + layout__REGION_TURN));
    (*cspan_at(&work, k8)) = (*cspan_at(&work, block + layout__REGION_TURN));
    if (contact_plane__is_yawed(work) == INT64_C(1))
    {
        turn_t = (*cspan_at(&work_t, block + layout__REGION_UPRIGHT_SHARE));
        turn = (*cspan_at(&work, block + layout__REGION_UPRIGHT_SHARE));
        k9 = strips__strip_field(strips__STRIP_GAP) + i;
        (*cspan_at(&work_t, k9)) = turn_t * (*cspan_at(&work, block + layout__REGION_GAP)) + turn * (*cspan_at(&work_t, block + layout__REGION_GAP)) + (gap_t * (*cspan_at(&work, block + layout__REGION_UPRIGHT_B)) + gap * (*cspan_at(&work_t, block + layout__REGION_UPRIGHT_B)));
        (*cspan_at(&work, k9)) = turn * (*cspan_at(&work, block + layout__REGION_GAP)) + gap * (*cspan_at(&work, block + layout__REGION_UPRIGHT_B));
        k10 = strips__strip_field(strips__STRIP_A) + i;
        (*cspan_at(&work_t, k10)) = (*cspan_at(&work_t, k10)) * (*cspan_at(&work, block + layout__REGION_UPRIGHT_A)) + (*cspan_at(&work, k10)) * (*cspan_at(&work_t, block + layout__REGION_UPRIGHT_A));
        (*cspan_at(&work, k10)) = (*cspan_at(&work, k10)) * (*cspan_at(&work, block + layout__REGION_UPRIGHT_A));
        k11 = strips__strip_field(strips__STRIP_TURN) + i;
        (*cspan_at(&work_t, k11)) = turn_t * (*cspan_at(&work, block + layout__REGION_TURN)) + turn * (*cspan_at(&work_t, block + layout__REGION_TURN));
        (*cspan_at(&work, k11)) = turn * (*cspan_at(&work, block + layout__REGION_TURN));
    }
    return 0;
}

/* Tangent of ``node_value``. */
static inline int64_t tangent_strips__node_value_t(double* result_0, double* result_1, array_double_1d work, array_double_1d work_t, int64_t region, int64_t field, int64_t k, double x, double x_t)
{
    int64_t at;
    double v1;
    at = nodes__node_field(region, field) + k;
    v1 = (*cspan_at(&work, at + INT64_C(1))) - (*cspan_at(&work, at));
    (*result_0) = (*cspan_at(&work, at)) + x * v1;
    (*result_1) = (*cspan_at(&work_t, at)) + (x_t * v1 + x * ((*cspan_at(&work_t, at + INT64_C(1))) - (*cspan_at(&work_t, at))));
    return 0;
}

/* Tangent of ``describe_strips``. */
static inline int64_t tangent_strips__describe_strips_t(array_double_1d work, array_double_1d work_t, int64_t strips, double penetration, double penetration_t)
{
    int64_t halves;
    double longest_t;
    double longest;
    int64_t i;
    int64_t region;
    int64_t k;
    double x;
    double x_t;
    double v1;
    double v1_t;
    double line_t;
    double line;
    double v2;
    double v2_t;
    double length_t;
    double length;
    double v3;
    double v3_t;
    double level_t;
    double level;
    int64_t k4;
    double loaded;
    double square_t;
    double square;
    double v5;
    int64_t k6;
    int64_t k7;
    double v8;
    double below_t;
    double below;
    double v9;
    double v10;
    double v11;
    double inside_t;
    double inside;
    int64_t k12;
    double v13;
    halves = strips__strip_field(strips__STRIP_HALF);
    longest_t = 0.0;
    longest = 0.0;
    for (i = INT64_C(0); i < strips; i += INT64_C(1))
    {
        tangent_strips__locate_strip_t(&region, &k, &x, &x_t, work, work_t, i);
        tangent_strips__node_value_t(&v1, &v1_t, work, work_t, region, nodes__NODE_LINE, k, x, x_t);
        line_t = v1_t;
        line = v1;
        tangent_strips__node_value_t(&v2, &v2_t, work, work_t, region, nodes__NODE_LENGTH, k, x, x_t);
        length_t = v2_t;
        length = v2;
        tangent_strips__node_value_t(&v3, &v3_t, work, work_t, region, nodes__NODE_RISE, k, x, x_t);
        level_t = (*cspan_at(&work_t, layout__WORK_REGIONS + layout__REGION_SIZE * region + layout__REGION_LEVEL)) - v3_t;
        level = (*cspan_at(&work, layout__WORK_REGIONS + layout__REGION_SIZE * region + layout__REGION_LEVEL)) - v3;
        k4 = strips__strip_field(strips__STRIP_HERTZ) + i;
        (*cspan_at(&work_t, k4)) = line_t * length + line * length_t;
        (*cspan_at(&work, k4)) = line * length;
        loaded = 0.0;
        square_t = 0.0;
        square = 0.0;
        if (level > 0.0)
        {
            loaded = 1.0;
            v5 = level / length;
            square_t = (level_t - v5 * length_t) / length;
            square = v5;
        }
        k6 = strips__strip_field(strips__STRIP_GAP) + i;
        k7 = strips__strip_field(strips__STRIP_TURN) + i;
        v8 = (*cspan_at(&work, k6)) / (*cspan_at(&work, k7));
        below_t = penetration_t - ((*cspan_at(&work_t, k6)) - v8 * (*cspan_at(&work_t, k7))) / (*cspan_at(&work, k7));
        below = penetration - v8;
        below_t = below_t * (*cspan_at(&work, layout__WORK_REGIONS + layout__REGION_SIZE * region + layout__REGION_TURN)) + below * (*cspan_at(&work_t, layout__WORK_REGIONS + layout__REGION_SIZE * region + layout__REGION_TURN));
        below = below * (*cspan_at(&work, layout__WORK_REGIONS + layout__REGION_SIZE * region + layout__REGION_TURN));
        v9 = strips__INSIDE * strips__INSIDE;
        v10 = v9 * below;
        v11 = v10 / length;
        inside_t = (v9 * below_t - v11 * length_t) / length;
        inside = v11;
        if (inside > square)
        {
            square_t = inside_t;
            square = inside;
        }
        k12 = strips__strip_field(strips__STRIP_LOADED) + i;
        (*cspan_at(&work_t, k12)) = 0.0;
        (*cspan_at(&work, k12)) = loaded;
        v13 = sqrt(square);
        (*cspan_at(&work_t, halves + i)) = tangent_rates__root_rate(v13, square_t);
        (*cspan_at(&work, halves + i)) = v13;
        if ((loaded == 1.0) && ((*cspan_at(&work, halves + i)) > longest))
        {
            longest_t = (*cspan_at(&work_t, halves + i));
            longest = (*cspan_at(&work, halves + i));
        }
    }
    tangent_strips__keep_long_t(work, work_t, strips, longest, longest_t);
    return INT64_C(0);
}

/* Tangent of ``keep_long``. */
static inline int64_t tangent_strips__keep_long_t(array_double_1d work, array_double_1d work_t, int64_t strips, double longest, double longest_t)
{
    int64_t halves;
    int64_t widths;
    int64_t i;
    int64_t k1;
    halves = strips__strip_field(strips__STRIP_HALF);
    widths = strips__strip_field(strips__STRIP_WIDTH);
    for (i = INT64_C(0); i < strips; i += INT64_C(1))
    {
        if ((*cspan_at(&work, halves + i)) < strips__SHORTEST * longest)
        {
            (*cspan_at(&work_t, halves + i)) = strips__SHORTEST * longest_t;
            (*cspan_at(&work, halves + i)) = strips__SHORTEST * longest;
        }
        if ((*cspan_at(&work, halves + i)) < strips__SQUARE * (*cspan_at(&work, widths + i)))
        {
            (*cspan_at(&work_t, halves + i)) = strips__SQUARE * (*cspan_at(&work_t, widths + i));
            (*cspan_at(&work, halves + i)) = strips__SQUARE * (*cspan_at(&work, widths + i));
        }
        k1 = strips__strip_field(strips__STRIP_LOG) + i;
        (*cspan_at(&work_t, k1)) = (*cspan_at(&work_t, halves + i)) / (*cspan_at(&work, halves + i));
        (*cspan_at(&work, k1)) = log((*cspan_at(&work, halves + i)));
    }
    return INT64_C(0);
}

/* Tangent of ``fit_edges``. */
static inline int64_t tangent_strips__fit_edges_t(array_double_1d work, array_double_1d work_t, int64_t strips)
{
    int64_t lines;
    int64_t first;
    int64_t last;
    double v1;
    double v1_t;
    double start_t;
    double start;
    double v2;
    double v2_t;
    double stop_t;
    double stop;
    lines = strips__strip_field(strips__STRIP_LINE);
    first = INT64_C(0);
    while(first < strips)
    {
        last = first;
        if ((*cspan_at(&work, lines + first)) > 0.0)
        {
            last = strips__run_end(work, strips, first);
            if (last > first + INT64_C(2))
            {
                tangent_strips__run_edge_t(&v1, &v1_t, work, work_t, strips, first, last, -INT64_C(1));
                start_t = v1_t;
                start = v1;
                tangent_strips__run_edge_t(&v2, &v2_t, work, work_t, strips, last, first, INT64_C(1));
                stop_t = v2_t;
                stop = v2;
                tangent_strips__fit_edge_t(work, work_t, strips, first, start, start_t, -INT64_C(1));
                tangent_strips__fit_edge_t(work, work_t, strips, last, stop, stop_t, INT64_C(1));
            }
        }
        first = last + INT64_C(1);
    }
    return INT64_C(0);
}

/* Tangent of ``fit_edge``. */
static inline int64_t tangent_strips__fit_edge_t(array_double_1d work, array_double_1d work_t, int64_t strips, int64_t last, double edge, double edge_t, int64_t outward)
{
    double direction;
    int64_t k1;
    double width_t;
    double width;
    int64_t k2;
    double v3;
    double inner_t;
    double inner;
    double outer_t;
    double outer;
    int64_t beyond;
    int64_t pair;
    double touching_t;
    double touching;
    int64_t k4;
    int64_t k5;
    double v6;
    int64_t k7;
    double far_t;
    double far;
    int64_t before;
    int64_t k8;
    double v9;
    int64_t k10;
    double near_t;
    double near;
    int64_t k11;
    direction = (double)(outward);
    k1 = strips__strip_field(strips__STRIP_WIDTH) + last;
    width_t = (*cspan_at(&work_t, k1));
    width = (*cspan_at(&work, k1));
    k2 = strips__strip_field(strips__STRIP_STATION) + last;
    v3 = 0.5 * direction;
    inner_t = (*cspan_at(&work_t, k2)) - v3 * width_t;
    inner = (*cspan_at(&work, k2)) - v3 * width;
    outer_t = inner_t + direction * width_t;
    outer = inner + direction * width;
    beyond = last + outward;
    pair = last;
    if (outward < INT64_C(0))
    {
        pair = beyond;
    }
    touching_t = 0.0;
    touching = 0.0;
    if ((pair >= INT64_C(0)) && (pair < strips))
    {
        k4 = strips__strip_field(strips__STRIP_JOINED) + pair;
        touching_t = (*cspan_at(&work_t, k4));
        touching = (*cspan_at(&work, k4));
    }
    if ((edge - inner) * direction > 0.5 * width)
    {
        tangent_strips__set_strip_t(work, work_t, strips, last, inner, inner_t, edge, edge_t);
        if (((edge - outer) * direction > 0.0) && (touching == 1.0))
        {
            k5 = strips__strip_field(strips__STRIP_STATION) + beyond;
            v6 = 0.5 * direction;
            k7 = strips__strip_field(strips__STRIP_WIDTH) + beyond;
            far_t = (*cspan_at(&work_t, k5)) + v6 * (*cspan_at(&work_t, k7));
            far = (*cspan_at(&work, k5)) + v6 * (*cspan_at(&work, k7));
            tangent_strips__set_strip_t(work, work_t, strips, beyond, edge, edge_t, far, far_t);
        }
    }
    else
    {
        before = last - outward;
        k8 = strips__strip_field(strips__STRIP_STATION) + before;
        v9 = 0.5 * direction;
        k10 = strips__strip_field(strips__STRIP_WIDTH) + before;
        near_t = (*cspan_at(&work_t, k8)) - v9 * (*cspan_at(&work_t, k10));
        near = (*cspan_at(&work, k8)) - v9 * (*cspan_at(&work, k10));
        tangent_strips__set_strip_t(work, work_t, strips, before, near, near_t, edge, edge_t);
        tangent_strips__set_strip_t(work, work_t, strips, last, edge, edge_t, outer, outer_t);
        k11 = strips__strip_field(strips__STRIP_LOADED) + last;
        (*cspan_at(&work_t, k11)) = 0.0;
        (*cspan_at(&work, k11)) = 0.0;
    }
    return INT64_C(0);
}

/* Tangent of ``set_strip``. */
static inline int64_t tangent_strips__set_strip_t(array_double_1d work, array_double_1d work_t, int64_t strips, int64_t i, double start, double start_t, double stop, double stop_t)
{
    int64_t k1;
    double v2;
    int64_t k3;
    double v4;
    int64_t region;
    int64_t k;
    double x;
    double x_t;
    k1 = strips__strip_field(strips__STRIP_WIDTH) + i;
    v2 = stop - start;
    (*cspan_at(&work_t, k1)) = tangent_rates__size_rate(v2, stop_t - start_t);
    (*cspan_at(&work, k1)) = fabs(v2);
    k3 = strips__strip_field(strips__STRIP_STATION) + i;
    v4 = start + stop;
    (*cspan_at(&work_t, k3)) = 0.5 * (start_t + stop_t);
    (*cspan_at(&work, k3)) = 0.5 * v4;
    tangent_strips__locate_strip_t(&region, &k, &x, &x_t, work, work_t, i);
    tangent_strips__measure_distances_t(work, work_t, strips, i, strips);
    return INT64_C(0);
}

/* Tangent of ``measure_distances``. */
static inline int64_t tangent_strips__measure_distances_t(array_double_1d work, array_double_1d work_t, int64_t strips, int64_t i, int64_t others)
{
    int64_t stations;
    int64_t regions;
    int64_t row;
    int64_t j;
    double v1;
    double apart_t;
    double apart;
    double v2;
    double v2_t;
    double along_t;
    double along;
    double v3;
    double v4;
    double distance_t;
    double distance;
    stations = strips__strip_field(strips__STRIP_STATION);
    regions = strips__strip_field(strips__STRIP_REGION);
    row = layout__WORK_DISTANCE + strips * i;
    for (j = INT64_C(0); j < others; j += INT64_C(1))
    {
        if (j != i)
        {
            v1 = (*cspan_at(&work, stations + i)) - (*cspan_at(&work, stations + j));
            apart_t = tangent_rates__size_rate(v1, (*cspan_at(&work_t, stations + i)) - (*cspan_at(&work_t, stations + j)));
            apart = fabs(v1);
            if ((*cspan_at(&work, regions + i)) != (*cspan_at(&work, regions + j)))
            {
                tangent_interaction__region_lead_t(&v2, &v2_t, work, work_t, layout__WORK_REGIONS + layout__REGION_SIZE * (int64_t)((*cspan_at(&work, regions + i))), layout__WORK_REGIONS + layout__REGION_SIZE * (int64_t)((*cspan_at(&work, regions + j))));
                along_t = v2_t;
                along = v2;
                v3 = apart * apart + along * along;
                v4 = sqrt(v3);
                apart_t = tangent_rates__root_rate(v4, apart_t * apart + apart * apart_t + (along_t * along + along * along_t));
                apart = v4;
            }
            distance_t = apart_t / apart;
            distance = log(apart);
            (*cspan_at(&work_t, row + j)) = distance_t;
            (*cspan_at(&work, row + j)) = distance;
            (*cspan_at(&work_t, layout__WORK_DISTANCE + strips * j + i)) = distance_t;
            (*cspan_at(&work, layout__WORK_DISTANCE + strips * j + i)) = distance;
        }
    }
    return INT64_C(0);
}

/* Tangent of ``influence_value``. */
static inline int64_t tangent_strips__influence_value_t(double* result_0, double* result_1, array_double_1d tables, int64_t base, double abscissa, double abscissa_t)
{
    double v1;
    double u_t;
    double u;
    double last;
    int64_t cell;
    int64_t at;
    double v2;
    double v3;
    v1 = abscissa - (*cspan_at(&tables, base + strips__TABLE_START));
    u_t = abscissa_t * (*cspan_at(&tables, base + strips__TABLE_CELLS_PER_UNIT));
    u = v1 * (*cspan_at(&tables, base + strips__TABLE_CELLS_PER_UNIT));
    last = (*cspan_at(&tables, base + strips__TABLE_COUNT));
    if (!(u > 0.0))
    {
        u_t = 0.0;
        u = 0.0;
    }
    if (u > last)
    {
        u_t = 0.0;
        u = last;
    }
    cell = (int64_t)(u);
    u = u - (double)(cell);
    at = base + strips__TABLE_CELLS + strips__TABLE_ROW * cell;
    v2 = (*cspan_at(&tables, at + INT64_C(2))) + u * (*cspan_at(&tables, at + INT64_C(3)));
    v3 = (*cspan_at(&tables, at + INT64_C(1))) + u * v2;
    (*result_0) = (*cspan_at(&tables, at)) + u * v3;
    (*result_1) = u_t * v3 + u * (u_t * v2 + u * (u_t * (*cspan_at(&tables, at + INT64_C(3)))));
    return 0;
}

/* Tangent of ``near_share``. */
static inline int64_t tangent_strips__near_share_t(double* result_0, double* result_1, double share, double share_t)
{
    double square_t;
    double square;
    double v1;
    double rest_t;
    double rest;
    double v2;
    double v3;
    double v4;
    square_t = share_t * share + share * share_t;
    square = share * share;
    v1 = 1.0 / 72.0 + square / 110.0;
    rest_t = square_t * v1 + square * (square_t / 110.0);
    rest = 1.0 / 42.0 + square * v1;
    v2 = 2.0 * square;
    v3 = 1.0 / 20.0 + square * rest;
    v4 = 1.0 / 6.0 + square * v3;
    (*result_0) = v2 * v4;
    (*result_1) = 2.0 * square_t * v4 + v2 * (square_t * v3 + square * (square_t * rest + square * rest_t));
    return 0;
}

/* Tangent of ``fill_influence``. */
static inline int64_t tangent_strips__fill_influence_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t strips, int64_t count)
{
    int64_t base;
    int64_t stations;
    int64_t widths;
    int64_t halves;
    int64_t logs;
    int64_t i;
    int64_t row;
    int64_t distances;
    int64_t j;
    double v1;
    double v1_t;
    double v3;
    double v4;
    double v5;
    double v6;
    double v2;
    double v2_t;
    double v7;
    double v8;
    double v9;
    base = (int64_t)((*cspan_at(&tables, layout__TABLES_INFLUENCE)));
    stations = strips__strip_field(strips__STRIP_STATION);
    widths = strips__strip_field(strips__STRIP_WIDTH);
    halves = strips__strip_field(strips__STRIP_HALF);
    logs = strips__strip_field(strips__STRIP_LOG);
    for (i = INT64_C(0); i < strips; i += INT64_C(1))
    {
        row = layout__WORK_INFLUENCE + strips * i;
        distances = layout__WORK_DISTANCE + strips * i;
        for (j = INT64_C(0); j < strips; j += INT64_C(1))
        {
            if (j != i)
            {
                tangent_strips__influence_value_t(&v1, &v1_t, tables, base, (*cspan_at(&work, distances + j)) - (*cspan_at(&work, logs + j)), (*cspan_at(&work_t, distances + j)) - (*cspan_at(&work_t, logs + j)));
                (*cspan_at(&work_t, row + j)) = v1_t;
                (*cspan_at(&work, row + j)) = v1;
            }
        }
        for (j = i - INT64_C(2); j < i + INT64_C(3); j += INT64_C(1))
        {
            if ((j >= INT64_C(0)) && (j < strips) && (j != i))
            {
                v3 = 0.5 * (*cspan_at(&work, widths + j));
                v4 = (*cspan_at(&work, stations + i)) - (*cspan_at(&work, stations + j));
                v5 = fabs(v4);
                v6 = v3 / v5;
                tangent_strips__near_share_t(&v2, &v2_t, v6, (0.5 * (*cspan_at(&work_t, widths + j)) - v6 * tangent_rates__size_rate(v4, (*cspan_at(&work_t, stations + i)) - (*cspan_at(&work_t, stations + j)))) / v5);
                (*cspan_at(&work_t, row + j)) = (*cspan_at(&work_t, row + j)) + v2_t;
                (*cspan_at(&work, row + j)) = (*cspan_at(&work, row + j)) + v2;
            }
        }
        v7 = 8.0 * (*cspan_at(&work, halves + i));
        v8 = v7 / (*cspan_at(&work, widths + i));
        v9 = log(v8);
        (*cspan_at(&work_t, row + i)) = 2.0 * ((8.0 * (*cspan_at(&work_t, halves + i)) - v8 * (*cspan_at(&work_t, widths + i))) / (*cspan_at(&work, widths + i)) / v8);
        (*cspan_at(&work, row + i)) = 2.0 * v9;
    }
    if (count > INT64_C(1))
    {
        tangent_strips__turn_influence_t(work, work_t, strips);
    }
    return INT64_C(0);
}

/* Tangent of ``turn_influence``. */
static inline int64_t tangent_strips__turn_influence_t(array_double_1d work, array_double_1d work_t, int64_t strips)
{
    int64_t regions;
    int64_t i;
    int64_t j;
    double v1;
    double v1_t;
    double cosine_t;
    double cosine;
    regions = strips__strip_field(strips__STRIP_REGION);
    for (i = INT64_C(0); i < strips; i += INT64_C(1))
    {
        for (j = INT64_C(0); j < strips; j += INT64_C(1))
        {
            if ((*cspan_at(&work, regions + i)) != (*cspan_at(&work, regions + j)))
            {
                tangent_interaction__planes_cosine_t(&v1, &v1_t, work, work_t, layout__WORK_REGIONS + layout__REGION_SIZE * (int64_t)((*cspan_at(&work, regions + i))), layout__WORK_REGIONS + layout__REGION_SIZE * (int64_t)((*cspan_at(&work, regions + j))));
                cosine_t = v1_t;
                cosine = v1;
                (*cspan_at(&work_t, layout__WORK_INFLUENCE + strips * i + j)) = (*cspan_at(&work_t, layout__WORK_INFLUENCE + strips * i + j)) * cosine + (*cspan_at(&work, layout__WORK_INFLUENCE + strips * i + j)) * cosine_t;
                (*cspan_at(&work, layout__WORK_INFLUENCE + strips * i + j)) = (*cspan_at(&work, layout__WORK_INFLUENCE + strips * i + j)) * cosine;
            }
        }
    }
    return INT64_C(0);
}

/* Tangent of ``eliminate``. */
static inline int64_t tangent_strips__eliminate_t(array_double_1d work, array_double_1d work_t, int64_t size)
{
    int64_t width;
    int64_t pair;
    int64_t k;
    int64_t first;
    int64_t second;
    double v1;
    double inverse_t;
    double inverse;
    double factor_t;
    double factor;
    int64_t j;
    double v2;
    double next_inverse_t;
    double next_inverse;
    int64_t i;
    int64_t row;
    double v3;
    double next_factor_t;
    double next_factor;
    int64_t back;
    int64_t pivot;
    double unit_t;
    double unit;
    double rest_t;
    double rest;
    double v4;
    double v5;
    width = size + INT64_C(2);
    for (pair = INT64_C(0); pair < py_floor_div_int64_t(size, INT64_C(2)); pair += INT64_C(1))
    {
        k = INT64_C(2) * pair;
        first = layout__WORK_SYSTEM + width * k;
        second = first + width;
        v1 = 1.0 / (*cspan_at(&work, first + k));
        inverse_t = (-v1) * (*cspan_at(&work_t, first + k)) / (*cspan_at(&work, first + k));
        inverse = v1;
        factor_t = (*cspan_at(&work_t, second + k)) * inverse + (*cspan_at(&work, second + k)) * inverse_t;
        factor = (*cspan_at(&work, second + k)) * inverse;
        for (j = k + INT64_C(1); j < width; j += INT64_C(1))
        {
            (*cspan_at(&work_t, second + j)) = (*cspan_at(&work_t, second + j)) - (factor_t * (*cspan_at(&work, first + j)) + factor * (*cspan_at(&work_t, first + j)));
            (*cspan_at(&work, second + j)) = (*cspan_at(&work, second + j)) - factor * (*cspan_at(&work, first + j));
        }
        v2 = 1.0 / (*cspan_at(&work, second + k + INT64_C(1)));
        next_inverse_t = (-v2) * (*cspan_at(&work_t, second + k + INT64_C(1))) / (*cspan_at(&work, second + k + INT64_C(1)));
        next_inverse = v2;
        for (i = k + INT64_C(2); i < size; i += INT64_C(1))
        {
            row = layout__WORK_SYSTEM + width * i;
            factor_t = (*cspan_at(&work_t, row + k)) * inverse + (*cspan_at(&work, row + k)) * inverse_t;
            factor = (*cspan_at(&work, row + k)) * inverse;
            v3 = (*cspan_at(&work, row + k + INT64_C(1))) - factor * (*cspan_at(&work, first + k + INT64_C(1)));
            next_factor_t = ((*cspan_at(&work_t, row + k + INT64_C(1))) - (factor_t * (*cspan_at(&work, first + k + INT64_C(1))) + factor * (*cspan_at(&work_t, first + k + INT64_C(1))))) * next_inverse + v3 * next_inverse_t;
            next_factor = v3 * next_inverse;
            for (j = k + INT64_C(2); j < width; j += INT64_C(1))
            {
                (*cspan_at(&work_t, row + j)) = (*cspan_at(&work_t, row + j)) - (factor_t * (*cspan_at(&work, first + j)) + factor * (*cspan_at(&work_t, first + j))) - (next_factor_t * (*cspan_at(&work, second + j)) + next_factor * (*cspan_at(&work_t, second + j)));
                (*cspan_at(&work, row + j)) = (*cspan_at(&work, row + j)) - factor * (*cspan_at(&work, first + j)) - next_factor * (*cspan_at(&work, second + j));
            }
        }
    }
    for (back = INT64_C(0); back < size; back += INT64_C(1))
    {
        k = size - INT64_C(1) - back;
        pivot = layout__WORK_SYSTEM + width * k;
        unit_t = (*cspan_at(&work_t, pivot + size));
        unit = (*cspan_at(&work, pivot + size));
        rest_t = (*cspan_at(&work_t, pivot + size + INT64_C(1)));
        rest = (*cspan_at(&work, pivot + size + INT64_C(1)));
        for (j = k + INT64_C(1); j < size; j += INT64_C(1))
        {
            row = layout__WORK_SYSTEM + width * j;
            unit_t = unit_t - ((*cspan_at(&work_t, pivot + j)) * (*cspan_at(&work, row + size)) + (*cspan_at(&work, pivot + j)) * (*cspan_at(&work_t, row + size)));
            unit = unit - (*cspan_at(&work, pivot + j)) * (*cspan_at(&work, row + size));
            rest_t = rest_t - ((*cspan_at(&work_t, pivot + j)) * (*cspan_at(&work, row + size + INT64_C(1))) + (*cspan_at(&work, pivot + j)) * (*cspan_at(&work_t, row + size + INT64_C(1))));
            rest = rest - (*cspan_at(&work, pivot + j)) * (*cspan_at(&work, row + size + INT64_C(1)));
        }
        v4 = unit / (*cspan_at(&work, pivot + k));
        (*cspan_at(&work_t, pivot + size)) = (unit_t - v4 * (*cspan_at(&work_t, pivot + k))) / (*cspan_at(&work, pivot + k));
        (*cspan_at(&work, pivot + size)) = v4;
        v5 = rest / (*cspan_at(&work, pivot + k));
        (*cspan_at(&work_t, pivot + size + INT64_C(1))) = (rest_t - v5 * (*cspan_at(&work_t, pivot + k))) / (*cspan_at(&work, pivot + k));
        (*cspan_at(&work, pivot + size + INT64_C(1))) = v5;
    }
    return INT64_C(0);
}

/* Tangent of ``solve_loaded``. */
static inline int64_t tangent_strips__solve_loaded_t(double* penetration, double* penetration_t, array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t strips, double force, double force_t, double prescribed, double prescribed_t, int64_t by_penetration)
{
    int64_t ranks;
    int64_t size;
    int64_t i;
    int64_t rank;
    int64_t row;
    int64_t influences;
    int64_t other;
    int64_t k1;
    int64_t k2;
    int64_t k3;
    double unit_load_t;
    double unit_load;
    double rest_load_t;
    double rest_load;
    int64_t k4;
    double half_t;
    double half;
    int64_t k5;
    double v6;
    double v7;
    double v8;
    int64_t k9;
    int64_t k10;
    ranks = strips__strip_field(strips__STRIP_RANK);
    size = INT64_C(0);
    for (i = INT64_C(0); i < strips; i += INT64_C(1))
    {
        if ((*cspan_at(&work, strips__strip_field(strips__STRIP_LOADED) + i)) == 1.0)
        {
            (*cspan_at(&work_t, ranks + size)) = 0.0;
            (*cspan_at(&work, ranks + size)) = (double)(i);
            size = size + INT64_C(1);
        }
    }
    for (rank = INT64_C(0); rank < size; rank += INT64_C(1))
    {
        i = (int64_t)((*cspan_at(&work, ranks + rank)));
        row = layout__WORK_SYSTEM + (size + INT64_C(2)) * rank;
        influences = layout__WORK_INFLUENCE + strips * i;
        for (other = INT64_C(0); other < size; other += INT64_C(1))
        {
            k1 = influences + (int64_t)((*cspan_at(&work, ranks + other)));
            (*cspan_at(&work_t, row + other)) = (*cspan_at(&work_t, k1));
            (*cspan_at(&work, row + other)) = (*cspan_at(&work, k1));
        }
        k2 = strips__strip_field(strips__STRIP_TURN) + i;
        (*cspan_at(&work_t, row + size)) = (*cspan_at(&work_t, k2));
        (*cspan_at(&work, row + size)) = (*cspan_at(&work, k2));
        k3 = strips__strip_field(strips__STRIP_GAP) + i;
        (*cspan_at(&work_t, row + size + INT64_C(1))) = (*cspan_at(&work_t, k3));
        (*cspan_at(&work, row + size + INT64_C(1))) = (*cspan_at(&work, k3));
    }
    tangent_strips__eliminate_t(work, work_t, size);
    unit_load_t = 0.0;
    unit_load = 0.0;
    rest_load_t = 0.0;
    rest_load = 0.0;
    for (rank = INT64_C(0); rank < size; rank += INT64_C(1))
    {
        row = layout__WORK_SYSTEM + (size + INT64_C(2)) * rank;
        i = (int64_t)((*cspan_at(&work, ranks + rank)));
        k4 = strips__strip_field(strips__STRIP_HALF) + i;
        half_t = (*cspan_at(&work_t, k4));
        half = (*cspan_at(&work, k4));
        k5 = layout__WORK_REGIONS + layout__REGION_SIZE * (int64_t)((*cspan_at(&work, strips__strip_field(strips__STRIP_REGION) + i))) + layout__REGION_SHARE;
        half_t = half_t * (*cspan_at(&work, k5)) + half * (*cspan_at(&work_t, k5));
        half = half * (*cspan_at(&work, k5));
        unit_load_t = unit_load_t + (half_t * (*cspan_at(&work, row + size)) + half * (*cspan_at(&work_t, row + size)));
        unit_load = unit_load + half * (*cspan_at(&work, row + size));
        rest_load_t = rest_load_t + (half_t * (*cspan_at(&work, row + size + INT64_C(1))) + half * (*cspan_at(&work_t, row + size + INT64_C(1))));
        rest_load = rest_load + half * (*cspan_at(&work, row + size + INT64_C(1)));
    }
    (*penetration_t) = prescribed_t;
    (*penetration) = prescribed;
    if (by_penetration == INT64_C(0))
    {
        v6 = 0.5 * M_PI * M_PI * (*cspan_at(&tables, layout__TABLES_CONTACT_MODULUS));
        v7 = force / v6 + rest_load;
        v8 = v7 / unit_load;
        (*penetration_t) = (force_t / v6 + rest_load_t - v8 * unit_load_t) / unit_load;
        (*penetration) = v8;
    }
    for (i = INT64_C(0); i < strips; i += INT64_C(1))
    {
        k9 = strips__strip_field(strips__STRIP_SHARE) + i;
        (*cspan_at(&work_t, k9)) = 0.0;
        (*cspan_at(&work, k9)) = 0.0;
    }
    for (rank = INT64_C(0); rank < size; rank += INT64_C(1))
    {
        row = layout__WORK_SYSTEM + (size + INT64_C(2)) * rank;
        k10 = strips__strip_field(strips__STRIP_SHARE) + (int64_t)((*cspan_at(&work, ranks + rank)));
        (*cspan_at(&work_t, k10)) = (*penetration_t) * (*cspan_at(&work, row + size)) + (*penetration) * (*cspan_at(&work_t, row + size)) - (*cspan_at(&work_t, row + size + INT64_C(1)));
        (*cspan_at(&work, k10)) = (*penetration) * (*cspan_at(&work, row + size)) - (*cspan_at(&work, row + size + INT64_C(1)));
    }
    return 0;
}

/* Tangent of ``exchange_strips``. */
static inline int64_t tangent_strips__exchange_strips_t(array_double_1d work, array_double_1d work_t, int64_t strips, double penetration, double penetration_t, int64_t single)
{
    int64_t loaded;
    int64_t shares;
    int64_t back;
    int64_t i;
    int64_t k1;
    double v2;
    int64_t k3;
    double pushed_t;
    double pushed;
    int64_t row;
    int64_t j;
    int64_t changed;
    loaded = strips__strip_field(strips__STRIP_LOADED);
    shares = strips__strip_field(strips__STRIP_SHARE);
    changed = INT64_C(0);
    for (back = INT64_C(0); back < strips; back += INT64_C(1))
    {
        i = strips - INT64_C(1) - back;
        if ((single == INT64_C(0)) || (changed == INT64_C(0)))
        {
            if ((*cspan_at(&work, loaded + i)) == 1.0)
            {
                if ((*cspan_at(&work, shares + i)) < 0.0)
                {
                    (*cspan_at(&work_t, loaded + i)) = 0.0;
                    (*cspan_at(&work, loaded + i)) = 0.0;
                    changed = changed + INT64_C(1);
                }
            }
            else
            {
                k1 = strips__strip_field(strips__STRIP_TURN) + i;
                v2 = (*cspan_at(&work, k1)) - strips__TOUCH;
                k3 = strips__strip_field(strips__STRIP_GAP) + i;
                pushed_t = (*cspan_at(&work_t, k1)) * penetration + v2 * penetration_t - (*cspan_at(&work_t, k3));
                pushed = v2 * penetration - (*cspan_at(&work, k3));
                row = layout__WORK_INFLUENCE + strips * i;
                for (j = INT64_C(0); j < strips; j += INT64_C(1))
                {
                    pushed_t = pushed_t - ((*cspan_at(&work_t, row + j)) * (*cspan_at(&work, shares + j)) + (*cspan_at(&work, row + j)) * (*cspan_at(&work_t, shares + j)));
                    pushed = pushed - (*cspan_at(&work, row + j)) * (*cspan_at(&work, shares + j));
                }
                if (pushed > 0.0)
                {
                    (*cspan_at(&work_t, loaded + i)) = 0.0;
                    (*cspan_at(&work, loaded + i)) = 1.0;
                    changed = changed + INT64_C(1);
                }
            }
        }
    }
    return changed;
}

/* Tangent of ``solve_strips``. */
static inline int64_t tangent_strips__solve_strips_t(double* result_0, double* result_1, int64_t* result_2_0001, array_double_1d tables, array_double_1d work, array_double_1d work_t, array_double_1d state, int64_t strips, double force, double force_t, double prescribed, double prescribed_t, int64_t by_penetration)
{
    double penetration_t;
    double penetration;
    int64_t exchange;
    double v1;
    double v1_t;
    int64_t single;
    int64_t n2;
    penetration_t = prescribed_t;
    penetration = prescribed;
    for (exchange = INT64_C(0); exchange < strips__EXCHANGE_LIMIT; exchange += INT64_C(1))
    {
        (*cspan_at(&state, layout__STATE_STRIP_COUNT)) = (*cspan_at(&state, layout__STATE_STRIP_COUNT)) + 1.0;
        tangent_strips__solve_loaded_t(&v1, &v1_t, tables, work, work_t, strips, force, force_t, prescribed, prescribed_t, by_penetration);
        penetration_t = v1_t;
        penetration = v1;
        single = INT64_C(0);
        if (exchange >= strips__EXCHANGES)
        {
            single = INT64_C(1);
        }
        n2 = tangent_strips__exchange_strips_t(work, work_t, strips, penetration, penetration_t, single);
        if (n2 == INT64_C(0))
        {
            (*result_0) = penetration;
            (*result_1) = penetration_t;
            (*result_2_0001) = INT64_C(1);
            return 0;
        }
    }
    (*result_0) = penetration;
    (*result_1) = penetration_t;
    (*result_2_0001) = INT64_C(0);
    return 0;
}

/* Tangent of ``correct_lengths``. */
static inline int64_t tangent_strips__correct_lengths_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t strips)
{
    int64_t stations;
    int64_t halves;
    int64_t shares;
    double scale;
    int64_t i;
    double line_t;
    double line;
    double square_t;
    double square;
    double pressure_t;
    double pressure;
    double half_t;
    double half;
    double v1;
    double v2;
    int64_t k3;
    double v4;
    double bend_t;
    double bend;
    int64_t row;
    int64_t j;
    double away_t;
    double away;
    double v5;
    double v6;
    double v7;
    double v8;
    double v9;
    int64_t k10;
    double v11;
    double v12;
    double asked_t;
    double asked;
    int64_t k13;
    double v14;
    double hertz_t;
    double hertz;
    double v15;
    double v16;
    double v17;
    double v18;
    double v19;
    double v20;
    int64_t k21;
    int64_t k22;
    int64_t k23;
    stations = strips__strip_field(strips__STRIP_STATION);
    halves = strips__strip_field(strips__STRIP_HALF);
    shares = strips__strip_field(strips__STRIP_SHARE);
    scale = 0.5 * M_PI * M_PI * (*cspan_at(&tables, layout__TABLES_CONTACT_MODULUS));
    for (i = INT64_C(0); i < strips; i += INT64_C(1))
    {
        line_t = 0.0;
        line = 0.0;
        square_t = 0.0;
        square = 0.0;
        pressure_t = 0.0;
        pressure = 0.0;
        if ((*cspan_at(&work, shares + i)) > 0.0)
        {
            half_t = (*cspan_at(&work_t, halves + i));
            half = (*cspan_at(&work, halves + i));
            v1 = scale * half;
            v2 = v1 * (*cspan_at(&work, shares + i));
            k3 = strips__strip_field(strips__STRIP_WIDTH) + i;
            v4 = v2 / (*cspan_at(&work, k3));
            line_t = (scale * half_t * (*cspan_at(&work, shares + i)) + v1 * (*cspan_at(&work_t, shares + i)) - v4 * (*cspan_at(&work_t, k3))) / (*cspan_at(&work, k3));
            line = v4;
            bend_t = 0.0;
            bend = 0.0;
            row = layout__WORK_INFLUENCE + strips * i;
            for (j = INT64_C(0); j < strips; j += INT64_C(1))
            {
                away_t = (*cspan_at(&work_t, stations + i)) - (*cspan_at(&work_t, stations + j));
                away = (*cspan_at(&work, stations + i)) - (*cspan_at(&work, stations + j));
                v5 = (*cspan_at(&work, row + j)) * (*cspan_at(&work, shares + j));
                v6 = (*cspan_at(&work, halves + j)) * (*cspan_at(&work, halves + j)) + away * away;
                v7 = v5 / v6;
                bend_t = bend_t + ((*cspan_at(&work_t, row + j)) * (*cspan_at(&work, shares + j)) + (*cspan_at(&work, row + j)) * (*cspan_at(&work_t, shares + j)) - v7 * ((*cspan_at(&work_t, halves + j)) * (*cspan_at(&work, halves + j)) + (*cspan_at(&work, halves + j)) * (*cspan_at(&work_t, halves + j)) + (away_t * away + away * away_t))) / v6;
                bend = bend + v7;
            }
            v8 = half * half;
            v9 = v8 * bend;
            k10 = strips__strip_field(strips__STRIP_A) + i;
            v11 = 2.0 * (*cspan_at(&work, k10));
            v12 = v9 / v11;
            asked_t = ((half_t * half + half * half_t) * bend + v8 * bend_t - v12 * (2.0 * (*cspan_at(&work_t, k10)))) / v11;
            asked = v12;
            k13 = strips__strip_field(strips__STRIP_HERTZ) + i;
            v14 = line / (*cspan_at(&work, k13));
            hertz_t = (line_t - v14 * (*cspan_at(&work_t, k13))) / (*cspan_at(&work, k13));
            hertz = v14;
            v15 = asked * hertz;
            v16 = sqrt(v15);
            square_t = tangent_rates__root_rate(v16, asked_t * hertz + asked * hertz_t);
            square = v16;
            v17 = 2.0 / M_PI;
            v18 = v17 * line;
            v19 = sqrt(square);
            v20 = v18 / v19;
            pressure_t = (v17 * line_t - v20 * tangent_rates__root_rate(v19, square_t)) / v19;
            pressure = v20;
        }
        k21 = strips__strip_field(strips__STRIP_LINE) + i;
        (*cspan_at(&work_t, k21)) = line_t;
        (*cspan_at(&work, k21)) = line;
        k22 = strips__strip_field(strips__STRIP_SQUARE) + i;
        (*cspan_at(&work_t, k22)) = square_t;
        (*cspan_at(&work, k22)) = square;
        k23 = strips__strip_field(strips__STRIP_PRESSURE) + i;
        (*cspan_at(&work_t, k23)) = pressure_t;
        (*cspan_at(&work, k23)) = pressure;
    }
    return INT64_C(0);
}

/* Tangent of ``adopt_lengths``. */
static inline int64_t tangent_strips__adopt_lengths_t(array_double_1d work, array_double_1d work_t, int64_t strips)
{
    double longest_t;
    double longest;
    int64_t i;
    int64_t k1;
    double v2;
    double half_t;
    double half;
    int64_t k3;
    longest_t = 0.0;
    longest = 0.0;
    for (i = INT64_C(0); i < strips; i += INT64_C(1))
    {
        if ((*cspan_at(&work, strips__strip_field(strips__STRIP_SQUARE) + i)) > 0.0)
        {
            k1 = strips__strip_field(strips__STRIP_SQUARE) + i;
            v2 = sqrt((*cspan_at(&work, k1)));
            half_t = tangent_rates__root_rate(v2, (*cspan_at(&work_t, k1)));
            half = v2;
            k3 = strips__strip_field(strips__STRIP_HALF) + i;
            (*cspan_at(&work_t, k3)) = half_t;
            (*cspan_at(&work, k3)) = half;
            if (half > longest)
            {
                longest_t = half_t;
                longest = half;
            }
        }
    }
    tangent_strips__keep_long_t(work, work_t, strips, longest, longest_t);
    return INT64_C(0);
}

/* Tangent of ``run_edge``. */
static inline int64_t tangent_strips__run_edge_t(double* edge, double* edge_t, array_double_1d work, array_double_1d work_t, int64_t strips, int64_t last, int64_t first, int64_t outward)
{
    int64_t stations;
    int64_t lines;
    double station_t;
    double station;
    double v1;
    int64_t k2;
    double limit_t;
    double limit;
    int64_t after;
    int64_t beside;
    int64_t inner;
    double fall_t;
    double fall;
    double v3;
    double v4;
    double reach_t;
    double reach;
    stations = strips__strip_field(strips__STRIP_STATION);
    lines = strips__strip_field(strips__STRIP_LINE);
    station_t = (*cspan_at(&work_t, stations + last));
    station = (*cspan_at(&work, stations + last));
    v1 = 0.5 * (double)(outward);
    k2 = strips__strip_field(strips__STRIP_WIDTH) + last;
    (*edge_t) = station_t + v1 * (*cspan_at(&work_t, k2));
    (*edge) = station + v1 * (*cspan_at(&work, k2));
    if (last != first)
    {
        limit_t = (*edge_t);
        limit = (*edge);
        after = last + outward;
        beside = last;
        if (outward < INT64_C(0))
        {
            beside = last - INT64_C(1);
        }
        if ((after >= INT64_C(0)) && (after < strips))
        {
            if ((*cspan_at(&work, strips__strip_field(strips__STRIP_JOINED) + beside)) == 1.0)
            {
                limit_t = (*cspan_at(&work_t, stations + after));
                limit = (*cspan_at(&work, stations + after));
            }
        }
        inner = last - outward;
        fall_t = (*cspan_at(&work_t, lines + inner)) - (*cspan_at(&work_t, lines + last));
        fall = (*cspan_at(&work, lines + inner)) - (*cspan_at(&work, lines + last));
        (*edge_t) = limit_t;
        (*edge) = limit;
        if (fall > 0.0)
        {
            v3 = (*cspan_at(&work, lines + last)) / fall;
            v4 = station - (*cspan_at(&work, stations + inner));
            reach_t = ((*cspan_at(&work_t, lines + last)) - v3 * fall_t) / fall * v4 + v3 * (station_t - (*cspan_at(&work_t, stations + inner)));
            reach = v3 * v4;
            if (reach * (double)(outward) < (limit - station) * (double)(outward))
            {
                (*edge_t) = station_t + reach_t;
                (*edge) = station + reach;
            }
        }
    }
    return 0;
}

/* Tangent of ``start_loaded``. */
static inline int64_t tangent_strips__start_loaded_t(array_double_1d work, array_double_1d work_t, int64_t strips)
{
    int64_t least;
    double loaded_t;
    double loaded;
    int64_t i;
    int64_t k1;
    int64_t k2;
    least = INT64_C(0);
    loaded_t = 0.0;
    loaded = 0.0;
    for (i = INT64_C(0); i < strips; i += INT64_C(1))
    {
        k1 = strips__strip_field(strips__STRIP_LOADED) + i;
        loaded_t = loaded_t + (*cspan_at(&work_t, k1));
        loaded = loaded + (*cspan_at(&work, k1));
        if ((*cspan_at(&work, strips__strip_field(strips__STRIP_GAP) + i)) < (*cspan_at(&work, strips__strip_field(strips__STRIP_GAP) + least)))
        {
            least = i;
        }
    }
    if (loaded == 0.0)
    {
        k2 = strips__strip_field(strips__STRIP_LOADED) + least;
        (*cspan_at(&work_t, k2)) = 0.0;
        (*cspan_at(&work, k2)) = 1.0;
    }
    return INT64_C(0);
}

/* Tangent of ``correct_strips``. */
static inline int64_t tangent_strips__correct_strips_t(double* result_0, double* result_1, int64_t* result_2, int64_t* result_3, array_double_1d tables, array_double_1d work, array_double_1d work_t, array_double_1d state, int64_t count, double force, double force_t, double predicted, double predicted_t, int64_t by_penetration)
{
    int64_t n1;
    int64_t strips;
    int64_t i;
    double penetration_t;
    double penetration;
    int64_t met;
    int64_t sweeps;
    int64_t sweep;
    n1 = tangent_strips__place_strips_t(tables, work, work_t, count, predicted, predicted_t);
    strips = n1;
    tangent_strips__join_strips_t(work, work_t, strips);
    tangent_strips__describe_strips_t(work, work_t, strips, predicted, predicted_t);
    tangent_strips__start_loaded_t(work, work_t, strips);
    for (i = INT64_C(0); i < strips; i += INT64_C(1))
    {
        tangent_strips__measure_distances_t(work, work_t, strips, i, i);
    }
    penetration_t = predicted_t;
    penetration = predicted;
    met = INT64_C(0);
    sweeps = (int64_t)((*cspan_at(&tables, layout__TABLES_SWEEPS)));
    for (sweep = INT64_C(0); sweep < sweeps; sweep += INT64_C(1))
    {
        tangent_strips__fill_influence_t(tables, work, work_t, strips, count);
        tangent_strips__solve_strips_t(&penetration, &penetration_t, &met, tables, work, work_t, state, strips, force, force_t, predicted, predicted_t, by_penetration);
        if (met == INT64_C(0))
        {
            (*result_0) = penetration;
            (*result_1) = penetration_t;
            (*result_2) = strips;
            (*result_3) = met;
            return 0;
        }
        tangent_strips__correct_lengths_t(tables, work, work_t, strips);
        if (sweep < sweeps - INT64_C(1))
        {
            tangent_strips__adopt_lengths_t(work, work_t, strips);
            tangent_strips__fit_edges_t(work, work_t, strips);
        }
    }
    (*result_0) = penetration;
    (*result_1) = penetration_t;
    (*result_2) = strips;
    (*result_3) = met;
    return 0;
}
