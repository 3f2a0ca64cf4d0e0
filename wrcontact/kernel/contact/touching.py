"""Pairs of points of wheel and rail with a common normal: where the overlap of a pressed wheel is largest, or
smallest between two largest ones.

They are found by a bracket on the rail, with Newton's method inside it, also where curvatures jump.  In a
pair the outline and the rail have one slope m and the line between both points is normal to them,

    m_wheel(y) = m_rail(x),   X - x + (Z - z_rail(x)) m = 0,
    depth = (Z - z_rail - m (X - x)) / sqrt(1 + m^2)

with (X, Z) the wheel's point at abscissa y in its present pose.
"""

from math import fabs, sqrt
from typing import Final

from ..layout import Frame, Place, Tables, seldom
from ..surface.profile_table import height_slope
from .pressed import LINE_SHARP, meet_wheel

#: A deepest point is located to this on the rail [m], so that differences of its place between poses are its
#: derivatives; its depth, being second order, asks for less.
DEEP_SHARP: Final[float] = 1e-13
DEEP_ITERATIONS: Final[int] = 60
#: Slope of the overlap below which it has changed sign there [-]: standard profiles are joined with slopes
#: that differ by up to 1e-5.
LEVEL_RISE: Final[float] = 1e-4
#: And below which it is zero but for rounding: a bracket of which one end never moved holds a turning point
#: only then.
ZERO_RISE: Final[float] = 1e-9


@seldom
def limited(step: float, limit: float):
    """``step``, no longer than ``limit`` either way."""
    if step > limit:
        step = limit
    if step < -limit:
        step = -limit
    return step


@seldom
def turning_point(tables: Tables, place: Place, low: float, high: float, y: float,
                  height: float, sign: float):
    """Rail and wheel abscissa [m] of the largest overlap (``sign`` = 1) or the smallest (-1) between two rail
    abscissae, and the overlap [m]: Newton's method on its slope, bracketed, from the middle on.  Fourth
    value: whether the slope changes its sign there: it may do so a little beyond the bracket.

    The bend leaves out a factor (:mod:`pressed`); between nearly conformal profiles under a deep overlap
    Newton's method can then alternate between two places.  Where a step has not halved the slope, the bracket
    is halved.
    """
    x = 0.5 * (low + high)
    overlap = 0.0
    rise = 1.0
    before = 0.0
    moved_low = False
    moved_high = False
    for i in range(DEEP_ITERATIONS):
        y, overlap, rise, bend, z, slope, wheel_bend, found = meet_wheel(tables, place, x, y, height,
                                                                         LINE_SHARP)
        if not found:
            return x, y, overlap, False
        if sign * rise > 0.0:
            low = x
            moved_low = True
        else:
            high = x
            moved_high = True
        following = 0.5 * (low + high)
        if sign * bend < 0.0 and (i == 0 or fabs(rise) < 0.5 * before):
            z_rail, slope = height_slope(tables.rail, x)
            newton = x - rise / (bend * sqrt(1.0 + slope * slope))
            if newton > low and newton < high:
                following = newton
        if fabs(following - x) < DEEP_SHARP:
            break
        x = following
        before = fabs(rise)
    turned = fabs(rise) < ZERO_RISE or (fabs(rise) < LEVEL_RISE and moved_low and moved_high)
    return x, y, overlap, turned
