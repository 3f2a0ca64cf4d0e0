"""The contact locus: where a yawed wheel can touch a rail that is the same all along the track.

The wheel is a surface of revolution, the rail a cylinder along x, so their common normal has no x component.
That leaves one angle around the wheel for every profile point (Wang 1984; closed form in
docs/theory):

    phi(y) = -atan t - asin w,   t = tan(yaw) sin(roll),   w = tan(yaw) cos(roll) r'(y) / sqrt(1 + t^2)

Seen along the track the locus is the wheel's outline, and wheel against rail becomes a problem in the (y, z)
plane. Everything here is for a right wheel; the left one comes in mirrored (conventions.MIRROR).
"""

from math import sqrt

from ..elementary.circle import sine_cosine
from ..layout import Pair, Place, inlined
from .tables import height_slope


def place_wheelset(
    place: Place, lateral_shift: float, yaw: float, roll: float, radius: float, height: float, arm: float
):
    """Write the pose of a right wheel of this nominal ``radius`` to ``place``; the wheelset's centre has the
    ``height`` over the running circles, and ``arm`` is half their distance [m]."""
    place.shift = lateral_shift
    place.sin_yaw = 0.0
    place.cos_yaw = 1.0
    place.yawed = False
    if yaw != 0.0:
        sine, cosine = sine_cosine(yaw)
        place.sin_yaw = sine
        place.cos_yaw = cosine
        place.yawed = True
    place.radius = radius
    place.height = height
    place.arm = arm
    place.rail_lateral = 0.0
    place.rail_vertical = 0.0
    place.leaning = False
    place.rail_sin = 0.0
    turn_wheelset(place, roll)


def turn_wheelset(place: Place, roll: float):
    """Give a placed wheelset another roll [rad]."""
    sine, cosine = sine_cosine(roll)
    set_roll(place, sine, cosine)


def set_roll(place: Place, sin_roll: float, cos_roll: float):
    """Give a placed wheelset the roll with this sine and cosine, and what (2.2) needs of it."""
    t = 0.0
    cos_t = 1.0
    w_per_slope = 0.0
    if place.yawed:
        tan_yaw = place.sin_yaw / place.cos_yaw
        t = tan_yaw * sin_roll
        cos_t = 1.0 / sqrt(1.0 + t * t)
        w_per_slope = tan_yaw * cos_roll * cos_t
    place.sin_roll = sin_roll
    place.cos_roll = cos_roll
    place.t = t
    place.cos_t = cos_t
    place.w_per_slope = w_per_slope


def mirror_place(place: Place, mirrored: Place, radius: float):
    """The left wheel of the wheelset at ``place``, with its nominal ``radius`` [m], as a right wheel at
    ``mirrored``: shift, yaw and roll change sign."""
    mirrored.shift = -place.shift
    mirrored.sin_yaw = -place.sin_yaw
    mirrored.cos_yaw = place.cos_yaw
    mirrored.radius = radius
    mirrored.height = place.height
    mirrored.arm = place.arm
    mirrored.yawed = place.yawed
    mirrored.leaning = False
    mirrored.rail_sin = 0.0
    mirror_roll(place, mirrored)


def mirror_roll(place: Place, mirrored: Place):
    """What ``turn_wheelset`` has changed, mirrored."""
    mirrored.sin_roll = -place.sin_roll
    mirrored.cos_roll = place.cos_roll
    mirrored.t = place.t
    mirrored.cos_t = place.cos_t
    mirrored.w_per_slope = -place.w_per_slope


@inlined
def around_wheel(place: Place, slope: float):
    """sin and cos of the angle around the wheel where the normal of a profile point with ``slope`` has no x
    component.

    Where the yaw is too large for that (|w| > 1) the nearest angle, w = +-1, is taken.
    """
    w = max(min(place.w_per_slope * slope, 1.0), -1.0)
    root = sqrt(1.0 - w * w)
    t = place.t
    cos_t = place.cos_t
    return -(t * root + w) * cos_t, (root - t * w) * cos_t


@inlined
def outline_point(place: Place, y: float, z: float, slope: float):
    """Lateral and vertical track coordinate [m] and slope dz/dy [-] of the outline at the wheel's profile
    point (y, z).

    They are those of a rail that is not moved. The vertical shift of the wheelset is not included: its centre
    is at minus ``place.height``.
    """
    sin_roll = place.sin_roll
    cos_roll = place.cos_roll
    arm = place.arm + y
    r = place.radius + z
    if not place.yawed:
        y_track = place.shift + arm * cos_roll - r * sin_roll
        z_track = arm * sin_roll + r * cos_roll - place.height
        outline_slope = (slope * cos_roll + sin_roll) / (cos_roll - slope * sin_roll)
    else:
        sin_yaw = place.sin_yaw
        cos_yaw = place.cos_yaw
        sin_phi, cos_phi = around_wheel(place, slope)
        y_track = place.shift + sin_yaw * r * sin_phi + cos_yaw * (arm * cos_roll - r * cos_phi * sin_roll)
        z_track = arm * sin_roll + r * cos_phi * cos_roll - place.height
        normal_y = sin_yaw * sin_phi - cos_yaw * (slope * cos_roll + cos_phi * sin_roll)
        normal_z = cos_phi * cos_roll - slope * sin_roll
        outline_slope = -normal_y / normal_z
    return y_track, z_track, outline_slope


@inlined
def outline_jet(place: Place, y: float, z: float, slope: float, bend: float):
    """``outline_point``, and along the wheel's profile the derivatives of the lateral coordinate [-] and
    slope [1/m]. (Both are written out: a search calls the shorter one most.)"""
    sin_roll = place.sin_roll
    cos_roll = place.cos_roll
    arm = place.arm + y
    r = place.radius + z
    if not place.yawed:
        y_track = place.shift + arm * cos_roll - r * sin_roll
        z_track = arm * sin_roll + r * cos_roll - place.height
        stretch = cos_roll - slope * sin_roll
        outline_slope = (slope * cos_roll + sin_roll) / stretch
        slope_rate = bend / (stretch * stretch)
    else:
        sin_yaw = place.sin_yaw
        cos_yaw = place.cos_yaw
        # around_wheel, whose root the angle's rate needs too
        w = max(min(place.w_per_slope * slope, 1.0), -1.0)
        root = sqrt(1.0 - w * w)
        sin_phi = -(place.t * root + w) * place.cos_t
        cos_phi = (root - place.t * w) * place.cos_t
        phi_rate = 0.0
        if root > 0.0:
            phi_rate = -place.w_per_slope * bend / root
        y_track = place.shift + sin_yaw * r * sin_phi + cos_yaw * (arm * cos_roll - r * cos_phi * sin_roll)
        z_track = arm * sin_roll + r * cos_phi * cos_roll - place.height
        stretch = sin_yaw * (slope * sin_phi + r * cos_phi * phi_rate) + cos_yaw * (
            cos_roll - sin_roll * (slope * cos_phi - r * sin_phi * phi_rate)
        )
        normal_y = sin_yaw * sin_phi - cos_yaw * (slope * cos_roll + cos_phi * sin_roll)
        normal_z = cos_phi * cos_roll - slope * sin_roll
        normal_y_rate = sin_yaw * cos_phi * phi_rate - cos_yaw * (
            bend * cos_roll - sin_phi * phi_rate * sin_roll
        )
        normal_z_rate = -sin_phi * phi_rate * cos_roll - bend * sin_roll
        outline_slope = -normal_y / normal_z
        slope_rate = -(normal_y_rate + outline_slope * normal_z_rate) / normal_z
    return y_track, z_track, outline_slope, stretch, slope_rate


def outline_x(pair: Pair, place: Place, y: float):
    """Track coordinate x [m] of the outline at wheel abscissa ``y`` [m], from the middle of the wheelset."""
    z, slope = height_slope(pair.wheel, y)
    sin_phi, cos_phi = around_wheel(place, slope)
    r = place.radius + z
    lateral = (place.arm + y) * place.cos_roll - r * cos_phi * place.sin_roll
    return place.cos_yaw * r * sin_phi - place.sin_yaw * lateral
