/* Generated from patch/filling.py by tools/transpile_kernel.py; change that one.
 *
 * How a model of normal contact fills the solved patches: one after the other by rising station, then totals
 * and ranks.
 */

#include "filling.h"

/* Totals of nothing, at station ``start`` [m]. */
static inline int64_t filling__clear_totals(array_double_1d work, int64_t totals, double start)
{
    (*cspan_at(&work, totals + layout__PATCH_TOTALS_LOAD)) = 0.0;
    (*cspan_at(&work, totals + layout__PATCH_TOTALS_AREA)) = 0.0;
    (*cspan_at(&work, totals + layout__PATCH_TOTALS_MOMENT)) = 0.0;
    (*cspan_at(&work, totals + layout__PATCH_TOTALS_CENTROID)) = 0.0;
    (*cspan_at(&work, totals + layout__PATCH_TOTALS_MAX_PRESSURE)) = 0.0;
    (*cspan_at(&work, totals + layout__PATCH_TOTALS_MAX_HALF_LENGTH)) = 0.0;
    (*cspan_at(&work, totals + layout__PATCH_TOTALS_START)) = start;
    (*cspan_at(&work, totals + layout__PATCH_TOTALS_STOP)) = start;
    (*cspan_at(&work, totals + layout__PATCH_TOTALS_WIDTH)) = 0.0;
    return INT64_C(0);
}

/* No patches. */
static inline int64_t filling__clear_patches(array_double_1d work)
{
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_COUNT)) = 0.0;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PART_COUNT)) = 0.0;
    filling__clear_totals(work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS, 0.0);
    return INT64_C(0);
}

/* Begin the next patch at station ``start`` [m] and strip ``first``, at the point of ``region``; its
 * index.
 *
 * Where there is no room for another patch, the last one goes on.
 */
static inline int64_t filling__begin_patch(array_double_1d work, int64_t region, double start, int64_t first, int64_t rule, double contact_angle)
{
    int64_t patch;
    int64_t index;
    index = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_COUNT)));
    if (index == layout__SOLVED_PATCH_LIMIT)
    {
        return index - INT64_C(1);
    }
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_COUNT)) = (double)(index + INT64_C(1));
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PRESSURE_SQUARE)) = 0.0;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_HALF_LENGTH_SQUARE)) = 0.0;
    patch = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_SIZE * index;
    filling__clear_totals(work, patch + layout__SOLVED_PATCH_TOTALS, start);
    filling__place_patch(work, patch, region, first, rule, contact_angle);
    return index;
}

/* Give a patch the plane and the point of its region; it has no rank, and no strips behind ``first``
 * yet.
 */
static inline int64_t filling__place_patch(array_double_1d work, int64_t patch, int64_t region, int64_t first, int64_t rule, double contact_angle)
{
    (*cspan_at(&work, patch + layout__SOLVED_PATCH_CONTACT_ANGLE)) = contact_angle;
    (*cspan_at(&work, patch + layout__SOLVED_PATCH_COS)) = (*cspan_at(&work, region + layout__REGION_COS));
    (*cspan_at(&work, patch + layout__SOLVED_PATCH_SIN)) = (*cspan_at(&work, region + layout__REGION_SIN));
    (*cspan_at(&work, patch + layout__SOLVED_PATCH_RAIL)) = (*cspan_at(&work, region + layout__REGION_RAIL));
    (*cspan_at(&work, patch + layout__SOLVED_PATCH_WHEEL)) = (*cspan_at(&work, region + layout__REGION_WHEEL));
    (*cspan_at(&work, patch + layout__SOLVED_PATCH_STATION)) = (*cspan_at(&work, region + layout__REGION_OFFSET)) + (*cspan_at(&work, region + layout__REGION_STATION));
    (*cspan_at(&work, patch + layout__SOLVED_PATCH_X)) = (*cspan_at(&work, region + layout__REGION_X_TRACK));
    (*cspan_at(&work, patch + layout__SOLVED_PATCH_SLANT)) = (*cspan_at(&work, region + layout__REGION_SLANT));
    (*cspan_at(&work, patch + layout__SOLVED_PATCH_RULE)) = (double)(rule);
    (*cspan_at(&work, patch + layout__SOLVED_PATCH_FIRST)) = (double)(first);
    (*cspan_at(&work, patch + layout__SOLVED_PATCH_LAST)) = (double)(first - INT64_C(1));
    (*cspan_at(&work, patch + layout__SOLVED_PATCH_RANK)) = 0.0;
    return INT64_C(0);
}

/* Add load [N] and moment [N m] in a region to the part of a patch that lies there: the
 * last part, or a new one.
 */
static inline int64_t filling__add_part(array_double_1d work, int64_t patch, int64_t region, double load, double moment)
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
        index += INT64_C(1);
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PART_COUNT)) = (double)(index + INT64_C(1));
        part = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PARTS + layout__SOLVED_PART_SIZE * index;
        (*cspan_at(&work, part + layout__SOLVED_PART_PATCH)) = (double)(patch);
        (*cspan_at(&work, part + layout__SOLVED_PART_REGION)) = (double)(region);
        (*cspan_at(&work, part + layout__SOLVED_PART_LOAD)) = 0.0;
        (*cspan_at(&work, part + layout__SOLVED_PART_MOMENT)) = 0.0;
    }
    part = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PARTS + layout__SOLVED_PART_SIZE * index;
    (*cspan_at(&work, part + layout__SOLVED_PART_LOAD)) += load;
    (*cspan_at(&work, part + layout__SOLVED_PART_MOMENT)) += moment;
    return INT64_C(0);
}

/* Let the first patch, whose totals are known, be the only one. */
static inline int64_t filling__fill_single(array_double_1d work)
{
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_COUNT)) = 1.0;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PART_COUNT)) = 0.0;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_RANK)) = 1.0;
    filling__add_part(work, INT64_C(0), INT64_C(0), (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_LOAD)), (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_MOMENT)));
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_LOAD)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_LOAD));
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_AREA)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_AREA));
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_MOMENT)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_MOMENT));
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_CENTROID)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_CENTROID));
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_MAX_PRESSURE)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_MAX_PRESSURE));
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_MAX_HALF_LENGTH)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_MAX_HALF_LENGTH));
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_START)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_START));
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_STOP)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_STOP));
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_WIDTH)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_WIDTH));
    return INT64_C(0);
}

/* Give the last patch, if there is one, what follows from its load, its edges and its largest squares. */
static inline int64_t filling__finish_patch(array_double_1d work)
{
    int64_t patch;
    int64_t totals;
    if ((int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_COUNT))) > INT64_C(0))
    {
        patch = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_SIZE * ((int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_COUNT))) - INT64_C(1));
        totals = patch + layout__SOLVED_PATCH_TOTALS;
        (*cspan_at(&work, totals + layout__PATCH_TOTALS_MAX_PRESSURE)) = sqrt((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PRESSURE_SQUARE)));
        (*cspan_at(&work, totals + layout__PATCH_TOTALS_MAX_HALF_LENGTH)) = sqrt((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_HALF_LENGTH_SQUARE)));
        filling__complete_totals(work, totals);
    }
    return INT64_C(0);
}

/* Centroid and width from load, moment and edges. */
static inline int64_t filling__complete_totals(array_double_1d work, int64_t totals)
{
    (*cspan_at(&work, totals + layout__PATCH_TOTALS_WIDTH)) = (*cspan_at(&work, totals + layout__PATCH_TOTALS_STOP)) - (*cspan_at(&work, totals + layout__PATCH_TOTALS_START));
    if ((*cspan_at(&work, totals + layout__PATCH_TOTALS_LOAD)) > 0.0)
    {
        (*cspan_at(&work, totals + layout__PATCH_TOTALS_CENTROID)) = (*cspan_at(&work, totals + layout__PATCH_TOTALS_MOMENT)) / (*cspan_at(&work, totals + layout__PATCH_TOTALS_LOAD));
    }
    return INT64_C(0);
}

/* Take away patches that carry nothing in sum: between jumps of the curvatures the quadratic of the line
 * load can be negative all over a sliver.  What they carry counts for their neighbours, so that the patches
 * carry together what the regions do.
 */
static inline int64_t filling__remove_unloaded(array_double_1d work)
{
    int64_t index;
    index = INT64_C(0);
    while(((int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_COUNT))) > INT64_C(1)) && (index < (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_COUNT)))))
    {
        if ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_SIZE * index + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_LOAD)) > 0.0)
        {
            index += INT64_C(1);
        }
        else
        {
            filling__remove_patch(work, index);
            index = INT64_C(0);
        }
    }
    return INT64_C(0);
}

/* Take a finished patch away; the one before, or else the one behind it gets its load and its area. */
static inline int64_t filling__remove_patch(array_double_1d work, int64_t index)
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
    (*cspan_at(&work, totals + layout__PATCH_TOTALS_LOAD)) += (*cspan_at(&work, from_totals + layout__PATCH_TOTALS_LOAD));
    (*cspan_at(&work, totals + layout__PATCH_TOTALS_MOMENT)) += (*cspan_at(&work, from_totals + layout__PATCH_TOTALS_MOMENT));
    (*cspan_at(&work, totals + layout__PATCH_TOTALS_AREA)) += (*cspan_at(&work, from_totals + layout__PATCH_TOTALS_AREA));
    filling__complete_totals(work, totals);
    number_end = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PART_COUNT)));
    for (number = INT64_C(0); number < number_end; number += INT64_C(1))
    {
        part = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PARTS + layout__SOLVED_PART_SIZE * number;
        if ((int64_t)((*cspan_at(&work, part + layout__SOLVED_PART_PATCH))) == index)
        {
            filling__hand_part(work, number, heir);
        }
    }
    number_end = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PART_COUNT)));
    for (number = INT64_C(0); number < number_end; number += INT64_C(1))
    {
        part = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PARTS + layout__SOLVED_PART_SIZE * number;
        if ((int64_t)((*cspan_at(&work, part + layout__SOLVED_PART_PATCH))) > index)
        {
            (*cspan_at(&work, part + layout__SOLVED_PART_PATCH)) = (double)((int64_t)((*cspan_at(&work, part + layout__SOLVED_PART_PATCH))) - INT64_C(1));
        }
    }
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_COUNT)) = (double)((int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_COUNT))) - INT64_C(1));
    following_end = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_COUNT)));
    for (following = index; following < following_end; following += INT64_C(1))
    {
        patch = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_SIZE * following;
        behind = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_SIZE * (following + INT64_C(1));
        for (i = INT64_C(0); i < layout__SOLVED_PATCH_SIZE; i += INT64_C(1))
        {
            (*cspan_at(&work, patch + i)) = (*cspan_at(&work, behind + i));
        }
    }
    return INT64_C(0);
}

/* Give the part ``number`` to the patch ``heir``: to its part in the same region if it has one. */
static inline int64_t filling__hand_part(array_double_1d work, int64_t number, int64_t heir)
{
    int64_t part;
    int64_t i_end;
    int64_t i;
    int64_t other;
    part = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PARTS + layout__SOLVED_PART_SIZE * number;
    (*cspan_at(&work, part + layout__SOLVED_PART_PATCH)) = (double)(heir);
    i_end = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PART_COUNT)));
    for (i = INT64_C(0); i < i_end; i += INT64_C(1))
    {
        other = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PARTS + layout__SOLVED_PART_SIZE * i;
        if ((i != number) && ((int64_t)((*cspan_at(&work, other + layout__SOLVED_PART_PATCH))) == heir) && ((int64_t)((*cspan_at(&work, other + layout__SOLVED_PART_REGION))) == (int64_t)((*cspan_at(&work, part + layout__SOLVED_PART_REGION)))))
        {
            (*cspan_at(&work, other + layout__SOLVED_PART_LOAD)) += (*cspan_at(&work, part + layout__SOLVED_PART_LOAD));
            (*cspan_at(&work, other + layout__SOLVED_PART_MOMENT)) += (*cspan_at(&work, part + layout__SOLVED_PART_MOMENT));
            (*cspan_at(&work, part + layout__SOLVED_PART_LOAD)) = 0.0;
            (*cspan_at(&work, part + layout__SOLVED_PART_MOMENT)) = 0.0;
            break;
        }
    }
    return INT64_C(0);
}

/* The totals of all patches that carry load, and their ranks, when the last patch is finished. */
static inline int64_t filling__finish_patches(array_double_1d work)
{
    int64_t count;
    int64_t index;
    int64_t patch;
    int64_t one;
    int64_t rank;
    int64_t heaviest;
    int64_t ranked;
    filling__remove_unloaded(work);
    count = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_COUNT)));
    for (index = INT64_C(0); index < count; index += INT64_C(1))
    {
        patch = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_SIZE * index;
        one = patch + layout__SOLVED_PATCH_TOTALS;
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_LOAD)) += (*cspan_at(&work, one + layout__PATCH_TOTALS_LOAD));
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_AREA)) += (*cspan_at(&work, one + layout__PATCH_TOTALS_AREA));
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_MOMENT)) += (*cspan_at(&work, one + layout__PATCH_TOTALS_MOMENT));
        if ((*cspan_at(&work, one + layout__PATCH_TOTALS_MAX_PRESSURE)) > (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_MAX_PRESSURE)))
        {
            (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_MAX_PRESSURE)) = (*cspan_at(&work, one + layout__PATCH_TOTALS_MAX_PRESSURE));
        }
        if ((*cspan_at(&work, one + layout__PATCH_TOTALS_MAX_HALF_LENGTH)) > (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_MAX_HALF_LENGTH)))
        {
            (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_MAX_HALF_LENGTH)) = (*cspan_at(&work, one + layout__PATCH_TOTALS_MAX_HALF_LENGTH));
        }
        if (index == INT64_C(0))
        {
            (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_START)) = (*cspan_at(&work, one + layout__PATCH_TOTALS_START));
        }
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_STOP)) = (*cspan_at(&work, one + layout__PATCH_TOTALS_STOP));
    }
    filling__complete_totals(work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS);
    for (rank = INT64_C(1); rank < count + INT64_C(1); rank += INT64_C(1))
    {
        heaviest = filling__heaviest_patch(work);
        if (heaviest >= INT64_C(0))
        {
            ranked = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_SIZE * heaviest;
            (*cspan_at(&work, ranked + layout__SOLVED_PATCH_RANK)) = (double)(rank);
        }
    }
    return INT64_C(0);
}

/* Index of the heaviest patch that carries load and has no rank, of equal ones the first; -1 if there is
 * none.
 */
static inline int64_t filling__heaviest_patch(array_double_1d work)
{
    double load;
    int64_t index_end;
    int64_t index;
    int64_t patch;
    int64_t heaviest;
    heaviest = -INT64_C(1);
    load = 0.0;
    index_end = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_COUNT)));
    for (index = INT64_C(0); index < index_end; index += INT64_C(1))
    {
        patch = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_SIZE * index;
        if (((int64_t)((*cspan_at(&work, patch + layout__SOLVED_PATCH_RANK))) == INT64_C(0)) && ((*cspan_at(&work, patch + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_LOAD)) > load))
        {
            heaviest = index;
            load = (*cspan_at(&work, patch + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_LOAD));
        }
    }
    return heaviest;
}
