/* Generated from tangent_strip_edges.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of strip_edges.py.
 */

#include "tangent_strip_edges.h"

/* Tangent of ``run_edge``. */
static inline int64_t tangent_strip_edges__run_edge_t(double* edge, double* edge_t, array_double_1d work, array_double_1d work_t, int64_t count, int64_t last, int64_t first, int64_t outward)
{
    double station_t;
    double station;
    double v1;
    double limit_t;
    double limit;
    int64_t after;
    int64_t pair;
    int64_t inner;
    double fall_t;
    double fall;
    double v2;
    double v3;
    double reach_t;
    double reach;
    station_t = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * last + layout__STRIP_STATION));
    station = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * last + layout__STRIP_STATION));
    v1 = 0.5 * (double)(outward);
    (*edge_t) = station_t + v1 * (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * last + layout__STRIP_WIDTH));
    (*edge) = station + v1 * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * last + layout__STRIP_WIDTH));
    if (last != first)
    {
        limit_t = (*edge_t);
        limit = (*edge);
        after = last + outward;
        pair = last;
        if (outward < INT64_C(0))
        {
            pair = last - INT64_C(1);
        }
        if ((after >= INT64_C(0)) && (after < count))
        {
            if ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * pair + layout__STRIP_JOINED)) == 1.0)
            {
                limit_t = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * after + layout__STRIP_STATION));
                limit = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * after + layout__STRIP_STATION));
            }
        }
        inner = last - outward;
        fall_t = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * inner + layout__STRIP_LINE_LOAD)) - (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * last + layout__STRIP_LINE_LOAD));
        fall = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * inner + layout__STRIP_LINE_LOAD)) - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * last + layout__STRIP_LINE_LOAD));
        (*edge_t) = limit_t;
        (*edge) = limit;
        if (fall > 0.0)
        {
            v2 = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * last + layout__STRIP_LINE_LOAD)) / fall;
            v3 = station - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * inner + layout__STRIP_STATION));
            reach_t = ((*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * last + layout__STRIP_LINE_LOAD)) - v2 * fall_t) / fall * v3 + v2 * (station_t - (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * inner + layout__STRIP_STATION)));
            reach = v2 * v3;
            if (reach * (double)(outward) < (limit - station) * (double)(outward))
            {
                (*edge_t) = station_t + reach_t;
                (*edge) = station + reach;
            }
        }
    }
    return 0;
}
