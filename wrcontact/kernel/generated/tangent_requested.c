/* Generated from tangent_requested.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of requested.py.
 */

#include "tangent_requested.h"

/* Tangent of ``side_force``. */
static inline int64_t tangent_requested__side_force_t(double* result_0, double* result_1, array_double_1d work, array_double_1d work_t, int64_t index)
{
    double sign;
    double v1;
    double v2;
    sign = (double)(INT64_C(2) * index - INT64_C(1));
    v1 = 1.0 + sign * (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_LOAD_TRANSFER));
    v2 = (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_NORMAL_FORCE)) * v1;
    (*result_0) = v2 * (*cspan_at(&work, layout__WORK_SUPPORTS + layout__SUPPORT_SIZE * index + layout__SUPPORT_FRICTION_LOAD));
    (*result_1) = ((*cspan_at(&work_t, layout__WORK_INPUTS + layout__INPUTS_NORMAL_FORCE)) * v1 + (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_NORMAL_FORCE)) * (sign * (*cspan_at(&work_t, layout__WORK_INPUTS + layout__INPUTS_LOAD_TRANSFER)))) * (*cspan_at(&work, layout__WORK_SUPPORTS + layout__SUPPORT_SIZE * index + layout__SUPPORT_FRICTION_LOAD)) + v2 * (*cspan_at(&work_t, layout__WORK_SUPPORTS + layout__SUPPORT_SIZE * index + layout__SUPPORT_FRICTION_LOAD));
    return 0;
}

/* Tangent of ``omit_outputs``. */
static inline int64_t tangent_requested__omit_outputs_t(array_double_1d tables, array_double_1d work, array_double_1d work_t)
{
    int64_t index;
    int64_t first;
    bool partial;
    int64_t i;
    for (index = INT64_C(0); index < INT64_C(2); index += INT64_C(1))
    {
        first = requested__first_omitted(tables);
        if (requested__is_requested(tables, index) == INT64_C(0))
        {
            first = INT64_C(0);
        }
        if (first < layout__SIDE_SIZE)
        {
            tangent_requested__omit_from_t(tables, work, work_t, index, first);
        }
    }
    partial = ((int64_t)((*cspan_at(&tables, layout__TABLES_SIDES))) != layout__SIDES_BOTH) || ((int64_t)((*cspan_at(&tables, layout__TABLES_DEPTH))) == layout__DEPTH_GEOMETRY);
    if (partial && ((int64_t)((*cspan_at(&tables, layout__TABLES_MODE))) == layout__MODE_RIGID))
    {
        for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
        {
            (*cspan_at(&work_t, layout__WORK_OUTPUTS + layout__OUTPUTS_FORCE + i)) = 0.0;
            (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_FORCE + i)) = (*cspan_at(&tables, layout__TABLES_ABSENT));
            (*cspan_at(&work_t, layout__WORK_OUTPUTS + layout__OUTPUTS_MOMENT + i)) = 0.0;
            (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_MOMENT + i)) = (*cspan_at(&tables, layout__TABLES_ABSENT));
            (*cspan_at(&work_t, layout__WORK_OUTPUTS + layout__OUTPUTS_NORMAL_PART + i)) = 0.0;
            (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_NORMAL_PART + i)) = (*cspan_at(&tables, layout__TABLES_ABSENT));
            (*cspan_at(&work_t, layout__WORK_OUTPUTS + layout__OUTPUTS_NORMAL_MOMENT + i)) = 0.0;
            (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_NORMAL_MOMENT + i)) = (*cspan_at(&tables, layout__TABLES_ABSENT));
        }
        (*cspan_at(&work_t, layout__WORK_OUTPUTS + layout__OUTPUTS_DRIVING_TORQUE)) = 0.0;
        (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_DRIVING_TORQUE)) = (*cspan_at(&tables, layout__TABLES_ABSENT));
    }
    return INT64_C(0);
}

/* Tangent of ``omit_from``. */
static inline int64_t tangent_requested__omit_from_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t index, int64_t first)
{
    int64_t out;
    int64_t i;
    out = layout__WORK_OUTPUTS + layout__OUTPUTS_LEFT + layout__SIDE_OUTPUTS_SIZE * index;
    for (i = first; i < layout__SIDE_SIZE; i += INT64_C(1))
    {
        (*cspan_at(&work_t, out + i)) = 0.0;
        (*cspan_at(&work, out + i)) = (*cspan_at(&tables, layout__TABLES_ABSENT));
    }
    tangent_outlines__fill_apart_t(tables, work, work_t, index, (*cspan_at(&tables, layout__TABLES_ABSENT)), 0.0);
    if (first <= layout__SIDE_PENETRATION)
    {
        (*cspan_at(&work_t, out + layout__SIDE_OUTPUTS_PATCH_COUNT)) = 0.0;
        (*cspan_at(&work, out + layout__SIDE_OUTPUTS_PATCH_COUNT)) = (*cspan_at(&tables, layout__TABLES_ABSENT));
    }
    return INT64_C(0);
}
