"""Creepages of the patches: how the wheel slides and turns on the rail, over the rolling speed.

At a patch's centre of load P the wheel's surface has the velocity

    v = (V, y', z') + W x (P - C) - w e2 x (P - C)

with the velocity of the wheelset's centre C, its rotation W but for that about the axle, and its rotation w
about the axle e2, positive when it rolls forward.  On the right wheel, with the normal n from the
rail to the wheel and y_p = e_x x n, which points to the field side,

    V_ref = sqrt((|V| + |w e2 x (P - C)|_x)^2 / 4 + V_0^2),   V_0 = 1e-12 m/s
    xi = v . e_x / V_ref,   eta = v . y_p / V_ref,   phi = -(W - w e2) . n / V_ref

The left wheel is mirrored.  A strip of a patch has those of its own middle, with the rail's normal there.

V_0 changes no bit of a wheel that rolls.  Towards standstill, with whatever velocities across the track,
creepages grow until the whole patch slips against them, and creep forces have their limit.  A wheelset at rest
has no creepages, which V_0 lets them reach without a jump.

The distance of P from the axle counts as the rolling radius there: an elastic wheel turns with the
circumference that it has when it carries nothing, however deep it is pressed.
"""

from math import fabs, sqrt
from typing import Final

from ..layout import ROLLING_STRIP_LIMIT, Motion, Patch, RollingStrip

#: V_0 [m/s]: a picometre a second, far below what any run could tell from rest.
REST: Final[float] = 1e-12


def move_patch(motion: Motion, patch: Patch):
    """Rolling speed and creepages of a patch."""
    x = patch.x_track
    y = patch.y_track - motion.centre_y
    z = patch.z_track - motion.centre_z
    rolling_x, rolling_y, rolling_z, share = rolling_velocity(motion, x, y, z, patch.rolling_radius)
    along = velocity_along(motion, y, z, rolling_x)
    lateral, vertical = velocity_across(motion, x, patch.y_track, patch.z_track, rolling_y, rolling_z)
    normal_y = -patch.angle_sin
    normal_z = -patch.angle_cos
    speed = reference_speed(motion.speed, rolling_x)
    patch.speed = speed
    patch.radius_share = share
    patch.backwards = motion.speed + rolling_x < 0.0
    patch.creepage_x = along / speed
    patch.creepage_y = -(normal_z * lateral - normal_y * vertical) / speed
    patch.spin = (
        -(
            (motion.turn_y - motion.wheel_rate * motion.axle_y) * normal_y
            + (motion.turn_z + motion.track_rate - motion.wheel_rate * motion.axle_z) * normal_z
        )
        / speed
    )


def move_strips(motion: Motion, patch: Patch):
    """Creepages and spin of the strips of a patch that rolls."""
    inverse = 1.0 / patch.speed
    for index in range(ROLLING_STRIP_LIMIT):
        move_strip(motion, patch.strips[index], patch.x_track, inverse)


def move_strip(motion: Motion, strip: RollingStrip, x_track: float, inverse: float):
    """Creepages and spin of a strip, with its own rolling radius and its own normal; its patch is at
    ``x_track`` [m] and rolls at the speed 1/``inverse`` [m/s]."""
    rail = motion.rail
    x = x_track + strip.x
    y = strip.y_track - motion.centre_y
    z = strip.z_track - motion.centre_z
    rolling_x, rolling_y, rolling_z, share = rolling_velocity(motion, x, y, z, strip.rolling_radius)
    turn_z = motion.turn_z + motion.track_rate
    along = motion.speed - motion.track_rate * motion.centre_y - turn_z * y + motion.turn_y * z - rolling_x
    roll = motion.turn_x - rail.roll
    lateral = (
        motion.lateral
        - rail.lateral
        + rail.roll * (motion.centre_z - rail.z)
        + turn_z * x
        - roll * z
        - rolling_y
    )
    vertical = (
        motion.vertical
        - rail.vertical
        - rail.roll * (motion.centre_y - rail.y)
        + roll * y
        - motion.turn_y * x
        - rolling_z
    )
    strip.slip = along * inverse
    strip.lateral = (strip.cos * lateral + strip.sin * vertical) * inverse
    strip.spin = (
        strip.cos * (turn_z - motion.wheel_rate * motion.axle_z)
        - strip.sin * (motion.turn_y - motion.wheel_rate * motion.axle_y)
    ) * inverse
    strip.radius_share = share


def rolling_velocity(motion: Motion, x: float, y: float, z: float, radius: float):
    """Velocity w e2 x (P - C) [m/s] of a place (x, y, z) from the wheelset's centre, where the wheel has the
    rolling ``radius`` [m]; its three components, and the radius over the distance from the axle."""
    around_x = motion.axle_y * z - motion.axle_z * y
    around_y = motion.axle_z * x - motion.axle_x * z
    around_z = motion.axle_x * y - motion.axle_y * x
    distance = sqrt(around_x * around_x + around_y * around_y + around_z * around_z)
    rolling = motion.wheel_rate * radius / distance
    return rolling * around_x, rolling * around_y, rolling * around_z, radius / distance


def velocity_along(motion: Motion, y: float, z: float, rolling_x: float):
    """Velocity of the wheel's surface along the track [m/s] at a place y, z from the wheelset's centre."""
    return (
        motion.speed
        - motion.track_rate * (y + motion.centre_y)
        + motion.turn_y * z
        - motion.turn_z * y
        - rolling_x
    )


def velocity_across(
    motion: Motion, x: float, y_track: float, z_track: float, rolling_y: float, rolling_z: float
):
    """Velocity of the wheel's surface against the rail [m/s] at a place in the track, to the field side and down, where the
    rotation about the axle has the parts ``rolling_y`` and ``rolling_z``."""
    rail = motion.rail
    y = y_track - motion.centre_y
    z = z_track - motion.centre_z
    lateral = (
        motion.lateral
        + motion.track_rate * x
        + motion.turn_z * x
        - motion.turn_x * z
        - rolling_y
        - rail.lateral
        + rail.roll * (z_track - rail.z)
    )
    vertical = (
        motion.vertical
        + motion.turn_x * y
        - motion.turn_y * x
        - rolling_z
        - rail.vertical
        - rail.roll * (y_track - rail.y)
    )
    return lateral, vertical


def reference_speed(running: float, rolling: float):
    """The rolling speed [m/s] that creepages are referred to, of a wheelset that is ``running`` and a wheel whose surface is
    ``rolling`` [m/s] along the rail."""
    speed = 0.5 * (fabs(running) + fabs(rolling))
    return sqrt(speed * speed + REST * REST)


def approach_rate(motion: Motion, patch: Patch):
    """Speed [m/s] at which wheel and rail approach each other along a patch's normal, at its centre of load.

    Neither the rotation of a round wheel about its axle nor the course of a curve brings them closer.
    """
    rail = motion.rail
    y = patch.y_track - motion.centre_y
    z = patch.z_track - motion.centre_z
    lateral = (
        motion.lateral
        + motion.turn_z * patch.x_track
        - motion.turn_x * z
        - rail.lateral
        + rail.roll * (patch.z_track - rail.z)
    )
    vertical = (
        motion.vertical
        + motion.turn_x * y
        - motion.turn_y * patch.x_track
        - rail.vertical
        - rail.roll * (patch.y_track - rail.y)
    )
    return patch.angle_sin * lateral + patch.angle_cos * vertical
