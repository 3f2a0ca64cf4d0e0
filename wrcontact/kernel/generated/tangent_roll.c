/* Generated from tangent_roll.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of roll.py.
 */

#include "tangent_roll.h"

/* Tangent of ``place_both``. */
static inline int64_t tangent_roll__place_both_t(array_double_1d work, array_double_1d work_t, array_double_1d left_tables, array_double_1d right_tables, double roll, double roll_t)
{
    tangent_locus__place_wheelset_t(work, work_t, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_PLACE, (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_LATERAL_SHIFT)), (*cspan_at(&work_t, layout__WORK_INPUTS + layout__INPUTS_LATERAL_SHIFT)), (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_YAW)), (*cspan_at(&work_t, layout__WORK_INPUTS + layout__INPUTS_YAW)), roll, roll_t, (*cspan_at(&right_tables, layout__TABLES_RADIUS)), 0.0, (*cspan_at(&right_tables, layout__TABLES_HEIGHT)), 0.0, (*cspan_at(&right_tables, layout__TABLES_ARM)), 0.0);
    tangent_locus__mirror_place_t(work, work_t, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_PLACE, layout__WORK_SIDES + layout__SIDE_SEARCH_PLACE, (*cspan_at(&left_tables, layout__TABLES_RADIUS)), 0.0);
    tangent_rails__move_rail_t(work, work_t, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_PLACE, (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_RIGHT_RAIL_LATERAL)), (*cspan_at(&work_t, layout__WORK_INPUTS + layout__INPUTS_RIGHT_RAIL_LATERAL)), (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_RIGHT_RAIL_VERTICAL)), (*cspan_at(&work_t, layout__WORK_INPUTS + layout__INPUTS_RIGHT_RAIL_VERTICAL)));
    tangent_rails__move_rail_t(work, work_t, layout__WORK_SIDES + layout__SIDE_SEARCH_PLACE, -(*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_LEFT_RAIL_LATERAL)), -(*cspan_at(&work_t, layout__WORK_INPUTS + layout__INPUTS_LEFT_RAIL_LATERAL)), (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_LEFT_RAIL_VERTICAL)), (*cspan_at(&work_t, layout__WORK_INPUTS + layout__INPUTS_LEFT_RAIL_VERTICAL)));
    if (((*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_LEFT_RAIL_ROLL)) != 0.0) || ((*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_RIGHT_RAIL_ROLL)) != 0.0))
    {
        tangent_roll__lean_both_t(work, work_t, left_tables, right_tables, roll, roll_t);
    }
    return INT64_C(0);
}

/* Tangent of ``lean_both``. */
static inline int64_t tangent_roll__lean_both_t(array_double_1d work, array_double_1d work_t, array_double_1d left_tables, array_double_1d right_tables, double roll, double roll_t)
{
    tangent_rails__lean_rail_t(work, work_t, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_PLACE, (*cspan_at(&right_tables, layout__TABLES_RAIL_Y)), 0.0, (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_RIGHT_RAIL_ROLL)), (*cspan_at(&work_t, layout__WORK_INPUTS + layout__INPUTS_RIGHT_RAIL_ROLL)));
    tangent_rails__lean_rail_t(work, work_t, layout__WORK_SIDES + layout__SIDE_SEARCH_PLACE, (*cspan_at(&left_tables, layout__TABLES_RAIL_Y)), 0.0, -(*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_LEFT_RAIL_ROLL)), -(*cspan_at(&work_t, layout__WORK_INPUTS + layout__INPUTS_LEFT_RAIL_ROLL)));
    tangent_roll__turn_both_t(work, work_t, roll, roll_t);
    return INT64_C(0);
}

/* Tangent of ``turn_both``. */
static inline int64_t tangent_roll__turn_both_t(array_double_1d work, array_double_1d work_t, double roll, double roll_t)
{
    if ((*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_PLACE + layout__PLACE_LEANING)) == 1.0)
    {
        tangent_roll__restore_yaw_t(work, work_t, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_PLACE);
        tangent_roll__restore_yaw_t(work, work_t, layout__WORK_SIDES + layout__SIDE_SEARCH_PLACE);
    }
    tangent_locus__turn_wheelset_t(work, work_t, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_PLACE, roll, roll_t);
    tangent_locus__mirror_roll_t(work, work_t, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_PLACE, layout__WORK_SIDES + layout__SIDE_SEARCH_PLACE);
    if ((*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_PLACE + layout__PLACE_LEANING)) == 1.0)
    {
        tangent_rails__turn_leaning_t(work, work_t, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_PLACE);
        tangent_rails__turn_leaning_t(work, work_t, layout__WORK_SIDES + layout__SIDE_SEARCH_PLACE);
    }
    return INT64_C(0);
}

/* Tangent of ``restore_yaw``. */
static inline int64_t tangent_roll__restore_yaw_t(array_double_1d work, array_double_1d work_t, int64_t place)
{
    (*cspan_at(&work_t, place + layout__PLACE_SIN_YAW)) = (*cspan_at(&work_t, place + layout__PLACE_TRACK_SIN_YAW));
    (*cspan_at(&work, place + layout__PLACE_SIN_YAW)) = (*cspan_at(&work, place + layout__PLACE_TRACK_SIN_YAW));
    (*cspan_at(&work_t, place + layout__PLACE_COS_YAW)) = (*cspan_at(&work_t, place + layout__PLACE_TRACK_COS_YAW));
    (*cspan_at(&work, place + layout__PLACE_COS_YAW)) = (*cspan_at(&work, place + layout__PLACE_TRACK_COS_YAW));
    return INT64_C(0);
}
