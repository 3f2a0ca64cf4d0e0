/* Generated from wheelset/requested.py by tools/transpile_kernel.py; change that one.
 *
 * What is asked of a step: whether its inputs can be evaluated, each side's force, and which
 * outputs are requested.
 */

#include "requested.h"

/* VALID, INVALID_INPUT if an input has no meaning, or OFF_PROFILE if the pose is outside the
 * range of the profiles.
 */
static inline int64_t requested__check_inputs(array_double_1d work, array_double_1d tables)
{
    int64_t i;
    int64_t status;
    status = layout__VALID;
    if ((fabs((*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_LATERAL_SHIFT))) > (*cspan_at(&tables, layout__TABLES_LATERAL_LIMIT))) || (fabs((*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_YAW))) > (*cspan_at(&tables, layout__TABLES_YAW_LIMIT))))
    {
        status = layout__OFF_PROFILE;
    }
    if (((int64_t)((*cspan_at(&tables, layout__TABLES_MODE))) == layout__MODE_COMPLIANT) && (fabs((*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_ROLL))) > layout__ROLL_LIMIT))
    {
        status = layout__OFF_PROFILE;
    }
    if (requested__is_rail_far(work) == INT64_C(1))
    {
        status = layout__OFF_PROFILE;
    }
    if (((*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_NORMAL_FORCE)) < 0.0) || (fabs((*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_LOAD_TRANSFER))) > 1.0))
    {
        status = layout__INVALID_INPUT;
    }
    if (wheelset_motion__is_moderate(work) == INT64_C(0))
    {
        status = layout__INVALID_INPUT;
    }
    if (friction__is_frictional((*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_LEFT_FRICTION)), layout__FRICTION_LIMIT) == INT64_C(0))
    {
        status = layout__INVALID_INPUT;
    }
    if (friction__is_frictional((*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_RIGHT_FRICTION)), layout__FRICTION_LIMIT) == INT64_C(0))
    {
        status = layout__INVALID_INPUT;
    }
    for (i = INT64_C(0); i < layout__INPUT_COUNT; i += INT64_C(1))
    {
        if (!isfinite((*cspan_at(&work, layout__WORK_INPUTS + i))))
        {
            status = layout__INVALID_INPUT;
        }
    }
    return status;
}

/* 1 if a rail is displaced further than RAIL_LIMIT, or rolled further than RAIL_ROLL_LIMIT, else 0. */
static inline int64_t requested__is_rail_far(array_double_1d work)
{
    int64_t far;
    far = INT64_C(0);
    if ((fabs((*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_LEFT_RAIL_LATERAL))) > layout__RAIL_LIMIT) || (fabs((*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_RIGHT_RAIL_LATERAL))) > layout__RAIL_LIMIT))
    {
        far = INT64_C(1);
    }
    if ((fabs((*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_LEFT_RAIL_ROLL))) > layout__RAIL_ROLL_LIMIT) || (fabs((*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_RIGHT_RAIL_ROLL))) > layout__RAIL_ROLL_LIMIT))
    {
        far = INT64_C(1);
    }
    if ((fabs((*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_LEFT_RAIL_VERTICAL))) > layout__RAIL_LIMIT) || (fabs((*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_RIGHT_RAIL_VERTICAL))) > layout__RAIL_LIMIT))
    {
        far = INT64_C(1);
    }
    return far;
}

/* The prescribed force of side ``index`` [N], with load transfer; where friction carries some of it, what
 * is left to the normal forces (friction_load.py).
 */
static inline double requested__side_force(array_double_1d work, int64_t index)
{
    double sign;
    double result;
    sign = (double)(INT64_C(2) * index - INT64_C(1));
    result = (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_NORMAL_FORCE)) * (1.0 + sign * (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_LOAD_TRANSFER))) * (*cspan_at(&work, layout__WORK_SUPPORTS + layout__SUPPORT_SIZE * index + layout__SUPPORT_FRICTION_LOAD));
    return result;
}

/* 1 if the outputs of side ``index`` are requested, else 0. */
static inline int64_t requested__is_requested(array_double_1d tables, int64_t index)
{
    int64_t requested;
    requested = INT64_C(0);
    if (((int64_t)((*cspan_at(&tables, layout__TABLES_SIDES))) == layout__SIDES_BOTH) || ((int64_t)((*cspan_at(&tables, layout__TABLES_SIDES))) == layout__SIDES_LEFT + index))
    {
        requested = INT64_C(1);
    }
    return requested;
}

/* The first of a side's outputs that is not requested; SIDE_SIZE if all are. */
static inline int64_t requested__first_omitted(array_double_1d tables)
{
    int64_t first;
    first = layout__SIDE_SIZE;
    if ((int64_t)((*cspan_at(&tables, layout__TABLES_DEPTH))) == layout__DEPTH_PATCHES)
    {
        first = layout__SIDE_STATION;
    }
    if ((int64_t)((*cspan_at(&tables, layout__TABLES_DEPTH))) == layout__DEPTH_GEOMETRY)
    {
        first = layout__SIDE_PENETRATION;
    }
    return first;
}

/* Take back the outputs that are not requested; the resultant needs both sides and their loads. */
static inline int64_t requested__omit_outputs(array_double_1d tables, array_double_1d work)
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
            requested__omit_from(tables, work, index, first);
        }
    }
    partial = ((int64_t)((*cspan_at(&tables, layout__TABLES_SIDES))) != layout__SIDES_BOTH) || ((int64_t)((*cspan_at(&tables, layout__TABLES_DEPTH))) == layout__DEPTH_GEOMETRY);
    if (partial && ((int64_t)((*cspan_at(&tables, layout__TABLES_MODE))) == layout__MODE_RIGID))
    {
        for (i = INT64_C(0); i < INT64_C(3); i += INT64_C(1))
        {
            (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_FORCE + i)) = (*cspan_at(&tables, layout__TABLES_ABSENT));
            (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_MOMENT + i)) = (*cspan_at(&tables, layout__TABLES_ABSENT));
            (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_NORMAL_PART + i)) = (*cspan_at(&tables, layout__TABLES_ABSENT));
            (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_NORMAL_MOMENT + i)) = (*cspan_at(&tables, layout__TABLES_ABSENT));
        }
        (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_DRIVING_TORQUE)) = (*cspan_at(&tables, layout__TABLES_ABSENT));
    }
    return INT64_C(0);
}

/* Write what stands for outputs that are not requested, from a side's output ``first`` on. */
static inline int64_t requested__omit_from(array_double_1d tables, array_double_1d work, int64_t index, int64_t first)
{
    int64_t out;
    int64_t i;
    out = layout__WORK_OUTPUTS + layout__OUTPUTS_LEFT + layout__SIDE_OUTPUTS_SIZE * index;
    for (i = first; i < layout__SIDE_SIZE; i += INT64_C(1))
    {
        (*cspan_at(&work, out + i)) = (*cspan_at(&tables, layout__TABLES_ABSENT));
    }
    outlines__fill_apart(tables, work, index, (*cspan_at(&tables, layout__TABLES_ABSENT)));
    if (first <= layout__SIDE_PENETRATION)
    {
        (*cspan_at(&work, out + layout__SIDE_OUTPUTS_PATCH_COUNT)) = (*cspan_at(&tables, layout__TABLES_ABSENT));
    }
    return INT64_C(0);
}
