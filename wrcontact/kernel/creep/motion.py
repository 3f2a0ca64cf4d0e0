"""The motion of a wheelset and its rails, from the inputs.

Velocities are those in the track frame, whose origin runs along the track with the speed.  In a curve the
frame turns in space, and the rails stand still there.  The left side is mirrored.

Vertical velocity and roll rate may follow from contact with both rails.  A wheel that stays in contact moves
along the plane of the contact: the velocity of its surface against the rail has no part along the normal n.
With the velocity v of the wheelset's centre and its rotation W this is

    n . v + ((P - C) x n) . W = the same for the rail

at each wheel, two linear equations for the two that are not given.  The rotation about the axle is left out:
it does not move the surface of a round wheel, whose normal goes through the axle.

Each wheel has its equation in its own frame, in which the left side is mirrored, and so is its roll rate.
"""

from math import fabs

from ..elementary.circle import sine_cosine
from ..elementary.pair import solve_pair
from ..layout import (
    CURVATURE_LIMIT,
    RATE_LIMIT,
    SPEED_LIMIT,
    TORQUE_LIMIT,
    VELOCITY_LIMIT,
    WHEEL_LIMIT,
    ContactPoint,
    Deflection,
    Forces,
    Inputs,
    Motion,
    Pair,
    RailMotion,
    Tables,
    Wheelset,
)


def is_moderate(inputs: Inputs) -> bool:
    """Whether no velocity among the inputs is beyond its limit."""
    moderate = not (fabs(inputs.speed) > SPEED_LIMIT or fabs(inputs.wheel_rate) > WHEEL_LIMIT)
    if fabs(inputs.left_wheel_rate) > WHEEL_LIMIT or fabs(inputs.right_wheel_rate) > WHEEL_LIMIT:
        moderate = False
    if fabs(inputs.lateral_velocity) > VELOCITY_LIMIT or fabs(inputs.vertical_velocity) > VELOCITY_LIMIT:
        moderate = False
    if fabs(inputs.yaw_rate) > RATE_LIMIT or fabs(inputs.roll_rate) > RATE_LIMIT:
        moderate = False
    if fabs(inputs.axle_torque) > TORQUE_LIMIT:
        moderate = False
    if fabs(inputs.left_axle_torque) > TORQUE_LIMIT or fabs(inputs.right_axle_torque) > TORQUE_LIMIT:
        moderate = False
    if fabs(inputs.track_curvature) > CURVATURE_LIMIT:
        moderate = False
    if not is_rail_moderate(
        inputs.left_rail_lateral_velocity, inputs.left_rail_vertical_velocity, inputs.left_rail_roll_velocity
    ):
        moderate = False
    if not is_rail_moderate(
        inputs.right_rail_lateral_velocity,
        inputs.right_rail_vertical_velocity,
        inputs.right_rail_roll_velocity,
    ):
        moderate = False
    return moderate


def is_rail_moderate(lateral: float, vertical: float, roll: float) -> bool:
    """Whether no velocity of a rail [m/s, rad/s] is beyond its limit."""
    return not (fabs(lateral) > VELOCITY_LIMIT or fabs(vertical) > VELOCITY_LIMIT or fabs(roll) > RATE_LIMIT)


def rolling_rate(inputs: Inputs, given: float, radius: float):
    """Rotation about the axle [rad/s], positive when it rolls forward, of which the input ``given`` says as
    much; 0 may stand for that of a nominal ``radius`` [m], or for one that follows
    (wheelset/free_rolling.py)."""
    rate = given
    if rate == 0.0 and inputs.free_rolling != 0.0:
        rate = inputs.speed / radius
    return rate


def are_independent(tables: Tables) -> bool:
    """Whether each wheel turns by itself."""
    return tables.parameters.independent_wheels != 0.0


def turn_wheels(tables: Tables, left: Motion, right: Motion, inputs: Inputs):
    """Give each wheel its own rotation."""
    left.wheel_rate = rolling_rate(inputs, inputs.left_wheel_rate, tables.pairs[0].radius)
    right.wheel_rate = rolling_rate(inputs, inputs.right_wheel_rate, tables.pairs[1].radius)


def open_motion(tables: Tables, motion: Motion, inputs: Inputs, wheelset: Wheelset):
    """What the inputs say of the motion of the ``wheelset``, as the right side sees it.  Vertical velocity
    and roll rate are left to :func:`set_rates`."""
    sin_yaw, cos_yaw = sine_cosine(inputs.yaw)
    sin_roll, cos_roll = sine_cosine(wheelset.roll)
    motion.speed = inputs.speed
    motion.lateral = inputs.lateral_velocity
    motion.wheel_rate = rolling_rate(inputs, inputs.wheel_rate, tables.height)
    motion.track_rate = inputs.speed * inputs.track_curvature
    motion.turn_z = inputs.yaw_rate
    motion.ahead_x = cos_yaw
    motion.ahead_y = sin_yaw
    motion.axle_x = -sin_yaw * cos_roll
    motion.axle_y = cos_yaw * cos_roll
    motion.axle_z = sin_roll
    motion.centre_y = inputs.lateral_shift
    motion.centre_z = wheelset.vertical_shift - tables.height


def mirror_motion(motion: Motion, mirrored: Motion):
    """The same as the left side sees it, which is mirrored."""
    mirrored.speed = motion.speed
    mirrored.lateral = -motion.lateral
    mirrored.wheel_rate = motion.wheel_rate
    mirrored.track_rate = -motion.track_rate
    mirrored.turn_z = -motion.turn_z
    mirrored.ahead_x = motion.ahead_x
    mirrored.ahead_y = -motion.ahead_y
    mirrored.axle_x = -motion.axle_x
    mirrored.axle_y = motion.axle_y
    mirrored.axle_z = -motion.axle_z
    mirrored.centre_y = -motion.centre_y
    mirrored.centre_z = motion.centre_z


def open_left_rail(pair: Pair, rail: RailMotion, inputs: Inputs):
    """What the inputs say of the left rail, which rolls about its highest point; mirrored."""
    rail.lateral = -inputs.left_rail_lateral_velocity
    rail.vertical = inputs.left_rail_vertical_velocity
    rail.roll = -inputs.left_rail_roll_velocity
    rail.y = pair.rail_y - inputs.left_rail_lateral
    rail.z = inputs.left_rail_vertical


def open_right_rail(pair: Pair, rail: RailMotion, inputs: Inputs):
    """The same of the right rail."""
    rail.lateral = inputs.right_rail_lateral_velocity
    rail.vertical = inputs.right_rail_vertical_velocity
    rail.roll = inputs.right_rail_roll_velocity
    rail.y = pair.rail_y + inputs.right_rail_lateral
    rail.z = inputs.right_rail_vertical


def carry_rail(rail: RailMotion, deflection: Deflection):
    """Let a rail on springs move by their deflection, too."""
    rail.lateral += deflection.lateral_rate
    rail.vertical += deflection.vertical_rate
    rail.y += deflection.lateral
    rail.z += deflection.vertical


def set_rates(left: Motion, right: Motion, vertical: float, roll_rate: float):
    """Give both sides the wheelset's vertical velocity [m/s] and roll rate [rad/s].

    The wheelset rolls about its own x axis, which yaws with it: (cos(yaw), sin(yaw), 0).
    """
    right.vertical = vertical
    right.turn_x = roll_rate * right.ahead_x
    right.turn_y = roll_rate * right.ahead_y
    left.vertical = vertical
    left.turn_x = -right.turn_x
    left.turn_y = right.turn_y


def constrain_touching(motion: Motion, point: ContactPoint):
    """The normal of the place where a rigid wheel touches its rail keeps it there."""
    constraint = motion.constraint
    x = point.x_track
    y = point.y_track - motion.centre_y
    z = point.z_track - motion.centre_z
    sine, cosine = sine_cosine(point.contact_angle)
    normal_y = -sine
    normal_z = -cosine
    constraint.y = normal_y
    constraint.z = normal_z
    constraint.moment_x = y * normal_z - z * normal_y
    constraint.moment_y = -x * normal_z
    constraint.moment_z = x * normal_y


def constrain_loaded(motion: Motion, forces: Forces):
    """The force of an elastic wheel [N] and its moment about the wheelset's centre [N m] keep it on its rail:
    what its patches approach is zero in the mean over the load, if its depth stays."""
    constraint = motion.constraint
    constraint.y = forces.normal_force[1]
    constraint.z = forces.normal_force[2]
    constraint.moment_x = forces.normal_moment[0]
    constraint.moment_y = forces.normal_moment[1]
    constraint.moment_z = forces.normal_moment[2]


def known_part(motion: Motion):
    """What the velocities that are known do with the constraint of a side."""
    constraint = motion.constraint
    rail = motion.rail
    # of the force about the point about which the rail rolls
    rail_moment = (
        constraint.moment_x
        + (motion.centre_y - rail.y) * constraint.z
        - (motion.centre_z - rail.z) * constraint.y
    )
    return (
        constraint.y * (motion.lateral - rail.lateral)
        + constraint.moment_z * motion.turn_z
        - constraint.z * rail.vertical
        - rail_moment * rail.roll
    )


def constraint_residual(motion: Motion):
    """How much faster than the wheelset the wheel of a side comes down [m/s], if it stays on its rail."""
    constraint = motion.constraint
    power = (
        known_part(motion)
        + constraint.z * motion.vertical
        + constraint.moment_x * motion.turn_x
        + constraint.moment_y * motion.turn_y
    )
    return -power / constraint.z


def set_contact_rates(left: Motion, right: Motion):
    """Vertical velocity [m/s] and roll rate [rad/s] with which both constraints hold; zero where they cannot
    tell."""
    x = right.ahead_x
    y = right.ahead_y
    left_roll = y * left.constraint.moment_y - x * left.constraint.moment_x
    right_roll = x * right.constraint.moment_x + y * right.constraint.moment_y
    known_left = known_part(left)
    known_right = known_part(right)
    determinant, vertical, roll_rate = solve_pair(
        known_left, known_right, left.constraint.z, left_roll, right.constraint.z, right_roll
    )
    set_rates(left, right, vertical, roll_rate)
