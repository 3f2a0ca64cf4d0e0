/* Generated from contact/overlaps.py by tools/transpile_kernel.py; change that one.
 *
 * Where a pressed wheel overlaps its rail: the deepest point of every region, and the saddles between them.
 *
 * Between two samples (:mod:`overlap_samples`) where the overlap changes from rising to falling lies a deepest
 * point, which is located along the rail's normals (:mod:`pressed`, :mod:`touching`).  Two with a low saddle
 * between them are one region (deep_points.MERGE).
 */

#include "overlaps.h"

/* List the regions in which the wheel of ``side``, moved down by ``height`` [m], overlaps its rail; their
 * number.
 */
static OUT_OF_LINE int64_t overlaps__find_overlaps(array_double_1d work, array_double_1d tables, int64_t side, array_double_1d state, double height)
{
    int64_t place;
    int64_t node;
    int64_t start;
    int64_t stop;
    int64_t entry;
    double step;
    double y;
    double depth;
    double rise;
    double bend;
    double curvature;
    int64_t found;
    int64_t rising;
    double rail;
    double wheel;
    int64_t turned;
    double low;
    double high;
    int64_t result;
    place = side + layout__SIDE_SEARCH_PLACE;
    node = raster__node_below(tables, (int64_t)((*cspan_at(&tables, layout__TABLES_SCAN))), (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST_Y)));
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_COUNT)) = 0.0;
    start = overlap_samples__walk_overlap(work, tables, place, state, node, -INT64_C(1), height, layout__OVERLAP_LIMIT - INT64_C(1)) + INT64_C(1);
    stop = overlap_samples__walk_overlap(work, tables, place, state, node + INT64_C(1), INT64_C(1), height, layout__OVERLAP_LIMIT);
    for (entry = start; entry < stop - INT64_C(1); entry += INT64_C(1))
    {
        if ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_SAMPLES + layout__SAMPLES_ADJACENT + (entry + INT64_C(1)))) == 1.0)
        {
            step = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_SAMPLES + layout__SAMPLES_RAIL + (entry + INT64_C(1)))) - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_SAMPLES + layout__SAMPLES_RAIL + entry));
            y = 0.5 * ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_SAMPLES + layout__SAMPLES_WHEEL + entry)) + (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_SAMPLES + layout__SAMPLES_WHEEL + (entry + INT64_C(1)))));
            if (overlaps__may_turn(work, tables, place, entry) == INT64_C(1))
            {
                pressed__normal_line(&y, &depth, &rise, &bend, &curvature, &found, work, tables, place, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_SAMPLES + layout__SAMPLES_RAIL + entry)), y, height, pressed__LINE_SHARP);
                rising = INT64_C(0);
                if ((found == INT64_C(1)) && (rise > 0.0))
                {
                    rising = INT64_C(1);
                }
                overlaps__list_between(work, tables, place, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_SAMPLES + layout__SAMPLES_RAIL + entry)), (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_SAMPLES + layout__SAMPLES_RAIL + (entry + INT64_C(1)))), y, height, overlaps__HIDDEN_PARTS, rising);
            }
            else if (((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_SAMPLES + layout__SAMPLES_RISE + entry)) > 0.0) && ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_SAMPLES + layout__SAMPLES_RISE + (entry + INT64_C(1)))) <= 0.0))
            {
                if (overlaps__turns_once(work, tables, place, entry) == INT64_C(1))
                {
                    touching__turning_point(&rail, &wheel, &depth, &turned, work, tables, place, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_SAMPLES + layout__SAMPLES_RAIL + entry)), (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_SAMPLES + layout__SAMPLES_RAIL + (entry + INT64_C(1)))), y, height, 1.0);
                    if (turned == INT64_C(1))
                    {
                        if ((depth > 0.0) && (deep_points__is_listed(work, rail) == INT64_C(0)))
                        {
                            deep_points__append_point(work, rail, wheel, depth);
                        }
                        continue;
                    }
                }
                low = overlaps__bracket_end(work, tables, place, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_SAMPLES + layout__SAMPLES_RAIL + entry)), -step, y, height);
                high = overlaps__bracket_end(work, tables, place, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_SAMPLES + layout__SAMPLES_RAIL + (entry + INT64_C(1)))), step, y, height);
                overlaps__list_between(work, tables, place, low, high, y, height, overlaps__OVERLAP_PARTS, INT64_C(1));
            }
        }
    }
    overlaps__list_beside_smallest_gap(work, tables, side, height);
    if ((int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_COUNT))) > INT64_C(0))
    {
        overlaps__find_saddles(work, tables, place, height);
        deep_points__merge_points(work);
    }
    result = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_COUNT)));
    return result;
}

/* 1 if between the sample ``entry`` and the next one the overlap may turn unseen by both, else 0. */
static OUT_OF_LINE int64_t overlaps__may_turn(array_double_1d work, array_double_1d tables, int64_t place, int64_t entry)
{
    double rise;
    double following;
    int64_t node;
    double least;
    double most;
    double width;
    int64_t answer;
    rise = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_SAMPLES + layout__SAMPLES_RISE + entry));
    following = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_SAMPLES + layout__SAMPLES_RISE + (entry + INT64_C(1))));
    answer = INT64_C(0);
    if (double_min(2, fabs(rise), fabs(following)) < fabs((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_SAMPLES + layout__SAMPLES_TURN + entry))) + fabs((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_SAMPLES + layout__SAMPLES_TURN + (entry + INT64_C(1))))))
    {
        /* the bounds are those of the overlap straight down */
        answer = INT64_C(1);
    }
    else if (rise * following > 0.0)
    {
        node = raster__node_below(tables, (int64_t)((*cspan_at(&tables, layout__TABLES_SCAN))), (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_SAMPLES + layout__SAMPLES_WHEEL + entry)));
        bounds__bend_bounds(&least, &most, tables, work, (int64_t)((*cspan_at(&tables, layout__TABLES_SCAN))), place, node, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_SAMPLES + layout__SAMPLES_RAIL + entry)));
        if (least < 0.0)
        {
            width = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_SAMPLES + layout__SAMPLES_WHEEL + (entry + INT64_C(1)))) - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_SAMPLES + layout__SAMPLES_WHEEL + entry));
            answer = INT64_C(1) - bounds__only_rises_or_falls(least, most, width, -rise, -following);
        }
    }
    return answer;
}

/* 1 if the overlap straight down has one largest value at most between the sample ``entry`` and the next
 * one, else 0.
 */
static OUT_OF_LINE int64_t overlaps__turns_once(array_double_1d work, array_double_1d tables, int64_t place, int64_t entry)
{
    int64_t node;
    double least;
    double most;
    int64_t answer;
    node = raster__node_below(tables, (int64_t)((*cspan_at(&tables, layout__TABLES_SCAN))), (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_SAMPLES + layout__SAMPLES_WHEEL + entry)));
    bounds__bend_bounds(&least, &most, tables, work, (int64_t)((*cspan_at(&tables, layout__TABLES_SCAN))), place, node, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_SAMPLES + layout__SAMPLES_RAIL + entry)));
    answer = INT64_C(0);
    if (least > 0.0)
    {
        answer = INT64_C(1);
    }
    return answer;
}

/* ``x``, or the first place some ``step`` [m] further, from where the overlap rises towards the other
 * side: the samples are straight down, and their slope may change its sign a little before the overlap along
 * the normal has its maximum.
 */
static OUT_OF_LINE double overlaps__bracket_end(array_double_1d work, array_double_1d tables, int64_t place, double x, double step, double y, double height)
{
    int64_t rail;
    int64_t i;
    double depth;
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
        pressed__normal_line(&y, &depth, &rise, &bend, &curvature, &found, work, tables, place, x, y, height, pressed__LINE_SHARP);
        if ((found == INT64_C(0)) || (rise * step < 0.0))
        {
            break;
        }
        x += step;
    }
    return x;
}

/* List the deepest points between two rail abscissae, which are examined in ``parts``: on nearly
 * conformal profiles the joints of their arcs leave several, of which a bracket by itself would end at
 * either.  The overlap falls at the end where it is examined in OVERLAP_PARTS.
 */
static OUT_OF_LINE int64_t overlaps__list_between(array_double_1d work, array_double_1d tables, int64_t place, double low, double high, double y, double height, int64_t parts, int64_t rising)
{
    double step;
    double start;
    double estimate;
    int64_t i;
    double stop;
    int64_t falls;
    double near;
    double depth;
    double rise;
    double bend;
    double curvature;
    int64_t found;
    double rail;
    double wheel;
    int64_t turned;
    step = (high - low) / (double)(parts);
    start = low;
    estimate = y;
    for (i = INT64_C(1); i < parts + INT64_C(1); i += INT64_C(1))
    {
        stop = low + step * (double)(i);
        falls = INT64_C(1);
        if ((i < parts) || (parts == overlaps__HIDDEN_PARTS))
        {
            pressed__normal_line(&near, &depth, &rise, &bend, &curvature, &found, work, tables, place, stop, estimate, height, pressed__LINE_SHARP);
            if (found == INT64_C(1))
            {
                estimate = near;
            }
            if ((found == INT64_C(1)) && (rise > 0.0))
            {
                falls = INT64_C(0);
            }
        }
        if ((rising == INT64_C(1)) && (falls == INT64_C(1)))
        {
            touching__turning_point(&rail, &wheel, &depth, &turned, work, tables, place, start, stop, estimate, height, 1.0);
            if ((turned == INT64_C(1)) && (depth > 0.0) && (deep_points__is_listed(work, rail) == INT64_C(0)))
            {
                deep_points__append_point(work, rail, wheel, depth);
            }
        }
        rising = INT64_C(1) - falls;
        start = stop;
    }
    return INT64_C(0);
}

/* List the deepest point beside the smallest gap where none on the list is as deep as the overlap there:
 * between two scan nodes on nearly conformal profiles the slope of the overlap can change its sign three
 * times.
 */
static OUT_OF_LINE int64_t overlaps__list_beside_smallest_gap(array_double_1d work, array_double_1d tables, int64_t side, double height)
{
    int64_t place;
    double z;
    double slope;
    double y_track;
    double z_track;
    double outline_slope;
    double x;
    double y;
    double depth;
    double rise;
    double bend;
    double curvature;
    int64_t found;
    double deepest;
    double step;
    double far;
    double low;
    double high;
    double rail;
    double wheel;
    int64_t turned;
    place = side + layout__SIDE_SEARCH_PLACE;
    profile_table__height_slope(&z, &slope, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL))), (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST_Y)));
    locus__outline_point(&y_track, &z_track, &outline_slope, work, place, (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST_Y)), z, slope);
    x = y_track - (*cspan_at(&tables, layout__TABLES_RAIL_Y));
    pressed__normal_line(&y, &depth, &rise, &bend, &curvature, &found, work, tables, place, x, (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST_Y)), height, pressed__LINE_SHARP);
    deepest = 0.0;
    if ((int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_COUNT))) > INT64_C(0))
    {
        deepest = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_POINTS + layout__DEEP_POINT_SIZE * deep_points__deepest_entry(work) + layout__DEEP_POINT_DEPTH));
    }
    if ((found == INT64_C(1)) && (depth > deepest))
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
            pressed__normal_line(&y, &depth, &rise, &bend, &curvature, &found, work, tables, place, far, y, height, pressed__LINE_SHARP);
            step *= 2.0;
        }
        low = x;
        high = far;
        if (far < x)
        {
            low = far;
            high = x;
        }
        touching__turning_point(&rail, &wheel, &depth, &turned, work, tables, place, low, high, (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST_Y)), height, 1.0);
        if ((turned == INT64_C(1)) && (depth > deepest))
        {
            deep_points__append_point(work, rail, wheel, depth);
            deep_points__sort_last(work);
        }
    }
    return INT64_C(0);
}

/* The smallest overlap between neighbouring deepest points. */
static OUT_OF_LINE int64_t overlaps__find_saddles(array_double_1d work, array_double_1d tables, int64_t place, double height)
{
    int64_t entry_end;
    int64_t entry;
    int64_t point;
    int64_t following;
    double x;
    double y;
    double depth;
    int64_t turned;
    entry_end = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_COUNT))) - INT64_C(1);
    for (entry = INT64_C(0); entry < entry_end; entry += INT64_C(1))
    {
        point = layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_POINTS + layout__DEEP_POINT_SIZE * entry;
        following = layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_POINTS + layout__DEEP_POINT_SIZE * (entry + INT64_C(1));
        touching__turning_point(&x, &y, &depth, &turned, work, tables, place, (*cspan_at(&work, point + layout__DEEP_POINT_RAIL)), (*cspan_at(&work, following + layout__DEEP_POINT_RAIL)), 0.5 * ((*cspan_at(&work, point + layout__DEEP_POINT_WHEEL)) + (*cspan_at(&work, following + layout__DEEP_POINT_WHEEL))), height, -1.0);
        (*cspan_at(&work, point + layout__DEEP_POINT_SADDLE)) = x;
        (*cspan_at(&work, point + layout__DEEP_POINT_BETWEEN)) = depth;
    }
    return INT64_C(0);
}
