/* Generated from normal/strip_contact.py by tools/transpile_kernel.py; change that one.
 *
 * The contact of one side by strips (docs/method.md, section 9).
 */

#include "strip_contact.h"

/* Fill the solved patches by strips if they are wanted; penetration [m], number of regions, and 1 when
 * the force is satisfied, else 0.
 *
 * A wheel that just touches is sunk to an estimated penetration first, and then to the one that the strips
 * have found there.
 */
static inline int64_t strip_contact__strip_contact(double* result_0_0001, int64_t* result_1, int64_t* result_2, array_double_1d work, array_double_1d tables, array_double_1d state, int64_t side, double force, double prescribed)
{
    int64_t by_penetration;
    int64_t count;
    double penetration;
    int64_t satisfied;
    double estimate;
    int64_t repeat;
    by_penetration = INT64_C(0);
    if (isfinite(prescribed))
    {
        by_penetration = INT64_C(1);
    }
    if ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PRESSED)) == 1.0)
    {
        /* where it is, it has its penetration */
        count = strip_contact__open_zones(work, tables, state);
        strips__first_layout(&penetration, &satisfied, work, tables, state, count, force, INT64_C(1));
    }
    else
    {
        estimate = prescribed;
        if (by_penetration == INT64_C(0))
        {
            estimate = estimate__first_penetration(work, tables, state, force);
        }
        penetration = estimate;
        count = INT64_C(0);
        satisfied = INT64_C(0);
        for (repeat = INT64_C(0); repeat < strip_contact__SINKINGS; repeat += INT64_C(1))
        {
            estimate = penetration;
            if (pressed_regions__sink_wheel(work, tables, side, state, estimate) == INT64_C(0))
            {
                /* it overlaps most at the end of a profile */
                (*result_0_0001) = estimate;
                (*result_1) = INT64_C(0);
                (*result_2) = INT64_C(0);
                return 0;
            }
            count = strip_contact__open_zones(work, tables, state);
            strips__first_layout(&penetration, &satisfied, work, tables, state, count, force, by_penetration);
            if ((satisfied == INT64_C(0)) || (penetration < strip_contact__DEEPER * estimate))
            {
                break;
            }
        }
        if ((satisfied == INT64_C(1)) && (by_penetration == INT64_C(0)))
        {
            pressed_regions__sink_deeper(work, count, penetration);
            (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_PENETRATION)) = penetration;
        }
    }
    if (satisfied == INT64_C(1))
    {
        strips__second_layout(&penetration, &satisfied, work, tables, state, count, force, by_penetration);
    }
    if (satisfied == INT64_C(1))
    {
        strip_patches__add_stiffness(work, tables, count);
    }
    if ((satisfied == INT64_C(1)) && ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FILLING)) == 1.0))
    {
        planes__locate_along_track(work, tables, count);
        strip_patches__fill_from_strips(work, tables, count);
    }
    (*result_0_0001) = penetration;
    (*result_1) = count;
    (*result_2) = satisfied;
    return 0;
}

/* As ``strip_contact`` for a wheel that is pressed and carries ``force`` [N], from the first layout alone
 * and without patches: about a per cent off.
 */
static inline int64_t strip_contact__coarse_contact(double* penetration, int64_t* count, int64_t* satisfied, array_double_1d work, array_double_1d tables, array_double_1d state, double force)
{
    (*count) = strip_contact__open_zones(work, tables, state);
    strips__first_layout(penetration, satisfied, work, tables, state, (*count), force, INT64_C(0));
    if ((*satisfied) == INT64_C(1))
    {
        strip_patches__add_stiffness(work, tables, (*count));
    }
    return 0;
}

/* Open the regions where the wheel overlaps its rail, and their zones; how many. */
static inline int64_t strip_contact__open_zones(array_double_1d work, array_double_1d tables, array_double_1d state)
{
    int64_t deepest;
    int64_t count;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_PENETRATION)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_DEPTH));
    count = pressed_regions__gather_overlaps(work, tables, state);
    deepest = layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_POINTS + layout__DEEP_POINT_SIZE * deep_points__deepest_entry(work);
    strip_zones__find_zones(work, tables, state, count, (*cspan_at(&work, deepest + layout__DEEP_POINT_DEPTH)));
    return count;
}
