"""The radius of a wheel over its abscissa y and the angle around it: that of its profile, and how far it is out of round.

A wheel that has turned by chi has at the angle phi, forward from its lowest point, the radius

    r = r_0 + z(y) + d(phi + chi, y),

with the deviation d from a table as that of a rail whose section changes, over angles instead of positions.
"""

from math import sqrt

from ..elementary.circle import STRAIGHT
from ..elementary.whole import nearest_whole
from ..layout import Pair, Place
from ..surface.tables import height_slope_bend
from .section_surface import section_jet


def within_turn(rotation: float):
    """The rotation of a wheel [rad] without whole turns."""
    return rotation - 2.0 * STRAIGHT * nearest_whole(rotation / (2.0 * STRAIGHT))


def radius_jet(pair: Pair, place: Place, rotation: float, y: float, angle: float):
    """r [m] at ``y`` [m] and ``angle`` [rad] of a wheel that is turned by ``rotation`` [rad], r_y [-], r_yy [1/m], r_phi [m],
    r_phiy [-] and r_phiphi [m]."""
    z, r_y, r_yy = height_slope_bend(pair.wheel, y)
    r = place.radius + z
    r_f = 0.0
    r_fy = 0.0
    r_ff = 0.0
    if pair.out_of_round:
        d, r_f, d_y, r_ff, r_fy, d_yy = section_jet(pair.deviation, rotation + angle, y)
        r += d
        r_y += d_y
        r_yy += d_yy
    return r, r_y, r_yy, r_f, r_fy, r_ff


def wheel_bends(
    place: Place,
    sine: float,
    cosine: float,
    r: float,
    r_y: float,
    r_yy: float,
    r_f: float,
    r_fy: float,
    r_ff: float,
):
    """Second derivatives [1/m] of the height of the placed wheel over x, x and y, and y, at a place of it.

    With the normal N = (sin phi - r_phi cos phi / r, -r_y, cos phi + r_phi sin phi / r) in the wheelset's frame, N P_yy = r_yy,
    N P_yphi = r_phiy - r_y r_phi / r, and N P_phiphi = r_phiphi - r - 2 r_phi^2 / r.
    """
    lead = r_f / r
    across = r_yy
    twist = r_fy - r_y * lead
    around = r_ff - r - 2.0 * r_f * lead
    down = cosine + lead * sine
    level_y = place.cos_roll - place.sin_roll * r_y * cosine
    level_f = -place.sin_roll * (r_f * cosine - r * sine)
    ahead_f = r_f * sine + r * cosine
    x_y = place.cos_yaw * r_y * sine - place.sin_yaw * level_y
    y_y = place.sin_yaw * r_y * sine + place.cos_yaw * level_y
    x_f = place.cos_yaw * ahead_f - place.sin_yaw * level_f
    y_f = place.sin_yaw * ahead_f + place.cos_yaw * level_f
    normal = -r_y * place.sin_roll + down * place.cos_roll
    scale = x_y * y_f - y_y * x_f
    scale = 1.0 / (scale * scale * normal)
    return (
        scale * (across * y_f * y_f - 2.0 * twist * y_y * y_f + around * y_y * y_y),
        scale * (-across * x_f * y_f + twist * (x_y * y_f + x_f * y_y) - around * x_y * y_y),
        scale * (across * x_f * x_f - 2.0 * twist * x_y * x_f + around * x_y * x_y),
    )
