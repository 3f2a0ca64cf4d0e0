/* Generated from search.py by tools/transpile_kernel.py; change that one.
 *
 * The smallest vertical gap of one side: scan, bound, refine.
 *
 * The gap has up to three local minima (tread, flange root, flange) that exchange rank.  The scan nodes lie on a fixed
 * raster of the wheel profile; between two nodes the gap lies above its chord by no less than -M h^2 / 8, where M bounds
 * its second derivative.  Every cell that could hold a value within MARGIN of the best is searched, so the global minimum
 * is bounded and not assumed.
 */

#include "search.h"

/* Gap and slope difference at all scan nodes above the rail; 1 if there are at least two, else 0. */
static int64_t search__scan_side(array_double_1d tables, array_double_1d work, int64_t side, array_double_1d place, int64_t at, array_double_1d state)
{
    int64_t scan;
    int64_t rail;
    int64_t count;
    int64_t first;
    int64_t last;
    double best;
    int64_t i;
    int64_t row;
    double y;
    double y_track;
    double z_track;
    double outline_slope;
    double abscissa;
    double gap;
    double mismatch;
    double z_rail;
    double rail_slope;
    int64_t found;
    scan = (int64_t)((*cspan_at(&tables, layout__SET_SCAN)));
    rail = (int64_t)((*cspan_at(&tables, layout__SET_RAIL)));
    count = (int64_t)((*cspan_at(&tables, scan + search__SCAN_COUNT)));
    first = -INT64_C(1);
    last = -INT64_C(1);
    best = search__LARGE_GAP;
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        row = scan + search__SCAN_NODES + search__SCAN_ROW * i;
        y = (*cspan_at(&tables, scan + search__SCAN_START)) + (*cspan_at(&tables, scan + search__SCAN_STEP)) * (double)(i);
        locus__outline_point(&y_track, &z_track, &outline_slope, place, at, y, (*cspan_at(&tables, row)), (*cspan_at(&tables, row + INT64_C(1))));
        abscissa = y_track - (*cspan_at(&tables, layout__SET_RAIL_Y));
        gap = search__LARGE_GAP;
        mismatch = 0.0;
        if (gap__above_rail(tables, abscissa) == INT64_C(1))
        {
            profile_table__height_slope(&z_rail, &rail_slope, tables, rail, abscissa);
            gap = z_rail - z_track;
            mismatch = rail_slope - outline_slope;
            if (first < INT64_C(0))
            {
                first = i;
            }
            last = i;
            if (gap < best)
            {
                best = gap;
                (*cspan_at(&work, side + layout__SIDE_BEST_Y)) = y;
            }
        }
        (*cspan_at(&work, side + layout__SIDE_GAP + i)) = gap;
        (*cspan_at(&work, side + layout__SIDE_MISMATCH + i)) = mismatch;
        (*cspan_at(&work, side + layout__SIDE_ABSCISSA + i)) = abscissa;
    }
    (*cspan_at(&work, side + layout__SIDE_FIRST)) = (double)(first);
    (*cspan_at(&work, side + layout__SIDE_LAST)) = (double)(last);
    (*cspan_at(&work, side + layout__SIDE_BEST)) = best;
    (*cspan_at(&work, side + layout__SIDE_MINIMUM_COUNT)) = 0.0;
    (*cspan_at(&state, layout__STATE_GAP_COUNT)) += (double)(last - first + INT64_C(1));
    (*cspan_at(&state, layout__STATE_SCAN_COUNT)) += 1.0;
    found = INT64_C(0);
    if (last > first)
    {
        found = INT64_C(1);
    }
    return found;
}

/* Bound M [1/m] on the gap's second derivative between scan nodes ``cell`` and ``cell`` + 1.
 *
 * Rail minus wheel; 1.3 covers what yaw and roll change in either (6 deg of yaw change a slope's rate by less).
 */
static double search__largest_bend(array_double_1d tables, array_double_1d work, int64_t side, int64_t cell)
{
    int64_t scan;
    double u;
    double rail_bend;
    double wheel_bend;
    double bound;
    scan = (int64_t)((*cspan_at(&tables, layout__SET_SCAN)));
    u = ((*cspan_at(&work, side + layout__SIDE_ABSCISSA + cell)) - (*cspan_at(&tables, scan + search__SCAN_RAIL_START))) / (*cspan_at(&tables, scan + search__SCAN_RAIL_STEP));
    if (!(u > 0.0))
    {
        u = 0.0;
    }
    if (u > (*cspan_at(&tables, scan + search__SCAN_RAIL_COUNT)) - 1.0)
    {
        u = (*cspan_at(&tables, scan + search__SCAN_RAIL_COUNT)) - 1.0;
    }
    rail_bend = (*cspan_at(&tables, scan + (int64_t)((*cspan_at(&tables, scan + search__SCAN_RAIL_OFFSET))) + (int64_t)(u)));
    wheel_bend = (*cspan_at(&tables, scan + search__SCAN_NODES + search__SCAN_ROW * cell + INT64_C(2)));
    bound = 1.3 * rail_bend;
    if (wheel_bend > 0.0)
    {
        bound -= 0.7 * wheel_bend;
    }
    else
    {
        bound -= 1.3 * wheel_bend;
    }
    if (!(bound > 0.0))
    {
        bound = 0.0;
    }
    return bound;
}

/* All local minima within MARGIN of the smallest gap, into the side's list; the smallest into SIDE_BEST. */
static int64_t search__find_minima(array_double_1d tables, array_double_1d work, int64_t side, array_double_1d place, int64_t at, array_double_1d state)
{
    int64_t scan;
    double step;
    int64_t first;
    int64_t last;
    int64_t i;
    double bend;
    double lowest;
    double low;
    scan = (int64_t)((*cspan_at(&tables, layout__SET_SCAN)));
    step = (*cspan_at(&tables, scan + search__SCAN_STEP));
    first = (int64_t)((*cspan_at(&work, side + layout__SIDE_FIRST)));
    last = (int64_t)((*cspan_at(&work, side + layout__SIDE_LAST)));
    for (i = first; i < last; i += INT64_C(1))
    {
        bend = search__largest_bend(tables, work, side, i);
        lowest = (*cspan_at(&work, side + layout__SIDE_GAP + i));
        if ((*cspan_at(&work, side + layout__SIDE_GAP + i + INT64_C(1))) < lowest)
        {
            lowest = (*cspan_at(&work, side + layout__SIDE_GAP + i + INT64_C(1)));
        }
        if (lowest - bend * step * step / 8.0 < (*cspan_at(&work, side + layout__SIDE_BEST)) + search__MARGIN)
        {
            low = (*cspan_at(&tables, scan + search__SCAN_START)) + step * (double)(i);
            search__search_cell(tables, work, side, place, at, state, bend, low, low + step, (*cspan_at(&work, side + layout__SIDE_GAP + i)), (*cspan_at(&work, side + layout__SIDE_GAP + i + INT64_C(1))), (*cspan_at(&work, side + layout__SIDE_MISMATCH + i)), (*cspan_at(&work, side + layout__SIDE_MISMATCH + i + INT64_C(1))));
        }
    }
    if (((*cspan_at(&work, side + layout__SIDE_MISMATCH + first)) > 0.0) && (first > INT64_C(0)))
    {
        search__search_end(tables, work, side, place, at, state, first, -INT64_C(1));
    }
    if (((*cspan_at(&work, side + layout__SIDE_MISMATCH + last)) < 0.0) && (last + INT64_C(1) < (int64_t)((*cspan_at(&tables, scan + search__SCAN_COUNT)))))
    {
        search__search_end(tables, work, side, place, at, state, last, INT64_C(1));
    }
    return INT64_C(0);
}

/* Search between scan node ``node``, where the gap falls outwards, and the end of the rail beyond it. */
static int64_t search__search_end(array_double_1d tables, array_double_1d work, int64_t side, array_double_1d place, int64_t at, array_double_1d state, int64_t node, int64_t outward)
{
    int64_t scan;
    double inner;
    double inside;
    double outside;
    double middle;
    double z;
    double slope;
    double y_track;
    double z_track;
    double outline_slope;
    double gap;
    double mismatch;
    double rate;
    int64_t cell;
    double bend;
    scan = (int64_t)((*cspan_at(&tables, layout__SET_SCAN)));
    inner = (*cspan_at(&tables, scan + search__SCAN_START)) + (*cspan_at(&tables, scan + search__SCAN_STEP)) * (double)(node);
    inside = inner;
    outside = inner + (*cspan_at(&tables, scan + search__SCAN_STEP)) * (double)(outward);
    while(fabs(outside - inside) > search__END_SHARP)
    {
        middle = 0.5 * (inside + outside);
        profile_table__height_slope(&z, &slope, tables, (int64_t)((*cspan_at(&tables, layout__SET_WHEEL))), middle);
        locus__outline_point(&y_track, &z_track, &outline_slope, place, at, middle, z, slope);
        if (gap__above_rail(tables, y_track - (*cspan_at(&tables, layout__SET_RAIL_Y))) == INT64_C(1))
        {
            inside = middle;
        }
        else
        {
            outside = middle;
        }
    }
    gap__vertical_gap(&gap, &mismatch, &rate, tables, place, at, inside);
    (*cspan_at(&state, layout__STATE_GAP_COUNT)) += 1.0;
    cell = node;
    if (outward < INT64_C(0))
    {
        cell = node - INT64_C(1);
    }
    bend = search__largest_bend(tables, work, side, cell);
    if (inside < inner)
    {
        search__search_cell(tables, work, side, place, at, state, bend, inside, inner, gap, (*cspan_at(&work, side + layout__SIDE_GAP + node)), mismatch, (*cspan_at(&work, side + layout__SIDE_MISMATCH + node)));
    }
    else if (inside > inner)
    {
        search__search_cell(tables, work, side, place, at, state, bend, inner, inside, (*cspan_at(&work, side + layout__SIDE_GAP + node)), gap, (*cspan_at(&work, side + layout__SIDE_MISMATCH + node)), mismatch);
    }
    return INT64_C(0);
}

/* Local minima in a cell: halve while the bound allows a better value, refine where the slope turns. */
static int64_t search__search_cell(array_double_1d tables, array_double_1d work, int64_t side, array_double_1d place, int64_t at, array_double_1d state, double bend, double first, double last, double gap_first, double gap_last, double mismatch_first, double mismatch_last)
{
    int64_t stack;
    int64_t depth;
    int64_t top;
    double low;
    double high;
    double gap_low;
    double gap_high;
    double mismatch_low;
    double mismatch_high;
    double width;
    double lowest;
    double y;
    double gap;
    double middle;
    double mismatch;
    double rate;
    stack = side + layout__SIDE_STACK;
    (*cspan_at(&work, stack)) = first;
    (*cspan_at(&work, stack + INT64_C(1))) = last;
    (*cspan_at(&work, stack + INT64_C(2))) = gap_first;
    (*cspan_at(&work, stack + INT64_C(3))) = gap_last;
    (*cspan_at(&work, stack + INT64_C(4))) = mismatch_first;
    (*cspan_at(&work, stack + INT64_C(5))) = mismatch_last;
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
        if (gap_high < gap_low)
        {
            lowest = gap_high;
        }
        if (lowest - bend * width * width / 8.0 < (*cspan_at(&work, side + layout__SIDE_BEST)) + search__MARGIN)
        {
            if ((mismatch_low < 0.0) && (mismatch_high >= 0.0))
            {
                search__refine_minimum(&y, &gap, tables, place, at, state, low, high, mismatch_low, mismatch_high);
                search__keep_minimum(work, side, y, gap);
            }
            else if (width > search__NARROW)
            {
                middle = 0.5 * (low + high);
                gap__vertical_gap(&gap, &mismatch, &rate, tables, place, at, middle);
                (*cspan_at(&state, layout__STATE_GAP_COUNT)) += 1.0;
                if (gap < (*cspan_at(&work, side + layout__SIDE_BEST)))
                {
                    (*cspan_at(&work, side + layout__SIDE_BEST)) = gap;
                    (*cspan_at(&work, side + layout__SIDE_BEST_Y)) = middle;
                }
                (*cspan_at(&work, top)) = low;
                (*cspan_at(&work, top + INT64_C(1))) = middle;
                (*cspan_at(&work, top + INT64_C(2))) = gap_low;
                (*cspan_at(&work, top + INT64_C(3))) = gap;
                (*cspan_at(&work, top + INT64_C(4))) = mismatch_low;
                (*cspan_at(&work, top + INT64_C(5))) = mismatch;
                (*cspan_at(&work, top + INT64_C(6))) = middle;
                (*cspan_at(&work, top + INT64_C(7))) = high;
                (*cspan_at(&work, top + INT64_C(8))) = gap;
                (*cspan_at(&work, top + INT64_C(9))) = gap_high;
                (*cspan_at(&work, top + INT64_C(10))) = mismatch;
                (*cspan_at(&work, top + INT64_C(11))) = mismatch_high;
                depth += INT64_C(2);
            }
        }
    }
    return INT64_C(0);
}

/* Abscissa [m] and gap [m] where the slope difference vanishes between ``low`` and ``high``: bracketed Newton. */
static int64_t search__refine_minimum(double* y, double* gap, array_double_1d tables, array_double_1d place, int64_t at, array_double_1d state, double low, double high, double mismatch_low, double mismatch_high)
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
        gap__vertical_gap(gap, &mismatch, &rate, tables, place, at, (*y));
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
            if (fabs(move) < search__SHARP)
            {
                break;
            }
            if (((*y) + move > low) && ((*y) + move < high))
            {
                following = (*y) + move;
            }
        }
        if (fabs(following - (*y)) < search__SHARP)
        {
            break;
        }
        (*y) = following;
    }
    return 0;
}

/* Add a local minimum to the side's list, in place of the worst one when it is full. */
static int64_t search__keep_minimum(array_double_1d work, int64_t side, double y, double gap)
{
    int64_t count;
    int64_t slot;
    int64_t i;
    count = (int64_t)((*cspan_at(&work, side + layout__SIDE_MINIMUM_COUNT)));
    slot = count;
    if (count == layout__MINIMUM_LIMIT)
    {
        slot = INT64_C(0);
        for (i = INT64_C(1); i < layout__MINIMUM_LIMIT; i += INT64_C(1))
        {
            if ((*cspan_at(&work, side + layout__SIDE_MINIMUM_GAP + i)) > (*cspan_at(&work, side + layout__SIDE_MINIMUM_GAP + slot)))
            {
                slot = i;
            }
        }
    }
    else
    {
        (*cspan_at(&work, side + layout__SIDE_MINIMUM_COUNT)) = (double)(count + INT64_C(1));
    }
    if ((count < layout__MINIMUM_LIMIT) || (gap < (*cspan_at(&work, side + layout__SIDE_MINIMUM_GAP + slot))))
    {
        (*cspan_at(&work, side + layout__SIDE_MINIMUM_Y + slot)) = y;
        (*cspan_at(&work, side + layout__SIDE_MINIMUM_GAP + slot)) = gap;
    }
    if (gap <= (*cspan_at(&work, side + layout__SIDE_BEST)))
    {
        (*cspan_at(&work, side + layout__SIDE_BEST)) = gap;
        (*cspan_at(&work, side + layout__SIDE_BEST_Y)) = y;
    }
    return INT64_C(0);
}

/* Refine the listed minima after a small change of roll; the smallest goes into SIDE_BEST.
 *
 * 1 if all were found again close by, else 0: between nearly conformal profiles a minimum can run away or vanish, and
 * the side must be scanned anew.
 */
static int64_t search__follow_minima(array_double_1d tables, array_double_1d work, int64_t side, array_double_1d place, int64_t at, array_double_1d state)
{
    double best;
    int64_t i_end;
    int64_t i;
    double y;
    int64_t met;
    int64_t k;
    double gap;
    double mismatch;
    double rate;
    double move;
    if ((*cspan_at(&work, side + layout__SIDE_MINIMUM_COUNT)) < 1.0)
    {
        return INT64_C(0);
    }
    best = search__LARGE_GAP;
    i_end = (int64_t)((*cspan_at(&work, side + layout__SIDE_MINIMUM_COUNT)));
    for (i = INT64_C(0); i < i_end; i += INT64_C(1))
    {
        y = (*cspan_at(&work, side + layout__SIDE_MINIMUM_Y + i));
        met = INT64_C(0);
        for (k = INT64_C(0); k < search__FOLLOW_ITERATIONS; k += INT64_C(1))
        {
            gap__vertical_gap(&gap, &mismatch, &rate, tables, place, at, y);
            (*cspan_at(&state, layout__STATE_GAP_COUNT)) += 1.0;
            if (!(rate > 0.0))
            {
                return INT64_C(0);
            }
            move = (-mismatch) / rate;
            if (fabs(move) < search__SHARP)
            {
                met = INT64_C(1);
                break;
            }
            if (fabs(move) > search__LONGEST_MOVE)
            {
                return INT64_C(0);
            }
            y += move;
        }
        if (met == INT64_C(0))
        {
            return INT64_C(0);
        }
        (*cspan_at(&work, side + layout__SIDE_MINIMUM_Y + i)) = y;
        (*cspan_at(&work, side + layout__SIDE_MINIMUM_GAP + i)) = gap;
        if (gap < best)
        {
            best = gap;
            (*cspan_at(&work, side + layout__SIDE_BEST)) = gap;
            (*cspan_at(&work, side + layout__SIDE_BEST_Y)) = y;
        }
    }
    return INT64_C(1);
}
