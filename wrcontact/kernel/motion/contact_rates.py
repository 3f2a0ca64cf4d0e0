"""Vertical velocity and roll rate of a wheelset that stays on both rails.

A wheel that stays in contact moves along the plane of the contact: the velocity of its surface against the
rail has no part along the normal n.  With the velocity v of the wheelset's centre and its rotation W this is

    n . v + ((P - C) x n) . W = the same for the rail

at each wheel, two linear equations for the two that are not given.  The rotation about the axle is left out:
it does not move the surface of a round wheel, whose normal goes through the axle.
"""

from math import cos, sin

from ..layout import Constraint, Inputs, Motion, SideOutputs


def touching_constraint(motion: Motion, side: SideOutputs, mirror: float, constraint: Constraint):
    """The normal of the place where a rigid wheel touches its rail; ``mirror`` = 1 on the right, -1 on the
    left."""
    x = side.x_track
    y = side.y_track - motion.centre_y
    z = side.z_track - motion.centre_z
    normal_y = -mirror * sin(side.contact_angle)
    normal_z = -cos(side.contact_angle)
    constraint.y = normal_y
    constraint.z = normal_z
    constraint.moment_x = y * normal_z - z * normal_y
    constraint.moment_y = -x * normal_z
    constraint.moment_z = x * normal_y
    return 0


def loaded_constraint(side: SideOutputs, constraint: Constraint):
    """The force of an elastic wheel [N] and its moment about the wheelset's centre [N m]: what its patches
    approach is zero in the mean over the load, which stays."""
    constraint.y = side.force[1]
    constraint.z = side.force[2]
    constraint.moment_x = side.moment[0]
    constraint.moment_y = side.moment[1]
    constraint.moment_z = side.moment[2]
    return 0


def known_part(motion: Motion, index: int):
    """What the velocities that are known do with the constraint of side ``index``."""
    constraint = motion.constraints[index]
    rail = motion.rails[index]
    # of the force about the point about which the rail rolls
    rail_moment = (constraint.moment_x + (motion.centre_y - rail.y) * constraint.z
                   - (motion.centre_z - rail.z) * constraint.y)
    return (constraint.y * (motion.lateral - rail.lateral) + constraint.moment_z * motion.turn_z
            - constraint.z * rail.vertical - rail_moment * rail.roll)


def contact_rates(motion: Motion, inputs: Inputs):
    """Vertical velocity [m/s] and roll rate [rad/s] with which both constraints hold; zero where they cannot
    tell."""
    sin_yaw = sin(inputs.yaw)
    cos_yaw = cos(inputs.yaw)
    left = motion.constraints[0]
    right = motion.constraints[1]
    left_roll = cos_yaw * left.moment_x + sin_yaw * left.moment_y
    right_roll = cos_yaw * right.moment_x + sin_yaw * right.moment_y
    known_left = known_part(motion, 0)
    known_right = known_part(motion, 1)
    determinant = left.z * right_roll - right.z * left_roll
    vertical = 0.0
    roll_rate = 0.0
    if determinant != 0.0:
        vertical = (known_right * left_roll - known_left * right_roll) / determinant
        roll_rate = (known_left * right.z - known_right * left.z) / determinant
    return vertical, roll_rate
