/* Generated from contact/deep_points.py by tools/transpile_kernel.py; change that one.
 *
 * The list of deepest points of the overlap, in the order of the rail, with the saddles between them.
 */

#include "deep_points.h"

/* Write ``point`` to ``copy``. */
static OUT_OF_LINE int64_t deep_points__copy_point(array_double_1d work, int64_t point, int64_t copy)
{
    (*cspan_at(&work, copy + layout__DEEP_POINT_RAIL)) = (*cspan_at(&work, point + layout__DEEP_POINT_RAIL));
    (*cspan_at(&work, copy + layout__DEEP_POINT_WHEEL)) = (*cspan_at(&work, point + layout__DEEP_POINT_WHEEL));
    (*cspan_at(&work, copy + layout__DEEP_POINT_DEPTH)) = (*cspan_at(&work, point + layout__DEEP_POINT_DEPTH));
    (*cspan_at(&work, copy + layout__DEEP_POINT_SADDLE)) = (*cspan_at(&work, point + layout__DEEP_POINT_SADDLE));
    (*cspan_at(&work, copy + layout__DEEP_POINT_BETWEEN)) = (*cspan_at(&work, point + layout__DEEP_POINT_BETWEEN));
    return INT64_C(0);
}

/* List a deepest point at the end. */
static OUT_OF_LINE int64_t deep_points__append_point(array_double_1d work, double rail, double wheel, double depth)
{
    int64_t count;
    int64_t point;
    count = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_COUNT)));
    if (count < layout__DEEP_LIMIT)
    {
        point = layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_POINTS + layout__DEEP_POINT_SIZE * count;
        (*cspan_at(&work, point + layout__DEEP_POINT_RAIL)) = rail;
        (*cspan_at(&work, point + layout__DEEP_POINT_WHEEL)) = wheel;
        (*cspan_at(&work, point + layout__DEEP_POINT_DEPTH)) = depth;
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_COUNT)) = (double)(count + INT64_C(1));
    }
    return INT64_C(0);
}

/* Bring the last point listed to its place along the rail. */
static OUT_OF_LINE int64_t deep_points__sort_last(array_double_1d work)
{
    int64_t entry;
    double rail;
    double wheel;
    double depth;
    int64_t point;
    entry = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_COUNT))) - INT64_C(1);
    rail = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_POINTS + layout__DEEP_POINT_SIZE * entry + layout__DEEP_POINT_RAIL));
    wheel = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_POINTS + layout__DEEP_POINT_SIZE * entry + layout__DEEP_POINT_WHEEL));
    depth = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_POINTS + layout__DEEP_POINT_SIZE * entry + layout__DEEP_POINT_DEPTH));
    while((entry > INT64_C(0)) && (rail < (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_POINTS + layout__DEEP_POINT_SIZE * (entry - INT64_C(1)) + layout__DEEP_POINT_RAIL))))
    {
        deep_points__copy_point(work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_POINTS + layout__DEEP_POINT_SIZE * (entry - INT64_C(1)), layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_POINTS + layout__DEEP_POINT_SIZE * entry);
        entry -= INT64_C(1);
    }
    point = layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_POINTS + layout__DEEP_POINT_SIZE * entry;
    (*cspan_at(&work, point + layout__DEEP_POINT_RAIL)) = rail;
    (*cspan_at(&work, point + layout__DEEP_POINT_WHEEL)) = wheel;
    (*cspan_at(&work, point + layout__DEEP_POINT_DEPTH)) = depth;
    return INT64_C(0);
}

/* 1 if the last point listed is at ``x`` [m] or beyond, else 0. */
static OUT_OF_LINE int64_t deep_points__is_listed(array_double_1d work, double x)
{
    int64_t entry;
    int64_t listed;
    listed = INT64_C(0);
    entry = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_COUNT))) - INT64_C(1);
    if (entry >= INT64_C(0))
    {
        if (x < (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_POINTS + layout__DEEP_POINT_SIZE * entry + layout__DEEP_POINT_RAIL)) + deep_points__SAME_POINT)
        {
            listed = INT64_C(1);
        }
    }
    return listed;
}

/* The deepest of the list. */
static OUT_OF_LINE int64_t deep_points__deepest_entry(array_double_1d work)
{
    int64_t entry_end;
    int64_t entry;
    int64_t best;
    best = INT64_C(0);
    entry_end = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_COUNT)));
    for (entry = INT64_C(0); entry < entry_end; entry += INT64_C(1))
    {
        if ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_POINTS + layout__DEEP_POINT_SIZE * entry + layout__DEEP_POINT_DEPTH)) > (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_POINTS + layout__DEEP_POINT_SIZE * best + layout__DEEP_POINT_DEPTH)))
        {
            best = entry;
        }
    }
    return best;
}

/* The least deep of the list. */
static OUT_OF_LINE int64_t deep_points__shallowest_entry(array_double_1d work)
{
    int64_t entry_end;
    int64_t entry;
    int64_t least;
    least = INT64_C(0);
    entry_end = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_COUNT)));
    for (entry = INT64_C(0); entry < entry_end; entry += INT64_C(1))
    {
        if ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_POINTS + layout__DEEP_POINT_SIZE * entry + layout__DEEP_POINT_DEPTH)) < (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_POINTS + layout__DEEP_POINT_SIZE * least + layout__DEEP_POINT_DEPTH)))
        {
            least = entry;
        }
    }
    return least;
}

/* Leave only the deepest of the list, which then has no bounds. */
static OUT_OF_LINE int64_t deep_points__keep_deepest(array_double_1d work)
{
    deep_points__copy_point(work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_POINTS + layout__DEEP_POINT_SIZE * deep_points__deepest_entry(work), layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_POINTS);
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_COUNT)) = 1.0;
    return INT64_C(0);
}

/* Take a point off the list with its own saddle. */
static OUT_OF_LINE int64_t deep_points__remove_point(array_double_1d work, int64_t entry)
{
    int64_t count;
    int64_t i;
    count = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_COUNT)));
    for (i = entry; i < count - INT64_C(1); i += INT64_C(1))
    {
        deep_points__copy_point(work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_POINTS + layout__DEEP_POINT_SIZE * (i + INT64_C(1)), layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_POINTS + layout__DEEP_POINT_SIZE * i);
    }
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_COUNT)) = (double)(count - INT64_C(1));
    return INT64_C(0);
}

/* Leave out a deepest point; of the saddles beside it the less deep one stays. */
static OUT_OF_LINE int64_t deep_points__drop_point(array_double_1d work, int64_t entry)
{
    int64_t point;
    int64_t before;
    if ((entry > INT64_C(0)) && (entry < (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_COUNT))) - INT64_C(1)))
    {
        point = layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_POINTS + layout__DEEP_POINT_SIZE * entry;
        before = layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_POINTS + layout__DEEP_POINT_SIZE * (entry - INT64_C(1));
        if ((*cspan_at(&work, point + layout__DEEP_POINT_BETWEEN)) < (*cspan_at(&work, before + layout__DEEP_POINT_BETWEEN)))
        {
            (*cspan_at(&work, before + layout__DEEP_POINT_BETWEEN)) = (*cspan_at(&work, point + layout__DEEP_POINT_BETWEEN));
            (*cspan_at(&work, before + layout__DEEP_POINT_SADDLE)) = (*cspan_at(&work, point + layout__DEEP_POINT_SADDLE));
        }
    }
    deep_points__remove_point(work, entry);
    return INT64_C(0);
}

/* Join points with a low saddle between them, or hardly one, and keep the deepest REGION_LIMIT. */
static OUT_OF_LINE int64_t deep_points__merge_points(array_double_1d work)
{
    double depth;
    int64_t entry;
    int64_t point;
    int64_t following;
    double lower;
    int64_t less;
    depth = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_POINTS + layout__DEEP_POINT_SIZE * deep_points__deepest_entry(work) + layout__DEEP_POINT_DEPTH));
    entry = INT64_C(0);
    while(entry < (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_COUNT))) - INT64_C(1))
    {
        point = layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_POINTS + layout__DEEP_POINT_SIZE * entry;
        following = layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_POINTS + layout__DEEP_POINT_SIZE * (entry + INT64_C(1));
        lower = (*cspan_at(&work, point + layout__DEEP_POINT_DEPTH));
        if (lower > (*cspan_at(&work, following + layout__DEEP_POINT_DEPTH)))
        {
            lower = (*cspan_at(&work, following + layout__DEEP_POINT_DEPTH));
        }
        if ((depth - (*cspan_at(&work, point + layout__DEEP_POINT_BETWEEN)) < deep_points__MERGE * depth) || (lower - (*cspan_at(&work, point + layout__DEEP_POINT_BETWEEN)) < deep_points__LEAST_HUMP))
        {
            less = entry;
            if ((*cspan_at(&work, point + layout__DEEP_POINT_DEPTH)) > (*cspan_at(&work, following + layout__DEEP_POINT_DEPTH)))
            {
                less = entry + INT64_C(1);
                /* the saddle between the two goes, the one on the far side stays */
                (*cspan_at(&work, point + layout__DEEP_POINT_SADDLE)) = (*cspan_at(&work, following + layout__DEEP_POINT_SADDLE));
                (*cspan_at(&work, point + layout__DEEP_POINT_BETWEEN)) = (*cspan_at(&work, following + layout__DEEP_POINT_BETWEEN));
            }
            deep_points__remove_point(work, less);
        }
        else
        {
            entry += INT64_C(1);
        }
    }
    while((int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_COUNT))) > layout__REGION_LIMIT)
    {
        deep_points__drop_point(work, deep_points__shallowest_entry(work));
    }
    return INT64_C(0);
}
