/* Generated from search.py by tools/transpile_kernel.py; change that one.
 *
 * The smallest vertical gap of one side: scan, bound, refine.
 *
 * The gap has up to three local minima (tread, flange root, flange) that exchange rank.  The scan nodes lie on a fixed
 * raster of the wheel profile.  Between two nodes the gap lies above its chord by no less than -M h^2 / 8, where M bounds
 * its second derivative from above; where a lower bound of the second derivative is positive the cell is convex and holds
 * one minimum at most.  Cells that could hold a value below the best one known are halved until neither is left open, so
 * the global minimum is bounded and not assumed.
 */

#include "search.h"

/* Gap and rail abscissa at all scan nodes above the rail; the node with the smallest gap, -1 if there are not two. */
static int64_t search__scan_side(array_double_1d tables, array_double_1d work, int64_t side, array_double_1d place, int64_t at, array_double_1d state)
{
    int64_t scan;
    int64_t rail;
    double start;
    double stop;
    double lead;
    int64_t first;
    int64_t last;
    double best;
    int64_t i_end;
    int64_t i;
    int64_t row;
    double y_track;
    double z_track;
    double outline_slope;
    double abscissa;
    int64_t piece;
    double u;
    double height;
    double gap;
    int64_t node;
    scan = (int64_t)((*cspan_at(&tables, layout__SET_SCAN)));
    rail = (int64_t)((*cspan_at(&tables, layout__SET_RAIL)));
    start = (*cspan_at(&tables, rail + profile_table__START));
    stop = (*cspan_at(&tables, rail + profile_table__STOP));
    lead = (*cspan_at(&tables, layout__SET_RAIL_Y)) + start - (*cspan_at(&place, at + locus__PLACE_SHIFT)) - (*cspan_at(&place, at + locus__PLACE_ARM)) - search__SCAN_LEAD;
    first = -INT64_C(1);
    last = -INT64_C(1);
    node = -INT64_C(1);
    best = search__LARGE_GAP;
    i_end = (int64_t)((*cspan_at(&tables, scan + search__SCAN_COUNT)));
    for (i = INT64_C(0); i < i_end; i += INT64_C(1))
    {
        row = scan + search__SCAN_NODES + search__SCAN_ROW * i;
        if ((*cspan_at(&tables, row + search__ROW_Y)) > lead)
        {
            locus__outline_point(&y_track, &z_track, &outline_slope, place, at, (*cspan_at(&tables, row + search__ROW_Y)), (*cspan_at(&tables, row + search__ROW_HEIGHT)), (*cspan_at(&tables, row + search__ROW_SLOPE)));
            abscissa = y_track - (*cspan_at(&tables, layout__SET_RAIL_Y));
            if ((abscissa >= start) && (abscissa <= stop))
            {
                piece = profile_table__find_piece(tables, rail, abscissa);
                u = abscissa - (*cspan_at(&tables, piece));
                height = (*cspan_at(&tables, piece + INT64_C(1))) + u * ((*cspan_at(&tables, piece + INT64_C(2))) + u * ((*cspan_at(&tables, piece + INT64_C(3))) + u * ((*cspan_at(&tables, piece + INT64_C(4))) + u * ((*cspan_at(&tables, piece + INT64_C(5))) + u * (*cspan_at(&tables, piece + INT64_C(6)))))));
                gap = height - z_track;
                if (first < INT64_C(0))
                {
                    first = i;
                }
                last = i;
                if (gap < best)
                {
                    best = gap;
                    node = i;
                }
                (*cspan_at(&work, side + layout__SIDE_GAP + i)) = gap;
                (*cspan_at(&work, side + layout__SIDE_ABSCISSA + i)) = abscissa;
            }
            else if ((abscissa > stop) && (first >= INT64_C(0)))
            {
                break;
            }
            else
            {
                (*cspan_at(&work, side + layout__SIDE_GAP + i)) = search__LARGE_GAP;
            }
        }
    }
    (*cspan_at(&work, side + layout__SIDE_FIRST)) = (double)(first);
    (*cspan_at(&work, side + layout__SIDE_LAST)) = (double)(last);
    (*cspan_at(&state, layout__STATE_GAP_COUNT)) += (double)(last - first + INT64_C(1));
    (*cspan_at(&state, layout__STATE_SCAN_COUNT)) += 1.0;
    if (last <= first)
    {
        node = -INT64_C(1);
    }
    return node;
}

/* Bounds [1/m] of the gap's second derivative between scan nodes ``cell`` and ``cell`` + 1, the first of them above
 * the rail's ``abscissa`` [m]: rail minus wheel.
 */
static int64_t search__bend_bounds(double* least, double* most, array_double_1d tables, array_double_1d place, int64_t at, int64_t cell, double abscissa)
{
    int64_t scan;
    double u;
    int64_t rail;
    int64_t row;
    double share;
    double steepest;
    double sine;
    scan = (int64_t)((*cspan_at(&tables, layout__SET_SCAN)));
    u = (abscissa - (*cspan_at(&tables, scan + search__SCAN_RAIL_START))) / (*cspan_at(&tables, scan + search__SCAN_RAIL_STEP));
    if (!(u > 0.0))
    {
        u = 0.0;
    }
    if (u > (*cspan_at(&tables, scan + search__SCAN_RAIL_COUNT)) - 1.0)
    {
        u = (*cspan_at(&tables, scan + search__SCAN_RAIL_COUNT)) - 1.0;
    }
    rail = scan + (int64_t)((*cspan_at(&tables, scan + search__SCAN_RAIL_OFFSET))) + search__RAIL_ROW * (int64_t)(u);
    row = scan + search__SCAN_NODES + search__SCAN_ROW * cell;
    share = search__ROLLED_SHARE;
    if ((*cspan_at(&place, at + locus__PLACE_YAWED)) != 0.0)
    {
        /* how much the outline is stretched: |dY/dy - 1| is about sin^2(yaw) r |r''| */
        steepest = fabs((*cspan_at(&tables, row + search__ROW_MOST_BEND)));
        if (fabs((*cspan_at(&tables, row + search__ROW_LEAST_BEND))) > steepest)
        {
            steepest = fabs((*cspan_at(&tables, row + search__ROW_LEAST_BEND)));
        }
        sine = (*cspan_at(&place, at + locus__PLACE_SIN_YAW));
        share = search__YAWED_SHARE + search__STRETCHED_SHARE * sine * sine * (*cspan_at(&place, at + locus__PLACE_RADIUS)) * steepest;
    }
    (*least) = (*cspan_at(&tables, rail)) - (*cspan_at(&tables, row + search__ROW_MOST_BEND)) - share * (fabs((*cspan_at(&tables, rail))) + fabs((*cspan_at(&tables, row + search__ROW_MOST_BEND))));
    (*most) = (*cspan_at(&tables, rail + INT64_C(1))) - (*cspan_at(&tables, row + search__ROW_LEAST_BEND)) + share * (fabs((*cspan_at(&tables, rail + INT64_C(1)))) + fabs((*cspan_at(&tables, row + search__ROW_LEAST_BEND))));
    if (!((*most) > 0.0))
    {
        (*most) = 0.0;
    }
    return 0;
}

/* Put the smallest gap of the side and its abscissa into SIDE_BEST, SIDE_BEST_Y; 1 if there is one, else 0.
 *
 * With ``known`` = 1 the two already hold a local minimum of this pose, and only a smaller one is looked for.
 */
static int64_t search__search_side(array_double_1d tables, array_double_1d work, int64_t side, array_double_1d place, int64_t at, array_double_1d state, int64_t known)
{
    int64_t node;
    int64_t scan;
    int64_t first;
    int64_t last;
    int64_t i;
    double lowest;
    double least;
    double most;
    int64_t row;
    double low;
    double high;
    bool own;
    node = search__scan_side(tables, work, side, place, at, state);
    if (node < INT64_C(0))
    {
        return INT64_C(0);
    }
    scan = (int64_t)((*cspan_at(&tables, layout__SET_SCAN)));
    if (known == INT64_C(0))
    {
        (*cspan_at(&work, side + layout__SIDE_BEST)) = (*cspan_at(&work, side + layout__SIDE_GAP + node));
        (*cspan_at(&work, side + layout__SIDE_BEST_Y)) = (*cspan_at(&tables, scan + search__SCAN_NODES + search__SCAN_ROW * node + search__ROW_Y));
    }
    first = (int64_t)((*cspan_at(&work, side + layout__SIDE_FIRST)));
    last = (int64_t)((*cspan_at(&work, side + layout__SIDE_LAST)));
    for (i = first; i < last; i += INT64_C(1))
    {
        lowest = (*cspan_at(&work, side + layout__SIDE_GAP + i));
        if ((*cspan_at(&work, side + layout__SIDE_GAP + i + INT64_C(1))) < lowest)
        {
            lowest = (*cspan_at(&work, side + layout__SIDE_GAP + i + INT64_C(1)));
        }
        /* most cells are far above; the bounds are looked up for the others only */
        if (lowest < (*cspan_at(&work, side + layout__SIDE_BEST)) + search__DEEPEST)
        {
            search__bend_bounds(&least, &most, tables, place, at, i, (*cspan_at(&work, side + layout__SIDE_ABSCISSA + i)));
            row = scan + search__SCAN_NODES + search__SCAN_ROW * i;
            low = (*cspan_at(&tables, row + search__ROW_Y));
            high = (*cspan_at(&tables, row + search__SCAN_ROW + search__ROW_Y));
            if (lowest - most * (high - low) * (high - low) / 8.0 < (*cspan_at(&work, side + layout__SIDE_BEST)))
            {
                own = (known == INT64_C(1)) && ((*cspan_at(&work, side + layout__SIDE_BEST_Y)) >= low) && ((*cspan_at(&work, side + layout__SIDE_BEST_Y)) <= high);
                if (!(own && (least > 0.0)))
                {
                    search__search_cell(tables, work, side, place, at, state, least, most, low, high);
                }
            }
        }
    }
    search__search_ends(tables, work, side, place, at, state, first, last);
    return INT64_C(1);
}

/* Search between the outermost scan nodes and the rail's ends, where the gap falls outwards. */
static int64_t search__search_ends(array_double_1d tables, array_double_1d work, int64_t side, array_double_1d place, int64_t at, array_double_1d state, int64_t first, int64_t last)
{
    int64_t scan;
    scan = (int64_t)((*cspan_at(&tables, layout__SET_SCAN)));
    if ((first > INT64_C(0)) && ((*cspan_at(&work, side + layout__SIDE_GAP + first)) < (*cspan_at(&work, side + layout__SIDE_GAP + first + INT64_C(1)))))
    {
        search__search_end(tables, work, side, place, at, state, first, -INT64_C(1));
    }
    if ((last + INT64_C(1) < (int64_t)((*cspan_at(&tables, scan + search__SCAN_COUNT)))) && ((*cspan_at(&work, side + layout__SIDE_GAP + last)) < (*cspan_at(&work, side + layout__SIDE_GAP + last - INT64_C(1)))))
    {
        search__search_end(tables, work, side, place, at, state, last, INT64_C(1));
    }
    return INT64_C(0);
}

/* Search between scan node ``node`` and the end of the rail beyond it. */
static int64_t search__search_end(array_double_1d tables, array_double_1d work, int64_t side, array_double_1d place, int64_t at, array_double_1d state, int64_t node, int64_t outward)
{
    int64_t scan;
    int64_t row;
    double inner;
    double inside;
    double outside;
    double middle;
    double z;
    double slope;
    double y_track;
    double z_track;
    double outline_slope;
    int64_t cell;
    double abscissa;
    double least;
    double most;
    scan = (int64_t)((*cspan_at(&tables, layout__SET_SCAN)));
    row = scan + search__SCAN_NODES + search__SCAN_ROW * node;
    inner = (*cspan_at(&tables, row + search__ROW_Y));
    inside = inner;
    outside = (*cspan_at(&tables, row + search__SCAN_ROW * outward + search__ROW_Y));
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
    cell = node;
    abscissa = (*cspan_at(&work, side + layout__SIDE_ABSCISSA + node));
    if (outward < INT64_C(0))
    {
        cell = node - INT64_C(1);
        abscissa = (*cspan_at(&tables, (int64_t)((*cspan_at(&tables, layout__SET_RAIL))) + profile_table__START));
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

/* Local minima between ``first`` and ``last`` [m]: halve while a better value is possible, refine where the slope
 * turns.  ``least`` and ``most`` bound the second derivative.
 */
static int64_t search__search_cell(array_double_1d tables, array_double_1d work, int64_t side, array_double_1d place, int64_t at, array_double_1d state, double least, double most, double first, double last)
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
    double y;
    double gap;
    double middle;
    double mismatch;
    stack = side + layout__SIDE_STACK;
    gap__vertical_gap(&gap_low, &mismatch_low, &rate, tables, place, at, first);
    gap__vertical_gap(&gap_high, &mismatch_high, &rate, tables, place, at, last);
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
        if (lowest - most * width * width / 8.0 < (*cspan_at(&work, side + layout__SIDE_BEST)))
        {
            folded = (mismatch_low == gap__FOLDED) || (mismatch_high == gap__FOLDED);
            if ((mismatch_low < 0.0) && (mismatch_high >= 0.0) && (!folded))
            {
                search__refine_minimum(&y, &gap, tables, place, at, state, low, high, mismatch_low, mismatch_high);
                search__keep_best(work, side, y, gap);
            }
            else if ((width > search__NARROW) && (folded || (!(least > 0.0))))
            {
                middle = 0.5 * (low + high);
                gap__vertical_gap(&gap, &mismatch, &rate, tables, place, at, middle);
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
static int64_t search__push_cell(array_double_1d work, int64_t top, double low, double high, double gap_low, double gap_high, double mismatch_low, double mismatch_high)
{
    (*cspan_at(&work, top)) = low;
    (*cspan_at(&work, top + INT64_C(1))) = high;
    (*cspan_at(&work, top + INT64_C(2))) = gap_low;
    (*cspan_at(&work, top + INT64_C(3))) = gap_high;
    (*cspan_at(&work, top + INT64_C(4))) = mismatch_low;
    (*cspan_at(&work, top + INT64_C(5))) = mismatch_high;
    return INT64_C(0);
}

/* Keep (y, gap) if it is the side's best so far. */
static int64_t search__keep_best(array_double_1d work, int64_t side, double y, double gap)
{
    if (gap < (*cspan_at(&work, side + layout__SIDE_BEST)))
    {
        (*cspan_at(&work, side + layout__SIDE_BEST)) = gap;
        (*cspan_at(&work, side + layout__SIDE_BEST_Y)) = y;
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

/* Refine the side's known minimum after a small change of pose; 1 if it is found again close by, else 0.
 *
 * Between nearly conformal profiles it can run away or vanish.
 */
static int64_t search__follow_minimum(array_double_1d tables, array_double_1d work, int64_t side, array_double_1d place, int64_t at, array_double_1d state)
{
    double y;
    int64_t k;
    double gap;
    double mismatch;
    double rate;
    double move;
    y = (*cspan_at(&work, side + layout__SIDE_BEST_Y));
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
            (*cspan_at(&work, side + layout__SIDE_BEST)) = gap;
            (*cspan_at(&work, side + layout__SIDE_BEST_Y)) = y;
            return INT64_C(1);
        }
        if (!(fabs(move) < search__LONGEST_MOVE))
        {
            return INT64_C(0);
        }
        y += move;
    }
    return INT64_C(0);
}
