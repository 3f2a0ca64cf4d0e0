/* Generated from tangent_tangential_contact.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of tangential_contact.py.
 */

#include "tangent_tangential_contact.h"

/* Tangent of ``solve_tangential``. */
static inline int64_t tangent_tangential_contact__solve_tangential_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t rolling)
{
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
    if (((*cspan_at(&work, rolling + layout__ROLLING_PATCH_LOAD)) > 0.0) && ((*cspan_at(&work, rolling + layout__ROLLING_PATCH_FRICTION)) > 0.0))
    {
        if ((int64_t)((*cspan_at(&tables, layout__TABLES_TANGENTIAL))) == layout__TANGENTIAL_POLACH)
        {
            tangent_polach__solve_polach_t(work, work_t, tables, rolling);
        }
    }
    return INT64_C(0);
}
