/* Generated from tangent_analyn_contact.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of analyn_contact.py.
 */

#include "tangent_analyn_contact.h"

/* Tangent of ``analyn_contact``. */
static inline int64_t tangent_analyn_contact__analyn_contact_t(double* penetration, double* penetration_t, int64_t* count, int64_t* satisfied, array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, int64_t side, double force, double force_t, double prescribed, double prescribed_t)
{
    tangent_analyn_contact__solve_analyn_t(penetration, penetration_t, count, satisfied, work, work_t, tables, state, side, force, force_t, prescribed, prescribed_t);
    if (((*satisfied) == INT64_C(1)) && ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FILLING)) == 1.0))
    {
        tangent_planes__locate_along_track_t(work, work_t, tables, (*count));
        tangent_node_patches__fill_from_nodes_t(work, work_t, (*count));
    }
    return 0;
}

/* Tangent of ``solve_analyn``. */
static inline int64_t tangent_analyn_contact__solve_analyn_t(double* penetration, double* penetration_t, int64_t* count, int64_t* satisfied, array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, int64_t side, double force, double force_t, double prescribed, double prescribed_t)
{
    int64_t by_penetration;
    double v1;
    double v1_t;
    int64_t repeat;
    double estimate_t;
    double estimate;
    by_penetration = INT64_C(0);
    (*penetration_t) = prescribed_t;
    (*penetration) = prescribed;
    if (isfinite(prescribed))
    {
        by_penetration = INT64_C(1);
    }
    if ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PRESSED)) == 1.0)
    {
        tangent_analyn_contact__solve_estimated_t(penetration, penetration_t, count, satisfied, work, work_t, tables, state, side, force, force_t, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_DEPTH)), (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_DEPTH)), by_penetration);
        return 0;
    }
    if (by_penetration == INT64_C(0))
    {
        tangent_estimate__first_penetration_t(&v1, &v1_t, work, work_t, tables, state, force, force_t);
        (*penetration_t) = v1_t;
        (*penetration) = v1;
    }
    (*count) = INT64_C(1);
    (*satisfied) = INT64_C(0);
    for (repeat = INT64_C(0); repeat < analyn_contact__ESTIMATE_REPEATS; repeat += INT64_C(1))
    {
        estimate_t = (*penetration_t);
        estimate = (*penetration);
        tangent_analyn_contact__solve_estimated_t(penetration, penetration_t, count, satisfied, work, work_t, tables, state, side, force, force_t, estimate, estimate_t, by_penetration);
        if (((*penetration) < analyn_contact__ESTIMATE_FACTOR * estimate) && (analyn_contact__ESTIMATE_FACTOR * (*penetration) > estimate))
        {
            break;
        }
    }
    return 0;
}

/* Tangent of ``solve_estimated``. */
static inline int64_t tangent_analyn_contact__solve_estimated_t(double* penetration, double* penetration_t, int64_t* count, int64_t* satisfied, array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, int64_t side, double force, double force_t, double estimate, double estimate_t, int64_t by_penetration)
{
    int64_t n1;
    n1 = tangent_analyn_contact__gather_regions_t(work, work_t, tables, state, side, estimate, estimate_t);
    (*count) = n1;
    tangent_analyn_contact__solve_fine_t(penetration, penetration_t, satisfied, work, work_t, tables, state, (*count), force, force_t, estimate, estimate_t, by_penetration);
    if (((*satisfied) == INT64_C(0)) && ((*count) > INT64_C(1)))
    {
        (*count) = INT64_C(1);
        if ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PRESSED)) == 1.0)
        {
            tangent_deep_points__keep_deepest_t(work, work_t);
            tangent_pressed_regions__gather_overlaps_t(work, work_t, tables, state);
        }
        else
        {
            tangent_regions__open_contact_region_t(work, work_t, tables, layout__WORK_CONTACT + layout__CONTACT_REGIONS);
        }
        tangent_estimate__start_penetrations_t(work, work_t, (*count), estimate, estimate_t);
        tangent_analyn_contact__solve_fine_t(penetration, penetration_t, satisfied, work, work_t, tables, state, (*count), force, force_t, estimate, estimate_t, by_penetration);
    }
    return 0;
}

/* Tangent of ``gather_regions``. */
static inline int64_t tangent_analyn_contact__gather_regions_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, int64_t side, double penetration, double penetration_t)
{
    int64_t i;
    int64_t n1;
    int64_t n2;
    int64_t n3;
    int64_t count;
    for (i = INT64_C(0); i < layout__REGION_LIMIT; i += INT64_C(1))
    {
        (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * i + layout__REGION_WIDTH_PENETRATION)) = 0.0;
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * i + layout__REGION_WIDTH_PENETRATION)) = 0.0;
        (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * i + layout__REGION_SLANT)) = 0.0;
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * i + layout__REGION_SLANT)) = 0.0;
    }
    count = INT64_C(1);
    if ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PRESSED)) == 1.0)
    {
        n1 = tangent_pressed_regions__gather_overlaps_t(work, work_t, tables, state);
        count = n1;
    }
    else
    {
        tangent_regions__open_contact_region_t(work, work_t, tables, layout__WORK_CONTACT + layout__CONTACT_REGIONS);
        n2 = tangent_regions__find_regions_t(work, work_t, tables, side, state, penetration, penetration_t);
        count = n2;
        n3 = tangent_regions__bound_regions_t(work, work_t, tables, state, count, penetration, penetration_t);
        count = n3;
        tangent_planes__give_planes_t(work, work_t, tables, state, count);
    }
    tangent_estimate__start_penetrations_t(work, work_t, count, penetration, penetration_t);
    return count;
}

/* Tangent of ``solve_fine``. */
static inline int64_t tangent_analyn_contact__solve_fine_t(double* result_0_0001, double* result_1_0001, int64_t* result_2, array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, int64_t count, double force, double force_t, double penetration, double penetration_t, int64_t by_penetration)
{
    double start_t;
    double start;
    double enlarge;
    int64_t satisfied;
    int64_t repeat;
    double laid_t;
    double laid;
    start_t = penetration_t;
    start = penetration;
    enlarge = 1.0;
    satisfied = INT64_C(0);
    for (repeat = INT64_C(0); repeat < analyn_contact__COVER_REPEATS; repeat += INT64_C(1))
    {
        tangent_node_layout__prepare_regions_t(work, work_t, tables, state, count, enlarge, 0.0);
        tangent_analyn__penetrations_rule_t(&penetration, &penetration_t, &satisfied, work, work_t, tables, state, count, force, force_t, start, start_t, by_penetration);
        if (satisfied == INT64_C(0))
        {
            (*result_0_0001) = start;
            (*result_1_0001) = start_t;
            (*result_2) = satisfied;
            return 0;
        }
        if (node_layout__covered(work, count) == INT64_C(1))
        {
            break;
        }
        if (repeat < analyn_contact__COVER_REPEATS - INT64_C(1))
        {
            enlarge = enlarge * analyn_contact__ENLARGED;
            start_t = penetration_t;
            start = penetration;
            laid_t = penetration_t;
            laid = penetration;
            if ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PRESSED)) == 1.0)
            {
                laid_t = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_DEPTH));
                laid = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_DEPTH));
            }
            tangent_estimate__start_penetrations_t(work, work_t, count, laid, laid_t);
        }
    }
    (*result_0_0001) = penetration;
    (*result_1_0001) = penetration_t;
    (*result_2) = satisfied;
    return 0;
}
