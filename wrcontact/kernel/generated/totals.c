/* Generated from patch/totals.py by tools/transpile_kernel.py; change that one.
 *
 * From the solved patches to the outputs of a side: its totals and its heaviest patches.
 */

#include "totals.h"

/* The totals of all patches, and the PATCH_LIMIT heaviest patches by falling load, into the outputs of a
 * side.
 */
static inline int64_t totals__write_patches(array_double_1d work, int64_t side)
{
    int64_t index_end;
    int64_t index;
    int64_t patch;
    int64_t rank;
    (*cspan_at(&work, side + layout__SIDE_OUTPUTS_PATCH_COUNT)) = (double)((int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_COUNT))));
    (*cspan_at(&work, side + layout__SIDE_OUTPUTS_NORMAL_FORCE)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_LOAD));
    (*cspan_at(&work, side + layout__SIDE_OUTPUTS_AREA)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_AREA));
    (*cspan_at(&work, side + layout__SIDE_OUTPUTS_MAX_PRESSURE)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_MAX_PRESSURE));
    (*cspan_at(&work, side + layout__SIDE_OUTPUTS_PATCH_LENGTH)) = 2.0 * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_MAX_HALF_LENGTH));
    (*cspan_at(&work, side + layout__SIDE_OUTPUTS_PATCH_WIDTH)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_WIDTH));
    (*cspan_at(&work, side + layout__SIDE_OUTPUTS_PATCH_CENTROID)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_CENTROID));
    index_end = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_COUNT)));
    for (index = INT64_C(0); index < index_end; index += INT64_C(1))
    {
        patch = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_SIZE * index;
        rank = (int64_t)((*cspan_at(&work, patch + layout__SOLVED_PATCH_RANK)));
        if ((rank > INT64_C(0)) && (rank <= layout__PATCH_LIMIT))
        {
            totals__write_patch(work, patch, side + layout__SIDE_OUTPUTS_PATCH + layout__PATCH_SIZE * (rank - INT64_C(1)));
        }
    }
    return INT64_C(0);
}

/* One patch into its outputs. */
static inline int64_t totals__write_patch(array_double_1d work, int64_t patch, int64_t to)
{
    int64_t totals;
    int64_t force;
    totals = patch + layout__SOLVED_PATCH_TOTALS;
    (*cspan_at(&work, to + layout__PATCH_NORMAL_FORCE)) = (*cspan_at(&work, totals + layout__PATCH_TOTALS_LOAD));
    (*cspan_at(&work, to + layout__PATCH_AREA)) = (*cspan_at(&work, totals + layout__PATCH_TOTALS_AREA));
    (*cspan_at(&work, to + layout__PATCH_MAX_PRESSURE)) = (*cspan_at(&work, totals + layout__PATCH_TOTALS_MAX_PRESSURE));
    (*cspan_at(&work, to + layout__PATCH_LENGTH)) = 2.0 * (*cspan_at(&work, totals + layout__PATCH_TOTALS_MAX_HALF_LENGTH));
    (*cspan_at(&work, to + layout__PATCH_WIDTH)) = (*cspan_at(&work, totals + layout__PATCH_TOTALS_WIDTH));
    (*cspan_at(&work, to + layout__PATCH_CENTROID)) = (*cspan_at(&work, totals + layout__PATCH_TOTALS_CENTROID));
    (*cspan_at(&work, to + layout__PATCH_CONTACT_ANGLE)) = (*cspan_at(&work, patch + layout__SOLVED_PATCH_CONTACT_ANGLE));
    (*cspan_at(&work, to + layout__PATCH_PENETRATION)) = (*cspan_at(&work, patch + layout__SOLVED_PATCH_LOCAL_PENETRATION));
    force = patch + layout__SOLVED_PATCH_FORCE;
    (*cspan_at(&work, to + layout__PATCH_ROLLING_RADIUS)) = (*cspan_at(&work, force + layout__PATCH_FORCE_ROLLING_RADIUS));
    (*cspan_at(&work, to + layout__PATCH_X_TRACK)) = (*cspan_at(&work, force + layout__PATCH_FORCE_X_TRACK));
    (*cspan_at(&work, to + layout__PATCH_Y_TRACK)) = (*cspan_at(&work, force + layout__PATCH_FORCE_Y_TRACK));
    (*cspan_at(&work, to + layout__PATCH_Z_TRACK)) = (*cspan_at(&work, force + layout__PATCH_FORCE_Z_TRACK));
    (*cspan_at(&work, to + layout__PATCH_FORCE + INT64_C(0))) = 0.0;
    (*cspan_at(&work, to + layout__PATCH_FORCE + INT64_C(1))) = (*cspan_at(&work, force + layout__PATCH_FORCE_Y));
    (*cspan_at(&work, to + layout__PATCH_FORCE + INT64_C(2))) = (*cspan_at(&work, force + layout__PATCH_FORCE_Z));
    return INT64_C(0);
}
