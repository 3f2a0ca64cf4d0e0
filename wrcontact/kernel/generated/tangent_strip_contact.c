/* Generated from tangent_strip_contact.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of strip_contact.py.
 */

#include "tangent_strip_contact.h"

/* Tangent of ``strip_contact``. */
static inline int64_t tangent_strip_contact__strip_contact_t(double* penetration, double* penetration_t, int64_t* count, int64_t* satisfied, array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, int64_t side, double force, double force_t, double prescribed, double prescribed_t)
{
    int64_t by_penetration;
    by_penetration = INT64_C(0);
    if (isfinite(prescribed))
    {
        by_penetration = INT64_C(1);
    }
    tangent_analyn_contact__solve_analyn_t(penetration, penetration_t, count, satisfied, work, work_t, tables, state, side, force, force_t, prescribed, prescribed_t);
    if ((*satisfied) == INT64_C(1))
    {
        tangent_planes__locate_along_track_t(work, work_t, tables, (*count));
        tangent_strip_placement__place_strips_t(work, work_t, (*count), (int64_t)((*cspan_at(&tables, layout__TABLES_STRIPS))), (*penetration), (*penetration_t));
        tangent_strip_surfaces__describe_strips_t(work, work_t);
        tangent_strip_surfaces__incline_strips_t(work, work_t, tables);
        tangent_strips__solve_strips_t(penetration, penetration_t, satisfied, work, work_t, tables, state, force, force_t, by_penetration);
        if ((*satisfied) == INT64_C(1))
        {
            tangent_strip_patches__fill_from_strips_t(work, work_t);
        }
    }
    return 0;
}
