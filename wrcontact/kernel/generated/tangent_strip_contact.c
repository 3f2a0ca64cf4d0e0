/* Generated from tangent_strip_contact.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of strip_contact.py.
 */

#include "tangent_strip_contact.h"

/* Tangent of ``strip_contact``. */
static inline int64_t tangent_strip_contact__strip_contact_t(double* penetration, double* penetration_t, int64_t* count, int64_t* satisfied, array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, int64_t side, double force, double force_t, double prescribed, double prescribed_t)
{
    int64_t by_penetration;
    double v1;
    double v1_t;
    int64_t n2;
    int64_t n3;
    int64_t deepest;
    by_penetration = INT64_C(0);
    if (isfinite(prescribed))
    {
        by_penetration = INT64_C(1);
    }
    if (!((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PRESSED)) == 1.0))
    {
        (*penetration_t) = prescribed_t;
        (*penetration) = prescribed;
        if (by_penetration == INT64_C(0))
        {
            tangent_estimate__first_penetration_t(&v1, &v1_t, work, work_t, tables, state, force, force_t);
            (*penetration_t) = v1_t;
            (*penetration) = v1;
        }
        n2 = tangent_pressed_regions__sink_wheel_t(work, work_t, tables, side, state, (*penetration), (*penetration_t));
        if (n2 == INT64_C(0))
        {
            (*count) = INT64_C(0);
            (*satisfied) = INT64_C(0);
            return 0;
        }
    }
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_PENETRATION)) = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_DEPTH));
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_PENETRATION)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_DEPTH));
    n3 = tangent_pressed_regions__gather_overlaps_t(work, work_t, tables, state);
    (*count) = n3;
    tangent_planes__locate_along_track_t(work, work_t, tables, (*count));
    deepest = layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_POINTS + layout__DEEP_POINT_SIZE * deep_points__deepest_entry(work);
    tangent_strip_zones__find_zones_t(work, work_t, tables, state, (*count), (*cspan_at(&work, deepest + layout__DEEP_POINT_DEPTH)), (*cspan_at(&work_t, deepest + layout__DEEP_POINT_DEPTH)));
    tangent_strips__solve_strips_t(penetration, penetration_t, satisfied, work, work_t, tables, state, (*count), force, force_t, by_penetration);
    if ((*satisfied) == INT64_C(1))
    {
        tangent_strip_patches__fill_from_strips_t(work, work_t, tables, (*count));
    }
    return 0;
}
