/* Generated from tangent_patches.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of patches.py.
 */

#include "tangent_patches.h"

/* Tangent of ``quadratic_moment``. */
static inline int64_t tangent_patches__quadratic_moment_t(double* result_0, double* result_1, double before, double before_t, double low, double low_t, double high, double high_t, double start, double start_t, double stop, double stop_t)
{
    double v1;
    double v1_t;
    double bend_t;
    double bend;
    double slope_t;
    double slope;
    double v2;
    double v3;
    double v4;
    double v5;
    double upper_t;
    double upper;
    double v6;
    double v7;
    double v8;
    double v9;
    double lower_t;
    double lower;
    tangent_analyn__bend_of_t(&v1, &v1_t, before, before_t, low, low_t, high, high_t);
    bend_t = v1_t;
    bend = v1;
    slope_t = high_t - low_t - bend_t;
    slope = high - low - bend;
    v2 = stop * stop;
    v3 = stop * bend;
    v4 = slope / 3.0 + v3 / 4.0;
    v5 = low / 2.0 + stop * v4;
    upper_t = (stop_t * stop + stop * stop_t) * v5 + v2 * (low_t / 2.0 + (stop_t * v4 + stop * (slope_t / 3.0 + (stop_t * bend + stop * bend_t) / 4.0)));
    upper = v2 * v5;
    v6 = start * start;
    v7 = start * bend;
    v8 = slope / 3.0 + v7 / 4.0;
    v9 = low / 2.0 + start * v8;
    lower_t = (start_t * start + start * start_t) * v9 + v6 * (low_t / 2.0 + (start_t * v8 + start * (slope_t / 3.0 + (start_t * bend + start * bend_t) / 4.0)));
    lower = v6 * v9;
    (*result_0) = upper - lower;
    (*result_1) = upper_t - lower_t;
    return 0;
}

/* Tangent of ``bent_integral``. */
static inline int64_t tangent_patches__bent_integral_t(double* result_0, double* result_1, double low, double low_t, double slope, double slope_t, double bend, double bend_t, double start, double start_t, double stop, double stop_t)
{
    double v1;
    double first_t;
    double first;
    double v2;
    double last_t;
    double last;
    double v3;
    double spread_t;
    double spread;
    double v4;
    double first_root_t;
    double first_root;
    double v5;
    double last_root_t;
    double last_root;
    double v6;
    double first_rate_t;
    double first_rate;
    double v7;
    double last_rate_t;
    double last_rate;
    double v8;
    double v9;
    double across_t;
    double across;
    double v10;
    double height_t;
    double height;
    double v11;
    double height_before_t;
    double height_before;
    double v12;
    double v13;
    double angle_t;
    double angle;
    double v14;
    double v15;
    double v16;
    double v17;
    double v18;
    double v19;
    double v20;
    v1 = slope + start * bend;
    first_t = low_t + (start_t * v1 + start * (slope_t + (start_t * bend + start * bend_t)));
    first = low + start * v1;
    v2 = slope + stop * bend;
    last_t = low_t + (stop_t * v2 + stop * (slope_t + (stop_t * bend + stop * bend_t)));
    last = low + stop * v2;
    if (first < 0.0)
    {
        first_t = 0.0;
        first = 0.0;
    }
    if (last < 0.0)
    {
        last_t = 0.0;
        last = 0.0;
    }
    v3 = 4.0 * bend;
    spread_t = slope_t * slope + slope * slope_t - (4.0 * bend_t * low + v3 * low_t);
    spread = slope * slope - v3 * low;
    if (!(spread > 0.0))
    {
        (*result_0) = 0.0;
        (*result_1) = 0.0;
        return 0;
    }
    v4 = sqrt(first);
    first_root_t = tangent_rates__root_rate(v4, first_t);
    first_root = v4;
    v5 = sqrt(last);
    last_root_t = tangent_rates__root_rate(v5, last_t);
    last_root = v5;
    v6 = 2.0 * bend;
    first_rate_t = 2.0 * bend_t * start + v6 * start_t + slope_t;
    first_rate = v6 * start + slope;
    v7 = 2.0 * bend;
    last_rate_t = 2.0 * bend_t * stop + v7 * stop_t + slope_t;
    last_rate = v7 * stop + slope;
    v8 = -bend;
    v9 = sqrt(v8);
    across_t = tangent_rates__root_rate(v9, -bend_t);
    across = v9;
    v10 = 2.0 * across;
    height_t = 2.0 * across_t * last_root + v10 * last_root_t;
    height = v10 * last_root;
    v11 = 2.0 * across;
    height_before_t = 2.0 * across_t * first_root + v11 * first_root_t;
    height_before = v11 * first_root;
    v12 = height * first_rate - height_before * last_rate;
    v13 = height * height_before + last_rate * first_rate;
    angle_t = (v13 * (height_t * first_rate + height * first_rate_t - (height_before_t * last_rate + height_before * last_rate_t)) - v12 * (height_t * height_before + height * height_before_t + (last_rate_t * first_rate + last_rate * first_rate_t))) / (v13 * v13 + v12 * v12);
    angle = atan2(v12, v13);
    v14 = last_rate * last_root - first_rate * first_root;
    v15 = 4.0 * bend;
    v16 = v14 / v15;
    v17 = -bend;
    v18 = 8.0 * v17;
    v19 = v18 * across;
    v20 = spread / v19;
    (*result_0) = v16 + v20 * angle;
    (*result_1) = (last_rate_t * last_root + last_rate * last_root_t - (first_rate_t * first_root + first_rate * first_root_t) - v16 * (4.0 * bend_t)) / v15 + ((spread_t - v20 * (8.0 * (-bend_t) * across + v18 * across_t)) / v19 * angle + v20 * angle_t);
    return 0;
}

/* Tangent of ``root_integral``. */
static inline int64_t tangent_patches__root_integral_t(double* v2, double* v2_t, double before, double before_t, double low, double low_t, double high, double high_t, double start, double start_t, double stop, double stop_t)
{
    double v1;
    double v1_t;
    double bend_t;
    double bend;
    double slope_t;
    double slope;
    double v3;
    double first_t;
    double first;
    double v4;
    double last_t;
    double last;
    double v5;
    double p_t;
    double p;
    double v6;
    double q_t;
    double q;
    double total_t;
    double total;
    double width_t;
    double width;
    double v7;
    double v8;
    double v9;
    double v10;
    double chord_t;
    double chord;
    double v11;
    double v12;
    double v13;
    double v14;
    double v15;
    double v16;
    double v17;
    double v18;
    double v19;
    double v20;
    double v21;
    tangent_analyn__bend_of_t(&v1, &v1_t, before, before_t, low, low_t, high, high_t);
    bend_t = v1_t;
    bend = v1;
    slope_t = high_t - low_t - bend_t;
    slope = high - low - bend;
    if (bend < (-patches__STRAIGHT) * (fabs(low) + fabs(high)))
    {
        tangent_patches__bent_integral_t(v2, v2_t, low, low_t, slope, slope_t, bend, bend_t, start, start_t, stop, stop_t);
        return 0;
    }
    v3 = slope + start * bend;
    first_t = low_t + (start_t * v3 + start * (slope_t + (start_t * bend + start * bend_t)));
    first = low + start * v3;
    v4 = slope + stop * bend;
    last_t = low_t + (stop_t * v4 + stop * (slope_t + (stop_t * bend + stop * bend_t)));
    last = low + stop * v4;
    if (first < 0.0)
    {
        first_t = 0.0;
        first = 0.0;
    }
    if (last < 0.0)
    {
        last_t = 0.0;
        last = 0.0;
    }
    v5 = sqrt(first);
    p_t = tangent_rates__root_rate(v5, first_t);
    p = v5;
    v6 = sqrt(last);
    q_t = tangent_rates__root_rate(v6, last_t);
    q = v6;
    total_t = p_t + q_t;
    total = p + q;
    if (!(total > 0.0))
    {
        (*v2) = 0.0;
        (*v2_t) = 0.0;
        return 0;
    }
    width_t = stop_t - start_t;
    width = stop - start;
    v7 = 2.0 / 3.0;
    v8 = first + p * q + last;
    v9 = v7 * v8;
    v10 = v9 / total;
    chord_t = (v7 * (first_t + (p_t * q + p * q_t) + last_t) - v10 * total_t) / total;
    chord = v10;
    v11 = 2.0 / 15.0;
    v12 = v11 * bend;
    v13 = v12 * width;
    v14 = v13 * width;
    v15 = 3.0 * p;
    v16 = first + v15 * q + last;
    v17 = v14 * v16;
    v18 = total * total;
    v19 = v18 * total;
    v20 = v17 / v19;
    v21 = chord - v20;
    (*v2) = width * v21;
    (*v2_t) = width_t * v21 + width * (chord_t - (((v11 * bend_t * width + v12 * width_t) * width + v13 * width_t) * v16 + v14 * (first_t + (3.0 * p_t * q + v15 * q_t) + last_t) - v20 * ((total_t * total + total * total_t) * total + v18 * total_t)) / v19);
    return 0;
}

/* Tangent of ``load_nodes``. */
static inline int64_t tangent_patches__load_nodes_t(array_double_1d work, array_double_1d work_t, int64_t region, double level, double level_t)
{
    int64_t block;
    int64_t rises;
    int64_t lines;
    int64_t lengths;
    int64_t loads;
    int64_t squares;
    int64_t pressures;
    int64_t k_end;
    int64_t k;
    double d_t;
    double d;
    double load_t;
    double load;
    double v1;
    double v2;
    double v3;
    double v4;
    block = layout__WORK_REGIONS + layout__REGION_SIZE * region;
    rises = nodes__node_field(region, nodes__NODE_RISE);
    lines = nodes__node_field(region, nodes__NODE_LINE);
    lengths = nodes__node_field(region, nodes__NODE_LENGTH);
    loads = nodes__node_field(region, nodes__NODE_LOAD);
    squares = nodes__node_field(region, nodes__NODE_SQUARE);
    pressures = nodes__node_field(region, nodes__NODE_PRESSURE);
    k_end = (int64_t)((*cspan_at(&work, block + layout__REGION_LAST))) + INT64_C(1);
    for (k = (int64_t)((*cspan_at(&work, block + layout__REGION_FIRST))); k < k_end; k += INT64_C(1))
    {
        d_t = level_t - (*cspan_at(&work_t, rises + k));
        d = level - (*cspan_at(&work, rises + k));
        load_t = (*cspan_at(&work_t, lines + k)) * d + (*cspan_at(&work, lines + k)) * d_t;
        load = (*cspan_at(&work, lines + k)) * d;
        (*cspan_at(&work_t, loads + k)) = load_t;
        (*cspan_at(&work, loads + k)) = load;
        v1 = d / (*cspan_at(&work, lengths + k));
        (*cspan_at(&work_t, squares + k)) = (d_t - v1 * (*cspan_at(&work_t, lengths + k))) / (*cspan_at(&work, lengths + k));
        (*cspan_at(&work, squares + k)) = v1;
        v2 = 4.0 / (M_PI * M_PI);
        v3 = v2 * (*cspan_at(&work, lines + k));
        v4 = v3 * load;
        (*cspan_at(&work_t, pressures + k)) = (v2 * (*cspan_at(&work_t, lines + k)) * load + v3 * load_t) * (*cspan_at(&work, lengths + k)) + v4 * (*cspan_at(&work_t, lengths + k));
        (*cspan_at(&work, pressures + k)) = v4 * (*cspan_at(&work, lengths + k));
    }
    return INT64_C(0);
}

/* Tangent of ``peak_square``. */
static inline int64_t tangent_patches__peak_square_t(double* square, double* square_t, array_double_1d work, array_double_1d work_t, int64_t field, int64_t k)
{
    double before_t;
    double before;
    double after_t;
    double after;
    double v1;
    double top_t;
    double top;
    double v2;
    double left_t;
    double left;
    double v3;
    double right_t;
    double right;
    double bend_t;
    double bend;
    double v4;
    double v5;
    double v6;
    double v7;
    double v8;
    (*square_t) = (*cspan_at(&work_t, field + k));
    (*square) = (*cspan_at(&work, field + k));
    before_t = (*cspan_at(&work_t, field + k - INT64_C(1)));
    before = (*cspan_at(&work, field + k - INT64_C(1)));
    after_t = (*cspan_at(&work_t, field + k + INT64_C(1)));
    after = (*cspan_at(&work, field + k + INT64_C(1)));
    if ((before > 0.0) && (after > 0.0) && ((*square) >= before) && ((*square) >= after))
    {
        v1 = sqrt((*square));
        top_t = tangent_rates__root_rate(v1, (*square_t));
        top = v1;
        v2 = sqrt(before);
        left_t = tangent_rates__root_rate(v2, before_t);
        left = v2;
        v3 = sqrt(after);
        right_t = tangent_rates__root_rate(v3, after_t);
        right = v3;
        bend_t = left_t - 2.0 * top_t + right_t;
        bend = left - 2.0 * top + right;
        if (bend < 0.0)
        {
            v4 = right - left;
            v5 = right - left;
            v6 = v4 * v5;
            v7 = 8.0 * bend;
            v8 = v6 / v7;
            top_t = top_t - ((right_t - left_t) * v5 + v4 * (right_t - left_t) - v8 * (8.0 * bend_t)) / v7;
            top = top - v8;
            (*square_t) = top_t * top + top * top_t;
            (*square) = top * top;
        }
    }
    return 0;
}

/* Tangent of ``open_island``. */
static inline int64_t tangent_patches__open_island_t(array_double_1d work, array_double_1d work_t, int64_t count, double start, double start_t, double angle, double angle_t)
{
    int64_t at;
    int64_t i;
    at = layout__WORK_ISLANDS + patches__ISLAND_SIZE * count;
    for (i = INT64_C(0); i < patches__ISLAND_SIZE; i += INT64_C(1))
    {
        (*cspan_at(&work_t, at + i)) = 0.0;
        (*cspan_at(&work, at + i)) = 0.0;
    }
    (*cspan_at(&work_t, at + patches__ISLAND_START)) = start_t;
    (*cspan_at(&work, at + patches__ISLAND_START)) = start;
    (*cspan_at(&work_t, at + patches__ISLAND_STOP)) = start_t;
    (*cspan_at(&work, at + patches__ISLAND_STOP)) = start;
    (*cspan_at(&work_t, at + patches__ISLAND_ANGLE)) = angle_t;
    (*cspan_at(&work, at + patches__ISLAND_ANGLE)) = angle;
    return INT64_C(0);
}

/* Tangent of ``gather_islands``. */
static inline int64_t tangent_patches__gather_islands_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t count)
{
    int64_t region;
    int64_t block;
    double level_t;
    double level;
    double angle_t;
    double angle;
    int64_t k_end;
    int64_t k;
    int64_t n1;
    int64_t islands;
    islands = INT64_C(0);
    for (region = INT64_C(0); region < count; region += INT64_C(1))
    {
        block = layout__WORK_REGIONS + layout__REGION_SIZE * region;
        level_t = (*cspan_at(&work_t, block + layout__REGION_LEVEL));
        level = (*cspan_at(&work, block + layout__REGION_LEVEL));
        (*cspan_at(&work_t, block + layout__REGION_CARRIED)) = 0.0;
        (*cspan_at(&work, block + layout__REGION_CARRIED)) = 0.0;
        (*cspan_at(&work_t, block + layout__REGION_MOMENT)) = 0.0;
        (*cspan_at(&work, block + layout__REGION_MOMENT)) = 0.0;
        if (level > 0.0)
        {
            angle_t = -((*cspan_at(&work_t, block + layout__REGION_LEAN)) / (1.0 + (*cspan_at(&work, block + layout__REGION_LEAN)) * (*cspan_at(&work, block + layout__REGION_LEAN))));
            angle = -atan((*cspan_at(&work, block + layout__REGION_LEAN)));
            tangent_patches__load_nodes_t(work, work_t, region, level, level_t);
            k_end = (int64_t)((*cspan_at(&work, block + layout__REGION_LAST)));
            for (k = (int64_t)((*cspan_at(&work, block + layout__REGION_FIRST))); k < k_end; k += INT64_C(1))
            {
                n1 = tangent_patches__gather_cell_t(work, work_t, region, level, level_t, k, islands, angle, angle_t);
                islands = n1;
            }
        }
    }
    return islands;
}

/* Tangent of ``gather_cell``. */
static inline int64_t tangent_patches__gather_cell_t(array_double_1d work, array_double_1d work_t, int64_t region, double level, double level_t, int64_t k, int64_t islands, double angle, double angle_t)
{
    int64_t block;
    double spacing_t;
    double spacing;
    int64_t outward;
    int64_t low;
    int64_t before;
    int64_t high;
    int64_t rises;
    double start;
    double start_t;
    double stop;
    double stop_t;
    double v1;
    double v1_t;
    double v2;
    double inner_t;
    double inner;
    double begin_t;
    double begin;
    double end_t;
    double end;
    int64_t joined;
    int64_t at;
    double v3;
    block = layout__WORK_REGIONS + layout__REGION_SIZE * region;
    spacing_t = (*cspan_at(&work_t, block + layout__REGION_SPACING));
    spacing = (*cspan_at(&work, block + layout__REGION_SPACING));
    outward = INT64_C(1);
    low = k;
    if (k < INT64_C(0))
    {
        outward = -INT64_C(1);
        low = k + INT64_C(1);
    }
    before = low - outward;
    high = low + outward;
    rises = nodes__node_field(region, nodes__NODE_RISE);
    tangent_analyn__cell_part_t(&start, &start_t, &stop, &stop_t, level - (*cspan_at(&work, rises + before)), level_t - (*cspan_at(&work_t, rises + before)), level - (*cspan_at(&work, rises + low)), level_t - (*cspan_at(&work_t, rises + low)), level - (*cspan_at(&work, rises + high)), level_t - (*cspan_at(&work_t, rises + high)));
    if ((k == (int64_t)((*cspan_at(&work, block + layout__REGION_FIRST)))) || (k == (int64_t)((*cspan_at(&work, block + layout__REGION_LAST))) - INT64_C(1)))
    {
        tangent_analyn__clip_to_bound_t(&v1, &v1_t, work, work_t, block, low, outward, stop, stop_t);
        stop_t = v1_t;
        stop = v1;
    }
    if (stop > start)
    {
        v2 = (double)(low);
        inner_t = (*cspan_at(&work_t, block + layout__REGION_OFFSET)) + (*cspan_at(&work_t, block + layout__REGION_STATION)) + spacing_t * v2;
        inner = (*cspan_at(&work, block + layout__REGION_OFFSET)) + (*cspan_at(&work, block + layout__REGION_STATION)) + spacing * v2;
        begin_t = inner_t + (spacing_t * start + spacing * start_t);
        begin = inner + spacing * start;
        end_t = inner_t + (spacing_t * stop + spacing * stop_t);
        end = inner + spacing * stop;
        if (outward < INT64_C(0))
        {
            begin_t = inner_t - (spacing_t * stop + spacing * stop_t);
            begin = inner - spacing * stop;
            end_t = inner_t - (spacing_t * start + spacing * start_t);
            end = inner - spacing * start;
        }
        joined = INT64_C(0);
        if (islands > INT64_C(0))
        {
            if (begin - (*cspan_at(&work, layout__WORK_ISLANDS + patches__ISLAND_SIZE * (islands - INT64_C(1)) + patches__ISLAND_STOP)) < patches__JOINED * spacing)
            {
                joined = INT64_C(1);
            }
        }
        if ((joined == INT64_C(0)) && (islands < patches__ISLAND_LIMIT))
        {
            tangent_patches__open_island_t(work, work_t, islands, begin, begin_t, angle, angle_t);
            islands = islands + INT64_C(1);
        }
        at = layout__WORK_ISLANDS + patches__ISLAND_SIZE * (islands - INT64_C(1));
        (*cspan_at(&work_t, at + patches__ISLAND_STOP)) = end_t;
        (*cspan_at(&work, at + patches__ISLAND_STOP)) = end;
        v3 = (double)(outward);
        tangent_patches__add_cell_t(work, work_t, region, before, low, high, start, start_t, stop, stop_t, at, inner, inner_t, spacing * v3, spacing_t * v3);
    }
    return islands;
}

/* Tangent of ``add_cell``. */
static inline int64_t tangent_patches__add_cell_t(array_double_1d work, array_double_1d work_t, int64_t region, int64_t before, int64_t low, int64_t high, double start, double start_t, double stop, double stop_t, int64_t at, double inner, double inner_t, double step, double step_t)
{
    int64_t loads;
    int64_t squares;
    int64_t pressures;
    double width_t;
    double width;
    double v1;
    double v1_t;
    double load_t;
    double load;
    double v2;
    double v2_t;
    double moment_t;
    double moment;
    double v3;
    double v3_t;
    double area_t;
    double area;
    double v4;
    double v5;
    double v6;
    double v6_t;
    double v7;
    double v7_t;
    loads = nodes__node_field(region, nodes__NODE_LOAD);
    squares = nodes__node_field(region, nodes__NODE_SQUARE);
    pressures = nodes__node_field(region, nodes__NODE_PRESSURE);
    width_t = tangent_rates__size_rate(step, step_t);
    width = fabs(step);
    tangent_analyn__quadratic_integral_t(&v1, &v1_t, (*cspan_at(&work, loads + before)), (*cspan_at(&work_t, loads + before)), (*cspan_at(&work, loads + low)), (*cspan_at(&work_t, loads + low)), (*cspan_at(&work, loads + high)), (*cspan_at(&work_t, loads + high)), start, start_t, stop, stop_t);
    load_t = width_t * v1 + width * v1_t;
    load = width * v1;
    tangent_patches__quadratic_moment_t(&v2, &v2_t, (*cspan_at(&work, loads + before)), (*cspan_at(&work_t, loads + before)), (*cspan_at(&work, loads + low)), (*cspan_at(&work_t, loads + low)), (*cspan_at(&work, loads + high)), (*cspan_at(&work_t, loads + high)), start, start_t, stop, stop_t);
    moment_t = v2_t;
    moment = v2;
    tangent_patches__root_integral_t(&v3, &v3_t, (*cspan_at(&work, squares + before)), (*cspan_at(&work_t, squares + before)), (*cspan_at(&work, squares + low)), (*cspan_at(&work_t, squares + low)), (*cspan_at(&work, squares + high)), (*cspan_at(&work_t, squares + high)), start, start_t, stop, stop_t);
    area_t = v3_t;
    area = v3;
    v4 = width * step;
    moment_t = inner_t * load + inner * load_t + ((width_t * step + width * step_t) * moment + v4 * moment_t);
    moment = inner * load + v4 * moment;
    (*cspan_at(&work_t, layout__WORK_REGIONS + layout__REGION_SIZE * region + layout__REGION_CARRIED)) = (*cspan_at(&work_t, layout__WORK_REGIONS + layout__REGION_SIZE * region + layout__REGION_CARRIED)) + load_t;
    (*cspan_at(&work, layout__WORK_REGIONS + layout__REGION_SIZE * region + layout__REGION_CARRIED)) = (*cspan_at(&work, layout__WORK_REGIONS + layout__REGION_SIZE * region + layout__REGION_CARRIED)) + load;
    (*cspan_at(&work_t, layout__WORK_REGIONS + layout__REGION_SIZE * region + layout__REGION_MOMENT)) = (*cspan_at(&work_t, layout__WORK_REGIONS + layout__REGION_SIZE * region + layout__REGION_MOMENT)) + moment_t;
    (*cspan_at(&work, layout__WORK_REGIONS + layout__REGION_SIZE * region + layout__REGION_MOMENT)) = (*cspan_at(&work, layout__WORK_REGIONS + layout__REGION_SIZE * region + layout__REGION_MOMENT)) + moment;
    (*cspan_at(&work_t, at + patches__ISLAND_LOAD)) = (*cspan_at(&work_t, at + patches__ISLAND_LOAD)) + load_t;
    (*cspan_at(&work, at + patches__ISLAND_LOAD)) = (*cspan_at(&work, at + patches__ISLAND_LOAD)) + load;
    (*cspan_at(&work_t, at + patches__ISLAND_MOMENT)) = (*cspan_at(&work_t, at + patches__ISLAND_MOMENT)) + moment_t;
    (*cspan_at(&work, at + patches__ISLAND_MOMENT)) = (*cspan_at(&work, at + patches__ISLAND_MOMENT)) + moment;
    v5 = 2.0 * width;
    (*cspan_at(&work_t, at + patches__ISLAND_AREA)) = (*cspan_at(&work_t, at + patches__ISLAND_AREA)) + (2.0 * width_t * area + v5 * area_t);
    (*cspan_at(&work, at + patches__ISLAND_AREA)) = (*cspan_at(&work, at + patches__ISLAND_AREA)) + v5 * area;
    if ((*cspan_at(&work, squares + low)) > (*cspan_at(&work, at + patches__ISLAND_HALF_LENGTH)))
    {
        tangent_patches__peak_square_t(&v6, &v6_t, work, work_t, squares, low);
        (*cspan_at(&work_t, at + patches__ISLAND_HALF_LENGTH)) = v6_t;
        (*cspan_at(&work, at + patches__ISLAND_HALF_LENGTH)) = v6;
    }
    if ((*cspan_at(&work, pressures + low)) > (*cspan_at(&work, at + patches__ISLAND_PRESSURE)))
    {
        tangent_patches__peak_square_t(&v7, &v7_t, work, work_t, pressures, low);
        (*cspan_at(&work_t, at + patches__ISLAND_PRESSURE)) = v7_t;
        (*cspan_at(&work, at + patches__ISLAND_PRESSURE)) = v7;
    }
    return INT64_C(0);
}

/* Tangent of ``write_patches``. */
static inline int64_t tangent_patches__write_patches_t(array_double_1d work, array_double_1d work_t, int64_t side, int64_t islands)
{
    double load_t;
    double load;
    double area_t;
    double area;
    double moment_t;
    double moment;
    double pressure_t;
    double pressure;
    double half_t;
    double half;
    int64_t i;
    int64_t at;
    double v1;
    double v2;
    int64_t last;
    double v3;
    int64_t rank;
    int64_t heaviest;
    load_t = 0.0;
    load = 0.0;
    area_t = 0.0;
    area = 0.0;
    moment_t = 0.0;
    moment = 0.0;
    pressure_t = 0.0;
    pressure = 0.0;
    half_t = 0.0;
    half = 0.0;
    for (i = INT64_C(0); i < islands; i += INT64_C(1))
    {
        at = layout__WORK_ISLANDS + patches__ISLAND_SIZE * i;
        load_t = load_t + (*cspan_at(&work_t, at + patches__ISLAND_LOAD));
        load = load + (*cspan_at(&work, at + patches__ISLAND_LOAD));
        area_t = area_t + (*cspan_at(&work_t, at + patches__ISLAND_AREA));
        area = area + (*cspan_at(&work, at + patches__ISLAND_AREA));
        moment_t = moment_t + (*cspan_at(&work_t, at + patches__ISLAND_MOMENT));
        moment = moment + (*cspan_at(&work, at + patches__ISLAND_MOMENT));
        if ((*cspan_at(&work, at + patches__ISLAND_PRESSURE)) > pressure)
        {
            pressure_t = (*cspan_at(&work_t, at + patches__ISLAND_PRESSURE));
            pressure = (*cspan_at(&work, at + patches__ISLAND_PRESSURE));
        }
        if ((*cspan_at(&work, at + patches__ISLAND_HALF_LENGTH)) > half)
        {
            half_t = (*cspan_at(&work_t, at + patches__ISLAND_HALF_LENGTH));
            half = (*cspan_at(&work, at + patches__ISLAND_HALF_LENGTH));
        }
    }
    (*cspan_at(&work_t, side + layout__SIDE_OUTPUTS_PATCH_COUNT)) = 0.0;
    (*cspan_at(&work, side + layout__SIDE_OUTPUTS_PATCH_COUNT)) = (double)(islands);
    (*cspan_at(&work_t, side + layout__SIDE_OUTPUTS_NORMAL_FORCE)) = load_t;
    (*cspan_at(&work, side + layout__SIDE_OUTPUTS_NORMAL_FORCE)) = load;
    (*cspan_at(&work_t, side + layout__SIDE_OUTPUTS_AREA)) = area_t;
    (*cspan_at(&work, side + layout__SIDE_OUTPUTS_AREA)) = area;
    v1 = sqrt(pressure);
    (*cspan_at(&work_t, side + layout__SIDE_OUTPUTS_MAX_PRESSURE)) = tangent_rates__root_rate(v1, pressure_t);
    (*cspan_at(&work, side + layout__SIDE_OUTPUTS_MAX_PRESSURE)) = v1;
    v2 = sqrt(half);
    (*cspan_at(&work_t, side + layout__SIDE_OUTPUTS_PATCH_LENGTH)) = 2.0 * tangent_rates__root_rate(v2, half_t);
    (*cspan_at(&work, side + layout__SIDE_OUTPUTS_PATCH_LENGTH)) = 2.0 * v2;
    if (islands > INT64_C(0))
    {
        last = layout__WORK_ISLANDS + patches__ISLAND_SIZE * (islands - INT64_C(1));
        (*cspan_at(&work_t, side + layout__SIDE_OUTPUTS_PATCH_WIDTH)) = (*cspan_at(&work_t, last + patches__ISLAND_STOP)) - (*cspan_at(&work_t, layout__WORK_ISLANDS + patches__ISLAND_START));
        (*cspan_at(&work, side + layout__SIDE_OUTPUTS_PATCH_WIDTH)) = (*cspan_at(&work, last + patches__ISLAND_STOP)) - (*cspan_at(&work, layout__WORK_ISLANDS + patches__ISLAND_START));
        v3 = moment / load;
        (*cspan_at(&work_t, side + layout__SIDE_OUTPUTS_PATCH_CENTROID)) = (moment_t - v3 * load_t) / load;
        (*cspan_at(&work, side + layout__SIDE_OUTPUTS_PATCH_CENTROID)) = v3;
    }
    for (rank = INT64_C(0); rank < layout__PATCH_LIMIT; rank += INT64_C(1))
    {
        heaviest = -INT64_C(1);
        for (i = INT64_C(0); i < islands; i += INT64_C(1))
        {
            at = layout__WORK_ISLANDS + patches__ISLAND_SIZE * i;
            if ((*cspan_at(&work, at + patches__ISLAND_LOAD)) > 0.0)
            {
                if (heaviest < INT64_C(0))
                {
                    heaviest = at;
                }
                else if ((*cspan_at(&work, at + patches__ISLAND_LOAD)) > (*cspan_at(&work, heaviest + patches__ISLAND_LOAD)))
                {
                    heaviest = at;
                }
            }
        }
        if (heaviest >= INT64_C(0))
        {
            tangent_patches__write_patch_t(work, work_t, side + layout__SIDE_OUTPUTS_PATCH + layout__PATCH_SIZE * rank, heaviest);
            (*cspan_at(&work_t, heaviest + patches__ISLAND_LOAD)) = 0.0;
            (*cspan_at(&work, heaviest + patches__ISLAND_LOAD)) = 0.0;
        }
    }
    return INT64_C(0);
}

/* Tangent of ``write_patch``. */
static inline int64_t tangent_patches__write_patch_t(array_double_1d work, array_double_1d work_t, int64_t to, int64_t at)
{
    double v1;
    double v2;
    double v3;
    (*cspan_at(&work_t, to + layout__PATCH_NORMAL_FORCE)) = (*cspan_at(&work_t, at + patches__ISLAND_LOAD));
    (*cspan_at(&work, to + layout__PATCH_NORMAL_FORCE)) = (*cspan_at(&work, at + patches__ISLAND_LOAD));
    (*cspan_at(&work_t, to + layout__PATCH_AREA)) = (*cspan_at(&work_t, at + patches__ISLAND_AREA));
    (*cspan_at(&work, to + layout__PATCH_AREA)) = (*cspan_at(&work, at + patches__ISLAND_AREA));
    v1 = sqrt((*cspan_at(&work, at + patches__ISLAND_PRESSURE)));
    (*cspan_at(&work_t, to + layout__PATCH_MAX_PRESSURE)) = tangent_rates__root_rate(v1, (*cspan_at(&work_t, at + patches__ISLAND_PRESSURE)));
    (*cspan_at(&work, to + layout__PATCH_MAX_PRESSURE)) = v1;
    v2 = sqrt((*cspan_at(&work, at + patches__ISLAND_HALF_LENGTH)));
    (*cspan_at(&work_t, to + layout__PATCH_LENGTH)) = 2.0 * tangent_rates__root_rate(v2, (*cspan_at(&work_t, at + patches__ISLAND_HALF_LENGTH)));
    (*cspan_at(&work, to + layout__PATCH_LENGTH)) = 2.0 * v2;
    (*cspan_at(&work_t, to + layout__PATCH_WIDTH)) = (*cspan_at(&work_t, at + patches__ISLAND_STOP)) - (*cspan_at(&work_t, at + patches__ISLAND_START));
    (*cspan_at(&work, to + layout__PATCH_WIDTH)) = (*cspan_at(&work, at + patches__ISLAND_STOP)) - (*cspan_at(&work, at + patches__ISLAND_START));
    v3 = (*cspan_at(&work, at + patches__ISLAND_MOMENT)) / (*cspan_at(&work, at + patches__ISLAND_LOAD));
    (*cspan_at(&work_t, to + layout__PATCH_CENTROID)) = ((*cspan_at(&work_t, at + patches__ISLAND_MOMENT)) - v3 * (*cspan_at(&work_t, at + patches__ISLAND_LOAD))) / (*cspan_at(&work, at + patches__ISLAND_LOAD));
    (*cspan_at(&work, to + layout__PATCH_CENTROID)) = v3;
    (*cspan_at(&work_t, to + layout__PATCH_CONTACT_ANGLE)) = (*cspan_at(&work_t, at + patches__ISLAND_ANGLE));
    (*cspan_at(&work, to + layout__PATCH_CONTACT_ANGLE)) = (*cspan_at(&work, at + patches__ISLAND_ANGLE));
    return INT64_C(0);
}

/* Tangent of ``write_outline``. */
static inline int64_t tangent_patches__write_outline_t(array_double_1d work, array_double_1d work_t, int64_t side, int64_t place, int64_t stations, int64_t count, int64_t islands)
{
    double start_t;
    double start;
    double stop_t;
    double stop;
    int64_t j;
    double v1;
    double v2;
    double v3;
    double v4;
    double station_t;
    double station;
    double half_t;
    double half;
    double pressure_t;
    double pressure;
    int64_t region;
    int64_t block;
    double own_t;
    double own;
    if (islands > INT64_C(0))
    {
        start_t = (*cspan_at(&work_t, layout__WORK_ISLANDS + patches__ISLAND_START));
        start = (*cspan_at(&work, layout__WORK_ISLANDS + patches__ISLAND_START));
        stop_t = (*cspan_at(&work_t, layout__WORK_ISLANDS + patches__ISLAND_SIZE * (islands - INT64_C(1)) + patches__ISLAND_STOP));
        stop = (*cspan_at(&work, layout__WORK_ISLANDS + patches__ISLAND_SIZE * (islands - INT64_C(1)) + patches__ISLAND_STOP));
        for (j = INT64_C(0); j < stations; j += INT64_C(1))
        {
            v1 = stop - start;
            v2 = (double)(j);
            v3 = v1 * v2;
            v4 = (double)(stations - INT64_C(1));
            station_t = start_t + (stop_t - start_t) * v2 / v4;
            station = start + v3 / v4;
            half_t = 0.0;
            half = 0.0;
            pressure_t = 0.0;
            pressure = 0.0;
            if ((j > INT64_C(0)) && (j < stations - INT64_C(1)))
            {
                for (region = INT64_C(0); region < count; region += INT64_C(1))
                {
                    block = layout__WORK_REGIONS + layout__REGION_SIZE * region;
                    own_t = station_t - (*cspan_at(&work_t, block + layout__REGION_OFFSET));
                    own = station - (*cspan_at(&work, block + layout__REGION_OFFSET));
                    if ((own >= (*cspan_at(&work, block + layout__REGION_LOW))) && (own <= (*cspan_at(&work, block + layout__REGION_HIGH))) && (half == 0.0))
                    {
                        tangent_patches__strip_at_t(&half, &half_t, &pressure, &pressure_t, work, work_t, region, own, own_t);
                    }
                }
            }
            if (half > 0.5 * (*cspan_at(&work, side + layout__SIDE_OUTPUTS_PATCH_LENGTH)))
            {
                half_t = 0.5 * (*cspan_at(&work_t, side + layout__SIDE_OUTPUTS_PATCH_LENGTH));
                half = 0.5 * (*cspan_at(&work, side + layout__SIDE_OUTPUTS_PATCH_LENGTH));
            }
            if (pressure > (*cspan_at(&work, side + layout__SIDE_OUTPUTS_MAX_PRESSURE)))
            {
                pressure_t = (*cspan_at(&work_t, side + layout__SIDE_OUTPUTS_MAX_PRESSURE));
                pressure = (*cspan_at(&work, side + layout__SIDE_OUTPUTS_MAX_PRESSURE));
            }
            (*cspan_at(&work_t, place + j)) = station_t;
            (*cspan_at(&work, place + j)) = station;
            (*cspan_at(&work_t, place + stations + j)) = half_t;
            (*cspan_at(&work, place + stations + j)) = half;
            (*cspan_at(&work_t, place + INT64_C(2) * stations + j)) = pressure_t;
            (*cspan_at(&work, place + INT64_C(2) * stations + j)) = pressure;
        }
    }
    return INT64_C(0);
}

/* Tangent of ``strip_at``. */
static inline int64_t tangent_patches__strip_at_t(double* half, double* half_t, double* pressure, double* pressure_t, array_double_1d work, array_double_1d work_t, int64_t region, double station, double station_t)
{
    int64_t block;
    double level_t;
    double level;
    double v1;
    double v2;
    double u_t;
    double u;
    bool inside;
    int64_t outward;
    int64_t low;
    double x_t;
    double x;
    int64_t squares;
    int64_t pressures;
    double v3;
    double v3_t;
    double length_t;
    double length;
    double v4;
    double v4_t;
    double square_t;
    double square;
    double v5;
    double v6;
    block = layout__WORK_REGIONS + layout__REGION_SIZE * region;
    level_t = (*cspan_at(&work_t, block + layout__REGION_LEVEL));
    level = (*cspan_at(&work, block + layout__REGION_LEVEL));
    (*half_t) = 0.0;
    (*half) = 0.0;
    (*pressure_t) = 0.0;
    (*pressure) = 0.0;
    v1 = station - (*cspan_at(&work, block + layout__REGION_STATION));
    v2 = v1 / (*cspan_at(&work, block + layout__REGION_SPACING));
    u_t = (station_t - (*cspan_at(&work_t, block + layout__REGION_STATION)) - v2 * (*cspan_at(&work_t, block + layout__REGION_SPACING))) / (*cspan_at(&work, block + layout__REGION_SPACING));
    u = v2;
    inside = (u > (int64_t)((*cspan_at(&work, block + layout__REGION_FIRST)))) && (u < (int64_t)((*cspan_at(&work, block + layout__REGION_LAST))));
    if ((level > 0.0) && inside)
    {
        outward = INT64_C(1);
        if (u < 0.0)
        {
            outward = -INT64_C(1);
            u_t = -u_t;
            u = -u;
        }
        low = (int64_t)(u);
        x_t = u_t;
        x = u - (double)(low);
        low = outward * low;
        squares = nodes__node_field(region, nodes__NODE_SQUARE) + low;
        pressures = nodes__node_field(region, nodes__NODE_PRESSURE) + low;
        tangent_patches__quadratic_value_t(&v3, &v3_t, (*cspan_at(&work, squares - outward)), (*cspan_at(&work_t, squares - outward)), (*cspan_at(&work, squares)), (*cspan_at(&work_t, squares)), (*cspan_at(&work, squares + outward)), (*cspan_at(&work_t, squares + outward)), x, x_t);
        length_t = v3_t;
        length = v3;
        tangent_patches__quadratic_value_t(&v4, &v4_t, (*cspan_at(&work, pressures - outward)), (*cspan_at(&work_t, pressures - outward)), (*cspan_at(&work, pressures)), (*cspan_at(&work_t, pressures)), (*cspan_at(&work, pressures + outward)), (*cspan_at(&work_t, pressures + outward)), x, x_t);
        square_t = v4_t;
        square = v4;
        if ((length > 0.0) && (square > 0.0))
        {
            v5 = sqrt(length);
            (*half_t) = tangent_rates__root_rate(v5, length_t);
            (*half) = v5;
            v6 = sqrt(square);
            (*pressure_t) = tangent_rates__root_rate(v6, square_t);
            (*pressure) = v6;
        }
    }
    return 0;
}

/* Tangent of ``quadratic_value``. */
static inline int64_t tangent_patches__quadratic_value_t(double* result_0, double* result_1, double before, double before_t, double low, double low_t, double high, double high_t, double x, double x_t)
{
    double v1;
    double v1_t;
    double bend_t;
    double bend;
    double v2;
    tangent_analyn__bend_of_t(&v1, &v1_t, before, before_t, low, low_t, high, high_t);
    bend_t = v1_t;
    bend = v1;
    v2 = high - low - bend + x * bend;
    (*result_0) = low + x * v2;
    (*result_1) = low_t + (x_t * v2 + x * (high_t - low_t - bend_t + (x_t * bend + x * bend_t)));
    return 0;
}
