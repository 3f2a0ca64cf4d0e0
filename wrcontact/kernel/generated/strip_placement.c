/* Generated from normal/strip_placement.py by tools/transpile_kernel.py; change that one.
 *
 * Where the strips of the strip correction lie: how far the zone of each region reaches, and how strips
 * divide it.
 *
 * Half of the strips are spread evenly.  The others have the density sqrt(B) sqrt(1 - g / penetration): they are
 * narrower where the gap bends and near the contact (docs/method.md, section 9).
 */

#include "strip_placement.h"

/* Lay about ``wanted`` strips over the zones of ``count`` regions at ANALYN's ``penetration`` [m]. */
static inline int64_t strip_placement__place_strips(array_double_1d work, int64_t count, int64_t wanted, double penetration)
{
    double weight;
    double width;
    int64_t i;
    int64_t zone;
    int64_t strips;
    double length;
    double share;
    int64_t own;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_PENETRATION)) = penetration;
    weight = 0.0;
    width = 0.0;
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        zone = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_ZONES + layout__STRIP_ZONE_SIZE * i;
        strip_placement__measure_zone(work, zone, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * i, layout__WORK_CONTACT + layout__CONTACT_NODES + layout__NODES_SIZE * i, penetration);
        weight += (*cspan_at(&work, zone + layout__STRIP_ZONE_WEIGHT));
        width += (*cspan_at(&work, zone + layout__STRIP_ZONE_STOP)) - (*cspan_at(&work, zone + layout__STRIP_ZONE_START));
    }
    strips = INT64_C(0);
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        zone = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_ZONES + layout__STRIP_ZONE_SIZE * i;
        length = (*cspan_at(&work, zone + layout__STRIP_ZONE_STOP)) - (*cspan_at(&work, zone + layout__STRIP_ZONE_START));
        if ((length > 0.0) && (weight > 0.0))
        {
            (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_EVEN)) = strip_placement__EVEN / width;
            (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_GRADED)) = (1.0 - strip_placement__EVEN) / weight;
            share = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_EVEN)) * length + (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_GRADED)) * (*cspan_at(&work, zone + layout__STRIP_ZONE_WEIGHT));
            own = (int64_t)((double)(wanted) * share + 0.5);
            if (own < strip_placement__FEWEST)
            {
                own = strip_placement__FEWEST;
            }
            strip_placement__divide_zone(work, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * i, layout__WORK_CONTACT + layout__CONTACT_NODES + layout__NODES_SIZE * i, i, strips, own);
            strips += own;
        }
    }
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT)) = (double)(strips);
    strip_placement__join_strips(work, strips);
    return INT64_C(0);
}

/* Ends and weight of a region's zone at the total ``penetration`` [m]. */
static inline int64_t strip_placement__measure_zone(array_double_1d work, int64_t zone, int64_t region, int64_t nodes, double penetration)
{
    double own;
    own = (*cspan_at(&work, region + layout__REGION_ALIGNMENT)) * penetration;
    (*cspan_at(&work, zone + layout__STRIP_ZONE_PENETRATION)) = own;
    (*cspan_at(&work, zone + layout__STRIP_ZONE_START)) = strip_placement__zone_end(work, region, nodes, -INT64_C(1), own);
    (*cspan_at(&work, zone + layout__STRIP_ZONE_STOP)) = strip_placement__zone_end(work, region, nodes, INT64_C(1), own);
    (*cspan_at(&work, zone + layout__STRIP_ZONE_WEIGHT)) = strip_placement__zone_weight(work, zone, region, nodes);
    return INT64_C(0);
}

/* How far node ``k`` is inside the zone, as a height [m]; negative outside. */
static inline double strip_placement__zone_excess(array_double_1d work, int64_t region, int64_t nodes, int64_t k, double penetration)
{
    double level;
    double beyond;
    double excess;
    excess = strip_placement__ZONE * penetration - (*cspan_at(&work, region + layout__REGION_GAP)) - (*cspan_at(&work, nodes + layout__NODES_GAP + INT64_C(128) + k));
    level = (*cspan_at(&work, region + layout__REGION_LOCAL_PENETRATION)) - (*cspan_at(&work, nodes + layout__NODES_RISE + INT64_C(128) + k));
    beyond = level + strip_placement__BEYOND * penetration;
    if (beyond < excess)
    {
        excess = beyond;
    }
    if (level > excess)
    {
        excess = level;
    }
    return excess;
}

/* Station [m] where the region's zone ends in ``direction``; that of its minimum if there is no zone. */
static inline double strip_placement__zone_end(array_double_1d work, int64_t region, int64_t nodes, int64_t direction, double penetration)
{
    int64_t last;
    double bound;
    double inner;
    double reach;
    int64_t k;
    double outer;
    double station;
    last = (int64_t)((*cspan_at(&work, region + layout__REGION_LAST)));
    bound = (*cspan_at(&work, region + layout__REGION_HIGH));
    if (direction < INT64_C(0))
    {
        last = -(int64_t)((*cspan_at(&work, region + layout__REGION_FIRST)));
        bound = (*cspan_at(&work, region + layout__REGION_LOW));
    }
    inner = strip_placement__zone_excess(work, region, nodes, INT64_C(0), penetration);
    reach = 0.0;
    if (inner > 0.0)
    {
        reach = (double)(last);
        for (k = INT64_C(1); k < last + INT64_C(1); k += INT64_C(1))
        {
            outer = strip_placement__zone_excess(work, region, nodes, direction * k, penetration);
            if (outer <= 0.0)
            {
                reach = (double)(k - INT64_C(1)) + inner / (inner - outer);
                break;
            }
            inner = outer;
        }
    }
    station = (*cspan_at(&work, region + layout__REGION_STATION)) + (double)(direction) * reach * (*cspan_at(&work, region + layout__REGION_SPACING));
    if ((station - bound) * (double)(direction) > 0.0)
    {
        station = bound;
    }
    return station;
}

/* sqrt(B) sqrt(1 - g / penetration) at node ``k`` [m^-1/2]. */
static inline double strip_placement__node_weight(array_double_1d work, int64_t region, int64_t nodes, int64_t k, double penetration)
{
    double share;
    double weight;
    share = 1.0 - ((*cspan_at(&work, region + layout__REGION_GAP)) + (*cspan_at(&work, nodes + layout__NODES_GAP + INT64_C(128) + k))) / penetration;
    weight = 0.0;
    if (share > 0.0)
    {
        weight = sqrt((*cspan_at(&work, nodes + layout__NODES_B + INT64_C(128) + k)) * share);
    }
    return weight;
}

/* Length of the cell between nodes ``k`` and ``k`` + 1 inside the zone [m], and the station where it
 * begins there [m].
 */
static inline int64_t strip_placement__cell_overlap(double* result_0, double* start, array_double_1d work, int64_t zone, int64_t region, int64_t k)
{
    double spacing;
    double stop;
    spacing = (*cspan_at(&work, region + layout__REGION_SPACING));
    (*start) = (*cspan_at(&work, region + layout__REGION_STATION)) + spacing * (double)(k);
    stop = (*start) + spacing;
    if ((*start) < (*cspan_at(&work, zone + layout__STRIP_ZONE_START)))
    {
        (*start) = (*cspan_at(&work, zone + layout__STRIP_ZONE_START));
    }
    if (stop > (*cspan_at(&work, zone + layout__STRIP_ZONE_STOP)))
    {
        stop = (*cspan_at(&work, zone + layout__STRIP_ZONE_STOP));
    }
    (*result_0) = stop - (*start);
    return 0;
}

/* Integral of ``node_weight`` over the zone [m^1/2]. */
static inline double strip_placement__zone_weight(array_double_1d work, int64_t zone, int64_t region, int64_t nodes)
{
    double before;
    int64_t k_end;
    int64_t k;
    double after;
    double length;
    double start;
    double total;
    total = 0.0;
    before = strip_placement__node_weight(work, region, nodes, (int64_t)((*cspan_at(&work, region + layout__REGION_FIRST))), (*cspan_at(&work, zone + layout__STRIP_ZONE_PENETRATION)));
    k_end = (int64_t)((*cspan_at(&work, region + layout__REGION_LAST)));
    for (k = (int64_t)((*cspan_at(&work, region + layout__REGION_FIRST))); k < k_end; k += INT64_C(1))
    {
        after = strip_placement__node_weight(work, region, nodes, k + INT64_C(1), (*cspan_at(&work, zone + layout__STRIP_ZONE_PENETRATION)));
        strip_placement__cell_overlap(&length, &start, work, zone, region, k);
        if (length > 0.0)
        {
            total += 0.5 * (before + after) * length;
        }
        before = after;
    }
    return total;
}

/* Divide the zone of the region with number ``index`` into ``own`` strips of equal weight, from strip
 * ``first`` on.
 */
static inline int64_t strip_placement__divide_zone(array_double_1d work, int64_t region, int64_t nodes, int64_t index, int64_t first, int64_t own)
{
    int64_t zone;
    double even;
    double graded;
    double each;
    double done;
    int64_t made;
    double edge;
    double before;
    int64_t k_end;
    int64_t k;
    double after;
    double length;
    double start;
    double density;
    double cut;
    zone = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_ZONES + layout__STRIP_ZONE_SIZE * index;
    even = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_EVEN));
    graded = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_GRADED));
    each = (even * ((*cspan_at(&work, zone + layout__STRIP_ZONE_STOP)) - (*cspan_at(&work, zone + layout__STRIP_ZONE_START))) + graded * (*cspan_at(&work, zone + layout__STRIP_ZONE_WEIGHT))) / (double)(own);
    done = 0.0;
    made = INT64_C(0);
    edge = (*cspan_at(&work, zone + layout__STRIP_ZONE_START));
    before = strip_placement__node_weight(work, region, nodes, (int64_t)((*cspan_at(&work, region + layout__REGION_FIRST))), (*cspan_at(&work, zone + layout__STRIP_ZONE_PENETRATION)));
    k_end = (int64_t)((*cspan_at(&work, region + layout__REGION_LAST)));
    for (k = (int64_t)((*cspan_at(&work, region + layout__REGION_FIRST))); k < k_end; k += INT64_C(1))
    {
        after = strip_placement__node_weight(work, region, nodes, k + INT64_C(1), (*cspan_at(&work, zone + layout__STRIP_ZONE_PENETRATION)));
        strip_placement__cell_overlap(&length, &start, work, zone, region, k);
        if (length > 0.0)
        {
            density = even + graded * 0.5 * (before + after);
            while((made < own - INT64_C(1)) && (done + density * length >= each * (double)(made + INT64_C(1))))
            {
                cut = start + (each * (double)(made + INT64_C(1)) - done) / density;
                strip_placement__cut_strip(work, first + made, index, (*cspan_at(&work, region + layout__REGION_OFFSET)), edge, cut);
                edge = cut;
                made += INT64_C(1);
            }
            done += density * length;
        }
        before = after;
    }
    while(made < own)
    {
        /* the last one, and any that rounding has left over */
        cut = edge + ((*cspan_at(&work, zone + layout__STRIP_ZONE_STOP)) - edge) / (double)(own - made);
        strip_placement__cut_strip(work, first + made, index, (*cspan_at(&work, region + layout__REGION_OFFSET)), edge, cut);
        edge = cut;
        made += INT64_C(1);
    }
    return INT64_C(0);
}

/* Let strip ``i`` lie between two stations [m] of the region with number ``index``, ``offset`` [m] from
 * those of the outputs.
 */
static inline int64_t strip_placement__cut_strip(array_double_1d work, int64_t i, int64_t index, double offset, double start, double stop)
{
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_STATION)) = offset + 0.5 * (start + stop);
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_WIDTH)) = stop - start;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_REGION)) = (double)(index);
    return INT64_C(0);
}

/* Note which strips touch the next one. */
static inline int64_t strip_placement__join_strips(array_double_1d work, int64_t count)
{
    int64_t i;
    int64_t joined;
    double reach;
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        joined = INT64_C(0);
        if (i < count - INT64_C(1))
        {
            reach = 0.5 * ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_WIDTH)) + (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (i + INT64_C(1)) + layout__STRIP_WIDTH)));
            if ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (i + INT64_C(1)) + layout__STRIP_STATION)) - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_STATION)) < reach * (1.0 + strip_placement__TOUCHING))
            {
                joined = INT64_C(1);
            }
        }
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_JOINED)) = (double)(joined);
    }
    return INT64_C(0);
}
