/* Generated from tangent_tangential_contact.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of tangential_contact.py.
 */

#include "tangent_tangential_contact.h"

/* Tangent of ``solve_tangential``. */
static inline int64_t tangent_tangential_contact__solve_tangential_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t rolling)
{
    tangent_tangential_contact__clear_found_t(work, work_t, rolling);
    if (((*cspan_at(&work, rolling + layout__ROLLING_PATCH_LOAD)) > 0.0) && ((*cspan_at(&work, rolling + layout__ROLLING_PATCH_FRICTION)) > 0.0) && ((*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_LENGTH)) > 0.0))
    {
        if ((*cspan_at(&work, rolling + layout__ROLLING_PATCH_BACKWARDS)) == 1.0)
        {
            tangent_tangential_contact__mirror_rolling_t(work, work_t, rolling);
        }
        if ((int64_t)((*cspan_at(&tables, layout__TABLES_TANGENTIAL))) == layout__TANGENTIAL_STRIPS)
        {
            tangent_coupled_strips__solve_strips_t(work, work_t, tables, rolling);
        }
        else if ((int64_t)((*cspan_at(&tables, layout__TABLES_TANGENTIAL))) == layout__TANGENTIAL_FASTSIM)
        {
            tangent_fastsim__solve_fastsim_t(work, work_t, tables, rolling);
        }
        else if ((int64_t)((*cspan_at(&tables, layout__TABLES_TANGENTIAL))) == layout__TANGENTIAL_FASTRIP)
        {
            tangent_fastrip__solve_fastrip_t(work, work_t, tables, rolling);
        }
        else if ((int64_t)((*cspan_at(&tables, layout__TABLES_TANGENTIAL))) == layout__TANGENTIAL_POLACH)
        {
            tangent_polach__solve_polach_t(work, work_t, tables, rolling);
        }
        if (((int64_t)((*cspan_at(&tables, layout__TABLES_TANGENTIAL))) != layout__TANGENTIAL_POLACH) && (!((*cspan_at(&work, rolling + layout__ROLLING_PATCH_BARE)) == 1.0)))
        {
            tangent_dissipation__keep_dissipating_t(work, work_t, rolling);
        }
        if ((*cspan_at(&work, rolling + layout__ROLLING_PATCH_BACKWARDS)) == 1.0)
        {
            tangent_tangential_contact__mirror_rolling_t(work, work_t, rolling);
        }
    }
    return INT64_C(0);
}

/* Tangent of ``clear_found``. */
static inline int64_t tangent_tangential_contact__clear_found_t(array_double_1d work, array_double_1d work_t, int64_t rolling)
{
    int64_t i_end;
    int64_t i;
    int64_t strip;
    (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_FORCE_X)) = 0.0;
    (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_X)) = 0.0;
    (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_FORCE_Y)) = 0.0;
    (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_Y)) = 0.0;
    (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_MOMENT)) = 0.0;
    (*cspan_at(&work, rolling + layout__ROLLING_PATCH_MOMENT)) = 0.0;
    (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_STICK_SHARE)) = 0.0;
    (*cspan_at(&work, rolling + layout__ROLLING_PATCH_STICK_SHARE)) = 0.0;
    (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_MAX_SHEAR)) = 0.0;
    (*cspan_at(&work, rolling + layout__ROLLING_PATCH_MAX_SHEAR)) = 0.0;
    i_end = (int64_t)((*cspan_at(&work, rolling + layout__ROLLING_PATCH_COUNT)));
    for (i = INT64_C(0); i < i_end; i += INT64_C(1))
    {
        strip = rolling + layout__ROLLING_PATCH_STRIPS + layout__ROLLING_STRIP_SIZE * i;
        (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_FORCE_X)) = 0.0;
        (*cspan_at(&work, strip + layout__ROLLING_STRIP_FORCE_X)) = 0.0;
        (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_FORCE_Y)) = 0.0;
        (*cspan_at(&work, strip + layout__ROLLING_STRIP_FORCE_Y)) = 0.0;
        (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_MOMENT)) = 0.0;
        (*cspan_at(&work, strip + layout__ROLLING_STRIP_MOMENT)) = 0.0;
    }
    return INT64_C(0);
}

/* Tangent of ``mirror_rolling``. */
static inline int64_t tangent_tangential_contact__mirror_rolling_t(array_double_1d work, array_double_1d work_t, int64_t rolling)
{
    int64_t i_end;
    int64_t i;
    int64_t strip;
    (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_CREEPAGE_X)) = -(*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_CREEPAGE_X));
    (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_X)) = -(*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_X));
    (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_SPIN)) = -(*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_SPIN));
    (*cspan_at(&work, rolling + layout__ROLLING_PATCH_SPIN)) = -(*cspan_at(&work, rolling + layout__ROLLING_PATCH_SPIN));
    (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_FORCE_X)) = -(*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_FORCE_X));
    (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_X)) = -(*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_X));
    (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_MOMENT)) = -(*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_MOMENT));
    (*cspan_at(&work, rolling + layout__ROLLING_PATCH_MOMENT)) = -(*cspan_at(&work, rolling + layout__ROLLING_PATCH_MOMENT));
    i_end = (int64_t)((*cspan_at(&work, rolling + layout__ROLLING_PATCH_COUNT)));
    for (i = INT64_C(0); i < i_end; i += INT64_C(1))
    {
        strip = rolling + layout__ROLLING_PATCH_STRIPS + layout__ROLLING_STRIP_SIZE * i;
        (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_X)) = -(*cspan_at(&work_t, strip + layout__ROLLING_STRIP_X));
        (*cspan_at(&work, strip + layout__ROLLING_STRIP_X)) = -(*cspan_at(&work, strip + layout__ROLLING_STRIP_X));
        (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_SLIP)) = -(*cspan_at(&work_t, strip + layout__ROLLING_STRIP_SLIP));
        (*cspan_at(&work, strip + layout__ROLLING_STRIP_SLIP)) = -(*cspan_at(&work, strip + layout__ROLLING_STRIP_SLIP));
        (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_FORCE_X)) = -(*cspan_at(&work_t, strip + layout__ROLLING_STRIP_FORCE_X));
        (*cspan_at(&work, strip + layout__ROLLING_STRIP_FORCE_X)) = -(*cspan_at(&work, strip + layout__ROLLING_STRIP_FORCE_X));
        (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_MOMENT)) = -(*cspan_at(&work_t, strip + layout__ROLLING_STRIP_MOMENT));
        (*cspan_at(&work, strip + layout__ROLLING_STRIP_MOMENT)) = -(*cspan_at(&work, strip + layout__ROLLING_STRIP_MOMENT));
    }
    return INT64_C(0);
}
