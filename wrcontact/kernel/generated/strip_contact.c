/* Generated from normal/strip_contact.py by tools/transpile_kernel.py; change that one.
 *
 * The contact of one side by strips (docs/method.md, section 9).
 */

#include "strip_contact.h"

/* Fill the solved patches by strips; penetration [m], number of regions, and 1 when the force is
 * satisfied, else 0.
 */
static inline int64_t strip_contact__strip_contact(double* penetration, int64_t* count, int64_t* satisfied, array_double_1d work, array_double_1d tables, array_double_1d state, int64_t side, double force, double prescribed)
{
    int64_t by_penetration;
    int64_t deepest;
    by_penetration = INT64_C(0);
    if (isfinite(prescribed))
    {
        by_penetration = INT64_C(1);
    }
    if (!((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PRESSED)) == 1.0))
    {
        (*penetration) = prescribed;
        if (by_penetration == INT64_C(0))
        {
            (*penetration) = estimate__first_penetration(work, tables, state, force);
        }
        if (pressed_regions__sink_wheel(work, tables, side, state, (*penetration)) == INT64_C(0))
        {
            /* it overlaps most at the end of a profile */
            (*count) = INT64_C(0);
            (*satisfied) = INT64_C(0);
            return 0;
        }
    }
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_PENETRATION)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_DEPTH));
    (*count) = pressed_regions__gather_overlaps(work, tables, state);
    planes__locate_along_track(work, tables, (*count));
    deepest = layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_POINTS + layout__DEEP_POINT_SIZE * deep_points__deepest_entry(work);
    strip_zones__find_zones(work, tables, state, (*count), (*cspan_at(&work, deepest + layout__DEEP_POINT_DEPTH)));
    strips__solve_strips(penetration, satisfied, work, tables, state, (*count), force, by_penetration);
    if ((*satisfied) == INT64_C(1))
    {
        strip_patches__fill_from_strips(work, tables, (*count));
    }
    return 0;
}
