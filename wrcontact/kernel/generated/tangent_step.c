/* Generated from tangent_step.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of step.py.
 */

#include "tangent_step.h"

/* Tangent of ``side_force``. */
static inline int64_t tangent_step__side_force_t(double* result_0, double* result_1, array_double_1d work, array_double_1d work_t, int64_t index)
{
    double sign;
    double v1;
    sign = (double)(INT64_C(2) * index - INT64_C(1));
    v1 = 1.0 + sign * (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_LOAD_TRANSFER));
    (*result_0) = (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_NORMAL_FORCE)) * v1;
    (*result_1) = (*cspan_at(&work_t, layout__WORK_INPUTS + layout__INPUTS_NORMAL_FORCE)) * v1 + (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_NORMAL_FORCE)) * (sign * (*cspan_at(&work_t, layout__WORK_INPUTS + layout__INPUTS_LOAD_TRANSFER)));
    return 0;
}

/* Tangent of ``stand_rigid``. */
static inline int64_t tangent_step__stand_rigid_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, array_double_1d state, double roll, double roll_t)
{
    int64_t index;
    double v2;
    double v2_t;
    int64_t n1;
    int64_t outcome;
    int64_t status;
    status = layout__VALID;
    (*cspan_at(&work_t, layout__WORK_OUTPUTS + layout__OUTPUTS_ROLL)) = roll_t;
    (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_ROLL)) = roll;
    (*cspan_at(&work_t, layout__WORK_OUTPUTS + layout__OUTPUTS_VERTICAL_SHIFT)) = (*cspan_at(&work_t, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_BEST));
    (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_VERTICAL_SHIFT)) = (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_BEST));
    for (index = INT64_C(0); index < INT64_C(2); index += INT64_C(1))
    {
        tangent_resultant__clear_resultant_t(work, work_t, layout__WORK_SUPPORTS + layout__SUPPORT_SIZE * index + layout__SUPPORT_RESULTANT);
    }
    for (index = INT64_C(0); index < INT64_C(2); index += INT64_C(1))
    {
        if (step__is_wanted(tables, index) == INT64_C(1))
        {
            tangent_step__side_force_t(&v2, &v2_t, work, work_t, index);
            n1 = tangent_side__step_side_t(tables, work, work_t, state, index, v2, v2_t);
            outcome = n1;
            if (outcome > status)
            {
                status = outcome;
            }
        }
    }
    return status;
}

/* Tangent of ``withhold``. */
static inline int64_t tangent_step__withhold_t(array_double_1d tables, array_double_1d work, array_double_1d work_t)
{
    int64_t index;
    int64_t first;
    bool partial;
    int64_t i;
    for (index = INT64_C(0); index < INT64_C(2); index += INT64_C(1))
    {
        first = side__first_unwanted(tables);
        if (step__is_wanted(tables, index) == INT64_C(0))
        {
            first = INT64_C(0);
        }
        if (first < layout__SIDE_SIZE)
        {
            tangent_side__clear_from_t(tables, work, work_t, layout__WORK_OUTPUTS + layout__OUTPUTS_LEFT + layout__SIDE_OUTPUTS_SIZE * index, first);
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
        }
    }
    return INT64_C(0);
}
