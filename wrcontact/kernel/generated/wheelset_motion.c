/* Generated from motion/wheelset_motion.py by tools/transpile_kernel.py; change that one.
 *
 * The motion of a wheelset and its rails, from the inputs.
 *
 * Velocities are those in the track frame, whose origin runs along the track with the speed.  In a curve the
 * frame turns in space, and the rails stand still there.
 */

#include "wheelset_motion.h"

/* 1 if no velocity among the inputs is beyond its limit, else 0. */
static inline int64_t wheelset_motion__is_moderate(array_double_1d work)
{
    int64_t moderate;
    moderate = INT64_C(1);
    if ((fabs((*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_SPEED))) > layout__SPEED_LIMIT) || (fabs((*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_WHEEL_RATE))) > layout__WHEEL_LIMIT))
    {
        moderate = INT64_C(0);
    }
    if ((fabs((*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_LATERAL_VELOCITY))) > layout__VELOCITY_LIMIT) || (fabs((*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_VERTICAL_VELOCITY))) > layout__VELOCITY_LIMIT))
    {
        moderate = INT64_C(0);
    }
    if ((fabs((*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_YAW_RATE))) > layout__RATE_LIMIT) || (fabs((*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_ROLL_RATE))) > layout__RATE_LIMIT))
    {
        moderate = INT64_C(0);
    }
    if (fabs((*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_TRACK_CURVATURE))) > layout__CURVATURE_LIMIT)
    {
        moderate = INT64_C(0);
    }
    if (wheelset_motion__is_rail_moderate((*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_LEFT_RAIL_LATERAL_VELOCITY)), (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_LEFT_RAIL_VERTICAL_VELOCITY)), (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_LEFT_RAIL_ROLL_VELOCITY))) == INT64_C(0))
    {
        moderate = INT64_C(0);
    }
    if (wheelset_motion__is_rail_moderate((*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_RIGHT_RAIL_LATERAL_VELOCITY)), (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_RIGHT_RAIL_VERTICAL_VELOCITY)), (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_RIGHT_RAIL_ROLL_VELOCITY))) == INT64_C(0))
    {
        moderate = INT64_C(0);
    }
    return moderate;
}

/* 1 if no velocity of a rail [m/s, rad/s] is beyond its limit, else 0. */
static inline int64_t wheelset_motion__is_rail_moderate(double lateral, double vertical, double roll)
{
    int64_t moderate;
    moderate = INT64_C(1);
    if ((fabs(lateral) > layout__VELOCITY_LIMIT) || (fabs(vertical) > layout__VELOCITY_LIMIT) || (fabs(roll) > layout__RATE_LIMIT))
    {
        moderate = INT64_C(0);
    }
    return moderate;
}

/* Rotation of the wheelset about its axle [rad/s], positive when it rolls forward. */
static inline double wheelset_motion__rolling_rate(array_double_1d work, array_double_1d tables)
{
    double rate;
    rate = (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_WHEEL_RATE));
    if ((rate == 0.0) && ((*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_FREE_ROLLING)) != 0.0))
    {
        rate = (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_SPEED)) / (*cspan_at(&tables, layout__TABLES_HEIGHT));
    }
    return rate;
}

/* What the inputs say of the motion, at the pose of the ``outputs``.  Vertical velocity and roll rate are
 * left to :func:`set_rates`.
 */
static inline int64_t wheelset_motion__open_motion(array_double_1d work, array_double_1d tables)
{
    double sin_yaw;
    double cos_yaw;
    double sin_roll;
    double cos_roll;
    sin_yaw = sin((*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_YAW)));
    cos_yaw = cos((*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_YAW)));
    sin_roll = sin((*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_ROLL)));
    cos_roll = cos((*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_ROLL)));
    (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_SPEED)) = (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_SPEED));
    (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_LATERAL)) = (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_LATERAL_VELOCITY));
    (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_WHEEL_RATE)) = wheelset_motion__rolling_rate(work, tables);
    (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TRACK_RATE)) = (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_SPEED)) * (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_TRACK_CURVATURE));
    (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TURN_Z)) = (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_YAW_RATE));
    (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_AXLE_X)) = (-sin_yaw) * cos_roll;
    (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_AXLE_Y)) = cos_yaw * cos_roll;
    (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_AXLE_Z)) = sin_roll;
    (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_CENTRE_Y)) = (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_LATERAL_SHIFT));
    (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_CENTRE_Z)) = (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_VERTICAL_SHIFT)) - (*cspan_at(&tables, layout__TABLES_HEIGHT));
    return INT64_C(0);
}

/* What the inputs say of the rails, which roll about their highest points. */
static inline int64_t wheelset_motion__open_rails(array_double_1d work, array_double_1d left_tables, array_double_1d right_tables)
{
    int64_t right;
    right = layout__WORK_MOTION + layout__MOTION_RAILS + layout__RAIL_MOTION_SIZE * INT64_C(1);
    (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_RAILS + layout__RAIL_MOTION_LATERAL)) = (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_LEFT_RAIL_LATERAL_VELOCITY));
    (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_RAILS + layout__RAIL_MOTION_VERTICAL)) = (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_LEFT_RAIL_VERTICAL_VELOCITY));
    (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_RAILS + layout__RAIL_MOTION_ROLL)) = (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_LEFT_RAIL_ROLL_VELOCITY));
    (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_RAILS + layout__RAIL_MOTION_Y)) = (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_LEFT_RAIL_LATERAL)) - (*cspan_at(&left_tables, layout__TABLES_RAIL_Y));
    (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_RAILS + layout__RAIL_MOTION_Z)) = (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_LEFT_RAIL_VERTICAL));
    (*cspan_at(&work, right + layout__RAIL_MOTION_LATERAL)) = (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_RIGHT_RAIL_LATERAL_VELOCITY));
    (*cspan_at(&work, right + layout__RAIL_MOTION_VERTICAL)) = (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_RIGHT_RAIL_VERTICAL_VELOCITY));
    (*cspan_at(&work, right + layout__RAIL_MOTION_ROLL)) = (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_RIGHT_RAIL_ROLL_VELOCITY));
    (*cspan_at(&work, right + layout__RAIL_MOTION_Y)) = (*cspan_at(&right_tables, layout__TABLES_RAIL_Y)) + (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_RIGHT_RAIL_LATERAL));
    (*cspan_at(&work, right + layout__RAIL_MOTION_Z)) = (*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_RIGHT_RAIL_VERTICAL));
    return INT64_C(0);
}

/* Give the motion its vertical velocity [m/s] and roll rate [rad/s].
 *
 * The wheelset rolls about its own x axis, which yaws with it: (cos(yaw), sin(yaw), 0).
 */
static inline int64_t wheelset_motion__set_rates(array_double_1d work, double vertical, double roll_rate)
{
    (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_VERTICAL)) = vertical;
    (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TURN_X)) = roll_rate * cos((*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_YAW)));
    (*cspan_at(&work, layout__WORK_MOTION + layout__MOTION_TURN_Y)) = roll_rate * sin((*cspan_at(&work, layout__WORK_INPUTS + layout__INPUTS_YAW)));
    return INT64_C(0);
}
