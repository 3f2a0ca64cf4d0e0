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

/* Tangent of ``rail_length``. */
static inline int64_t tangent_arc_length__rail_length_t(double* result_0, double* result_1, array_double_1d tables, double start, double start_t, double stop, double stop_t)
{
    double v1;
    double v1_t;
    double v2;
    double v2_t;
    tangent_cubic_table__read_cubic_t(&v1, &v1_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL_ARC))), stop, stop_t);
    tangent_cubic_table__read_cubic_t(&v2, &v2_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL_ARC))), start, start_t);
    (*result_0) = v1 - v2;
    (*result_1) = v1_t - v2_t;
    return 0;
}

/* Tangent of ``rail_abscissa``. */
static inline int64_t tangent_arc_length__rail_abscissa_t(double* x, double* x_t, array_double_1d tables, double start, double start_t, double length, double length_t)
{
    int64_t rail;
    int64_t arcs;
    int64_t abscissae;
    double v1;
    double v1_t;
    double arc_t;
    double arc;
    double v2;
    double v2_t;
    double found;
    double found_t;
    double speed;
    double speed_t;
    double v3;
    double v4;
    rail = (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL)));
    arcs = (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL_ARC)));
    abscissae = (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL_AT_ARC)));
    tangent_cubic_table__read_cubic_t(&v1, &v1_t, tables, arcs, start, start_t);
    arc_t = v1_t + length_t;
    arc = v1 + length;
    if (arc < 0.0)
    {
        (*x_t) = arc_t;
        (*x) = (*cspan_at(&tables, rail + layout__PROFILE_START)) + arc;
    }
    else if (arc * (*cspan_at(&tables, abscissae + layout__CUBIC_TABLE_CELLS_PER_UNIT)) > (*cspan_at(&tables, abscissae + layout__CUBIC_TABLE_COUNT)))
    {
        (*x_t) = arc_t;
        (*x) = (*cspan_at(&tables, rail + layout__PROFILE_STOP)) + (arc - (*cspan_at(&tables, abscissae + layout__CUBIC_TABLE_COUNT)) / (*cspan_at(&tables, abscissae + layout__CUBIC_TABLE_CELLS_PER_UNIT)));
    }
    else
    {
        tangent_cubic_table__read_cubic_t(&v2, &v2_t, tables, abscissae, arc, arc_t);
        (*x_t) = v2_t;
        (*x) = v2;
        tangent_cubic_table__read_cubic_jet_t(&found, &found_t, &speed, &speed_t, tables, arcs, (*x), (*x_t));
        v3 = arc - found;
        v4 = v3 / speed;
        (*x_t) = (*x_t) + (arc_t - found_t - v4 * speed_t) / speed;
        (*x) = (*x) + v4;
    }
    return 0;
}
