/* Generated from normal/strips.py by tools/transpile_kernel.py; change that one.
 *
 * The strip correction: ANALYN's patch, put right by the elastic half-space.
 *
 * ANALYN's strips do not feel each other: the displacement of each is that of a Hertz ellipse with its own curvatures.  Here
 * the same strips, each with a pressure p sqrt(1 - (x/a)^2) along the track, press on one half-space (docs/method.md, S1-S9):
 *
 * 1. place the strips over ANALYN's zone, finer where the gap bends and near the contact,
 * 2. solve sum_j F_ij y_j = penetration - gap_i with y = h p / (pi E*) >= 0 and the force given; F_ij tells how a strip j of
 *    half-length a_j pushes the middle line of strip i down,
 * 3. correct every half-length by what the middle line's curvature along the track asks for, at its line load.
 *
 * One round of 2 and 3 is a sweep.  Where the true patch differs from ANALYN's, strips lose their load or take some up.
 */

#include "strips.h"

/* Offset of strip 0 of ``field`` in the workspace. */
static inline int64_t strips__strip_field(int64_t field)
{
    return layout__WORK_STRIPS + field * layout__STRIP_LIMIT;
}

/* Positive where strips belong: by how much the gap stays below ZONE, or ANALYN's load level above nothing [m]. */
static inline double strips__zone_excess(array_double_1d work, int64_t block, int64_t gaps, int64_t rises, int64_t k, double penetration)
{
    double level;
    double beyond;
    double below;
    below = strips__ZONE * penetration - (*cspan_at(&work, block + layout__REGION_GAP)) - (*cspan_at(&work, gaps + k));
    level = (*cspan_at(&work, block + layout__REGION_LEVEL)) - (*cspan_at(&work, rises + k));
    beyond = level + strips__BEYOND * penetration;
    if (beyond < below)
    {
        below = beyond;
    }
    if (level > below)
    {
        below = level;
    }
    return below;
}

/* Station [m] where the region's strips end in ``direction``; its minimum's if none belong there. */
static inline double strips__zone_end(array_double_1d work, int64_t region, int64_t direction, double penetration)
{
    int64_t block;
    int64_t gaps;
    int64_t rises;
    int64_t last;
    double bound;
    double inner;
    double reach;
    int64_t k;
    double outer;
    double station;
    block = layout__WORK_REGIONS + layout__REGION_SIZE * region;
    gaps = nodes__node_field(region, nodes__NODE_GAP);
    rises = nodes__node_field(region, nodes__NODE_RISE);
    last = (int64_t)((*cspan_at(&work, block + layout__REGION_LAST)));
    bound = (*cspan_at(&work, block + layout__REGION_HIGH));
    if (direction < INT64_C(0))
    {
        last = -(int64_t)((*cspan_at(&work, block + layout__REGION_FIRST)));
        bound = (*cspan_at(&work, block + layout__REGION_LOW));
    }
    inner = strips__zone_excess(work, block, gaps, rises, INT64_C(0), penetration);
    reach = 0.0;
    if (inner > 0.0)
    {
        reach = (double)(last);
        for (k = INT64_C(1); k < last + INT64_C(1); k += INT64_C(1))
        {
            outer = strips__zone_excess(work, block, gaps, rises, direction * k, penetration);
            if (outer <= 0.0)
            {
                reach = (double)(k - INT64_C(1)) + inner / (inner - outer);
                break;
            }
            inner = outer;
        }
    }
    station = (*cspan_at(&work, block + layout__REGION_STATION)) + (double)(direction) * reach * (*cspan_at(&work, block + layout__REGION_SPACING));
    if ((station - bound) * (double)(direction) > 0.0)
    {
        station = bound;
    }
    return station;
}

/* sqrt(B) sqrt(1 - gap / penetration) at a node [m^-1/2]. */
static inline double strips__node_weight(array_double_1d work, int64_t region, int64_t k, double penetration)
{
    int64_t block;
    double share;
    double weight;
    block = layout__WORK_REGIONS + layout__REGION_SIZE * region;
    share = 1.0 - ((*cspan_at(&work, block + layout__REGION_GAP)) + (*cspan_at(&work, nodes__node_field(region, nodes__NODE_GAP) + k))) / penetration;
    weight = 0.0;
    if (share > 0.0)
    {
        weight = sqrt((*cspan_at(&work, nodes__node_field(region, nodes__NODE_B) + k)) * share);
    }
    return weight;
}

/* Length of the cell between nodes ``k`` and ``k`` + 1 inside the region's zone [m], and where it begins there. */
static inline int64_t strips__cell_overlap(double* result_0, double* start, array_double_1d work, int64_t block, int64_t k)
{
    double spacing;
    double stop;
    spacing = (*cspan_at(&work, block + layout__REGION_SPACING));
    (*start) = (*cspan_at(&work, block + layout__REGION_STATION)) + spacing * (double)(k);
    stop = (*start) + spacing;
    if ((*start) < (*cspan_at(&work, block + layout__REGION_START)))
    {
        (*start) = (*cspan_at(&work, block + layout__REGION_START));
    }
    if (stop > (*cspan_at(&work, block + layout__REGION_STOP)))
    {
        stop = (*cspan_at(&work, block + layout__REGION_STOP));
    }
    (*result_0) = stop - (*start);
    return 0;
}

/* Integral of the weight over the region's zone [m^1/2]. */
static inline double strips__weigh_region(array_double_1d work, int64_t region, double penetration)
{
    int64_t block;
    double before;
    int64_t k_end;
    int64_t k;
    double after;
    double length;
    double start;
    double total;
    block = layout__WORK_REGIONS + layout__REGION_SIZE * region;
    total = 0.0;
    before = strips__node_weight(work, region, (int64_t)((*cspan_at(&work, block + layout__REGION_FIRST))), penetration);
    k_end = (int64_t)((*cspan_at(&work, block + layout__REGION_LAST)));
    for (k = (int64_t)((*cspan_at(&work, block + layout__REGION_FIRST))); k < k_end; k += INT64_C(1))
    {
        after = strips__node_weight(work, region, k + INT64_C(1), penetration);
        strips__cell_overlap(&length, &start, work, block, k);
        if (length > 0.0)
        {
            total += 0.5 * (before + after) * length;
        }
        before = after;
    }
    return total;
}

/* Strips over the zones of all regions; their number. */
static inline int64_t strips__place_strips(array_double_1d tables, array_double_1d work, int64_t count, double penetration)
{
    double weight;
    double width;
    int64_t region;
    int64_t block;
    double share;
    double length;
    double even;
    double graded;
    int64_t own;
    int64_t strips;
    weight = 0.0;
    width = 0.0;
    for (region = INT64_C(0); region < count; region += INT64_C(1))
    {
        block = layout__WORK_REGIONS + layout__REGION_SIZE * region;
        share = (*cspan_at(&work, block + layout__REGION_TURN)) * penetration;
        (*cspan_at(&work, block + layout__REGION_START)) = strips__zone_end(work, region, -INT64_C(1), share);
        (*cspan_at(&work, block + layout__REGION_STOP)) = strips__zone_end(work, region, INT64_C(1), share);
        (*cspan_at(&work, block + layout__REGION_WEIGHT)) = strips__weigh_region(work, region, share);
        weight += (*cspan_at(&work, block + layout__REGION_WEIGHT));
        width += (*cspan_at(&work, block + layout__REGION_STOP)) - (*cspan_at(&work, block + layout__REGION_START));
    }
    strips = INT64_C(0);
    for (region = INT64_C(0); region < count; region += INT64_C(1))
    {
        block = layout__WORK_REGIONS + layout__REGION_SIZE * region;
        length = (*cspan_at(&work, block + layout__REGION_STOP)) - (*cspan_at(&work, block + layout__REGION_START));
        if ((length > 0.0) && (weight > 0.0))
        {
            even = strips__EVEN / width;
            graded = (1.0 - strips__EVEN) / weight;
            share = even * length + graded * (*cspan_at(&work, block + layout__REGION_WEIGHT));
            own = (int64_t)((*cspan_at(&tables, layout__TABLES_STRIPS)) * share + 0.5);
            if (own < strips__LEAST)
            {
                own = strips__LEAST;
            }
            strips = strips__divide_zone(work, region, (*cspan_at(&work, block + layout__REGION_TURN)) * penetration, strips, own, even, graded, share);
        }
    }
    return strips;
}

/* Cut the region's zone into ``own`` strips of equal weight after the first ``strips`` ones; the number of all. */
static inline int64_t strips__divide_zone(array_double_1d work, int64_t region, double penetration, int64_t strips, int64_t own, double even, double graded, double share)
{
    int64_t block;
    int64_t stations;
    int64_t widths;
    int64_t regions;
    double offset;
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
    block = layout__WORK_REGIONS + layout__REGION_SIZE * region;
    stations = strips__strip_field(strips__STRIP_STATION);
    widths = strips__strip_field(strips__STRIP_WIDTH);
    regions = strips__strip_field(strips__STRIP_REGION);
    offset = (*cspan_at(&work, block + layout__REGION_OFFSET));
    each = share / (double)(own);
    done = 0.0;
    made = INT64_C(0);
    edge = (*cspan_at(&work, block + layout__REGION_START));
    before = strips__node_weight(work, region, (int64_t)((*cspan_at(&work, block + layout__REGION_FIRST))), penetration);
    k_end = (int64_t)((*cspan_at(&work, block + layout__REGION_LAST)));
    for (k = (int64_t)((*cspan_at(&work, block + layout__REGION_FIRST))); k < k_end; k += INT64_C(1))
    {
        after = strips__node_weight(work, region, k + INT64_C(1), penetration);
        strips__cell_overlap(&length, &start, work, block, k);
        if (length > 0.0)
        {
            density = even + graded * 0.5 * (before + after);
            while((made < own - INT64_C(1)) && (done + density * length >= each * (double)(made + INT64_C(1))))
            {
                cut = start + (each * (double)(made + INT64_C(1)) - done) / density;
                (*cspan_at(&work, stations + strips + made)) = offset + 0.5 * (edge + cut);
                (*cspan_at(&work, widths + strips + made)) = cut - edge;
                (*cspan_at(&work, regions + strips + made)) = (double)(region);
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
        cut = edge + ((*cspan_at(&work, block + layout__REGION_STOP)) - edge) / (double)(own - made);
        (*cspan_at(&work, stations + strips + made)) = offset + 0.5 * (edge + cut);
        (*cspan_at(&work, widths + strips + made)) = cut - edge;
        (*cspan_at(&work, regions + strips + made)) = (double)(region);
        edge = cut;
        made += INT64_C(1);
    }
    return strips + own;
}

/* Mark the strips whose edges meet. */
static inline int64_t strips__join_strips(array_double_1d work, int64_t strips)
{
    int64_t stations;
    int64_t widths;
    int64_t i;
    double joined;
    double reach;
    stations = strips__strip_field(strips__STRIP_STATION);
    widths = strips__strip_field(strips__STRIP_WIDTH);
    for (i = INT64_C(0); i < strips; i += INT64_C(1))
    {
        joined = 0.0;
        if (i < strips - INT64_C(1))
        {
            reach = 0.5 * ((*cspan_at(&work, widths + i)) + (*cspan_at(&work, widths + i + INT64_C(1))));
            if ((*cspan_at(&work, stations + i + INT64_C(1))) - (*cspan_at(&work, stations + i)) < reach * (1.0 + strips__TOUCHING))
            {
                joined = 1.0;
            }
        }
        (*cspan_at(&work, strips__strip_field(strips__STRIP_JOINED) + i)) = joined;
    }
    return INT64_C(0);
}

/* The cubic through values at -1, 0, 1, 2, at x. */
static inline double strips__cubic_through(double before, double low, double high, double after, double x)
{
    double bend;
    double third;
    bend = 0.5 * (before - 2.0 * low + high);
    third = (after - 3.0 * high + 3.0 * low - before) / 6.0;
    return low + x * (high - low + (x - 1.0) * (bend + (x + 1.0) * third));
}

/* The cubic through the four values around ``at`` + x, 0 <= x <= 1. */
static inline double strips__cubic_value(array_double_1d work, int64_t at, double x)
{
    double result;
    result = strips__cubic_through((*cspan_at(&work, at - INT64_C(1))), (*cspan_at(&work, at)), (*cspan_at(&work, at + INT64_C(1))), (*cspan_at(&work, at + INT64_C(2))), x);
    return result;
}

/* Gap and A of strip ``i`` where it stands; its node and the share of the way to the next one. */
static inline int64_t strips__locate_strip(int64_t* region, int64_t* k, double* x, array_double_1d work, int64_t i)
{
    int64_t block;
    double u;
    double gap;
    double turn;
    (*region) = (int64_t)((*cspan_at(&work, strips__strip_field(strips__STRIP_REGION) + i)));
    block = layout__WORK_REGIONS + layout__REGION_SIZE * (*region);
    u = ((*cspan_at(&work, strips__strip_field(strips__STRIP_STATION) + i)) - (*cspan_at(&work, block + layout__REGION_OFFSET)) - (*cspan_at(&work, block + layout__REGION_STATION))) / (*cspan_at(&work, block + layout__REGION_SPACING));
    (*k) = (int64_t)(u + (double)(layout__NODE_MIDDLE)) - layout__NODE_MIDDLE;
    if ((*k) > (int64_t)((*cspan_at(&work, block + layout__REGION_LAST))) - INT64_C(1))
    {
        (*k) = (int64_t)((*cspan_at(&work, block + layout__REGION_LAST))) - INT64_C(1);
    }
    if ((*k) < (int64_t)((*cspan_at(&work, block + layout__REGION_FIRST))))
    {
        (*k) = (int64_t)((*cspan_at(&work, block + layout__REGION_FIRST)));
    }
    (*x) = u - (double)((*k));
    gap = strips__cubic_value(work, nodes__node_field((*region), nodes__NODE_GAP) + (*k), (*x));
    if (gap < 0.0)
    {
        /* beside a sudden rise a cubic falls below the region's smallest gap */
        gap = 0.0;
    }
    (*cspan_at(&work, strips__strip_field(strips__STRIP_GAP) + i)) = (*cspan_at(&work, block + layout__REGION_GAP)) + gap;
    (*cspan_at(&work, strips__strip_field(strips__STRIP_A) + i)) = strips__node_value(work, (*region), nodes__NODE_A, (*k), (*x));
    (*cspan_at(&work, strips__strip_field(strips__STRIP_TURN) + i)) = (*cspan_at(&work, block + layout__REGION_TURN));
    if (contact_plane__is_yawed(work) == INT64_C(1))
    {
        /* the patch is tilted; the strips are those of an upright one (hertz.upright_coefficients) */
        turn = (*cspan_at(&work, block + layout__REGION_UPRIGHT_SHARE));
        (*cspan_at(&work, strips__strip_field(strips__STRIP_GAP) + i)) = turn * (*cspan_at(&work, block + layout__REGION_GAP)) + gap * (*cspan_at(&work, block + layout__REGION_UPRIGHT_B));
        (*cspan_at(&work, strips__strip_field(strips__STRIP_A) + i)) *= (*cspan_at(&work, block + layout__REGION_UPRIGHT_A));
        (*cspan_at(&work, strips__strip_field(strips__STRIP_TURN) + i)) = turn * (*cspan_at(&work, block + layout__REGION_TURN));
    }
    return 0;
}

/* ``field`` on the straight line between nodes ``k`` and ``k`` + 1. */
static inline double strips__node_value(array_double_1d work, int64_t region, int64_t field, int64_t k, double x)
{
    int64_t at;
    double result;
    at = nodes__node_field(region, field) + k;
    result = (*cspan_at(&work, at)) + x * ((*cspan_at(&work, at + INT64_C(1))) - (*cspan_at(&work, at)));
    return result;
}

/* Gap, curvature and ANALYN's half-length of every strip, from its region's nodes. */
static inline int64_t strips__describe_strips(array_double_1d work, int64_t strips, double penetration)
{
    int64_t halves;
    double longest;
    int64_t i;
    int64_t region;
    int64_t k;
    double x;
    double line;
    double length;
    double level;
    double loaded;
    double square;
    double below;
    double inside;
    halves = strips__strip_field(strips__STRIP_HALF);
    longest = 0.0;
    for (i = INT64_C(0); i < strips; i += INT64_C(1))
    {
        strips__locate_strip(&region, &k, &x, work, i);
        line = strips__node_value(work, region, nodes__NODE_LINE, k, x);
        length = strips__node_value(work, region, nodes__NODE_LENGTH, k, x);
        level = (*cspan_at(&work, layout__WORK_REGIONS + layout__REGION_SIZE * region + layout__REGION_LEVEL)) - strips__node_value(work, region, nodes__NODE_RISE, k, x);
        (*cspan_at(&work, strips__strip_field(strips__STRIP_HERTZ) + i)) = line * length;
        loaded = 0.0;
        square = 0.0;
        if (level > 0.0)
        {
            loaded = 1.0;
            square = level / length;
        }
        below = penetration - (*cspan_at(&work, strips__strip_field(strips__STRIP_GAP) + i)) / (*cspan_at(&work, strips__strip_field(strips__STRIP_TURN) + i));
        below *= (*cspan_at(&work, layout__WORK_REGIONS + layout__REGION_SIZE * region + layout__REGION_TURN));
        inside = strips__INSIDE * strips__INSIDE * below / length;
        if (inside > square)
        {
            square = inside;
        }
        (*cspan_at(&work, strips__strip_field(strips__STRIP_LOADED) + i)) = loaded;
        (*cspan_at(&work, halves + i)) = sqrt(square);
        if ((loaded == 1.0) && ((*cspan_at(&work, halves + i)) > longest))
        {
            longest = (*cspan_at(&work, halves + i));
        }
    }
    strips__keep_long(work, strips, longest);
    return INT64_C(0);
}

/* Raise half-lengths to their least, and take the logarithms. */
static inline int64_t strips__keep_long(array_double_1d work, int64_t strips, double longest)
{
    int64_t halves;
    int64_t widths;
    int64_t i;
    halves = strips__strip_field(strips__STRIP_HALF);
    widths = strips__strip_field(strips__STRIP_WIDTH);
    for (i = INT64_C(0); i < strips; i += INT64_C(1))
    {
        if ((*cspan_at(&work, halves + i)) < strips__SHORTEST * longest)
        {
            (*cspan_at(&work, halves + i)) = strips__SHORTEST * longest;
        }
        if ((*cspan_at(&work, halves + i)) < strips__SQUARE * (*cspan_at(&work, widths + i)))
        {
            (*cspan_at(&work, halves + i)) = strips__SQUARE * (*cspan_at(&work, widths + i));
        }
        (*cspan_at(&work, strips__strip_field(strips__STRIP_LOG) + i)) = log((*cspan_at(&work, halves + i)));
    }
    return INT64_C(0);
}

/* Let the outermost strips of every run of loaded ones end at the run's edges. */
static inline int64_t strips__fit_edges(array_double_1d work, int64_t strips)
{
    int64_t lines;
    int64_t first;
    int64_t last;
    double start;
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
                start = strips__run_edge(work, strips, first, last, -INT64_C(1));
                stop = strips__run_edge(work, strips, last, first, INT64_C(1));
                strips__fit_edge(work, strips, first, start, -INT64_C(1));
                strips__fit_edge(work, strips, last, stop, INT64_C(1));
            }
        }
        first = last + INT64_C(1);
    }
    return INT64_C(0);
}

/* Let the run that ends with strip ``last`` end at ``edge`` [m], which lies within one and a half of its widths.
 *
 * A strip is never narrower than half of what it was, since a narrow one answers the smallest mismatch with a large
 * pressure: the one before takes over what little is left of it.
 */
static inline int64_t strips__fit_edge(array_double_1d work, int64_t strips, int64_t last, double edge, int64_t outward)
{
    double direction;
    double width;
    double inner;
    double outer;
    int64_t beyond;
    int64_t pair;
    double touching;
    double far;
    int64_t before;
    double near;
    direction = (double)(outward);
    width = (*cspan_at(&work, strips__strip_field(strips__STRIP_WIDTH) + last));
    inner = (*cspan_at(&work, strips__strip_field(strips__STRIP_STATION) + last)) - 0.5 * direction * width;
    outer = inner + direction * width;
    beyond = last + outward;
    pair = last;
    if (outward < INT64_C(0))
    {
        pair = beyond;
    }
    touching = 0.0;
    if ((pair >= INT64_C(0)) && (pair < strips))
    {
        touching = (*cspan_at(&work, strips__strip_field(strips__STRIP_JOINED) + pair));
    }
    if ((edge - inner) * direction > 0.5 * width)
    {
        strips__set_strip(work, strips, last, inner, edge);
        if (((edge - outer) * direction > 0.0) && (touching == 1.0))
        {
            far = (*cspan_at(&work, strips__strip_field(strips__STRIP_STATION) + beyond)) + 0.5 * direction * (*cspan_at(&work, strips__strip_field(strips__STRIP_WIDTH) + beyond));
            strips__set_strip(work, strips, beyond, edge, far);
        }
    }
    else
    {
        before = last - outward;
        near = (*cspan_at(&work, strips__strip_field(strips__STRIP_STATION) + before)) - 0.5 * direction * (*cspan_at(&work, strips__strip_field(strips__STRIP_WIDTH) + before));
        strips__set_strip(work, strips, before, near, edge);
        strips__set_strip(work, strips, last, edge, outer);
        (*cspan_at(&work, strips__strip_field(strips__STRIP_LOADED) + last)) = 0.0;
    }
    return INT64_C(0);
}

/* Let strip ``i`` lie between two stations [m]. */
static inline int64_t strips__set_strip(array_double_1d work, int64_t strips, int64_t i, double start, double stop)
{
    int64_t region;
    int64_t k;
    double x;
    (*cspan_at(&work, strips__strip_field(strips__STRIP_WIDTH) + i)) = fabs(stop - start);
    (*cspan_at(&work, strips__strip_field(strips__STRIP_STATION) + i)) = 0.5 * (start + stop);
    strips__locate_strip(&region, &k, &x, work, i);
    strips__measure_distances(work, strips, i, strips);
    return INT64_C(0);
}

/* Logarithms of the distances between strip ``i`` and the first ``others``, and how far their regions lie
 * ahead of each other.
 */
static inline int64_t strips__measure_distances(array_double_1d work, int64_t strips, int64_t i, int64_t others)
{
    int64_t stations;
    int64_t regions;
    int64_t row;
    int64_t j;
    double apart;
    double along;
    double distance;
    stations = strips__strip_field(strips__STRIP_STATION);
    regions = strips__strip_field(strips__STRIP_REGION);
    row = layout__WORK_DISTANCE + strips * i;
    for (j = INT64_C(0); j < others; j += INT64_C(1))
    {
        if (j != i)
        {
            apart = fabs((*cspan_at(&work, stations + i)) - (*cspan_at(&work, stations + j)));
            if ((*cspan_at(&work, regions + i)) != (*cspan_at(&work, regions + j)))
            {
                along = interaction__region_lead(work, layout__WORK_REGIONS + layout__REGION_SIZE * (int64_t)((*cspan_at(&work, regions + i))), layout__WORK_REGIONS + layout__REGION_SIZE * (int64_t)((*cspan_at(&work, regions + j))));
                apart = sqrt(apart * apart + along * along);
            }
            distance = log(apart);
            (*cspan_at(&work, row + j)) = distance;
            (*cspan_at(&work, layout__WORK_DISTANCE + strips * j + i)) = distance;
        }
    }
    return INT64_C(0);
}

/* Phi of eq. (S3) at ln(distance / half-length). */
static inline double strips__influence_value(array_double_1d tables, int64_t base, double abscissa)
{
    double u;
    double last;
    int64_t cell;
    int64_t at;
    double result;
    u = (abscissa - (*cspan_at(&tables, base + strips__TABLE_START))) * (*cspan_at(&tables, base + strips__TABLE_CELLS_PER_UNIT));
    last = (*cspan_at(&tables, base + strips__TABLE_COUNT));
    if (!(u > 0.0))
    {
        u = 0.0;
    }
    if (u > last)
    {
        u = last;
    }
    cell = (int64_t)(u);
    u -= (double)(cell);
    at = base + strips__TABLE_CELLS + strips__TABLE_ROW * cell;
    result = (*cspan_at(&tables, at)) + u * ((*cspan_at(&tables, at + INT64_C(1))) + u * ((*cspan_at(&tables, at + INT64_C(2))) + u * (*cspan_at(&tables, at + INT64_C(3)))));
    return result;
}

/* What the mean of -2 ln(distance) over a strip exceeds its middle value by; ``share`` is half-width over distance. */
static inline double strips__near_share(double share)
{
    double square;
    double rest;
    square = share * share;
    rest = 1.0 / 42.0 + square * (1.0 / 72.0 + square / 110.0);
    return 2.0 * square * (1.0 / 6.0 + square * (1.0 / 20.0 + square * rest));
}

/* F_ij: displacement of middle line i for y_j = 1; eqs. (S3), (S4).  ``count`` is the number of regions. */
static inline int64_t strips__fill_influence(array_double_1d tables, array_double_1d work, int64_t strips, int64_t count)
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
                (*cspan_at(&work, row + j)) = strips__influence_value(tables, base, (*cspan_at(&work, distances + j)) - (*cspan_at(&work, logs + j)));
            }
        }
        for (j = i - INT64_C(2); j < i + INT64_C(3); j += INT64_C(1))
        {
            if ((j >= INT64_C(0)) && (j < strips) && (j != i))
            {
                (*cspan_at(&work, row + j)) += strips__near_share(0.5 * (*cspan_at(&work, widths + j)) / fabs((*cspan_at(&work, stations + i)) - (*cspan_at(&work, stations + j))));
            }
        }
        (*cspan_at(&work, row + i)) = 2.0 * log(8.0 * (*cspan_at(&work, halves + i)) / (*cspan_at(&work, widths + i)));
    }
    if (count > INT64_C(1))
    {
        strips__turn_influence(work, strips);
    }
    return INT64_C(0);
}

/* Let strips of regions in different planes press on each other by the cosine of the angle between them. */
static inline int64_t strips__turn_influence(array_double_1d work, int64_t strips)
{
    int64_t regions;
    int64_t i;
    int64_t j;
    double cosine;
    regions = strips__strip_field(strips__STRIP_REGION);
    for (i = INT64_C(0); i < strips; i += INT64_C(1))
    {
        for (j = INT64_C(0); j < strips; j += INT64_C(1))
        {
            if ((*cspan_at(&work, regions + i)) != (*cspan_at(&work, regions + j)))
            {
                cosine = interaction__planes_cosine(work, layout__WORK_REGIONS + layout__REGION_SIZE * (int64_t)((*cspan_at(&work, regions + i))), layout__WORK_REGIONS + layout__REGION_SIZE * (int64_t)((*cspan_at(&work, regions + j))));
                (*cspan_at(&work, layout__WORK_INFLUENCE + strips * i + j)) *= cosine;
            }
        }
    }
    return INT64_C(0);
}

/* Solve the system of ``size`` rows with two right-hand sides in its last two columns, in place.
 *
 * Without exchange of rows: the matrix is that of a positive kernel, largest on the diagonal.
 */
static inline int64_t strips__eliminate(array_double_1d work, int64_t size)
{
    int64_t width;
    int64_t pair;
    int64_t k;
    int64_t first;
    int64_t second;
    double inverse;
    double factor;
    int64_t j;
    double next_inverse;
    int64_t i;
    int64_t row;
    double next_factor;
    int64_t back;
    int64_t pivot;
    double unit;
    double rest;
    width = size + INT64_C(2);
    for (pair = INT64_C(0); pair < py_floor_div_int64_t(size, INT64_C(2)); pair += INT64_C(1))
    {
        /* two columns at a time, so that every row is read and written once for both */
        k = INT64_C(2) * pair;
        first = layout__WORK_SYSTEM + width * k;
        second = first + width;
        inverse = 1.0 / (*cspan_at(&work, first + k));
        factor = (*cspan_at(&work, second + k)) * inverse;
        for (j = k + INT64_C(1); j < width; j += INT64_C(1))
        {
            (*cspan_at(&work, second + j)) -= factor * (*cspan_at(&work, first + j));
        }
        next_inverse = 1.0 / (*cspan_at(&work, second + k + INT64_C(1)));
        for (i = k + INT64_C(2); i < size; i += INT64_C(1))
        {
            row = layout__WORK_SYSTEM + width * i;
            factor = (*cspan_at(&work, row + k)) * inverse;
            next_factor = ((*cspan_at(&work, row + k + INT64_C(1))) - factor * (*cspan_at(&work, first + k + INT64_C(1)))) * next_inverse;
            for (j = k + INT64_C(2); j < width; j += INT64_C(1))
            {
                (*cspan_at(&work, row + j)) = (*cspan_at(&work, row + j)) - factor * (*cspan_at(&work, first + j)) - next_factor * (*cspan_at(&work, second + j));
            }
        }
    }
    for (back = INT64_C(0); back < size; back += INT64_C(1))
    {
        k = size - INT64_C(1) - back;
        pivot = layout__WORK_SYSTEM + width * k;
        unit = (*cspan_at(&work, pivot + size));
        rest = (*cspan_at(&work, pivot + size + INT64_C(1)));
        for (j = k + INT64_C(1); j < size; j += INT64_C(1))
        {
            row = layout__WORK_SYSTEM + width * j;
            unit -= (*cspan_at(&work, pivot + j)) * (*cspan_at(&work, row + size));
            rest -= (*cspan_at(&work, pivot + j)) * (*cspan_at(&work, row + size + INT64_C(1)));
        }
        (*cspan_at(&work, pivot + size)) = unit / (*cspan_at(&work, pivot + k));
        (*cspan_at(&work, pivot + size + INT64_C(1))) = rest / (*cspan_at(&work, pivot + k));
    }
    return INT64_C(0);
}

/* y of the loaded strips under ``force`` [N], or at ``prescribed`` penetration [m]; the penetration. */
static inline double strips__solve_loaded(array_double_1d tables, array_double_1d work, int64_t strips, double force, double prescribed, int64_t by_penetration)
{
    int64_t ranks;
    int64_t size;
    int64_t i;
    int64_t rank;
    int64_t row;
    int64_t influences;
    int64_t other;
    double unit_load;
    double rest_load;
    double half;
    double penetration;
    ranks = strips__strip_field(strips__STRIP_RANK);
    size = INT64_C(0);
    for (i = INT64_C(0); i < strips; i += INT64_C(1))
    {
        if ((*cspan_at(&work, strips__strip_field(strips__STRIP_LOADED) + i)) == 1.0)
        {
            (*cspan_at(&work, ranks + size)) = (double)(i);
            size += INT64_C(1);
        }
    }
    for (rank = INT64_C(0); rank < size; rank += INT64_C(1))
    {
        i = (int64_t)((*cspan_at(&work, ranks + rank)));
        row = layout__WORK_SYSTEM + (size + INT64_C(2)) * rank;
        influences = layout__WORK_INFLUENCE + strips * i;
        for (other = INT64_C(0); other < size; other += INT64_C(1))
        {
            (*cspan_at(&work, row + other)) = (*cspan_at(&work, influences + (int64_t)((*cspan_at(&work, ranks + other)))));
        }
        (*cspan_at(&work, row + size)) = (*cspan_at(&work, strips__strip_field(strips__STRIP_TURN) + i));
        (*cspan_at(&work, row + size + INT64_C(1))) = (*cspan_at(&work, strips__strip_field(strips__STRIP_GAP) + i));
    }
    strips__eliminate(work, size);
    unit_load = 0.0;
    rest_load = 0.0;
    for (rank = INT64_C(0); rank < size; rank += INT64_C(1))
    {
        row = layout__WORK_SYSTEM + (size + INT64_C(2)) * rank;
        i = (int64_t)((*cspan_at(&work, ranks + rank)));
        half = (*cspan_at(&work, strips__strip_field(strips__STRIP_HALF) + i));
        /* what of it counts for the prescribed force */
        half *= (*cspan_at(&work, layout__WORK_REGIONS + layout__REGION_SIZE * (int64_t)((*cspan_at(&work, strips__strip_field(strips__STRIP_REGION) + i))) + layout__REGION_SHARE));
        unit_load += half * (*cspan_at(&work, row + size));
        rest_load += half * (*cspan_at(&work, row + size + INT64_C(1)));
    }
    penetration = prescribed;
    if (by_penetration == INT64_C(0))
    {
        penetration = (force / (0.5 * M_PI * M_PI * (*cspan_at(&tables, layout__TABLES_CONTACT_MODULUS))) + rest_load) / unit_load;
    }
    for (i = INT64_C(0); i < strips; i += INT64_C(1))
    {
        (*cspan_at(&work, strips__strip_field(strips__STRIP_SHARE) + i)) = 0.0;
    }
    for (rank = INT64_C(0); rank < size; rank += INT64_C(1))
    {
        row = layout__WORK_SYSTEM + (size + INT64_C(2)) * rank;
        (*cspan_at(&work, strips__strip_field(strips__STRIP_SHARE) + (int64_t)((*cspan_at(&work, ranks + rank))))) = penetration * (*cspan_at(&work, row + size)) - (*cspan_at(&work, row + size + INT64_C(1)));
    }
    return penetration;
}

/* Unload strips that pull, load strips that penetrate (only the last of all where ``single``); how many. */
static inline int64_t strips__exchange_strips(array_double_1d work, int64_t strips, double penetration, int64_t single)
{
    int64_t loaded;
    int64_t shares;
    int64_t back;
    int64_t i;
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
                    (*cspan_at(&work, loaded + i)) = 0.0;
                    changed += INT64_C(1);
                }
            }
            else
            {
                pushed = ((*cspan_at(&work, strips__strip_field(strips__STRIP_TURN) + i)) - strips__TOUCH) * penetration - (*cspan_at(&work, strips__strip_field(strips__STRIP_GAP) + i));
                row = layout__WORK_INFLUENCE + strips * i;
                for (j = INT64_C(0); j < strips; j += INT64_C(1))
                {
                    pushed -= (*cspan_at(&work, row + j)) * (*cspan_at(&work, shares + j));
                }
                if (pushed > 0.0)
                {
                    (*cspan_at(&work, loaded + i)) = 1.0;
                    changed += INT64_C(1);
                }
            }
        }
    }
    return changed;
}

/* Loaded strips and their y with no pull and no penetration; the penetration [m], and 1 when found, else 0. */
static inline int64_t strips__solve_strips(double* result_0, int64_t* result_1_0001, array_double_1d tables, array_double_1d work, array_double_1d state, int64_t strips, double force, double prescribed, int64_t by_penetration)
{
    double penetration;
    int64_t exchange;
    int64_t single;
    penetration = prescribed;
    for (exchange = INT64_C(0); exchange < strips__EXCHANGE_LIMIT; exchange += INT64_C(1))
    {
        (*cspan_at(&state, layout__STATE_STRIP_COUNT)) += 1.0;
        penetration = strips__solve_loaded(tables, work, strips, force, prescribed, by_penetration);
        single = INT64_C(0);
        if (exchange >= strips__EXCHANGES)
        {
            single = INT64_C(1);
        }
        if (strips__exchange_strips(work, strips, penetration, single) == INT64_C(0))
        {
            (*result_0) = penetration;
            (*result_1_0001) = INT64_C(1);
            return 0;
        }
    }
    (*result_0) = penetration;
    (*result_1_0001) = INT64_C(0);
    return 0;
}

/* Line load, square of the corrected half-length, and pressure of every strip; eqs. (S6)-(S9).
 *
 * At fixed line load the half-length follows from two conditions that are one for an ellipse: the middle line's
 * curvature along the track, and ANALYN's ratio of line load to half-length.  Their geometric mean is taken.
 */
static inline int64_t strips__correct_lengths(array_double_1d tables, array_double_1d work, int64_t strips)
{
    int64_t stations;
    int64_t halves;
    int64_t shares;
    double scale;
    int64_t i;
    double line;
    double square;
    double pressure;
    double half;
    double bend;
    int64_t row;
    int64_t j;
    double away;
    double asked;
    double hertz;
    stations = strips__strip_field(strips__STRIP_STATION);
    halves = strips__strip_field(strips__STRIP_HALF);
    shares = strips__strip_field(strips__STRIP_SHARE);
    scale = 0.5 * M_PI * M_PI * (*cspan_at(&tables, layout__TABLES_CONTACT_MODULUS));
    for (i = INT64_C(0); i < strips; i += INT64_C(1))
    {
        line = 0.0;
        square = 0.0;
        pressure = 0.0;
        if ((*cspan_at(&work, shares + i)) > 0.0)
        {
            half = (*cspan_at(&work, halves + i));
            line = scale * half * (*cspan_at(&work, shares + i)) / (*cspan_at(&work, strips__strip_field(strips__STRIP_WIDTH) + i));
            bend = 0.0;
            row = layout__WORK_INFLUENCE + strips * i;
            for (j = INT64_C(0); j < strips; j += INT64_C(1))
            {
                away = (*cspan_at(&work, stations + i)) - (*cspan_at(&work, stations + j));
                bend += (*cspan_at(&work, row + j)) * (*cspan_at(&work, shares + j)) / ((*cspan_at(&work, halves + j)) * (*cspan_at(&work, halves + j)) + away * away);
            }
            asked = half * half * bend / (2.0 * (*cspan_at(&work, strips__strip_field(strips__STRIP_A) + i)));
            hertz = line / (*cspan_at(&work, strips__strip_field(strips__STRIP_HERTZ) + i));
            square = sqrt(asked * hertz);
            pressure = 2.0 / M_PI * line / sqrt(square);
        }
        (*cspan_at(&work, strips__strip_field(strips__STRIP_LINE) + i)) = line;
        (*cspan_at(&work, strips__strip_field(strips__STRIP_SQUARE) + i)) = square;
        (*cspan_at(&work, strips__strip_field(strips__STRIP_PRESSURE) + i)) = pressure;
    }
    return INT64_C(0);
}

/* Let loaded strips have their corrected half-lengths in the next sweep. */
static inline int64_t strips__adopt_lengths(array_double_1d work, int64_t strips)
{
    double longest;
    int64_t i;
    double half;
    longest = 0.0;
    for (i = INT64_C(0); i < strips; i += INT64_C(1))
    {
        if ((*cspan_at(&work, strips__strip_field(strips__STRIP_SQUARE) + i)) > 0.0)
        {
            half = sqrt((*cspan_at(&work, strips__strip_field(strips__STRIP_SQUARE) + i)));
            (*cspan_at(&work, strips__strip_field(strips__STRIP_HALF) + i)) = half;
            if (half > longest)
            {
                longest = half;
            }
        }
    }
    strips__keep_long(work, strips, longest);
    return INT64_C(0);
}

/* Last strip of the run of loaded strips that begins at ``first``. */
static inline int64_t strips__run_end(array_double_1d work, int64_t strips, int64_t first)
{
    int64_t lines;
    int64_t last;
    lines = strips__strip_field(strips__STRIP_LINE);
    last = first;
    while((last < strips - INT64_C(1)) && ((*cspan_at(&work, lines + last + INT64_C(1))) > 0.0) && ((*cspan_at(&work, strips__strip_field(strips__STRIP_JOINED) + last)) == 1.0))
    {
        last += INT64_C(1);
    }
    return last;
}

/* Station [m] of the edge beyond strip ``last`` of a run that reaches to ``first`` on the other side. */
static inline double strips__run_edge(array_double_1d work, int64_t strips, int64_t last, int64_t first, int64_t outward)
{
    int64_t stations;
    int64_t lines;
    double station;
    double limit;
    int64_t after;
    int64_t beside;
    int64_t inner;
    double fall;
    double reach;
    double edge;
    stations = strips__strip_field(strips__STRIP_STATION);
    lines = strips__strip_field(strips__STRIP_LINE);
    station = (*cspan_at(&work, stations + last));
    edge = station + 0.5 * (double)(outward) * (*cspan_at(&work, strips__strip_field(strips__STRIP_WIDTH) + last));
    if (last != first)
    {
        /* no farther than the middle of the next strip, which carries nothing */
        limit = edge;
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
                limit = (*cspan_at(&work, stations + after));
            }
        }
        inner = last - outward;
        fall = (*cspan_at(&work, lines + inner)) - (*cspan_at(&work, lines + last));
        edge = limit;
        if (fall > 0.0)
        {
            reach = (*cspan_at(&work, lines + last)) / fall * (station - (*cspan_at(&work, stations + inner)));
            if (reach * (double)(outward) < (limit - station) * (double)(outward))
            {
                edge = station + reach;
            }
        }
    }
    return edge;
}

/* Load the strip with the smallest gap where ANALYN loads none of them. */
static inline int64_t strips__start_loaded(array_double_1d work, int64_t strips)
{
    int64_t least;
    double loaded;
    int64_t i;
    least = INT64_C(0);
    loaded = 0.0;
    for (i = INT64_C(0); i < strips; i += INT64_C(1))
    {
        loaded += (*cspan_at(&work, strips__strip_field(strips__STRIP_LOADED) + i));
        if ((*cspan_at(&work, strips__strip_field(strips__STRIP_GAP) + i)) < (*cspan_at(&work, strips__strip_field(strips__STRIP_GAP) + least)))
        {
            least = i;
        }
    }
    if (loaded == 0.0)
    {
        (*cspan_at(&work, strips__strip_field(strips__STRIP_LOADED) + least)) = 1.0;
    }
    return INT64_C(0);
}

/* Strip correction of ANALYN's ``count`` regions at its ``predicted`` penetration [m]; the corrected penetration
 * [m], the number of strips, and 1 when met, else 0.
 */
static inline int64_t strips__correct_strips(double* result_0, int64_t* result_1, int64_t* result_2, array_double_1d tables, array_double_1d work, array_double_1d state, int64_t count, double force, double predicted, int64_t by_penetration)
{
    int64_t strips;
    int64_t i;
    double penetration;
    int64_t met;
    int64_t sweeps;
    int64_t sweep;
    strips = strips__place_strips(tables, work, count, predicted);
    strips__join_strips(work, strips);
    strips__describe_strips(work, strips, predicted);
    strips__start_loaded(work, strips);
    for (i = INT64_C(0); i < strips; i += INT64_C(1))
    {
        strips__measure_distances(work, strips, i, i);
    }
    penetration = predicted;
    met = INT64_C(0);
    sweeps = (int64_t)((*cspan_at(&tables, layout__TABLES_SWEEPS)));
    for (sweep = INT64_C(0); sweep < sweeps; sweep += INT64_C(1))
    {
        strips__fill_influence(tables, work, strips, count);
        strips__solve_strips(&penetration, &met, tables, work, state, strips, force, predicted, by_penetration);
        if (met == INT64_C(0))
        {
            (*result_0) = penetration;
            (*result_1) = strips;
            (*result_2) = met;
            return 0;
        }
        strips__correct_lengths(tables, work, strips);
        if (sweep < sweeps - INT64_C(1))
        {
            strips__adopt_lengths(work, strips);
            strips__fit_edges(work, strips);
        }
    }
    (*result_0) = penetration;
    (*result_1) = strips;
    (*result_2) = met;
    return 0;
}
