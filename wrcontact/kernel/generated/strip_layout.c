/* Generated from normal/strip_layout.py by tools/transpile_kernel.py; change that one.
 *
 * How the rail is divided into strips: evenly over the zones first, then by the pressure that was found.
 *
 * Pieces of the rail have weights.  Each run of pieces that touch gets as many strips as its weight is worth,
 * all of one weight, and no fewer than FEWEST: with less a patch has no shape.
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

/* Cut about ``wanted`` strips from the cells, from each run of cells that touch as many as its weight is
 * worth; more, where there are several runs.
 */
static inline int64_t strip_layout__divide_cells(array_double_1d work, int64_t region_count, int64_t wanted)
{
    double total;
    int64_t index_end;
    int64_t index;
    double squares;
    int64_t first;
    int64_t last;
    double weight;
    double several;
    double each;
    int64_t made;
    int64_t number;
    total = 0.0;
    index_end = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELL_COUNT)));
    for (index = INT64_C(0); index < index_end; index += INT64_C(1))
    {
        total += (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELLS + layout__STRIP_CELL_SIZE * index + layout__STRIP_CELL_WEIGHT));
    }
    squares = 0.0;
    first = INT64_C(0);
    while(first < (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELL_COUNT))))
    {
        strip_layout__run_of_cells(&last, &weight, work, first);
        squares += weight * weight;
        first = last + INT64_C(1);
    }
    several = total * total / squares - 1.0;
    each = total / ((double)(wanted) * (1.0 + strip_layout__MORE * several));
    made = INT64_C(0);
    first = INT64_C(0);
    while(first < (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELL_COUNT))))
    {
        strip_layout__run_of_cells(&last, &weight, work, first);
        if (weight > 0.0)
        {
            number = (int64_t)(weight / each + 0.5);
            if (number < strip_layout__FEWEST)
            {
                number = strip_layout__FEWEST;
            }
            if (number > layout__STRIP_LIMIT - made)
            {
                number = layout__STRIP_LIMIT - made;
            }
            strip_layout__cut_run(work, first, made, number, weight);
            made += number;
        }
        first = last + INT64_C(1);
    }
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT)) = (double)(made);
    strip_layout__touch(work, made);
    strip_layout__place_in_regions(work, made, region_count);
    return INT64_C(0);
}

/* The last cell of the run of cells that touch and begins with ``first``, and the weight of the run. */
static inline int64_t strip_layout__run_of_cells(int64_t* last, double* weight, array_double_1d work, int64_t first)
{
    (*last) = first;
    (*weight) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELLS + layout__STRIP_CELL_SIZE * first + layout__STRIP_CELL_WEIGHT));
    while(((*last) < (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELL_COUNT))) - INT64_C(1)) && ((*weight) > 0.0) && (strip_layout__continued(work, (*last)) == INT64_C(1)))
    {
        (*last) += INT64_C(1);
        (*weight) += (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELLS + layout__STRIP_CELL_SIZE * (*last) + layout__STRIP_CELL_WEIGHT));
    }
    return 0;
}

/* 1 where the cell after ``index`` touches it and has a weight, else 0. */
static inline int64_t strip_layout__continued(array_double_1d work, int64_t index)
{
    int64_t following;
    int64_t answer;
    following = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELLS + layout__STRIP_CELL_SIZE * (index + INT64_C(1));
    answer = INT64_C(0);
    if (((*cspan_at(&work, following + layout__STRIP_CELL_WEIGHT)) > 0.0) && ((*cspan_at(&work, following + layout__STRIP_CELL_START)) - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELLS + layout__STRIP_CELL_SIZE * index + layout__STRIP_CELL_STOP)) < strip_layout__TOUCHING))
    {
        answer = INT64_C(1);
    }
    return answer;
}

/* Cut ``number`` strips of equal weight from a run of cells that begins with ``first`` and has this
 * ``weight``; strips are numbered from ``made`` on.
 */
static inline int64_t strip_layout__cut_run(array_double_1d work, int64_t first, int64_t made, int64_t number, double weight)
{
    double each;
    int64_t index;
    double done;
    double edge;
    int64_t cut;
    double wanted;
    int64_t cell;
    double stop;
    int64_t strip;
    each = weight / (double)(number);
    index = first;
    done = 0.0;
    edge = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELLS + layout__STRIP_CELL_SIZE * first + layout__STRIP_CELL_START));
    for (cut = INT64_C(0); cut < number; cut += INT64_C(1))
    {
        wanted = each * (double)(cut + INT64_C(1));
        while((cut < number - INT64_C(1)) && (done + (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELLS + layout__STRIP_CELL_SIZE * index + layout__STRIP_CELL_WEIGHT)) < wanted))
        {
            done += (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELLS + layout__STRIP_CELL_SIZE * index + layout__STRIP_CELL_WEIGHT));
            index += INT64_C(1);
        }
        cell = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELLS + layout__STRIP_CELL_SIZE * index;
        stop = (*cspan_at(&work, cell + layout__STRIP_CELL_START)) + (wanted - done) / (*cspan_at(&work, cell + layout__STRIP_CELL_WEIGHT)) * ((*cspan_at(&work, cell + layout__STRIP_CELL_STOP)) - (*cspan_at(&work, cell + layout__STRIP_CELL_START)));
        if (cut == number - INT64_C(1))
        {
            stop = strip_layout__run_stop(work, index);
        }
        strip = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (made + cut);
        (*cspan_at(&work, strip + layout__STRIP_STATION)) = 0.5 * (edge + stop);
        (*cspan_at(&work, strip + layout__STRIP_WIDTH)) = stop - edge;
        edge = stop;
    }
    return INT64_C(0);
}

/* Station [m] of the end of the run of cells that ``index`` is in. */
static inline double strip_layout__run_stop(array_double_1d work, int64_t index)
{
    double result;
    while((index < (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELL_COUNT))) - INT64_C(1)) && (strip_layout__continued(work, index) == INT64_C(1)))
    {
        index += INT64_C(1);
    }
    result = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELLS + layout__STRIP_CELL_SIZE * index + layout__STRIP_CELL_STOP));
    return result;
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
