"""Tractions along a strip: points, bound, and sums.

The points x_q = a cos(q pi / (n + 1)), q = 1 ... n, run from the leading edge at a to the trailing one at -a.
With the weights a pi / (n + 1) sin(q pi / (n + 1)) the bound m sqrt(a^2 - x^2) is integrated exactly.  m is
the coefficient of friction times the pressure on the strip's middle over its half-length.
"""

from math import pi, sqrt
from typing import Final

from ..layout import RollingPatch, RollingStrip

#: Weight of a point, over a sin(...).
WEIGHT: Final[float] = 0.18479956785822313167        # pi / (POINT_LIMIT + 1)
#: Strips with a bound below this, of the patch's mean bound, carry nothing.
SLIGHT: Final[float] = 1e-12


def bound_rate(rolling: RollingPatch, strip: RollingStrip):
    """m of a strip [Pa/m]: its bound on traction is m sqrt(a^2 - x^2); 0 where the strip carries nothing."""
    a = strip.half_length
    rate = 0.0
    if strip.line_load * rolling.half_width > SLIGHT * rolling.load and a > SLIGHT * rolling.half_length:
        rate = rolling.friction * 2.0 * strip.line_load / (pi * a * a)
    return rate


def cut_to(along: float, across: float, bound: float):
    """A traction, cut to its bound."""
    square = along * along + across * across
    if square > bound * bound:
        share = bound / sqrt(square)
        along *= share
        across *= share
    return along, across


def add_strip(rolling: RollingPatch, strip: RollingStrip, along: float, across: float, moment: float):
    """Add a strip's force per width [N/m] to the patch's force; ``moment`` is that of the lateral force about
    the strip's own middle, per width [N]."""
    strip.force_x = along
    strip.force_y = across
    strip.moment = moment + strip.x * across
    rolling.force_x += along * strip.width
    rolling.force_y += across * strip.width
    rolling.moment += (moment + strip.x * across - strip.y * along) * strip.width
    return 0


def patch_area(rolling: RollingPatch):
    """Area of the strips [m^2]."""
    area = 0.0
    for i in range(rolling.count):
        strip = rolling.strips[i]
        area += 2.0 * strip.half_length * strip.width
    return area


def point_weight(strip: RollingStrip):
    """Weight of a point of a strip [m], over its sine."""
    return WEIGHT * strip.half_length


