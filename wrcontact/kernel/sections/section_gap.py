"""The gap of a wheel over a rail whose section changes, by the abscissa y on the wheel and the angle phi around it.

A point of the placed wheel is P = R (r sin phi, arm + y, r cos phi) + (0, shift, -height), with R = Rz(yaw) Rx(roll), and
the gap is F = z(u + P_x, P_y) - P_z. With g = (z_u, z_y, -1), G = R^T g, O = G_1 sin phi + G_3 cos phi and
A = G_1 cos phi - G_3 sin phi,

    F_y = r_y O + G_2,  F_phi = r_phi O + r A,

and second derivatives have r_yy O, r_phiy O + r_y A, and (r_phiphi - r) O + 2 r_phi A, and in addition the quadratic form of the
rail's second derivatives between the tangents.
Where the gap of a round wheel is smallest for an abscissa, the normals of wheel and rail have the same x component l:

    cos(yaw) sin phi + sin(yaw) (cos(roll) r' + sin(roll) cos phi) = l sqrt(1 + r'^2).                         (A1)
"""

from typing import Final

from ..elementary.circle import sine_cosine
from ..layout import Pair, Place, SectionSearch
from .section_surface import section_jet
from .wheel_radius import radius_jet

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
    r, r_y, r_yy, r_f, r_fy, r_ff = radius_jet(pair, place, search.rotation, y, angle)
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
    ahead = r_f * sine + r * cosine
    level = place.sin_roll * (r * sine - r_f * cosine)
    x_f = place.cos_yaw * ahead - place.sin_yaw * level
    y_f = place.sin_yaw * ahead + place.cos_yaw * level
    at.gap = height - down
    at.across = r_y * outward + g2
    at.around = r_f * outward + r * around
    at.bend_across = z_uu * x_y * x_y + 2.0 * z_uy * x_y * y_y + z_yy * y_y * y_y + r_yy * outward
    at.twist = (
        z_uu * x_y * x_f + z_uy * (x_y * y_f + y_y * x_f) + z_yy * y_y * y_f + r_fy * outward + r_y * around
    )
    at.bend_around = z_uu * x_f * x_f + 2.0 * z_uy * x_f * y_f + z_yy * y_f * y_f
    at.bend_around += (r_ff - r) * outward + 2.0 * r_f * around
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
