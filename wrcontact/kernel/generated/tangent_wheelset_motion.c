/* Generated from tangent_wheelset_motion.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of wheelset_motion.py.
 */

#include "tangent_wheelset_motion.h"

/* Tangent of ``rolling_rate``. */
static inline int64_t tangent_wheelset_motion__rolling_rate_t(double* rate, double* rate_t, array_double_1d work, array_double_1d work_t, array_double_1d tables)
{
    (*rate_t) = (*cspan_at(&work_t, layout__WORK_INPUTS + layout__INPUTS_WHEEL_RATE));
    (*rate) = (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_WHEEL_RATE));
    if (((*rate) == 0.0) && ((*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_FREE_ROLLING)) != 0.0))
    {
        (*rate_t) = (*cspan_at(&work_t, layout__WORK_INPUTS + layout__INPUTS_SPEED)) / (*cspan_at(&tables, layout__TABLES_HEIGHT));
        (*rate) = (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_SPEED)) / (*cspan_at(&tables, layout__TABLES_HEIGHT));
    }
    return 0;
}

/* Tangent of ``open_motion``. */
static inline int64_t tangent_wheelset_motion__open_motion_t(array_double_1d work, array_double_1d work_t, array_double_1d tables)
{
    double sin_yaw_t;
    double sin_yaw;
    double cos_yaw_t;
    double cos_yaw;
    double sin_roll_t;
    double sin_roll;
    double cos_roll_t;
    double cos_roll;
    double v1;
    double v1_t;
    double v2;
    sin_yaw_t = cos((*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_YAW))) * (*cspan_at(&work_t, layout__WORK_INPUTS + layout__INPUTS_YAW));
    sin_yaw = sin((*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_YAW)));
    cos_yaw_t = (-sin((*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_YAW)))) * (*cspan_at(&work_t, layout__WORK_INPUTS + layout__INPUTS_YAW));
    cos_yaw = cos((*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_YAW)));
    sin_roll_t = cos((*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_ROLL))) * (*cspan_at(&work_t, layout__WORK_OUTPUTS + layout__OUTPUTS_ROLL));
    sin_roll = sin((*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_ROLL)));
    cos_roll_t = (-sin((*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_ROLL)))) * (*cspan_at(&work_t, layout__WORK_OUTPUTS + layout__OUTPUTS_ROLL));
    cos_roll = cos((*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_ROLL)));
    (*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_SPEED)) = (*cspan_at(&work_t, layout__WORK_INPUTS + layout__INPUTS_SPEED));
    (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_SPEED)) = (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_SPEED));
    (*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_LATERAL)) = (*cspan_at(&work_t, layout__WORK_INPUTS + layout__INPUTS_LATERAL_VELOCITY));
    (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_LATERAL)) = (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_LATERAL_VELOCITY));
    tangent_wheelset_motion__rolling_rate_t(&v1, &v1_t, work, work_t, tables);
    (*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_WHEEL_RATE)) = v1_t;
    (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_WHEEL_RATE)) = v1;
    (*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_TRACK_RATE)) = (*cspan_at(&work_t, layout__WORK_INPUTS + layout__INPUTS_SPEED)) * (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_TRACK_CURVATURE)) + (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_SPEED)) * (*cspan_at(&work_t, layout__WORK_INPUTS + layout__INPUTS_TRACK_CURVATURE));
    (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TRACK_RATE)) = (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_SPEED)) * (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_TRACK_CURVATURE));
    (*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_TURN_Z)) = (*cspan_at(&work_t, layout__WORK_INPUTS + layout__INPUTS_YAW_RATE));
    (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TURN_Z)) = (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_YAW_RATE));
    v2 = -sin_yaw;
    (*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_AXLE_X)) = (-sin_yaw_t) * cos_roll + v2 * cos_roll_t;
    (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_AXLE_X)) = v2 * cos_roll;
    (*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_AXLE_Y)) = cos_yaw_t * cos_roll + cos_yaw * cos_roll_t;
    (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_AXLE_Y)) = cos_yaw * cos_roll;
    (*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_AXLE_Z)) = sin_roll_t;
    (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_AXLE_Z)) = sin_roll;
    (*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_CENTRE_Y)) = (*cspan_at(&work_t, layout__WORK_INPUTS + layout__INPUTS_LATERAL_SHIFT));
    (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_CENTRE_Y)) = (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_LATERAL_SHIFT));
    (*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_CENTRE_Z)) = (*cspan_at(&work_t, layout__WORK_OUTPUTS + layout__OUTPUTS_VERTICAL_SHIFT));
    (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_CENTRE_Z)) = (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_VERTICAL_SHIFT)) - (*cspan_at(&tables, layout__TABLES_HEIGHT));
    return INT64_C(0);
}

/* Tangent of ``open_rails``. */
static inline int64_t tangent_wheelset_motion__open_rails_t(array_double_1d work, array_double_1d work_t, array_double_1d left_tables, array_double_1d right_tables)
{
    int64_t right;
    right = layout__WORK_MOTION + layout__MOTION_RAILS + layout__RAIL_MOTION_SIZE * INT64_C(1);
    (*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_RAILS + layout__RAIL_MOTION_LATERAL)) = (*cspan_at(&work_t, layout__WORK_INPUTS + layout__INPUTS_LEFT_RAIL_LATERAL_VELOCITY));
    (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_RAILS + layout__RAIL_MOTION_LATERAL)) = (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_LEFT_RAIL_LATERAL_VELOCITY));
    (*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_RAILS + layout__RAIL_MOTION_VERTICAL)) = (*cspan_at(&work_t, layout__WORK_INPUTS + layout__INPUTS_LEFT_RAIL_VERTICAL_VELOCITY));
    (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_RAILS + layout__RAIL_MOTION_VERTICAL)) = (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_LEFT_RAIL_VERTICAL_VELOCITY));
    (*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_RAILS + layout__RAIL_MOTION_ROLL)) = (*cspan_at(&work_t, layout__WORK_INPUTS + layout__INPUTS_LEFT_RAIL_ROLL_VELOCITY));
    (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_RAILS + layout__RAIL_MOTION_ROLL)) = (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_LEFT_RAIL_ROLL_VELOCITY));
    (*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_RAILS + layout__RAIL_MOTION_Y)) = (*cspan_at(&work_t, layout__WORK_INPUTS + layout__INPUTS_LEFT_RAIL_LATERAL));
    (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_RAILS + layout__RAIL_MOTION_Y)) = (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_LEFT_RAIL_LATERAL)) - (*cspan_at(&left_tables, layout__TABLES_RAIL_Y));
    (*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_RAILS + layout__RAIL_MOTION_Z)) = (*cspan_at(&work_t, layout__WORK_INPUTS + layout__INPUTS_LEFT_RAIL_VERTICAL));
    (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_RAILS + layout__RAIL_MOTION_Z)) = (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_LEFT_RAIL_VERTICAL));
    (*cspan_at(&work_t, right + layout__RAIL_MOTION_LATERAL)) = (*cspan_at(&work_t, layout__WORK_INPUTS + layout__INPUTS_RIGHT_RAIL_LATERAL_VELOCITY));
    (*cspan_at(&work, right + layout__RAIL_MOTION_LATERAL)) = (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_RIGHT_RAIL_LATERAL_VELOCITY));
    (*cspan_at(&work_t, right + layout__RAIL_MOTION_VERTICAL)) = (*cspan_at(&work_t, layout__WORK_INPUTS + layout__INPUTS_RIGHT_RAIL_VERTICAL_VELOCITY));
    (*cspan_at(&work, right + layout__RAIL_MOTION_VERTICAL)) = (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_RIGHT_RAIL_VERTICAL_VELOCITY));
    (*cspan_at(&work_t, right + layout__RAIL_MOTION_ROLL)) = (*cspan_at(&work_t, layout__WORK_INPUTS + layout__INPUTS_RIGHT_RAIL_ROLL_VELOCITY));
    (*cspan_at(&work, right + layout__RAIL_MOTION_ROLL)) = (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_RIGHT_RAIL_ROLL_VELOCITY));
    (*cspan_at(&work_t, right + layout__RAIL_MOTION_Y)) = (*cspan_at(&work_t, layout__WORK_INPUTS + layout__INPUTS_RIGHT_RAIL_LATERAL));
    (*cspan_at(&work, right + layout__RAIL_MOTION_Y)) = (*cspan_at(&right_tables, layout__TABLES_RAIL_Y)) + (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_RIGHT_RAIL_LATERAL));
    (*cspan_at(&work_t, right + layout__RAIL_MOTION_Z)) = (*cspan_at(&work_t, layout__WORK_INPUTS + layout__INPUTS_RIGHT_RAIL_VERTICAL));
    (*cspan_at(&work, right + layout__RAIL_MOTION_Z)) = (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_RIGHT_RAIL_VERTICAL));
    return INT64_C(0);
}

/* Tangent of ``set_rates``. */
static inline int64_t tangent_wheelset_motion__set_rates_t(array_double_1d work, array_double_1d work_t, double vertical, double vertical_t, double roll_rate, double roll_rate_t)
{
    double v1;
    double v2;
    (*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_VERTICAL)) = vertical_t;
    (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_VERTICAL)) = vertical;
    v1 = cos((*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_YAW)));
    (*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_TURN_X)) = roll_rate_t * v1 + roll_rate * ((-sin((*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_YAW)))) * (*cspan_at(&work_t, layout__WORK_INPUTS + layout__INPUTS_YAW)));
    (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TURN_X)) = roll_rate * v1;
    v2 = sin((*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_YAW)));
    (*cspan_at(&work_t, layout__WORK_MOTION + layout__MOTION_TURN_Y)) = roll_rate_t * v2 + roll_rate * (cos((*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_YAW))) * (*cspan_at(&work_t, layout__WORK_INPUTS + layout__INPUTS_YAW)));
    (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TURN_Y)) = roll_rate * v2;
    return INT64_C(0);
}
