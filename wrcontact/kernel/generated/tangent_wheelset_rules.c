/* Generated from tangent_wheelset_rules.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of wheelset_rules.py.
 */

#include "tangent_wheelset_rules.h"

/* Tangent of ``place_moving``. */
static inline int64_t tangent_wheelset_rules__place_moving_t(array_double_1d left_tables, array_double_1d right_tables, array_double_1d work, array_double_1d work_t, double roll, double roll_t)
{
    double turning;
    tangent_roll__place_both_t(work, work_t, left_tables, right_tables, roll, roll_t);
    if ((*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_PLACE + layout__PLACE_LEANING)) == 1.0)
    {
        tangent_wheelset_rules__begin_yaw_t(work, work_t, roll, roll_t);
    }
    else
    {
        turning = fabs((*cspan_at(&work_t, layout__WORK_INPUTS + layout__INPUTS_LEFT_RAIL_ROLL))) + fabs((*cspan_at(&work_t, layout__WORK_INPUTS + layout__INPUTS_RIGHT_RAIL_ROLL)));
        tangent_wheelset_rules__begin_yaw_t(work, work_t, roll, roll_t);
        if (turning != 0.0)
        {
            tangent_roll__lean_both_t(work, work_t, left_tables, right_tables, roll, roll_t);
        }
    }
    return INT64_C(0);
}

/* Tangent of ``begin_yaw``. */
static inline int64_t tangent_wheelset_rules__begin_yaw_t(array_double_1d work, array_double_1d work_t, double roll, double roll_t)
{
    double yaw_t;
    double yaw;
    int64_t index;
    int64_t place;
    yaw_t = (*cspan_at(&work_t, layout__WORK_INPUTS + layout__INPUTS_YAW));
    yaw = (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_YAW));
    if ((yaw == 0.0) && (yaw_t != 0.0))
    {
        (*cspan_at(&work_t, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_PLACE + layout__PLACE_SIN_YAW)) = cos(yaw) * yaw_t;
        (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_PLACE + layout__PLACE_SIN_YAW)) = sin(yaw);
        (*cspan_at(&work_t, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_PLACE + layout__PLACE_COS_YAW)) = (-sin(yaw)) * yaw_t;
        (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_PLACE + layout__PLACE_COS_YAW)) = cos(yaw);
        (*cspan_at(&work_t, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_PLACE + layout__PLACE_YAWED)) = 0.0;
        (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_PLACE + layout__PLACE_YAWED)) = (double)(1);
        (*cspan_at(&work_t, layout__WORK_SIDES + layout__SIDE_SEARCH_PLACE + layout__PLACE_SIN_YAW)) = -(cos(yaw) * yaw_t);
        (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_PLACE + layout__PLACE_SIN_YAW)) = -sin(yaw);
        (*cspan_at(&work_t, layout__WORK_SIDES + layout__SIDE_SEARCH_PLACE + layout__PLACE_COS_YAW)) = (-sin(yaw)) * yaw_t;
        (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_PLACE + layout__PLACE_COS_YAW)) = cos(yaw);
        (*cspan_at(&work_t, layout__WORK_SIDES + layout__SIDE_SEARCH_PLACE + layout__PLACE_YAWED)) = 0.0;
        (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_PLACE + layout__PLACE_YAWED)) = (double)(1);
        for (index = INT64_C(0); index < INT64_C(2); index += INT64_C(1))
        {
            place = layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * index + layout__SIDE_SEARCH_PLACE;
            if ((*cspan_at(&work, place + layout__PLACE_LEANING)) == 1.0)
            {
                (*cspan_at(&work_t, place + layout__PLACE_TRACK_SIN_YAW)) = (*cspan_at(&work_t, place + layout__PLACE_SIN_YAW));
                (*cspan_at(&work, place + layout__PLACE_TRACK_SIN_YAW)) = (*cspan_at(&work, place + layout__PLACE_SIN_YAW));
                (*cspan_at(&work_t, place + layout__PLACE_TRACK_COS_YAW)) = (*cspan_at(&work_t, place + layout__PLACE_COS_YAW));
                (*cspan_at(&work, place + layout__PLACE_TRACK_COS_YAW)) = (*cspan_at(&work, place + layout__PLACE_COS_YAW));
            }
        }
        tangent_roll__turn_both_t(work, work_t, roll, roll_t);
    }
    return INT64_C(0);
}

/* Tangent of ``follow_minimum``. */
static inline int64_t tangent_wheelset_rules__follow_minimum_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t index)
{
    int64_t side;
    int64_t at;
    double y_t;
    double y;
    double gap;
    double gap_t;
    double mismatch;
    double mismatch_t;
    double rate;
    double rate_t;
    double v1;
    side = layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * index;
    at = layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * index + layout__SIDE_SEARCH_PLACE;
    y_t = 0.0;
    y = (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST_Y));
    tangent_gap__vertical_gap_t(&gap, &gap_t, &mismatch, &mismatch_t, &rate, &rate_t, work, work_t, tables, at, y, y_t);
    v1 = -mismatch;
    y_t = (-mismatch_t) / rate;
    tangent_gap__vertical_gap_t(&gap, &gap_t, &mismatch, &mismatch_t, &rate, &rate_t, work, work_t, tables, at, y, y_t);
    (*cspan_at(&work_t, side + layout__SIDE_SEARCH_BEST_Y)) = y_t;
    (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST_Y)) = y;
    (*cspan_at(&work_t, side + layout__SIDE_SEARCH_BEST)) = gap_t;
    return INT64_C(0);
}

/* Tangent of ``follow_roll``. */
static inline int64_t tangent_wheelset_rules__follow_roll_t(double* roll, double* result_1, array_double_1d left_tables, array_double_1d right_tables, array_double_1d work, array_double_1d work_t)
{
    double left;
    double right;
    double gap_left;
    double gap_left_t;
    double mismatch_left;
    double mismatch_left_t;
    double rate_left;
    double rate_left_t;
    double gap_right;
    double gap_right_t;
    double mismatch_right;
    double mismatch_right_t;
    double rate_right;
    double rate_right_t;
    double v1;
    double v1_t;
    double v2;
    double v2_t;
    double lever_t;
    double lever;
    double v3;
    (*roll) = (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_ROLL));
    tangent_wheelset_rules__place_moving_t(left_tables, right_tables, work, work_t, (*roll), 0.0);
    left = (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_BEST_Y));
    right = (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_BEST_Y));
    tangent_gap__vertical_gap_t(&gap_left, &gap_left_t, &mismatch_left, &mismatch_left_t, &rate_left, &rate_left_t, work, work_t, left_tables, layout__WORK_SIDES + layout__SIDE_SEARCH_PLACE, left, 0.0);
    tangent_gap__vertical_gap_t(&gap_right, &gap_right_t, &mismatch_right, &mismatch_right_t, &rate_right, &rate_right_t, work, work_t, right_tables, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_PLACE, right, 0.0);
    tangent_gap__gap_per_roll_t(&v1, &v1_t, work, work_t, right_tables, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_PLACE, right, 0.0);
    tangent_gap__gap_per_roll_t(&v2, &v2_t, work, work_t, left_tables, layout__WORK_SIDES + layout__SIDE_SEARCH_PLACE, left, 0.0);
    lever_t = v1_t + v2_t;
    lever = v1 + v2;
    v3 = -(gap_right - gap_left);
    (*result_1) = (-(gap_right_t - gap_left_t)) / lever;
    return 0;
}

/* Tangent of ``follow_gaps``. */
static inline int64_t tangent_wheelset_rules__follow_gaps_t(double* result_0, double* result_1, double* result_2, double* result_3, array_double_1d left_tables, array_double_1d right_tables, array_double_1d work, array_double_1d work_t, double roll, double roll_t, double height, double height_t)
{
    double left;
    double left_t;
    double mismatch;
    double mismatch_t;
    double rate;
    double rate_t;
    double right;
    double right_t;
    tangent_leaning__set_reference_t(work, work_t, height, height_t);
    tangent_wheelset_rules__place_moving_t(left_tables, right_tables, work, work_t, roll, roll_t);
    tangent_gap__vertical_gap_t(&left, &left_t, &mismatch, &mismatch_t, &rate, &rate_t, work, work_t, left_tables, layout__WORK_SIDES + layout__SIDE_SEARCH_PLACE, (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_BEST_Y)), 0.0);
    tangent_gap__vertical_gap_t(&right, &right_t, &mismatch, &mismatch_t, &rate, &rate_t, work, work_t, right_tables, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_PLACE, (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_BEST_Y)), 0.0);
    (*result_0) = left - height;
    (*result_1) = left_t - height_t;
    (*result_2) = right - height;
    (*result_3) = right_t - height_t;
    return 0;
}

/* Tangent of ``follow_leaning_roll``. */
static inline int64_t tangent_wheelset_rules__follow_leaning_roll_t(double* roll, double* roll_rate, array_double_1d left_tables, array_double_1d right_tables, array_double_1d work, array_double_1d work_t)
{
    double height;
    double left;
    double left_t;
    double right;
    double right_t;
    double residual_left;
    double residual_right;
    double left_height;
    double right_height;
    double left_roll;
    double right_roll;
    double determinant;
    double height_rate;
    (*roll) = (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_ROLL));
    height = (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_VERTICAL_SHIFT));
    tangent_wheelset_rules__follow_gaps_t(&left, &left_t, &right, &right_t, left_tables, right_tables, work, work_t, (*roll), 0.0, height, 0.0);
    residual_left = left_t;
    residual_right = right_t;
    tangent_wheelset_rules__follow_gaps_t(&left, &left_t, &right, &right_t, left_tables, right_tables, work, work_t, (*roll), 0.0, height, 1.0);
    left_height = left_t - residual_left;
    right_height = right_t - residual_right;
    tangent_wheelset_rules__follow_gaps_t(&left, &left_t, &right, &right_t, left_tables, right_tables, work, work_t, (*roll), 1.0, height, 0.0);
    left_roll = left_t - residual_left;
    right_roll = right_t - residual_right;
    determinant = left_height * right_roll - right_height * left_roll;
    height_rate = (residual_right * left_roll - residual_left * right_roll) / determinant;
    (*roll_rate) = (residual_left * right_height - residual_right * left_height) / determinant;
    tangent_leaning__set_reference_t(work, work_t, height, height_rate);
    return 0;
}

/* Tangent of ``follow_position``. */
static inline int64_t tangent_wheelset_rules__follow_position_t(array_double_1d left_tables, array_double_1d right_tables, array_double_1d work, array_double_1d work_t, array_double_1d state, double roll, double roll_t, double height, double height_t)
{
    double v1;
    double v1_t;
    double v2;
    double v2_t;
    tangent_leaning__set_reference_t(work, work_t, height, height_t);
    tangent_wheelset_rules__place_moving_t(left_tables, right_tables, work, work_t, roll, roll_t);
    tangent_wheelset_rules__follow_minimum_t(left_tables, work, work_t, INT64_C(0));
    tangent_requested__side_force_t(&v1, &v1_t, work, work_t, INT64_C(0));
    tangent_trial__balance_side_t(left_tables, work, work_t, state, INT64_C(0), v1, v1_t, height, height_t);
    tangent_wheelset_rules__follow_minimum_t(right_tables, work, work_t, INT64_C(1));
    tangent_requested__side_force_t(&v2, &v2_t, work, work_t, INT64_C(1));
    tangent_trial__balance_side_t(right_tables, work, work_t, state, INT64_C(1), v2, v2_t, height, height_t);
    return INT64_C(0);
}

/* Tangent of ``follow_elastic``. */
static inline int64_t tangent_wheelset_rules__follow_elastic_t(array_double_1d left_tables, array_double_1d right_tables, array_double_1d work, array_double_1d work_t, array_double_1d state)
{
    double roll_t;
    double roll;
    double height_t;
    double height;
    int64_t right;
    double residual_left;
    double residual_right;
    double left_height;
    double right_height;
    double left_roll;
    double right_roll;
    double determinant;
    double height_rate;
    double roll_rate;
    roll_t = (*cspan_at(&work_t, layout__WORK_OUTPUTS + layout__OUTPUTS_ROLL));
    roll = (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_ROLL));
    height_t = (*cspan_at(&work_t, layout__WORK_OUTPUTS + layout__OUTPUTS_VERTICAL_SHIFT));
    height = (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_VERTICAL_SHIFT));
    right = layout__WORK_SUPPORTS + layout__SUPPORT_SIZE * INT64_C(1);
    tangent_wheelset_rules__follow_position_t(left_tables, right_tables, work, work_t, state, roll, 0.0, height, 0.0);
    if (fabs((*cspan_at(&work, layout__WORK_SUPPORTS + layout__SUPPORT_HEIGHT)) - height) + fabs((*cspan_at(&work, right + layout__SUPPORT_HEIGHT)) - height) > elastic__UNBALANCED)
    {
        return INT64_C(1);
    }
    residual_left = (*cspan_at(&work_t, layout__WORK_SUPPORTS + layout__SUPPORT_HEIGHT));
    residual_right = (*cspan_at(&work_t, right + layout__SUPPORT_HEIGHT));
    tangent_wheelset_rules__follow_position_t(left_tables, right_tables, work, work_t, state, roll, 0.0, height, 1.0);
    left_height = (*cspan_at(&work_t, layout__WORK_SUPPORTS + layout__SUPPORT_HEIGHT)) - residual_left - 1.0;
    right_height = (*cspan_at(&work_t, right + layout__SUPPORT_HEIGHT)) - residual_right - 1.0;
    tangent_wheelset_rules__follow_position_t(left_tables, right_tables, work, work_t, state, roll, 1.0, height, 0.0);
    left_roll = (*cspan_at(&work_t, layout__WORK_SUPPORTS + layout__SUPPORT_HEIGHT)) - residual_left;
    right_roll = (*cspan_at(&work_t, right + layout__SUPPORT_HEIGHT)) - residual_right;
    determinant = left_height * right_roll - right_height * left_roll;
    if (determinant == 0.0)
    {
        return INT64_C(1);
    }
    height_rate = (residual_right * left_roll - residual_left * right_roll) / determinant;
    roll_rate = (residual_left * right_height - residual_right * left_height) / determinant;
    tangent_wheelset_rules__follow_position_t(left_tables, right_tables, work, work_t, state, roll, roll_rate, height, height_rate);
    (*cspan_at(&work_t, layout__WORK_OUTPUTS + layout__OUTPUTS_ROLL)) = roll_rate;
    (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_ROLL)) = roll;
    (*cspan_at(&work_t, layout__WORK_OUTPUTS + layout__OUTPUTS_VERTICAL_SHIFT)) = height_rate;
    (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_VERTICAL_SHIFT)) = height;
    return INT64_C(0);
}

/* Tangent of ``follow_compliant``. */
static inline int64_t tangent_wheelset_rules__follow_compliant_t(array_double_1d left_tables, array_double_1d right_tables, array_double_1d work, array_double_1d work_t, array_double_1d state)
{
    double roll_t;
    double roll;
    double height_t;
    double height;
    roll_t = (*cspan_at(&work_t, layout__WORK_INPUTS + layout__INPUTS_ROLL));
    roll = (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_ROLL));
    height_t = (*cspan_at(&work_t, layout__WORK_INPUTS + layout__INPUTS_VERTICAL_SHIFT));
    height = (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_VERTICAL_SHIFT));
    tangent_leaning__set_reference_t(work, work_t, height, height_t);
    tangent_wheelset_rules__place_moving_t(left_tables, right_tables, work, work_t, roll, roll_t);
    (*cspan_at(&work_t, layout__WORK_OUTPUTS + layout__OUTPUTS_ROLL)) = roll_t;
    (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_ROLL)) = roll;
    (*cspan_at(&work_t, layout__WORK_OUTPUTS + layout__OUTPUTS_VERTICAL_SHIFT)) = height_t;
    (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_VERTICAL_SHIFT)) = height;
    if (damping__is_damped(right_tables) == INT64_C(1))
    {
        tangent_moving__open_given_motion_t(left_tables, right_tables, work, work_t);
    }
    tangent_wheelset_rules__follow_minimum_t(left_tables, work, work_t, INT64_C(0));
    tangent_compliant__load_at_height_t(left_tables, work, work_t, state, INT64_C(0), height, height_t);
    tangent_wheelset_rules__follow_minimum_t(right_tables, work, work_t, INT64_C(1));
    tangent_compliant__load_at_height_t(right_tables, work, work_t, state, INT64_C(1), height, height_t);
    return INT64_C(0);
}

/* Tangent of ``differentiate``. */
static inline int64_t tangent_wheelset_rules__differentiate_t(array_double_1d left_tables, array_double_1d right_tables, array_double_1d work, array_double_1d work_t, array_double_1d state)
{
    int64_t n1;
    int64_t i;
    int64_t n2;
    int64_t outcome;
    n1 = tangent_wheelset_rules__follow_wheelset_t(left_tables, right_tables, work, work_t, state);
    outcome = n1;
    if (friction_load__carries_friction(right_tables, work) == INT64_C(1))
    {
        for (i = INT64_C(0); i < friction_load__LOAD_RATES; i += INT64_C(1))
        {
            tangent_wheelset_rules__follow_load_t(work, work_t);
            n2 = tangent_wheelset_rules__follow_wheelset_t(left_tables, right_tables, work, work_t, state);
            outcome = n2;
        }
    }
    tangent_requested__omit_outputs_t(right_tables, work, work_t);
    return outcome;
}

/* Tangent of ``follow_load``. */
static inline int64_t tangent_wheelset_rules__follow_load_t(array_double_1d work, array_double_1d work_t)
{
    int64_t index;
    int64_t support;
    double v1;
    double v1_t;
    double share_t;
    double share;
    for (index = INT64_C(0); index < INT64_C(2); index += INT64_C(1))
    {
        support = layout__WORK_SUPPORTS + layout__SUPPORT_SIZE * index;
        tangent_friction_load__carried_share_t(&v1, &v1_t, work, work_t, index);
        share_t = v1_t;
        share = v1;
        (*cspan_at(&work_t, support + layout__SUPPORT_FRICTION_LOAD)) = (*cspan_at(&work_t, support + layout__SUPPORT_FRICTION_LOAD)) - (*cspan_at(&work, support + layout__SUPPORT_FRICTION_LOAD)) * share_t / share;
    }
    return INT64_C(0);
}

/* Tangent of ``follow_wheelset``. */
static inline int64_t tangent_wheelset_rules__follow_wheelset_t(array_double_1d left_tables, array_double_1d right_tables, array_double_1d work, array_double_1d work_t, array_double_1d state)
{
    int64_t mode;
    double v1;
    double v1_t;
    double roll_t;
    double roll;
    double v2;
    double v2_t;
    int64_t n3;
    int64_t outcome;
    mode = (int64_t)((*cspan_at(&right_tables, layout__TABLES_MODE)));
    outcome = INT64_C(0);
    if (mode == layout__MODE_RIGID)
    {
        tangent_wheelset_rules__follow_roll_t(&v1, &v1_t, left_tables, right_tables, work, work_t);
        roll_t = v1_t;
        roll = v1;
        if ((*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_PLACE + layout__PLACE_LEANING)) == 1.0)
        {
            tangent_wheelset_rules__follow_leaning_roll_t(&v2, &v2_t, left_tables, right_tables, work, work_t);
            roll_t = v2_t;
            roll = v2;
        }
        tangent_wheelset_rules__place_moving_t(left_tables, right_tables, work, work_t, roll, roll_t);
        tangent_wheelset_rules__follow_minimum_t(left_tables, work, work_t, INT64_C(0));
        tangent_wheelset_rules__follow_minimum_t(right_tables, work, work_t, INT64_C(1));
        tangent_rigid__solve_rigid_t(left_tables, right_tables, work, work_t, state, roll, roll_t);
    }
    if (mode == layout__MODE_ELASTIC)
    {
        n3 = tangent_wheelset_rules__follow_elastic_t(left_tables, right_tables, work, work_t, state);
        outcome = n3;
    }
    if (mode == layout__MODE_COMPLIANT)
    {
        tangent_wheelset_rules__follow_compliant_t(left_tables, right_tables, work, work_t, state);
    }
    tangent_resultant__write_resultant_t(work, work_t, right_tables, layout__WORK_SUPPORTS + layout__SUPPORT_RESULTANT, layout__WORK_SUPPORTS + layout__SUPPORT_SIZE * INT64_C(1) + layout__SUPPORT_RESULTANT);
    if (moving__is_rolling(work) == INT64_C(1))
    {
        tangent_moving__write_creepages_t(left_tables, right_tables, work, work_t, state);
    }
    if (creep_forces__has_creep_forces(right_tables, work) == INT64_C(1))
    {
        tangent_creep_forces__write_creep_forces_t(left_tables, right_tables, work, work_t);
    }
    return outcome;
}
