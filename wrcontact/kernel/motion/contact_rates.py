"""Vertical velocity and roll rate of a wheelset that stays on both rails.

A wheel that stays in contact moves along the plane of the contact: the velocity of its surface against the
rail has no part along the normal n.  With the velocity v of the wheelset's centre and its rotation W this is

    n . v + ((P - C) x n) . W = the same for the rail

at each wheel, two linear equations for the two that are not given.  The rotation about the axle is left out:
it does not move the surface of a round wheel, whose normal goes through the axle.

Each wheel has its equation in its own frame, in which the left side is mirrored, and so is its roll rate.
"""

from math import cos, sin

from ..layout import ContactPoint, Forces, Inputs, Motion
from .wheelset_motion import set_rates


def constrain_touching(motion: Motion, point: ContactPoint):
    """The normal of the place where a rigid wheel touches its rail keeps it there."""
    constraint = motion.constraint
    x = point.x_track
    y = point.y_track - motion.centre_y
    z = point.z_track - motion.centre_z
    normal_y = -sin(point.contact_angle)
    normal_z = -cos(point.contact_angle)
    constraint.y = normal_y
    constraint.z = normal_z
    constraint.moment_x = y * normal_z - z * normal_y
    constraint.moment_y = -x * normal_z
    constraint.moment_z = x * normal_y


def constrain_loaded(motion: Motion, forces: Forces):
    """The force of an elastic wheel [N] and its moment about the wheelset's centre [N m] keep it on its rail:
    what its patches approach is zero in the mean over the load, which stays."""
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
    rail_moment = (constraint.moment_x + (motion.centre_y - rail.y) * constraint.z
                   - (motion.centre_z - rail.z) * constraint.y)
    return (constraint.y * (motion.lateral - rail.lateral) + constraint.moment_z * motion.turn_z
            - constraint.z * rail.vertical - rail_moment * rail.roll)


def set_contact_rates(left: Motion, right: Motion, inputs: Inputs):
    """Vertical velocity [m/s] and roll rate [rad/s] with which both constraints hold; zero where they cannot
    tell."""
    sin_yaw = sin(inputs.yaw)
    cos_yaw = cos(inputs.yaw)
    left_roll = sin_yaw * left.constraint.moment_y - cos_yaw * left.constraint.moment_x
    right_roll = cos_yaw * right.constraint.moment_x + sin_yaw * right.constraint.moment_y
    known_left = known_part(left)
    known_right = known_part(right)
    determinant = left.constraint.z * right_roll - right.constraint.z * left_roll
    vertical = 0.0
    roll_rate = 0.0
    if determinant != 0.0:
        vertical = (known_right * left_roll - known_left * right_roll) / determinant
        roll_rate = (known_left * right.constraint.z - known_right * left.constraint.z) / determinant
    set_rates(left, right, inputs, vertical, roll_rate)
