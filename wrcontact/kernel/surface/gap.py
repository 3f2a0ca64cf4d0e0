"""The vertical gap between a placed right wheel and its rail, along the contact locus.

gap(y) = z_rail(Y(y)) - Z(y), with the outline (Y, Z) of :mod:`locus`; positive where the wheel is above the
rail.  The wheelset stands at vertical shift zero, so contact lies at the smallest gap and the vertical shift
is that gap.
"""

from typing import Final

from ..layout import Pair, Place, inlined
from .locus import around_wheel, outline_jet, outline_point
from .tables import height_slope, height_slope_bend

#: Slope difference of a point that cannot be in contact.
FOLDED: Final[float] = 1e6


def above_rail(pair: Pair, abscissa: float) -> bool:
    """Whether the rail profile has a height at ``abscissa`` [m]."""
    rail = pair.rail
    return abscissa >= rail.start and abscissa <= rail.stop


@inlined
def vertical_gap(pair: Pair, place: Place, y: float):
    """Gap [m], slope difference rail - outline [-] and its derivative along the wheel profile [1/m] at ``y``
    [m].

    Where a strongly yawed flange root folds the outline back, a point is on the wheel but no place of
    contact: its slope difference reads FOLDED.
    """
    z, slope, bend = height_slope_bend(pair.wheel, y)
    y_track, z_track, outline_slope, stretch, outline_rate = outline_jet(place, y, z, slope, bend)
    z_rail, rail_slope, rail_bend = height_slope_bend(pair.rail, y_track - pair.rail_y)
    mismatch = rail_slope - outline_slope
    if not stretch > 0.0:
        mismatch = FOLDED
    return z_rail - z_track, mismatch, rail_bend * stretch - outline_rate


def gap_per_roll(pair: Pair, place: Place, y: float):
    """Derivative of the smallest gap with respect to roll [m], at its place ``y`` [m].

    At a minimum the place does not count (envelope theorem): it is the partial derivative at a fixed wheel
    point, z'_rail dY/droll - dZ/droll, with dY/droll = -cos(yaw) (arm sin(roll) + r cos(phi) cos(roll)) and
    dZ/droll = arm cos(roll) - r cos(phi) sin(roll).
    """
    z, slope = height_slope(pair.wheel, y)
    y_track, z_track, outline_slope = outline_point(place, y, z, slope)
    z_rail, rail_slope = height_slope(pair.rail, y_track - pair.rail_y)
    sin_phi, cos_phi = around_wheel(place, slope)
    arm = place.arm + y
    height = (place.radius + z) * cos_phi
    sin_roll = place.sin_roll
    cos_roll = place.cos_roll
    lateral = -place.cos_yaw * (arm * sin_roll + height * cos_roll)
    vertical = arm * cos_roll - height * sin_roll
    return rail_slope * lateral - vertical


def gap_jet(pair: Pair, place: Place, y: float):
    """``vertical_gap``, its and the slope difference's derivatives with respect to roll [m, 1] at a fixed
    wheel point, and the rail abscissa [m].

    The derivative of the outline's slope is the one without yaw: it sets how fast a Newton method converges,
    not where.
    """
    z, slope, bend = height_slope_bend(pair.wheel, y)
    y_track, z_track, outline_slope, stretch, outline_rate = outline_jet(place, y, z, slope, bend)
    abscissa = y_track - pair.rail_y
    z_rail, rail_slope, rail_bend = height_slope_bend(pair.rail, abscissa)
    mismatch = rail_slope - outline_slope
    if not stretch > 0.0:
        mismatch = FOLDED
    lateral = -place.cos_yaw * (z_track + place.height)
    vertical = y_track - place.shift
    if place.yawed:
        sin_phi, cos_phi = around_wheel(place, slope)
        vertical = (place.arm + y) * place.cos_roll - (place.radius + z) * cos_phi * place.sin_roll
    return (
        z_rail - z_track,
        mismatch,
        rail_bend * stretch - outline_rate,
        rail_slope * lateral - vertical,
        rail_bend * lateral - 1.0 - outline_slope * outline_slope,
        abscissa,
    )
