/* Generated from tangent_filling.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of filling.py.
 */

#include "tangent_filling.h"

/* Tangent of ``clear_totals``. */
static inline int64_t tangent_filling__clear_totals_t(array_double_1d work, array_double_1d work_t, int64_t totals, double start, double start_t)
{
    (*cspan_at(&work_t, totals + layout__PATCH_TOTALS_LOAD)) = 0.0;
    (*cspan_at(&work, totals + layout__PATCH_TOTALS_LOAD)) = 0.0;
    (*cspan_at(&work_t, totals + layout__PATCH_TOTALS_AREA)) = 0.0;
    (*cspan_at(&work, totals + layout__PATCH_TOTALS_AREA)) = 0.0;
    (*cspan_at(&work_t, totals + layout__PATCH_TOTALS_MOMENT)) = 0.0;
    (*cspan_at(&work, totals + layout__PATCH_TOTALS_MOMENT)) = 0.0;
    (*cspan_at(&work_t, totals + layout__PATCH_TOTALS_CENTROID)) = 0.0;
    (*cspan_at(&work, totals + layout__PATCH_TOTALS_CENTROID)) = 0.0;
    (*cspan_at(&work_t, totals + layout__PATCH_TOTALS_MAX_PRESSURE)) = 0.0;
    (*cspan_at(&work, totals + layout__PATCH_TOTALS_MAX_PRESSURE)) = 0.0;
    (*cspan_at(&work_t, totals + layout__PATCH_TOTALS_MAX_HALF_LENGTH)) = 0.0;
    (*cspan_at(&work, totals + layout__PATCH_TOTALS_MAX_HALF_LENGTH)) = 0.0;
    (*cspan_at(&work_t, totals + layout__PATCH_TOTALS_START)) = start_t;
    (*cspan_at(&work, totals + layout__PATCH_TOTALS_START)) = start;
    (*cspan_at(&work_t, totals + layout__PATCH_TOTALS_STOP)) = start_t;
    (*cspan_at(&work, totals + layout__PATCH_TOTALS_STOP)) = start;
    (*cspan_at(&work_t, totals + layout__PATCH_TOTALS_WIDTH)) = 0.0;
    (*cspan_at(&work, totals + layout__PATCH_TOTALS_WIDTH)) = 0.0;
    return INT64_C(0);
}

/* Tangent of ``clear_patches``. */
static inline int64_t tangent_filling__clear_patches_t(array_double_1d work, array_double_1d work_t)
{
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_COUNT)) = 0.0;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_COUNT)) = 0.0;
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PART_COUNT)) = 0.0;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PART_COUNT)) = 0.0;
    tangent_filling__clear_totals_t(work, work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS, 0.0, 0.0);
    return INT64_C(0);
}

/* Tangent of ``begin_patch``. */
static inline int64_t tangent_filling__begin_patch_t(array_double_1d work, array_double_1d work_t, int64_t region, double start, double start_t, int64_t first, int64_t rule, double contact_angle, double contact_angle_t)
{
    int64_t patch;
    int64_t index;
    index = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_COUNT)));
    if (index == layout__SOLVED_PATCH_LIMIT)
    {
        return index - INT64_C(1);
    }
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_COUNT)) = 0.0;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_COUNT)) = (double)(index + INT64_C(1));
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PRESSURE_SQUARE)) = 0.0;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PRESSURE_SQUARE)) = 0.0;
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_HALF_LENGTH_SQUARE)) = 0.0;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_HALF_LENGTH_SQUARE)) = 0.0;
    patch = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_SIZE * index;
    tangent_filling__clear_totals_t(work, work_t, patch + layout__SOLVED_PATCH_TOTALS, start, start_t);
    tangent_filling__place_patch_t(work, work_t, patch, region, first, rule, contact_angle, contact_angle_t);
    return index;
}

/* Tangent of ``place_patch``. */
static inline int64_t tangent_filling__place_patch_t(array_double_1d work, array_double_1d work_t, int64_t patch, int64_t region, int64_t first, int64_t rule, double contact_angle, double contact_angle_t)
{
    (*cspan_at(&work_t, patch + layout__SOLVED_PATCH_CONTACT_ANGLE)) = contact_angle_t;
    (*cspan_at(&work, patch + layout__SOLVED_PATCH_CONTACT_ANGLE)) = contact_angle;
    (*cspan_at(&work_t, patch + layout__SOLVED_PATCH_COS)) = (*cspan_at(&work_t, region + layout__REGION_COS));
    (*cspan_at(&work, patch + layout__SOLVED_PATCH_COS)) = (*cspan_at(&work, region + layout__REGION_COS));
    (*cspan_at(&work_t, patch + layout__SOLVED_PATCH_SIN)) = (*cspan_at(&work_t, region + layout__REGION_SIN));
    (*cspan_at(&work, patch + layout__SOLVED_PATCH_SIN)) = (*cspan_at(&work, region + layout__REGION_SIN));
    (*cspan_at(&work_t, patch + layout__SOLVED_PATCH_RAIL)) = (*cspan_at(&work_t, region + layout__REGION_RAIL));
    (*cspan_at(&work, patch + layout__SOLVED_PATCH_RAIL)) = (*cspan_at(&work, region + layout__REGION_RAIL));
    (*cspan_at(&work_t, patch + layout__SOLVED_PATCH_WHEEL)) = (*cspan_at(&work_t, region + layout__REGION_WHEEL));
    (*cspan_at(&work, patch + layout__SOLVED_PATCH_WHEEL)) = (*cspan_at(&work, region + layout__REGION_WHEEL));
    (*cspan_at(&work_t, patch + layout__SOLVED_PATCH_STATION)) = (*cspan_at(&work_t, region + layout__REGION_OFFSET)) + (*cspan_at(&work_t, region + layout__REGION_STATION));
    (*cspan_at(&work, patch + layout__SOLVED_PATCH_STATION)) = (*cspan_at(&work, region + layout__REGION_OFFSET)) + (*cspan_at(&work, region + layout__REGION_STATION));
    (*cspan_at(&work_t, patch + layout__SOLVED_PATCH_X)) = (*cspan_at(&work_t, region + layout__REGION_X_TRACK));
    (*cspan_at(&work, patch + layout__SOLVED_PATCH_X)) = (*cspan_at(&work, region + layout__REGION_X_TRACK));
    (*cspan_at(&work_t, patch + layout__SOLVED_PATCH_SLANT)) = (*cspan_at(&work_t, region + layout__REGION_SLANT));
    (*cspan_at(&work, patch + layout__SOLVED_PATCH_SLANT)) = (*cspan_at(&work, region + layout__REGION_SLANT));
    (*cspan_at(&work_t, patch + layout__SOLVED_PATCH_RULE)) = 0.0;
    (*cspan_at(&work, patch + layout__SOLVED_PATCH_RULE)) = (double)(rule);
    (*cspan_at(&work_t, patch + layout__SOLVED_PATCH_FIRST)) = 0.0;
    (*cspan_at(&work, patch + layout__SOLVED_PATCH_FIRST)) = (double)(first);
    (*cspan_at(&work_t, patch + layout__SOLVED_PATCH_LAST)) = 0.0;
    (*cspan_at(&work, patch + layout__SOLVED_PATCH_LAST)) = (double)(first - INT64_C(1));
    (*cspan_at(&work_t, patch + layout__SOLVED_PATCH_RANK)) = 0.0;
    (*cspan_at(&work, patch + layout__SOLVED_PATCH_RANK)) = 0.0;
    return INT64_C(0);
}

/* Tangent of ``add_part``. */
static inline int64_t tangent_filling__add_part_t(array_double_1d work, array_double_1d work_t, int64_t patch, int64_t region, double load, double load_t, double moment, double moment_t)
{
    int64_t index;
    int64_t known;
    int64_t last;
    int64_t part;
    index = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PART_COUNT))) - INT64_C(1);
    known = INT64_C(0);
    if (index >= INT64_C(0))
    {
        last = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PARTS + layout__SOLVED_PART_SIZE * index;
        if (((int64_t)((*cspan_at(&work, last + layout__SOLVED_PART_PATCH))) == patch) && ((int64_t)((*cspan_at(&work, last + layout__SOLVED_PART_REGION))) == region))
        {
            known = INT64_C(1);
        }
    }
    if ((known == INT64_C(0)) && (index < layout__SOLVED_PART_LIMIT - INT64_C(1)))
    {
        index = index + INT64_C(1);
        (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PART_COUNT)) = 0.0;
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PART_COUNT)) = (double)(index + INT64_C(1));
        part = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PARTS + layout__SOLVED_PART_SIZE * index;
        (*cspan_at(&work_t, part + layout__SOLVED_PART_PATCH)) = 0.0;
        (*cspan_at(&work, part + layout__SOLVED_PART_PATCH)) = (double)(patch);
        (*cspan_at(&work_t, part + layout__SOLVED_PART_REGION)) = 0.0;
        (*cspan_at(&work, part + layout__SOLVED_PART_REGION)) = (double)(region);
        (*cspan_at(&work_t, part + layout__SOLVED_PART_LOAD)) = 0.0;
        (*cspan_at(&work, part + layout__SOLVED_PART_LOAD)) = 0.0;
        (*cspan_at(&work_t, part + layout__SOLVED_PART_MOMENT)) = 0.0;
        (*cspan_at(&work, part + layout__SOLVED_PART_MOMENT)) = 0.0;
    }
    part = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PARTS + layout__SOLVED_PART_SIZE * index;
    (*cspan_at(&work_t, part + layout__SOLVED_PART_LOAD)) = (*cspan_at(&work_t, part + layout__SOLVED_PART_LOAD)) + load_t;
    (*cspan_at(&work, part + layout__SOLVED_PART_LOAD)) = (*cspan_at(&work, part + layout__SOLVED_PART_LOAD)) + load;
    (*cspan_at(&work_t, part + layout__SOLVED_PART_MOMENT)) = (*cspan_at(&work_t, part + layout__SOLVED_PART_MOMENT)) + moment_t;
    (*cspan_at(&work, part + layout__SOLVED_PART_MOMENT)) = (*cspan_at(&work, part + layout__SOLVED_PART_MOMENT)) + moment;
    return INT64_C(0);
}

/* Tangent of ``fill_single``. */
static inline int64_t tangent_filling__fill_single_t(array_double_1d work, array_double_1d work_t)
{
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_COUNT)) = 0.0;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_COUNT)) = 1.0;
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PART_COUNT)) = 0.0;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PART_COUNT)) = 0.0;
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_RANK)) = 0.0;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_RANK)) = 1.0;
    tangent_filling__add_part_t(work, work_t, INT64_C(0), INT64_C(0), (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_LOAD)), (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_LOAD)), (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_MOMENT)), (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_MOMENT)));
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_LOAD)) = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_LOAD));
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_LOAD)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_LOAD));
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_AREA)) = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_AREA));
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_AREA)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_AREA));
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_MOMENT)) = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_MOMENT));
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_MOMENT)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_MOMENT));
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_CENTROID)) = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_CENTROID));
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_CENTROID)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_CENTROID));
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_MAX_PRESSURE)) = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_MAX_PRESSURE));
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_MAX_PRESSURE)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_MAX_PRESSURE));
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_MAX_HALF_LENGTH)) = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_MAX_HALF_LENGTH));
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_MAX_HALF_LENGTH)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_MAX_HALF_LENGTH));
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_START)) = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_START));
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_START)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_START));
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_STOP)) = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_STOP));
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_STOP)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_STOP));
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_WIDTH)) = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_WIDTH));
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_WIDTH)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_WIDTH));
    return INT64_C(0);
}

/* Tangent of ``finish_patch``. */
static inline int64_t tangent_filling__finish_patch_t(array_double_1d work, array_double_1d work_t)
{
    int64_t patch;
    int64_t totals;
    double v1;
    double v2;
    if ((int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_COUNT))) > INT64_C(0))
    {
        patch = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_SIZE * ((int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_COUNT))) - INT64_C(1));
        totals = patch + layout__SOLVED_PATCH_TOTALS;
        v1 = sqrt((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PRESSURE_SQUARE)));
        (*cspan_at(&work_t, totals + layout__PATCH_TOTALS_MAX_PRESSURE)) = tangent_rates__root_rate(v1, (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PRESSURE_SQUARE)));
        (*cspan_at(&work, totals + layout__PATCH_TOTALS_MAX_PRESSURE)) = v1;
        v2 = sqrt((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_HALF_LENGTH_SQUARE)));
        (*cspan_at(&work_t, totals + layout__PATCH_TOTALS_MAX_HALF_LENGTH)) = tangent_rates__root_rate(v2, (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_HALF_LENGTH_SQUARE)));
        (*cspan_at(&work, totals + layout__PATCH_TOTALS_MAX_HALF_LENGTH)) = v2;
        tangent_filling__complete_totals_t(work, work_t, totals);
    }
    return INT64_C(0);
}

/* Tangent of ``complete_totals``. */
static inline int64_t tangent_filling__complete_totals_t(array_double_1d work, array_double_1d work_t, int64_t totals)
{
    double v1;
    (*cspan_at(&work_t, totals + layout__PATCH_TOTALS_WIDTH)) = (*cspan_at(&work_t, totals + layout__PATCH_TOTALS_STOP)) - (*cspan_at(&work_t, totals + layout__PATCH_TOTALS_START));
    (*cspan_at(&work, totals + layout__PATCH_TOTALS_WIDTH)) = (*cspan_at(&work, totals + layout__PATCH_TOTALS_STOP)) - (*cspan_at(&work, totals + layout__PATCH_TOTALS_START));
    if ((*cspan_at(&work, totals + layout__PATCH_TOTALS_LOAD)) > 0.0)
    {
        v1 = (*cspan_at(&work, totals + layout__PATCH_TOTALS_MOMENT)) / (*cspan_at(&work, totals + layout__PATCH_TOTALS_LOAD));
        (*cspan_at(&work_t, totals + layout__PATCH_TOTALS_CENTROID)) = ((*cspan_at(&work_t, totals + layout__PATCH_TOTALS_MOMENT)) - v1 * (*cspan_at(&work_t, totals + layout__PATCH_TOTALS_LOAD))) / (*cspan_at(&work, totals + layout__PATCH_TOTALS_LOAD));
        (*cspan_at(&work, totals + layout__PATCH_TOTALS_CENTROID)) = v1;
    }
    return INT64_C(0);
}

/* Tangent of ``remove_unloaded``. */
static inline int64_t tangent_filling__remove_unloaded_t(array_double_1d work, array_double_1d work_t)
{
    int64_t index;
    index = INT64_C(0);
    while(((int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_COUNT))) > INT64_C(1)) && (index < (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_COUNT)))))
    {
        if ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_SIZE * index + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_LOAD)) > 0.0)
        {
            index = index + INT64_C(1);
        }
        else
        {
            tangent_filling__remove_patch_t(work, work_t, index);
            index = INT64_C(0);
        }
    }
    return INT64_C(0);
}

/* Tangent of ``remove_patch``. */
static inline int64_t tangent_filling__remove_patch_t(array_double_1d work, array_double_1d work_t, int64_t index)
{
    int64_t heir;
    int64_t from_totals;
    int64_t totals;
    int64_t number_end;
    int64_t number;
    int64_t part;
    int64_t following_end;
    int64_t following;
    int64_t patch;
    int64_t behind;
    int64_t i;
    heir = index - INT64_C(1);
    if (heir < INT64_C(0))
    {
        heir = INT64_C(1);
    }
    from_totals = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_SIZE * index + layout__SOLVED_PATCH_TOTALS;
    totals = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_SIZE * heir + layout__SOLVED_PATCH_TOTALS;
    (*cspan_at(&work_t, totals + layout__PATCH_TOTALS_LOAD)) = (*cspan_at(&work_t, totals + layout__PATCH_TOTALS_LOAD)) + (*cspan_at(&work_t, from_totals + layout__PATCH_TOTALS_LOAD));
    (*cspan_at(&work, totals + layout__PATCH_TOTALS_LOAD)) = (*cspan_at(&work, totals + layout__PATCH_TOTALS_LOAD)) + (*cspan_at(&work, from_totals + layout__PATCH_TOTALS_LOAD));
    (*cspan_at(&work_t, totals + layout__PATCH_TOTALS_MOMENT)) = (*cspan_at(&work_t, totals + layout__PATCH_TOTALS_MOMENT)) + (*cspan_at(&work_t, from_totals + layout__PATCH_TOTALS_MOMENT));
    (*cspan_at(&work, totals + layout__PATCH_TOTALS_MOMENT)) = (*cspan_at(&work, totals + layout__PATCH_TOTALS_MOMENT)) + (*cspan_at(&work, from_totals + layout__PATCH_TOTALS_MOMENT));
    (*cspan_at(&work_t, totals + layout__PATCH_TOTALS_AREA)) = (*cspan_at(&work_t, totals + layout__PATCH_TOTALS_AREA)) + (*cspan_at(&work_t, from_totals + layout__PATCH_TOTALS_AREA));
    (*cspan_at(&work, totals + layout__PATCH_TOTALS_AREA)) = (*cspan_at(&work, totals + layout__PATCH_TOTALS_AREA)) + (*cspan_at(&work, from_totals + layout__PATCH_TOTALS_AREA));
    tangent_filling__complete_totals_t(work, work_t, totals);
    number_end = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PART_COUNT)));
    for (number = INT64_C(0); number < number_end; number += INT64_C(1))
    {
        part = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PARTS + layout__SOLVED_PART_SIZE * number;
        if ((int64_t)((*cspan_at(&work, part + layout__SOLVED_PART_PATCH))) == index)
        {
            tangent_filling__hand_part_t(work, work_t, number, heir);
        }
    }
    number_end = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PART_COUNT)));
    for (number = INT64_C(0); number < number_end; number += INT64_C(1))
    {
        part = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PARTS + layout__SOLVED_PART_SIZE * number;
        if ((int64_t)((*cspan_at(&work, part + layout__SOLVED_PART_PATCH))) > index)
        {
            (*cspan_at(&work_t, part + layout__SOLVED_PART_PATCH)) = 0.0;
            (*cspan_at(&work, part + layout__SOLVED_PART_PATCH)) = (double)((int64_t)((*cspan_at(&work, part + layout__SOLVED_PART_PATCH))) - INT64_C(1));
        }
    }
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_COUNT)) = 0.0;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_COUNT)) = (double)((int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_COUNT))) - INT64_C(1));
    following_end = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_COUNT)));
    for (following = index; following < following_end; following += INT64_C(1))
    {
        patch = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_SIZE * following;
        behind = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_SIZE * (following + INT64_C(1));
        for (i = INT64_C(0); i < layout__SOLVED_PATCH_SIZE; i += INT64_C(1))
        {
            (*cspan_at(&work_t, patch + i)) = (*cspan_at(&work_t, behind + i));
            (*cspan_at(&work, patch + i)) = (*cspan_at(&work, behind + i));
        }
    }
    return INT64_C(0);
}

/* Tangent of ``hand_part``. */
static inline int64_t tangent_filling__hand_part_t(array_double_1d work, array_double_1d work_t, int64_t number, int64_t heir)
{
    int64_t part;
    int64_t i_end;
    int64_t i;
    int64_t other;
    part = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PARTS + layout__SOLVED_PART_SIZE * number;
    (*cspan_at(&work_t, part + layout__SOLVED_PART_PATCH)) = 0.0;
    (*cspan_at(&work, part + layout__SOLVED_PART_PATCH)) = (double)(heir);
    i_end = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PART_COUNT)));
    for (i = INT64_C(0); i < i_end; i += INT64_C(1))
    {
        other = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PARTS + layout__SOLVED_PART_SIZE * i;
        if ((i != number) && ((int64_t)((*cspan_at(&work, other + layout__SOLVED_PART_PATCH))) == heir) && ((int64_t)((*cspan_at(&work, other + layout__SOLVED_PART_REGION))) == (int64_t)((*cspan_at(&work, part + layout__SOLVED_PART_REGION)))))
        {
            (*cspan_at(&work_t, other + layout__SOLVED_PART_LOAD)) = (*cspan_at(&work_t, other + layout__SOLVED_PART_LOAD)) + (*cspan_at(&work_t, part + layout__SOLVED_PART_LOAD));
            (*cspan_at(&work, other + layout__SOLVED_PART_LOAD)) = (*cspan_at(&work, other + layout__SOLVED_PART_LOAD)) + (*cspan_at(&work, part + layout__SOLVED_PART_LOAD));
            (*cspan_at(&work_t, other + layout__SOLVED_PART_MOMENT)) = (*cspan_at(&work_t, other + layout__SOLVED_PART_MOMENT)) + (*cspan_at(&work_t, part + layout__SOLVED_PART_MOMENT));
            (*cspan_at(&work, other + layout__SOLVED_PART_MOMENT)) = (*cspan_at(&work, other + layout__SOLVED_PART_MOMENT)) + (*cspan_at(&work, part + layout__SOLVED_PART_MOMENT));
            (*cspan_at(&work_t, part + layout__SOLVED_PART_LOAD)) = 0.0;
            (*cspan_at(&work, part + layout__SOLVED_PART_LOAD)) = 0.0;
            (*cspan_at(&work_t, part + layout__SOLVED_PART_MOMENT)) = 0.0;
            (*cspan_at(&work, part + layout__SOLVED_PART_MOMENT)) = 0.0;
            break;
        }
    }
    return INT64_C(0);
}

/* Tangent of ``finish_patches``. */
static inline int64_t tangent_filling__finish_patches_t(array_double_1d work, array_double_1d work_t)
{
    int64_t count;
    int64_t index;
    int64_t patch;
    int64_t one;
    int64_t rank;
    int64_t heaviest;
    int64_t ranked;
    tangent_filling__remove_unloaded_t(work, work_t);
    count = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_COUNT)));
    for (index = INT64_C(0); index < count; index += INT64_C(1))
    {
        patch = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_SIZE * index;
        one = patch + layout__SOLVED_PATCH_TOTALS;
        (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_LOAD)) = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_LOAD)) + (*cspan_at(&work_t, one + layout__PATCH_TOTALS_LOAD));
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_LOAD)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_LOAD)) + (*cspan_at(&work, one + layout__PATCH_TOTALS_LOAD));
        (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_AREA)) = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_AREA)) + (*cspan_at(&work_t, one + layout__PATCH_TOTALS_AREA));
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_AREA)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_AREA)) + (*cspan_at(&work, one + layout__PATCH_TOTALS_AREA));
        (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_MOMENT)) = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_MOMENT)) + (*cspan_at(&work_t, one + layout__PATCH_TOTALS_MOMENT));
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_MOMENT)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_MOMENT)) + (*cspan_at(&work, one + layout__PATCH_TOTALS_MOMENT));
        if ((*cspan_at(&work, one + layout__PATCH_TOTALS_MAX_PRESSURE)) > (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_MAX_PRESSURE)))
        {
            (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_MAX_PRESSURE)) = (*cspan_at(&work_t, one + layout__PATCH_TOTALS_MAX_PRESSURE));
            (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_MAX_PRESSURE)) = (*cspan_at(&work, one + layout__PATCH_TOTALS_MAX_PRESSURE));
        }
        if ((*cspan_at(&work, one + layout__PATCH_TOTALS_MAX_HALF_LENGTH)) > (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_MAX_HALF_LENGTH)))
        {
            (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_MAX_HALF_LENGTH)) = (*cspan_at(&work_t, one + layout__PATCH_TOTALS_MAX_HALF_LENGTH));
            (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_MAX_HALF_LENGTH)) = (*cspan_at(&work, one + layout__PATCH_TOTALS_MAX_HALF_LENGTH));
        }
        if (index == INT64_C(0))
        {
            (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_START)) = (*cspan_at(&work_t, one + layout__PATCH_TOTALS_START));
            (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_START)) = (*cspan_at(&work, one + layout__PATCH_TOTALS_START));
        }
        (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_STOP)) = (*cspan_at(&work_t, one + layout__PATCH_TOTALS_STOP));
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_STOP)) = (*cspan_at(&work, one + layout__PATCH_TOTALS_STOP));
    }
    tangent_filling__complete_totals_t(work, work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS);
    for (rank = INT64_C(1); rank < count + INT64_C(1); rank += INT64_C(1))
    {
        heaviest = filling__heaviest_patch(work);
        if (heaviest >= INT64_C(0))
        {
            ranked = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_SIZE * heaviest;
            (*cspan_at(&work_t, ranked + layout__SOLVED_PATCH_RANK)) = 0.0;
            (*cspan_at(&work, ranked + layout__SOLVED_PATCH_RANK)) = (double)(rank);
        }
    }
    return INT64_C(0);
}
