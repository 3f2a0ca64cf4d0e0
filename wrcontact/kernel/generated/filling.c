/* Generated from patch/filling.py by tools/transpile_kernel.py; change that one.
 *
 * How a model of normal contact fills the solved patches: one after the other by rising station, then their ranks.
 */

#include "filling.h"

/* No patches. */
static inline int64_t filling__clear_patches(array_double_1d work)
{
    (*cspan_at(&work, layout__WORK_SOLVED + layout__SOLVED_PATCHES_COUNT)) = 0.0;
    return INT64_C(0);
}

/* Begin the next patch at station ``start`` [m] and strip ``first``, with the plane and the point of ``region``; its index.
 *
 * Where there is no room for another patch, the last one goes on.
 */
static inline int64_t filling__begin_patch(array_double_1d work, int64_t region, double start, int64_t first, int64_t rule, double contact_angle)
{
    int64_t patch;
    int64_t index;
    index = (int64_t)((*cspan_at(&work, layout__WORK_SOLVED + layout__SOLVED_PATCHES_COUNT)));
    if (index == layout__SOLVED_PATCH_LIMIT)
    {
        return index - INT64_C(1);
    }
    (*cspan_at(&work, layout__WORK_SOLVED + layout__SOLVED_PATCHES_COUNT)) = (double)(index + INT64_C(1));
    (*cspan_at(&work, layout__WORK_SOLVED + layout__SOLVED_PATCHES_PRESSURE_SQUARE)) = 0.0;
    (*cspan_at(&work, layout__WORK_SOLVED + layout__SOLVED_PATCHES_HALF_LENGTH_SQUARE)) = 0.0;
    patch = layout__WORK_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_SIZE * index;
    (*cspan_at(&work, patch + layout__SOLVED_PATCH_LOAD)) = 0.0;
    (*cspan_at(&work, patch + layout__SOLVED_PATCH_AREA)) = 0.0;
    (*cspan_at(&work, patch + layout__SOLVED_PATCH_MOMENT)) = 0.0;
    (*cspan_at(&work, patch + layout__SOLVED_PATCH_MAX_PRESSURE)) = 0.0;
    (*cspan_at(&work, patch + layout__SOLVED_PATCH_MAX_HALF_LENGTH)) = 0.0;
    (*cspan_at(&work, patch + layout__SOLVED_PATCH_START)) = start;
    (*cspan_at(&work, patch + layout__SOLVED_PATCH_STOP)) = start;
    (*cspan_at(&work, patch + layout__SOLVED_PATCH_CONTACT_ANGLE)) = contact_angle;
    (*cspan_at(&work, patch + layout__SOLVED_PATCH_COS)) = (*cspan_at(&work, region + layout__REGION_COS));
    (*cspan_at(&work, patch + layout__SOLVED_PATCH_SIN)) = (*cspan_at(&work, region + layout__REGION_SIN));
    (*cspan_at(&work, patch + layout__SOLVED_PATCH_RAIL)) = (*cspan_at(&work, region + layout__REGION_RAIL));
    (*cspan_at(&work, patch + layout__SOLVED_PATCH_WHEEL)) = (*cspan_at(&work, region + layout__REGION_WHEEL));
    (*cspan_at(&work, patch + layout__SOLVED_PATCH_STATION)) = (*cspan_at(&work, region + layout__REGION_OFFSET)) + (*cspan_at(&work, region + layout__REGION_STATION));
    (*cspan_at(&work, patch + layout__SOLVED_PATCH_X)) = (*cspan_at(&work, region + layout__REGION_ALONG));
    (*cspan_at(&work, patch + layout__SOLVED_PATCH_SLANT)) = (*cspan_at(&work, region + layout__REGION_SLANT));
    (*cspan_at(&work, patch + layout__SOLVED_PATCH_LOCAL_PENETRATION)) = (*cspan_at(&work, region + layout__REGION_LEVEL));
    (*cspan_at(&work, patch + layout__SOLVED_PATCH_RULE)) = (double)(rule);
    (*cspan_at(&work, patch + layout__SOLVED_PATCH_FIRST)) = (double)(first);
    (*cspan_at(&work, patch + layout__SOLVED_PATCH_LAST)) = (double)(first - INT64_C(1));
    (*cspan_at(&work, patch + layout__SOLVED_PATCH_RANK)) = 0.0;
    return index;
}

/* Give the last patch, if there is one, its largest pressure and half-length. */
static inline int64_t filling__finish_patch(array_double_1d work)
{
    int64_t patch;
    if ((int64_t)((*cspan_at(&work, layout__WORK_SOLVED + layout__SOLVED_PATCHES_COUNT))) > INT64_C(0))
    {
        patch = layout__WORK_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_SIZE * ((int64_t)((*cspan_at(&work, layout__WORK_SOLVED + layout__SOLVED_PATCHES_COUNT))) - INT64_C(1));
        (*cspan_at(&work, patch + layout__SOLVED_PATCH_MAX_PRESSURE)) = sqrt((*cspan_at(&work, layout__WORK_SOLVED + layout__SOLVED_PATCHES_PRESSURE_SQUARE)));
        (*cspan_at(&work, patch + layout__SOLVED_PATCH_MAX_HALF_LENGTH)) = sqrt((*cspan_at(&work, layout__WORK_SOLVED + layout__SOLVED_PATCHES_HALF_LENGTH_SQUARE)));
    }
    return INT64_C(0);
}

/* Rank the patches that carry load, the heaviest first; of equal ones the one with the smaller station. */
static inline int64_t filling__rank_patches(array_double_1d work)
{
    int64_t count;
    int64_t rank;
    int64_t heaviest;
    double load;
    int64_t index;
    int64_t patch;
    int64_t ranked;
    count = (int64_t)((*cspan_at(&work, layout__WORK_SOLVED + layout__SOLVED_PATCHES_COUNT)));
    for (rank = INT64_C(1); rank < count + INT64_C(1); rank += INT64_C(1))
    {
        heaviest = -INT64_C(1);
        load = 0.0;
        for (index = INT64_C(0); index < count; index += INT64_C(1))
        {
            patch = layout__WORK_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_SIZE * index;
            if (((int64_t)((*cspan_at(&work, patch + layout__SOLVED_PATCH_RANK))) == INT64_C(0)) && ((*cspan_at(&work, patch + layout__SOLVED_PATCH_LOAD)) > load))
            {
                heaviest = index;
                load = (*cspan_at(&work, patch + layout__SOLVED_PATCH_LOAD));
            }
        }
        if (heaviest >= INT64_C(0))
        {
            ranked = layout__WORK_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_SIZE * heaviest;
            (*cspan_at(&work, ranked + layout__SOLVED_PATCH_RANK)) = (double)(rank);
        }
    }
    return INT64_C(0);
}
