/* Generated from tangent_strip_placement.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of strip_placement.py.
 */

#include "tangent_strip_placement.h"

/* Tangent of ``place_strips``. */
static inline int64_t tangent_strip_placement__place_strips_t(array_double_1d work, array_double_1d work_t, int64_t count, int64_t wanted, double penetration, double penetration_t)
{
    double weight_t;
    double weight;
    double width_t;
    double width;
    int64_t i;
    int64_t zone;
    int64_t strips;
    double length_t;
    double length;
    double v1;
    double v2;
    double v3;
    double share_t;
    double share;
    int64_t own;
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_PENETRATION)) = penetration_t;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_PENETRATION)) = penetration;
    weight_t = 0.0;
    weight = 0.0;
    width_t = 0.0;
    width = 0.0;
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        zone = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_ZONES + layout__STRIP_ZONE_SIZE * i;
        tangent_strip_placement__measure_zone_t(work, work_t, zone, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * i, layout__WORK_CONTACT + layout__CONTACT_NODES + layout__NODES_SIZE * i, penetration, penetration_t);
        weight_t = weight_t + (*cspan_at(&work_t, zone + layout__STRIP_ZONE_WEIGHT));
        weight = weight + (*cspan_at(&work, zone + layout__STRIP_ZONE_WEIGHT));
        width_t = width_t + ((*cspan_at(&work_t, zone + layout__STRIP_ZONE_STOP)) - (*cspan_at(&work_t, zone + layout__STRIP_ZONE_START)));
        width = width + ((*cspan_at(&work, zone + layout__STRIP_ZONE_STOP)) - (*cspan_at(&work, zone + layout__STRIP_ZONE_START)));
    }
    strips = INT64_C(0);
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        zone = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_ZONES + layout__STRIP_ZONE_SIZE * i;
        length_t = (*cspan_at(&work_t, zone + layout__STRIP_ZONE_STOP)) - (*cspan_at(&work_t, zone + layout__STRIP_ZONE_START));
        length = (*cspan_at(&work, zone + layout__STRIP_ZONE_STOP)) - (*cspan_at(&work, zone + layout__STRIP_ZONE_START));
        if ((length > 0.0) && (weight > 0.0))
        {
            v1 = strip_placement__EVEN / width;
            (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_EVEN)) = (-v1) * width_t / width;
            (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_EVEN)) = v1;
            v2 = 1.0 - strip_placement__EVEN;
            v3 = v2 / weight;
            (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_GRADED)) = (-v3) * weight_t / weight;
            (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_GRADED)) = v3;
            share_t = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_EVEN)) * length + (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_EVEN)) * length_t + ((*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_GRADED)) * (*cspan_at(&work, zone + layout__STRIP_ZONE_WEIGHT)) + (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_GRADED)) * (*cspan_at(&work_t, zone + layout__STRIP_ZONE_WEIGHT)));
            share = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_EVEN)) * length + (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_GRADED)) * (*cspan_at(&work, zone + layout__STRIP_ZONE_WEIGHT));
            own = (int64_t)((double)(wanted) * share + 0.5);
            if (own < strip_placement__FEWEST)
            {
                own = strip_placement__FEWEST;
            }
            tangent_strip_placement__divide_zone_t(work, work_t, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * i, layout__WORK_CONTACT + layout__CONTACT_NODES + layout__NODES_SIZE * i, i, strips, own);
            strips = strips + own;
        }
    }
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT)) = 0.0;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT)) = (double)(strips);
    tangent_strip_placement__join_strips_t(work, work_t, strips);
    return INT64_C(0);
}

/* Tangent of ``measure_zone``. */
static inline int64_t tangent_strip_placement__measure_zone_t(array_double_1d work, array_double_1d work_t, int64_t zone, int64_t region, int64_t nodes, double penetration, double penetration_t)
{
    double own_t;
    double own;
    double v1;
    double v1_t;
    double v2;
    double v2_t;
    double v3;
    double v3_t;
    own_t = (*cspan_at(&work_t, region + layout__REGION_ALIGNMENT)) * penetration + (*cspan_at(&work, region + layout__REGION_ALIGNMENT)) * penetration_t;
    own = (*cspan_at(&work, region + layout__REGION_ALIGNMENT)) * penetration;
    (*cspan_at(&work_t, zone + layout__STRIP_ZONE_PENETRATION)) = own_t;
    (*cspan_at(&work, zone + layout__STRIP_ZONE_PENETRATION)) = own;
    tangent_strip_placement__zone_end_t(&v1, &v1_t, work, work_t, region, nodes, -INT64_C(1), own, own_t);
    (*cspan_at(&work_t, zone + layout__STRIP_ZONE_START)) = v1_t;
    (*cspan_at(&work, zone + layout__STRIP_ZONE_START)) = v1;
    tangent_strip_placement__zone_end_t(&v2, &v2_t, work, work_t, region, nodes, INT64_C(1), own, own_t);
    (*cspan_at(&work_t, zone + layout__STRIP_ZONE_STOP)) = v2_t;
    (*cspan_at(&work, zone + layout__STRIP_ZONE_STOP)) = v2;
    tangent_strip_placement__zone_weight_t(&v3, &v3_t, work, work_t, zone, region, nodes);
    (*cspan_at(&work_t, zone + layout__STRIP_ZONE_WEIGHT)) = v3_t;
    (*cspan_at(&work, zone + layout__STRIP_ZONE_WEIGHT)) = v3;
    return INT64_C(0);
}

/* Tangent of ``zone_excess``. */
static inline int64_t tangent_strip_placement__zone_excess_t(double* excess, double* excess_t, array_double_1d work, array_double_1d work_t, int64_t region, int64_t nodes, int64_t k, double penetration, double penetration_t)
{
    double level_t;
    double level;
    double beyond_t;
    double beyond;
    (*excess_t) = strip_placement__ZONE * penetration_t - (*cspan_at(&work_t, region + layout__REGION_GAP)) - (*cspan_at(&work_t, nodes + layout__NODES_GAP + INT64_C(128) + k));
    (*excess) = strip_placement__ZONE * penetration - (*cspan_at(&work, region + layout__REGION_GAP)) - (*cspan_at(&work, nodes + layout__NODES_GAP + INT64_C(128) + k));
    level_t = (*cspan_at(&work_t, region + layout__REGION_LOCAL_PENETRATION)) - (*cspan_at(&work_t, nodes + layout__NODES_RISE + INT64_C(128) + k));
    level = (*cspan_at(&work, region + layout__REGION_LOCAL_PENETRATION)) - (*cspan_at(&work, nodes + layout__NODES_RISE + INT64_C(128) + k));
    beyond_t = level_t + strip_placement__BEYOND * penetration_t;
    beyond = level + strip_placement__BEYOND * penetration;
    if (beyond < (*excess))
    {
        (*excess_t) = beyond_t;
        (*excess) = beyond;
    }
    if (level > (*excess))
    {
        (*excess_t) = level_t;
        (*excess) = level;
    }
    return 0;
}

/* Tangent of ``zone_end``. */
static inline int64_t tangent_strip_placement__zone_end_t(double* station, double* station_t, array_double_1d work, array_double_1d work_t, int64_t region, int64_t nodes, int64_t direction, double penetration, double penetration_t)
{
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
    last = (int64_t)((*cspan_at(&work, region + layout__REGION_LAST)));
    bound_t = (*cspan_at(&work_t, region + layout__REGION_HIGH));
    bound = (*cspan_at(&work, region + layout__REGION_HIGH));
    if (direction < INT64_C(0))
    {
        last = -(int64_t)((*cspan_at(&work, region + layout__REGION_FIRST)));
        bound_t = (*cspan_at(&work_t, region + layout__REGION_LOW));
        bound = (*cspan_at(&work, region + layout__REGION_LOW));
    }
    tangent_strip_placement__zone_excess_t(&v1, &v1_t, work, work_t, region, nodes, INT64_C(0), penetration, penetration_t);
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
            tangent_strip_placement__zone_excess_t(&v2, &v2_t, work, work_t, region, nodes, direction * k, penetration, penetration_t);
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
    (*station_t) = (*cspan_at(&work_t, region + layout__REGION_STATION)) + (v5 * reach_t * (*cspan_at(&work, region + layout__REGION_SPACING)) + v6 * (*cspan_at(&work_t, region + layout__REGION_SPACING)));
    (*station) = (*cspan_at(&work, region + layout__REGION_STATION)) + v6 * (*cspan_at(&work, region + layout__REGION_SPACING));
    if (((*station) - bound) * (double)(direction) > 0.0)
    {
        (*station_t) = bound_t;
        (*station) = bound;
    }
    return 0;
}

/* Tangent of ``node_weight``. */
static inline int64_t tangent_strip_placement__node_weight_t(double* weight, double* weight_t, array_double_1d work, array_double_1d work_t, int64_t region, int64_t nodes, int64_t k, double penetration, double penetration_t)
{
    double v1;
    double v2;
    double share_t;
    double share;
    double v3;
    double v4;
    v1 = (*cspan_at(&work, region + layout__REGION_GAP)) + (*cspan_at(&work, nodes + layout__NODES_GAP + INT64_C(128) + k));
    v2 = v1 / penetration;
    share_t = -(((*cspan_at(&work_t, region + layout__REGION_GAP)) + (*cspan_at(&work_t, nodes + layout__NODES_GAP + INT64_C(128) + k)) - v2 * penetration_t) / penetration);
    share = 1.0 - v2;
    (*weight_t) = 0.0;
    (*weight) = 0.0;
    if (share > 0.0)
    {
        v3 = (*cspan_at(&work, nodes + layout__NODES_B + INT64_C(128) + k)) * share;
        v4 = sqrt(v3);
        (*weight_t) = tangent_rates__root_rate(v4, (*cspan_at(&work_t, nodes + layout__NODES_B + INT64_C(128) + k)) * share + (*cspan_at(&work, nodes + layout__NODES_B + INT64_C(128) + k)) * share_t);
        (*weight) = v4;
    }
    return 0;
}

/* Tangent of ``cell_overlap``. */
static inline int64_t tangent_strip_placement__cell_overlap_t(double* result_0, double* result_1, double* start, double* start_t, array_double_1d work, array_double_1d work_t, int64_t zone, int64_t region, int64_t k)
{
    double spacing_t;
    double spacing;
    double v1;
    double stop_t;
    double stop;
    spacing_t = (*cspan_at(&work_t, region + layout__REGION_SPACING));
    spacing = (*cspan_at(&work, region + layout__REGION_SPACING));
    v1 = (double)(k);
    (*start_t) = (*cspan_at(&work_t, region + layout__REGION_STATION)) + spacing_t * v1;
    (*start) = (*cspan_at(&work, region + layout__REGION_STATION)) + spacing * v1;
    stop_t = (*start_t) + spacing_t;
    stop = (*start) + spacing;
    if ((*start) < (*cspan_at(&work, zone + layout__STRIP_ZONE_START)))
    {
        (*start_t) = (*cspan_at(&work_t, zone + layout__STRIP_ZONE_START));
        (*start) = (*cspan_at(&work, zone + layout__STRIP_ZONE_START));
    }
    if (stop > (*cspan_at(&work, zone + layout__STRIP_ZONE_STOP)))
    {
        stop_t = (*cspan_at(&work_t, zone + layout__STRIP_ZONE_STOP));
        stop = (*cspan_at(&work, zone + layout__STRIP_ZONE_STOP));
    }
    (*result_0) = stop - (*start);
    (*result_1) = stop_t - (*start_t);
    return 0;
}

/* Tangent of ``zone_weight``. */
static inline int64_t tangent_strip_placement__zone_weight_t(double* total, double* total_t, array_double_1d work, array_double_1d work_t, int64_t zone, int64_t region, int64_t nodes)
{
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
    (*total_t) = 0.0;
    (*total) = 0.0;
    tangent_strip_placement__node_weight_t(&v1, &v1_t, work, work_t, region, nodes, (int64_t)((*cspan_at(&work, region + layout__REGION_FIRST))), (*cspan_at(&work, zone + layout__STRIP_ZONE_PENETRATION)), (*cspan_at(&work_t, zone + layout__STRIP_ZONE_PENETRATION)));
    before_t = v1_t;
    before = v1;
    k_end = (int64_t)((*cspan_at(&work, region + layout__REGION_LAST)));
    for (k = (int64_t)((*cspan_at(&work, region + layout__REGION_FIRST))); k < k_end; k += INT64_C(1))
    {
        tangent_strip_placement__node_weight_t(&v2, &v2_t, work, work_t, region, nodes, k + INT64_C(1), (*cspan_at(&work, zone + layout__STRIP_ZONE_PENETRATION)), (*cspan_at(&work_t, zone + layout__STRIP_ZONE_PENETRATION)));
        after_t = v2_t;
        after = v2;
        tangent_strip_placement__cell_overlap_t(&length, &length_t, &start, &start_t, work, work_t, zone, region, k);
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

/* Tangent of ``divide_zone``. */
static inline int64_t tangent_strip_placement__divide_zone_t(array_double_1d work, array_double_1d work_t, int64_t region, int64_t nodes, int64_t index, int64_t first, int64_t own)
{
    int64_t zone;
    double even_t;
    double even;
    double graded_t;
    double graded;
    double v1;
    double v2;
    double v3;
    double each_t;
    double each;
    double done_t;
    double done;
    int64_t made;
    double edge_t;
    double edge;
    double v4;
    double v4_t;
    double before_t;
    double before;
    int64_t k_end;
    int64_t k;
    double v5;
    double v5_t;
    double after_t;
    double after;
    double length;
    double length_t;
    double start;
    double start_t;
    double v6;
    double v7;
    double density_t;
    double density;
    double v8;
    double v9;
    double v10;
    double cut_t;
    double cut;
    double v11;
    double v12;
    zone = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_ZONES + layout__STRIP_ZONE_SIZE * index;
    even_t = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_EVEN));
    even = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_EVEN));
    graded_t = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_GRADED));
    graded = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_GRADED));
    v1 = (*cspan_at(&work, zone + layout__STRIP_ZONE_STOP)) - (*cspan_at(&work, zone + layout__STRIP_ZONE_START));
    v2 = even * v1 + graded * (*cspan_at(&work, zone + layout__STRIP_ZONE_WEIGHT));
    v3 = (double)(own);
    each_t = (even_t * v1 + even * ((*cspan_at(&work_t, zone + layout__STRIP_ZONE_STOP)) - (*cspan_at(&work_t, zone + layout__STRIP_ZONE_START))) + (graded_t * (*cspan_at(&work, zone + layout__STRIP_ZONE_WEIGHT)) + graded * (*cspan_at(&work_t, zone + layout__STRIP_ZONE_WEIGHT)))) / v3;
    each = v2 / v3;
    done_t = 0.0;
    done = 0.0;
    made = INT64_C(0);
    edge_t = (*cspan_at(&work_t, zone + layout__STRIP_ZONE_START));
    edge = (*cspan_at(&work, zone + layout__STRIP_ZONE_START));
    tangent_strip_placement__node_weight_t(&v4, &v4_t, work, work_t, region, nodes, (int64_t)((*cspan_at(&work, region + layout__REGION_FIRST))), (*cspan_at(&work, zone + layout__STRIP_ZONE_PENETRATION)), (*cspan_at(&work_t, zone + layout__STRIP_ZONE_PENETRATION)));
    before_t = v4_t;
    before = v4;
    k_end = (int64_t)((*cspan_at(&work, region + layout__REGION_LAST)));
    for (k = (int64_t)((*cspan_at(&work, region + layout__REGION_FIRST))); k < k_end; k += INT64_C(1))
    {
        tangent_strip_placement__node_weight_t(&v5, &v5_t, work, work_t, region, nodes, k + INT64_C(1), (*cspan_at(&work, zone + layout__STRIP_ZONE_PENETRATION)), (*cspan_at(&work_t, zone + layout__STRIP_ZONE_PENETRATION)));
        after_t = v5_t;
        after = v5;
        tangent_strip_placement__cell_overlap_t(&length, &length_t, &start, &start_t, work, work_t, zone, region, k);
        if (length > 0.0)
        {
            v6 = graded * 0.5;
            v7 = before + after;
            density_t = even_t + (graded_t * 0.5 * v7 + v6 * (before_t + after_t));
            density = even + v6 * v7;
            while((made < own - INT64_C(1)) && (done + density * length >= each * (double)(made + INT64_C(1))))
            {
                v8 = (double)(made + INT64_C(1));
                v9 = each * v8 - done;
                v10 = v9 / density;
                cut_t = start_t + (each_t * v8 - done_t - v10 * density_t) / density;
                cut = start + v10;
                tangent_strip_placement__cut_strip_t(work, work_t, first + made, index, (*cspan_at(&work, region + layout__REGION_OFFSET)), (*cspan_at(&work_t, region + layout__REGION_OFFSET)), edge, edge_t, cut, cut_t);
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
        v11 = (*cspan_at(&work, zone + layout__STRIP_ZONE_STOP)) - edge;
        v12 = (double)(own - made);
        cut_t = edge_t + ((*cspan_at(&work_t, zone + layout__STRIP_ZONE_STOP)) - edge_t) / v12;
        cut = edge + v11 / v12;
        tangent_strip_placement__cut_strip_t(work, work_t, first + made, index, (*cspan_at(&work, region + layout__REGION_OFFSET)), (*cspan_at(&work_t, region + layout__REGION_OFFSET)), edge, edge_t, cut, cut_t);
        edge_t = cut_t;
        edge = cut;
        made = made + INT64_C(1);
    }
    return INT64_C(0);
}

/* Tangent of ``cut_strip``. */
static inline int64_t tangent_strip_placement__cut_strip_t(array_double_1d work, array_double_1d work_t, int64_t i, int64_t index, double offset, double offset_t, double start, double start_t, double stop, double stop_t)
{
    double v1;
    v1 = start + stop;
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_STATION)) = offset_t + 0.5 * (start_t + stop_t);
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_STATION)) = offset + 0.5 * v1;
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_WIDTH)) = stop_t - start_t;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_WIDTH)) = stop - start;
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_REGION)) = 0.0;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_REGION)) = (double)(index);
    return INT64_C(0);
}

/* Tangent of ``join_strips``. */
static inline int64_t tangent_strip_placement__join_strips_t(array_double_1d work, array_double_1d work_t, int64_t count)
{
    int64_t i;
    int64_t joined;
    double v1;
    double reach_t;
    double reach;
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        joined = INT64_C(0);
        if (i < count - INT64_C(1))
        {
            v1 = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_WIDTH)) + (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (i + INT64_C(1)) + layout__STRIP_WIDTH));
            reach_t = 0.5 * ((*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_WIDTH)) + (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (i + INT64_C(1)) + layout__STRIP_WIDTH)));
            reach = 0.5 * v1;
            if ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (i + INT64_C(1)) + layout__STRIP_STATION)) - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_STATION)) < reach * (1.0 + strip_placement__TOUCHING))
            {
                joined = INT64_C(1);
            }
        }
        (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_JOINED)) = 0.0;
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_JOINED)) = (double)(joined);
    }
    return INT64_C(0);
}
