"""Pairs of points of wheel and rail with a common normal, found in two ways for two purposes.

touching_pair   by Newton's method for both abscissae at once, from a good estimate: where a wheel that
                overlaps its rail a little, or is above it, would touch. Wheel and rail have to be bent
                towards each other.
turning_point   by a bracket on the rail, with Newton's method inside it: where the overlap of a pressed wheel
                is largest, or smallest between two largest ones. It finds one also where curvatures jump.

An elastic contact is a rigid one that has been pressed: the wheel is ``depth`` deeper than where it just
touches. In a pair the outline and the rail have one slope m and the line between both points is normal to
them,

    m_wheel(y) = m_rail(x),   X - x + (Z - z_rail(x)) m = 0,
    depth = (Z - z_rail - m (X - x)) / sqrt(1 + m^2)

with (X, Z) the wheel's point at abscissa y in its present pose. Without overlap it is the point of the
smallest vertical gap.
"""

from math import fabs, sqrt
from typing import Final

from ..layout import Frame, Place, Tables
from ..surface.locus import outline_jet
from ..surface.profile_table import height_slope, height_slope_bend
from .pressed import LINE_SHARP, normal_line

#: The pair is found when it moves by less [m]; its depth is then exact to rounding, being second order.
PAIR_SHARP: Final[float] = 1e-12
PAIR_ITERATIONS: Final[int] = 25
#: Longest step of the pair, and how far it may lie from the estimate [m].
PAIR_STEP: Final[float] = 5e-4
PAIR_REACH: Final[float] = 4e-3
#: Smallest relative bend of wheel and rail, as a share of the sum of both, for a pair to be sought between
#: nearly conformal ones.
PAIR_BEND: Final[float] = 1e-3
#: A deepest point is located to this on the rail [m], so that differences of its place between poses are its
#: derivatives; its depth, being second order, asks for less.
DEEP_SHARP: Final[float] = 1e-13
DEEP_ITERATIONS: Final[int] = 60
#: Slope of the overlap below which it has changed sign there [-]: standard profiles are joined with slopes
#: that differ by up to 1e-5.
LEVEL_RISE: Final[float] = 1e-4


def limited(step: float, limit: float):
    """``step``, no longer than ``limit`` either way."""
    if step > limit:
        step = limit
    if step < -limit:
        step = -limit
    return step


def touching_pair(tables: Tables, place: Place, y: float, abscissa: float, shift: float):
    """Wheel and rail abscissa [m] of the pair near ``y`` and ``abscissa`` for the wheel placed at ``place``
    and moved down by ``shift`` [m]; its depth [m], negative where they are apart; the lateral and vertical
    shift [m] that let it touch; and 1 if there is such a pair, else 0."""
    rail = tables.rail
    wheel = tables.wheel
    start_y = y
    start_x = abscissa
    for i in range(PAIR_ITERATIONS):
        z, slope, bend = height_slope_bend(wheel, y)
        y_track, z_track, outline_slope, stretch, rate = outline_jet(place, y, z, slope, bend)
        height, m, rail_bend = height_slope_bend(rail, abscissa)
        across = y_track - tables.rail_y - abscissa
        down = z_track + shift - height
        mismatch = outline_slope - m
        apart = across + down * m
        along = stretch * (1.0 + outline_slope * m)
        back = down * rail_bend - 1.0 - m * m
        determinant = rate * back + rail_bend * along
        if not determinant > PAIR_BEND * (fabs(rate * back) + fabs(rail_bend * along)):
            return y, abscissa, 0.0, 0.0, 0.0, 0
        move_y = -(mismatch * back + rail_bend * apart) / determinant
        move_x = -(rate * apart - along * mismatch) / determinant
        if fabs(move_y) < PAIR_SHARP and fabs(move_x) < PAIR_SHARP:
            depth = (down - m * across) / sqrt(1.0 + m * m)
            return y, abscissa, depth, -across, shift - down, 1
        y += limited(move_y, PAIR_STEP)
        abscissa += limited(move_x, PAIR_STEP)
        if fabs(y - start_y) > PAIR_REACH or fabs(abscissa - start_x) > PAIR_REACH:
            return y, abscissa, 0.0, 0.0, 0.0, 0
        if not (y > wheel.start and y < wheel.stop):
            return y, abscissa, 0.0, 0.0, 0.0, 0
        if not (abscissa > rail.start and abscissa < rail.stop):
            return y, abscissa, 0.0, 0.0, 0.0, 0
    return y, abscissa, 0.0, 0.0, 0.0, 0


def turning_point(tables: Tables, frame: Frame, place: Place, low: float, high: float, y: float,
                  height: float, sign: float):
    """Rail and wheel abscissa [m] of the largest overlap (``sign`` = 1) or the smallest (-1) between two rail
    abscissae, and the overlap [m]: Newton's method on its slope, bracketed, from the middle on.  Fourth
    value: 1 if the slope changes its sign there, else 0.

    The bend leaves out a factor (:mod:`pressed`); between nearly conformal profiles under a deep overlap
    Newton's method can then alternate between two places.  Where a step has not halved the slope, the bracket
    is halved.
    """
    x = 0.5 * (low + high)
    overlap = 0.0
    rise = 1.0
    before = 0.0
    for i in range(DEEP_ITERATIONS):
        y, overlap, rise, bend, curvature, found = normal_line(tables, frame, place, x, y, height, LINE_SHARP)
        if found == 0:
            return x, y, overlap, 0
        if sign * rise > 0.0:
            low = x
        else:
            high = x
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
    turned = 0
    if fabs(rise) < LEVEL_RISE:
        turned = 1
    return x, y, overlap, turned
