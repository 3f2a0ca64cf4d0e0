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
    int64_t n2;
    by_penetration = INT64_C(0);
    (*penetration_t) = prescribed_t;
    (*penetration) = prescribed;
    if (isfinite(prescribed))
    {
        by_penetration = INT64_C(1);
    }
    if ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PRESSED)) == 1.0)
    {
        tangent_analyn_contact__solve_estimated_t(penetration, penetration_t, count, satisfied, work, work_t, tables, state, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_DEPTH)), (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_DEPTH)), force, force_t, by_penetration);
        return 0;
    }
    if (by_penetration == INT64_C(0))
    {
        tangent_estimate__first_penetration_t(&v1, &v1_t, work, work_t, tables, state, force, force_t);
        (*penetration_t) = v1_t;
        (*penetration) = v1;
    }
    (*count) = INT64_C(0);
    (*satisfied) = INT64_C(0);
    for (repeat = INT64_C(0); repeat < analyn_contact__ESTIMATE_REPEATS; repeat += INT64_C(1))
    {
        estimate_t = (*penetration_t);
        estimate = (*penetration);
        n2 = tangent_pressed_regions__sink_wheel_t(work, work_t, tables, side, state, estimate, estimate_t);
        if (n2 == INT64_C(0))
        {
            (*count) = INT64_C(0);
            (*satisfied) = INT64_C(0);
            return 0;
        }
        tangent_analyn_contact__solve_estimated_t(penetration, penetration_t, count, satisfied, work, work_t, tables, state, estimate, estimate_t, force, force_t, by_penetration);
        if (((*penetration) < analyn_contact__ESTIMATE_FACTOR * estimate) && (analyn_contact__ESTIMATE_FACTOR * (*penetration) > estimate))
        {
            break;
        }
    }
    return 0;
}

/* Tangent of ``solve_estimated``. */
static inline int64_t tangent_analyn_contact__solve_estimated_t(double* penetration, double* penetration_t, int64_t* count, int64_t* satisfied, array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, double estimate, double estimate_t, double force, double force_t, int64_t by_penetration)
{
    int64_t n1;
    int64_t n2;
    n1 = tangent_analyn_contact__gather_regions_t(work, work_t, tables, state, estimate, estimate_t);
    (*count) = n1;
    tangent_analyn_contact__solve_fine_t(penetration, penetration_t, satisfied, work, work_t, tables, state, (*count), force, force_t, estimate, estimate_t, by_penetration);
    if (((*satisfied) == INT64_C(0)) && ((*count) > INT64_C(1)))
    {
        tangent_deep_points__keep_deepest_t(work, work_t);
        n2 = tangent_analyn_contact__gather_regions_t(work, work_t, tables, state, estimate, estimate_t);
        (*count) = n2;
        tangent_analyn_contact__solve_fine_t(penetration, penetration_t, satisfied, work, work_t, tables, state, (*count), force, force_t, estimate, estimate_t, by_penetration);
    }
    return 0;
}

/* Tangent of ``gather_regions``. */
static inline int64_t tangent_analyn_contact__gather_regions_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, double penetration, double penetration_t)
{
    int64_t i;
    int64_t n1;
    int64_t count;
    for (i = INT64_C(0); i < layout__REGION_LIMIT; i += INT64_C(1))
    {
        (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * i + layout__REGION_WIDTH_PENETRATION)) = 0.0;
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * i + layout__REGION_WIDTH_PENETRATION)) = 0.0;
        (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * i + layout__REGION_SLANT)) = 0.0;
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * i + layout__REGION_SLANT)) = 0.0;
    }
    n1 = tangent_pressed_regions__gather_overlaps_t(work, work_t, tables, state);
    count = n1;
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
            tangent_estimate__start_penetrations_t(work, work_t, count, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_DEPTH)), (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_DEPTH)));
        }
    }
    (*result_0_0001) = penetration;
    (*result_1_0001) = penetration_t;
    (*result_2) = satisfied;
    return 0;
}
