/* Generated from tangential/tangential_contact.py by tools/transpile_kernel.py; change that one.
 *
 * The creep force of a patch by the chosen model.
 */

#include "tangential_contact.h"

/* Force, moment, stick share and largest traction of a patch that rolls, into its record.
 *
 * All are zero where nothing presses or nothing rubs.
 */
static inline int64_t tangential_contact__solve_tangential(array_double_1d work, array_double_1d tables, int64_t rolling)
{
    (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_X)) = 0.0;
    (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_Y)) = 0.0;
    (*cspan_at(&work, rolling + layout__ROLLING_PATCH_MOMENT)) = 0.0;
    (*cspan_at(&work, rolling + layout__ROLLING_PATCH_STICK_SHARE)) = 0.0;
    (*cspan_at(&work, rolling + layout__ROLLING_PATCH_MAX_SHEAR)) = 0.0;
    if (((*cspan_at(&work, rolling + layout__ROLLING_PATCH_LOAD)) > 0.0) && ((*cspan_at(&work, rolling + layout__ROLLING_PATCH_FRICTION)) > 0.0))
    {
        if ((int64_t)((*cspan_at(&tables, layout__TABLES_TANGENTIAL))) == layout__TANGENTIAL_POLACH)
        {
            polach__solve_polach(work, tables, rolling);
        }
    }
    return INT64_C(0);
}
