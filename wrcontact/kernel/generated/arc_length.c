/* Generated from contact/arc_length.py by tools/transpile_kernel.py; change that one.
 *
 * Arc lengths of the curves across the track, in two ways for two purposes.
 *
 * Gauss     exact to rounding, piece by piece of the profile: the arcs of the equidistant separation, which are
 *           compared on wheel and rail to 1e-13 m and must not depend on where a piece ends.
 * a table   prepared with the profiles: the stations of a pressed wheel along its rail; any coordinate is
 *           suitable for them that is smooth, the same at every use, and cheap.
 */

#include "arc_length.h"

/* Arc length [m] between abscissae within one piece of the profile, by Gauss's
 * formula with six points.
 */
static OUT_OF_LINE double arc_length__panel_length(array_double_1d work, array_double_1d tables, int64_t curve, double low, double high)
{
    double middle;
    double half;
    double total;
    int64_t i;
    double side;
    int64_t k;
    double away;
    double weight;
    middle = 0.5 * (low + high);
    half = 0.5 * (high - low);
    total = 0.0;
    for (i = -INT64_C(1); i < INT64_C(2); i += INT64_C(2))
    {
        side = half * (double)(i);
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
            total += weight * curves__curve_speed(work, tables, curve, middle + side * away);
        }
    }
    return half * total;
}

/* Arc length [m] of a curve from abscissa ``start`` to ``stop``, negative where
 * ``stop`` is the smaller one.
 *
 * Piece by piece: within one the curve has all derivatives, at the ends its curvature may jump.
 */
static OUT_OF_LINE double arc_length__arc_length(array_double_1d work, array_double_1d tables, int64_t curve, double start, double stop)
{
    double low;
    double high;
    int64_t piece;
    double end;
    double total;
    low = start;
    high = stop;
    if (stop < start)
    {
        low = stop;
        high = start;
    }
    total = 0.0;
    piece = profile_table__find_piece(tables, curves__curve_profile(tables, curve), low);
    while(low < high)
    {
        end = high;
        piece = piece + layout__PIECE_SIZE;
        if ((*cspan_at(&tables, piece + layout__PIECE_START)) < high)
        {
            end = (*cspan_at(&tables, piece + layout__PIECE_START));
        }
        total += arc_length__panel_length(work, tables, curve, low, end);
        low = end;
    }
    if (stop < start)
    {
        total = -total;
    }
    return total;
}

/* Length of the rail profile between two abscissae [m], negative where ``stop`` is the smaller one. */
static OUT_OF_LINE double arc_length__rail_length(array_double_1d tables, double start, double stop)
{
    double result;
    result = cubic_table__read_cubic(tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL_ARC))), stop) - cubic_table__read_cubic(tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL_ARC))), start);
    return result;
}

/* Abscissa [m] of the rail at ``length`` [m] of arc from ``start``; beyond an end, by what is missing.
 *
 * The table of abscissae is within 1e-8 m of the other's inverse, and a step of Newton's method on that one
 * leaves rounding.
 */
static OUT_OF_LINE double arc_length__rail_abscissa(array_double_1d tables, double start, double length)
{
    int64_t rail;
    int64_t arcs;
    int64_t abscissae;
    double arc;
    double found;
    double speed;
    double x;
    rail = (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL)));
    arcs = (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL_ARC)));
    abscissae = (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL_AT_ARC)));
    arc = cubic_table__read_cubic(tables, arcs, start) + length;
    if (arc < 0.0)
    {
        x = (*cspan_at(&tables, rail + layout__PROFILE_START)) + arc;
    }
    else if (arc * (*cspan_at(&tables, abscissae + layout__CUBIC_TABLE_CELLS_PER_UNIT)) > (*cspan_at(&tables, abscissae + layout__CUBIC_TABLE_COUNT)))
    {
        x = (*cspan_at(&tables, rail + layout__PROFILE_STOP)) + (arc - (*cspan_at(&tables, abscissae + layout__CUBIC_TABLE_COUNT)) / (*cspan_at(&tables, abscissae + layout__CUBIC_TABLE_CELLS_PER_UNIT)));
    }
    else
    {
        x = cubic_table__read_cubic(tables, abscissae, arc);
        cubic_table__read_cubic_jet(&found, &speed, tables, arcs, x);
        x += (arc - found) / speed;
    }
    return x;
}
