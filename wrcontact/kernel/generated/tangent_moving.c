/* Generated from tangent_moving.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of moving.py.
 */

#include "tangent_moving.h"

/* Tangent of ``open_given_motion``. */
static inline int64_t tangent_moving__open_given_motion_t(array_double_1d left_tables, array_double_1d right_tables, array_double_1d work, array_double_1d work_t)
{
    tangent_wheelset_motion__open_motion_t(work, work_t, right_tables);
    tangent_wheelset_motion__open_rails_t(work, work_t, left_tables, right_tables);
    tangent_wheelset_motion__set_rates_t(work, work_t, (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_VERTICAL_VELOCITY)), (*cspan_at(&work_t, layout__WORK_INPUTS + layout__INPUTS_VERTICAL_VELOCITY)), (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_ROLL_RATE)), (*cspan_at(&work_t, layout__WORK_INPUTS + layout__INPUTS_ROLL_RATE)));
    return INT64_C(0);
}

/* Tangent of ``write_creepages``. */
static inline int64_t tangent_moving__write_creepages_t(array_double_1d left_tables, array_double_1d right_tables, array_double_1d work, array_double_1d work_t, array_double_1d state)
{
    double vertical;
    double vertical_t;
    double roll_rate;
    double roll_rate_t;
    int64_t index;
    tangent_moving__open_given_motion_t(left_tables, right_tables, work, work_t);
    if ((int64_t)((*cspan_at(&right_tables, layout__TABLES_MODE))) != layout__MODE_COMPLIANT)
    {
        tangent_moving__constrain_side_t(left_tables, work, work_t, state, INT64_C(0));
        tangent_moving__constrain_side_t(right_tables, work, work_t, state, INT64_C(1));
        tangent_contact_rates__contact_rates_t(&vertical, &vertical_t, &roll_rate, &roll_rate_t, work, work_t);
        tangent_wheelset_motion__set_rates_t(work, work_t, vertical, vertical_t, roll_rate, roll_rate_t);
    }
    for (index = INT64_C(0); index < INT64_C(2); index += INT64_C(1))
    {
        tangent_creepage__write_side_creepages_t(work, work_t, layout__WORK_MOTION + layout__MOTION_RAILS + layout__RAIL_MOTION_SIZE * index, layout__WORK_OUTPUTS + layout__OUTPUTS_LEFT + layout__SIDE_OUTPUTS_SIZE * index, (double)(INT64_C(2) * index - INT64_C(1)), 0.0);
    }
    return INT64_C(0);
}

/* Tangent of ``constrain_side``. */
static inline int64_t tangent_moving__constrain_side_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, array_double_1d state, int64_t index)
{
    int64_t out;
    out = layout__WORK_OUTPUTS + layout__OUTPUTS_LEFT + layout__SIDE_OUTPUTS_SIZE * index;
    if (((int64_t)((*cspan_at(&tables, layout__TABLES_MODE))) == layout__MODE_ELASTIC) && ((*cspan_at(&work, out + layout__SIDE_OUTPUTS_FORCE + INT64_C(2))) != 0.0))
    {
        tangent_contact_rates__loaded_constraint_t(work, work_t, out, layout__WORK_MOTION + layout__MOTION_CONSTRAINTS + layout__CONSTRAINT_SIZE * index);
    }
    else
    {
        if (requested__is_requested(tables, index) == INT64_C(0))
        {
            tangent_side__touch_side_t(tables, work, work_t, state, index);
        }
        tangent_contact_rates__touching_constraint_t(work, work_t, out, (double)(INT64_C(2) * index - INT64_C(1)), 0.0, layout__WORK_MOTION + layout__MOTION_CONSTRAINTS + layout__CONSTRAINT_SIZE * index);
    }
    return INT64_C(0);
}
