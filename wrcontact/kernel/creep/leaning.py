"""Creepages of patches on rails whose section changes, where the normal n has a part along the track.

Equations are those of creepage.py with vectors.  At a place P of contact e1 lies along the rail in the plane of contact,
e2 to the field side, and e3 = e1 x e2 into the rail, so that n = -e3.  With the velocity v there, that of the wheel's surface
against the rail, the rotation w about the axle a, and the velocity v_c of the wheelset's centre,

    V_ref = sqrt((|v_c . e1| + |w (a x (P - C)) . e1|)^2 / 4 + V_0^2)
    xi = v . e1 / V_ref,   eta = v . e2 / V_ref,   phi = (W - w a) . e3 / V_ref

Wheel and rail approach each other at the speed v . e3, in which the rotation about the axle has no part as long as the wheel is
round and its normals meet the axle; at an angle at which its radius grows by r_theta, a wheel grows by w r_theta.  With the normal's part along the track this is

    -n . v = -(n_x V + n_y y' + n_z z' + ((P - C) x n) . W)                                     (A4)

A wheel that stays on its rail does not approach it.
"""

from ..layout import (
    ROLLING_STRIP_LIMIT,
    Leaning,
    LeaningPatch,
    Motion,
    Patch,
    RollingStrip,
    Turning,
    Vector,
)
from .creepage import reference_speed, rolling_velocity, velocity_across, velocity_along
from .turning import enclose_rate, heading_velocity


def along(direction: Vector, x: float, y: float, z: float):
    """The part of a vector along a ``direction`` of length 1."""
    return direction[0] * x + direction[1] * y + direction[2] * z


def roll_at(motion: Motion, at: Leaning, radius: float):
    """Velocity w a x (P - C) [m/s] of a place where the wheel has the rolling ``radius`` [m], and the radius over the
    distance from the axle."""
    return rolling_velocity(motion, at.x, at.y - motion.centre_y, at.z - motion.centre_z, radius)


def slide_at(motion: Motion, at: Leaning, rolling_x: float, rolling_y: float, rolling_z: float):
    """Velocity of the wheel's surface against the rail [m/s] at a place, where the rotation about the axle has this
    part."""
    lateral, vertical = velocity_across(motion, at.x, at.y, at.z, rolling_y, rolling_z)
    roller_x, roller_z = roller_slide(motion, at)
    return (
        velocity_along(motion, at.y - motion.centre_y, at.z - motion.centre_z, rolling_x) + roller_x,
        lateral,
        vertical + roller_z,
    )


def roller_slide(motion: Motion, at: Leaning):
    """What the velocity of the wheel's surface against a roller has beyond that against a rail along which the wheelset runs
    [m/s], along and down.

    The roller's surface has the velocity t (z - z_a, 0, x_a - x) with its rotation t = V / R about (x_a, z_a), and the wheelset
    does not run along it.
    """
    rail = motion.rail
    roller_x = 0.0
    roller_z = 0.0
    if rail.turn != 0.0:
        roller_x = rail.turn * (rail.axle_z - at.z) - motion.speed
        roller_z = rail.turn * (at.x - rail.axle_x)
    return roller_x, roller_z


def turn_at(motion: Motion, at: Leaning):
    """Rotation of the wheel against the rail [rad/s] about the normal into the rail."""
    rate = motion.wheel_rate
    return along(
        at.down,
        motion.turn_x - motion.rail.roll - rate * motion.axle_x,
        motion.turn_y - motion.rail.turn - rate * motion.axle_y,
        motion.turn_z + motion.track_rate - rate * motion.axle_z,
    )


def move_leaning_patch(motion: Motion, leaning: LeaningPatch, patch: Patch):
    """Rolling speed and creepages of a patch."""
    at = leaning.own
    rolling_x, rolling_y, rolling_z, share = roll_at(motion, at, patch.rolling_radius)
    slide_x, slide_y, slide_z = slide_at(motion, at, rolling_x, rolling_y, rolling_z)
    running = along(at.ahead, motion.speed, motion.lateral, motion.vertical)
    rolling = along(at.ahead, rolling_x, rolling_y, rolling_z)
    speed = reference_speed(running, rolling)
    patch.speed = speed
    patch.radius_share = share
    patch.backwards = running + rolling < 0.0
    patch.creepage_x = along(at.ahead, slide_x, slide_y, slide_z) / speed
    patch.creepage_y = along(at.aside, slide_x, slide_y, slide_z) / speed
    patch.spin = turn_at(motion, at) / speed


def move_leaning_strips(motion: Motion, leaning: LeaningPatch, patch: Patch):
    """Creepages and spin of the strips of a patch that rolls."""
    for index in range(ROLLING_STRIP_LIMIT):
        move_leaning_strip(motion, leaning.strips[index], patch.strips[index], 1.0 / patch.speed)


def move_leaning_strip(motion: Motion, at: Leaning, strip: RollingStrip, inverse: float):
    """Creepages and spin of a strip, whose patch rolls at the speed 1/``inverse`` [m/s]."""
    rolling_x, rolling_y, rolling_z, share = roll_at(motion, at, strip.rolling_radius)
    slide_x, slide_y, slide_z = slide_at(motion, at, rolling_x, rolling_y, rolling_z)
    strip.slip = along(at.ahead, slide_x, slide_y, slide_z) * inverse
    strip.lateral = along(at.aside, slide_x, slide_y, slide_z) * inverse
    strip.spin = turn_at(motion, at) * inverse
    strip.radius_share = share


def enclose_leaning_rates(turning: Turning, motion: Motion, leaning: LeaningPatch, patch: Patch):
    """Let the enclosure hold the rates of all strips of a patch, as eq. (A1) of turning.py."""
    for index in range(ROLLING_STRIP_LIMIT):
        strip = patch.strips[index]
        if strip.line_load > 0.0:
            at = leaning.strips[index]
            heading, ahead = heading_velocity(motion, at.x, at.y, at.z)
            roller_x, roller_z = roller_slide(motion, at)
            enclose_rate(turning, (heading + roller_x * ahead) / strip.rolling_radius)


def leaning_approach_rate(motion: Motion, at: Leaning):
    """Speed [m/s] at which wheel and rail approach each other at a place; eq. (A4).  The course of a curve does not bring
    them closer, as positions along the track are those of its centre line."""
    x = at.x
    y = at.y - motion.centre_y
    z = at.z - motion.centre_z
    lateral, vertical = velocity_across(motion, x, at.y, at.z, motion.track_rate * x, 0.0)
    roller_x, roller_z = roller_slide(motion, at)
    rate = along(
        at.down,
        motion.speed + motion.turn_y * z - motion.turn_z * y + roller_x,
        lateral,
        vertical + roller_z,
    )
    return rate + motion.wheel_rate * at.swelling
