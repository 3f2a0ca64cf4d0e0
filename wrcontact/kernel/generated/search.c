/* Generated from search/search.py by tools/transpile_kernel.py; change that one.
 *
 * The smallest vertical gap of one side: march, bound, refine.
 *
 * The gap has up to three local minima (tread, flange root, flange) that exchange rank.  From a known place the search
 * marches outwards over a fixed raster of the wheel profile.  Gap, slope and a lower bound of the second derivative tell how
 * far the gap cannot have fallen below the best one known; that stretch, of up to 32 cells, is skipped.  Where not even one
 * cell can be, the gap between its two nodes lies above its chord by no less than -M h^2 / 8, where M bounds its second
 * derivative from above, and a cell that could still hold a smaller value is halved until that is settled.  So the global
 * minimum is bounded and not assumed.
 */

#include "search.h"

/* The scan node at or below ``y`` [m]; the second last one at most. */
static inline int64_t search__node_below(array_double_1d tables, double y)
{
    int64_t scan;
    double u;
    int64_t node;
    scan = (int64_t)((*cspan_at(&tables, layout__TABLES_SCAN)));
    u = (y - (*cspan_at(&tables, scan + search__SCAN_NODES + search__ROW_Y))) * (*cspan_at(&tables, scan + search__SCAN_BINS_PER_METRE));
    if (!(u > 0.0))
    {
        u = 0.0;
    }
    if (u > (*cspan_at(&tables, scan + search__SCAN_BIN_COUNT)) - 1.0)
    {
        u = (*cspan_at(&tables, scan + search__SCAN_BIN_COUNT)) - 1.0;
    }
    node = (int64_t)((*cspan_at(&tables, scan + (int64_t)((*cspan_at(&tables, scan + search__SCAN_BIN_OFFSET))) + (int64_t)(u))));
    if ((node + INT64_C(2) < (int64_t)((*cspan_at(&tables, scan + search__SCAN_COUNT)))) && ((*cspan_at(&tables, scan + search__SCAN_NODES + search__SCAN_ROW * (node + INT64_C(1)) + search__ROW_Y)) <= y))
    {
        node += INT64_C(1);
    }
    return node;
}

/* Gap [m], slope difference rail - outline [-] and rail abscissa [m] at scan node ``node``. */
static inline int64_t search__node_gap(double* result_0, double* result_1, double* abscissa, array_double_1d tables, array_double_1d place, int64_t at, int64_t node)
{
    int64_t row;
    double y_track;
    double z_track;
    double outline_slope;
    double height;
    double rail_slope;
    row = (int64_t)((*cspan_at(&tables, layout__TABLES_SCAN))) + search__SCAN_NODES + search__SCAN_ROW * node;
    locus__outline_point(&y_track, &z_track, &outline_slope, place, at, (*cspan_at(&tables, row + search__ROW_Y)), (*cspan_at(&tables, row + search__ROW_HEIGHT)), (*cspan_at(&tables, row + search__ROW_SLOPE)));
    (*abscissa) = y_track - (*cspan_at(&tables, layout__TABLES_RAIL_Y));
    profile_table__height_slope(&height, &rail_slope, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), (*abscissa));
    (*result_0) = height - z_track;
    (*result_1) = rail_slope - outline_slope;
    return 0;
}

/* Place of ``abscissa`` [m] in the rail's raster, in cells. */
static inline double search__rail_cell(array_double_1d tables, double abscissa)
{
    int64_t scan;
    double result;
    scan = (int64_t)((*cspan_at(&tables, layout__TABLES_SCAN)));
    result = (abscissa - (*cspan_at(&tables, scan + search__SCAN_RAIL_START))) * (*cspan_at(&tables, scan + search__SCAN_RAIL_PER_METRE));
    return result;
}

/* Offset in ``tables`` of the rail raster's cell at place ``u``, or of the nearest. */
static inline int64_t search__rail_row(array_double_1d tables, double u)
{
    int64_t scan;
    int64_t result;
    scan = (int64_t)((*cspan_at(&tables, layout__TABLES_SCAN)));
    if (!(u > 0.0))
    {
        u = 0.0;
    }
    if (u > (*cspan_at(&tables, scan + search__SCAN_RAIL_COUNT)) - 1.0)
    {
        u = (*cspan_at(&tables, scan + search__SCAN_RAIL_COUNT)) - 1.0;
    }
    result = scan + (int64_t)((*cspan_at(&tables, scan + search__SCAN_RAIL_OFFSET))) + search__RAIL_ROW * (int64_t)(u);
    return result;
}

/* The largest level of 2^level cells from ``node`` on in which the gap does not fall by more than ``excess`` [m], or
 * with ``risen`` = 1 in which it only rises; from ``level`` downwards, -1 if there is none.
 *
 * abscissa : where the stretch begins on the rail [m].
 * slope : of rail minus outline at the node, seen in ``direction`` (1 or -1).
 *
 * Along the wheel the slope difference rises by no less than m = rail'' - wheel'', each but for its share, and the gap by
 * that slope times the outline's stretch 1 +- w.
 */
static inline int64_t search__clear_level(array_double_1d tables, array_double_1d place, int64_t at, int64_t node, int64_t direction, double abscissa, double excess, double slope, int64_t level, int64_t risen)
{
    int64_t scan;
    int64_t count;
    double begin;
    double back;
    int64_t cells;
    int64_t first;
    int64_t row;
    double length;
    double bend;
    double stretch;
    scan = (int64_t)((*cspan_at(&tables, layout__TABLES_SCAN)));
    count = (int64_t)((*cspan_at(&tables, scan + search__SCAN_COUNT)));
    begin = search__rail_cell(tables, abscissa);
    back = 0.0;
    if (direction < INT64_C(0))
    {
        back = (1.0 + search__WIDEST) * (*cspan_at(&tables, scan + search__SCAN_RAIL_PER_METRE));
    }
    while(level >= INT64_C(0))
    {
        cells = INT64_C(1) << (int64_t)(level);
        first = node;
        if (direction < INT64_C(0))
        {
            first = node - cells;
        }
        if ((first >= INT64_C(0)) && (first + cells < count))
        {
            row = scan + search__SCAN_NODES + search__SCAN_ROW * first;
            length = (*cspan_at(&tables, row + search__SCAN_ROW * cells + search__ROW_Y)) - (*cspan_at(&tables, row + search__ROW_Y));
            search__least_bend(&bend, &stretch, tables, place, at, first, level, length, begin - back * length);
            if (stretch < search__WIDEST)
            {
                if (search__largest_fall(slope, bend, length, stretch) <= excess)
                {
                    return level;
                }
                if ((risen == INT64_C(1)) && (slope >= 0.0) && (slope + bend * length >= 0.0))
                {
                    return level;
                }
            }
        }
        level -= INT64_C(1);
    }
    return level;
}

/* By how much the slope difference rises at least [1/m] over the 2^level cells, of ``length`` [m] together, that begin
 * with scan node ``first``, and the share by which the outline is stretched there; the first tells nothing where the second is
 * not below WIDEST.
 *
 * u : place in the rail's raster where they begin, in cells.
 */
static inline int64_t search__least_bend(double* bend, double* stretch, array_double_1d tables, array_double_1d place, int64_t at, int64_t first, int64_t level, double length, double u)
{
    double roll;
    double share;
    int64_t row;
    double square;
    int64_t rail;
    double wheel;
    roll = fabs((*cspan_at(&place, at + layout__PLACE_SIN_ROLL)));
    (*stretch) = search__ROLL_STRETCH * roll;
    share = search__ROLL_BEND * roll;
    row = (int64_t)((*cspan_at(&tables, layout__TABLES_SCAN))) + search__SCAN_NODES + search__SCAN_ROW * first;
    if ((*cspan_at(&place, at + layout__PLACE_YAWED)) == 1.0)
    {
        square = (*cspan_at(&place, at + layout__PLACE_SIN_YAW)) * (*cspan_at(&place, at + layout__PLACE_SIN_YAW));
        (*stretch) += search__STEEP_STRETCH * square + search__BEND_STRETCH * square * (*cspan_at(&place, at + layout__PLACE_RADIUS)) * (*cspan_at(&tables, row + search__ROW_STEEPEST_BENDS + level));
        share += search__YAW_BEND * square;
    }
    (*bend) = 0.0;
    if ((*stretch) < search__WIDEST)
    {
        rail = search__rail_row(tables, u);
        (*bend) = (*cspan_at(&tables, rail + search__RAIL_LEAST_BENDS + level));
        if (length > search__FINE_CELL * (double)(INT64_C(1) << (int64_t)(level)))
        {
            (*bend) = (*cspan_at(&tables, rail + search__RAIL_LEAST_BENDS + level + INT64_C(1)));
        }
        wheel = (*cspan_at(&tables, row + search__ROW_MOST_BENDS + level));
        (*bend) -= (*stretch) * fabs((*bend)) + wheel + share * fabs(wheel);
    }
    return 0;
}

/* ``clear_level`` from a minimum of the gap in ``cell``, at ``abscissa`` on the rail [m]: where the gap only rises.
 *
 * The stretch is counted from the cell's far node, so that it covers the whole cell.
 */
static inline int64_t search__leave_minimum(array_double_1d tables, array_double_1d place, int64_t at, int64_t cell, int64_t direction, double abscissa)
{
    int64_t row;
    double margin;
    int64_t node;
    double start;
    int64_t result;
    row = (int64_t)((*cspan_at(&tables, layout__TABLES_SCAN))) + search__SCAN_NODES + search__SCAN_ROW * cell;
    margin = (1.0 + search__WIDEST) * ((*cspan_at(&tables, row + search__SCAN_ROW + search__ROW_Y)) - (*cspan_at(&tables, row + search__ROW_Y)));
    node = cell;
    start = abscissa - margin;
    if (direction < INT64_C(0))
    {
        node = cell + INT64_C(1);
        start = abscissa + margin;
    }
    result = search__clear_level(tables, place, at, node, direction, start, 0.0, 0.0, search__LEVELS - INT64_C(1), INT64_C(0));
    return result;
}

/* How far the gap can fall at most over ``length`` [m], with a slope that begins with ``slope`` and rises by no less
 * than ``bend`` [1/m], on a wheel that is stretched by no more than the share ``stretch``.
 */
static inline double search__largest_fall(double slope, double bend, double length, double stretch)
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

/* Bounds [1/m] of the gap's second derivative between scan nodes ``cell`` and ``cell`` + 1, the first of them above
 * the rail's ``abscissa`` [m]: rail minus wheel.
 */
static inline int64_t search__bend_bounds(double* least, double* most, array_double_1d tables, array_double_1d place, int64_t at, int64_t cell, double abscissa)
{
    int64_t rail;
    int64_t row;
    double share;
    double sine;
    double least_rail;
    double most_rail;
    double least_wheel;
    double most_wheel;
    rail = search__rail_row(tables, search__rail_cell(tables, abscissa));
    row = (int64_t)((*cspan_at(&tables, layout__TABLES_SCAN))) + search__SCAN_NODES + search__SCAN_ROW * cell;
    share = search__ROLLED_SHARE;
    if ((*cspan_at(&place, at + layout__PLACE_YAWED)) == 1.0)
    {
        /* how much the outline is stretched: |dY/dy - 1| is about sin^2(yaw) r |r''| */
        sine = (*cspan_at(&place, at + layout__PLACE_SIN_YAW));
        share = search__YAWED_SHARE + search__STRETCHED_SHARE * sine * sine * (*cspan_at(&place, at + layout__PLACE_RADIUS)) * (*cspan_at(&tables, row + search__ROW_STEEPEST_BENDS));
    }
    least_rail = (*cspan_at(&tables, rail + search__RAIL_LEAST_BEND));
    most_rail = (*cspan_at(&tables, rail + search__RAIL_MOST_BEND));
    least_wheel = (*cspan_at(&tables, row + search__ROW_LEAST_BEND));
    most_wheel = (*cspan_at(&tables, row + search__ROW_MOST_BENDS));
    (*least) = least_rail - most_wheel - share * (fabs(least_rail) + fabs(most_wheel));
    (*most) = most_rail - least_wheel + share * (fabs(most_rail) + fabs(least_wheel));
    if (!((*most) > 0.0))
    {
        (*most) = 0.0;
    }
    return 0;
}

/* Put the smallest gap of the side and its abscissa into SIDE_BEST, SIDE_BEST_Y; 1 if there is one, else 0.
 *
 * With ``known`` = 1 the two, and SIDE_BEST_RAIL, already hold a local minimum of this pose, and only a smaller one is
 * looked for.
 */
static inline int64_t search__search_side(array_double_1d tables, array_double_1d work, int64_t side, array_double_1d place, int64_t at, array_double_1d state, int64_t known)
{
    int64_t cell;
    int64_t ahead;
    int64_t behind;
    int64_t node;
    double gap;
    double mismatch;
    double abscissa;
    (*cspan_at(&state, layout__STATE_SCAN_COUNT)) += 1.0;
    if (known == INT64_C(1))
    {
        cell = search__node_below(tables, (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST_Y)));
        ahead = search__leave_minimum(tables, place, at, cell, INT64_C(1), (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST_RAIL)));
        behind = search__leave_minimum(tables, place, at, cell, -INT64_C(1), (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST_RAIL)));
        if ((ahead >= INT64_C(0)) && (behind >= INT64_C(0)))
        {
            search__march(tables, work, side, place, at, state, cell + (INT64_C(1) << (int64_t)(ahead)), INT64_C(1));
            search__march(tables, work, side, place, at, state, cell + INT64_C(1) - (INT64_C(1) << (int64_t)(behind)), -INT64_C(1));
            return INT64_C(1);
        }
        node = cell;
        search__node_gap(&gap, &mismatch, &abscissa, tables, place, at, node);
        if (gap__above_rail(tables, abscissa) == INT64_C(0))
        {
            node = cell + INT64_C(1);
        }
    }
    else
    {
        (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST)) = search__LARGE_GAP;
        node = search__probe(tables, work, side, place, at, state, search__PROBE_STRIDE);
        if (node < INT64_C(0))
        {
            node = search__probe(tables, work, side, place, at, state, INT64_C(1));
        }
        if (node < INT64_C(0))
        {
            return INT64_C(0);
        }
    }
    search__march(tables, work, side, place, at, state, node, INT64_C(1));
    search__march(tables, work, side, place, at, state, node, -INT64_C(1));
    return INT64_C(1);
}

/* The node with the smallest gap among every ``stride``-th one above the rail, which becomes the best known; -1 if
 * there is none.
 */
static inline int64_t search__probe(array_double_1d tables, array_double_1d work, int64_t side, array_double_1d place, int64_t at, array_double_1d state, int64_t stride)
{
    int64_t node;
    int64_t count;
    double gap;
    double mismatch;
    double abscissa;
    int64_t found;
    found = -INT64_C(1);
    node = INT64_C(0);
    count = (int64_t)((*cspan_at(&tables, (int64_t)((*cspan_at(&tables, layout__TABLES_SCAN))) + search__SCAN_COUNT)));
    while(node < count)
    {
        search__node_gap(&gap, &mismatch, &abscissa, tables, place, at, node);
        (*cspan_at(&state, layout__STATE_GAP_COUNT)) += 1.0;
        if (gap__above_rail(tables, abscissa) == INT64_C(1))
        {
            if (gap < (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST)))
            {
                (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST)) = gap;
                (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST_Y)) = (*cspan_at(&tables, (int64_t)((*cspan_at(&tables, layout__TABLES_SCAN))) + search__SCAN_NODES + search__SCAN_ROW * node + search__ROW_Y));
                found = node;
            }
        }
        else if ((found >= INT64_C(0)) && (search__is_gone(tables, place, at, node, INT64_C(1), abscissa) == INT64_C(1)))
        {
            return found;
        }
        node += stride;
    }
    return found;
}

/* Search from scan node ``node`` on in ``direction`` (1 or -1), up to the end of rail or wheel. */
static inline int64_t search__march(array_double_1d tables, array_double_1d work, int64_t side, array_double_1d place, int64_t at, array_double_1d state, int64_t node, int64_t direction)
{
    int64_t scan;
    int64_t count;
    int64_t level;
    double gap_before;
    double abscissa_before;
    int64_t skipped;
    int64_t off;
    double gap;
    double mismatch;
    double abscissa;
    scan = (int64_t)((*cspan_at(&tables, layout__TABLES_SCAN)));
    count = (int64_t)((*cspan_at(&tables, scan + search__SCAN_COUNT)));
    level = search__LEVELS - INT64_C(1);
    gap_before = search__LARGE_GAP;
    abscissa_before = 0.0;
    skipped = INT64_C(1);
    off = INT64_C(0);
    while((node >= INT64_C(0)) && (node < count))
    {
        search__node_gap(&gap, &mismatch, &abscissa, tables, place, at, node);
        (*cspan_at(&state, layout__STATE_GAP_COUNT)) += 1.0;
        if (gap__above_rail(tables, abscissa) == INT64_C(0))
        {
            if ((skipped == INT64_C(0)) && (off == INT64_C(0)))
            {
                search__search_end(tables, work, side, place, at, state, node - direction, direction, abscissa_before, abscissa);
            }
            if (search__is_gone(tables, place, at, node, direction, abscissa) == INT64_C(1))
            {
                return INT64_C(0);
            }
            off = INT64_C(1);
            skipped = INT64_C(0);
            level = INT64_C(0);
        }
        else
        {
            search__keep_best(work, side, (*cspan_at(&tables, scan + search__SCAN_NODES + search__SCAN_ROW * node + search__ROW_Y)), gap);
            if (off == INT64_C(1))
            {
                search__search_end(tables, work, side, place, at, state, node, -direction, abscissa, abscissa_before);
            }
            else if (skipped == INT64_C(0))
            {
                if (direction > INT64_C(0))
                {
                    search__bound_cell(tables, work, side, place, at, state, node - INT64_C(1), gap_before, gap, abscissa_before);
                }
                else
                {
                    search__bound_cell(tables, work, side, place, at, state, node, gap, gap_before, abscissa);
                }
            }
            off = INT64_C(0);
            gap_before = gap;
            level = search__clear_level(tables, place, at, node, direction, abscissa, gap - (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST)), (double)(direction) * mismatch, level, INT64_C(0));
            skipped = INT64_C(1);
            if (level < INT64_C(0))
            {
                level = INT64_C(0);
                skipped = INT64_C(0);
            }
        }
        abscissa_before = abscissa;
        node += direction * (INT64_C(1) << (int64_t)(level));
        if ((off == INT64_C(0)) && (level < search__LEVELS - INT64_C(1)))
        {
            level += INT64_C(1);
        }
    }
    return INT64_C(0);
}

/* 1 if the outline, beside the rail at scan node ``node``, does not come back above it further in ``direction``, else 0.
 *
 * Yaw moves a place of the wheel sideways by about sin^2(yaw) r times its slope, so that a steep flank can reach over a
 * rail that ends below the flange root.
 */
static inline int64_t search__is_gone(array_double_1d tables, array_double_1d place, int64_t at, int64_t node, int64_t direction, double abscissa)
{
    int64_t scan;
    int64_t rail;
    double apart;
    double reach;
    double sine;
    double steep;
    int64_t gone;
    scan = (int64_t)((*cspan_at(&tables, layout__TABLES_SCAN)));
    rail = (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL)));
    apart = abscissa - (*cspan_at(&tables, rail + layout__PROFILE_STOP));
    if (direction < INT64_C(0))
    {
        apart = (*cspan_at(&tables, rail + layout__PROFILE_START)) - abscissa;
    }
    reach = 0.0;
    if ((*cspan_at(&place, at + layout__PLACE_YAWED)) == 1.0)
    {
        sine = (*cspan_at(&place, at + layout__PLACE_SIN_YAW));
        steep = (*cspan_at(&tables, scan + search__SCAN_STEEPEST)) + (*cspan_at(&tables, scan + search__SCAN_NODES + search__SCAN_ROW * node + search__ROW_SLOPE));
        reach = search__REACH_SHARE * sine * sine * (*cspan_at(&place, at + layout__PLACE_RADIUS)) * steep + search__REACH_ROLL * fabs((*cspan_at(&place, at + layout__PLACE_SIN_ROLL)));
    }
    gone = INT64_C(0);
    if (apart > reach)
    {
        gone = INT64_C(1);
    }
    return gone;
}

/* Search between the scan nodes ``cell`` and ``cell`` + 1 if the gap can be smaller there than the best one known.
 *
 * gap_low, gap_high : at the two nodes [m].
 * abscissa : of the first one on the rail [m].
 */
static inline int64_t search__bound_cell(array_double_1d tables, array_double_1d work, int64_t side, array_double_1d place, int64_t at, array_double_1d state, int64_t cell, double gap_low, double gap_high, double abscissa)
{
    int64_t row;
    double low;
    double high;
    double least;
    double most;
    double lowest;
    row = (int64_t)((*cspan_at(&tables, layout__TABLES_SCAN))) + search__SCAN_NODES + search__SCAN_ROW * cell;
    low = (*cspan_at(&tables, row + search__ROW_Y));
    high = (*cspan_at(&tables, row + search__SCAN_ROW + search__ROW_Y));
    search__bend_bounds(&least, &most, tables, place, at, cell, abscissa);
    lowest = gap_low;
    if (gap_high < lowest)
    {
        lowest = gap_high;
    }
    if (lowest - most * (high - low) * (high - low) / 8.0 < (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST)))
    {
        search__search_cell(tables, work, side, place, at, state, least, most, low, high);
    }
    return INT64_C(0);
}

/* Search between scan node ``node``, above the rail at ``abscissa`` [m], and the end of the rail, which lies before the next
 * node at ``beyond`` [m].
 */
static inline int64_t search__search_end(array_double_1d tables, array_double_1d work, int64_t side, array_double_1d place, int64_t at, array_double_1d state, int64_t node, int64_t outward, double abscissa, double beyond)
{
    double inner;
    double inside;
    int64_t cell;
    double least;
    double most;
    inner = (*cspan_at(&tables, (int64_t)((*cspan_at(&tables, layout__TABLES_SCAN))) + search__SCAN_NODES + search__SCAN_ROW * node + search__ROW_Y));
    inside = search__rail_end(tables, place, at, node, outward);
    cell = node;
    if (outward < INT64_C(0))
    {
        cell = node - INT64_C(1);
    }
    if (beyond < abscissa)
    {
        abscissa = (*cspan_at(&tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))) + layout__PROFILE_START));
    }
    search__bend_bounds(&least, &most, tables, place, at, cell, abscissa);
    if (inside < inner)
    {
        search__search_cell(tables, work, side, place, at, state, -1.0, most, inside, inner);
    }
    else if (inside > inner)
    {
        search__search_cell(tables, work, side, place, at, state, -1.0, most, inner, inside);
    }
    return INT64_C(0);
}

/* Wheel abscissa [m] above the end of the rail, which lies between scan node ``node``, above it, and the next one
 * ``outward`` (1 or -1).
 */
static inline double search__rail_end(array_double_1d tables, array_double_1d place, int64_t at, int64_t node, int64_t outward)
{
    int64_t row;
    double outside;
    double middle;
    double z;
    double slope;
    double y_track;
    double z_track;
    double outline_slope;
    double inside;
    row = (int64_t)((*cspan_at(&tables, layout__TABLES_SCAN))) + search__SCAN_NODES + search__SCAN_ROW * node;
    inside = (*cspan_at(&tables, row + search__ROW_Y));
    outside = (*cspan_at(&tables, row + search__SCAN_ROW * outward + search__ROW_Y));
    while(fabs(outside - inside) > search__END_SHARP)
    {
        middle = 0.5 * (inside + outside);
        profile_table__height_slope(&z, &slope, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL))), middle);
        locus__outline_point(&y_track, &z_track, &outline_slope, place, at, middle, z, slope);
        if (gap__above_rail(tables, y_track - (*cspan_at(&tables, layout__TABLES_RAIL_Y))) == INT64_C(1))
        {
            inside = middle;
        }
        else
        {
            outside = middle;
        }
    }
    return inside;
}

/* List the local minima of the gap below ``reach`` [m] other than the known smallest one, which lies at ``abscissa`` on
 * the rail [m].
 *
 * SIDE_FIRST and SIDE_LAST tell which entries of SIDE_PLACE, their wheel abscissae, and of SIDE_ABSCISSA, their places on
 * the rail [m], hold them, by rising abscissa.
 */
static inline int64_t search__scan_side(array_double_1d tables, array_double_1d work, int64_t side, array_double_1d place, int64_t at, array_double_1d state, double reach, double abscissa)
{
    int64_t cell;
    int64_t ahead;
    int64_t behind;
    cell = search__node_below(tables, (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST_Y)));
    (*cspan_at(&work, side + layout__SIDE_SEARCH_FIRST)) = (double)((double)(search__CANDIDATES));
    (*cspan_at(&work, side + layout__SIDE_SEARCH_LAST)) = (double)((double)(search__CANDIDATES - INT64_C(1)));
    ahead = search__leave_minimum(tables, place, at, cell, INT64_C(1), abscissa);
    if (ahead < INT64_C(0))
    {
        ahead = INT64_C(0);
    }
    search__scan_on(tables, work, side, place, at, state, reach, cell + (INT64_C(1) << (int64_t)(ahead)), INT64_C(1));
    behind = search__leave_minimum(tables, place, at, cell, -INT64_C(1), abscissa);
    if (behind < INT64_C(0))
    {
        behind = INT64_C(0);
    }
    search__scan_on(tables, work, side, place, at, state, reach, cell + INT64_C(1) - (INT64_C(1) << (int64_t)(behind)), -INT64_C(1));
    return INT64_C(0);
}

/* ``scan_side`` from scan node ``node`` on in ``direction`` (1 or -1).
 *
 * Stretches are skipped in which the gap only rises, or stays above ``reach``.
 */
static inline int64_t search__scan_on(array_double_1d tables, array_double_1d work, int64_t side, array_double_1d place, int64_t at, array_double_1d state, double reach, int64_t node, int64_t direction)
{
    int64_t nodes;
    int64_t count;
    int64_t level;
    double gap_before;
    double mismatch_before;
    double abscissa_before;
    int64_t skipped;
    int64_t off;
    double gap;
    double mismatch;
    double abscissa;
    double y;
    nodes = (int64_t)((*cspan_at(&tables, layout__TABLES_SCAN))) + search__SCAN_NODES;
    count = (int64_t)((*cspan_at(&tables, (int64_t)((*cspan_at(&tables, layout__TABLES_SCAN))) + search__SCAN_COUNT)));
    level = search__LEVELS - INT64_C(1);
    gap_before = 0.0;
    mismatch_before = 0.0;
    abscissa_before = 0.0;
    skipped = INT64_C(1);
    off = INT64_C(0);
    while((node >= INT64_C(0)) && (node < count))
    {
        search__node_gap(&gap, &mismatch, &abscissa, tables, place, at, node);
        (*cspan_at(&state, layout__STATE_GAP_COUNT)) += 1.0;
        y = (*cspan_at(&tables, nodes + search__SCAN_ROW * node + search__ROW_Y));
        if (gap__above_rail(tables, abscissa) == INT64_C(0))
        {
            if ((skipped == INT64_C(0)) && (off == INT64_C(0)))
            {
                search__list_end(tables, work, side, place, at, state, reach, node - direction, direction, direction);
            }
            if (search__is_gone(tables, place, at, node, direction, abscissa) == INT64_C(1))
            {
                return INT64_C(0);
            }
            off = INT64_C(1);
            skipped = INT64_C(0);
            level = INT64_C(0);
        }
        else
        {
            if (off == INT64_C(1))
            {
                search__list_end(tables, work, side, place, at, state, reach, node, -direction, direction);
            }
            else if ((skipped == INT64_C(0)) && (direction > INT64_C(0)))
            {
                search__list_cell(tables, work, side, place, at, state, reach, node - INT64_C(1), direction, abscissa_before, (*cspan_at(&tables, nodes + search__SCAN_ROW * (node - INT64_C(1)) + search__ROW_Y)), y, gap_before, gap, mismatch_before, mismatch);
            }
            else if (skipped == INT64_C(0))
            {
                search__list_cell(tables, work, side, place, at, state, reach, node, direction, abscissa, y, (*cspan_at(&tables, nodes + search__SCAN_ROW * (node + INT64_C(1)) + search__ROW_Y)), gap, gap_before, mismatch, mismatch_before);
            }
            off = INT64_C(0);
            level = search__clear_level(tables, place, at, node, direction, abscissa, gap - reach, (double)(direction) * mismatch, level, INT64_C(1));
            skipped = INT64_C(1);
            if (level < INT64_C(0))
            {
                level = INT64_C(0);
                skipped = INT64_C(0);
            }
            gap_before = gap;
            mismatch_before = mismatch;
            abscissa_before = abscissa;
        }
        node += direction * (INT64_C(1) << (int64_t)(level));
        if ((off == INT64_C(0)) && (level < search__LEVELS - INT64_C(1)))
        {
            level += INT64_C(1);
        }
    }
    return INT64_C(0);
}

/* ``list_cell`` between scan node ``node`` and the end of the rail before the next one ``outward`` (1 or -1). */
static inline int64_t search__list_end(array_double_1d tables, array_double_1d work, int64_t side, array_double_1d place, int64_t at, array_double_1d state, double reach, int64_t node, int64_t outward, int64_t direction)
{
    double inner;
    double end;
    double low;
    double high;
    int64_t cell;
    double gap_low;
    double mismatch_low;
    double rate;
    double gap_high;
    double mismatch_high;
    inner = (*cspan_at(&tables, (int64_t)((*cspan_at(&tables, layout__TABLES_SCAN))) + search__SCAN_NODES + search__SCAN_ROW * node + search__ROW_Y));
    end = search__rail_end(tables, place, at, node, outward);
    low = double_min(2, inner, end);
    high = double_max(2, inner, end);
    cell = node;
    if (outward < INT64_C(0))
    {
        cell = node - INT64_C(1);
    }
    if (low < high)
    {
        gap__vertical_gap(&gap_low, &mismatch_low, &rate, work, tables, at, low);
        gap__vertical_gap(&gap_high, &mismatch_high, &rate, work, tables, at, high);
        (*cspan_at(&state, layout__STATE_GAP_COUNT)) += 2.0;
        search__list_cell(tables, work, side, place, at, state, reach, cell, direction, search__rail_place(tables, place, at, low), low, high, gap_low, gap_high, mismatch_low, mismatch_high);
    }
    return INT64_C(0);
}

/* Abscissa on the rail [m] below wheel abscissa ``y`` [m]. */
static inline double search__rail_place(array_double_1d tables, array_double_1d place, int64_t at, double y)
{
    double z;
    double slope;
    double y_track;
    double z_track;
    double outline_slope;
    double result;
    profile_table__height_slope(&z, &slope, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL))), y);
    locus__outline_point(&y_track, &z_track, &outline_slope, place, at, y, z, slope);
    result = y_track - (*cspan_at(&tables, layout__TABLES_RAIL_Y));
    return result;
}

/* List the local minima between ``low`` and ``high`` [m], which lie between the scan nodes ``cell`` and ``cell`` + 1.
 *
 * abscissa : of ``low`` on the rail [m].
 * gap_low, gap_high, mismatch_low, mismatch_high : at both.
 */
static inline int64_t search__list_cell(array_double_1d tables, array_double_1d work, int64_t side, array_double_1d place, int64_t at, array_double_1d state, double reach, int64_t cell, int64_t direction, double abscissa, double low, double high, double gap_low, double gap_high, double mismatch_low, double mismatch_high)
{
    double nothing;
    double most;
    double least;
    double stretch;
    double rate;
    int64_t stack;
    int64_t depth;
    int64_t top;
    double width;
    bool folded;
    bool turns;
    double y;
    double gap;
    double middle;
    double mismatch;
    search__bend_bounds(&nothing, &most, tables, place, at, cell, abscissa);
    search__least_bend(&least, &stretch, tables, place, at, cell, INT64_C(0), high - low, search__rail_cell(tables, abscissa));
    if (!(stretch < search__WIDEST))
    {
        /* the outline may be folded there */
        least = nothing;
        gap__vertical_gap(&gap_low, &mismatch_low, &rate, work, tables, at, low);
        gap__vertical_gap(&gap_high, &mismatch_high, &rate, work, tables, at, high);
        (*cspan_at(&state, layout__STATE_GAP_COUNT)) += 2.0;
    }
    stack = side + layout__SIDE_STACK;
    search__push_cell(work, stack, low, high, gap_low, gap_high, mismatch_low, mismatch_high);
    depth = INT64_C(1);
    while(depth > INT64_C(0))
    {
        depth -= INT64_C(1);
        top = stack + INT64_C(6) * depth;
        low = (*cspan_at(&work, top));
        high = (*cspan_at(&work, top + INT64_C(1)));
        gap_low = (*cspan_at(&work, top + INT64_C(2)));
        gap_high = (*cspan_at(&work, top + INT64_C(3)));
        mismatch_low = (*cspan_at(&work, top + INT64_C(4)));
        mismatch_high = (*cspan_at(&work, top + INT64_C(5)));
        width = high - low;
        if (double_min(2, gap_low, gap_high) - most * width * width / 8.0 < reach)
        {
            folded = (mismatch_low == gap__FOLDED) || (mismatch_high == gap__FOLDED);
            turns = (mismatch_low < 0.0) && (mismatch_high >= 0.0) && (!folded);
            if (turns && ((least > 0.0) || (width <= search__LISTED_ONE)))
            {
                search__refine_minimum(&y, &gap, tables, place, at, state, low, high, mismatch_low, mismatch_high, search__LISTED);
                if (gap < reach)
                {
                    search__list_minimum(work, side, y, search__rail_place(tables, place, at, y), direction);
                }
            }
            else if ((width > search__LISTED) && (folded || (search__is_steady(least, most, width, mismatch_low, mismatch_high) == INT64_C(0))))
            {
                middle = 0.5 * (low + high);
                gap__vertical_gap(&gap, &mismatch, &rate, work, tables, at, middle);
                (*cspan_at(&state, layout__STATE_GAP_COUNT)) += 1.0;
                /* the one that comes first in ``direction`` on top */
                if (direction > INT64_C(0))
                {
                    search__push_cell(work, top, middle, high, gap, gap_high, mismatch, mismatch_high);
                    search__push_cell(work, top + INT64_C(6), low, middle, gap_low, gap, mismatch_low, mismatch);
                }
                else
                {
                    search__push_cell(work, top, low, middle, gap_low, gap, mismatch_low, mismatch);
                    search__push_cell(work, top + INT64_C(6), middle, high, gap, gap_high, mismatch, mismatch_high);
                }
                depth += INT64_C(2);
            }
        }
    }
    return INT64_C(0);
}

/* 1 if the gap certainly only rises, or only falls, over a ``width`` [m] in which the slope difference rises by no less
 * than ``least`` and no more than ``most`` [1/m], else 0.
 */
static inline int64_t search__is_steady(double least, double most, double width, double mismatch_low, double mismatch_high)
{
    int64_t steady;
    steady = INT64_C(0);
    if ((mismatch_low >= 0.0) && (search__least_slope(least, most, width, mismatch_low, mismatch_high) >= 0.0))
    {
        steady = INT64_C(1);
    }
    if ((mismatch_high <= 0.0) && (search__least_slope(least, most, width, -mismatch_high, -mismatch_low) >= 0.0))
    {
        steady = INT64_C(1);
    }
    return steady;
}

/* The smallest slope that is possible over a ``width`` [m] between ``first`` and ``last`` at its ends, where it rises by
 * no less than ``least`` and no more than ``most`` [1/m]: where the lines from both ends meet.
 */
static inline double search__least_slope(double least, double most, double width, double first, double last)
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

/* Add the minimum at ``y`` [m] to the list of ``scan_side``, at the end for ``direction`` = 1, else at the beginning. */
static inline int64_t search__list_minimum(array_double_1d work, int64_t side, double y, double abscissa, int64_t direction)
{
    int64_t entry;
    entry = (int64_t)((*cspan_at(&work, side + layout__SIDE_SEARCH_LAST))) + INT64_C(1);
    if (direction < INT64_C(0))
    {
        entry = (int64_t)((*cspan_at(&work, side + layout__SIDE_SEARCH_FIRST))) - INT64_C(1);
    }
    if ((entry >= INT64_C(0)) && (entry < INT64_C(2) * search__CANDIDATES))
    {
        (*cspan_at(&work, side + layout__SIDE_SEARCH_PLACE + entry)) = y;
        (*cspan_at(&work, side + layout__SIDE_SEARCH_ABSCISSA + entry)) = abscissa;
        if (direction < INT64_C(0))
        {
            (*cspan_at(&work, side + layout__SIDE_SEARCH_FIRST)) = (double)((double)(entry));
        }
        else
        {
            (*cspan_at(&work, side + layout__SIDE_SEARCH_LAST)) = (double)((double)(entry));
        }
    }
    return INT64_C(0);
}

/* Local minima between ``first`` and ``last`` [m]: halve while a better value is possible, refine where the slope
 * turns.  ``least`` and ``most`` bound the second derivative.
 */
static inline int64_t search__search_cell(array_double_1d tables, array_double_1d work, int64_t side, array_double_1d place, int64_t at, array_double_1d state, double least, double most, double first, double last)
{
    int64_t stack;
    double gap_low;
    double mismatch_low;
    double rate;
    double gap_high;
    double mismatch_high;
    int64_t depth;
    int64_t top;
    double low;
    double high;
    double width;
    double lowest;
    bool folded;
    bool turns;
    bool steady;
    double y;
    double gap;
    double middle;
    double mismatch;
    stack = side + layout__SIDE_STACK;
    gap__vertical_gap(&gap_low, &mismatch_low, &rate, work, tables, at, first);
    gap__vertical_gap(&gap_high, &mismatch_high, &rate, work, tables, at, last);
    (*cspan_at(&state, layout__STATE_GAP_COUNT)) += 2.0;
    search__push_cell(work, stack, first, last, gap_low, gap_high, mismatch_low, mismatch_high);
    depth = INT64_C(1);
    while(depth > INT64_C(0))
    {
        depth -= INT64_C(1);
        top = stack + INT64_C(6) * depth;
        low = (*cspan_at(&work, top));
        high = (*cspan_at(&work, top + INT64_C(1)));
        gap_low = (*cspan_at(&work, top + INT64_C(2)));
        gap_high = (*cspan_at(&work, top + INT64_C(3)));
        mismatch_low = (*cspan_at(&work, top + INT64_C(4)));
        mismatch_high = (*cspan_at(&work, top + INT64_C(5)));
        width = high - low;
        lowest = gap_low;
        search__keep_best(work, side, low, gap_low);
        if (gap_high < gap_low)
        {
            lowest = gap_high;
            search__keep_best(work, side, high, gap_high);
        }
        if (lowest - most * width * width / 8.0 < (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST)))
        {
            folded = (mismatch_low == gap__FOLDED) || (mismatch_high == gap__FOLDED);
            turns = (mismatch_low < 0.0) && (mismatch_high >= 0.0) && (!folded);
            steady = (search__is_steady(least, most, width, mismatch_low, mismatch_high) == INT64_C(1)) && (!folded);
            if (turns && ((least > 0.0) || (width <= search__NARROW)))
            {
                search__refine_minimum(&y, &gap, tables, place, at, state, low, high, mismatch_low, mismatch_high, search__SHARP);
                search__keep_refined(work, side, y, gap, width);
            }
            else if ((width > search__NARROW) && (!steady) && (folded || (!(least > 0.0))))
            {
                middle = 0.5 * (low + high);
                gap__vertical_gap(&gap, &mismatch, &rate, work, tables, at, middle);
                (*cspan_at(&state, layout__STATE_GAP_COUNT)) += 1.0;
                search__push_cell(work, top, low, middle, gap_low, gap, mismatch_low, mismatch);
                search__push_cell(work, top + INT64_C(6), middle, high, gap, gap_high, mismatch, mismatch_high);
                depth += INT64_C(2);
            }
        }
    }
    return INT64_C(0);
}

/* Write a cell to the stack at ``top``. */
static inline int64_t search__push_cell(array_double_1d work, int64_t top, double low, double high, double gap_low, double gap_high, double mismatch_low, double mismatch_high)
{
    (*cspan_at(&work, top)) = low;
    (*cspan_at(&work, top + INT64_C(1))) = high;
    (*cspan_at(&work, top + INT64_C(2))) = gap_low;
    (*cspan_at(&work, top + INT64_C(3))) = gap_high;
    (*cspan_at(&work, top + INT64_C(4))) = mismatch_low;
    (*cspan_at(&work, top + INT64_C(5))) = mismatch_high;
    return INT64_C(0);
}

/* Keep (y, gap) if it is the side's best so far, by more than rounding: a node beside a place of contact is none. */
static inline int64_t search__keep_best(array_double_1d work, int64_t side, double y, double gap)
{
    if (gap < (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST)) - search__ROUNDING)
    {
        (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST)) = gap;
        (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST_Y)) = y;
    }
    return INT64_C(0);
}

/* Keep (y, gap), a place of contact, if it is the side's best so far: before a node within ``width`` [m] that has the same
 * gap but for the last bits.
 */
static inline int64_t search__keep_refined(array_double_1d work, int64_t side, double y, double gap, double width)
{
    double allowed;
    allowed = (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST));
    if (fabs(y - (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST_Y))) < width)
    {
        allowed += search__ROUNDING;
    }
    if (gap < allowed)
    {
        (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST)) = gap;
        (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST_Y)) = y;
    }
    return INT64_C(0);
}

/* Abscissa [m], to ``sharp`` [m], and gap [m] where the slope difference vanishes between ``low`` and ``high``:
 * bracketed Newton.
 */
static inline int64_t search__refine_minimum(double* y, double* gap, array_double_1d tables, array_double_1d place, int64_t at, array_double_1d state, double low, double high, double mismatch_low, double mismatch_high, double sharp)
{
    int64_t i;
    double mismatch;
    double rate;
    double following;
    double move;
    (*y) = low - mismatch_low * (high - low) / (mismatch_high - mismatch_low);
    (*gap) = 0.0;
    for (i = INT64_C(0); i < INT64_C(60); i += INT64_C(1))
    {
        gap__vertical_gap(gap, &mismatch, &rate, place, tables, at, (*y));
        (*cspan_at(&state, layout__STATE_GAP_COUNT)) += 1.0;
        if (mismatch < 0.0)
        {
            low = (*y);
        }
        else
        {
            high = (*y);
        }
        following = 0.5 * (low + high);
        if (rate > 0.0)
        {
            move = (-mismatch) / rate;
            if (fabs(move) < sharp)
            {
                break;
            }
            if (((*y) + move > low) && ((*y) + move < high))
            {
                following = (*y) + move;
            }
        }
        if (fabs(following - (*y)) < sharp)
        {
            break;
        }
        (*y) = following;
    }
    return 0;
}
