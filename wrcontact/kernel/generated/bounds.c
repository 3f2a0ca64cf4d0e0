/* Generated from search/bounds.py by tools/transpile_kernel.py; change that one.
 *
 * How far the gap can fall: bounds of its second derivative between nodes of the raster.
 *
 * Along the wheel the slope difference rail - outline rises by no less than m = rail'' - wheel'', each but for
 * its share, and the gap changes by that slope times the outline's stretch 1 +- w. Both second derivatives are
 * bounded in the tables over stretches of 2^k cells. The shares are compared with dense sampling in
 * tests/search/test_rigid.py.
 */

#include "bounds.h"

/* Place of ``abscissa`` [m] in the raster of the rail, in cells. */
static inline double bounds__rail_place(array_double_1d tables, int64_t scan, double abscissa)
{
    double result;
    result = (abscissa - (*cspan_at(&tables, scan + layout__SCAN_RAIL_START))) * (*cspan_at(&tables, scan + layout__SCAN_RAIL_PER_METRE));
    return result;
}

/* The cell of the raster of the rail at place ``u``, or the nearest. */
static inline int64_t bounds__rail_index(array_double_1d tables, int64_t scan, double u)
{
    if (!(u > 0.0))
    {
        u = 0.0;
    }
    if (u > (int64_t)((*cspan_at(&tables, scan + layout__SCAN_RAIL_COUNT))) - 1.0)
    {
        u = (int64_t)((*cspan_at(&tables, scan + layout__SCAN_RAIL_COUNT))) - 1.0;
    }
    return (int64_t)(u);
}

/* By how much the slope difference rises at least [1/m] over the 2^exponent cells, of ``length`` [m]
 * together, that begin with node ``first``, and the share by which the outline is stretched there [-]; the
 * first is no bound where the second is not below WIDEST.
 *
 * u : place in the raster of the rail where they begin, in cells.
 */
static inline int64_t bounds__least_bend(double* bend, double* stretch, array_double_1d tables, array_double_1d work, int64_t scan, int64_t at, int64_t first, int64_t exponent, double length, double u)
{
    int64_t node;
    double roll;
    double share;
    double square;
    int64_t rail;
    double wheel;
    node = scan + layout__SCAN_NODES + layout__SCAN_NODE_SIZE * first;
    roll = fabs((*cspan_at(&work, at + layout__PLACE_SIN_ROLL)));
    (*stretch) = bounds__ROLL_STRETCH * roll;
    share = bounds__ROLL_BEND * roll;
    if ((*cspan_at(&work, at + layout__PLACE_YAWED)) == 1.0)
    {
        square = (*cspan_at(&work, at + layout__PLACE_SIN_YAW)) * (*cspan_at(&work, at + layout__PLACE_SIN_YAW));
        (*stretch) += bounds__STEEP_STRETCH * square + bounds__BEND_STRETCH * square * (*cspan_at(&work, at + layout__PLACE_RADIUS)) * (*cspan_at(&tables, node + layout__SCAN_NODE_STEEPEST_BENDS + exponent));
        share += bounds__YAW_BEND * square;
    }
    (*bend) = 0.0;
    if ((*stretch) < bounds__WIDEST)
    {
        rail = scan + (int64_t)((*cspan_at(&tables, scan + layout__SCAN_RAIL))) + layout__RAIL_CELL_SIZE * bounds__rail_index(tables, scan, u);
        (*bend) = (*cspan_at(&tables, rail + layout__RAIL_CELL_LEAST_BENDS + exponent));
        if (length > bounds__FINE_CELL * (double)(INT64_C(1) << exponent))
        {
            (*bend) = (*cspan_at(&tables, rail + layout__RAIL_CELL_LEAST_BENDS + (exponent + INT64_C(1))));
        }
        wheel = (*cspan_at(&tables, node + layout__SCAN_NODE_MOST_BENDS + exponent));
        (*bend) -= (*stretch) * fabs((*bend)) + wheel + share * fabs(wheel);
    }
    return 0;
}

/* Length [m] of the 2^exponent cells from ``node`` on in ``direction`` (1 or -1), ``least_bend`` over
 * them [1/m] and the share of the outline's stretch [-], which is WIDEST where the raster ends before.
 *
 * u : place of the node in the raster of the rail, in cells.
 */
static inline int64_t bounds__stretch_bend(double* length, double* bend, double* stretch, array_double_1d tables, array_double_1d work, int64_t scan, int64_t at, int64_t node, int64_t direction, int64_t exponent, double u)
{
    int64_t cells;
    int64_t first;
    double begin;
    cells = INT64_C(1) << exponent;
    first = node;
    if (direction < INT64_C(0))
    {
        first = node - cells;
    }
    (*length) = 0.0;
    (*bend) = 0.0;
    (*stretch) = bounds__WIDEST;
    if ((first >= INT64_C(0)) && (first + cells < (int64_t)((*cspan_at(&tables, scan + layout__SCAN_COUNT)))))
    {
        (*length) = (*cspan_at(&tables, scan + layout__SCAN_NODES + layout__SCAN_NODE_SIZE * (first + cells) + layout__SCAN_NODE_Y)) - (*cspan_at(&tables, scan + layout__SCAN_NODES + layout__SCAN_NODE_SIZE * first + layout__SCAN_NODE_Y));
        begin = u;
        if (direction < INT64_C(0))
        {
            begin -= (1.0 + bounds__WIDEST) * (*cspan_at(&tables, scan + layout__SCAN_RAIL_PER_METRE)) * (*length);
        }
        bounds__least_bend(bend, stretch, tables, work, scan, at, first, exponent, (*length), begin);
    }
    return 0;
}

/* How far the gap can fall at most [m] over ``length`` [m], with a slope that begins with
 * ``slope`` and rises by no less than ``bend`` [1/m], on a wheel that is stretched by no more than
 * the share ``stretch``.
 */
static inline double bounds__largest_fall(double slope, double bend, double length, double stretch)
{
    double fall;
    if (bend >= 0.0)
    {
        if (slope >= 0.0)
        {
            return 0.0;
        }
        if (-slope < bend * length)
        {
            return 0.5 * (1.0 + stretch) * slope * slope / bend;
        }
    }
    fall = (-slope) * length + stretch * fabs(slope) * length - 0.5 * (1.0 + stretch) * bend * length * length;
    if (fall < 0.0)
    {
        fall = 0.0;
    }
    return fall;
}

/* The largest exponent, from ``exponent`` downwards, for which the gap does not fall by more than
 * ``excess`` [m] over the 2^exponent cells from ``node`` on; -1 if there is none.
 *
 * abscissa : of the node on the rail [m].
 * slope : of rail minus outline at the node, seen in ``direction`` (1 or -1).
 */
static ALWAYS_INLINE int64_t bounds__clear_exponent(array_double_1d tables, array_double_1d work, int64_t scan, int64_t at, int64_t node, int64_t direction, double abscissa, double excess, double slope, int64_t exponent)
{
    double u;
    double length;
    double bend;
    double stretch;
    u = bounds__rail_place(tables, scan, abscissa);
    while(exponent >= INT64_C(0))
    {
        bounds__stretch_bend(&length, &bend, &stretch, tables, work, scan, at, node, direction, exponent, u);
        if ((stretch < bounds__WIDEST) && (bounds__largest_fall(slope, bend, length, stretch) <= excess))
        {
            return exponent;
        }
        exponent -= INT64_C(1);
    }
    return exponent;
}

/* As ``clear_exponent``, also for cells over which the gap only rises. */
static inline int64_t bounds__rising_exponent(array_double_1d tables, array_double_1d work, int64_t scan, int64_t at, int64_t node, int64_t direction, double abscissa, double excess, double slope, int64_t exponent)
{
    double u;
    double length;
    double bend;
    double stretch;
    u = bounds__rail_place(tables, scan, abscissa);
    while(exponent >= INT64_C(0))
    {
        bounds__stretch_bend(&length, &bend, &stretch, tables, work, scan, at, node, direction, exponent, u);
        if (stretch < bounds__WIDEST)
        {
            if (bounds__largest_fall(slope, bend, length, stretch) <= excess)
            {
                return exponent;
            }
            if ((slope >= 0.0) && (slope + bend * length >= 0.0))
            {
                return exponent;
            }
        }
        exponent -= INT64_C(1);
    }
    return exponent;
}

/* ``clear_exponent`` from a minimum of the gap at ``y``, at ``abscissa`` on the rail [m], on:
 * where the gap only rises.
 *
 * The stretch is counted from the far node of the minimum's cell, so that it covers the whole cell.
 */
static inline int64_t bounds__rising_from_minimum(array_double_1d tables, array_double_1d work, int64_t scan, int64_t at, double y, int64_t direction, double abscissa)
{
    int64_t cell;
    double margin;
    int64_t node;
    double start;
    int64_t result;
    cell = raster__node_below(tables, scan, y);
    margin = (1.0 + bounds__WIDEST) * ((*cspan_at(&tables, scan + layout__SCAN_NODES + layout__SCAN_NODE_SIZE * (cell + INT64_C(1)) + layout__SCAN_NODE_Y)) - (*cspan_at(&tables, scan + layout__SCAN_NODES + layout__SCAN_NODE_SIZE * cell + layout__SCAN_NODE_Y)));
    node = cell;
    start = abscissa - margin;
    if (direction < INT64_C(0))
    {
        node = cell + INT64_C(1);
        start = abscissa + margin;
    }
    result = bounds__clear_exponent(tables, work, scan, at, node, direction, start, 0.0, 0.0, layout__EXPONENTS - INT64_C(1));
    return result;
}

/* Bounds [1/m] of the gap's second derivative between the nodes ``cell`` and ``cell`` + 1, the first of
 * them above the rail's ``abscissa`` [m]: rail minus wheel.
 */
static inline int64_t bounds__bend_bounds(double* least, double* most, array_double_1d tables, array_double_1d work, int64_t scan, int64_t at, int64_t cell, double abscissa)
{
    int64_t rail;
    int64_t node;
    double share;
    double sine;
    double least_rail;
    double most_rail;
    double least_wheel;
    double most_wheel;
    rail = scan + (int64_t)((*cspan_at(&tables, scan + layout__SCAN_RAIL))) + layout__RAIL_CELL_SIZE * bounds__rail_index(tables, scan, bounds__rail_place(tables, scan, abscissa));
    node = scan + layout__SCAN_NODES + layout__SCAN_NODE_SIZE * cell;
    share = bounds__ROLLED_SHARE;
    if ((*cspan_at(&work, at + layout__PLACE_YAWED)) == 1.0)
    {
        /* how much the outline is stretched: |dY/dy - 1| is about sin^2(yaw) r |r''| */
        sine = (*cspan_at(&work, at + layout__PLACE_SIN_YAW));
        share = bounds__YAWED_SHARE + bounds__STRETCHED_SHARE * sine * sine * (*cspan_at(&work, at + layout__PLACE_RADIUS)) * (*cspan_at(&tables, node + layout__SCAN_NODE_STEEPEST_BENDS + INT64_C(0)));
    }
    least_rail = (*cspan_at(&tables, rail + layout__RAIL_CELL_LEAST_BEND));
    most_rail = (*cspan_at(&tables, rail + layout__RAIL_CELL_MOST_BEND));
    least_wheel = (*cspan_at(&tables, node + layout__SCAN_NODE_LEAST_BEND));
    most_wheel = (*cspan_at(&tables, node + layout__SCAN_NODE_MOST_BENDS + INT64_C(0)));
    (*least) = least_rail - most_wheel - share * (fabs(least_rail) + fabs(most_wheel));
    (*most) = most_rail - least_wheel + share * (fabs(most_rail) + fabs(least_wheel));
    if (!((*most) > 0.0))
    {
        (*most) = 0.0;
    }
    return 0;
}

/* 1 if the gap certainly only rises, or only falls, over a ``width`` [m] in which the slope difference
 * rises by no less than ``least`` and no more than ``most`` [1/m], else 0.
 */
static inline int64_t bounds__only_rises_or_falls(double least, double most, double width, double mismatch_low, double mismatch_high)
{
    int64_t steady;
    steady = INT64_C(0);
    if ((mismatch_low >= 0.0) && (bounds__least_slope(least, most, width, mismatch_low, mismatch_high) >= 0.0))
    {
        steady = INT64_C(1);
    }
    if ((mismatch_high <= 0.0) && (bounds__least_slope(least, most, width, -mismatch_high, -mismatch_low) >= 0.0))
    {
        steady = INT64_C(1);
    }
    return steady;
}

/* The smallest slope that is possible over a ``width`` [m] between ``first`` and ``last``
 * at its ends, where it rises by no less than ``least`` and no more than ``most`` [1/m]:
 * where the lines from both ends meet.
 */
static inline double bounds__least_slope(double least, double most, double width, double first, double last)
{
    double meet;
    double lowest;
    lowest = double_min(2, first, last);
    if (least < 0.0)
    {
        lowest = first + least * width;
        if (most > 0.0)
        {
            meet = (last - first - most * width) / (least - most);
            lowest = first + least * double_min(2, double_max(2, meet, 0.0), width);
        }
    }
    return lowest;
}
