/* Generated from tangent_damping.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of damping.py.
 */

#include "tangent_damping.h"

/* Tangent of ``damp_patches``. */
static inline int64_t tangent_damping__damp_patches_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t index, int64_t resultant)
{
    int64_t i;
    double load_t;
    double load;
    double moment_t;
    double moment;
    int64_t number_end;
    int64_t number;
    int64_t patch;
    double v1;
    double v1_t;
    int64_t force;
    double v2;
    for (i = INT64_C(0); i < layout__RESULTANT_COUNT; i += INT64_C(1))
    {
        (*cspan_at(&work_t, resultant + i)) = 0.0;
        (*cspan_at(&work, resultant + i)) = 0.0;
    }
    load_t = 0.0;
    load = 0.0;
    moment_t = 0.0;
    moment = 0.0;
    number_end = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_COUNT)));
    for (number = INT64_C(0); number < number_end; number += INT64_C(1))
    {
        patch = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_SIZE * number;
        tangent_damping__damping_factor_t(&v1, &v1_t, work, work_t, tables, patch, index);
        tangent_damping__damp_patch_t(work, work_t, patch, v1, v1_t);
        force = patch + layout__SOLVED_PATCH_FORCE;
        (*cspan_at(&work_t, resultant + INT64_C(1))) = (*cspan_at(&work_t, resultant + INT64_C(1))) + (*cspan_at(&work_t, force + layout__PATCH_FORCE_Y));
        (*cspan_at(&work, resultant + INT64_C(1))) = (*cspan_at(&work, resultant + INT64_C(1))) + (*cspan_at(&work, force + layout__PATCH_FORCE_Y));
        (*cspan_at(&work_t, resultant + INT64_C(2))) = (*cspan_at(&work_t, resultant + INT64_C(2))) + (*cspan_at(&work_t, force + layout__PATCH_FORCE_Z));
        (*cspan_at(&work, resultant + INT64_C(2))) = (*cspan_at(&work, resultant + INT64_C(2))) + (*cspan_at(&work, force + layout__PATCH_FORCE_Z));
        (*cspan_at(&work_t, resultant + INT64_C(3))) = (*cspan_at(&work_t, resultant + INT64_C(3))) + (*cspan_at(&work_t, force + layout__PATCH_FORCE_MOMENT_X));
        (*cspan_at(&work, resultant + INT64_C(3))) = (*cspan_at(&work, resultant + INT64_C(3))) + (*cspan_at(&work, force + layout__PATCH_FORCE_MOMENT_X));
        (*cspan_at(&work_t, resultant + INT64_C(4))) = (*cspan_at(&work_t, resultant + INT64_C(4))) + (*cspan_at(&work_t, force + layout__PATCH_FORCE_MOMENT_Y));
        (*cspan_at(&work, resultant + INT64_C(4))) = (*cspan_at(&work, resultant + INT64_C(4))) + (*cspan_at(&work, force + layout__PATCH_FORCE_MOMENT_Y));
        (*cspan_at(&work_t, resultant + INT64_C(5))) = (*cspan_at(&work_t, resultant + INT64_C(5))) + (*cspan_at(&work_t, force + layout__PATCH_FORCE_MOMENT_Z));
        (*cspan_at(&work, resultant + INT64_C(5))) = (*cspan_at(&work, resultant + INT64_C(5))) + (*cspan_at(&work, force + layout__PATCH_FORCE_MOMENT_Z));
        load_t = load_t + (*cspan_at(&work_t, patch + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_LOAD));
        load = load + (*cspan_at(&work, patch + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_LOAD));
        moment_t = moment_t + (*cspan_at(&work_t, patch + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_MOMENT));
        moment = moment + (*cspan_at(&work, patch + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_MOMENT));
    }
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_LOAD)) = load_t;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_LOAD)) = load;
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_MOMENT)) = moment_t;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_MOMENT)) = moment;
    if (load > 0.0)
    {
        v2 = moment / load;
        (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_CENTROID)) = (moment_t - v2 * load_t) / load;
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_CENTROID)) = v2;
    }
    return INT64_C(0);
}

/* Tangent of ``damping_factor``. */
static inline int64_t tangent_damping__damping_factor_t(double* factor, double* factor_t, array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t patch, int64_t index)
{
    double v1;
    double v1_t;
    tangent_approach__approach_rate_t(&v1, &v1_t, work, work_t, index, patch + layout__SOLVED_PATCH_FORCE, (*cspan_at(&work, patch + layout__SOLVED_PATCH_CONTACT_ANGLE)), (*cspan_at(&work_t, patch + layout__SOLVED_PATCH_CONTACT_ANGLE)));
    (*factor_t) = (*cspan_at(&tables, layout__TABLES_PARAMETERS + layout__PARAMETERS_CONTACT_DAMPING)) * v1_t;
    (*factor) = 1.0 + (*cspan_at(&tables, layout__TABLES_PARAMETERS + layout__PARAMETERS_CONTACT_DAMPING)) * v1;
    if ((*factor) < 0.0)
    {
        (*factor_t) = 0.0;
        (*factor) = 0.0;
    }
    return 0;
}

/* Tangent of ``damp_patch``. */
static inline int64_t tangent_damping__damp_patch_t(array_double_1d work, array_double_1d work_t, int64_t patch, double factor, double factor_t)
{
    int64_t force;
    (*cspan_at(&work_t, patch + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_LOAD)) = (*cspan_at(&work_t, patch + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_LOAD)) * factor + (*cspan_at(&work, patch + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_LOAD)) * factor_t;
    (*cspan_at(&work, patch + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_LOAD)) = (*cspan_at(&work, patch + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_LOAD)) * factor;
    (*cspan_at(&work_t, patch + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_MOMENT)) = (*cspan_at(&work_t, patch + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_MOMENT)) * factor + (*cspan_at(&work, patch + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_MOMENT)) * factor_t;
    (*cspan_at(&work, patch + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_MOMENT)) = (*cspan_at(&work, patch + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_MOMENT)) * factor;
    force = patch + layout__SOLVED_PATCH_FORCE;
    (*cspan_at(&work_t, force + layout__PATCH_FORCE_Y)) = (*cspan_at(&work_t, force + layout__PATCH_FORCE_Y)) * factor + (*cspan_at(&work, force + layout__PATCH_FORCE_Y)) * factor_t;
    (*cspan_at(&work, force + layout__PATCH_FORCE_Y)) = (*cspan_at(&work, force + layout__PATCH_FORCE_Y)) * factor;
    (*cspan_at(&work_t, force + layout__PATCH_FORCE_Z)) = (*cspan_at(&work_t, force + layout__PATCH_FORCE_Z)) * factor + (*cspan_at(&work, force + layout__PATCH_FORCE_Z)) * factor_t;
    (*cspan_at(&work, force + layout__PATCH_FORCE_Z)) = (*cspan_at(&work, force + layout__PATCH_FORCE_Z)) * factor;
    (*cspan_at(&work_t, force + layout__PATCH_FORCE_MOMENT_X)) = (*cspan_at(&work_t, force + layout__PATCH_FORCE_MOMENT_X)) * factor + (*cspan_at(&work, force + layout__PATCH_FORCE_MOMENT_X)) * factor_t;
    (*cspan_at(&work, force + layout__PATCH_FORCE_MOMENT_X)) = (*cspan_at(&work, force + layout__PATCH_FORCE_MOMENT_X)) * factor;
    (*cspan_at(&work_t, force + layout__PATCH_FORCE_MOMENT_Y)) = (*cspan_at(&work_t, force + layout__PATCH_FORCE_MOMENT_Y)) * factor + (*cspan_at(&work, force + layout__PATCH_FORCE_MOMENT_Y)) * factor_t;
    (*cspan_at(&work, force + layout__PATCH_FORCE_MOMENT_Y)) = (*cspan_at(&work, force + layout__PATCH_FORCE_MOMENT_Y)) * factor;
    (*cspan_at(&work_t, force + layout__PATCH_FORCE_MOMENT_Z)) = (*cspan_at(&work_t, force + layout__PATCH_FORCE_MOMENT_Z)) * factor + (*cspan_at(&work, force + layout__PATCH_FORCE_MOMENT_Z)) * factor_t;
    (*cspan_at(&work, force + layout__PATCH_FORCE_MOMENT_Z)) = (*cspan_at(&work, force + layout__PATCH_FORCE_MOMENT_Z)) * factor;
    return INT64_C(0);
}
