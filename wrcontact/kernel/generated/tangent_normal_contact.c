/* Generated from tangent_normal_contact.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of normal_contact.py.
 */

#include "tangent_normal_contact.h"

/* Tangent of ``guess_penetration``. */
static inline int64_t tangent_normal_contact__guess_penetration_t(double* v8, double* result_1, double force, double force_t, double A, double A_t, double contact_modulus, double contact_modulus_t)
{
    double v1;
    double v2;
    double share_t;
    double share;
    double v3;
    double v4;
    double v5;
    double v6;
    double v7;
    v1 = 0.75 * force;
    v2 = v1 / contact_modulus;
    share_t = (0.75 * force_t - v2 * contact_modulus_t) / contact_modulus;
    share = v2;
    v3 = share * share;
    v4 = 1.0 + normal_contact__TYPICAL_RATIO;
    v5 = v3 * v4;
    v6 = v5 * A;
    v7 = 1.0 / 3.0;
    (*v8) = pow(v6, v7);
    (*result_1) = tangent_rates__power_rate((*v8), v6, v7, (share_t * share + share * share_t) * v4 * A + v5 * A_t);
    return 0;
}

/* Tangent of ``measure_widths``. */
static inline int64_t tangent_normal_contact__measure_widths_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, array_double_1d state, int64_t region, double level, double level_t)
{
    int64_t block;
    double bend_t;
    double bend;
    double v1;
    double v2;
    double v3;
    double low_t;
    double low;
    double high_t;
    double high;
    double v4;
    double v5;
    double grown_t;
    double grown;
    double v6;
    double v6_t;
    double high_reached_t;
    double high_reached;
    double slant_t;
    double slant;
    double start_t;
    double start;
    int64_t yawed;
    double v7;
    double v7_t;
    double v8;
    double v8_t;
    double v9;
    double v9_t;
    double v10;
    double v11;
    double v13;
    double v12;
    double v12_t;
    double v15;
    double v14;
    double v14_t;
    double v16;
    block = layout__WORK_REGIONS + layout__REGION_SIZE * region;
    bend_t = (*cspan_at(&work_t, block + layout__REGION_BEND));
    bend = (*cspan_at(&work, block + layout__REGION_BEND));
    if (bend < normal_contact__LEAST_BEND * (*cspan_at(&work, block + layout__REGION_CURVATURE)))
    {
        bend_t = normal_contact__LEAST_BEND * (*cspan_at(&work_t, block + layout__REGION_CURVATURE));
        bend = normal_contact__LEAST_BEND * (*cspan_at(&work, block + layout__REGION_CURVATURE));
    }
    if (bend > normal_contact__MOST_BEND * (*cspan_at(&work, block + layout__REGION_CURVATURE)))
    {
        bend_t = normal_contact__MOST_BEND * (*cspan_at(&work_t, block + layout__REGION_CURVATURE));
        bend = normal_contact__MOST_BEND * (*cspan_at(&work, block + layout__REGION_CURVATURE));
    }
    v1 = 2.0 * level;
    v2 = v1 / bend;
    v3 = sqrt(v2);
    low_t = tangent_rates__root_rate(v3, (2.0 * level_t - v2 * bend_t) / bend);
    low = v3;
    high_t = low_t;
    high = low;
    if ((*cspan_at(&work, block + layout__REGION_WIDTH_LEVEL)) > 0.0)
    {
        v4 = level / (*cspan_at(&work, block + layout__REGION_WIDTH_LEVEL));
        v5 = sqrt(v4);
        grown_t = tangent_rates__root_rate(v5, (level_t - v4 * (*cspan_at(&work_t, block + layout__REGION_WIDTH_LEVEL))) / (*cspan_at(&work, block + layout__REGION_WIDTH_LEVEL)));
        grown = v5;
        low_t = (*cspan_at(&work_t, block + layout__REGION_WIDTH_LOW)) * grown + (*cspan_at(&work, block + layout__REGION_WIDTH_LOW)) * grown_t;
        low = (*cspan_at(&work, block + layout__REGION_WIDTH_LOW)) * grown;
        high_t = (*cspan_at(&work_t, block + layout__REGION_WIDTH_HIGH)) * grown + (*cspan_at(&work, block + layout__REGION_WIDTH_HIGH)) * grown_t;
        high = (*cspan_at(&work, block + layout__REGION_WIDTH_HIGH)) * grown;
    }
    tangent_regions__width_rule_t(&v6, &v6_t, tables, work, work_t, state, block, 1.0, 0.0, level, level_t, high, high_t);
    high_t = v6_t;
    high = v6;
    high_reached_t = (*cspan_at(&work_t, block + layout__REGION_REACHED));
    high_reached = (*cspan_at(&work, block + layout__REGION_REACHED));
    slant_t = 0.0;
    slant = 0.0;
    start_t = (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_TRACER_STATION));
    start = (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_STATION));
    yawed = contact_plane__is_yawed(work);
    if (yawed == INT64_C(1))
    {
        tangent_contact_plane__ridge_place_t(&v7, &v7_t, tables, work, work_t, (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_WHEEL)), (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_TRACER_WHEEL)));
        slant_t = v7_t;
        slant = v7;
    }
    if (!((*cspan_at(&work, block + layout__REGION_WIDTH_LEVEL)) > 0.0))
    {
        low_t = high_t;
        low = high;
    }
    tangent_regions__width_rule_t(&v8, &v8_t, tables, work, work_t, state, block, -1.0, 0.0, level, level_t, low, low_t);
    low_t = v8_t;
    low = v8;
    if (yawed == INT64_C(1))
    {
        tangent_contact_plane__ridge_place_t(&v9, &v9_t, tables, work, work_t, (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_WHEEL)), (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_TRACER_WHEEL)));
        slant_t = slant_t - v9_t;
        slant = slant - v9;
        if (start > (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_STATION)))
        {
            v10 = start - (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_STATION));
            v11 = slant / v10;
            (*cspan_at(&work_t, block + layout__REGION_SLANT)) = (slant_t - v11 * (start_t - (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_TRACER_STATION)))) / v10;
            (*cspan_at(&work, block + layout__REGION_SLANT)) = v11;
        }
    }
    v13 = low + high;
    tangent_normal_contact__side_curvature_t(&v12, &v12_t, high_reached, high_reached_t, high, high_t, 0.5 * v13, 0.5 * (low_t + high_t));
    (*cspan_at(&work_t, block + layout__REGION_SIDE_HIGH)) = v12_t;
    (*cspan_at(&work, block + layout__REGION_SIDE_HIGH)) = v12;
    v15 = low + high;
    tangent_normal_contact__side_curvature_t(&v14, &v14_t, (*cspan_at(&work, block + layout__REGION_REACHED)), (*cspan_at(&work_t, block + layout__REGION_REACHED)), low, low_t, 0.5 * v15, 0.5 * (low_t + high_t));
    (*cspan_at(&work_t, block + layout__REGION_SIDE_LOW)) = v14_t;
    (*cspan_at(&work, block + layout__REGION_SIDE_LOW)) = v14;
    (*cspan_at(&work_t, block + layout__REGION_WIDTH_HIGH)) = high_t;
    (*cspan_at(&work, block + layout__REGION_WIDTH_HIGH)) = high;
    (*cspan_at(&work_t, block + layout__REGION_WIDTH_LOW)) = low_t;
    (*cspan_at(&work, block + layout__REGION_WIDTH_LOW)) = low;
    (*cspan_at(&work_t, block + layout__REGION_WIDTH_LEVEL)) = level_t;
    (*cspan_at(&work, block + layout__REGION_WIDTH_LEVEL)) = level;
    v16 = high - low;
    (*cspan_at(&work_t, block + layout__REGION_MIDDLE)) = (*cspan_at(&work_t, block + layout__REGION_STATION)) + 0.5 * (high_t - low_t);
    (*cspan_at(&work, block + layout__REGION_MIDDLE)) = (*cspan_at(&work, block + layout__REGION_STATION)) + 0.5 * v16;
    return INT64_C(0);
}

/* Tangent of ``side_curvature``. */
static inline int64_t tangent_normal_contact__side_curvature_t(double* curvature, double* curvature_t, double reached, double reached_t, double own, double own_t, double mean, double mean_t)
{
    double v1;
    double ratio_t;
    double ratio;
    double v2;
    double v3;
    double v4;
    (*curvature_t) = 0.0;
    (*curvature) = 0.0;
    if (own > 0.0)
    {
        v1 = mean / own;
        ratio_t = (mean_t - v1 * own_t) / own;
        ratio = v1;
        if (ratio > normal_contact__NARROWER)
        {
            ratio_t = 0.0;
            ratio = normal_contact__NARROWER;
        }
        v2 = own * own;
        v3 = reached / v2;
        v4 = v3 * ratio;
        (*curvature_t) = ((reached_t - v3 * (own_t * own + own * own_t)) / v2 * ratio + v3 * ratio_t) * ratio + v4 * ratio_t;
        (*curvature) = v4 * ratio;
    }
    return 0;
}

/* Tangent of ``zone_share``. */
static inline int64_t tangent_normal_contact__zone_share_t(double* share, double* share_t, array_double_1d tables, double A, double A_t, double side, double side_t)
{
    double spread;
    double v2;
    double v1;
    double v1_t;
    double v3;
    if (side < nodes__FLOOR * A)
    {
        side_t = nodes__FLOOR * A_t;
        side = nodes__FLOOR * A;
    }
    spread = normal_contact__SPREAD;
    if ((int64_t)((*cspan_at(&tables, layout__TABLES_NORMAL_MODEL))) == layout__MODEL_ANALYN_STRIP)
    {
        spread = normal_contact__STRIP_SPREAD;
    }
    v2 = A / side;
    tangent_hertz__table_value_t(&v1, &v1_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_HERTZ))), INT64_C(0), log(v2), (A_t - v2 * side_t) / side / v2);
    v3 = spread / v1;
    (*share_t) = (-v3) * v1_t / v1;
    (*share) = v3;
    if (((*share) > normal_contact__COVER) || ((int64_t)((*cspan_at(&tables, layout__TABLES_LATERAL))) != layout__LATERAL_ADAPTIVE))
    {
        (*share_t) = 0.0;
        (*share) = normal_contact__COVER;
    }
    return 0;
}

/* Tangent of ``prepare_regions``. */
static inline int64_t tangent_normal_contact__prepare_regions_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, array_double_1d state, int64_t count, double enlarge, double enlarge_t)
{
    int64_t window;
    int64_t stride;
    int64_t i;
    int64_t block;
    double level_t;
    double level;
    double v1;
    double mean_t;
    double mean;
    double widest_t;
    double widest;
    double v2;
    double v3;
    double least_t;
    double least;
    double spacing_t;
    double spacing;
    double v4;
    double A_t;
    double A;
    double v5;
    double v6;
    double v6_t;
    double low_reach_t;
    double low_reach;
    double v7;
    double v8;
    double v8_t;
    double high_reach_t;
    double high_reach;
    double v9;
    double v10;
    int64_t k11;
    double v12;
    window = (int64_t)((*cspan_at(&tables, layout__TABLES_NODES)) * normal_contact__WINDOW + 0.5);
    stride = normal_contact__node_stride(tables);
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        block = layout__WORK_REGIONS + layout__REGION_SIZE * i;
        level_t = (*cspan_at(&work_t, block + layout__REGION_LEVEL));
        level = (*cspan_at(&work, block + layout__REGION_LEVEL));
        tangent_planes__enter_plane_t(work, work_t, i);
        tangent_normal_contact__measure_widths_t(tables, work, work_t, state, i, normal_contact__MEASURED * level, normal_contact__MEASURED * level_t);
        v1 = (*cspan_at(&work, block + layout__REGION_WIDTH_LOW)) + (*cspan_at(&work, block + layout__REGION_WIDTH_HIGH));
        mean_t = 0.5 * ((*cspan_at(&work_t, block + layout__REGION_WIDTH_LOW)) + (*cspan_at(&work_t, block + layout__REGION_WIDTH_HIGH)));
        mean = 0.5 * v1;
        widest_t = (*cspan_at(&work_t, block + layout__REGION_WIDTH_LOW));
        widest = (*cspan_at(&work, block + layout__REGION_WIDTH_LOW));
        if ((*cspan_at(&work, block + layout__REGION_WIDTH_HIGH)) > widest)
        {
            widest_t = (*cspan_at(&work_t, block + layout__REGION_WIDTH_HIGH));
            widest = (*cspan_at(&work, block + layout__REGION_WIDTH_HIGH));
        }
        v2 = level / (*cspan_at(&work, block + layout__REGION_CURVATURE));
        v3 = sqrt(v2);
        least_t = normal_contact__NARROWEST * tangent_rates__root_rate(v3, (level_t - v2 * (*cspan_at(&work_t, block + layout__REGION_CURVATURE))) / (*cspan_at(&work, block + layout__REGION_CURVATURE)));
        least = normal_contact__NARROWEST * v3;
        if (mean < least)
        {
            mean_t = least_t;
            mean = least;
        }
        spacing_t = mean_t / (*cspan_at(&tables, layout__TABLES_NODES));
        spacing = mean / (*cspan_at(&tables, layout__TABLES_NODES));
        if (widest * enlarge > normal_contact__WIDEST * spacing)
        {
            v4 = widest * enlarge;
            spacing_t = (widest_t * enlarge + widest * enlarge_t) / normal_contact__WIDEST;
            spacing = v4 / normal_contact__WIDEST;
        }
        A_t = 0.5 * (*cspan_at(&work_t, block + layout__REGION_CURVATURE));
        A = 0.5 * (*cspan_at(&work, block + layout__REGION_CURVATURE));
        v5 = level * enlarge;
        tangent_normal_contact__zone_share_t(&v6, &v6_t, tables, A, A_t, (*cspan_at(&work, block + layout__REGION_SIDE_LOW)), (*cspan_at(&work_t, block + layout__REGION_SIDE_LOW)));
        low_reach_t = (level_t * enlarge + level * enlarge_t) * v6 + v5 * v6_t;
        low_reach = v5 * v6;
        v7 = level * enlarge;
        tangent_normal_contact__zone_share_t(&v8, &v8_t, tables, A, A_t, (*cspan_at(&work, block + layout__REGION_SIDE_HIGH)), (*cspan_at(&work_t, block + layout__REGION_SIDE_HIGH)));
        high_reach_t = (level_t * enlarge + level * enlarge_t) * v8 + v7 * v8_t;
        high_reach = v7 * v8;
        if (((*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_PRESSED)) == 1.0) && (contact_plane__is_yawed(work) == INT64_C(1)))
        {
            v9 = (double)(stride);
            v10 = spacing * v9;
            (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_BLUR)) = spacing_t * v9 * (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_WHEEL_COS)) + v10 * (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_WHEEL_COS));
            (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_BLUR)) = v10 * (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_WHEEL_COS));
        }
        tangent_nodes__lay_nodes_t(tables, work, work_t, state, i, low_reach, low_reach_t, high_reach, high_reach_t, spacing, spacing_t, window, stride);
        tangent_nodes__weigh_nodes_t(tables, work, work_t, i, window);
        if (((*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_PRESSED)) == 1.0) || ((int64_t)((*cspan_at(&tables, layout__TABLES_LOAD))) == layout__LOAD_VERTICAL))
        {
            tangent_normal_contact__mean_normal_t(tables, work, work_t, i, level, level_t);
        }
        tangent_planes__leave_plane_t(work, work_t, i);
        k11 = nodes__node_field(i, nodes__NODE_LENGTH);
        v12 = level / (*cspan_at(&work, k11));
        (*cspan_at(&work_t, block + layout__REGION_SQUARE)) = (level_t - v12 * (*cspan_at(&work_t, k11))) / (*cspan_at(&work, k11));
        (*cspan_at(&work, block + layout__REGION_SQUARE)) = v12;
    }
    return INT64_C(0);
}

/* Tangent of ``rail_per_station``. */
static inline int64_t tangent_normal_contact__rail_per_station_t(double* v3, double* result_1, array_double_1d tables, array_double_1d work, array_double_1d work_t, double abscissa, double abscissa_t)
{
    double height;
    double height_t;
    double slope;
    double slope_t;
    double v1;
    double v2;
    double along_t;
    double along;
    tangent_profile_table__height_slope_t(&height, &height_t, &slope, &slope_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), abscissa, abscissa_t);
    v1 = 1.0 + slope * slope;
    v2 = sqrt(v1);
    along_t = tangent_rates__root_rate(v2, slope_t * slope + slope * slope_t);
    along = v2;
    if (!((*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_PRESSED)) == 1.0))
    {
        along_t = (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_COS)) + (slope_t * (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_SIN)) + slope * (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_SIN)));
        along = (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_COS)) + slope * (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_SIN));
    }
    (*v3) = 1.0 / along;
    (*result_1) = (-(*v3)) * along_t / along;
    return 0;
}

/* Tangent of ``mean_normal``. */
static inline int64_t tangent_normal_contact__mean_normal_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t region, double level, double level_t)
{
    int64_t block;
    int64_t rises;
    int64_t lines;
    double total_t;
    double total;
    double cosines_t;
    double cosines;
    double sines_t;
    double sines;
    int64_t direction;
    double x_t;
    double x;
    double v1;
    double step_t;
    double step;
    int64_t last;
    int64_t k;
    double height;
    double height_t;
    double slope;
    double slope_t;
    double v2;
    double v3;
    double v4;
    double cosine_t;
    double cosine;
    double v5;
    double weight_t;
    double weight;
    double v6;
    double v8;
    double v9;
    double v9_t;
    double v7;
    double v7_t;
    double v10;
    double v11;
    block = layout__WORK_REGIONS + layout__REGION_SIZE * region;
    rises = nodes__node_field(region, nodes__NODE_RISE);
    lines = nodes__node_field(region, nodes__NODE_LINE);
    total_t = 0.0;
    total = 0.0;
    cosines_t = 0.0;
    cosines = 0.0;
    sines_t = 0.0;
    sines = 0.0;
    for (direction = -INT64_C(1); direction < INT64_C(2); direction += INT64_C(2))
    {
        x_t = (*cspan_at(&work_t, block + layout__REGION_RAIL));
        x = (*cspan_at(&work, block + layout__REGION_RAIL));
        v1 = (double)(direction);
        step_t = v1 * (*cspan_at(&work_t, block + layout__REGION_SPACING));
        step = v1 * (*cspan_at(&work, block + layout__REGION_SPACING));
        last = (int64_t)((*cspan_at(&work, block + layout__REGION_LAST)));
        if (direction < INT64_C(0))
        {
            last = -(int64_t)((*cspan_at(&work, block + layout__REGION_FIRST)));
        }
        for (k = INT64_C(0); k < last + INT64_C(1); k += INT64_C(1))
        {
            tangent_profile_table__height_slope_t(&height, &height_t, &slope, &slope_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), x, x_t);
            v2 = 1.0 + slope * slope;
            v3 = sqrt(v2);
            v4 = 1.0 / v3;
            cosine_t = (-v4) * tangent_rates__root_rate(v3, slope_t * slope + slope * slope_t) / v3;
            cosine = v4;
            v5 = level - (*cspan_at(&work, rises + direction * k));
            weight_t = (*cspan_at(&work_t, lines + direction * k)) * v5 + (*cspan_at(&work, lines + direction * k)) * (level_t - (*cspan_at(&work_t, rises + direction * k)));
            weight = (*cspan_at(&work, lines + direction * k)) * v5;
            if (weight <= 0.0)
            {
                break;
            }
            if (k == INT64_C(0))
            {
                weight_t = weight_t * 0.5;
                weight = weight * 0.5;
            }
            total_t = total_t + weight_t;
            total = total + weight;
            cosines_t = cosines_t + (weight_t * cosine + weight * cosine_t);
            cosines = cosines + weight * cosine;
            v6 = weight * slope;
            sines_t = sines_t + ((weight_t * slope + weight * slope_t) * cosine + v6 * cosine_t);
            sines = sines + v6 * cosine;
            v8 = 0.5 * step;
            tangent_normal_contact__rail_per_station_t(&v9, &v9_t, tables, work, work_t, x, x_t);
            tangent_normal_contact__rail_per_station_t(&v7, &v7_t, tables, work, work_t, x + v8 * v9, x_t + (0.5 * step_t * v9 + v8 * v9_t));
            x_t = x_t + (step_t * v7 + step * v7_t);
            x = x + step * v7;
        }
    }
    if (total > 0.0)
    {
        v10 = cosines / total;
        (*cspan_at(&work_t, block + layout__REGION_COS)) = (cosines_t - v10 * total_t) / total;
        (*cspan_at(&work, block + layout__REGION_COS)) = v10;
        v11 = sines / total;
        (*cspan_at(&work_t, block + layout__REGION_SIN)) = (sines_t - v11 * total_t) / total;
        (*cspan_at(&work, block + layout__REGION_SIN)) = v11;
        if ((int64_t)((*cspan_at(&tables, layout__TABLES_LOAD))) == layout__LOAD_VERTICAL)
        {
            (*cspan_at(&work_t, block + layout__REGION_SHARE)) = (*cspan_at(&work_t, block + layout__REGION_COS));
            (*cspan_at(&work, block + layout__REGION_SHARE)) = (*cspan_at(&work, block + layout__REGION_COS));
        }
    }
    return INT64_C(0);
}

/* Tangent of ``start_levels``. */
static inline int64_t tangent_normal_contact__start_levels_t(array_double_1d work, array_double_1d work_t, int64_t count, double penetration, double penetration_t)
{
    int64_t i;
    int64_t block;
    double level_t;
    double level;
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        block = layout__WORK_REGIONS + layout__REGION_SIZE * i;
        level_t = (*cspan_at(&work_t, block + layout__REGION_TURN)) * penetration + (*cspan_at(&work, block + layout__REGION_TURN)) * penetration_t - (*cspan_at(&work_t, block + layout__REGION_GAP));
        level = (*cspan_at(&work, block + layout__REGION_TURN)) * penetration - (*cspan_at(&work, block + layout__REGION_GAP));
        if (level < 0.1 * penetration)
        {
            level_t = 0.1 * penetration_t;
            level = 0.1 * penetration;
        }
        (*cspan_at(&work_t, block + layout__REGION_LEVEL)) = level_t;
        (*cspan_at(&work, block + layout__REGION_LEVEL)) = level;
    }
    return INT64_C(0);
}

/* Tangent of ``estimate_penetration``. */
static inline int64_t tangent_normal_contact__estimate_penetration_t(double* v8, double* result_1, array_double_1d tables, array_double_1d work, array_double_1d work_t, array_double_1d state, double force, double force_t)
{
    double A_t;
    double A;
    double v1;
    double v1_t;
    double guess_t;
    double guess;
    double v2;
    double width_t;
    double width;
    double B_t;
    double B;
    double v3;
    double v4;
    double v5;
    double v5_t;
    double stiffness_t;
    double stiffness;
    double v6;
    double v7;
    A_t = 0.5 * (*cspan_at(&work_t, layout__WORK_REGIONS + layout__REGION_CURVATURE));
    A = 0.5 * (*cspan_at(&work, layout__WORK_REGIONS + layout__REGION_CURVATURE));
    tangent_normal_contact__guess_penetration_t(&v1, &v1_t, force, force_t, A, A_t, (*cspan_at(&tables, layout__TABLES_CONTACT_MODULUS)), 0.0);
    guess_t = v1_t;
    guess = v1;
    tangent_normal_contact__measure_widths_t(tables, work, work_t, state, INT64_C(0), guess, guess_t);
    v2 = (*cspan_at(&work, layout__WORK_REGIONS + layout__REGION_WIDTH_LOW)) + (*cspan_at(&work, layout__WORK_REGIONS + layout__REGION_WIDTH_HIGH));
    width_t = 0.5 * ((*cspan_at(&work_t, layout__WORK_REGIONS + layout__REGION_WIDTH_LOW)) + (*cspan_at(&work_t, layout__WORK_REGIONS + layout__REGION_WIDTH_HIGH)));
    width = 0.5 * v2;
    B_t = nodes__FLOOR * A_t;
    B = nodes__FLOOR * A;
    if (guess > normal_contact__CEILING * A * width * width)
    {
        B_t = normal_contact__CEILING * A_t;
        B = normal_contact__CEILING * A;
    }
    else if (guess > B * width * width)
    {
        v3 = width * width;
        v4 = guess / v3;
        B_t = (guess_t - v4 * (width_t * width + width * width_t)) / v3;
        B = v4;
    }
    tangent_hertz__hertz_stiffness_t(&v5, &v5_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_HERTZ))), A, A_t, B, B_t, (*cspan_at(&tables, layout__TABLES_CONTACT_MODULUS)), 0.0);
    stiffness_t = v5_t;
    stiffness = v5;
    v6 = force / stiffness;
    v7 = 2.0 / 3.0;
    (*v8) = pow(v6, v7);
    (*result_1) = tangent_rates__power_rate((*v8), v6, v7, (force_t - v6 * stiffness_t) / stiffness);
    return 0;
}

/* Tangent of ``gather_regions``. */
static inline int64_t tangent_normal_contact__gather_regions_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, array_double_1d state, int64_t side, double penetration, double penetration_t)
{
    int64_t i;
    int64_t n1;
    int64_t n2;
    int64_t n3;
    int64_t count;
    for (i = INT64_C(0); i < layout__REGION_LIMIT; i += INT64_C(1))
    {
        (*cspan_at(&work_t, layout__WORK_REGIONS + layout__REGION_SIZE * i + layout__REGION_WIDTH_LEVEL)) = 0.0;
        (*cspan_at(&work, layout__WORK_REGIONS + layout__REGION_SIZE * i + layout__REGION_WIDTH_LEVEL)) = 0.0;
        (*cspan_at(&work_t, layout__WORK_REGIONS + layout__REGION_SIZE * i + layout__REGION_SLANT)) = 0.0;
        (*cspan_at(&work, layout__WORK_REGIONS + layout__REGION_SIZE * i + layout__REGION_SLANT)) = 0.0;
    }
    count = INT64_C(1);
    if ((*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_PRESSED)) == 1.0)
    {
        n1 = tangent_overlaps__gather_overlaps_t(tables, work, work_t, state);
        count = n1;
    }
    else
    {
        tangent_regions__open_contact_region_t(tables, work, work_t, state);
        n2 = tangent_regions__find_regions_t(tables, work, work_t, state, side, penetration, penetration_t);
        count = n2;
        n3 = tangent_regions__bound_regions_t(tables, work, work_t, state, count, penetration, penetration_t);
        count = n3;
        tangent_planes__give_planes_t(tables, work, work_t, state, count);
    }
    tangent_normal_contact__start_levels_t(work, work_t, count, penetration, penetration_t);
    return count;
}

/* Tangent of ``first_penetration``. */
static inline int64_t tangent_normal_contact__first_penetration_t(double* v1, double* v1_t, array_double_1d tables, array_double_1d work, array_double_1d work_t, array_double_1d state, double force, double force_t)
{
    double v2;
    tangent_regions__open_contact_region_t(tables, work, work_t, state);
    (*cspan_at(&work_t, layout__WORK_REGIONS + layout__REGION_WIDTH_LEVEL)) = 0.0;
    (*cspan_at(&work, layout__WORK_REGIONS + layout__REGION_WIDTH_LEVEL)) = 0.0;
    v2 = force / (*cspan_at(&work, layout__WORK_REGIONS + layout__REGION_SHARE));
    tangent_normal_contact__estimate_penetration_t(v1, v1_t, tables, work, work_t, state, v2, (force_t - v2 * (*cspan_at(&work_t, layout__WORK_REGIONS + layout__REGION_SHARE))) / (*cspan_at(&work, layout__WORK_REGIONS + layout__REGION_SHARE)));
    return 0;
}

/* Tangent of ``solve_estimated``. */
static inline int64_t tangent_normal_contact__solve_estimated_t(double* penetration, double* penetration_t, int64_t* count, int64_t* met, array_double_1d tables, array_double_1d work, array_double_1d work_t, array_double_1d state, int64_t side, double force, double force_t, double estimate, double estimate_t, int64_t by_penetration)
{
    int64_t n1;
    n1 = tangent_normal_contact__gather_regions_t(tables, work, work_t, state, side, estimate, estimate_t);
    (*count) = n1;
    tangent_normal_contact__solve_fine_t(penetration, penetration_t, met, tables, work, work_t, state, (*count), force, force_t, estimate, estimate_t, by_penetration);
    if (((*met) == INT64_C(0)) && ((*count) > INT64_C(1)))
    {
        (*count) = INT64_C(1);
        if ((*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_PRESSED)) == 1.0)
        {
            tangent_overlaps__keep_deepest_t(work, work_t);
            tangent_overlaps__gather_overlaps_t(tables, work, work_t, state);
        }
        else
        {
            tangent_regions__open_contact_region_t(tables, work, work_t, state);
        }
        tangent_normal_contact__start_levels_t(work, work_t, (*count), estimate, estimate_t);
        tangent_normal_contact__solve_fine_t(penetration, penetration_t, met, tables, work, work_t, state, (*count), force, force_t, estimate, estimate_t, by_penetration);
    }
    return 0;
}

/* Tangent of ``solve_analyn``. */
static inline int64_t tangent_normal_contact__solve_analyn_t(double* penetration, double* penetration_t, int64_t* count, int64_t* met, array_double_1d tables, array_double_1d work, array_double_1d work_t, array_double_1d state, int64_t side, double force, double force_t, double prescribed, double prescribed_t)
{
    int64_t by_penetration;
    double v1;
    double v1_t;
    int64_t repeat;
    double estimate_t;
    double estimate;
    by_penetration = INT64_C(0);
    (*penetration_t) = prescribed_t;
    (*penetration) = prescribed;
    if (isfinite(prescribed))
    {
        by_penetration = INT64_C(1);
    }
    if ((*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_PRESSED)) == 1.0)
    {
        tangent_normal_contact__solve_estimated_t(penetration, penetration_t, count, met, tables, work, work_t, state, side, force, force_t, (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_DEPTH)), (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_DEPTH)), by_penetration);
        return 0;
    }
    if (by_penetration == INT64_C(0))
    {
        tangent_normal_contact__first_penetration_t(&v1, &v1_t, tables, work, work_t, state, force, force_t);
        (*penetration_t) = v1_t;
        (*penetration) = v1;
    }
    (*count) = INT64_C(1);
    (*met) = INT64_C(0);
    for (repeat = INT64_C(0); repeat < normal_contact__ESTIMATE_REPEATS; repeat += INT64_C(1))
    {
        estimate_t = (*penetration_t);
        estimate = (*penetration);
        tangent_normal_contact__solve_estimated_t(penetration, penetration_t, count, met, tables, work, work_t, state, side, force, force_t, estimate, estimate_t, by_penetration);
        if (((*penetration) < normal_contact__ESTIMATE_FACTOR * estimate) && (normal_contact__ESTIMATE_FACTOR * (*penetration) > estimate))
        {
            break;
        }
    }
    return 0;
}

/* Tangent of ``solve_fine``. */
static inline int64_t tangent_normal_contact__solve_fine_t(double* result_0_0001, double* result_1_0001, int64_t* result_2, array_double_1d tables, array_double_1d work, array_double_1d work_t, array_double_1d state, int64_t count, double force, double force_t, double penetration, double penetration_t, int64_t by_penetration)
{
    double start_t;
    double start;
    double enlarge;
    int64_t met;
    int64_t repeat;
    double laid_t;
    double laid;
    start_t = penetration_t;
    start = penetration;
    enlarge = 1.0;
    met = INT64_C(0);
    for (repeat = INT64_C(0); repeat < normal_contact__COVER_REPEATS; repeat += INT64_C(1))
    {
        tangent_normal_contact__prepare_regions_t(tables, work, work_t, state, count, enlarge, 0.0);
        tangent_analyn__levels_rule_t(&penetration, &penetration_t, &met, tables, work, work_t, state, count, force, force_t, start, start_t, by_penetration, analyn__FORCE_SHARP, 0.0);
        if (met == INT64_C(0))
        {
            (*result_0_0001) = start;
            (*result_1_0001) = start_t;
            (*result_2) = met;
            return 0;
        }
        if (normal_contact__covered(work, count) == INT64_C(1))
        {
            break;
        }
        if (repeat < normal_contact__COVER_REPEATS - INT64_C(1))
        {
            enlarge = enlarge * 1.4;
            start_t = penetration_t;
            start = penetration;
            laid_t = penetration_t;
            laid = penetration;
            if ((*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_PRESSED)) == 1.0)
            {
                laid_t = (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_DEPTH));
                laid = (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_DEPTH));
            }
            tangent_normal_contact__start_levels_t(work, work_t, count, laid, laid_t);
        }
    }
    (*result_0_0001) = penetration;
    (*result_1_0001) = penetration_t;
    (*result_2) = met;
    return 0;
}

/* Tangent of ``solve_normal``. */
static inline int64_t tangent_normal_contact__solve_normal_t(double* penetration, double* penetration_t, int64_t* count, int64_t* met, array_double_1d tables, array_double_1d work, array_double_1d work_t, array_double_1d state, int64_t side, int64_t outputs, double force, double force_t, double prescribed, double prescribed_t)
{
    double v1;
    double v1_t;
    int64_t by_penetration;
    int64_t strips;
    (*met) = INT64_C(1);
    (*count) = INT64_C(1);
    if ((int64_t)((*cspan_at(&tables, layout__TABLES_NORMAL_MODEL))) == layout__MODEL_HERTZ)
    {
        tangent_planes__line_up_t(tables, work, work_t, INT64_C(1));
        tangent_hertz_contact__solve_hertz_t(&v1, &v1_t, work, work_t, tables, outputs, layout__WORK_REGIONS, force, force_t, prescribed, prescribed_t);
        (*penetration_t) = v1_t;
        (*penetration) = v1;
        return 0;
    }
    tangent_normal_contact__solve_analyn_t(penetration, penetration_t, count, met, tables, work, work_t, state, side, force, force_t, prescribed, prescribed_t);
    if ((*met) == INT64_C(1))
    {
        tangent_planes__line_up_t(tables, work, work_t, (*count));
        if ((int64_t)((*cspan_at(&tables, layout__TABLES_NORMAL_MODEL))) == layout__MODEL_ANALYN_STRIP)
        {
            by_penetration = INT64_C(0);
            if (isfinite(prescribed))
            {
                by_penetration = INT64_C(1);
            }
            tangent_strips__correct_strips_t(penetration, penetration_t, &strips, met, tables, work, work_t, state, (*count), force, force_t, (*penetration), (*penetration_t), by_penetration);
            if ((*met) == INT64_C(1))
            {
                tangent_strip_patches__gather_strips_t(work, work_t, strips);
            }
        }
        else
        {
            tangent_node_patches__fill_from_nodes_t(work, work_t, (*count));
        }
    }
    return 0;
}
