"""What the models of creep forces share: Kalker's coefficients by the shape of a patch, its length over its
width, and tractions along a strip: points, bound, and sums.

The points x_q = a cos(q pi / (n + 1)), q = 1 ... n, run from the leading edge at a to the trailing one at -a.
With the weights a pi / (n + 1) sin(q pi / (n + 1)) the bound m sqrt(a^2 - x^2) is integrated exactly.  m is
the coefficient of friction times the pressure on the strip's middle over its half-length.
"""

from math import pi, sqrt
from typing import Final

from ..elementary.powers import log
from ..layout import (
    ROLLING_STRIP_LIMIT,
    SHAPE_CELLS,
    SHAPE_PER_UNIT,
    SHAPE_ROW,
    SHAPE_START,
    Patch,
    RollingStrip,
    RollingTable,
)
from ..surface.tables import table_cell

#: Weight of a point, over a sin(...).
WEIGHT: Final[float] = 0.18479956785822313167  # pi / (POINT_LIMIT + 1)
#: Strips with a bound below this, of the patch's mean bound, carry nothing.
SLIGHT: Final[float] = 1e-12


def shape_place(axis_ratio: float):
    """Place of a/b in the table, counted in cells; beyond its ends the shape of the end is taken."""
    return (log(axis_ratio) - SHAPE_START) * SHAPE_PER_UNIT


def shape_value(table: RollingTable, column: int, place: float):
    """Value of a column, 0 ... SHAPE_COLUMNS - 1, at a place."""
    cell, u = table_cell(place, float(SHAPE_CELLS))
    at = SHAPE_ROW * cell + 4 * column
    high = table.shapes[at + 2] + u * table.shapes[at + 3]
    return table.shapes[at] + u * (table.shapes[at + 1] + u * high)


def kalker_coefficients(table: RollingTable, axis_ratio: float):
    """Kalker's creepage coefficients C11, C22, C23 of an ellipse with this a/b, length over width."""
    place = shape_place(axis_ratio)
    return (
        1.0 / shape_value(table, 0, place),
        1.0 / shape_value(table, 1, place),
        1.0 / shape_value(table, 2, place),
    )


def bound_rate(patch: Patch, strip: RollingStrip):
    """m of a strip [Pa/m]: its bound on traction is m sqrt(a^2 - x^2); 0 where the strip carries nothing."""
    a = strip.half_length
    rate = 0.0
    if strip.line_load * patch.half_width > SLIGHT * patch.totals.load and a > SLIGHT * patch.half_length:
        rate = patch.friction * 2.0 * strip.line_load / (pi * a * a)
    return rate


def cut_to(along: float, across: float, bound: float):
    """A traction, cut to its bound."""
    square = along * along + across * across
    if square > bound * bound:
        share = bound / sqrt(square)
        along *= share
        across *= share
    return along, across


def add_strip(patch: Patch, strip: RollingStrip, along: float, across: float, moment: float):
    """Add a strip's force per width [N/m] to the patch's force; ``moment`` is that of the lateral force about
    the strip's own middle, per width [N]."""
    strip.force_x = along
    strip.force_y = across
    strip.moment = moment + strip.x * across
    patch.creep_x += along * strip.width
    patch.creep_y += across * strip.width
    patch.creep_moment += (moment + strip.x * across - strip.y * along) * strip.width


def patch_area(patch: Patch):
    """Area of the strips [m^2]."""
    area = 0.0
    for i in range(ROLLING_STRIP_LIMIT):
        strip = patch.strips[i]
        area += 2.0 * strip.half_length * strip.width
    return area


def point_weight(strip: RollingStrip):
    """Weight of a point of a strip [m], over its sine."""
    return WEIGHT * strip.half_length
