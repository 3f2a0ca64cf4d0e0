/* Generated from contact/arc_length.py by tools/transpile_kernel.py; change that one.
 *
 * Arc lengths of the curves across the track, in two ways for two purposes.
 *
 * Gauss     exact to rounding, piece by piece of the profile: the arcs of the equidistant separation, which are
 *           compared on wheel and rail to 1e-13 m and must not depend on where a piece ends.
 * Simpson   an evaluation for each half millimetre: the stations of a pressed wheel along its rail; any
 *           coordinate is suitable for them that is smooth, the same at every use, and cheap.
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

/* Arc length per abscissa of the rail [-]. */
static OUT_OF_LINE double arc_length__rail_speed(array_double_1d tables, double abscissa)
{
    double height;
    double slope;
    profile_table__height_slope(&height, &slope, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), abscissa);
    return sqrt(1.0 + slope * slope);
}

/* Length of the rail profile between two abscissae [m] by Simpson's rule, negative where ``stop`` is the
 * smaller one.
 */
static OUT_OF_LINE double arc_length__rail_length(array_double_1d tables, double start, double stop)
{
    int64_t cells;
    double step;
    double total;
    double low;
    int64_t i;
    double begin;
    double middle;
    double high;
    cells = (int64_t)(fabs(stop - start) / arc_length__SIMPSON_STEP) + INT64_C(1);
    step = (stop - start) / (double)(cells);
    total = 0.0;
    low = arc_length__rail_speed(tables, start);
    for (i = INT64_C(0); i < cells; i += INT64_C(1))
    {
        begin = start + step * (double)(i);
        middle = arc_length__rail_speed(tables, begin + 0.5 * step);
        high = arc_length__rail_speed(tables, begin + step);
        total += low + 4.0 * middle + high;
        low = high;
    }
    return total * step / 6.0;
}

/* Abscissa [m] of the rail at ``length`` [m] of arc from ``start``, in steps of no more than
 * SIMPSON_STEP: a parabola gives a first estimate, and Newton's method on Simpson's rule the result.
 */
static OUT_OF_LINE double arc_length__rail_abscissa(array_double_1d tables, double start, double length)
{
    int64_t steps;
    double way;
    int64_t step;
    double height;
    double slope;
    double bend;
    double before;
    double cosine;
    double following;
    int64_t i;
    double middle;
    double after;
    double move;
    double x;
    steps = (int64_t)(fabs(length) / arc_length__SIMPSON_STEP) + INT64_C(1);
    way = length / (double)(steps);
    x = start;
    for (step = INT64_C(0); step < steps; step += INT64_C(1))
    {
        profile_table__height_slope_bend(&height, &slope, &bend, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), x);
        before = sqrt(1.0 + slope * slope);
        cosine = 1.0 / before;
        following = x + way * cosine * (1.0 - 0.5 * way * slope * bend * cosine * cosine * cosine);
        for (i = INT64_C(0); i < arc_length__SIMPSON_ITERATIONS; i += INT64_C(1))
        {
            middle = arc_length__rail_speed(tables, 0.5 * (x + following));
            after = arc_length__rail_speed(tables, following);
            move = (way - (following - x) * (before + 4.0 * middle + after) / 6.0) / after;
            following += move;
            if (fabs(move) < arc_length__SIMPSON_SHARP)
            {
                break;
            }
        }
        x = following;
    }
    return x;
}
