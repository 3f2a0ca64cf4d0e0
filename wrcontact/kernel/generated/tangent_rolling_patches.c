/* Generated from tangent_rolling_patches.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of rolling_patches.py.
 */

#include "tangent_rolling_patches.h"

/* Tangent of ``keep_rolling``. */
static inline int64_t tangent_rolling_patches__keep_rolling_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t rolling, double mirror, double mirror_t)
{
    int64_t index_end;
    int64_t index;
    int64_t part;
    int64_t rank;
    int64_t patch;
    int64_t result;
    (*cspan_at(&work_t, rolling + layout__ROLLING_SIDE_COUNT)) = 0.0;
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
        if ((rank > INT64_C(0)) && (rank <= layout__PATCH_LIMIT) && (rolling_patches__is_first_part(work, index) == INT64_C(1)))
        {
            patch = rolling + layout__ROLLING_SIDE_PATCHES + layout__ROLLING_PATCH_SIZE * (rank - INT64_C(1));
            tangent_sections__cut_patch_t(work, work_t, (int64_t)((*cspan_at(&work, part + layout__SOLVED_PART_PATCH))), patch);
            tangent_rolling_patches__place_strips_t(work, work_t, tables, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * (int64_t)((*cspan_at(&work, part + layout__SOLVED_PART_REGION))), patch, mirror, mirror_t);
            if (rank > (int64_t)((*cspan_at(&work, rolling + layout__ROLLING_SIDE_COUNT))))
            {
                (*cspan_at(&work_t, rolling + layout__ROLLING_SIDE_COUNT)) = 0.0;
                (*cspan_at(&work, rolling + layout__ROLLING_SIDE_COUNT)) = (double)(rank);
            }
        }
    }
    result = (int64_t)((*cspan_at(&work, rolling + layout__ROLLING_SIDE_COUNT)));
    return result;
}

/* Tangent of ``place_strips``. */
static inline int64_t tangent_rolling_patches__place_strips_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t region, int64_t patch, double mirror, double mirror_t)
{
    int64_t index_end;
    int64_t index;
    index_end = (int64_t)((*cspan_at(&work, patch + layout__ROLLING_PATCH_COUNT)));
    for (index = INT64_C(0); index < index_end; index += INT64_C(1))
    {
        tangent_rolling_patches__place_strip_t(work, work_t, tables, region, patch + layout__ROLLING_PATCH_STRIPS + layout__ROLLING_STRIP_SIZE * index, mirror, mirror_t);
    }
    return INT64_C(0);
}

/* Tangent of ``place_strip``. */
static inline int64_t tangent_rolling_patches__place_strip_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t region, int64_t strip, double mirror, double mirror_t)
{
    double away_t;
    double away;
    double abscissa_t;
    double abscissa;
    double v1;
    double v1_t;
    double height;
    double height_t;
    double slope;
    double slope_t;
    double y;
    double y_t;
    double z;
    double z_t;
    away_t = (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_STATION)) - (*cspan_at(&work_t, region + layout__REGION_OFFSET)) - (*cspan_at(&work_t, region + layout__REGION_STATION));
    away = (*cspan_at(&work, strip + layout__ROLLING_STRIP_STATION)) - (*cspan_at(&work, region + layout__REGION_OFFSET)) - (*cspan_at(&work, region + layout__REGION_STATION));
    abscissa_t = (*cspan_at(&work_t, region + layout__REGION_RAIL)) + (away_t * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS)) + away * (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS)));
    abscissa = (*cspan_at(&work, region + layout__REGION_RAIL)) + away * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS));
    if ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PRESSED)) == 1.0)
    {
        tangent_arc_length__rail_abscissa_t(&v1, &v1_t, tables, (*cspan_at(&work, region + layout__REGION_RAIL)), (*cspan_at(&work_t, region + layout__REGION_RAIL)), away, away_t);
        abscissa_t = v1_t;
        abscissa = v1;
    }
    tangent_profile_table__height_slope_t(&height, &height_t, &slope, &slope_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), abscissa, abscissa_t);
    tangent_rails__on_track_t(&y, &y_t, &z, &z_t, work, work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLACE))), (*cspan_at(&tables, layout__TABLES_RAIL_Y)), 0.0, (*cspan_at(&tables, layout__TABLES_RAIL_Y)) + abscissa, abscissa_t, height, height_t);
    (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_Y_TRACK)) = mirror_t * y + mirror * y_t;
    (*cspan_at(&work, strip + layout__ROLLING_STRIP_Y_TRACK)) = mirror * y;
    (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_Z_TRACK)) = z_t;
    (*cspan_at(&work, strip + layout__ROLLING_STRIP_Z_TRACK)) = z;
    tangent_profile_table__height_slope_t(&height, &height_t, &slope, &slope_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL))), (*cspan_at(&work, region + layout__REGION_WHEEL)) + abscissa - (*cspan_at(&work, region + layout__REGION_RAIL)), (*cspan_at(&work_t, region + layout__REGION_WHEEL)) + abscissa_t - (*cspan_at(&work_t, region + layout__REGION_RAIL)));
    (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_ROLLING_RADIUS)) = height_t;
    (*cspan_at(&work, strip + layout__ROLLING_STRIP_ROLLING_RADIUS)) = (*cspan_at(&tables, layout__TABLES_RADIUS)) + height;
    return INT64_C(0);
}
