"""The motion of a wheelset and its rails, from the inputs.

Velocities are those in the track frame, whose origin runs along the track with the speed.  In a curve the
frame turns in space, and the rails stand still there.
"""

from math import cos, fabs, sin

from ..layout import (
    CURVATURE_LIMIT,
    RATE_LIMIT,
    SPEED_LIMIT,
    VELOCITY_LIMIT,
    WHEEL_LIMIT,
    Inputs,
    Motion,
    Outputs,
    Tables,
)


def is_moderate(inputs: Inputs):
    """1 if no velocity among the inputs is beyond its limit, else 0."""
    moderate = 1
    if fabs(inputs.speed) > SPEED_LIMIT or fabs(inputs.wheel_rate) > WHEEL_LIMIT:
        moderate = 0
    if fabs(inputs.lateral_velocity) > VELOCITY_LIMIT or fabs(inputs.vertical_velocity) > VELOCITY_LIMIT:
        moderate = 0
    if fabs(inputs.yaw_rate) > RATE_LIMIT or fabs(inputs.roll_rate) > RATE_LIMIT:
        moderate = 0
    if fabs(inputs.track_curvature) > CURVATURE_LIMIT:
        moderate = 0
    if is_rail_moderate(inputs.left_rail_lateral_velocity, inputs.left_rail_vertical_velocity,
                        inputs.left_rail_roll_velocity) == 0:
        moderate = 0
    if is_rail_moderate(inputs.right_rail_lateral_velocity, inputs.right_rail_vertical_velocity,
                        inputs.right_rail_roll_velocity) == 0:
        moderate = 0
    return moderate


def is_rail_moderate(lateral: float, vertical: float, roll: float):
    """1 if no velocity of a rail [m/s, rad/s] is beyond its limit, else 0."""
    moderate = 1
    if fabs(lateral) > VELOCITY_LIMIT or fabs(vertical) > VELOCITY_LIMIT or fabs(roll) > RATE_LIMIT:
        moderate = 0
    return moderate


def rolling_rate(tables: Tables, inputs: Inputs):
    """Rotation of the wheelset about its axle [rad/s], positive when it rolls forward."""
    rate = inputs.wheel_rate
    if rate == 0.0 and inputs.free_rolling != 0.0:
        rate = inputs.speed / tables.height
    return rate


def open_motion(tables: Tables, motion: Motion, inputs: Inputs, outputs: Outputs):
    """What the inputs say of the motion, at the pose of the ``outputs``.  Vertical velocity and roll rate are
    left to :func:`set_rates`."""
    sin_yaw = sin(inputs.yaw)
    cos_yaw = cos(inputs.yaw)
    sin_roll = sin(outputs.roll)
    cos_roll = cos(outputs.roll)
    motion.speed = inputs.speed
    motion.lateral = inputs.lateral_velocity
    motion.wheel_rate = rolling_rate(tables, inputs)
    motion.track_rate = inputs.speed * inputs.track_curvature
    motion.turn_z = inputs.yaw_rate
    motion.axle_x = -sin_yaw * cos_roll
    motion.axle_y = cos_yaw * cos_roll
    motion.axle_z = sin_roll
    motion.centre_y = inputs.lateral_shift
    motion.centre_z = outputs.vertical_shift - tables.height
    return 0


def open_rails(left_tables: Tables, right_tables: Tables, motion: Motion, inputs: Inputs):
    """What the inputs say of the rails, which roll about their highest points."""
    left = motion.rails[0]
    right = motion.rails[1]
    left.lateral = inputs.left_rail_lateral_velocity
    left.vertical = inputs.left_rail_vertical_velocity
    left.roll = inputs.left_rail_roll_velocity
    left.y = inputs.left_rail_lateral - left_tables.rail_y
    left.z = inputs.left_rail_vertical
    right.lateral = inputs.right_rail_lateral_velocity
    right.vertical = inputs.right_rail_vertical_velocity
    right.roll = inputs.right_rail_roll_velocity
    right.y = right_tables.rail_y + inputs.right_rail_lateral
    right.z = inputs.right_rail_vertical
    return 0


def set_rates(motion: Motion, inputs: Inputs, vertical: float, roll_rate: float):
    """Give the motion its vertical velocity [m/s] and roll rate [rad/s].

    The wheelset rolls about its own x axis, which yaws with it: (cos(yaw), sin(yaw), 0).
    """
    motion.vertical = vertical
    motion.turn_x = roll_rate * cos(inputs.yaw)
    motion.turn_y = roll_rate * sin(inputs.yaw)
    return 0
