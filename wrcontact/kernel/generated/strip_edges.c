/* Generated from normal/strip_edges.py by tools/transpile_kernel.py; change that one.
 *
 * Edges of the patches that loaded strips form, and strips that are cut at them between two sweeps.
 *
 * Near the edge of a patch the line load falls to zero in proportion to the distance, so the edge is where the
 * straight line through the line loads of the last two strips ends.
 */

#include "strip_edges.h"

/* Last strip of the run of loaded strips that begins with strip ``first``. */
static inline int64_t strip_edges__run_end(array_double_1d work, int64_t count, int64_t first)
{
    int64_t last;
    last = first;
    while((last < count - INT64_C(1)) && ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (last + INT64_C(1)) + layout__STRIP_LINE_LOAD)) > 0.0) && ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * last + layout__STRIP_JOINED)) == 1.0))
    {
        last += INT64_C(1);
    }
    return last;
}

/* Station [m] of the edge beyond strip ``last`` of a run that reaches to ``first`` on the other side. */
static inline double strip_edges__run_edge(array_double_1d work, int64_t count, int64_t last, int64_t first, int64_t outward)
{
    double station;
    double limit;
    int64_t after;
    int64_t pair;
    int64_t inner;
    double fall;
    double reach;
    double edge;
    station = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * last + layout__STRIP_STATION));
    edge = station + 0.5 * (double)(outward) * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * last + layout__STRIP_WIDTH));
    if (last != first)
    {
        /* no farther than the middle of the next strip, which is not loaded */
        limit = edge;
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
                limit = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * after + layout__STRIP_STATION));
            }
        }
        inner = last - outward;
        fall = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * inner + layout__STRIP_LINE_LOAD)) - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * last + layout__STRIP_LINE_LOAD));
        edge = limit;
        if (fall > 0.0)
        {
            reach = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * last + layout__STRIP_LINE_LOAD)) / fall * (station - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * inner + layout__STRIP_STATION)));
            if (reach * (double)(outward) < (limit - station) * (double)(outward))
            {
                edge = station + reach;
            }
        }
    }
    return edge;
}

/* Let the outermost strips of every run of loaded strips end at the edges of the run. */
static inline int64_t strip_edges__fit_edges(array_double_1d work)
{
    int64_t count;
    int64_t first;
    int64_t last;
    double start;
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
                start = strip_edges__run_edge(work, count, first, last, -INT64_C(1));
                stop = strip_edges__run_edge(work, count, last, first, INT64_C(1));
                strip_edges__fit_edge(work, first, start, -INT64_C(1));
                strip_edges__fit_edge(work, last, stop, INT64_C(1));
            }
        }
        first = last + INT64_C(1);
    }
    return INT64_C(0);
}

/* Let the run that ends with strip ``last`` end at ``edge`` [m], which lies within one and a half of its
 * widths.
 *
 * A strip is never cut to less than half of its width, because a narrow one answers the smallest mismatch
 * with a large pressure: the strip before it takes over what remains, and the last one is unloaded.
 */
static inline int64_t strip_edges__fit_edge(array_double_1d work, int64_t last, double edge, int64_t outward)
{
    double direction;
    double width;
    double inner;
    double outer;
    int64_t beyond;
    int64_t pair;
    int64_t touching;
    double far;
    int64_t before;
    double near;
    direction = (double)(outward);
    width = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * last + layout__STRIP_WIDTH));
    inner = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * last + layout__STRIP_STATION)) - 0.5 * direction * width;
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
        strip_edges__move_strip(work, last, inner, edge);
        if (((edge - outer) * direction > 0.0) && (touching == INT64_C(1)))
        {
            far = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * beyond + layout__STRIP_STATION)) + 0.5 * direction * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * beyond + layout__STRIP_WIDTH));
            strip_edges__move_strip(work, beyond, edge, far);
        }
    }
    else
    {
        before = last - outward;
        near = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * before + layout__STRIP_STATION)) - 0.5 * direction * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * before + layout__STRIP_WIDTH));
        strip_edges__move_strip(work, before, near, edge);
        strip_edges__move_strip(work, last, edge, outer);
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * last + layout__STRIP_LOADED)) = (double)(0);
    }
    return INT64_C(0);
}

/* Let strip ``i`` lie between two stations [m], with the surfaces and distances there. */
static inline int64_t strip_edges__move_strip(array_double_1d work, int64_t i, double start, double stop)
{
    int64_t strip;
    int64_t region;
    int64_t k;
    double x;
    strip = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i;
    (*cspan_at(&work, strip + layout__STRIP_WIDTH)) = fabs(stop - start);
    (*cspan_at(&work, strip + layout__STRIP_STATION)) = 0.5 * (start + stop);
    region = layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * (int64_t)((*cspan_at(&work, strip + layout__STRIP_REGION)));
    strip_surfaces__node_cell(&k, &x, work, strip, region);
    strip_surfaces__read_surfaces(work, strip, region, layout__WORK_CONTACT + layout__CONTACT_NODES + layout__NODES_SIZE * (int64_t)((*cspan_at(&work, strip + layout__STRIP_REGION))), k, x);
    strip_influence__measure_distances(work, i, (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT))));
    return INT64_C(0);
}
