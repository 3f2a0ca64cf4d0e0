/* Generated from tangent_trial.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of trial.py.
 */

#include "tangent_trial.h"

/* Tangent of ``permitted_approach``. */
static inline int64_t tangent_trial__permitted_approach_t(double* approach, double* approach_t, array_double_1d work, array_double_1d work_t, int64_t support, int64_t side, double height, double height_t)
{
    (*approach_t) = height_t - (*cspan_at(&work_t, side + layout__SIDE_SEARCH_BEST));
    (*approach) = height - (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST));
    if ((*approach) < trial__SHALLOWEST * (*cspan_at(&work, support + layout__SUPPORT_APPROACH)))
    {
        (*approach_t) = trial__SHALLOWEST * (*cspan_at(&work_t, support + layout__SUPPORT_APPROACH));
        (*approach) = trial__SHALLOWEST * (*cspan_at(&work, support + layout__SUPPORT_APPROACH));
    }
    if ((*approach) > trial__DEEPEST)
    {
        (*approach_t) = 0.0;
        (*approach) = trial__DEEPEST;
    }
    return 0;
}

/* Tangent of ``balance_side``. */
static inline int64_t tangent_trial__balance_side_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, array_double_1d state, int64_t index, double force, double force_t, double height, double height_t)
{
    int64_t support;
    int64_t side;
    double v1;
    double v1_t;
    int64_t n2;
    double v3;
    double v3_t;
    double approach_t;
    double approach;
    int64_t n4;
    int64_t status;
    int64_t count;
    double v5;
    double v6;
    double carried_t;
    double carried;
    double v7;
    double v7_t;
    support = layout__WORK_SUPPORTS + layout__SUPPORT_SIZE * index;
    side = layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * index;
    if (!(force > 0.0))
    {
        (*cspan_at(&work_t, support + layout__SUPPORT_HEIGHT)) = (*cspan_at(&work_t, side + layout__SIDE_SEARCH_BEST));
        (*cspan_at(&work, support + layout__SUPPORT_HEIGHT)) = (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST));
        tangent_side__side_lever_t(&v1, &v1_t, tables, work, work_t, index, INT64_C(0));
        (*cspan_at(&work_t, support + layout__SUPPORT_LEVER)) = v1_t;
        (*cspan_at(&work, support + layout__SUPPORT_LEVER)) = v1;
        n2 = tangent_side__touch_side_t(tables, work, work_t, state, index);
        return n2;
    }
    tangent_trial__permitted_approach_t(&v3, &v3_t, work, work_t, support, side, height, height_t);
    approach_t = v3_t;
    approach = v3;
    n4 = tangent_side__press_side_t(tables, work, work_t, state, index, approach, approach_t);
    status = n4;
    if (status == layout__VALID)
    {
        tangent_side__load_side_t(&count, &status, tables, work, work_t, state, index, force, force_t, (*cspan_at(&tables, layout__TABLES_ABSENT)), 0.0);
        v5 = (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_LEFT + layout__SIDE_OUTPUTS_SIZE * index + layout__SIDE_OUTPUTS_PENETRATION)) - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_DEPTH));
        v6 = v5 / (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS));
        carried_t = approach_t + ((*cspan_at(&work_t, layout__WORK_OUTPUTS + layout__OUTPUTS_LEFT + layout__SIDE_OUTPUTS_SIZE * index + layout__SIDE_OUTPUTS_PENETRATION)) - (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_DEPTH)) - v6 * (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS))) / (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS));
        carried = approach + v6;
        (*cspan_at(&work_t, support + layout__SUPPORT_HEIGHT)) = (*cspan_at(&work_t, side + layout__SIDE_SEARCH_BEST)) + carried_t;
        (*cspan_at(&work, support + layout__SUPPORT_HEIGHT)) = (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST)) + carried;
        tangent_side__side_lever_t(&v7, &v7_t, tables, work, work_t, index, count);
        (*cspan_at(&work_t, support + layout__SUPPORT_LEVER)) = v7_t;
        (*cspan_at(&work, support + layout__SUPPORT_LEVER)) = v7;
    }
    return status;
}
