/* Generated from tangent_arc_length.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of arc_length.py.
 */

#include "tangent_arc_length.h"

/* Tangent of ``panel_length``. */
static inline int64_t tangent_arc_length__panel_length_t(double* result_0, double* result_1, array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t curve, double low, double low_t, double high, double high_t)
{
    double v1;
    double middle_t;
    double middle;
    double v2;
    double half_t;
    double half;
    double total_t;
    double total;
    int64_t i;
    double v3;
    double side_t;
    double side;
    int64_t k;
    double away;
    double weight;
    double v4;
    double v4_t;
    v1 = low + high;
    middle_t = 0.5 * (low_t + high_t);
    middle = 0.5 * v1;
    v2 = high - low;
    half_t = 0.5 * (high_t - low_t);
    half = 0.5 * v2;
    total_t = 0.0;
    total = 0.0;
    for (i = -INT64_C(1); i < INT64_C(2); i += INT64_C(2))
    {
        v3 = (double)(i);
        side_t = half_t * v3;
        side = half * v3;
        for (k = INT64_C(0); k < INT64_C(3); k += INT64_C(1))
        {
            away = arc_length__GAUSS_1;
            weight = arc_length__WEIGHT_1;
            if (k == INT64_C(1))
            {
                away = arc_length__GAUSS_2;
                weight = arc_length__WEIGHT_2;
            }
            if (k == INT64_C(2))
            {
                away = arc_length__GAUSS_3;
                weight = arc_length__WEIGHT_3;
            }
            tangent_curves__curve_speed_t(&v4, &v4_t, work, work_t, tables, curve, middle + side * away, middle_t + side_t * away);
            total_t = total_t + weight * v4_t;
            total = total + weight * v4;
        }
    }
    (*result_0) = half * total;
    (*result_1) = half_t * total + half * total_t;
    return 0;
}

/* Tangent of ``arc_length``. */
static inline int64_t tangent_arc_length__arc_length_t(double* total, double* total_t, array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t curve, double start, double start_t, double stop, double stop_t)
{
    double low_t;
    double low;
    double high_t;
    double high;
    int64_t piece;
    double end_t;
    double end;
    double v1;
    double v1_t;
    low_t = start_t;
    low = start;
    high_t = stop_t;
    high = stop;
    if (stop < start)
    {
        low_t = stop_t;
        low = stop;
        high_t = start_t;
        high = start;
    }
    (*total_t) = 0.0;
    (*total) = 0.0;
    piece = profile_table__find_piece(tables, curves__curve_profile(tables, curve), low);
    while(low < high)
    {
        end_t = high_t;
        end = high;
        piece = piece + layout__PIECE_SIZE;
        if ((*cspan_at(&tables, piece + layout__PIECE_START)) < high)
        {
            end_t = 0.0;
            end = (*cspan_at(&tables, piece + layout__PIECE_START));
        }
        tangent_arc_length__panel_length_t(&v1, &v1_t, work, work_t, tables, curve, low, low_t, end, end_t);
        (*total_t) = (*total_t) + v1_t;
        (*total) = (*total) + v1;
        low_t = end_t;
        low = end;
    }
    if (stop < start)
    {
        (*total_t) = -(*total_t);
        (*total) = -(*total);
    }
    return 0;
}

/* Tangent of ``rail_speed``. */
static inline int64_t tangent_arc_length__rail_speed_t(double* v2, double* result_1, array_double_1d tables, double abscissa, double abscissa_t)
{
    double height;
    double height_t;
    double slope;
    double slope_t;
    double v1;
    tangent_profile_table__height_slope_t(&height, &height_t, &slope, &slope_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), abscissa, abscissa_t);
    v1 = 1.0 + slope * slope;
    (*v2) = sqrt(v1);
    (*result_1) = tangent_rates__root_rate((*v2), slope_t * slope + slope * slope_t);
    return 0;
}

/* Tangent of ``rail_length``. */
static inline int64_t tangent_arc_length__rail_length_t(double* result_0, double* result_1, array_double_1d tables, double start, double start_t, double stop, double stop_t)
{
    int64_t cells;
    double v1;
    double v2;
    double step_t;
    double step;
    double total_t;
    double total;
    double v3;
    double v3_t;
    double low_t;
    double low;
    int64_t i;
    double v4;
    double begin_t;
    double begin;
    double v5;
    double v5_t;
    double middle_t;
    double middle;
    double v6;
    double v6_t;
    double high_t;
    double high;
    double v7;
    cells = (int64_t)(fabs(stop - start) / arc_length__SIMPSON_STEP) + INT64_C(1);
    v1 = stop - start;
    v2 = (double)(cells);
    step_t = (stop_t - start_t) / v2;
    step = v1 / v2;
    total_t = 0.0;
    total = 0.0;
    tangent_arc_length__rail_speed_t(&v3, &v3_t, tables, start, start_t);
    low_t = v3_t;
    low = v3;
    for (i = INT64_C(0); i < cells; i += INT64_C(1))
    {
        v4 = (double)(i);
        begin_t = start_t + step_t * v4;
        begin = start + step * v4;
        tangent_arc_length__rail_speed_t(&v5, &v5_t, tables, begin + 0.5 * step, begin_t + 0.5 * step_t);
        middle_t = v5_t;
        middle = v5;
        tangent_arc_length__rail_speed_t(&v6, &v6_t, tables, begin + step, begin_t + step_t);
        high_t = v6_t;
        high = v6;
        total_t = total_t + (low_t + 4.0 * middle_t + high_t);
        total = total + (low + 4.0 * middle + high);
        low_t = high_t;
        low = high;
    }
    v7 = total * step;
    (*result_0) = v7 / 6.0;
    (*result_1) = (total_t * step + total * step_t) / 6.0;
    return 0;
}

/* Tangent of ``rail_abscissa``. */
static inline int64_t tangent_arc_length__rail_abscissa_t(double* x, double* x_t, array_double_1d tables, double start, double start_t, double length, double length_t)
{
    int64_t steps;
    double v1;
    double way_t;
    double way;
    int64_t step;
    double height;
    double height_t;
    double slope;
    double slope_t;
    double bend;
    double bend_t;
    double v2;
    double v3;
    double before_t;
    double before;
    double v4;
    double cosine_t;
    double cosine;
    double v5;
    double v6;
    double v7;
    double v8;
    double v9;
    double v10;
    double v11;
    double following_t;
    double following;
    int64_t i;
    double v13;
    double v12;
    double v12_t;
    double middle_t;
    double middle;
    double v14;
    double v14_t;
    double after_t;
    double after;
    double v15;
    double v16;
    double v17;
    double v18;
    double v19;
    double move_t;
    double move;
    steps = (int64_t)(fabs(length) / arc_length__SIMPSON_STEP) + INT64_C(1);
    v1 = (double)(steps);
    way_t = length_t / v1;
    way = length / v1;
    (*x_t) = start_t;
    (*x) = start;
    for (step = INT64_C(0); step < steps; step += INT64_C(1))
    {
        tangent_profile_table__height_slope_bend_t(&height, &height_t, &slope, &slope_t, &bend, &bend_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), (*x), (*x_t));
        v2 = 1.0 + slope * slope;
        v3 = sqrt(v2);
        before_t = tangent_rates__root_rate(v3, slope_t * slope + slope * slope_t);
        before = v3;
        v4 = 1.0 / before;
        cosine_t = (-v4) * before_t / before;
        cosine = v4;
        v5 = way * cosine;
        v6 = 0.5 * way;
        v7 = v6 * slope;
        v8 = v7 * bend;
        v9 = v8 * cosine;
        v10 = v9 * cosine;
        v11 = 1.0 - v10 * cosine;
        following_t = (*x_t) + ((way_t * cosine + way * cosine_t) * v11 + v5 * (-(((((0.5 * way_t * slope + v6 * slope_t) * bend + v7 * bend_t) * cosine + v8 * cosine_t) * cosine + v9 * cosine_t) * cosine + v10 * cosine_t)));
        following = (*x) + v5 * v11;
        for (i = INT64_C(0); i < arc_length__SIMPSON_ITERATIONS; i += INT64_C(1))
        {
            v13 = (*x) + following;
            tangent_arc_length__rail_speed_t(&v12, &v12_t, tables, 0.5 * v13, 0.5 * ((*x_t) + following_t));
            middle_t = v12_t;
            middle = v12;
            tangent_arc_length__rail_speed_t(&v14, &v14_t, tables, following, following_t);
            after_t = v14_t;
            after = v14;
            v15 = following - (*x);
            v16 = before + 4.0 * middle + after;
            v17 = v15 * v16;
            v18 = way - v17 / 6.0;
            v19 = v18 / after;
            move_t = (way_t - ((following_t - (*x_t)) * v16 + v15 * (before_t + 4.0 * middle_t + after_t)) / 6.0 - v19 * after_t) / after;
            move = v19;
            following_t = following_t + move_t;
            following = following + move;
            if (fabs(move) < arc_length__SIMPSON_SHARP)
            {
                break;
            }
        }
        (*x_t) = following_t;
        (*x) = following;
    }
    return 0;
}
