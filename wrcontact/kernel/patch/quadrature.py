"""Integrals over the cells between the strips of a patch.

A cell has a value at its inner end, one at its outer end, and the value one cell further in.  Between its
ends the quadratic through the three is taken, with a limited bend (:func:`bend_of`), so that an ellipse is
integrated exactly.  A place in a cell is its share of the cell, counted from the inner end.
"""

from math import fabs, sqrt
from typing import Final

from ..elementary.circle import atan, atan2

#: Bend, as a share of the end values, below which a quadratic is expanded about its chord: leaves the square
#: of it.
STRAIGHT: Final[float] = 1e-4


def bend_of(before: float, low: float, high: float):
    """Second coefficient of the quadratic through (-1, before), (0, low), (1, high), limited to half of |low|
    + |high|.

    Unlimited it is exact for a parabola; the limit keeps it positive between positive values where the data
    has kinks.
    """
    bend = 0.5 * (before - 2.0 * low + high)
    limit = 0.5 * (fabs(low) + fabs(high))
    bend = max(min(bend, limit), -limit)
    return bend


def quadratic_value(before: float, low: float, high: float, x: float):
    """The quadratic of ``bend_of`` at x."""
    bend = bend_of(before, low, high)
    return low + x * (high - low - bend + x * bend)


def cell_part(d_before: float, d_low: float, d_high: float):
    """The loaded part [from, to] of a cell, as shares of it counted from its inner node."""
    start = 0.0
    stop = 1.0
    if d_low <= 0.0 and d_high <= 0.0:
        stop = 0.0
    elif d_low <= 0.0 or d_high <= 0.0:
        bend = bend_of(d_before, d_low, d_high)
        slope = d_high - d_low - bend
        # the root between two values of opposite sign, in the form that does not cancel
        spread = max(slope * slope - 4.0 * bend * d_low, 0.0)
        spread = sqrt(spread)
        root = 0.0
        if d_low > 0.0:
            root = 2.0 * d_low / (spread - slope)
            stop = root
        else:
            root = -2.0 * d_low / (spread + slope)
            start = root
    return start, stop


def quadratic_integral(before: float, low: float, high: float, stop: float):
    """Integral over [0, stop] of the quadratic of ``bend_of``."""
    bend = bend_of(before, low, high)
    slope = high - low - bend
    return stop * (low + stop * (slope / 2.0 + stop * bend / 3.0))


def full_cell(before: float, low: float, high: float):
    """The same over the whole cell, between values ``low`` and ``high`` above zero."""
    mean = 0.5 * (low + high)
    bend = max(min(0.5 * (before - 2.0 * low + high), mean), -mean)
    return mean - bend / 6.0


def quadratic_moment(before: float, low: float, high: float, stop: float):
    """Integral over [0, stop] of x times the quadratic of ``bend_of``."""
    bend = bend_of(before, low, high)
    slope = high - low - bend
    return stop * stop * (low / 2.0 + stop * (slope / 3.0 + stop * bend / 4.0))


def root_integral(before: float, low: float, high: float, start: float, stop: float):
    """Integral over [start, stop] of the square root of the quadratic of ``bend_of``, which is not negative
    there.

    In closed form where the quadratic bends down noticeably.  Otherwise with the roots p, q of the end values
    and the width w, expanded about the chord: w [2/3 (p^2 + p q + q^2)/(p + q) - 2/15 bend w^2 (p^2 + 3 p q +
    q^2)/(p + q)^3].
    """
    bend = bend_of(before, low, high)
    slope = high - low - bend
    if bend < -STRAIGHT * (fabs(low) + fabs(high)):
        return bent_integral(low, slope, bend, start, stop)
    first = quadratic_at(low, slope, bend, start)
    last = quadratic_at(low, slope, bend, stop)
    p = sqrt(first)
    q = sqrt(last)
    total = p + q
    if not total > 0.0:
        return 0.0
    width = stop - start
    chord = 2.0 / 3.0 * (first + p * q + last) / total
    cube = total * total * total
    return width * (chord - 2.0 / 15.0 * bend * width * width * (first + 3.0 * p * q + last) / cube)


def quadratic_at(low: float, slope: float, bend: float, x: float):
    """low + slope x + bend x^2, and 0 where rounding makes it negative."""
    value = max(low + x * (slope + x * bend), 0.0)
    return value


def bent_integral(low: float, slope: float, bend: float, start: float, stop: float):
    """Integral over [start, stop] of sqrt(low + slope x + bend x^2) for bend < 0, in closed form.

    The angle between both ends is taken from the roots themselves, not from how far x has come: at the end of
    a loaded stretch the rounding of root and angle then cancels.
    """
    first = quadratic_at(low, slope, bend, start)
    last = quadratic_at(low, slope, bend, stop)
    spread = slope * slope - 4.0 * bend * low
    if not spread > 0.0:
        return 0.0
    first_root = sqrt(first)
    last_root = sqrt(last)
    first_rate = 2.0 * bend * start + slope
    last_rate = 2.0 * bend * stop + slope
    across = sqrt(-bend)
    height = 2.0 * across * last_root
    height_before = 2.0 * across * first_root
    up = height * first_rate - height_before * last_rate
    along = height * height_before + last_rate * first_rate
    angle = 0.0
    if along > fabs(up):
        angle = atan(up / along)
    else:
        angle = atan2(up, along)
    return (last_rate * last_root - first_rate * first_root) / (4.0 * bend) + spread / (
        8.0 * -bend * across
    ) * angle
