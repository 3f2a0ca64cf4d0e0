/* Generated from tangent_elastic.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of elastic.py.
 */

#include "tangent_elastic.h"

/* Tangent of ``carry_side``. */
static inline int64_t tangent_elastic__carry_side_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, array_double_1d state, int64_t index, double force, double force_t, double height, double height_t)
{
    int64_t support;
    double best_t;
    double best;
    double v1;
    double v1_t;
    int64_t n2;
    double sink_t;
    double sink;
    int64_t n3;
    int64_t status;
    int64_t count;
    double v4;
    double v5;
    double carried_t;
    double carried;
    double v6;
    double v6_t;
    support = layout__WORK_SUPPORTS + layout__SUPPORT_SIZE * index;
    best_t = (*cspan_at(&work_t, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * index + layout__SIDE_SEARCH_BEST));
    best = (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * index + layout__SIDE_SEARCH_BEST));
    if (!(force > 0.0))
    {
        (*cspan_at(&work_t, support + layout__SUPPORT_HEIGHT)) = best_t;
        (*cspan_at(&work, support + layout__SUPPORT_HEIGHT)) = best;
        tangent_side__side_lever_t(&v1, &v1_t, tables, work, work_t, index, INT64_C(0));
        (*cspan_at(&work_t, support + layout__SUPPORT_LEVER)) = v1_t;
        (*cspan_at(&work, support + layout__SUPPORT_LEVER)) = v1;
        n2 = tangent_side__rest_side_t(tables, work, work_t, state, index);
        return n2;
    }
    sink_t = height_t - best_t;
    sink = height - best;
    if (sink < elastic__SHALLOWEST * (*cspan_at(&work, support + layout__SUPPORT_FIRST)))
    {
        sink_t = elastic__SHALLOWEST * (*cspan_at(&work_t, support + layout__SUPPORT_FIRST));
        sink = elastic__SHALLOWEST * (*cspan_at(&work, support + layout__SUPPORT_FIRST));
    }
    if (sink > elastic__DEEPEST)
    {
        sink_t = 0.0;
        sink = elastic__DEEPEST;
    }
    n3 = tangent_side__press_side_t(tables, work, work_t, state, index, sink, sink_t);
    status = n3;
    if (status == layout__VALID)
    {
        tangent_side__load_side_t(&count, &status, tables, work, work_t, state, index, force, force_t, (*cspan_at(&tables, layout__TABLES_ABSENT)), 0.0);
        v4 = (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_LEFT + layout__SIDE_OUTPUTS_SIZE * index + layout__SIDE_OUTPUTS_PENETRATION)) - (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_DEPTH));
        v5 = v4 / (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_COS));
        carried_t = sink_t + ((*cspan_at(&work_t, layout__WORK_OUTPUTS + layout__OUTPUTS_LEFT + layout__SIDE_OUTPUTS_SIZE * index + layout__SIDE_OUTPUTS_PENETRATION)) - (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_DEPTH)) - v5 * (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_COS))) / (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_COS));
        carried = sink + v5;
        (*cspan_at(&work_t, support + layout__SUPPORT_HEIGHT)) = best_t + carried_t;
        (*cspan_at(&work, support + layout__SUPPORT_HEIGHT)) = best + carried;
        tangent_side__side_lever_t(&v6, &v6_t, tables, work, work_t, index, count);
        (*cspan_at(&work_t, support + layout__SUPPORT_LEVER)) = v6_t;
        (*cspan_at(&work, support + layout__SUPPORT_LEVER)) = v6;
    }
    return status;
}

/* Tangent of ``bear_side``. */
static inline int64_t tangent_elastic__bear_side_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, array_double_1d state, int64_t index, double height, double height_t)
{
    double sink_t;
    double sink;
    int64_t n1;
    int64_t n2;
    int64_t status;
    int64_t count;
    sink_t = height_t - (*cspan_at(&work_t, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * index + layout__SIDE_SEARCH_BEST));
    sink = height - (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * index + layout__SIDE_SEARCH_BEST));
    if (!(sink > elastic__GRAZING))
    {
        n1 = tangent_side__rest_side_t(tables, work, work_t, state, index);
        return n1;
    }
    if (sink > elastic__DEEPEST)
    {
        return layout__OFF_PROFILE;
    }
    n2 = tangent_side__press_side_t(tables, work, work_t, state, index, sink, sink_t);
    status = n2;
    if (status == layout__VALID)
    {
        tangent_side__load_side_t(&count, &status, tables, work, work_t, state, index, 0.0, 0.0, (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_DEPTH)), (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_DEPTH)));
    }
    return status;
}
