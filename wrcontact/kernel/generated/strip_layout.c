/* Generated from normal/strip_layout.py by tools/transpile_kernel.py; change that one.
 *
 * How the rail is divided into strips: evenly over the zones first, then by the pressure that was found.
 *
 * The places of the strips follow the pose without jumps: pieces of the rail have weights that do, and strips
 * of one weight are cut from them, one after the other.  A strip that reaches over a hole between two pieces is
 * cut in two.
 */

#include "strip_layout.h"

/* The zones of ``count`` regions as cells, weighted by how wide and how deep they are. */
static inline int64_t strip_layout__zone_cells(array_double_1d work, int64_t count)
{
    double width;
    double depth;
    int64_t index;
    int64_t cells;
    int64_t zone;
    int64_t cell;
    width = 0.0;
    depth = 0.0;
    for (index = INT64_C(0); index < count; index += INT64_C(1))
    {
        width += (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_ZONES + layout__STRIP_ZONE_SIZE * index + layout__STRIP_ZONE_STOP)) - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_ZONES + layout__STRIP_ZONE_SIZE * index + layout__STRIP_ZONE_START));
        depth += (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_ZONES + layout__STRIP_ZONE_SIZE * index + layout__STRIP_ZONE_LEVEL));
    }
    cells = INT64_C(0);
    for (index = INT64_C(0); index < count; index += INT64_C(1))
    {
        zone = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_ZONES + layout__STRIP_ZONE_SIZE * index;
        if ((*cspan_at(&work, zone + layout__STRIP_ZONE_STOP)) > (*cspan_at(&work, zone + layout__STRIP_ZONE_START)))
        {
            cell = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELLS + layout__STRIP_CELL_SIZE * cells;
            (*cspan_at(&work, cell + layout__STRIP_CELL_START)) = (*cspan_at(&work, zone + layout__STRIP_ZONE_START));
            (*cspan_at(&work, cell + layout__STRIP_CELL_STOP)) = (*cspan_at(&work, zone + layout__STRIP_ZONE_STOP));
            (*cspan_at(&work, cell + layout__STRIP_CELL_WEIGHT)) = (1.0 - strip_layout__DEEP) * ((*cspan_at(&work, zone + layout__STRIP_ZONE_STOP)) - (*cspan_at(&work, zone + layout__STRIP_ZONE_START))) / width + strip_layout__DEEP * (*cspan_at(&work, zone + layout__STRIP_ZONE_LEVEL)) / depth;
            cells += INT64_C(1);
        }
    }
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELL_COUNT)) = (double)(cells);
    return INT64_C(0);
}

/* Note which strips touch the next one. */
static inline int64_t strip_layout__touch(array_double_1d work, int64_t count)
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
            if ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (i + INT64_C(1)) + layout__STRIP_STATION)) - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_STATION)) < reach + strip_layout__TOUCHING)
            {
                joined = INT64_C(1);
            }
        }
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_JOINED)) = (double)(joined);
    }
    return INT64_C(0);
}

/* The solved strips as cells, weighted by their pressures. */
static inline int64_t strip_layout__strip_cells(array_double_1d work)
{
    int64_t count;
    double largest;
    int64_t i;
    double width;
    double change;
    int64_t strip;
    int64_t cell;
    double weight;
    count = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT)));
    largest = 0.0;
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        if ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_PRESSURE)) > largest)
        {
            largest = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_PRESSURE));
        }
    }
    width = 0.0;
    change = 0.0;
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        width += strip_layout__loaded_share(work, count, i, largest) * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_WIDTH));
        if ((i < count - INT64_C(1)) && ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_JOINED)) == 1.0))
        {
            change += fabs((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (i + INT64_C(1)) + layout__STRIP_PRESSURE)) - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_PRESSURE)));
        }
    }
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        strip = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i;
        cell = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELLS + layout__STRIP_CELL_SIZE * i;
        (*cspan_at(&work, cell + layout__STRIP_CELL_START)) = (*cspan_at(&work, strip + layout__STRIP_STATION)) - 0.5 * (*cspan_at(&work, strip + layout__STRIP_WIDTH));
        (*cspan_at(&work, cell + layout__STRIP_CELL_STOP)) = (*cspan_at(&work, strip + layout__STRIP_STATION)) + 0.5 * (*cspan_at(&work, strip + layout__STRIP_WIDTH));
        (*cspan_at(&work, cell + layout__STRIP_CELL_HALF_LENGTH)) = (*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH));
        (*cspan_at(&work, cell + layout__STRIP_CELL_LEAD)) = (*cspan_at(&work, strip + layout__STRIP_LEAD));
        (*cspan_at(&work, cell + layout__STRIP_CELL_LOADED)) = (double)((*cspan_at(&work, strip + layout__STRIP_PRESSURE)) > 0.0);
        weight = strip_layout__EVEN * strip_layout__loaded_share(work, count, i, largest) * (*cspan_at(&work, strip + layout__STRIP_WIDTH)) / width;
        if (change > 0.0)
        {
            weight += (1.0 - strip_layout__EVEN) * 0.5 * strip_layout__pressure_changes(work, count, i) / change;
        }
        (*cspan_at(&work, cell + layout__STRIP_CELL_WEIGHT)) = weight;
    }
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELL_COUNT)) = (double)(count);
    return INT64_C(0);
}

/* How far strip ``i`` counts as loaded, where the ``largest`` pressure is given [Pa]. */
static inline double strip_layout__loaded_share(array_double_1d work, int64_t count, int64_t i, double largest)
{
    double pressure;
    double share;
    pressure = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_PRESSURE));
    if ((i > INT64_C(0)) && ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (i - INT64_C(1)) + layout__STRIP_JOINED)) == 1.0))
    {
        if ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (i - INT64_C(1)) + layout__STRIP_PRESSURE)) > pressure)
        {
            pressure = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (i - INT64_C(1)) + layout__STRIP_PRESSURE));
        }
    }
    if ((i < count - INT64_C(1)) && ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_JOINED)) == 1.0))
    {
        if ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (i + INT64_C(1)) + layout__STRIP_PRESSURE)) > pressure)
        {
            pressure = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (i + INT64_C(1)) + layout__STRIP_PRESSURE));
        }
    }
    share = pressure / (strip_layout__LOADED * largest);
    if (share > 1.0)
    {
        share = 1.0;
    }
    return share;
}

/* Changes of the pressure from strip ``i`` to those that touch it [Pa]. */
static inline double strip_layout__pressure_changes(array_double_1d work, int64_t count, int64_t i)
{
    double change;
    change = 0.0;
    if ((i > INT64_C(0)) && ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (i - INT64_C(1)) + layout__STRIP_JOINED)) == 1.0))
    {
        change += fabs((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_PRESSURE)) - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (i - INT64_C(1)) + layout__STRIP_PRESSURE)));
    }
    if ((i < count - INT64_C(1)) && ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_JOINED)) == 1.0))
    {
        change += fabs((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (i + INT64_C(1)) + layout__STRIP_PRESSURE)) - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_PRESSURE)));
    }
    return change;
}

/* Cut strips from the cells: ``wanted``, and one more for every hole. */
static inline int64_t strip_layout__divide_cells(array_double_1d work, int64_t region_count, int64_t wanted)
{
    double total;
    int64_t index_end;
    int64_t index;
    double each;
    int64_t made;
    int64_t cuts;
    double done;
    double edge;
    double stop;
    int64_t opened;
    int64_t cell;
    double share;
    double cut;
    total = 0.0;
    index_end = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELL_COUNT)));
    for (index = INT64_C(0); index < index_end; index += INT64_C(1))
    {
        total += (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELLS + layout__STRIP_CELL_SIZE * index + layout__STRIP_CELL_WEIGHT));
    }
    each = total / (double)(wanted);
    made = INT64_C(0);
    cuts = INT64_C(0);
    done = 0.0;
    edge = 0.0;
    stop = 0.0;
    opened = INT64_C(0);
    index_end = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELL_COUNT)));
    for (index = INT64_C(0); index < index_end; index += INT64_C(1))
    {
        cell = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELLS + layout__STRIP_CELL_SIZE * index;
        if ((*cspan_at(&work, cell + layout__STRIP_CELL_WEIGHT)) > 0.0)
        {
            if ((opened == INT64_C(1)) && ((*cspan_at(&work, cell + layout__STRIP_CELL_START)) - stop > strip_layout__TOUCHING))
            {
                made += strip_layout__cut_strip(work, made, edge, stop);
                opened = INT64_C(0);
            }
            if (opened == INT64_C(0))
            {
                edge = (*cspan_at(&work, cell + layout__STRIP_CELL_START));
                opened = INT64_C(1);
            }
            while((cuts < wanted - INT64_C(1)) && (done + (*cspan_at(&work, cell + layout__STRIP_CELL_WEIGHT)) >= each * (double)(cuts + INT64_C(1))))
            {
                share = (each * (double)(cuts + INT64_C(1)) - done) / (*cspan_at(&work, cell + layout__STRIP_CELL_WEIGHT));
                cut = (*cspan_at(&work, cell + layout__STRIP_CELL_START)) + share * ((*cspan_at(&work, cell + layout__STRIP_CELL_STOP)) - (*cspan_at(&work, cell + layout__STRIP_CELL_START)));
                made += strip_layout__cut_strip(work, made, edge, cut);
                edge = cut;
                cuts += INT64_C(1);
            }
            done += (*cspan_at(&work, cell + layout__STRIP_CELL_WEIGHT));
            stop = (*cspan_at(&work, cell + layout__STRIP_CELL_STOP));
        }
    }
    made += strip_layout__cut_strip(work, made, edge, stop);
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT)) = (double)(made);
    strip_layout__touch(work, made);
    strip_layout__place_in_regions(work, made, region_count);
    return INT64_C(0);
}

/* Let strip ``i`` lie between two stations [m]; how many strips that is, 0 where it has no width. */
static inline int64_t strip_layout__cut_strip(array_double_1d work, int64_t i, double start, double stop)
{
    int64_t made;
    made = INT64_C(0);
    if (stop - start > strip_layout__TOUCHING)
    {
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_STATION)) = 0.5 * (start + stop);
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_WIDTH)) = stop - start;
        made = INT64_C(1);
    }
    return made;
}

/* Give every strip the region that its middle lies in. */
static inline int64_t strip_layout__place_in_regions(array_double_1d work, int64_t count, int64_t region_count)
{
    int64_t index;
    int64_t i;
    index = INT64_C(0);
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        while((index < region_count - INT64_C(1)) && ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_STATION)) > (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * index + layout__REGION_OFFSET)) + (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * index + layout__REGION_HIGH))))
        {
            index += INT64_C(1);
        }
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_REGION)) = (double)(index);
    }
    return INT64_C(0);
}

/* Half-length and lead of every strip from those of the cells, on straight lines between their
 * middles.
 */
static inline int64_t strip_layout__length_before(array_double_1d work)
{
    int64_t last;
    int64_t index;
    int64_t i_end;
    int64_t i;
    int64_t strip;
    int64_t after;
    double share;
    double reach;
    double rest;
    last = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELL_COUNT))) - INT64_C(1);
    index = INT64_C(0);
    i_end = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT)));
    for (i = INT64_C(0); i < i_end; i += INT64_C(1))
    {
        strip = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i;
        while((index < last - INT64_C(1)) && ((*cspan_at(&work, strip + layout__STRIP_STATION)) > strip_layout__cell_middle(work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELLS + layout__STRIP_CELL_SIZE * (index + INT64_C(1)))))
        {
            index += INT64_C(1);
        }
        after = index;
        if (index < last)
        {
            after = index + INT64_C(1);
        }
        share = 0.0;
        reach = strip_layout__cell_middle(work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELLS + layout__STRIP_CELL_SIZE * after) - strip_layout__cell_middle(work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELLS + layout__STRIP_CELL_SIZE * index);
        if (reach > 0.0)
        {
            share = ((*cspan_at(&work, strip + layout__STRIP_STATION)) - strip_layout__cell_middle(work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELLS + layout__STRIP_CELL_SIZE * index)) / reach;
            if (share < 0.0)
            {
                share = 0.0;
            }
            if (share > 1.0)
            {
                share = 1.0;
            }
        }
        rest = 1.0 - share;
        (*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH)) = rest * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELLS + layout__STRIP_CELL_SIZE * index + layout__STRIP_CELL_HALF_LENGTH)) + share * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELLS + layout__STRIP_CELL_SIZE * after + layout__STRIP_CELL_HALF_LENGTH));
        (*cspan_at(&work, strip + layout__STRIP_LEAD)) = rest * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELLS + layout__STRIP_CELL_SIZE * index + layout__STRIP_CELL_LEAD)) + share * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELLS + layout__STRIP_CELL_SIZE * after + layout__STRIP_CELL_LEAD));
        (*cspan_at(&work, strip + layout__STRIP_LOADED)) = (double)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELLS + layout__STRIP_CELL_SIZE * index + layout__STRIP_CELL_LOADED)) == 1.0);
        if (share > 0.5)
        {
            (*cspan_at(&work, strip + layout__STRIP_LOADED)) = (double)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELLS + layout__STRIP_CELL_SIZE * after + layout__STRIP_CELL_LOADED)) == 1.0);
        }
    }
    return INT64_C(0);
}

/* Station [m] of the middle of a cell. */
static inline double strip_layout__cell_middle(array_double_1d work, int64_t cell)
{
    double result;
    result = 0.5 * ((*cspan_at(&work, cell + layout__STRIP_CELL_START)) + (*cspan_at(&work, cell + layout__STRIP_CELL_STOP)));
    return result;
}
