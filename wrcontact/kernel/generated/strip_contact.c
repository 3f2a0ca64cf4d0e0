/* Generated from normal/strip_contact.py by tools/transpile_kernel.py; change that one.
 *
 * The contact of one side by ANALYN and the strip correction.
 */

#include "strip_contact.h"

/* Fill the solved patches by the strip correction of ANALYN; penetration [m], number of regions, and 1
 * when the force is satisfied, else 0.
 */
static inline int64_t strip_contact__strip_contact(double* penetration, int64_t* count, int64_t* satisfied, array_double_1d work, array_double_1d tables, array_double_1d state, int64_t side, double force, double prescribed)
{
    int64_t by_penetration;
    by_penetration = INT64_C(0);
    if (isfinite(prescribed))
    {
        by_penetration = INT64_C(1);
    }
    analyn_contact__solve_analyn(penetration, count, satisfied, work, tables, state, side, force, prescribed);
    if ((*satisfied) == INT64_C(1))
    {
        planes__locate_along_track(work, tables, (*count));
        strip_placement__place_strips(work, (*count), (int64_t)((*cspan_at(&tables, layout__TABLES_STRIPS))), (*penetration));
        strip_surfaces__describe_strips(work);
        strip_surfaces__incline_strips(work, tables);
        strips__solve_strips(penetration, satisfied, work, tables, state, force, by_penetration);
        if ((*satisfied) == INT64_C(1))
        {
            strip_patches__fill_from_strips(work);
        }
    }
    return 0;
}
