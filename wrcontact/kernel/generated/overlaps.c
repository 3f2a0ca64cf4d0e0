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
    int64_t result;
    place = side + layout__SIDE_SEARCH_PLACE;
    node = raster__node_below(tables, (int64_t)((*cspan_at(&tables, layout__TABLES_SCAN))), (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST_Y)));
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_COUNT)) = 0.0;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_HEIGHT)) = height;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_KNOWN)) = (double)(-INT64_C(1));
    start = overlap_samples__walk_overlap(work, tables, place, state, node, -INT64_C(1), height, layout__OVERLAP_LIMIT - INT64_C(1)) + INT64_C(1);
    stop = overlap_samples__walk_overlap(work, tables, place, state, node + INT64_C(1), INT64_C(1), height, layout__OVERLAP_LIMIT);
    for (entry = start; entry < stop - INT64_C(1); entry += INT64_C(1))
    {
        if ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_SAMPLES + layout__SAMPLES_ADJACENT + (entry + INT64_C(1)))) == 1.0)
        {
            overlaps__list_in_cell(work, tables, place, entry);
        }
    }
    overlaps__list_beside_smallest_gap(work, tables, side);
    if ((int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_COUNT))) > INT64_C(0))
    {
        overlaps__find_saddles(work, tables, place);
        deep_points__merge_points(work);
    }
    result = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_COUNT)));
    return result;
}

/* List the deepest points between the sample ``entry`` and the next one. */
static OUT_OF_LINE int64_t overlaps__list_in_cell(array_double_1d work, array_double_1d tables, int64_t place, int64_t entry)
{
    double rise;
    double following;
    int64_t hidden;
    int64_t finest;
    int64_t listed;
    rise = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_SAMPLES + layout__SAMPLES_RISE + entry));
    following = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_SAMPLES + layout__SAMPLES_RISE + (entry + INT64_C(1))));
    hidden = overlaps__may_turn(work, tables, place, entry);
    if ((hidden == INT64_C(0)) && (!((rise > 0.0) && (following <= 0.0))))
    {
        return INT64_C(0);
    }
    overlaps__open_stretch(work, tables, place, entry);
    finest = overlaps__OVERLAP_PART;
    listed = INT64_C(0);
    if (hidden == INT64_C(1))
    {
        /* the samples are straight down: what counts is the rise along the normal */
        overlaps__widen_bounds(work, tables, place, entry);
        if ((int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_KNOWN))) == entry)
        {
            overlaps__copy_rise(work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_END, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_FIRST);
        }
        else
        {
            overlaps__measure_rise(work, tables, place, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_FIRST, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_SAMPLES + layout__SAMPLES_WHEEL + entry)));
        }
        overlaps__measure_rise(work, tables, place, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_LAST, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_SAMPLES + layout__SAMPLES_WHEEL + (entry + INT64_C(1)))));
        overlaps__copy_rise(work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_LAST, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_END);
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_KNOWN)) = (double)(entry + INT64_C(1));
        finest = overlaps__HIDDEN_PART;
    }
    else if ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_LEAST)) > 0.0)
    {
        listed = overlaps__list_turning_point(work, tables, place, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_FIRST + layout__RISE_POINT_X)), (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_LAST + layout__RISE_POINT_X)), (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_WHEEL)));
    }
    else
    {
        overlaps__widen_bounds(work, tables, place, entry);
    }
    if (listed == INT64_C(0))
    {
        if (hidden == INT64_C(0))
        {
            (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_LEAST)) = double_min(2, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_LEAST)), 0.0);
            overlaps__widen_stretch(work, tables, place);
        }
        overlaps__list_on_stretch(work, tables, place, finest);
    }
    return INT64_C(0);
}

/* Open the stretch between the sample ``entry`` and the next one, with bounds for the overlap straight
 * down.
 */
static OUT_OF_LINE int64_t overlaps__open_stretch(array_double_1d work, array_double_1d tables, int64_t place, int64_t entry)
{
    int64_t node;
    overlaps__set_point(work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_FIRST, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_SAMPLES + layout__SAMPLES_RAIL + entry)), (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_SAMPLES + layout__SAMPLES_RISE + entry)), 0.0);
    overlaps__set_point(work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_LAST, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_SAMPLES + layout__SAMPLES_RAIL + (entry + INT64_C(1)))), (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_SAMPLES + layout__SAMPLES_RISE + (entry + INT64_C(1)))), 0.0);
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_WHEEL)) = 0.5 * ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_SAMPLES + layout__SAMPLES_WHEEL + entry)) + (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_SAMPLES + layout__SAMPLES_WHEEL + (entry + INT64_C(1)))));
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_WIDTH)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_SAMPLES + layout__SAMPLES_WHEEL + (entry + INT64_C(1)))) - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_SAMPLES + layout__SAMPLES_WHEEL + entry));
    node = raster__node_below(tables, (int64_t)((*cspan_at(&tables, layout__TABLES_SCAN))), (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_SAMPLES + layout__SAMPLES_WHEEL + entry)));
    bounds__bend_bounds(cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_LEAST), cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_MOST), tables, work, (int64_t)((*cspan_at(&tables, layout__TABLES_SCAN))), place, node, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_FIRST + layout__RISE_POINT_X)));
    return INT64_C(0);
}

/* Write ``point`` to ``copy``. */
static OUT_OF_LINE int64_t overlaps__copy_rise(array_double_1d work, int64_t point, int64_t copy)
{
    overlaps__set_point(work, copy, (*cspan_at(&work, point + layout__RISE_POINT_X)), (*cspan_at(&work, point + layout__RISE_POINT_RISE)), (*cspan_at(&work, point + layout__RISE_POINT_RATE)));
    return INT64_C(0);
}

/* Write a place [m] with its rise [-] and the derivative of that [1/m]. */
static OUT_OF_LINE int64_t overlaps__set_point(array_double_1d work, int64_t point, double x, double rise, double rate)
{
    (*cspan_at(&work, point + layout__RISE_POINT_X)) = x;
    (*cspan_at(&work, point + layout__RISE_POINT_RISE)) = rise;
    (*cspan_at(&work, point + layout__RISE_POINT_RATE)) = rate;
    return INT64_C(0);
}

/* Rise of the overlap along the normal at ``point``, sought from the wheel's ``y`` [m]; zeros where there
 * is none.
 */
static OUT_OF_LINE int64_t overlaps__measure_rise(array_double_1d work, array_double_1d tables, int64_t place, int64_t point, double y)
{
    double depth;
    double rise;
    double bend;
    double z;
    double slope;
    double wheel_bend;
    int64_t found;
    double z_rail;
    pressed__meet_wheel(&y, &depth, &rise, &bend, &z, &slope, &wheel_bend, &found, work, tables, place, (*cspan_at(&work, point + layout__RISE_POINT_X)), y, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_HEIGHT)), pressed__NODE_SHARP);
    (*cspan_at(&work, point + layout__RISE_POINT_RISE)) = 0.0;
    (*cspan_at(&work, point + layout__RISE_POINT_RATE)) = 0.0;
    if (found == INT64_C(1))
    {
        profile_table__height_slope(&z_rail, &slope, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), (*cspan_at(&work, point + layout__RISE_POINT_X)));
        (*cspan_at(&work, point + layout__RISE_POINT_RISE)) = rise;
        (*cspan_at(&work, point + layout__RISE_POINT_RATE)) = bend * sqrt(1.0 + slope * slope);
    }
    return INT64_C(0);
}

/* Widen the bounds of the stretch after the sample ``entry`` to those of the bend along the normals.
 *
 * A normal meets the wheel aside of the sample, in the next cell at most, and by a share of NORMAL_SHARE
 * sooner or later.
 */
static OUT_OF_LINE int64_t overlaps__widen_bounds(array_double_1d work, array_double_1d tables, int64_t place, int64_t entry)
{
    int64_t scan;
    int64_t node;
    double low;
    double high;
    double share;
    scan = (int64_t)((*cspan_at(&tables, layout__TABLES_SCAN)));
    node = raster__node_below(tables, scan, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_SAMPLES + layout__SAMPLES_WHEEL + entry)));
    if (node > INT64_C(0))
    {
        bounds__bend_bounds(&low, &high, tables, work, scan, place, node - INT64_C(1), (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_FIRST + layout__RISE_POINT_X)));
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_LEAST)) = double_min(2, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_LEAST)), low);
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_MOST)) = double_max(2, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_MOST)), high);
    }
    if (node + INT64_C(2) < (int64_t)((*cspan_at(&tables, scan + layout__SCAN_COUNT))))
    {
        bounds__bend_bounds(&low, &high, tables, work, scan, place, node + INT64_C(1), (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_FIRST + layout__RISE_POINT_X)));
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_LEAST)) = double_min(2, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_LEAST)), low);
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_MOST)) = double_max(2, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_MOST)), high);
    }
    share = overlaps__NORMAL_SHARE * (*cspan_at(&tables, scan + layout__SCAN_NODES + layout__SCAN_NODE_SIZE * node + layout__SCAN_NODE_STEEPEST_BENDS + INT64_C(0)));
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_LEAST)) -= share;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_MOST)) += share;
    return INT64_C(0);
}

/* List the deepest point between two rail abscissae [m], sought from the wheel's ``y`` [m], if there is
 * an overlap and it is not listed yet; 1 if there is a turning point, else 0.
 */
static OUT_OF_LINE int64_t overlaps__list_turning_point(array_double_1d work, array_double_1d tables, int64_t place, double low, double high, double y)
{
    double rail;
    double wheel;
    double depth;
    int64_t turned;
    touching__turning_point(&rail, &wheel, &depth, &turned, work, tables, place, low, high, y, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_HEIGHT)), 1.0);
    if ((turned == INT64_C(1)) && (depth > 0.0) && (deep_points__is_listed(work, rail) == INT64_C(0)))
    {
        deep_points__append_point(work, rail, wheel, depth);
    }
    return turned;
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

/* Widen the stretch until the overlap rises from its first end and falls to its last one: the samples are
 * straight down, and their slope may change its sign a little before the overlap along the normal has its
 * maximum.
 */
static OUT_OF_LINE int64_t overlaps__widen_stretch(array_double_1d work, array_double_1d tables, int64_t place)
{
    double step;
    double low;
    double high;
    step = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_LAST + layout__RISE_POINT_X)) - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_FIRST + layout__RISE_POINT_X));
    low = overlaps__bracket_end(work, tables, place, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_FIRST + layout__RISE_POINT_X)), -step);
    high = overlaps__bracket_end(work, tables, place, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_LAST + layout__RISE_POINT_X)), step);
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_WIDTH)) *= (high - low) / step;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_FIRST + layout__RISE_POINT_X)) = low;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_LAST + layout__RISE_POINT_X)) = high;
    return INT64_C(0);
}

/* ``x``, or the first place some ``step`` [m] further, from where the overlap rises towards the other
 * side.
 */
static OUT_OF_LINE double overlaps__bracket_end(array_double_1d work, array_double_1d tables, int64_t place, double x, double step)
{
    int64_t rail;
    double y;
    int64_t i;
    double depth;
    double rise;
    double bend;
    double z;
    double slope;
    double wheel_bend;
    int64_t found;
    double result;
    rail = (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL)));
    y = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_WHEEL));
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
        pressed__meet_wheel(&y, &depth, &rise, &bend, &z, &slope, &wheel_bend, &found, work, tables, place, x, y, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_HEIGHT)), pressed__LINE_SHARP);
        if ((found == INT64_C(0)) || (rise * step < 0.0))
        {
            break;
        }
        x += step;
    }
    return x;
}

/* List the deepest points on the stretch: on nearly conformal profiles the joints of their arcs leave
 * several, of which a bracket by itself would end at either.
 *
 * It is halved until the bounds show that the overlap has one largest value at most on each part, or a part
 * is ``finest`` of the PARTS.  There the tangents of the rise show what may still be hidden.
 */
static OUT_OF_LINE int64_t overlaps__list_on_stretch(array_double_1d work, array_double_1d tables, int64_t place, int64_t finest)
{
    double each;
    int64_t start;
    int64_t size;
    int64_t stop;
    int64_t once;
    each = ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_LAST + layout__RISE_POINT_X)) - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_FIRST + layout__RISE_POINT_X))) / (double)(overlaps__PARTS);
    overlaps__copy_rise(work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_FIRST, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_BEFORE);
    start = INT64_C(0);
    size = overlaps__PARTS;
    while(start < overlaps__PARTS)
    {
        stop = start + size;
        if (stop < overlaps__PARTS)
        {
            (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_AFTER + layout__RISE_POINT_X)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_FIRST + layout__RISE_POINT_X)) + each * (double)(stop);
            overlaps__measure_rise(work, tables, place, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_AFTER, overlaps__wheel_beside(work, (double)(stop)));
        }
        else
        {
            overlaps__copy_rise(work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_LAST, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_AFTER);
        }
        once = overlaps__turns_once(work, (double)(size) / (double)(overlaps__PARTS));
        if ((size > finest) && (once == INT64_C(0)))
        {
            size = py_floor_div_int64_t(size, INT64_C(2));
        }
        else
        {
            if (((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_BEFORE + layout__RISE_POINT_RISE)) > 0.0) && ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_AFTER + layout__RISE_POINT_RISE)) <= 0.0))
            {
                overlaps__list_turning_point(work, tables, place, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_BEFORE + layout__RISE_POINT_X)), (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_AFTER + layout__RISE_POINT_X)), overlaps__wheel_beside(work, 0.5 * (double)(start + stop)));
            }
            else if (once == INT64_C(0))
            {
                overlaps__list_hidden_point(work, tables, place);
            }
            overlaps__copy_rise(work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_AFTER, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_BEFORE);
            start = stop;
            while((start < overlaps__PARTS) && (size < overlaps__PARTS) && (pyc_modulo(start, (INT64_C(2) * size)) == INT64_C(0)))
            {
                size = INT64_C(2) * size;
            }
        }
    }
    return INT64_C(0);
}

/* About which wheel abscissa [m] belongs to the place that many ``parts`` after the first end of the
 * stretch.
 */
static OUT_OF_LINE double overlaps__wheel_beside(array_double_1d work, double parts)
{
    double result;
    result = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_WHEEL)) + (parts / (double)(overlaps__PARTS) - 0.5) * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_WIDTH));
    return result;
}

/* 1 if the overlap certainly has one largest value at most on the open part, a ``share`` of the stretch,
 * else 0.
 */
static OUT_OF_LINE int64_t overlaps__turns_once(array_double_1d work, double share)
{
    double before;
    double after;
    int64_t answer;
    before = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_BEFORE + layout__RISE_POINT_RISE));
    after = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_AFTER + layout__RISE_POINT_RISE));
    answer = INT64_C(0);
    if ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_LEAST)) > 0.0)
    {
        answer = INT64_C(1);
    }
    else if (before * after > 0.0)
    {
        answer = bounds__only_rises_or_falls((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_LEAST)), (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_MOST)), share * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_WIDTH)), -before, -after);
    }
    return answer;
}

/* List the deepest point of a hump on the open part if the overlap rises, or falls, at both ends of it.
 *
 * A rise that bends one way, or has one kink, is nowhere beyond its tangents at both ends.  While those
 * meet beyond zero, the rise is measured where they meet, and the part ends there.
 */
static OUT_OF_LINE int64_t overlaps__list_hidden_point(array_double_1d work, array_double_1d tables, int64_t place)
{
    double sign;
    int64_t i;
    double width;
    double step;
    overlaps__copy_rise(work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_BEFORE, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_LOW);
    overlaps__copy_rise(work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_AFTER, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_HIGH);
    sign = 1.0;
    if ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_LOW + layout__RISE_POINT_RISE)) < 0.0)
    {
        sign = -1.0;
    }
    for (i = INT64_C(0); i < overlaps__HUMP_ITERATIONS; i += INT64_C(1))
    {
        if (!(((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_LOW + layout__RISE_POINT_RISE)) * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_HIGH + layout__RISE_POINT_RISE)) > 0.0) && (sign * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_LOW + layout__RISE_POINT_RATE)) < 0.0) && (sign * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_HIGH + layout__RISE_POINT_RATE)) > 0.0)))
        {
            return INT64_C(0);
        }
        width = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_HIGH + layout__RISE_POINT_X)) - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_LOW + layout__RISE_POINT_X));
        step = ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_LOW + layout__RISE_POINT_RISE)) - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_HIGH + layout__RISE_POINT_RISE)) + (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_HIGH + layout__RISE_POINT_RATE)) * width) / ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_HIGH + layout__RISE_POINT_RATE)) - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_LOW + layout__RISE_POINT_RATE)));
        if (sign * ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_LOW + layout__RISE_POINT_RISE)) + (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_LOW + layout__RISE_POINT_RATE)) * step) > 0.0)
        {
            return INT64_C(0);
        }
        if (!((step > 0.0) && (step < width)))
        {
            step = 0.5 * width;
        }
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_MIDDLE + layout__RISE_POINT_X)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_LOW + layout__RISE_POINT_X)) + step;
        overlaps__measure_rise(work, tables, place, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_MIDDLE, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_WHEEL)));
        if (sign * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_MIDDLE + layout__RISE_POINT_RISE)) < 0.0)
        {
            if (sign > 0.0)
            {
                overlaps__list_turning_point(work, tables, place, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_LOW + layout__RISE_POINT_X)), (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_MIDDLE + layout__RISE_POINT_X)), (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_WHEEL)));
            }
            else
            {
                overlaps__list_turning_point(work, tables, place, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_MIDDLE + layout__RISE_POINT_X)), (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_HIGH + layout__RISE_POINT_X)), (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_WHEEL)));
            }
            return INT64_C(0);
        }
        if (sign * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_MIDDLE + layout__RISE_POINT_RATE)) < 0.0)
        {
            overlaps__copy_rise(work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_MIDDLE, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_LOW);
        }
        else
        {
            overlaps__copy_rise(work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_MIDDLE, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_STRETCH + layout__STRETCH_HIGH);
        }
    }
    return INT64_C(0);
}

/* List the deepest point beside the smallest gap where none on the list is as deep as the overlap there:
 * between two scan nodes on nearly conformal profiles the slope of the overlap can change its sign three
 * times.
 */
static OUT_OF_LINE int64_t overlaps__list_beside_smallest_gap(array_double_1d work, array_double_1d tables, int64_t side)
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
    double wheel_bend;
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
    pressed__meet_wheel(&y, &depth, &rise, &bend, &z, &slope, &wheel_bend, &found, work, tables, place, x, (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST_Y)), (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_HEIGHT)), pressed__LINE_SHARP);
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
            pressed__meet_wheel(&y, &depth, &rise, &bend, &z, &slope, &wheel_bend, &found, work, tables, place, far, y, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_HEIGHT)), pressed__LINE_SHARP);
            step *= 2.0;
        }
        low = x;
        high = far;
        if (far < x)
        {
            low = far;
            high = x;
        }
        touching__turning_point(&rail, &wheel, &depth, &turned, work, tables, place, low, high, (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST_Y)), (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_HEIGHT)), 1.0);
        if ((turned == INT64_C(1)) && (depth > deepest))
        {
            deep_points__append_point(work, rail, wheel, depth);
            deep_points__sort_last(work);
        }
    }
    return INT64_C(0);
}

/* The smallest overlap between neighbouring deepest points. */
static OUT_OF_LINE int64_t overlaps__find_saddles(array_double_1d work, array_double_1d tables, int64_t place)
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
        touching__turning_point(&x, &y, &depth, &turned, work, tables, place, (*cspan_at(&work, point + layout__DEEP_POINT_RAIL)), (*cspan_at(&work, following + layout__DEEP_POINT_RAIL)), 0.5 * ((*cspan_at(&work, point + layout__DEEP_POINT_WHEEL)) + (*cspan_at(&work, following + layout__DEEP_POINT_WHEEL))), (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_HEIGHT)), -1.0);
        (*cspan_at(&work, point + layout__DEEP_POINT_SADDLE)) = x;
        (*cspan_at(&work, point + layout__DEEP_POINT_BETWEEN)) = depth;
    }
    return INT64_C(0);
}
