/* Generated from search/walk.py by tools/transpile_kernel.py; change that one.
 *
 * Walk over the raster of the wheel from a node outwards, and search the cells that
 * may hold a minimum of the gap.
 *
 * Gap, slope and a lower bound of the second derivative tell over how many cells the gap cannot have a value of
 * interest; that stretch, of up to 32 cells, is skipped. Where not even one cell can be skipped, the cell itself
 * is searched. One walk serves two questions: the smallest gap (``listing`` = 0) and all local minima below
 * ``side.reach`` (``listing`` = 1).
 *
 * The overlap of a pressed wheel has a walk of its own (contact/overlaps.py): it keeps what it finds at the
 * nodes, does not look between them, and ends at the first node beside the rail.
 */

#include "walk.h"

/* Search from ``node`` on in ``direction`` (1 or -1), up to the end of rail or wheel. */
static inline int64_t walk__walk(array_double_1d work, array_double_1d tables, int64_t side, array_double_1d state, int64_t node, int64_t direction, int64_t listing)
{
    int64_t scan;
    int64_t at;
    int64_t count;
    int64_t exponent;
    double gap_before;
    double mismatch_before;
    double abscissa_before;
    int64_t skipped;
    int64_t beside;
    double gap;
    double mismatch;
    double abscissa;
    double slope;
    scan = (int64_t)((*cspan_at(&tables, layout__TABLES_SCAN)));
    at = side + layout__SIDE_SEARCH_PLACE;
    count = (int64_t)((*cspan_at(&tables, scan + layout__SCAN_COUNT)));
    exponent = layout__EXPONENTS - INT64_C(1);
    gap_before = walk__LARGE_GAP;
    mismatch_before = 0.0;
    abscissa_before = 0.0;
    skipped = INT64_C(1);
    beside = INT64_C(0);
    while((node >= INT64_C(0)) && (node < count))
    {
        raster__node_gap(&gap, &mismatch, &abscissa, work, tables, at, node);
        (*cspan_at(&state, layout__STATE_GAP_COUNT)) += 1.0;
        if (gap__above_rail(tables, abscissa) == INT64_C(0))
        {
            if ((skipped == INT64_C(0)) && (beside == INT64_C(0)))
            {
                walk__search_end(work, tables, side, state, node - direction, direction, direction, listing);
            }
            if (raster__leaves_rail(work, tables, at, node, direction, abscissa) == INT64_C(1))
            {
                return INT64_C(0);
            }
            beside = INT64_C(1);
            skipped = INT64_C(0);
            exponent = INT64_C(0);
        }
        else
        {
            if (listing == INT64_C(0))
            {
                cells__keep_smaller(work, side, (*cspan_at(&tables, scan + layout__SCAN_NODES + layout__SCAN_NODE_SIZE * node + layout__SCAN_NODE_Y)), gap);
            }
            if (beside == INT64_C(1))
            {
                walk__search_end(work, tables, side, state, node, -direction, direction, listing);
            }
            else if (skipped == INT64_C(0))
            {
                if (direction > INT64_C(0))
                {
                    cells__write_cell(work, side + layout__SIDE_SEARCH_STACK, (*cspan_at(&tables, scan + layout__SCAN_NODES + layout__SCAN_NODE_SIZE * (node - INT64_C(1)) + layout__SCAN_NODE_Y)), (*cspan_at(&tables, scan + layout__SCAN_NODES + layout__SCAN_NODE_SIZE * node + layout__SCAN_NODE_Y)), gap_before, gap, mismatch_before, mismatch);
                    walk__search_between(work, tables, side, state, node - INT64_C(1), direction, abscissa_before, listing);
                }
                else
                {
                    cells__write_cell(work, side + layout__SIDE_SEARCH_STACK, (*cspan_at(&tables, scan + layout__SCAN_NODES + layout__SCAN_NODE_SIZE * node + layout__SCAN_NODE_Y)), (*cspan_at(&tables, scan + layout__SCAN_NODES + layout__SCAN_NODE_SIZE * (node + INT64_C(1)) + layout__SCAN_NODE_Y)), gap, gap_before, mismatch, mismatch_before);
                    walk__search_between(work, tables, side, state, node, direction, abscissa, listing);
                }
            }
            beside = INT64_C(0);
            gap_before = gap;
            mismatch_before = mismatch;
            abscissa_before = abscissa;
            slope = (double)(direction) * mismatch;
            if (listing == INT64_C(0))
            {
                exponent = bounds__clear_exponent(tables, work, scan, at, node, direction, abscissa, gap - (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST)), slope, exponent);
            }
            else
            {
                exponent = bounds__rising_exponent(tables, work, scan, at, node, direction, abscissa, gap - (*cspan_at(&work, side + layout__SIDE_SEARCH_REACH)), slope, exponent);
            }
            skipped = INT64_C(1);
            if (exponent < INT64_C(0))
            {
                exponent = INT64_C(0);
                skipped = INT64_C(0);
            }
        }
        node += direction * (INT64_C(1) << exponent);
        if ((beside == INT64_C(0)) && (exponent < layout__EXPONENTS - INT64_C(1)))
        {
            exponent += INT64_C(1);
        }
    }
    return INT64_C(0);
}

/* Search the first cell of the stack, which lies between ``node`` and the next one, if it
 * can hold what is asked for.
 *
 * abscissa : of ``node`` on the rail [m].
 */
static inline int64_t walk__search_between(array_double_1d work, array_double_1d tables, int64_t side, array_double_1d state, int64_t node, int64_t direction, double abscissa, int64_t listing)
{
    double least;
    double most;
    int64_t cell;
    double width;
    if (listing == INT64_C(1))
    {
        cells__list_cell(work, tables, side, state, node, direction, abscissa);
    }
    else
    {
        bounds__bend_bounds(&least, &most, tables, work, (int64_t)((*cspan_at(&tables, layout__TABLES_SCAN))), side + layout__SIDE_SEARCH_PLACE, node, abscissa);
        cell = side + layout__SIDE_SEARCH_STACK;
        width = (*cspan_at(&work, cell + layout__CELL_HIGH)) - (*cspan_at(&work, cell + layout__CELL_LOW));
        if (double_min(2, (*cspan_at(&work, cell + layout__CELL_GAP_LOW)), (*cspan_at(&work, cell + layout__CELL_GAP_HIGH))) - most * width * width / 8.0 < (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST)))
        {
            cells__search_cell(work, tables, side, state, least, most, (*cspan_at(&work, cell + layout__CELL_LOW)), (*cspan_at(&work, cell + layout__CELL_HIGH)));
        }
    }
    return INT64_C(0);
}

/* Search between ``node``, above the rail, and the end of the rail, which lies before the next node
 * ``outward`` (1 or -1).
 */
static inline int64_t walk__search_end(array_double_1d work, array_double_1d tables, int64_t side, array_double_1d state, int64_t node, int64_t outward, int64_t direction, int64_t listing)
{
    int64_t at;
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
    double gap;
    double mismatch;
    double abscissa;
    double beyond;
    double least;
    double most;
    at = side + layout__SIDE_SEARCH_PLACE;
    inner = (*cspan_at(&tables, (int64_t)((*cspan_at(&tables, layout__TABLES_SCAN))) + layout__SCAN_NODES + layout__SCAN_NODE_SIZE * node + layout__SCAN_NODE_Y));
    end = raster__above_rail_end(work, tables, at, node, outward);
    low = double_min(2, inner, end);
    high = double_max(2, inner, end);
    cell = node;
    if (outward < INT64_C(0))
    {
        cell = node - INT64_C(1);
    }
    if (low < high)
    {
        if (listing == INT64_C(1))
        {
            gap__vertical_gap(&gap_low, &mismatch_low, &rate, work, tables, at, low);
            gap__vertical_gap(&gap_high, &mismatch_high, &rate, work, tables, at, high);
            (*cspan_at(&state, layout__STATE_GAP_COUNT)) += 2.0;
            cells__write_cell(work, side + layout__SIDE_SEARCH_STACK, low, high, gap_low, gap_high, mismatch_low, mismatch_high);
            cells__list_cell(work, tables, side, state, cell, direction, raster__rail_below(work, tables, at, low));
        }
        else
        {
            raster__node_gap(&gap, &mismatch, &abscissa, work, tables, at, node);
            raster__node_gap(&gap, &mismatch, &beyond, work, tables, at, node + outward);
            if (beyond < abscissa)
            {
                abscissa = (*cspan_at(&tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))) + layout__PROFILE_START));
            }
            bounds__bend_bounds(&least, &most, tables, work, (int64_t)((*cspan_at(&tables, layout__TABLES_SCAN))), at, cell, abscissa);
            cells__search_cell(work, tables, side, state, -1.0, most, low, high);
        }
    }
    return INT64_C(0);
}
