/* Generated from tangent_totals.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of totals.py.
 */

#include "tangent_totals.h"

/* Tangent of ``write_patches``. */
static inline int64_t tangent_totals__write_patches_t(array_double_1d work, array_double_1d work_t, int64_t side)
{
    double load_t;
    double load;
    double area_t;
    double area;
    double moment_t;
    double moment;
    double pressure_t;
    double pressure;
    double half_length_t;
    double half_length;
    int64_t count;
    int64_t index;
    int64_t patch;
    int64_t rank;
    int64_t last;
    double v1;
    load_t = 0.0;
    load = 0.0;
    area_t = 0.0;
    area = 0.0;
    moment_t = 0.0;
    moment = 0.0;
    pressure_t = 0.0;
    pressure = 0.0;
    half_length_t = 0.0;
    half_length = 0.0;
    count = (int64_t)((*cspan_at(&work, layout__WORK_SOLVED + layout__SOLVED_PATCHES_COUNT)));
    for (index = INT64_C(0); index < count; index += INT64_C(1))
    {
        patch = layout__WORK_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_SIZE * index;
        load_t = load_t + (*cspan_at(&work_t, patch + layout__SOLVED_PATCH_LOAD));
        load = load + (*cspan_at(&work, patch + layout__SOLVED_PATCH_LOAD));
        area_t = area_t + (*cspan_at(&work_t, patch + layout__SOLVED_PATCH_AREA));
        area = area + (*cspan_at(&work, patch + layout__SOLVED_PATCH_AREA));
        moment_t = moment_t + (*cspan_at(&work_t, patch + layout__SOLVED_PATCH_MOMENT));
        moment = moment + (*cspan_at(&work, patch + layout__SOLVED_PATCH_MOMENT));
        if ((*cspan_at(&work, patch + layout__SOLVED_PATCH_MAX_PRESSURE)) > pressure)
        {
            pressure_t = (*cspan_at(&work_t, patch + layout__SOLVED_PATCH_MAX_PRESSURE));
            pressure = (*cspan_at(&work, patch + layout__SOLVED_PATCH_MAX_PRESSURE));
        }
        if ((*cspan_at(&work, patch + layout__SOLVED_PATCH_MAX_HALF_LENGTH)) > half_length)
        {
            half_length_t = (*cspan_at(&work_t, patch + layout__SOLVED_PATCH_MAX_HALF_LENGTH));
            half_length = (*cspan_at(&work, patch + layout__SOLVED_PATCH_MAX_HALF_LENGTH));
        }
        rank = (int64_t)((*cspan_at(&work, patch + layout__SOLVED_PATCH_RANK)));
        if ((rank > INT64_C(0)) && (rank <= layout__PATCH_LIMIT))
        {
            tangent_totals__write_patch_t(work, work_t, patch, side + layout__SIDE_OUTPUTS_PATCH + layout__PATCH_SIZE * (rank - INT64_C(1)));
        }
    }
    (*cspan_at(&work_t, side + layout__SIDE_OUTPUTS_PATCH_COUNT)) = 0.0;
    (*cspan_at(&work, side + layout__SIDE_OUTPUTS_PATCH_COUNT)) = (double)(count);
    (*cspan_at(&work_t, side + layout__SIDE_OUTPUTS_NORMAL_FORCE)) = load_t;
    (*cspan_at(&work, side + layout__SIDE_OUTPUTS_NORMAL_FORCE)) = load;
    (*cspan_at(&work_t, side + layout__SIDE_OUTPUTS_AREA)) = area_t;
    (*cspan_at(&work, side + layout__SIDE_OUTPUTS_AREA)) = area;
    (*cspan_at(&work_t, side + layout__SIDE_OUTPUTS_MAX_PRESSURE)) = pressure_t;
    (*cspan_at(&work, side + layout__SIDE_OUTPUTS_MAX_PRESSURE)) = pressure;
    (*cspan_at(&work_t, side + layout__SIDE_OUTPUTS_PATCH_LENGTH)) = 2.0 * half_length_t;
    (*cspan_at(&work, side + layout__SIDE_OUTPUTS_PATCH_LENGTH)) = 2.0 * half_length;
    if (count > INT64_C(0))
    {
        last = layout__WORK_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_SIZE * (count - INT64_C(1));
        (*cspan_at(&work_t, side + layout__SIDE_OUTPUTS_PATCH_WIDTH)) = (*cspan_at(&work_t, last + layout__SOLVED_PATCH_STOP)) - (*cspan_at(&work_t, layout__WORK_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_START));
        (*cspan_at(&work, side + layout__SIDE_OUTPUTS_PATCH_WIDTH)) = (*cspan_at(&work, last + layout__SOLVED_PATCH_STOP)) - (*cspan_at(&work, layout__WORK_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_START));
        v1 = moment / load;
        (*cspan_at(&work_t, side + layout__SIDE_OUTPUTS_PATCH_CENTROID)) = (moment_t - v1 * load_t) / load;
        (*cspan_at(&work, side + layout__SIDE_OUTPUTS_PATCH_CENTROID)) = v1;
    }
    return INT64_C(0);
}

/* Tangent of ``write_patch``. */
static inline int64_t tangent_totals__write_patch_t(array_double_1d work, array_double_1d work_t, int64_t patch, int64_t to)
{
    double v1;
    (*cspan_at(&work_t, to + layout__PATCH_NORMAL_FORCE)) = (*cspan_at(&work_t, patch + layout__SOLVED_PATCH_LOAD));
    (*cspan_at(&work, to + layout__PATCH_NORMAL_FORCE)) = (*cspan_at(&work, patch + layout__SOLVED_PATCH_LOAD));
    (*cspan_at(&work_t, to + layout__PATCH_AREA)) = (*cspan_at(&work_t, patch + layout__SOLVED_PATCH_AREA));
    (*cspan_at(&work, to + layout__PATCH_AREA)) = (*cspan_at(&work, patch + layout__SOLVED_PATCH_AREA));
    (*cspan_at(&work_t, to + layout__PATCH_MAX_PRESSURE)) = (*cspan_at(&work_t, patch + layout__SOLVED_PATCH_MAX_PRESSURE));
    (*cspan_at(&work, to + layout__PATCH_MAX_PRESSURE)) = (*cspan_at(&work, patch + layout__SOLVED_PATCH_MAX_PRESSURE));
    (*cspan_at(&work_t, to + layout__PATCH_LENGTH)) = 2.0 * (*cspan_at(&work_t, patch + layout__SOLVED_PATCH_MAX_HALF_LENGTH));
    (*cspan_at(&work, to + layout__PATCH_LENGTH)) = 2.0 * (*cspan_at(&work, patch + layout__SOLVED_PATCH_MAX_HALF_LENGTH));
    (*cspan_at(&work_t, to + layout__PATCH_WIDTH)) = (*cspan_at(&work_t, patch + layout__SOLVED_PATCH_STOP)) - (*cspan_at(&work_t, patch + layout__SOLVED_PATCH_START));
    (*cspan_at(&work, to + layout__PATCH_WIDTH)) = (*cspan_at(&work, patch + layout__SOLVED_PATCH_STOP)) - (*cspan_at(&work, patch + layout__SOLVED_PATCH_START));
    v1 = (*cspan_at(&work, patch + layout__SOLVED_PATCH_MOMENT)) / (*cspan_at(&work, patch + layout__SOLVED_PATCH_LOAD));
    (*cspan_at(&work_t, to + layout__PATCH_CENTROID)) = ((*cspan_at(&work_t, patch + layout__SOLVED_PATCH_MOMENT)) - v1 * (*cspan_at(&work_t, patch + layout__SOLVED_PATCH_LOAD))) / (*cspan_at(&work, patch + layout__SOLVED_PATCH_LOAD));
    (*cspan_at(&work, to + layout__PATCH_CENTROID)) = v1;
    (*cspan_at(&work_t, to + layout__PATCH_CONTACT_ANGLE)) = (*cspan_at(&work_t, patch + layout__SOLVED_PATCH_CONTACT_ANGLE));
    (*cspan_at(&work, to + layout__PATCH_CONTACT_ANGLE)) = (*cspan_at(&work, patch + layout__SOLVED_PATCH_CONTACT_ANGLE));
    return INT64_C(0);
}
