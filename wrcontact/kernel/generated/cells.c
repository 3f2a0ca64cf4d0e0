/* Generated from search/cells.py by tools/transpile_kernel.py; change that one.
 *
 * Local minima of the gap inside one cell of the raster, or inside the part of it that is above the rail.
 *
 * A cell that could hold a minimum is halved until that is settled. The gap between both ends lies above its
 * chord by no less than -M h^2 / 8, where M bounds its second derivative from above. Two loops do this, since
 * they ask for different things: ``search_cell`` for any value below the smallest gap, which narrows as it goes,
 * also at ends; ``list_cell`` for all minima below a fixed reach, in their order, each of them once.
 */

#include "cells.h"

/* Fill in a cell that waits to be searched. */
static inline int64_t cells__write_cell(array_double_1d work, int64_t cell, double low, double high, double gap_low, double gap_high, double mismatch_low, double mismatch_high)
{
    (*cspan_at(&work, cell + layout__CELL_LOW)) = low;
    (*cspan_at(&work, cell + layout__CELL_HIGH)) = high;
    (*cspan_at(&work, cell + layout__CELL_GAP_LOW)) = gap_low;
    (*cspan_at(&work, cell + layout__CELL_GAP_HIGH)) = gap_high;
    (*cspan_at(&work, cell + layout__CELL_MISMATCH_LOW)) = mismatch_low;
    (*cspan_at(&work, cell + layout__CELL_MISMATCH_HIGH)) = mismatch_high;
    return INT64_C(0);
}

/* Abscissae, gaps [m] and mismatches [-] at both ends of a cell. */
static inline int64_t cells__cell_ends(double* result_0, double* result_1, double* result_2, double* result_3, double* result_4, double* result_5, array_double_1d work, int64_t cell)
{
    (*result_0) = (*cspan_at(&work, cell + layout__CELL_LOW));
    (*result_1) = (*cspan_at(&work, cell + layout__CELL_HIGH));
    (*result_2) = (*cspan_at(&work, cell + layout__CELL_GAP_LOW));
    (*result_3) = (*cspan_at(&work, cell + layout__CELL_GAP_HIGH));
    (*result_4) = (*cspan_at(&work, cell + layout__CELL_MISMATCH_LOW));
    (*result_5) = (*cspan_at(&work, cell + layout__CELL_MISMATCH_HIGH));
    return 0;
}

/* Keep the smallest gap between ``first`` and ``last`` [m] if it is the side's smallest: halve
 * while a smaller one is possible, refine where the slope turns. ``least`` and ``most`` bound the
 * second derivative [1/m].
 */
static inline int64_t cells__search_cell(array_double_1d work, array_double_1d tables, int64_t side, array_double_1d state, double least, double most, double first, double last)
{
    int64_t at;
    double gap_low;
    double mismatch_low;
    double rate;
    double gap_high;
    double mismatch_high;
    int64_t depth;
    int64_t cell;
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
    at = side + layout__SIDE_SEARCH_PLACE;
    gap__vertical_gap(&gap_low, &mismatch_low, &rate, work, tables, at, first);
    gap__vertical_gap(&gap_high, &mismatch_high, &rate, work, tables, at, last);
    (*cspan_at(&state, layout__STATE_GAP_COUNT)) += 2.0;
    cells__write_cell(work, side + layout__SIDE_SEARCH_STACK, first, last, gap_low, gap_high, mismatch_low, mismatch_high);
    depth = INT64_C(1);
    while(depth > INT64_C(0))
    {
        depth -= INT64_C(1);
        cell = side + layout__SIDE_SEARCH_STACK + layout__CELL_SIZE * depth;
        cells__cell_ends(&low, &high, &gap_low, &gap_high, &mismatch_low, &mismatch_high, work, cell);
        width = high - low;
        lowest = gap_low;
        cells__keep_smaller(work, side, low, gap_low);
        if (gap_high < gap_low)
        {
            lowest = gap_high;
            cells__keep_smaller(work, side, high, gap_high);
        }
        if (lowest - most * width * width / 8.0 < (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST)))
        {
            folded = (mismatch_low == gap__FOLDED) || (mismatch_high == gap__FOLDED);
            turns = (mismatch_low < 0.0) && (mismatch_high >= 0.0) && (!folded);
            steady = (bounds__only_rises_or_falls(least, most, width, mismatch_low, mismatch_high) == INT64_C(1)) && (!folded);
            if (turns && ((least > 0.0) || (width <= cells__NARROW)))
            {
                cells__refine_minimum(&y, &gap, work, tables, at, state, cell, cells__SHARP);
                cells__keep_refined(work, side, y, gap, width);
            }
            else if ((width > cells__NARROW) && (!steady) && (folded || (!(least > 0.0))))
            {
                middle = 0.5 * (low + high);
                gap__vertical_gap(&gap, &mismatch, &rate, work, tables, at, middle);
                (*cspan_at(&state, layout__STATE_GAP_COUNT)) += 1.0;
                cells__write_cell(work, side + layout__SIDE_SEARCH_STACK + layout__CELL_SIZE * (depth + INT64_C(1)), middle, high, gap, gap_high, mismatch, mismatch_high);
                cells__write_cell(work, cell, low, middle, gap_low, gap, mismatch_low, mismatch);
                depth += INT64_C(2);
            }
        }
    }
    return INT64_C(0);
}

/* List the local minima below ``side.reach`` in the first cell of the stack, which lies between
 * ``node`` and the next one.
 *
 * abscissa : of its lower end on the rail [m].
 */
static inline int64_t cells__list_cell(array_double_1d work, array_double_1d tables, int64_t side, array_double_1d state, int64_t node, int64_t direction, double abscissa)
{
    int64_t at;
    int64_t scan;
    int64_t first;
    double nothing;
    double most;
    double least;
    double stretch;
    double gap_low;
    double mismatch_low;
    double rate;
    double gap_high;
    double mismatch_high;
    int64_t depth;
    int64_t cell;
    double low;
    double high;
    double width;
    bool folded;
    bool turns;
    double y;
    double gap;
    double middle;
    double mismatch;
    int64_t other;
    at = side + layout__SIDE_SEARCH_PLACE;
    scan = (int64_t)((*cspan_at(&tables, layout__TABLES_SCAN)));
    first = side + layout__SIDE_SEARCH_STACK;
    bounds__bend_bounds(&nothing, &most, tables, work, scan, at, node, abscissa);
    bounds__least_bend(&least, &stretch, tables, work, scan, at, node, INT64_C(0), (*cspan_at(&work, first + layout__CELL_HIGH)) - (*cspan_at(&work, first + layout__CELL_LOW)), bounds__rail_place(tables, scan, abscissa));
    if (!(stretch < bounds__WIDEST))
    {
        /* the outline may be folded there */
        least = nothing;
        gap__vertical_gap(&gap_low, &mismatch_low, &rate, work, tables, at, (*cspan_at(&work, first + layout__CELL_LOW)));
        gap__vertical_gap(&gap_high, &mismatch_high, &rate, work, tables, at, (*cspan_at(&work, first + layout__CELL_HIGH)));
        (*cspan_at(&state, layout__STATE_GAP_COUNT)) += 2.0;
        cells__write_cell(work, first, (*cspan_at(&work, first + layout__CELL_LOW)), (*cspan_at(&work, first + layout__CELL_HIGH)), gap_low, gap_high, mismatch_low, mismatch_high);
    }
    depth = INT64_C(1);
    while(depth > INT64_C(0))
    {
        depth -= INT64_C(1);
        cell = side + layout__SIDE_SEARCH_STACK + layout__CELL_SIZE * depth;
        cells__cell_ends(&low, &high, &gap_low, &gap_high, &mismatch_low, &mismatch_high, work, cell);
        width = high - low;
        if (double_min(2, gap_low, gap_high) - most * width * width / 8.0 < (*cspan_at(&work, side + layout__SIDE_SEARCH_REACH)))
        {
            folded = (mismatch_low == gap__FOLDED) || (mismatch_high == gap__FOLDED);
            turns = (mismatch_low < 0.0) && (mismatch_high >= 0.0) && (!folded);
            if (turns && ((least > 0.0) || (width <= cells__LISTED_ONE)))
            {
                cells__refine_minimum(&y, &gap, work, tables, at, state, cell, cells__LISTED_SHARP);
                if (gap < (*cspan_at(&work, side + layout__SIDE_SEARCH_REACH)))
                {
                    cells__list_minimum(work, side, y, raster__rail_below(work, tables, at, y), direction);
                }
            }
            else if ((width > cells__NARROW) && (folded || (bounds__only_rises_or_falls(least, most, width, mismatch_low, mismatch_high) == INT64_C(0))))
            {
                middle = 0.5 * (low + high);
                gap__vertical_gap(&gap, &mismatch, &rate, work, tables, at, middle);
                (*cspan_at(&state, layout__STATE_GAP_COUNT)) += 1.0;
                /* the one that comes first in ``direction`` on top */
                other = side + layout__SIDE_SEARCH_STACK + layout__CELL_SIZE * (depth + INT64_C(1));
                if (direction > INT64_C(0))
                {
                    cells__write_cell(work, cell, middle, high, gap, gap_high, mismatch, mismatch_high);
                    cells__write_cell(work, other, low, middle, gap_low, gap, mismatch_low, mismatch);
                }
                else
                {
                    cells__write_cell(work, cell, low, middle, gap_low, gap, mismatch_low, mismatch);
                    cells__write_cell(work, other, middle, high, gap, gap_high, mismatch, mismatch_high);
                }
                depth += INT64_C(2);
            }
        }
    }
    return INT64_C(0);
}

/* Add the minimum at ``y`` [m] to the candidates, at the end for ``direction`` =
 * 1, else at the beginning.
 */
static inline int64_t cells__list_minimum(array_double_1d work, int64_t side, double y, double abscissa, int64_t direction)
{
    int64_t entry;
    int64_t candidate;
    entry = (int64_t)((*cspan_at(&work, side + layout__SIDE_SEARCH_LAST))) + INT64_C(1);
    if (direction < INT64_C(0))
    {
        entry = (int64_t)((*cspan_at(&work, side + layout__SIDE_SEARCH_FIRST))) - INT64_C(1);
    }
    if ((entry >= INT64_C(0)) && (entry < INT64_C(2) * layout__CANDIDATES))
    {
        candidate = side + layout__SIDE_SEARCH_CANDIDATES + layout__CANDIDATE_SIZE * entry;
        (*cspan_at(&work, candidate + layout__CANDIDATE_Y)) = y;
        (*cspan_at(&work, candidate + layout__CANDIDATE_RAIL)) = abscissa;
        if (direction < INT64_C(0))
        {
            (*cspan_at(&work, side + layout__SIDE_SEARCH_FIRST)) = (double)(entry);
        }
        else
        {
            (*cspan_at(&work, side + layout__SIDE_SEARCH_LAST)) = (double)(entry);
        }
    }
    return INT64_C(0);
}

/* Keep (y, gap) if it is the side's smallest so far, by more than rounding: a
 * node beside a contact is none.
 */
static inline int64_t cells__keep_smaller(array_double_1d work, int64_t side, double y, double gap)
{
    if (gap < (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST)) - cells__ROUNDING)
    {
        (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST)) = gap;
        (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST_Y)) = y;
    }
    return INT64_C(0);
}

/* Keep (y, gap), a place of contact, if it is the side's smallest so far: rather than a node within
 * ``width`` [m] that has the same gap but for the last bits.
 */
static inline int64_t cells__keep_refined(array_double_1d work, int64_t side, double y, double gap, double width)
{
    double allowed;
    allowed = (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST));
    if (fabs(y - (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST_Y))) < width)
    {
        allowed += cells__ROUNDING;
    }
    if (gap < allowed)
    {
        (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST)) = gap;
        (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST_Y)) = y;
    }
    return INT64_C(0);
}

/* Abscissa [m], to ``sharp`` [m], and gap [m] where the slope difference vanishes in a cell:
 * bracketed Newton's method.
 */
static inline int64_t cells__refine_minimum(double* y, double* gap, array_double_1d work, array_double_1d tables, int64_t at, array_double_1d state, int64_t cell, double sharp)
{
    double low;
    double high;
    int64_t i;
    double mismatch;
    double rate;
    double following;
    double move;
    low = (*cspan_at(&work, cell + layout__CELL_LOW));
    high = (*cspan_at(&work, cell + layout__CELL_HIGH));
    (*y) = low - (*cspan_at(&work, cell + layout__CELL_MISMATCH_LOW)) * (high - low) / ((*cspan_at(&work, cell + layout__CELL_MISMATCH_HIGH)) - (*cspan_at(&work, cell + layout__CELL_MISMATCH_LOW)));
    (*gap) = 0.0;
    for (i = INT64_C(0); i < cells__REFINEMENTS; i += INT64_C(1))
    {
        gap__vertical_gap(gap, &mismatch, &rate, work, tables, at, (*y));
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
