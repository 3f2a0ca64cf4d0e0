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
    tangent_locus__move_rail_t(work, work_t, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_PLACE, (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_RIGHT_RAIL_LATERAL)), (*cspan_at(&work_t, layout__WORK_INPUTS + layout__INPUTS_RIGHT_RAIL_LATERAL)), (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_RIGHT_RAIL_VERTICAL)), (*cspan_at(&work_t, layout__WORK_INPUTS + layout__INPUTS_RIGHT_RAIL_VERTICAL)));
    tangent_locus__move_rail_t(work, work_t, layout__WORK_SIDES + layout__SIDE_SEARCH_PLACE, -(*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_LEFT_RAIL_LATERAL)), -(*cspan_at(&work_t, layout__WORK_INPUTS + layout__INPUTS_LEFT_RAIL_LATERAL)), (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_LEFT_RAIL_VERTICAL)), (*cspan_at(&work_t, layout__WORK_INPUTS + layout__INPUTS_LEFT_RAIL_VERTICAL)));
    return INT64_C(0);
}

/* Tangent of ``turn_both``. */
static inline int64_t tangent_roll__turn_both_t(array_double_1d work, array_double_1d work_t, double roll, double roll_t)
{
    tangent_locus__turn_wheelset_t(work, work_t, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_PLACE, roll, roll_t);
    tangent_locus__mirror_roll_t(work, work_t, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_PLACE, layout__WORK_SIDES + layout__SIDE_SEARCH_PLACE);
    return INT64_C(0);
}
