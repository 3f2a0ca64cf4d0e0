/* Generated from tangent_strip_contact.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of strip_contact.py.
 */

#include "tangent_strip_contact.h"

/* Tangent of ``strip_contact``. */
static inline int64_t tangent_strip_contact__strip_contact_t(double* result_0_0001, double* result_1_0001, int64_t* result_2, int64_t* result_3, array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, int64_t side, double force, double force_t, double prescribed, double prescribed_t)
{
    int64_t by_penetration;
    int64_t n1;
    int64_t count;
    double penetration;
    double penetration_t;
    int64_t satisfied;
    double estimate_t;
    double estimate;
    double v2;
    double v2_t;
    int64_t repeat;
    int64_t n3;
    int64_t n4;
    by_penetration = INT64_C(0);
    if (isfinite(prescribed))
    {
        by_penetration = INT64_C(1);
    }
    if ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PRESSED)) == 1.0)
    {
        n1 = tangent_strip_contact__open_zones_t(work, work_t, tables, state);
        count = n1;
        tangent_strips__first_layout_t(&penetration, &penetration_t, &satisfied, work, work_t, tables, state, count, force, force_t, INT64_C(1));
    }
    else
    {
        estimate_t = prescribed_t;
        estimate = prescribed;
        if (by_penetration == INT64_C(0))
        {
            tangent_estimate__first_penetration_t(&v2, &v2_t, work, work_t, tables, state, force, force_t);
            estimate_t = v2_t;
            estimate = v2;
        }
        penetration_t = estimate_t;
        penetration = estimate;
        count = INT64_C(0);
        satisfied = INT64_C(0);
        for (repeat = INT64_C(0); repeat < strip_contact__SINKINGS; repeat += INT64_C(1))
        {
            estimate_t = penetration_t;
            estimate = penetration;
            n3 = tangent_pressed_regions__sink_wheel_t(work, work_t, tables, side, state, estimate, estimate_t);
            if (n3 == INT64_C(0))
            {
                (*result_0_0001) = estimate;
                (*result_1_0001) = estimate_t;
                (*result_2) = INT64_C(0);
                (*result_3) = INT64_C(0);
                return 0;
            }
            n4 = tangent_strip_contact__open_zones_t(work, work_t, tables, state);
            count = n4;
            tangent_strips__first_layout_t(&penetration, &penetration_t, &satisfied, work, work_t, tables, state, count, force, force_t, by_penetration);
            if ((satisfied == INT64_C(0)) || (penetration < strip_contact__DEEPER * estimate))
            {
                break;
            }
        }
        if ((satisfied == INT64_C(1)) && (by_penetration == INT64_C(0)))
        {
            tangent_pressed_regions__sink_deeper_t(work, work_t, count, penetration, penetration_t);
            (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_PENETRATION)) = penetration_t;
            (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_PENETRATION)) = penetration;
        }
    }
    if (satisfied == INT64_C(1))
    {
        tangent_strips__second_layout_t(&penetration, &penetration_t, &satisfied, work, work_t, tables, state, count, force, force_t, by_penetration);
    }
    if (satisfied == INT64_C(1))
    {
        tangent_strip_patches__add_stiffness_t(work, work_t, tables, count);
    }
    if ((satisfied == INT64_C(1)) && ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FILLING)) == 1.0))
    {
        tangent_planes__locate_along_track_t(work, work_t, tables, count);
        tangent_strip_patches__fill_from_strips_t(work, work_t, tables, count);
    }
    (*result_0_0001) = penetration;
    (*result_1_0001) = penetration_t;
    (*result_2) = count;
    (*result_3) = satisfied;
    return 0;
}

/* Tangent of ``coarse_contact``. */
static inline int64_t tangent_strip_contact__coarse_contact_t(double* penetration, double* penetration_t, int64_t* count, int64_t* satisfied, array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, double force, double force_t)
{
    int64_t n1;
    n1 = tangent_strip_contact__open_zones_t(work, work_t, tables, state);
    (*count) = n1;
    tangent_strips__first_layout_t(penetration, penetration_t, satisfied, work, work_t, tables, state, (*count), force, force_t, INT64_C(0));
    if ((*satisfied) == INT64_C(1))
    {
        tangent_strip_patches__add_stiffness_t(work, work_t, tables, (*count));
    }
    return 0;
}

/* Tangent of ``open_zones``. */
static inline int64_t tangent_strip_contact__open_zones_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state)
{
    int64_t n1;
    int64_t deepest;
    int64_t count;
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_PENETRATION)) = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_DEPTH));
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_PENETRATION)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_DEPTH));
    n1 = tangent_pressed_regions__gather_overlaps_t(work, work_t, tables, state);
    count = n1;
    deepest = layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_POINTS + layout__DEEP_POINT_SIZE * deep_points__deepest_entry(work);
    tangent_strip_zones__find_zones_t(work, work_t, tables, state, count, (*cspan_at(&work, deepest + layout__DEEP_POINT_DEPTH)), (*cspan_at(&work_t, deepest + layout__DEEP_POINT_DEPTH)));
    return count;
}
