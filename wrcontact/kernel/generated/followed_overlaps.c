/* Generated from contact/followed_overlaps.py by tools/transpile_kernel.py; change that one.
 *
 * Deepest points that are followed from one trial of an elastic wheelset to the next, which stands a few
 * micrometres away: a search for them costs as much as the rest of a trial.
 */

#include "followed_overlaps.h"

/* Note the deepest points on the list for the next trial. */
static inline int64_t followed_overlaps__keep_points(array_double_1d work, int64_t kept)
{
    int64_t entry_end;
    int64_t entry;
    (*cspan_at(&work, kept + layout__DEEP_POINTS_COUNT)) = (double)((int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_COUNT))));
    entry_end = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_COUNT)));
    for (entry = INT64_C(0); entry < entry_end; entry += INT64_C(1))
    {
        deep_points__copy_point(work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_POINTS + layout__DEEP_POINT_SIZE * entry, kept + layout__DEEP_POINTS_POINTS + layout__DEEP_POINT_SIZE * entry);
    }
    return INT64_C(0);
}

/* List the deepest points that ``kept`` ones have become under the wheel at ``place``, moved down by
 * ``height`` [m], with the saddles between them; their number, or 0 if one was lost or moved too far.
 */
static inline int64_t followed_overlaps__follow_overlaps(array_double_1d work, array_double_1d tables, int64_t kept, int64_t place, double height)
{
    int64_t entry_end;
    int64_t entry;
    int64_t point;
    double x;
    double rail;
    double wheel;
    double depth;
    int64_t turned;
    int64_t result;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_HEIGHT)) = height;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_COUNT)) = (double)((int64_t)((*cspan_at(&work, kept + layout__DEEP_POINTS_COUNT))));
    entry_end = (int64_t)((*cspan_at(&work, kept + layout__DEEP_POINTS_COUNT)));
    for (entry = INT64_C(0); entry < entry_end; entry += INT64_C(1))
    {
        point = layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_POINTS + layout__DEEP_POINT_SIZE * entry;
        deep_points__copy_point(work, kept + layout__DEEP_POINTS_POINTS + layout__DEEP_POINT_SIZE * entry, point);
        x = (*cspan_at(&work, point + layout__DEEP_POINT_RAIL));
        touching__turning_point(&rail, &wheel, &depth, &turned, work, tables, place, x - followed_overlaps__FOLLOWED, x + followed_overlaps__FOLLOWED, (*cspan_at(&work, point + layout__DEEP_POINT_WHEEL)), height, 1.0);
        if ((turned == INT64_C(0)) || (!(depth > 0.0)))
        {
            return INT64_C(0);
        }
        (*cspan_at(&work, point + layout__DEEP_POINT_RAIL)) = rail;
        (*cspan_at(&work, point + layout__DEEP_POINT_WHEEL)) = wheel;
        (*cspan_at(&work, point + layout__DEEP_POINT_DEPTH)) = depth;
    }
    entry_end = (int64_t)((*cspan_at(&work, kept + layout__DEEP_POINTS_COUNT))) - INT64_C(1);
    for (entry = INT64_C(0); entry < entry_end; entry += INT64_C(1))
    {
        followed_overlaps__follow_saddle(work, tables, place, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_POINTS + layout__DEEP_POINT_SIZE * entry, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_POINTS + layout__DEEP_POINT_SIZE * (entry + INT64_C(1)), height);
    }
    result = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_COUNT)));
    return result;
}

/* Find the saddle between two neighbouring points from where it was. */
static inline int64_t followed_overlaps__follow_saddle(array_double_1d work, array_double_1d tables, int64_t place, int64_t point, int64_t following, double height)
{
    double y;
    double reach;
    double x;
    double depth;
    int64_t turned;
    y = 0.5 * ((*cspan_at(&work, point + layout__DEEP_POINT_WHEEL)) + (*cspan_at(&work, following + layout__DEEP_POINT_WHEEL)));
    reach = followed_overlaps__FOLLOWED;
    if ((*cspan_at(&work, point + layout__DEEP_POINT_SADDLE)) - (*cspan_at(&work, point + layout__DEEP_POINT_RAIL)) < reach)
    {
        reach = (*cspan_at(&work, point + layout__DEEP_POINT_SADDLE)) - (*cspan_at(&work, point + layout__DEEP_POINT_RAIL));
    }
    if ((*cspan_at(&work, following + layout__DEEP_POINT_RAIL)) - (*cspan_at(&work, point + layout__DEEP_POINT_SADDLE)) < reach)
    {
        reach = (*cspan_at(&work, following + layout__DEEP_POINT_RAIL)) - (*cspan_at(&work, point + layout__DEEP_POINT_SADDLE));
    }
    touching__turning_point(&x, &y, &depth, &turned, work, tables, place, (*cspan_at(&work, point + layout__DEEP_POINT_SADDLE)) - reach, (*cspan_at(&work, point + layout__DEEP_POINT_SADDLE)) + reach, y, height, -1.0);
    if (turned == INT64_C(0))
    {
        touching__turning_point(&x, &y, &depth, &turned, work, tables, place, (*cspan_at(&work, point + layout__DEEP_POINT_RAIL)), (*cspan_at(&work, following + layout__DEEP_POINT_RAIL)), 0.5 * ((*cspan_at(&work, point + layout__DEEP_POINT_WHEEL)) + (*cspan_at(&work, following + layout__DEEP_POINT_WHEEL))), height, -1.0);
    }
    (*cspan_at(&work, point + layout__DEEP_POINT_SADDLE)) = x;
    (*cspan_at(&work, point + layout__DEEP_POINT_BETWEEN)) = depth;
    return INT64_C(0);
}
