/* Generated from wheelset/moving.py by tools/transpile_kernel.py; change that one.
 *
 * The motion of a wheelset whose contact is solved: its velocities, and the creepages of its patches.
 */

#include "moving.h"

/* 1 if the wheelset runs or its wheels turn, else 0: then there are no creepages. */
static inline int64_t moving__is_rolling(array_double_1d work)
{
    int64_t rolling;
    rolling = INT64_C(0);
    if (((*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_SPEED)) != 0.0) || ((*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_WHEEL_RATE)) != 0.0))
    {
        rolling = INT64_C(1);
    }
    return rolling;
}

/* The motion as the inputs give it, at the pose of the outputs. */
static inline int64_t moving__open_given_motion(array_double_1d left_tables, array_double_1d right_tables, array_double_1d work)
{
    wheelset_motion__open_motion(work, right_tables);
    wheelset_motion__open_rails(work, left_tables, right_tables);
    wheelset_motion__set_rates(work, (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_VERTICAL_VELOCITY)), (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_ROLL_RATE)));
    return INT64_C(0);
}

/* Creepages of all patches in the outputs; in compliant contact vertical velocity and roll rate are
 * given, otherwise they follow from contact with both rails.
 */
static inline int64_t moving__write_creepages(array_double_1d left_tables, array_double_1d right_tables, array_double_1d work, array_double_1d state)
{
    double vertical;
    double roll_rate;
    int64_t index;
    moving__open_given_motion(left_tables, right_tables, work);
    if ((int64_t)((*cspan_at(&right_tables, layout__TABLES_MODE))) != layout__MODE_COMPLIANT)
    {
        moving__constrain_side(left_tables, work, state, INT64_C(0));
        moving__constrain_side(right_tables, work, state, INT64_C(1));
        contact_rates__contact_rates(&vertical, &roll_rate, work);
        wheelset_motion__set_rates(work, vertical, roll_rate);
    }
    for (index = INT64_C(0); index < INT64_C(2); index += INT64_C(1))
    {
        creepage__write_side_creepages(work, layout__WORK_MOTION + layout__MOTION_RAILS + layout__RAIL_MOTION_SIZE * index, layout__WORK_OUTPUTS + layout__OUTPUTS_LEFT + layout__SIDE_OUTPUTS_SIZE * index, (double)(INT64_C(2) * index - INT64_C(1)));
    }
    return INT64_C(0);
}

/* What keeps the wheel of side ``index`` on its rail: the normal where it touches, or its force if it is
 * elastic and carries a load.
 */
static inline int64_t moving__constrain_side(array_double_1d tables, array_double_1d work, array_double_1d state, int64_t index)
{
    int64_t out;
    out = layout__WORK_OUTPUTS + layout__OUTPUTS_LEFT + layout__SIDE_OUTPUTS_SIZE * index;
    if (((int64_t)((*cspan_at(&tables, layout__TABLES_MODE))) == layout__MODE_ELASTIC) && ((*cspan_at(&work, out + layout__SIDE_OUTPUTS_FORCE + INT64_C(2))) != 0.0))
    {
        contact_rates__loaded_constraint(work, out, layout__WORK_MOTION + layout__MOTION_CONSTRAINTS + layout__CONSTRAINT_SIZE * index);
    }
    else
    {
        if (requested__is_requested(tables, index) == INT64_C(0))
        {
            side__touch_side(tables, work, state, index);
        }
        contact_rates__touching_constraint(work, out, (double)(INT64_C(2) * index - INT64_C(1)), layout__WORK_MOTION + layout__MOTION_CONSTRAINTS + layout__CONSTRAINT_SIZE * index);
    }
    return INT64_C(0);
}
