/* Generated from wheelset/damping.py by tools/transpile_kernel.py; change that one.
 *
 * Contact damping of a compliant wheelset: forces grow with the speed of the approach.
 *
 * The force of a patch is multiplied by 1 + d a, with the contact damping d [s/m] and the speed a [m/s] at which
 * wheel and rail approach each other along the patch's normal at its centre of load; it is never below zero.
 * Areas and pressures stay those of the elastic contact.
 */

#include "damping.h"

/* 1 if contact is damped, else 0. */
static inline int64_t damping__is_damped(array_double_1d tables)
{
    int64_t damped;
    damped = INT64_C(0);
    if (((int64_t)((*cspan_at(&tables, layout__TABLES_MODE))) == layout__MODE_COMPLIANT) && ((*cspan_at(&tables, layout__TABLES_PARAMETERS + layout__PARAMETERS_CONTACT_DAMPING)) > 0.0))
    {
        damped = INT64_C(1);
    }
    return damped;
}

/* Damp the forces of the solved patches of side ``index``, and add them up to its ``resultant``. */
static inline int64_t damping__damp_patches(array_double_1d work, array_double_1d tables, int64_t index, int64_t resultant)
{
    int64_t i;
    double load;
    double moment;
    int64_t number_end;
    int64_t number;
    int64_t patch;
    int64_t force;
    for (i = INT64_C(0); i < layout__RESULTANT_COUNT; i += INT64_C(1))
    {
        (*cspan_at(&work, resultant + i)) = 0.0;
    }
    load = 0.0;
    moment = 0.0;
    number_end = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_COUNT)));
    for (number = INT64_C(0); number < number_end; number += INT64_C(1))
    {
        patch = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_SIZE * number;
        damping__damp_patch(work, patch, damping__damping_factor(work, tables, patch, index));
        force = patch + layout__SOLVED_PATCH_FORCE;
        (*cspan_at(&work, resultant + INT64_C(1))) += (*cspan_at(&work, force + layout__PATCH_FORCE_Y));
        (*cspan_at(&work, resultant + INT64_C(2))) += (*cspan_at(&work, force + layout__PATCH_FORCE_Z));
        (*cspan_at(&work, resultant + INT64_C(3))) += (*cspan_at(&work, force + layout__PATCH_FORCE_MOMENT_X));
        (*cspan_at(&work, resultant + INT64_C(4))) += (*cspan_at(&work, force + layout__PATCH_FORCE_MOMENT_Y));
        (*cspan_at(&work, resultant + INT64_C(5))) += (*cspan_at(&work, force + layout__PATCH_FORCE_MOMENT_Z));
        load += (*cspan_at(&work, patch + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_LOAD));
        moment += (*cspan_at(&work, patch + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_MOMENT));
    }
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_LOAD)) = load;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_MOMENT)) = moment;
    if (load > 0.0)
    {
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_TOTALS + layout__PATCH_TOTALS_CENTROID)) = moment / load;
    }
    return INT64_C(0);
}

/* By what the force of a patch of side ``index`` is multiplied. */
static inline double damping__damping_factor(array_double_1d work, array_double_1d tables, int64_t patch, int64_t index)
{
    double factor;
    factor = 1.0 + (*cspan_at(&tables, layout__TABLES_PARAMETERS + layout__PARAMETERS_CONTACT_DAMPING)) * approach__approach_rate(work, index, patch + layout__SOLVED_PATCH_FORCE, (*cspan_at(&work, patch + layout__SOLVED_PATCH_CONTACT_ANGLE)));
    if (factor < 0.0)
    {
        factor = 0.0;
    }
    return factor;
}

/* Multiply load, force and moments of a patch by ``factor``. */
static inline int64_t damping__damp_patch(array_double_1d work, int64_t patch, double factor)
{
    int64_t force;
    (*cspan_at(&work, patch + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_LOAD)) *= factor;
    (*cspan_at(&work, patch + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_MOMENT)) *= factor;
    force = patch + layout__SOLVED_PATCH_FORCE;
    (*cspan_at(&work, force + layout__PATCH_FORCE_Y)) *= factor;
    (*cspan_at(&work, force + layout__PATCH_FORCE_Z)) *= factor;
    (*cspan_at(&work, force + layout__PATCH_FORCE_MOMENT_X)) *= factor;
    (*cspan_at(&work, force + layout__PATCH_FORCE_MOMENT_Y)) *= factor;
    (*cspan_at(&work, force + layout__PATCH_FORCE_MOMENT_Z)) *= factor;
    return INT64_C(0);
}
