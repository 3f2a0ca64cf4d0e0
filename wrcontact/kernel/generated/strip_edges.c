/* Generated from normal/strip_edges.py by tools/transpile_kernel.py; change that one.
 *
 * Edges of the patches that loaded strips form.
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
