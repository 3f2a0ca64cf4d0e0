"""The contact locus: where a yawed wheel can touch a rail that is the same all along the track.

The wheel is a surface of revolution, the rail a cylinder along x, so their common normal has no x component.  That
leaves one angle around the wheel for every profile point (Wang 1984; closed form in docs/method.md):

    phi(y) = -atan t - asin w,   t = tan(yaw) sin(roll),   w = tan(yaw) cos(roll) r'(y) / sqrt(1 + t^2)

Seen along the track the locus is the wheel's outline, and wheel against rail becomes a problem in the (y, z) plane.
Everything here is for a right wheel; the left one comes in mirrored (conventions.MIRROR).
"""

from math import cos, sin, sqrt

from ..layout import Place


def place_wheelset(at: Place, lateral_shift: float, yaw: float, roll: float, radius: float, arm: float):
    """Write the pose of a right wheel to ``at``; ``arm`` is half the distance of the running circles [m]."""
    at.shift = lateral_shift
    at.sin_yaw = 0.0
    at.cos_yaw = 1.0
    at.yawed = False
    if yaw != 0.0:
        at.sin_yaw = sin(yaw)
        at.cos_yaw = cos(yaw)
        at.yawed = True
    at.radius = radius
    at.arm = arm
    turn_wheelset(at, roll)
    return 0


def turn_wheelset(at: Place, roll: float):
    """Give the wheelset at ``at`` another roll [rad]."""
    sin_roll = sin(roll)
    cos_roll = cos(roll)
    t = 0.0
    cos_t = 1.0
    w_per_slope = 0.0
    if at.yawed:
        tan_yaw = at.sin_yaw / at.cos_yaw
        t = tan_yaw * sin_roll
        cos_t = 1.0 / sqrt(1.0 + t * t)
        w_per_slope = tan_yaw * cos_roll * cos_t
    at.sin_roll = sin_roll
    at.cos_roll = cos_roll
    at.t = t
    at.cos_t = cos_t
    at.w_per_slope = w_per_slope
    return 0


def mirror_place(at: Place, to: Place):
    """The left wheel of the wheelset at ``at`` as a right wheel at ``to``: shift, yaw and roll change sign."""
    to.shift = -at.shift
    to.sin_yaw = -at.sin_yaw
    to.cos_yaw = at.cos_yaw
    to.radius = at.radius
    to.arm = at.arm
    to.yawed = at.yawed
    mirror_roll(at, to)
    return 0


def mirror_roll(at: Place, to: Place):
    """What ``turn_wheelset`` has changed, mirrored."""
    to.sin_roll = -at.sin_roll
    to.cos_roll = at.cos_roll
    to.t = at.t
    to.cos_t = at.cos_t
    to.w_per_slope = -at.w_per_slope
    return 0


def around_wheel(at: Place, slope: float):
    """sin and cos of the angle around the wheel where the normal of a profile point with ``slope`` has no x component.

    Where the yaw is too large for that (|w| > 1) the nearest angle, w = +-1, is taken.
    """
    w = at.w_per_slope * slope
    if w > 1.0:
        w = 1.0
    if w < -1.0:
        w = -1.0
    root = sqrt(1.0 - w * w)
    t = at.t
    cos_t = at.cos_t
    return -(t * root + w) * cos_t, (root - t * w) * cos_t


def outline_point(at: Place, y: float, z: float, slope: float):
    """Lateral and vertical track coordinate [m] and slope dz/dy [-] of the outline at wheel profile point (y, z).

    The vertical shift of the wheelset is not included: its centre is at minus the nominal radius.
    """
    sin_roll = at.sin_roll
    cos_roll = at.cos_roll
    arm = at.arm + y
    r = at.radius + z
    if not at.yawed:
        y_track = at.shift + arm * cos_roll - r * sin_roll
        z_track = arm * sin_roll + r * cos_roll - at.radius
        outline_slope = (slope * cos_roll + sin_roll) / (cos_roll - slope * sin_roll)
    else:
        sin_yaw = at.sin_yaw
        cos_yaw = at.cos_yaw
        sin_phi, cos_phi = around_wheel(at, slope)
        y_track = (at.shift + sin_yaw * r * sin_phi
                   + cos_yaw * (arm * cos_roll - r * cos_phi * sin_roll))
        z_track = arm * sin_roll + r * cos_phi * cos_roll - at.radius
        normal_y = sin_yaw * sin_phi - cos_yaw * (slope * cos_roll + cos_phi * sin_roll)
        normal_z = cos_phi * cos_roll - slope * sin_roll
        outline_slope = -normal_y / normal_z
    return y_track, z_track, outline_slope


def outline_jet(at: Place, y: float, z: float, slope: float, bend: float):
    """``outline_point``, and along the wheel's profile the derivatives of the lateral coordinate [-] and slope [1/m]."""
    sin_roll = at.sin_roll
    cos_roll = at.cos_roll
    arm = at.arm + y
    r = at.radius + z
    if not at.yawed:
        y_track = at.shift + arm * cos_roll - r * sin_roll
        z_track = arm * sin_roll + r * cos_roll - at.radius
        stretch = cos_roll - slope * sin_roll
        outline_slope = (slope * cos_roll + sin_roll) / stretch
        slope_rate = bend / (stretch * stretch)
    else:
        sin_yaw = at.sin_yaw
        cos_yaw = at.cos_yaw
        sin_phi, cos_phi = around_wheel(at, slope)
        w = at.w_per_slope * slope
        phi_rate = 0.0
        if w * w < 1.0:
            phi_rate = -at.w_per_slope * bend / sqrt(1.0 - w * w)
        y_track = (at.shift + sin_yaw * r * sin_phi
                   + cos_yaw * (arm * cos_roll - r * cos_phi * sin_roll))
        z_track = arm * sin_roll + r * cos_phi * cos_roll - at.radius
        stretch = (sin_yaw * (slope * sin_phi + r * cos_phi * phi_rate)
                   + cos_yaw * (cos_roll - sin_roll * (slope * cos_phi - r * sin_phi * phi_rate)))
        normal_y = sin_yaw * sin_phi - cos_yaw * (slope * cos_roll + cos_phi * sin_roll)
        normal_z = cos_phi * cos_roll - slope * sin_roll
        normal_y_rate = sin_yaw * cos_phi * phi_rate - cos_yaw * (bend * cos_roll - sin_phi * phi_rate * sin_roll)
        normal_z_rate = -sin_phi * phi_rate * cos_roll - bend * sin_roll
        outline_slope = -normal_y / normal_z
        slope_rate = -(normal_y_rate * normal_z - normal_y * normal_z_rate) / (normal_z * normal_z)
    return y_track, z_track, outline_slope, stretch, slope_rate
