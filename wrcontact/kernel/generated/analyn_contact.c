/* Generated from normal/analyn_contact.py by tools/transpile_kernel.py; change that one.
 *
 * ANALYN's contact of one side: estimate, regions, nodes, local penetrations, patches.
 *
 * 1. Estimate the penetration from the force and the width of the interpenetration,
 * 2. find the regions that it reaches, and the half-width of each one's interpenetration, which sets
 * 3. spacing and window of the nodes, on which
 * 4. the force is satisfied.
 *
 * The estimate depends on pose and force alone and is smooth in them, and so is the result.
 */

#include "analyn_contact.h"

/* Fill the solved patches by ANALYN if they are wanted; penetration [m], number of regions, and 1 when
 * the force is satisfied, else 0.
 */
static inline int64_t analyn_contact__analyn_contact(double* penetration, int64_t* count, int64_t* satisfied, array_double_1d work, array_double_1d tables, array_double_1d state, int64_t side, double force, double prescribed)
{
    analyn_contact__solve_analyn(penetration, count, satisfied, work, tables, state, side, force, prescribed);
    if (((*satisfied) == INT64_C(1)) && ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FILLING)) == 1.0))
    {
        planes__locate_along_track(work, tables, (*count));
        node_patches__fill_from_nodes(work, (*count));
    }
    return 0;
}

/* Penetration [m] and number of regions under ``force`` [N], or at ``prescribed`` penetration [m] if that
 * is a number; third value 1 when the force is satisfied, else 0.  A pressed wheel has its regions where it
 * stands.
 */
static inline int64_t analyn_contact__solve_analyn(double* penetration, int64_t* count, int64_t* satisfied, array_double_1d work, array_double_1d tables, array_double_1d state, int64_t side, double force, double prescribed)
{
    int64_t by_penetration;
    int64_t repeat;
    double estimate;
    by_penetration = INT64_C(0);
    (*penetration) = prescribed;
    if (isfinite(prescribed))
    {
        by_penetration = INT64_C(1);
    }
    if ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PRESSED)) == 1.0)
    {
        analyn_contact__solve_estimated(penetration, count, satisfied, work, tables, state, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_DEPTH)), force, by_penetration);
        return 0;
    }
    if (by_penetration == INT64_C(0))
    {
        (*penetration) = estimate__first_penetration(work, tables, state, force);
    }
    (*count) = INT64_C(0);
    (*satisfied) = INT64_C(0);
    for (repeat = INT64_C(0); repeat < analyn_contact__ESTIMATE_REPEATS; repeat += INT64_C(1))
    {
        estimate = (*penetration);
        if (pressed_regions__sink_wheel(work, tables, side, state, estimate) == INT64_C(0))
        {
            /* it overlaps most at the end of a profile */
            (*count) = INT64_C(0);
            (*satisfied) = INT64_C(0);
            return 0;
        }
        analyn_contact__solve_estimated(penetration, count, satisfied, work, tables, state, estimate, force, by_penetration);
        if (((*penetration) < analyn_contact__ESTIMATE_FACTOR * estimate) && (analyn_contact__ESTIMATE_FACTOR * (*penetration) > estimate))
        {
            break;
        }
    }
    return 0;
}

/* Penetration [m] and number of regions, with regions and nodes laid for the ``estimate`` of it; third
 * value 1 when the force is satisfied, else 0.
 */
static inline int64_t analyn_contact__solve_estimated(double* penetration, int64_t* count, int64_t* satisfied, array_double_1d work, array_double_1d tables, array_double_1d state, double estimate, double force, int64_t by_penetration)
{
    (*count) = analyn_contact__gather_regions(work, tables, state, estimate);
    analyn_contact__solve_fine(penetration, satisfied, work, tables, state, (*count), force, estimate, by_penetration);
    if (((*satisfied) == INT64_C(0)) && ((*count) > INT64_C(1)))
    {
        /* regions so close that pressing on each other has no fixed point are one region */
        deep_points__keep_deepest(work);
        (*count) = analyn_contact__gather_regions(work, tables, state, estimate);
        analyn_contact__solve_fine(penetration, satisfied, work, tables, state, (*count), force, estimate, by_penetration);
    }
    return 0;
}

/* Open the regions where the wheel overlaps its rail, with their first local penetrations; their
 * number.
 */
static inline int64_t analyn_contact__gather_regions(array_double_1d work, array_double_1d tables, array_double_1d state, double penetration)
{
    int64_t i;
    int64_t count;
    for (i = INT64_C(0); i < layout__REGION_LIMIT; i += INT64_C(1))
    {
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * i + layout__REGION_WIDTH_PENETRATION)) = 0.0;
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * i + layout__REGION_SLANT)) = 0.0;
    }
    count = pressed_regions__gather_overlaps(work, tables, state);
    estimate__start_penetrations(work, count, penetration);
    return count;
}

/* Penetration [m] on fine nodes over the regions, laid again where the patch outgrows them; and 1 when
 * the force is satisfied, else 0.
 */
static inline int64_t analyn_contact__solve_fine(double* result_0_0001, int64_t* result_1, array_double_1d work, array_double_1d tables, array_double_1d state, int64_t count, double force, double penetration, int64_t by_penetration)
{
    double start;
    double enlarge;
    int64_t satisfied;
    int64_t repeat;
    start = penetration;
    enlarge = 1.0;
    satisfied = INT64_C(0);
    for (repeat = INT64_C(0); repeat < analyn_contact__COVER_REPEATS; repeat += INT64_C(1))
    {
        node_layout__prepare_regions(work, tables, state, count, enlarge);
        analyn__solve_penetrations(&penetration, &satisfied, work, tables, state, count, force, start, by_penetration);
        if (satisfied == INT64_C(0))
        {
            (*result_0_0001) = start;
            (*result_1) = satisfied;
            return 0;
        }
        if (node_layout__covered(work, count) == INT64_C(1))
        {
            break;
        }
        if (repeat < analyn_contact__COVER_REPEATS - INT64_C(1))
        {
            enlarge *= analyn_contact__ENLARGED;
            start = penetration;
            /* nodes stay where the wheel stands; there are only more of them */
            estimate__start_penetrations(work, count, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_DEPTH)));
        }
    }
    (*result_0_0001) = penetration;
    (*result_1) = satisfied;
    return 0;
}
