"""The contact locus: where a yawed wheel can touch a rail that is the same all along the track.

The wheel is a surface of revolution, the rail a cylinder along x, so their common normal has no x component.  That
leaves one angle around the wheel for every profile point (Wang 1984; closed form in docs/method.md):

    phi(y) = -atan t - asin w,   t = tan(yaw) sin(roll),   w = tan(yaw) cos(roll) r'(y) / sqrt(1 + t^2)

Seen along the track the locus is the wheel's outline, and wheel against rail becomes a problem in the (y, z) plane.
Everything here is for a right wheel; the left one comes in mirrored (conventions.MIRROR).
"""

from math import cos, sin, sqrt
from typing import Final


# where the placed wheelset stands in the array ``place``
PLACE_SHIFT: Final[int] = 0
PLACE_SIN_YAW: Final[int] = 1
PLACE_COS_YAW: Final[int] = 2
PLACE_SIN_ROLL: Final[int] = 3
PLACE_COS_ROLL: Final[int] = 4
PLACE_T: Final[int] = 5
PLACE_W_PER_SLOPE: Final[int] = 6
PLACE_COS_T: Final[int] = 7
PLACE_RADIUS: Final[int] = 8
PLACE_ARM: Final[int] = 9
PLACE_YAWED: Final[int] = 10
PLACE_SIZE: Final[int] = 11


def place_wheelset(place: 'float[:]', at: int, lateral_shift: float, yaw: float, roll: float, radius: float, arm: float):
    """Write the pose of a right wheel to ``place[at:]``; ``arm`` is half the distance of the running circles [m]."""
    place[at + PLACE_SHIFT] = lateral_shift
    place[at + PLACE_SIN_YAW] = 0.0
    place[at + PLACE_COS_YAW] = 1.0
    place[at + PLACE_YAWED] = 0.0
    if yaw != 0.0:
        place[at + PLACE_SIN_YAW] = sin(yaw)
        place[at + PLACE_COS_YAW] = cos(yaw)
        place[at + PLACE_YAWED] = 1.0
    place[at + PLACE_RADIUS] = radius
    place[at + PLACE_ARM] = arm
    turn_wheelset(place, at, roll)
    return 0


def turn_wheelset(place: 'float[:]', at: int, roll: float):
    """Give the wheelset at ``at`` another roll [rad]."""
    sin_roll = sin(roll)
    cos_roll = cos(roll)
    t = 0.0
    cos_t = 1.0
    w_per_slope = 0.0
    if place[at + PLACE_YAWED] != 0.0:
        tan_yaw = place[at + PLACE_SIN_YAW] / place[at + PLACE_COS_YAW]
        t = tan_yaw * sin_roll
        cos_t = 1.0 / sqrt(1.0 + t * t)
        w_per_slope = tan_yaw * cos_roll * cos_t
    place[at + PLACE_SIN_ROLL] = sin_roll
    place[at + PLACE_COS_ROLL] = cos_roll
    place[at + PLACE_T] = t
    place[at + PLACE_COS_T] = cos_t
    place[at + PLACE_W_PER_SLOPE] = w_per_slope
    return 0


def mirror_place(place: 'float[:]', at: int, to: int):
    """The left wheel of the wheelset at ``at`` as a right wheel at ``to``: shift, yaw and roll change sign."""
    place[to + PLACE_SHIFT] = -place[at + PLACE_SHIFT]
    place[to + PLACE_SIN_YAW] = -place[at + PLACE_SIN_YAW]
    place[to + PLACE_COS_YAW] = place[at + PLACE_COS_YAW]
    place[to + PLACE_RADIUS] = place[at + PLACE_RADIUS]
    place[to + PLACE_ARM] = place[at + PLACE_ARM]
    place[to + PLACE_YAWED] = place[at + PLACE_YAWED]
    mirror_roll(place, at, to)
    return 0


def mirror_roll(place: 'float[:]', at: int, to: int):
    """What ``turn_wheelset`` has changed, mirrored."""
    place[to + PLACE_SIN_ROLL] = -place[at + PLACE_SIN_ROLL]
    place[to + PLACE_COS_ROLL] = place[at + PLACE_COS_ROLL]
    place[to + PLACE_T] = place[at + PLACE_T]
    place[to + PLACE_COS_T] = place[at + PLACE_COS_T]
    place[to + PLACE_W_PER_SLOPE] = -place[at + PLACE_W_PER_SLOPE]
    return 0


def around_wheel(place: 'float[:]', at: int, slope: float):
    """sin and cos of the angle around the wheel where the normal of a profile point with ``slope`` has no x component.

    Where the yaw is too large for that (|w| > 1) the nearest angle, w = +-1, is taken.
    """
    w = place[at + PLACE_W_PER_SLOPE] * slope
    if w > 1.0:
        w = 1.0
    if w < -1.0:
        w = -1.0
    root = sqrt(1.0 - w * w)
    t = place[at + PLACE_T]
    cos_t = place[at + PLACE_COS_T]
    return -(t * root + w) * cos_t, (root - t * w) * cos_t


def outline_point(place: 'float[:]', at: int, y: float, z: float, slope: float):
    """Lateral and vertical track coordinate [m] and slope dz/dy [-] of the outline at wheel profile point (y, z).

    The vertical shift of the wheelset is not included: its centre is at minus the nominal radius.
    """
    sin_roll = place[at + PLACE_SIN_ROLL]
    cos_roll = place[at + PLACE_COS_ROLL]
    arm = place[at + PLACE_ARM] + y
    r = place[at + PLACE_RADIUS] + z
    if place[at + PLACE_YAWED] == 0.0:
        y_track = place[at + PLACE_SHIFT] + arm * cos_roll - r * sin_roll
        z_track = arm * sin_roll + r * cos_roll - place[at + PLACE_RADIUS]
        outline_slope = (slope * cos_roll + sin_roll) / (cos_roll - slope * sin_roll)
    else:
        sin_yaw = place[at + PLACE_SIN_YAW]
        cos_yaw = place[at + PLACE_COS_YAW]
        sin_phi, cos_phi = around_wheel(place, at, slope)
        y_track = (place[at + PLACE_SHIFT] + sin_yaw * r * sin_phi
                   + cos_yaw * (arm * cos_roll - r * cos_phi * sin_roll))
        z_track = arm * sin_roll + r * cos_phi * cos_roll - place[at + PLACE_RADIUS]
        normal_y = sin_yaw * sin_phi - cos_yaw * (slope * cos_roll + cos_phi * sin_roll)
        normal_z = cos_phi * cos_roll - slope * sin_roll
        outline_slope = -normal_y / normal_z
    return y_track, z_track, outline_slope


def outline_jet(place: 'float[:]', at: int, y: float, z: float, slope: float, bend: float):
    """``outline_point``, and along the wheel's profile the derivatives of the lateral coordinate [-] and slope [1/m]."""
    sin_roll = place[at + PLACE_SIN_ROLL]
    cos_roll = place[at + PLACE_COS_ROLL]
    arm = place[at + PLACE_ARM] + y
    r = place[at + PLACE_RADIUS] + z
    if place[at + PLACE_YAWED] == 0.0:
        y_track = place[at + PLACE_SHIFT] + arm * cos_roll - r * sin_roll
        z_track = arm * sin_roll + r * cos_roll - place[at + PLACE_RADIUS]
        stretch = cos_roll - slope * sin_roll
        outline_slope = (slope * cos_roll + sin_roll) / stretch
        slope_rate = bend / (stretch * stretch)
    else:
        sin_yaw = place[at + PLACE_SIN_YAW]
        cos_yaw = place[at + PLACE_COS_YAW]
        sin_phi, cos_phi = around_wheel(place, at, slope)
        w = place[at + PLACE_W_PER_SLOPE] * slope
        phi_rate = 0.0
        if w * w < 1.0:
            phi_rate = -place[at + PLACE_W_PER_SLOPE] * bend / sqrt(1.0 - w * w)
        y_track = (place[at + PLACE_SHIFT] + sin_yaw * r * sin_phi
                   + cos_yaw * (arm * cos_roll - r * cos_phi * sin_roll))
        z_track = arm * sin_roll + r * cos_phi * cos_roll - place[at + PLACE_RADIUS]
        stretch = (sin_yaw * (slope * sin_phi + r * cos_phi * phi_rate)
                   + cos_yaw * (cos_roll - sin_roll * (slope * cos_phi - r * sin_phi * phi_rate)))
        normal_y = sin_yaw * sin_phi - cos_yaw * (slope * cos_roll + cos_phi * sin_roll)
        normal_z = cos_phi * cos_roll - slope * sin_roll
        normal_y_rate = sin_yaw * cos_phi * phi_rate - cos_yaw * (bend * cos_roll - sin_phi * phi_rate * sin_roll)
        normal_z_rate = -sin_phi * phi_rate * cos_roll - bend * sin_roll
        outline_slope = -normal_y / normal_z
        slope_rate = -(normal_y_rate * normal_z - normal_y * normal_z_rate) / (normal_z * normal_z)
    return y_track, z_track, outline_slope, stretch, slope_rate
