/* Generated from wheelset/rolling_patches.py by tools/transpile_kernel.py; change that one.
 *
 * The patches of a wheel as the models of creep forces read them: cut into strips when they are solved, for
 * the solved patches of one wheel give way to those of the other.
 */

#include "rolling_patches.h"

/* Cut the heaviest solved patches of a side into strips, if creep forces are wanted; ``mirror`` = 1 on
 * the right, -1 on the left.
 */
static inline int64_t rolling_patches__keep_rolling(array_double_1d work, array_double_1d tables, int64_t rolling, double mirror)
{
    int64_t index_end;
    int64_t index;
    int64_t part;
    int64_t rank;
    int64_t patch;
    int64_t result;
    (*cspan_at(&work, rolling + layout__ROLLING_SIDE_COUNT)) = 0.0;
    if ((int64_t)((*cspan_at(&tables, layout__TABLES_TANGENTIAL))) == layout__TANGENTIAL_NONE)
    {
        return INT64_C(0);
    }
    index_end = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PART_COUNT)));
    for (index = INT64_C(0); index < index_end; index += INT64_C(1))
    {
        part = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PARTS + layout__SOLVED_PART_SIZE * index;
        rank = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_SIZE * (int64_t)((*cspan_at(&work, part + layout__SOLVED_PART_PATCH))) + layout__SOLVED_PATCH_RANK)));
        /* the first part of a patch tells its region */
        if ((rank > INT64_C(0)) && (rank <= layout__PATCH_LIMIT) && (rolling_patches__is_first_part(work, index) == INT64_C(1)))
        {
            patch = rolling + layout__ROLLING_SIDE_PATCHES + layout__ROLLING_PATCH_SIZE * (rank - INT64_C(1));
            sections__cut_patch(work, (int64_t)((*cspan_at(&work, part + layout__SOLVED_PART_PATCH))), patch);
            rolling_patches__place_strips(work, tables, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * (int64_t)((*cspan_at(&work, part + layout__SOLVED_PART_REGION))), patch, mirror);
            if (rank > (int64_t)((*cspan_at(&work, rolling + layout__ROLLING_SIDE_COUNT))))
            {
                (*cspan_at(&work, rolling + layout__ROLLING_SIDE_COUNT)) = (double)(rank);
            }
        }
    }
    result = (int64_t)((*cspan_at(&work, rolling + layout__ROLLING_SIDE_COUNT)));
    return result;
}

/* 1 if no part before ``number`` is of the same patch, else 0. */
static inline int64_t rolling_patches__is_first_part(array_double_1d work, int64_t number)
{
    int64_t index;
    int64_t first;
    first = INT64_C(1);
    for (index = INT64_C(0); index < number; index += INT64_C(1))
    {
        if ((int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PARTS + layout__SOLVED_PART_SIZE * index + layout__SOLVED_PART_PATCH))) == (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PARTS + layout__SOLVED_PART_SIZE * number + layout__SOLVED_PART_PATCH))))
        {
            first = INT64_C(0);
        }
    }
    return first;
}

/* Where the strips of a patch are in the track, and the wheel's rolling radius there. */
static inline int64_t rolling_patches__place_strips(array_double_1d work, array_double_1d tables, int64_t region, int64_t patch, double mirror)
{
    int64_t index_end;
    int64_t index;
    index_end = (int64_t)((*cspan_at(&work, patch + layout__ROLLING_PATCH_COUNT)));
    for (index = INT64_C(0); index < index_end; index += INT64_C(1))
    {
        rolling_patches__place_strip(work, tables, region, patch + layout__ROLLING_PATCH_STRIPS + layout__ROLLING_STRIP_SIZE * index, mirror);
    }
    return INT64_C(0);
}

/* Place of one strip.  Wheel and rail lie on each other: from the region's point on, both abscissae run
 * alike.
 */
static inline int64_t rolling_patches__place_strip(array_double_1d work, array_double_1d tables, int64_t region, int64_t strip, double mirror)
{
    double away;
    double abscissa;
    double height;
    double slope;
    double y;
    double z;
    away = (*cspan_at(&work, strip + layout__ROLLING_STRIP_STATION)) - (*cspan_at(&work, region + layout__REGION_OFFSET)) - (*cspan_at(&work, region + layout__REGION_STATION));
    abscissa = (*cspan_at(&work, region + layout__REGION_RAIL)) + away * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS));
    if ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PRESSED)) == 1.0)
    {
        abscissa = arc_length__rail_abscissa(tables, (*cspan_at(&work, region + layout__REGION_RAIL)), away);
    }
    profile_table__height_slope(&height, &slope, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), abscissa);
    rails__on_track(&y, &z, work, layout__WORK_CONTACT + layout__CONTACT_FRAME + (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLACE))), (*cspan_at(&tables, layout__TABLES_RAIL_Y)), (*cspan_at(&tables, layout__TABLES_RAIL_Y)) + abscissa, height);
    (*cspan_at(&work, strip + layout__ROLLING_STRIP_Y_TRACK)) = mirror * y;
    (*cspan_at(&work, strip + layout__ROLLING_STRIP_Z_TRACK)) = z;
    profile_table__height_slope(&height, &slope, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL))), (*cspan_at(&work, region + layout__REGION_WHEEL)) + abscissa - (*cspan_at(&work, region + layout__REGION_RAIL)));
    (*cspan_at(&work, strip + layout__ROLLING_STRIP_ROLLING_RADIUS)) = (*cspan_at(&tables, layout__TABLES_RADIUS)) + height;
    return INT64_C(0);
}
