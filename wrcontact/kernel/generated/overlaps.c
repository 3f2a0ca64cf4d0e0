/* Generated from contact/overlaps.py by tools/transpile_kernel.py; change that one.
 *
 * Where a pressed wheel overlaps its rail: the deepest point of every region, and the humps between them.
 *
 * The overlap is sampled at the scan nodes where the wheel is below the rail, taken straight down and turned into the normal;
 * between two samples where it turns from rising to falling lies a deepest point, which is refined along the rail's normals
 * (:mod:`pressed`).  Two that are parted by a low hump are one region (regions.MERGE).
 */

#include "overlaps.h"

/* Write scan node ``node`` to sample ``entry``; its vertical gap [m], slope difference [-] and rail abscissa [m]. */
static OUT_OF_LINE int64_t overlaps__sample_overlap(double* gap, double* result_1, double* abscissa, array_double_1d tables, array_double_1d work, int64_t at, int64_t node, double height, int64_t entry)
{
    int64_t point;
    double y;
    double y_track;
    double z_track;
    double outline_slope;
    double z_rail;
    double m;
    double bend;
    double square;
    double rise;
    point = (int64_t)((*cspan_at(&tables, layout__TABLES_SCAN))) + layout__SCAN_NODES + layout__SCAN_NODE_SIZE * node;
    y = (*cspan_at(&tables, point + layout__SCAN_NODE_Y));
    locus__outline_point(&y_track, &z_track, &outline_slope, work, at, y, (*cspan_at(&tables, point + layout__SCAN_NODE_HEIGHT)), (*cspan_at(&tables, point + layout__SCAN_NODE_SLOPE)));
    (*abscissa) = y_track - (*cspan_at(&tables, layout__TABLES_RAIL_Y));
    profile_table__height_slope_bend(&z_rail, &m, &bend, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), (*abscissa));
    (*gap) = z_rail - z_track;
    square = 1.0 / (1.0 + m * m);
    (*cspan_at(&work, overlaps__SAMPLE_RAIL + entry)) = (*abscissa);
    (*cspan_at(&work, overlaps__SAMPLE_WHEEL + entry)) = y;
    /* of (height - gap) cos, but for a factor cos; apart from each other, where the rail's normals say little, of height - gap */
    rise = outline_slope - m;
    if (height > (*gap))
    {
        rise -= (height - (*gap)) * m * bend * square;
    }
    (*cspan_at(&work, overlaps__SAMPLE_RISE + entry)) = rise;
    (*result_1) = m - outline_slope;
    return 0;
}

/* Let sample ``entry``, beyond the rail, stand for its end, with a slope that lets the last stretch be searched.
 *
 * It keeps its own wheel abscissa, less than a cell away: it may be the first one, whose neighbour is not sampled yet.
 */
static OUT_OF_LINE int64_t overlaps__sample_end(array_double_1d tables, array_double_1d work, int64_t direction, int64_t entry)
{
    int64_t rail;
    rail = (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL)));
    (*cspan_at(&work, overlaps__SAMPLE_RAIL + entry)) = (*cspan_at(&tables, rail + layout__PROFILE_START));
    (*cspan_at(&work, overlaps__SAMPLE_RISE + entry)) = 1.0;
    if (direction > INT64_C(0))
    {
        (*cspan_at(&work, overlaps__SAMPLE_RAIL + entry)) = (*cspan_at(&tables, rail + layout__PROFILE_STOP));
        (*cspan_at(&work, overlaps__SAMPLE_RISE + entry)) = -1.0;
    }
    return INT64_C(0);
}

/* Sample from scan node ``node`` on in ``direction`` (1 or -1), leaving out stretches where the wheel is above the rail;
 * the entry after the last one.  Entries begin with ``first`` and run in ``direction``.
 */
static OUT_OF_LINE int64_t overlaps__walk_overlap(array_double_1d tables, array_double_1d work, array_double_1d state, int64_t at, int64_t node, int64_t direction, double height, int64_t first)
{
    int64_t count;
    int64_t exponent;
    double neighbour;
    double gap;
    double mismatch;
    double abscissa;
    int64_t on_rail;
    int64_t step;
    int64_t entry;
    count = (int64_t)((*cspan_at(&tables, (int64_t)((*cspan_at(&tables, layout__TABLES_SCAN))) + layout__SCAN_COUNT)));
    entry = first;
    exponent = layout__EXPONENTS - INT64_C(1);
    neighbour = 1.0;
    while((node >= INT64_C(0)) && (node < count) && (entry > INT64_C(0)) && (entry < INT64_C(2) * layout__OVERLAP_LIMIT - INT64_C(1)))
    {
        overlaps__sample_overlap(&gap, &mismatch, &abscissa, tables, work, at, node, height, entry);
        (*cspan_at(&state, layout__STATE_GAP_COUNT)) += 1.0;
        on_rail = gap__above_rail(tables, abscissa);
        if (on_rail == INT64_C(0))
        {
            overlaps__sample_end(tables, work, direction, entry);
        }
        if (direction > INT64_C(0))
        {
            (*cspan_at(&work, overlaps__SAMPLE_NEXT + entry)) = neighbour;
        }
        else
        {
            (*cspan_at(&work, overlaps__SAMPLE_NEXT + entry + INT64_C(1))) = neighbour;
        }
        entry += direction;
        if (on_rail == INT64_C(0))
        {
            return entry;
        }
        neighbour = 1.0;
        step = INT64_C(1);
        if (gap > height)
        {
            exponent = bounds__clear_exponent(tables, work, (int64_t)((*cspan_at(&tables, layout__TABLES_SCAN))), at, node, direction, abscissa, gap - height, (double)(direction) * mismatch, exponent);
            if (exponent < INT64_C(0))
            {
                exponent = INT64_C(0);
            }
            else if (exponent > INT64_C(0))
            {
                step = INT64_C(1) << (int64_t)(exponent);
                neighbour = 0.0;
            }
            if (exponent < layout__EXPONENTS - INT64_C(1))
            {
                exponent += INT64_C(1);
            }
        }
        node += direction * step;
    }
    return entry;
}

/* Rail and wheel abscissa [m] of the largest overlap (``sign`` = 1) or the smallest (-1) between two rail abscissae, and
 * the overlap [m]: Newton's method on its slope, bracketed, from the middle on.  Fourth value: 1 if the slope turns there,
 * else 0.
 *
 * The bend leaves out a factor (:mod:`pressed`); between nearly conformal profiles under a deep overlap that can send
 * Newton's method to and fro.  Where a step has not halved the slope, the bracket is.
 */
static OUT_OF_LINE int64_t overlaps__turning_point(double* result_0, double* result_1_0001, double* result_2, int64_t* result_3, array_double_1d tables, array_double_1d work, int64_t at, double low, double high, double y, double height, double sign)
{
    double x;
    double overlap;
    double rise;
    double before;
    int64_t i;
    double bend;
    double curvature;
    int64_t found;
    double following;
    double newton;
    int64_t turned;
    x = 0.5 * (low + high);
    overlap = 0.0;
    rise = 1.0;
    before = 0.0;
    for (i = INT64_C(0); i < overlaps__DEEP_ITERATIONS; i += INT64_C(1))
    {
        pressed__normal_line(&y, &overlap, &rise, &bend, &curvature, &found, tables, work, at, x, y, height);
        if (found == INT64_C(0))
        {
            (*result_0) = x;
            (*result_1_0001) = y;
            (*result_2) = overlap;
            (*result_3) = INT64_C(0);
            return 0;
        }
        if (sign * rise > 0.0)
        {
            low = x;
        }
        else
        {
            high = x;
        }
        following = 0.5 * (low + high);
        if ((sign * bend < 0.0) && ((i == INT64_C(0)) || (fabs(rise) < 0.5 * before)))
        {
            newton = x - rise / (bend * pressed__rail_speed(tables, x));
            if ((newton > low) && (newton < high))
            {
                following = newton;
            }
        }
        if (fabs(following - x) < overlaps__DEEP_SHARP)
        {
            break;
        }
        x = following;
        before = fabs(rise);
    }
    turned = INT64_C(0);
    if (fabs(rise) < overlaps__LEVEL_RISE)
    {
        turned = INT64_C(1);
    }
    (*result_0) = x;
    (*result_1_0001) = y;
    (*result_2) = overlap;
    (*result_3) = turned;
    return 0;
}

/* ``x``, or the first place some ``step`` [m] further, from where the overlap rises towards the other side; the samples
 * are straight down and may have turned a little before it.
 */
static OUT_OF_LINE double overlaps__bracket_end(array_double_1d tables, array_double_1d work, int64_t at, double x, double step, double y, double height)
{
    int64_t rail;
    int64_t i;
    double overlap;
    double rise;
    double bend;
    double curvature;
    int64_t found;
    double result;
    rail = (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL)));
    for (i = INT64_C(0); i < overlaps__WIDENINGS; i += INT64_C(1))
    {
        if (x <= (*cspan_at(&tables, rail + layout__PROFILE_START)))
        {
            result = (*cspan_at(&tables, rail + layout__PROFILE_START));
            return result;
        }
        if (x >= (*cspan_at(&tables, rail + layout__PROFILE_STOP)))
        {
            result = (*cspan_at(&tables, rail + layout__PROFILE_STOP));
            return result;
        }
        pressed__normal_line(&y, &overlap, &rise, &bend, &curvature, &found, tables, work, at, x, y, height);
        if ((found == INT64_C(0)) || (rise * step < 0.0))
        {
            break;
        }
        x += step;
    }
    return x;
}

/* List a deepest point. */
static OUT_OF_LINE int64_t overlaps__keep_deep(array_double_1d work, double x, double y, double depth)
{
    int64_t entry;
    int64_t block;
    entry = (int64_t)((*cspan_at(&work, overlaps__DEEP_COUNT)));
    if (entry < overlaps__DEEP_LIMIT)
    {
        block = overlaps__DEEP_FIRST + overlaps__DEEP_SIZE * entry;
        (*cspan_at(&work, block + overlaps__DEEP_RAIL)) = x;
        (*cspan_at(&work, block + overlaps__DEEP_WHEEL)) = y;
        (*cspan_at(&work, block + overlaps__DEEP_DEPTH)) = depth;
        (*cspan_at(&work, overlaps__DEEP_COUNT)) = (double)(entry + INT64_C(1));
    }
    return INT64_C(0);
}

/* Leave out a deepest point; of the humps beside it the lower one stays. */
static OUT_OF_LINE int64_t overlaps__drop_deep(array_double_1d work, int64_t entry)
{
    int64_t count;
    int64_t block;
    int64_t before;
    count = (int64_t)((*cspan_at(&work, overlaps__DEEP_COUNT)));
    block = overlaps__DEEP_FIRST + overlaps__DEEP_SIZE * entry;
    if ((entry > INT64_C(0)) && (entry < count - INT64_C(1)))
    {
        before = block - overlaps__DEEP_SIZE;
        if ((*cspan_at(&work, block + overlaps__DEEP_BETWEEN)) < (*cspan_at(&work, before + overlaps__DEEP_BETWEEN)))
        {
            (*cspan_at(&work, before + overlaps__DEEP_BETWEEN)) = (*cspan_at(&work, block + overlaps__DEEP_BETWEEN));
            (*cspan_at(&work, before + overlaps__DEEP_HUMP)) = (*cspan_at(&work, block + overlaps__DEEP_HUMP));
        }
    }
    overlaps__remove_deep(work, entry);
    return INT64_C(0);
}

/* The smallest overlap between neighbouring deepest points. */
static OUT_OF_LINE int64_t overlaps__find_humps(array_double_1d tables, array_double_1d work, int64_t at, double height)
{
    int64_t entry_end;
    int64_t entry;
    int64_t block;
    double x;
    double y;
    double overlap;
    int64_t turned;
    entry_end = (int64_t)((*cspan_at(&work, overlaps__DEEP_COUNT))) - INT64_C(1);
    for (entry = INT64_C(0); entry < entry_end; entry += INT64_C(1))
    {
        block = overlaps__DEEP_FIRST + overlaps__DEEP_SIZE * entry;
        overlaps__turning_point(&x, &y, &overlap, &turned, tables, work, at, (*cspan_at(&work, block + overlaps__DEEP_RAIL)), (*cspan_at(&work, block + overlaps__DEEP_SIZE + overlaps__DEEP_RAIL)), 0.5 * ((*cspan_at(&work, block + overlaps__DEEP_WHEEL)) + (*cspan_at(&work, block + overlaps__DEEP_SIZE + overlaps__DEEP_WHEEL))), height, -1.0);
        (*cspan_at(&work, block + overlaps__DEEP_HUMP)) = x;
        (*cspan_at(&work, block + overlaps__DEEP_BETWEEN)) = overlap;
    }
    return INT64_C(0);
}

/* The deepest of the list. */
static OUT_OF_LINE int64_t overlaps__deepest_entry(array_double_1d work)
{
    int64_t entry_end;
    int64_t entry;
    int64_t best;
    best = INT64_C(0);
    entry_end = (int64_t)((*cspan_at(&work, overlaps__DEEP_COUNT)));
    for (entry = INT64_C(0); entry < entry_end; entry += INT64_C(1))
    {
        if ((*cspan_at(&work, overlaps__DEEP_FIRST + overlaps__DEEP_SIZE * entry + overlaps__DEEP_DEPTH)) > (*cspan_at(&work, overlaps__DEEP_FIRST + overlaps__DEEP_SIZE * best + overlaps__DEEP_DEPTH)))
        {
            best = entry;
        }
    }
    return best;
}

/* Leave only the deepest of the list, which then has no bounds. */
static OUT_OF_LINE int64_t overlaps__keep_deepest(array_double_1d work)
{
    int64_t deepest;
    int64_t i;
    deepest = overlaps__DEEP_FIRST + overlaps__DEEP_SIZE * overlaps__deepest_entry(work);
    for (i = INT64_C(0); i < overlaps__DEEP_SIZE; i += INT64_C(1))
    {
        (*cspan_at(&work, overlaps__DEEP_FIRST + i)) = (*cspan_at(&work, deepest + i));
    }
    (*cspan_at(&work, overlaps__DEEP_COUNT)) = 1.0;
    return INT64_C(0);
}

/* The least deep of the list. */
static OUT_OF_LINE int64_t overlaps__shallowest_entry(array_double_1d work)
{
    int64_t entry_end;
    int64_t entry;
    int64_t least;
    least = INT64_C(0);
    entry_end = (int64_t)((*cspan_at(&work, overlaps__DEEP_COUNT)));
    for (entry = INT64_C(0); entry < entry_end; entry += INT64_C(1))
    {
        if ((*cspan_at(&work, overlaps__DEEP_FIRST + overlaps__DEEP_SIZE * entry + overlaps__DEEP_DEPTH)) < (*cspan_at(&work, overlaps__DEEP_FIRST + overlaps__DEEP_SIZE * least + overlaps__DEEP_DEPTH)))
        {
            least = entry;
        }
    }
    return least;
}

/* Join what a low hump parts, and keep the deepest REGION_LIMIT. */
static OUT_OF_LINE int64_t overlaps__merge_deep(array_double_1d work)
{
    double depth;
    int64_t entry;
    int64_t block;
    int64_t less;
    depth = (*cspan_at(&work, overlaps__DEEP_FIRST + overlaps__DEEP_SIZE * overlaps__deepest_entry(work) + overlaps__DEEP_DEPTH));
    entry = INT64_C(0);
    while(entry < (int64_t)((*cspan_at(&work, overlaps__DEEP_COUNT))) - INT64_C(1))
    {
        block = overlaps__DEEP_FIRST + overlaps__DEEP_SIZE * entry;
        if (depth - (*cspan_at(&work, block + overlaps__DEEP_BETWEEN)) < regions__MERGE * depth)
        {
            less = entry;
            if ((*cspan_at(&work, block + overlaps__DEEP_DEPTH)) > (*cspan_at(&work, block + overlaps__DEEP_SIZE + overlaps__DEEP_DEPTH)))
            {
                less = entry + INT64_C(1);
            }
            if (less == entry + INT64_C(1))
            {
                (*cspan_at(&work, block + overlaps__DEEP_HUMP)) = (*cspan_at(&work, block + overlaps__DEEP_SIZE + overlaps__DEEP_HUMP));
                (*cspan_at(&work, block + overlaps__DEEP_BETWEEN)) = (*cspan_at(&work, block + overlaps__DEEP_SIZE + overlaps__DEEP_BETWEEN));
            }
            overlaps__remove_deep(work, less);
        }
        else
        {
            /* the hump between the two goes, the one on the far side stays */
            entry += INT64_C(1);
        }
    }
    while((int64_t)((*cspan_at(&work, overlaps__DEEP_COUNT))) > layout__REGION_LIMIT)
    {
        overlaps__drop_deep(work, overlaps__shallowest_entry(work));
    }
    return INT64_C(0);
}

/* Take entry ``entry`` off the list with its own hump. */
static OUT_OF_LINE int64_t overlaps__remove_deep(array_double_1d work, int64_t entry)
{
    int64_t block;
    int64_t count;
    int64_t i;
    block = overlaps__DEEP_FIRST + overlaps__DEEP_SIZE * entry;
    count = (int64_t)((*cspan_at(&work, overlaps__DEEP_COUNT)));
    for (i = block; i < overlaps__DEEP_FIRST + overlaps__DEEP_SIZE * (count - INT64_C(1)); i += INT64_C(1))
    {
        (*cspan_at(&work, i)) = (*cspan_at(&work, i + overlaps__DEEP_SIZE));
    }
    (*cspan_at(&work, overlaps__DEEP_COUNT)) = (double)(count - INT64_C(1));
    return INT64_C(0);
}

/* List the regions in which the wheel placed at ``at`` and moved down by ``height`` [m] overlaps its rail; their number. */
static OUT_OF_LINE int64_t overlaps__find_overlaps(array_double_1d tables, array_double_1d work, array_double_1d state, int64_t side, int64_t at, double height)
{
    int64_t node;
    int64_t start;
    int64_t stop;
    int64_t entry;
    double step;
    double y;
    double low;
    double high;
    int64_t result;
    node = raster__node_below(tables, (int64_t)((*cspan_at(&tables, layout__TABLES_SCAN))), (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST_Y)));
    (*cspan_at(&work, overlaps__DEEP_COUNT)) = 0.0;
    start = overlaps__walk_overlap(tables, work, state, at, node, -INT64_C(1), height, layout__OVERLAP_LIMIT - INT64_C(1)) + INT64_C(1);
    stop = overlaps__walk_overlap(tables, work, state, at, node + INT64_C(1), INT64_C(1), height, layout__OVERLAP_LIMIT);
    for (entry = start; entry < stop - INT64_C(1); entry += INT64_C(1))
    {
        if (((*cspan_at(&work, overlaps__SAMPLE_RISE + entry)) > 0.0) && ((*cspan_at(&work, overlaps__SAMPLE_RISE + entry + INT64_C(1))) <= 0.0) && ((*cspan_at(&work, overlaps__SAMPLE_NEXT + entry + INT64_C(1))) == 1.0))
        {
            step = (*cspan_at(&work, overlaps__SAMPLE_RAIL + entry + INT64_C(1))) - (*cspan_at(&work, overlaps__SAMPLE_RAIL + entry));
            y = 0.5 * ((*cspan_at(&work, overlaps__SAMPLE_WHEEL + entry)) + (*cspan_at(&work, overlaps__SAMPLE_WHEEL + entry + INT64_C(1))));
            low = overlaps__bracket_end(tables, work, at, (*cspan_at(&work, overlaps__SAMPLE_RAIL + entry)), -step, y, height);
            high = overlaps__bracket_end(tables, work, at, (*cspan_at(&work, overlaps__SAMPLE_RAIL + entry + INT64_C(1))), step, y, height);
            overlaps__list_between(tables, work, at, low, high, y, height);
        }
    }
    overlaps__list_smallest(tables, work, side, at, height);
    if ((int64_t)((*cspan_at(&work, overlaps__DEEP_COUNT))) > INT64_C(0))
    {
        overlaps__find_humps(tables, work, at, height);
        overlaps__merge_deep(work);
    }
    result = (int64_t)((*cspan_at(&work, overlaps__DEEP_COUNT)));
    return result;
}

/* List the deepest points between two rail abscissae from where the overlap rises towards each other: on nearly conformal
 * profiles the joints of their arcs leave several, of which a bracket by itself would end at either.
 */
static OUT_OF_LINE int64_t overlaps__list_between(array_double_1d tables, array_double_1d work, int64_t at, double low, double high, double y, double height)
{
    double step;
    double start;
    int64_t rising;
    double guess;
    int64_t i;
    double stop;
    int64_t falls;
    double near;
    double overlap;
    double rise;
    double bend;
    double curvature;
    int64_t found;
    double x;
    double depth;
    int64_t turned;
    step = (high - low) / (double)(overlaps__PARTS);
    start = low;
    rising = INT64_C(1);
    guess = y;
    for (i = INT64_C(1); i < overlaps__PARTS + INT64_C(1); i += INT64_C(1))
    {
        stop = low + step * (double)(i);
        falls = INT64_C(1);
        if (i < overlaps__PARTS)
        {
            pressed__normal_line(&near, &overlap, &rise, &bend, &curvature, &found, tables, work, at, stop, guess, height);
            if (found == INT64_C(1))
            {
                guess = near;
            }
            if ((found == INT64_C(1)) && (rise > 0.0))
            {
                falls = INT64_C(0);
            }
        }
        if ((rising == INT64_C(1)) && (falls == INT64_C(1)))
        {
            overlaps__turning_point(&x, &y, &depth, &turned, tables, work, at, start, stop, guess, height, 1.0);
            if ((turned == INT64_C(1)) && (depth > 0.0) && (overlaps__is_listed(work, x) == INT64_C(0)))
            {
                overlaps__keep_deep(work, x, y, depth);
            }
        }
        rising = INT64_C(1) - falls;
        start = stop;
    }
    return INT64_C(0);
}

/* List the deepest point beside the smallest gap where none on the list is as deep as the overlap there: between two
 * scan nodes on nearly conformal profiles it can turn three times.
 */
static OUT_OF_LINE int64_t overlaps__list_smallest(array_double_1d tables, array_double_1d work, int64_t side, int64_t at, double height)
{
    double z;
    double slope;
    double y_track;
    double z_track;
    double outline_slope;
    double x;
    double y;
    double overlap;
    double rise;
    double bend;
    double curvature;
    int64_t found;
    double deepest;
    double step;
    double far;
    double low;
    double high;
    double depth;
    int64_t turned;
    profile_table__height_slope(&z, &slope, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL))), (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST_Y)));
    locus__outline_point(&y_track, &z_track, &outline_slope, work, at, (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST_Y)), z, slope);
    x = y_track - (*cspan_at(&tables, layout__TABLES_RAIL_Y));
    pressed__normal_line(&y, &overlap, &rise, &bend, &curvature, &found, tables, work, at, x, (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST_Y)), height);
    deepest = 0.0;
    if ((int64_t)((*cspan_at(&work, overlaps__DEEP_COUNT))) > INT64_C(0))
    {
        deepest = (*cspan_at(&work, overlaps__DEEP_FIRST + overlaps__DEEP_SIZE * overlaps__deepest_entry(work) + overlaps__DEEP_DEPTH));
    }
    if ((found == INT64_C(1)) && (overlap > deepest))
    {
        step = overlaps__FIRST_STEP;
        if (rise < 0.0)
        {
            step = -overlaps__FIRST_STEP;
        }
        far = x;
        while((rise * step > 0.0) && (fabs(far - x) < overlaps__FAR_STEP) && (found == INT64_C(1)))
        {
            far += step;
            pressed__normal_line(&y, &overlap, &rise, &bend, &curvature, &found, tables, work, at, far, y, height);
            step *= 2.0;
        }
        low = x;
        high = far;
        if (far < x)
        {
            low = far;
            high = x;
        }
        overlaps__turning_point(&x, &y, &depth, &turned, tables, work, at, low, high, (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST_Y)), height, 1.0);
        if ((turned == INT64_C(1)) && (depth > deepest))
        {
            overlaps__keep_deep(work, x, y, depth);
            overlaps__sort_deep(work);
        }
    }
    return INT64_C(0);
}

/* Bring the last deepest point listed to its place along the rail. */
static OUT_OF_LINE int64_t overlaps__sort_deep(array_double_1d work)
{
    int64_t block;
    int64_t i;
    double kept;
    block = overlaps__DEEP_FIRST + overlaps__DEEP_SIZE * ((int64_t)((*cspan_at(&work, overlaps__DEEP_COUNT))) - INT64_C(1));
    while((block > overlaps__DEEP_FIRST) && ((*cspan_at(&work, block + overlaps__DEEP_RAIL)) < (*cspan_at(&work, block - overlaps__DEEP_SIZE + overlaps__DEEP_RAIL))))
    {
        for (i = block; i < block + overlaps__DEEP_SIZE; i += INT64_C(1))
        {
            kept = (*cspan_at(&work, i));
            (*cspan_at(&work, i)) = (*cspan_at(&work, i - overlaps__DEEP_SIZE));
            (*cspan_at(&work, i - overlaps__DEEP_SIZE)) = kept;
        }
        block -= overlaps__DEEP_SIZE;
    }
    return INT64_C(0);
}

/* 1 if the last deepest point listed is at ``x`` [m] or beyond, else 0. */
static OUT_OF_LINE int64_t overlaps__is_listed(array_double_1d work, double x)
{
    int64_t entry;
    int64_t listed;
    listed = INT64_C(0);
    entry = (int64_t)((*cspan_at(&work, overlaps__DEEP_COUNT))) - INT64_C(1);
    if (entry >= INT64_C(0))
    {
        if (x < (*cspan_at(&work, overlaps__DEEP_FIRST + overlaps__DEEP_SIZE * entry + overlaps__DEEP_RAIL)) + overlaps__SAME)
        {
            listed = INT64_C(1);
        }
    }
    return listed;
}

/* Lateral and vertical shift [m] that let the wheel just touch at a deepest point. */
static OUT_OF_LINE int64_t overlaps__touching_shift(double* result_0, double* result_1, array_double_1d tables, array_double_1d work, int64_t at, int64_t entry, double height)
{
    int64_t block;
    double x;
    double y;
    double z;
    double slope;
    double y_track;
    double z_track;
    double outline_slope;
    double z_rail;
    double m;
    block = overlaps__DEEP_FIRST + overlaps__DEEP_SIZE * entry;
    x = (*cspan_at(&work, block + overlaps__DEEP_RAIL));
    y = (*cspan_at(&work, block + overlaps__DEEP_WHEEL));
    profile_table__height_slope(&z, &slope, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL))), y);
    locus__outline_point(&y_track, &z_track, &outline_slope, work, at, y, z, slope);
    profile_table__height_slope(&z_rail, &m, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), x);
    (*result_0) = x + (*cspan_at(&tables, layout__TABLES_RAIL_Y)) - y_track;
    (*result_1) = z_rail - z_track;
    return 0;
}

/* Let the open frame be that of a wheel pressed ``depth`` deep, whose own gap is ``gap`` [m]. */
static OUT_OF_LINE int64_t overlaps__press_frame(array_double_1d work, double height, double depth, double gap)
{
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_POSE)) = height;
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_DEPTH)) = depth;
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_PRESSED)) = (double)(1);
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_RAISED)) = gap;
    return INT64_C(0);
}

/* Open a region for every deepest point on the list, each with its own frame; their number.  The open frame is that of the
 * deepest, whose share of the approach counts as one.
 */
static OUT_OF_LINE int64_t overlaps__gather_overlaps(array_double_1d tables, array_double_1d work, array_double_1d state)
{
    int64_t contact;
    double cosine;
    double abscissa;
    double height;
    double depth;
    int64_t at;
    int64_t rail;
    int64_t region;
    int64_t block;
    int64_t deep;
    double z_rail;
    double m;
    double aside;
    double shift;
    double Dummy_0002_0;
    double Dummy_0002_1;
    double Dummy_0002_2;
    double Dummy_0002_3;
    double Dummy_0002_4;
    double gap;
    double rate;
    double bend;
    double curvature;
    double low;
    double high;
    int64_t count;
    count = (int64_t)((*cspan_at(&work, overlaps__DEEP_COUNT)));
    contact = overlaps__deepest_entry(work);
    cosine = (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_COS));
    abscissa = (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_ABSCISSA));
    height = (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_POSE));
    depth = (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_DEPTH));
    at = (int64_t)((*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_PLACE)));
    rail = (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL)));
    planes__keep_frame(work, layout__REGION_LIMIT);
    for (region = INT64_C(0); region < count; region += INT64_C(1))
    {
        block = layout__WORK_REGIONS + layout__REGION_SIZE * region;
        deep = overlaps__DEEP_FIRST + overlaps__DEEP_SIZE * region;
        (*cspan_at(&work, block + layout__REGION_STATION)) = 0.0;
        (*cspan_at(&work, block + layout__REGION_GAP)) = 0.0;
        (*cspan_at(&work, block + layout__REGION_RAIL)) = (*cspan_at(&work, deep + overlaps__DEEP_RAIL));
        (*cspan_at(&work, block + layout__REGION_WHEEL)) = (*cspan_at(&work, deep + overlaps__DEEP_WHEEL));
        profile_table__height_slope(&z_rail, &m, tables, rail, (*cspan_at(&work, deep + overlaps__DEEP_RAIL)));
        regions__lean_region(tables, work, block, m);
        if (region != contact)
        {
            overlaps__touching_shift(&aside, &shift, tables, work, at, region, height);
            contact_plane__open_frame(&Dummy_0002_0, &Dummy_0002_1, &Dummy_0002_2, &Dummy_0002_3, &Dummy_0002_4, tables, work, at, (*cspan_at(&work, deep + overlaps__DEEP_WHEEL)), aside, shift);
            (*cspan_at(&work, block + layout__REGION_OWN)) = (double)(1);
            (*cspan_at(&work, block + layout__REGION_TURN)) = (*cspan_at(&work, block + layout__REGION_COS)) / cosine;
            (*cspan_at(&work, block + layout__REGION_GAP)) = (*cspan_at(&work, block + layout__REGION_TURN)) * depth - (*cspan_at(&work, deep + overlaps__DEEP_DEPTH));
            (*cspan_at(&work, block + layout__REGION_OFFSET)) = pressed__rail_length(tables, abscissa, (*cspan_at(&work, deep + overlaps__DEEP_RAIL)));
            overlaps__press_frame(work, height, (*cspan_at(&work, deep + overlaps__DEEP_DEPTH)), (*cspan_at(&work, block + layout__REGION_GAP)));
        }
        contact_plane__start_tracer(work, 0.0, (*cspan_at(&work, deep + overlaps__DEEP_RAIL)), (*cspan_at(&work, deep + overlaps__DEEP_WHEEL)));
        pressed__pressed_gap(&gap, &rate, &bend, &curvature, tables, work, state, 0.0);
        (*cspan_at(&work, block + layout__REGION_BEND)) = bend;
        (*cspan_at(&work, block + layout__REGION_CURVATURE)) = curvature;
        low = (*cspan_at(&tables, rail + layout__PROFILE_START));
        high = (*cspan_at(&tables, rail + layout__PROFILE_STOP));
        if (region > INT64_C(0))
        {
            low = (*cspan_at(&work, deep - overlaps__DEEP_SIZE + overlaps__DEEP_HUMP));
        }
        if (region < count - INT64_C(1))
        {
            high = (*cspan_at(&work, deep + overlaps__DEEP_HUMP));
        }
        (*cspan_at(&work, block + layout__REGION_LOW)) = pressed__rail_length(tables, (*cspan_at(&work, deep + overlaps__DEEP_RAIL)), low);
        (*cspan_at(&work, block + layout__REGION_HIGH)) = pressed__rail_length(tables, (*cspan_at(&work, deep + overlaps__DEEP_RAIL)), high);
        planes__keep_frame(work, region);
        planes__use_frame(work, layout__REGION_LIMIT);
    }
    if (count > INT64_C(1))
    {
        planes__line_up(tables, work, count);
    }
    return count;
}
