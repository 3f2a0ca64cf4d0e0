/* Generated from tangential/tangential_contact.py by tools/transpile_kernel.py; change that one.
 *
 * The creep force of a patch by the chosen model.
 */

#include "tangential_contact.h"

/* Force, moment, stick share and largest traction of a patch that rolls, into its record.
 *
 * All are zero where nothing presses or nothing rubs.  A patch that rolls backwards is solved as its mirror
 * image that rolls forwards.
 */
static inline int64_t tangential_contact__solve_tangential(array_double_1d work, array_double_1d tables, int64_t rolling)
{
    tangential_contact__clear_found(work, rolling);
    if (((*cspan_at(&work, rolling + layout__ROLLING_PATCH_LOAD)) > 0.0) && ((*cspan_at(&work, rolling + layout__ROLLING_PATCH_FRICTION)) > 0.0) && ((*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_LENGTH)) > 0.0))
    {
        if ((*cspan_at(&work, rolling + layout__ROLLING_PATCH_BACKWARDS)) == 1.0)
        {
            tangential_contact__mirror_rolling(work, rolling);
        }
        if ((int64_t)((*cspan_at(&tables, layout__TABLES_TANGENTIAL))) == layout__TANGENTIAL_STRIPS)
        {
            coupled_strips__solve_strips(work, tables, rolling);
        }
        else if ((int64_t)((*cspan_at(&tables, layout__TABLES_TANGENTIAL))) == layout__TANGENTIAL_FASTSIM)
        {
            fastsim__solve_fastsim(work, tables, rolling);
        }
        else if ((int64_t)((*cspan_at(&tables, layout__TABLES_TANGENTIAL))) == layout__TANGENTIAL_FASTRIP)
        {
            fastrip__solve_fastrip(work, tables, rolling);
        }
        else if ((int64_t)((*cspan_at(&tables, layout__TABLES_TANGENTIAL))) == layout__TANGENTIAL_POLACH)
        {
            polach__solve_polach(work, tables, rolling);
        }
        if (((int64_t)((*cspan_at(&tables, layout__TABLES_TANGENTIAL))) != layout__TANGENTIAL_POLACH) && (!((*cspan_at(&work, rolling + layout__ROLLING_PATCH_BARE)) == 1.0)))
        {
            /* Polach's formula has no moment, which belongs to the power of spin */
            dissipation__keep_dissipating(work, rolling);
        }
        if ((*cspan_at(&work, rolling + layout__ROLLING_PATCH_BACKWARDS)) == 1.0)
        {
            tangential_contact__mirror_rolling(work, rolling);
        }
    }
    return INT64_C(0);
}

/* Nothing is found yet. */
static inline int64_t tangential_contact__clear_found(array_double_1d work, int64_t rolling)
{
    int64_t i_end;
    int64_t i;
    int64_t strip;
    (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_X)) = 0.0;
    (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_Y)) = 0.0;
    (*cspan_at(&work, rolling + layout__ROLLING_PATCH_MOMENT)) = 0.0;
    (*cspan_at(&work, rolling + layout__ROLLING_PATCH_STICK_SHARE)) = 0.0;
    (*cspan_at(&work, rolling + layout__ROLLING_PATCH_MAX_SHEAR)) = 0.0;
    i_end = (int64_t)((*cspan_at(&work, rolling + layout__ROLLING_PATCH_COUNT)));
    for (i = INT64_C(0); i < i_end; i += INT64_C(1))
    {
        strip = rolling + layout__ROLLING_PATCH_STRIPS + layout__ROLLING_STRIP_SIZE * i;
        (*cspan_at(&work, strip + layout__ROLLING_STRIP_FORCE_X)) = 0.0;
        (*cspan_at(&work, strip + layout__ROLLING_STRIP_FORCE_Y)) = 0.0;
        (*cspan_at(&work, strip + layout__ROLLING_STRIP_MOMENT)) = 0.0;
    }
    return INT64_C(0);
}

/* The mirror image of a patch, what is known of it and what is found, in the plane across the rail. */
static inline int64_t tangential_contact__mirror_rolling(array_double_1d work, int64_t rolling)
{
    int64_t i_end;
    int64_t i;
    int64_t strip;
    (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_X)) = -(*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_X));
    (*cspan_at(&work, rolling + layout__ROLLING_PATCH_SPIN)) = -(*cspan_at(&work, rolling + layout__ROLLING_PATCH_SPIN));
    (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_X)) = -(*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_X));
    (*cspan_at(&work, rolling + layout__ROLLING_PATCH_MOMENT)) = -(*cspan_at(&work, rolling + layout__ROLLING_PATCH_MOMENT));
    i_end = (int64_t)((*cspan_at(&work, rolling + layout__ROLLING_PATCH_COUNT)));
    for (i = INT64_C(0); i < i_end; i += INT64_C(1))
    {
        strip = rolling + layout__ROLLING_PATCH_STRIPS + layout__ROLLING_STRIP_SIZE * i;
        (*cspan_at(&work, strip + layout__ROLLING_STRIP_X)) = -(*cspan_at(&work, strip + layout__ROLLING_STRIP_X));
        (*cspan_at(&work, strip + layout__ROLLING_STRIP_SLIP)) = -(*cspan_at(&work, strip + layout__ROLLING_STRIP_SLIP));
        (*cspan_at(&work, strip + layout__ROLLING_STRIP_FORCE_X)) = -(*cspan_at(&work, strip + layout__ROLLING_STRIP_FORCE_X));
        (*cspan_at(&work, strip + layout__ROLLING_STRIP_MOMENT)) = -(*cspan_at(&work, strip + layout__ROLLING_STRIP_MOMENT));
    }
    return INT64_C(0);
}
