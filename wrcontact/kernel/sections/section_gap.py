"""The gap of a wheel over a rail whose section changes, by the abscissa y on the wheel and the angle phi around it.

A point of the placed wheel is P = R (r sin phi, arm + y, r cos phi) + (0, shift, -height), with R = Rz(yaw) Rx(roll), and
the gap is F = z(u + P_x, P_y) - P_z. With g = (z_u, z_y, -1) and G = R^T g

    F_y = r' (G_1 sin phi + G_3 cos phi) + G_2,  F_phi = r (G_1 cos phi - G_3 sin phi),

and second derivatives have in addition the quadratic form of the rail's second derivatives between the tangents.
Where the gap is smallest for an abscissa, the normals of wheel and rail have the same x component l:

    cos(yaw) sin phi + sin(yaw) (cos(roll) r' + sin(roll) cos phi) = l sqrt(1 + r'^2).                         (A1)
"""

from typing import Final

from ..elementary.circle import sine_cosine
from ..layout import Pair, Place, SectionSearch
from ..surface.tables import height_slope_bend
from .section_surface import section_jet

#: Steps of Newton's method for the angle, and the last one [rad]: the gap is then exact to 1e-12 m.
ANGLE_STEPS: Final[int] = 6
ANGLE_SHARP: Final[float] = 1e-6


def turned_back(place: Place, along: float, slope: float):
    """G, in the wheelset's frame, for these slopes of the rail."""
    level = place.cos_yaw * slope - place.sin_yaw * along
    return (
        place.cos_yaw * along + place.sin_yaw * slope,
        place.cos_roll * level - place.sin_roll,
        -place.sin_roll * level - place.cos_roll,
    )


def compute_gap(pair: Pair, place: Place, search: SectionSearch, y: float, angle: float):
    """Write the gap at ``y`` [m] and ``angle`` [rad], and its derivatives, to ``search.at``."""
    search.gap_count += 1.0
    at = search.at
    sine, cosine = sine_cosine(angle)
    z, r_y, r_yy = height_slope_bend(pair.wheel, y)
    r = place.radius + z
    arm = place.arm + y
    across = arm * place.cos_roll - r * cosine * place.sin_roll
    at.x = place.cos_yaw * r * sine - place.sin_yaw * across
    at.y = place.shift + place.sin_yaw * r * sine + place.cos_yaw * across
    down = arm * place.sin_roll + r * cosine * place.cos_roll - place.height
    height, z_u, z_y, z_uu, z_uy, z_yy = section_jet(
        pair.sections, search.position + at.x, at.y - pair.rail_y
    )
    g1, g2, g3 = turned_back(place, z_u, z_y)
    outward = g1 * sine + g3 * cosine
    around = g1 * cosine - g3 * sine
    # x and y of the tangents by y and by the angle
    level = place.cos_roll - place.sin_roll * r_y * cosine
    x_y = place.cos_yaw * r_y * sine - place.sin_yaw * level
    y_y = place.sin_yaw * r_y * sine + place.cos_yaw * level
    level = place.sin_roll * r * sine
    x_f = place.cos_yaw * r * cosine - place.sin_yaw * level
    y_f = place.sin_yaw * r * cosine + place.cos_yaw * level
    at.gap = height - down
    at.across = r_y * outward + g2
    at.around = r * around
    at.bend_across = z_uu * x_y * x_y + 2.0 * z_uy * x_y * y_y + z_yy * y_y * y_y + r_yy * outward
    at.twist = z_uu * x_y * x_f + z_uy * (x_y * y_f + y_y * x_f) + z_yy * y_y * y_f + r_y * around
    at.bend_around = z_uu * x_f * x_f + 2.0 * z_uy * x_f * y_f + z_yy * y_f * y_f - r * outward
    at.along = z_u
    at.slope = z_y


def settled_angle(
    pair: Pair, place: Place, search: SectionSearch, y: float, angle: float, back: float, ahead: float
):
    """Newton's method for the angle of the smallest gap at ``y`` [m], between ``back`` and ``ahead`` [rad]; the gap at what
    is returned is in ``search.at``."""
    compute_gap(pair, place, search, y, angle)
    for i in range(ANGLE_STEPS):
        if not search.at.bend_around > 0.0:
            return angle
        following = min(max(angle - search.at.around / search.at.bend_around, back), ahead)
        move = following - angle
        if move * move < ANGLE_SHARP * ANGLE_SHARP:
            return angle
        angle = following
        compute_gap(pair, place, search, y, angle)
    return angle
