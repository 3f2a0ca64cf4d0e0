/* Generated from tangent_strip_layout.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of strip_layout.py.
 */

#include "tangent_strip_layout.h"

/* Tangent of ``zone_cells``. */
static inline int64_t tangent_strip_layout__zone_cells_t(array_double_1d work, array_double_1d work_t, int64_t count)
{
    double width_t;
    double width;
    double depth_t;
    double depth;
    int64_t index;
    int64_t cells;
    int64_t zone;
    int64_t cell;
    double v1;
    double v2;
    double v3;
    double v4;
    double v5;
    double v6;
    width_t = 0.0;
    width = 0.0;
    depth_t = 0.0;
    depth = 0.0;
    for (index = INT64_C(0); index < count; index += INT64_C(1))
    {
        width_t = width_t + ((*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_ZONES + layout__STRIP_ZONE_SIZE * index + layout__STRIP_ZONE_STOP)) - (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_ZONES + layout__STRIP_ZONE_SIZE * index + layout__STRIP_ZONE_START)));
        width = width + ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_ZONES + layout__STRIP_ZONE_SIZE * index + layout__STRIP_ZONE_STOP)) - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_ZONES + layout__STRIP_ZONE_SIZE * index + layout__STRIP_ZONE_START)));
        depth_t = depth_t + (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_ZONES + layout__STRIP_ZONE_SIZE * index + layout__STRIP_ZONE_LEVEL));
        depth = depth + (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_ZONES + layout__STRIP_ZONE_SIZE * index + layout__STRIP_ZONE_LEVEL));
    }
    cells = INT64_C(0);
    for (index = INT64_C(0); index < count; index += INT64_C(1))
    {
        zone = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_ZONES + layout__STRIP_ZONE_SIZE * index;
        if ((*cspan_at(&work, zone + layout__STRIP_ZONE_STOP)) > (*cspan_at(&work, zone + layout__STRIP_ZONE_START)))
        {
            cell = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELLS + layout__STRIP_CELL_SIZE * cells;
            (*cspan_at(&work_t, cell + layout__STRIP_CELL_START)) = (*cspan_at(&work_t, zone + layout__STRIP_ZONE_START));
            (*cspan_at(&work, cell + layout__STRIP_CELL_START)) = (*cspan_at(&work, zone + layout__STRIP_ZONE_START));
            (*cspan_at(&work_t, cell + layout__STRIP_CELL_STOP)) = (*cspan_at(&work_t, zone + layout__STRIP_ZONE_STOP));
            (*cspan_at(&work, cell + layout__STRIP_CELL_STOP)) = (*cspan_at(&work, zone + layout__STRIP_ZONE_STOP));
            v1 = 1.0 - strip_layout__DEEP;
            v2 = (*cspan_at(&work, zone + layout__STRIP_ZONE_STOP)) - (*cspan_at(&work, zone + layout__STRIP_ZONE_START));
            v3 = v1 * v2;
            v4 = v3 / width;
            v5 = strip_layout__DEEP * (*cspan_at(&work, zone + layout__STRIP_ZONE_LEVEL));
            v6 = v5 / depth;
            (*cspan_at(&work_t, cell + layout__STRIP_CELL_WEIGHT)) = (v1 * ((*cspan_at(&work_t, zone + layout__STRIP_ZONE_STOP)) - (*cspan_at(&work_t, zone + layout__STRIP_ZONE_START))) - v4 * width_t) / width + (strip_layout__DEEP * (*cspan_at(&work_t, zone + layout__STRIP_ZONE_LEVEL)) - v6 * depth_t) / depth;
            (*cspan_at(&work, cell + layout__STRIP_CELL_WEIGHT)) = v4 + v6;
            cells = cells + INT64_C(1);
        }
    }
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELL_COUNT)) = 0.0;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELL_COUNT)) = (double)(cells);
    return INT64_C(0);
}

/* Tangent of ``touch``. */
static inline int64_t tangent_strip_layout__touch_t(array_double_1d work, array_double_1d work_t, int64_t count)
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
            if ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (i + INT64_C(1)) + layout__STRIP_STATION)) - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_STATION)) < reach + strip_layout__TOUCHING)
            {
                joined = INT64_C(1);
            }
        }
        (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_JOINED)) = 0.0;
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_JOINED)) = (double)(joined);
    }
    return INT64_C(0);
}

/* Tangent of ``strip_cells``. */
static inline int64_t tangent_strip_layout__strip_cells_t(array_double_1d work, array_double_1d work_t)
{
    int64_t count;
    double largest_t;
    double largest;
    int64_t i;
    double width_t;
    double width;
    double change_t;
    double change;
    double v1;
    double v1_t;
    double v2;
    int64_t strip;
    int64_t cell;
    double v3;
    double v3_t;
    double v4;
    double v5;
    double v6;
    double weight_t;
    double weight;
    double v7;
    double v8;
    double v8_t;
    double v9;
    double v10;
    count = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT)));
    largest_t = 0.0;
    largest = 0.0;
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        if ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_PRESSURE)) > largest)
        {
            largest_t = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_PRESSURE));
            largest = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_PRESSURE));
        }
    }
    width_t = 0.0;
    width = 0.0;
    change_t = 0.0;
    change = 0.0;
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        tangent_strip_layout__loaded_share_t(&v1, &v1_t, work, work_t, count, i, largest, largest_t);
        width_t = width_t + (v1_t * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_WIDTH)) + v1 * (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_WIDTH)));
        width = width + v1 * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_WIDTH));
        if ((i < count - INT64_C(1)) && ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_JOINED)) == 1.0))
        {
            v2 = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (i + INT64_C(1)) + layout__STRIP_PRESSURE)) - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_PRESSURE));
            change_t = change_t + tangent_rates__size_rate(v2, (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (i + INT64_C(1)) + layout__STRIP_PRESSURE)) - (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_PRESSURE)));
            change = change + fabs(v2);
        }
    }
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        strip = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i;
        cell = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELLS + layout__STRIP_CELL_SIZE * i;
        (*cspan_at(&work_t, cell + layout__STRIP_CELL_START)) = (*cspan_at(&work_t, strip + layout__STRIP_STATION)) - 0.5 * (*cspan_at(&work_t, strip + layout__STRIP_WIDTH));
        (*cspan_at(&work, cell + layout__STRIP_CELL_START)) = (*cspan_at(&work, strip + layout__STRIP_STATION)) - 0.5 * (*cspan_at(&work, strip + layout__STRIP_WIDTH));
        (*cspan_at(&work_t, cell + layout__STRIP_CELL_STOP)) = (*cspan_at(&work_t, strip + layout__STRIP_STATION)) + 0.5 * (*cspan_at(&work_t, strip + layout__STRIP_WIDTH));
        (*cspan_at(&work, cell + layout__STRIP_CELL_STOP)) = (*cspan_at(&work, strip + layout__STRIP_STATION)) + 0.5 * (*cspan_at(&work, strip + layout__STRIP_WIDTH));
        (*cspan_at(&work_t, cell + layout__STRIP_CELL_HALF_LENGTH)) = (*cspan_at(&work_t, strip + layout__STRIP_HALF_LENGTH));
        (*cspan_at(&work, cell + layout__STRIP_CELL_HALF_LENGTH)) = (*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH));
        (*cspan_at(&work_t, cell + layout__STRIP_CELL_LEAD)) = (*cspan_at(&work_t, strip + layout__STRIP_LEAD));
        (*cspan_at(&work, cell + layout__STRIP_CELL_LEAD)) = (*cspan_at(&work, strip + layout__STRIP_LEAD));
        (*cspan_at(&work_t, cell + layout__STRIP_CELL_LOADED)) = 0.0;
        (*cspan_at(&work, cell + layout__STRIP_CELL_LOADED)) = (double)((*cspan_at(&work, strip + layout__STRIP_PRESSURE)) > 0.0);
        tangent_strip_layout__loaded_share_t(&v3, &v3_t, work, work_t, count, i, largest, largest_t);
        v4 = strip_layout__EVEN * v3;
        v5 = v4 * (*cspan_at(&work, strip + layout__STRIP_WIDTH));
        v6 = v5 / width;
        weight_t = (strip_layout__EVEN * v3_t * (*cspan_at(&work, strip + layout__STRIP_WIDTH)) + v4 * (*cspan_at(&work_t, strip + layout__STRIP_WIDTH)) - v6 * width_t) / width;
        weight = v6;
        if (change > 0.0)
        {
            v7 = (1.0 - strip_layout__EVEN) * 0.5;
            tangent_strip_layout__pressure_changes_t(&v8, &v8_t, work, work_t, count, i);
            v9 = v7 * v8;
            v10 = v9 / change;
            weight_t = weight_t + (v7 * v8_t - v10 * change_t) / change;
            weight = weight + v10;
        }
        (*cspan_at(&work_t, cell + layout__STRIP_CELL_WEIGHT)) = weight_t;
        (*cspan_at(&work, cell + layout__STRIP_CELL_WEIGHT)) = weight;
    }
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELL_COUNT)) = 0.0;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELL_COUNT)) = (double)(count);
    return INT64_C(0);
}

/* Tangent of ``loaded_share``. */
static inline int64_t tangent_strip_layout__loaded_share_t(double* share, double* share_t, array_double_1d work, array_double_1d work_t, int64_t count, int64_t i, double largest, double largest_t)
{
    double pressure_t;
    double pressure;
    double v1;
    double v2;
    pressure_t = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_PRESSURE));
    pressure = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_PRESSURE));
    if ((i > INT64_C(0)) && ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (i - INT64_C(1)) + layout__STRIP_JOINED)) == 1.0))
    {
        if ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (i - INT64_C(1)) + layout__STRIP_PRESSURE)) > pressure)
        {
            pressure_t = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (i - INT64_C(1)) + layout__STRIP_PRESSURE));
            pressure = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (i - INT64_C(1)) + layout__STRIP_PRESSURE));
        }
    }
    if ((i < count - INT64_C(1)) && ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_JOINED)) == 1.0))
    {
        if ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (i + INT64_C(1)) + layout__STRIP_PRESSURE)) > pressure)
        {
            pressure_t = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (i + INT64_C(1)) + layout__STRIP_PRESSURE));
            pressure = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (i + INT64_C(1)) + layout__STRIP_PRESSURE));
        }
    }
    v1 = strip_layout__LOADED * largest;
    v2 = pressure / v1;
    (*share_t) = (pressure_t - v2 * (strip_layout__LOADED * largest_t)) / v1;
    (*share) = v2;
    if ((*share) > 1.0)
    {
        (*share_t) = 0.0;
        (*share) = 1.0;
    }
    return 0;
}

/* Tangent of ``pressure_changes``. */
static inline int64_t tangent_strip_layout__pressure_changes_t(double* change, double* change_t, array_double_1d work, array_double_1d work_t, int64_t count, int64_t i)
{
    double v1;
    double v2;
    (*change_t) = 0.0;
    (*change) = 0.0;
    if ((i > INT64_C(0)) && ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (i - INT64_C(1)) + layout__STRIP_JOINED)) == 1.0))
    {
        v1 = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_PRESSURE)) - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (i - INT64_C(1)) + layout__STRIP_PRESSURE));
        (*change_t) = (*change_t) + tangent_rates__size_rate(v1, (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_PRESSURE)) - (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (i - INT64_C(1)) + layout__STRIP_PRESSURE)));
        (*change) = (*change) + fabs(v1);
    }
    if ((i < count - INT64_C(1)) && ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_JOINED)) == 1.0))
    {
        v2 = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (i + INT64_C(1)) + layout__STRIP_PRESSURE)) - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_PRESSURE));
        (*change_t) = (*change_t) + tangent_rates__size_rate(v2, (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (i + INT64_C(1)) + layout__STRIP_PRESSURE)) - (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_PRESSURE)));
        (*change) = (*change) + fabs(v2);
    }
    return 0;
}

/* Tangent of ``divide_cells``. */
static inline int64_t tangent_strip_layout__divide_cells_t(array_double_1d work, array_double_1d work_t, int64_t region_count, int64_t wanted)
{
    double total_t;
    double total;
    int64_t index_end;
    int64_t index;
    double squares_t;
    double squares;
    int64_t first;
    int64_t last;
    double weight;
    double weight_t;
    double v1;
    double v2;
    double several_t;
    double several;
    double v3;
    double v4;
    double v5;
    double v6;
    double each_t;
    double each;
    int64_t made;
    int64_t number;
    total_t = 0.0;
    total = 0.0;
    index_end = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELL_COUNT)));
    for (index = INT64_C(0); index < index_end; index += INT64_C(1))
    {
        total_t = total_t + (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELLS + layout__STRIP_CELL_SIZE * index + layout__STRIP_CELL_WEIGHT));
        total = total + (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELLS + layout__STRIP_CELL_SIZE * index + layout__STRIP_CELL_WEIGHT));
    }
    squares_t = 0.0;
    squares = 0.0;
    first = INT64_C(0);
    while(first < (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELL_COUNT))))
    {
        tangent_strip_layout__run_of_cells_t(&last, &weight, &weight_t, work, work_t, first);
        squares_t = squares_t + (weight_t * weight + weight * weight_t);
        squares = squares + weight * weight;
        first = last + INT64_C(1);
    }
    v1 = total * total;
    v2 = v1 / squares;
    several_t = (total_t * total + total * total_t - v2 * squares_t) / squares;
    several = v2 - 1.0;
    v3 = (double)(wanted);
    v4 = 1.0 + strip_layout__MORE * several;
    v5 = v3 * v4;
    v6 = total / v5;
    each_t = (total_t - v6 * (v3 * (strip_layout__MORE * several_t))) / v5;
    each = v6;
    made = INT64_C(0);
    first = INT64_C(0);
    while(first < (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELL_COUNT))))
    {
        tangent_strip_layout__run_of_cells_t(&last, &weight, &weight_t, work, work_t, first);
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
            tangent_strip_layout__cut_run_t(work, work_t, first, made, number, weight, weight_t);
            made = made + number;
        }
        first = last + INT64_C(1);
    }
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT)) = 0.0;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT)) = (double)(made);
    tangent_strip_layout__touch_t(work, work_t, made);
    tangent_strip_layout__place_in_regions_t(work, work_t, made, region_count);
    return INT64_C(0);
}

/* Tangent of ``run_of_cells``. */
static inline int64_t tangent_strip_layout__run_of_cells_t(int64_t* last, double* weight, double* weight_t, array_double_1d work, array_double_1d work_t, int64_t first)
{
    (*last) = first;
    (*weight_t) = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELLS + layout__STRIP_CELL_SIZE * first + layout__STRIP_CELL_WEIGHT));
    (*weight) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELLS + layout__STRIP_CELL_SIZE * first + layout__STRIP_CELL_WEIGHT));
    while(((*last) < (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELL_COUNT))) - INT64_C(1)) && ((*weight) > 0.0) && (strip_layout__continued(work, (*last)) == INT64_C(1)))
    {
        (*last) = (*last) + INT64_C(1);
        (*weight_t) = (*weight_t) + (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELLS + layout__STRIP_CELL_SIZE * (*last) + layout__STRIP_CELL_WEIGHT));
        (*weight) = (*weight) + (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELLS + layout__STRIP_CELL_SIZE * (*last) + layout__STRIP_CELL_WEIGHT));
    }
    return 0;
}

/* Tangent of ``cut_run``. */
static inline int64_t tangent_strip_layout__cut_run_t(array_double_1d work, array_double_1d work_t, int64_t first, int64_t made, int64_t number, double weight, double weight_t)
{
    double v1;
    double each_t;
    double each;
    int64_t index;
    double done_t;
    double done;
    double edge_t;
    double edge;
    int64_t cut;
    double v2;
    double wanted_t;
    double wanted;
    int64_t cell;
    double v3;
    double v4;
    double v5;
    double stop_t;
    double stop;
    double v6;
    double v6_t;
    int64_t strip;
    double v7;
    v1 = (double)(number);
    each_t = weight_t / v1;
    each = weight / v1;
    index = first;
    done_t = 0.0;
    done = 0.0;
    edge_t = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELLS + layout__STRIP_CELL_SIZE * first + layout__STRIP_CELL_START));
    edge = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELLS + layout__STRIP_CELL_SIZE * first + layout__STRIP_CELL_START));
    for (cut = INT64_C(0); cut < number; cut += INT64_C(1))
    {
        v2 = (double)(cut + INT64_C(1));
        wanted_t = each_t * v2;
        wanted = each * v2;
        while((cut < number - INT64_C(1)) && (done + (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELLS + layout__STRIP_CELL_SIZE * index + layout__STRIP_CELL_WEIGHT)) < wanted))
        {
            done_t = done_t + (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELLS + layout__STRIP_CELL_SIZE * index + layout__STRIP_CELL_WEIGHT));
            done = done + (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELLS + layout__STRIP_CELL_SIZE * index + layout__STRIP_CELL_WEIGHT));
            index = index + INT64_C(1);
        }
        cell = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELLS + layout__STRIP_CELL_SIZE * index;
        v3 = wanted - done;
        v4 = v3 / (*cspan_at(&work, cell + layout__STRIP_CELL_WEIGHT));
        v5 = (*cspan_at(&work, cell + layout__STRIP_CELL_STOP)) - (*cspan_at(&work, cell + layout__STRIP_CELL_START));
        stop_t = (*cspan_at(&work_t, cell + layout__STRIP_CELL_START)) + ((wanted_t - done_t - v4 * (*cspan_at(&work_t, cell + layout__STRIP_CELL_WEIGHT))) / (*cspan_at(&work, cell + layout__STRIP_CELL_WEIGHT)) * v5 + v4 * ((*cspan_at(&work_t, cell + layout__STRIP_CELL_STOP)) - (*cspan_at(&work_t, cell + layout__STRIP_CELL_START))));
        stop = (*cspan_at(&work, cell + layout__STRIP_CELL_START)) + v4 * v5;
        if (cut == number - INT64_C(1))
        {
            tangent_strip_layout__run_stop_t(&v6, &v6_t, work, work_t, index);
            stop_t = v6_t;
            stop = v6;
        }
        strip = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (made + cut);
        v7 = edge + stop;
        (*cspan_at(&work_t, strip + layout__STRIP_STATION)) = 0.5 * (edge_t + stop_t);
        (*cspan_at(&work, strip + layout__STRIP_STATION)) = 0.5 * v7;
        (*cspan_at(&work_t, strip + layout__STRIP_WIDTH)) = stop_t - edge_t;
        (*cspan_at(&work, strip + layout__STRIP_WIDTH)) = stop - edge;
        edge_t = stop_t;
        edge = stop;
    }
    return INT64_C(0);
}

/* Tangent of ``run_stop``. */
static inline int64_t tangent_strip_layout__run_stop_t(double* result_0, double* result_1, array_double_1d work, array_double_1d work_t, int64_t index)
{
    while((index < (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELL_COUNT))) - INT64_C(1)) && (strip_layout__continued(work, index) == INT64_C(1)))
    {
        index = index + INT64_C(1);
    }
    (*result_0) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELLS + layout__STRIP_CELL_SIZE * index + layout__STRIP_CELL_STOP));
    (*result_1) = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELLS + layout__STRIP_CELL_SIZE * index + layout__STRIP_CELL_STOP));
    return 0;
}

/* Tangent of ``place_in_regions``. */
static inline int64_t tangent_strip_layout__place_in_regions_t(array_double_1d work, array_double_1d work_t, int64_t count, int64_t region_count)
{
    int64_t index;
    int64_t i;
    index = INT64_C(0);
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        while((index < region_count - INT64_C(1)) && ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_STATION)) > (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * index + layout__REGION_OFFSET)) + (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * index + layout__REGION_HIGH))))
        {
            index = index + INT64_C(1);
        }
        (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_REGION)) = 0.0;
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_REGION)) = (double)(index);
    }
    return INT64_C(0);
}

/* Tangent of ``length_before``. */
static inline int64_t tangent_strip_layout__length_before_t(array_double_1d work, array_double_1d work_t)
{
    int64_t last;
    int64_t index;
    int64_t i_end;
    int64_t i;
    int64_t strip;
    int64_t after;
    double share_t;
    double share;
    double v1;
    double v1_t;
    double v2;
    double v2_t;
    double reach_t;
    double reach;
    double v3;
    double v3_t;
    double v4;
    double v5;
    double rest_t;
    double rest;
    last = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELL_COUNT))) - INT64_C(1);
    index = INT64_C(0);
    i_end = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT)));
    for (i = INT64_C(0); i < i_end; i += INT64_C(1))
    {
        strip = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i;
        while((index < last - INT64_C(1)) && ((*cspan_at(&work, strip + layout__STRIP_STATION)) > strip_layout__cell_middle(work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELLS + layout__STRIP_CELL_SIZE * (index + INT64_C(1)))))
        {
            index = index + INT64_C(1);
        }
        after = index;
        if (index < last)
        {
            after = index + INT64_C(1);
        }
        share_t = 0.0;
        share = 0.0;
        tangent_strip_layout__cell_middle_t(&v1, &v1_t, work, work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELLS + layout__STRIP_CELL_SIZE * after);
        tangent_strip_layout__cell_middle_t(&v2, &v2_t, work, work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELLS + layout__STRIP_CELL_SIZE * index);
        reach_t = v1_t - v2_t;
        reach = v1 - v2;
        if (reach > 0.0)
        {
            tangent_strip_layout__cell_middle_t(&v3, &v3_t, work, work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELLS + layout__STRIP_CELL_SIZE * index);
            v4 = (*cspan_at(&work, strip + layout__STRIP_STATION)) - v3;
            v5 = v4 / reach;
            share_t = ((*cspan_at(&work_t, strip + layout__STRIP_STATION)) - v3_t - v5 * reach_t) / reach;
            share = v5;
            if (share < 0.0)
            {
                share_t = 0.0;
                share = 0.0;
            }
            if (share > 1.0)
            {
                share_t = 0.0;
                share = 1.0;
            }
        }
        rest_t = -share_t;
        rest = 1.0 - share;
        (*cspan_at(&work_t, strip + layout__STRIP_HALF_LENGTH)) = rest_t * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELLS + layout__STRIP_CELL_SIZE * index + layout__STRIP_CELL_HALF_LENGTH)) + rest * (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELLS + layout__STRIP_CELL_SIZE * index + layout__STRIP_CELL_HALF_LENGTH)) + (share_t * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELLS + layout__STRIP_CELL_SIZE * after + layout__STRIP_CELL_HALF_LENGTH)) + share * (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELLS + layout__STRIP_CELL_SIZE * after + layout__STRIP_CELL_HALF_LENGTH)));
        (*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH)) = rest * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELLS + layout__STRIP_CELL_SIZE * index + layout__STRIP_CELL_HALF_LENGTH)) + share * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELLS + layout__STRIP_CELL_SIZE * after + layout__STRIP_CELL_HALF_LENGTH));
        (*cspan_at(&work_t, strip + layout__STRIP_LEAD)) = rest_t * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELLS + layout__STRIP_CELL_SIZE * index + layout__STRIP_CELL_LEAD)) + rest * (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELLS + layout__STRIP_CELL_SIZE * index + layout__STRIP_CELL_LEAD)) + (share_t * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELLS + layout__STRIP_CELL_SIZE * after + layout__STRIP_CELL_LEAD)) + share * (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELLS + layout__STRIP_CELL_SIZE * after + layout__STRIP_CELL_LEAD)));
        (*cspan_at(&work, strip + layout__STRIP_LEAD)) = rest * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELLS + layout__STRIP_CELL_SIZE * index + layout__STRIP_CELL_LEAD)) + share * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELLS + layout__STRIP_CELL_SIZE * after + layout__STRIP_CELL_LEAD));
        (*cspan_at(&work_t, strip + layout__STRIP_LOADED)) = 0.0;
        (*cspan_at(&work, strip + layout__STRIP_LOADED)) = (double)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELLS + layout__STRIP_CELL_SIZE * index + layout__STRIP_CELL_LOADED)) == 1.0);
        if (share > 0.5)
        {
            (*cspan_at(&work_t, strip + layout__STRIP_LOADED)) = 0.0;
            (*cspan_at(&work, strip + layout__STRIP_LOADED)) = (double)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_CELLS + layout__STRIP_CELL_SIZE * after + layout__STRIP_CELL_LOADED)) == 1.0);
        }
    }
    return INT64_C(0);
}

/* Tangent of ``cell_middle``. */
static inline int64_t tangent_strip_layout__cell_middle_t(double* result_0, double* result_1, array_double_1d work, array_double_1d work_t, int64_t cell)
{
    double v1;
    v1 = (*cspan_at(&work, cell + layout__STRIP_CELL_START)) + (*cspan_at(&work, cell + layout__STRIP_CELL_STOP));
    (*result_0) = 0.5 * v1;
    (*result_1) = 0.5 * ((*cspan_at(&work_t, cell + layout__STRIP_CELL_START)) + (*cspan_at(&work_t, cell + layout__STRIP_CELL_STOP)));
    return 0;
}
