/* Generated from search/smallest_gap.py by tools/transpile_kernel.py; change that one.
 *
 * The smallest vertical gap of one side, and the further local minima of the gap.
 *
 * The gap has up to three local minima (tread, flange root, flange) that exchange rank. From a known
 * place, or the best of a few nodes, the search walks outwards over the raster of the wheel. Whatever it
 * leaves out cannot hold a smaller gap, by the bounds of the gap's second derivative: so the global
 * minimum is bounded and not assumed.
 */

#include "smallest_gap.h"

/* Write the side's smallest gap and its abscissa to ``best`` and ``best_y``; 1 if there is one, else 0.
 *
 * With ``known`` = 1 the two, and ``best_rail``, already hold a local minimum of this pose, and only a
 * smaller one is looked for.
 */
static inline int64_t smallest_gap__search_side(array_double_1d work, array_double_1d tables, int64_t side, array_double_1d state, int64_t known)
{
    int64_t scan;
    int64_t at;
    int64_t cell;
    int64_t ahead;
    int64_t behind;
    int64_t node;
    double gap;
    double mismatch;
    double abscissa;
    scan = (int64_t)((*cspan_at(&tables, layout__TABLES_SCAN)));
    at = side + layout__SIDE_SEARCH_PLACE;
    (*cspan_at(&state, layout__STATE_SCAN_COUNT)) += 1.0;
    if (known == INT64_C(1))
    {
        cell = raster__node_below(tables, scan, (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST_Y)));
        ahead = bounds__rising_from_minimum(tables, work, scan, at, (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST_Y)), INT64_C(1), (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST_RAIL)));
        behind = bounds__rising_from_minimum(tables, work, scan, at, (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST_Y)), -INT64_C(1), (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST_RAIL)));
        if ((ahead >= INT64_C(0)) && (behind >= INT64_C(0)))
        {
            walk__walk(work, tables, side, state, cell + (INT64_C(1) << ahead), INT64_C(1), INT64_C(0));
            walk__walk(work, tables, side, state, cell + INT64_C(1) - (INT64_C(1) << behind), -INT64_C(1), INT64_C(0));
            return INT64_C(1);
        }
        node = cell;
        raster__node_gap(&gap, &mismatch, &abscissa, work, tables, at, node);
        if (gap__above_rail(tables, abscissa) == INT64_C(0))
        {
            node = cell + INT64_C(1);
        }
    }
    else
    {
        (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST)) = walk__LARGE_GAP;
        node = smallest_gap__best_node(work, tables, side, state, smallest_gap__PROBE_STRIDE);
        if (node < INT64_C(0))
        {
            node = smallest_gap__best_node(work, tables, side, state, INT64_C(1));
        }
        if (node < INT64_C(0))
        {
            return INT64_C(0);
        }
    }
    walk__walk(work, tables, side, state, node, INT64_C(1), INT64_C(0));
    walk__walk(work, tables, side, state, node, -INT64_C(1), INT64_C(0));
    return INT64_C(1);
}

/* The node with the smallest gap among every ``stride``-th one above the rail, which becomes the best
 * known; -1 if there is none.
 */
static inline int64_t smallest_gap__best_node(array_double_1d work, array_double_1d tables, int64_t side, array_double_1d state, int64_t stride)
{
    int64_t scan;
    int64_t at;
    int64_t node;
    double gap;
    double mismatch;
    double abscissa;
    int64_t found;
    scan = (int64_t)((*cspan_at(&tables, layout__TABLES_SCAN)));
    at = side + layout__SIDE_SEARCH_PLACE;
    found = -INT64_C(1);
    node = INT64_C(0);
    while(node < (int64_t)((*cspan_at(&tables, scan + layout__SCAN_COUNT))))
    {
        raster__node_gap(&gap, &mismatch, &abscissa, work, tables, at, node);
        (*cspan_at(&state, layout__STATE_GAP_COUNT)) += 1.0;
        if (gap__above_rail(tables, abscissa) == INT64_C(1))
        {
            if (gap < (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST)))
            {
                (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST)) = gap;
                (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST_Y)) = (*cspan_at(&tables, scan + layout__SCAN_NODES + layout__SCAN_NODE_SIZE * node + layout__SCAN_NODE_Y));
                found = node;
            }
        }
        else if ((found >= INT64_C(0)) && (raster__leaves_rail(work, tables, at, node, INT64_C(1), abscissa) == INT64_C(1)))
        {
            return found;
        }
        node += stride;
    }
    return found;
}

/* List the local minima of the gap below ``reach`` [m] other than the known smallest one, which lies at
 * ``abscissa`` on the rail [m]: the candidates ``first`` ... ``last`` of the side.
 */
static inline int64_t smallest_gap__list_minima(array_double_1d work, array_double_1d tables, int64_t side, array_double_1d state, double reach, double abscissa)
{
    int64_t scan;
    int64_t cell;
    int64_t ahead;
    int64_t behind;
    scan = (int64_t)((*cspan_at(&tables, layout__TABLES_SCAN)));
    cell = raster__node_below(tables, scan, (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST_Y)));
    (*cspan_at(&work, side + layout__SIDE_SEARCH_REACH)) = reach;
    (*cspan_at(&work, side + layout__SIDE_SEARCH_FIRST)) = (double)(layout__CANDIDATES);
    (*cspan_at(&work, side + layout__SIDE_SEARCH_LAST)) = (double)(layout__CANDIDATES - INT64_C(1));
    ahead = bounds__rising_from_minimum(tables, work, scan, side + layout__SIDE_SEARCH_PLACE, (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST_Y)), INT64_C(1), abscissa);
    if (ahead < INT64_C(0))
    {
        ahead = INT64_C(0);
    }
    walk__walk(work, tables, side, state, cell + (INT64_C(1) << ahead), INT64_C(1), INT64_C(1));
    behind = bounds__rising_from_minimum(tables, work, scan, side + layout__SIDE_SEARCH_PLACE, (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST_Y)), -INT64_C(1), abscissa);
    if (behind < INT64_C(0))
    {
        behind = INT64_C(0);
    }
    walk__walk(work, tables, side, state, cell + INT64_C(1) - (INT64_C(1) << behind), -INT64_C(1), INT64_C(1));
    return INT64_C(0);
}
