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

/* Tangent of ``fit_edges``. */
static inline int64_t tangent_strip_edges__fit_edges_t(array_double_1d work, array_double_1d work_t)
{
    int64_t count;
    int64_t first;
    int64_t last;
    double v1;
    double v1_t;
    double start_t;
    double start;
    double v2;
    double v2_t;
    double stop_t;
    double stop;
    count = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT)));
    first = INT64_C(0);
    while(first < count)
    {
        last = first;
        if ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * first + layout__STRIP_LINE_LOAD)) > 0.0)
        {
            last = strip_edges__run_end(work, count, first);
            if (last > first + INT64_C(2))
            {
                tangent_strip_edges__run_edge_t(&v1, &v1_t, work, work_t, count, first, last, -INT64_C(1));
                start_t = v1_t;
                start = v1;
                tangent_strip_edges__run_edge_t(&v2, &v2_t, work, work_t, count, last, first, INT64_C(1));
                stop_t = v2_t;
                stop = v2;
                tangent_strip_edges__fit_edge_t(work, work_t, first, start, start_t, -INT64_C(1));
                tangent_strip_edges__fit_edge_t(work, work_t, last, stop, stop_t, INT64_C(1));
            }
        }
        first = last + INT64_C(1);
    }
    return INT64_C(0);
}

/* Tangent of ``fit_edge``. */
static inline int64_t tangent_strip_edges__fit_edge_t(array_double_1d work, array_double_1d work_t, int64_t last, double edge, double edge_t, int64_t outward)
{
    double direction;
    double width_t;
    double width;
    double v1;
    double inner_t;
    double inner;
    double outer_t;
    double outer;
    int64_t beyond;
    int64_t pair;
    int64_t touching;
    double v2;
    double far_t;
    double far;
    int64_t before;
    double v3;
    double near_t;
    double near;
    direction = (double)(outward);
    width_t = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * last + layout__STRIP_WIDTH));
    width = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * last + layout__STRIP_WIDTH));
    v1 = 0.5 * direction;
    inner_t = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * last + layout__STRIP_STATION)) - v1 * width_t;
    inner = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * last + layout__STRIP_STATION)) - v1 * width;
    outer_t = inner_t + direction * width_t;
    outer = inner + direction * width;
    beyond = last + outward;
    pair = last;
    if (outward < INT64_C(0))
    {
        pair = beyond;
    }
    touching = INT64_C(0);
    if ((pair >= INT64_C(0)) && (pair < (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT)))))
    {
        if ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * pair + layout__STRIP_JOINED)) == 1.0)
        {
            touching = INT64_C(1);
        }
    }
    if ((edge - inner) * direction > 0.5 * width)
    {
        tangent_strip_edges__move_strip_t(work, work_t, last, inner, inner_t, edge, edge_t);
        if (((edge - outer) * direction > 0.0) && (touching == INT64_C(1)))
        {
            v2 = 0.5 * direction;
            far_t = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * beyond + layout__STRIP_STATION)) + v2 * (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * beyond + layout__STRIP_WIDTH));
            far = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * beyond + layout__STRIP_STATION)) + v2 * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * beyond + layout__STRIP_WIDTH));
            tangent_strip_edges__move_strip_t(work, work_t, beyond, edge, edge_t, far, far_t);
        }
    }
    else
    {
        before = last - outward;
        v3 = 0.5 * direction;
        near_t = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * before + layout__STRIP_STATION)) - v3 * (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * before + layout__STRIP_WIDTH));
        near = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * before + layout__STRIP_STATION)) - v3 * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * before + layout__STRIP_WIDTH));
        tangent_strip_edges__move_strip_t(work, work_t, before, near, near_t, edge, edge_t);
        tangent_strip_edges__move_strip_t(work, work_t, last, edge, edge_t, outer, outer_t);
        (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * last + layout__STRIP_LOADED)) = 0.0;
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * last + layout__STRIP_LOADED)) = (double)(0);
    }
    return INT64_C(0);
}

/* Tangent of ``move_strip``. */
static inline int64_t tangent_strip_edges__move_strip_t(array_double_1d work, array_double_1d work_t, int64_t i, double start, double start_t, double stop, double stop_t)
{
    int64_t strip;
    double v1;
    double v2;
    int64_t region;
    int64_t k;
    double x;
    double x_t;
    strip = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i;
    v1 = stop - start;
    (*cspan_at(&work_t, strip + layout__STRIP_WIDTH)) = tangent_rates__size_rate(v1, stop_t - start_t);
    (*cspan_at(&work, strip + layout__STRIP_WIDTH)) = fabs(v1);
    v2 = start + stop;
    (*cspan_at(&work_t, strip + layout__STRIP_STATION)) = 0.5 * (start_t + stop_t);
    (*cspan_at(&work, strip + layout__STRIP_STATION)) = 0.5 * v2;
    region = layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * (int64_t)((*cspan_at(&work, strip + layout__STRIP_REGION)));
    tangent_strip_surfaces__node_cell_t(&k, &x, &x_t, work, work_t, strip, region);
    tangent_strip_surfaces__read_surfaces_t(work, work_t, strip, region, layout__WORK_CONTACT + layout__CONTACT_NODES + layout__NODES_SIZE * (int64_t)((*cspan_at(&work, strip + layout__STRIP_REGION))), k, x, x_t);
    tangent_strip_influence__measure_distances_t(work, work_t, i, (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT))));
    return INT64_C(0);
}
