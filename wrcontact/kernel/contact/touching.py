"""Where a wheel that overlaps its rail would touch it, if it were drawn back along their common normal.

An elastic contact is a rigid one that has been pressed: the wheel stands ``depth`` deeper than where it just touches.  The
pair of points is found where the outline and the rail have one slope m and the line between them is normal to both,

    m_wheel(y) = m_rail(x),   X - x + (Z - z_rail(x)) m = 0,   depth = (Z - z_rail - m (X - x)) / sqrt(1 + m^2)

with (X, Z) the wheel's point at abscissa y as it stands.  Without overlap it is the point of the smallest vertical gap.
"""

from math import fabs, sqrt
from typing import Final

from ..layout import Place, Tables, Work
from ..surface.locus import outline_jet
from ..surface.profile_table import height_slope_bend

#: The pair is found when it moves by less [m]; its depth is then exact to rounding, being second order.
PAIR_SHARP: Final[float] = 1e-12
PAIR_ITERATIONS: Final[int] = 25
#: Longest step of the pair, and how far it may lie from where it was looked for [m].
PAIR_STEP: Final[float] = 5e-4
PAIR_REACH: Final[float] = 4e-3
#: Smallest relative bend of wheel and rail, as a share of the sum of both, for a pair to be sought between nearly conformal ones.
PAIR_BEND: Final[float] = 1e-3


def limited(step: float, limit: float):
    """``step``, no longer than ``limit`` either way."""
    if step > limit:
        step = limit
    if step < -limit:
        step = -limit
    return step


def touching_pair(tables: Tables, work: Work, at: Place, y: float, abscissa: float, shift: float):
    """Wheel and rail abscissa [m] of the pair near ``y`` and ``abscissa`` for the wheel placed at ``at`` and moved down by
    ``shift`` [m]; its depth [m], negative where they are apart; the lateral and vertical shift [m] that let it touch; and 1
    if there is such a pair, else 0."""
    rail = tables.rail
    wheel = tables.wheel
    start_y = y
    start_x = abscissa
    for i in range(PAIR_ITERATIONS):
        z, slope, bend = height_slope_bend(wheel, y)
        y_track, z_track, outline_slope, stretch, rate = outline_jet(at, y, z, slope, bend)
        height, m, rail_bend = height_slope_bend(rail, abscissa)
        across = y_track - tables.rail_y - abscissa
        down = z_track + shift - height
        turned = outline_slope - m
        apart = across + down * m
        along = stretch * (1.0 + outline_slope * m)
        back = down * rail_bend - 1.0 - m * m
        determinant = rate * back + rail_bend * along
        if not determinant > PAIR_BEND * (fabs(rate * back) + fabs(rail_bend * along)):
            return y, abscissa, 0.0, 0.0, 0.0, 0
        move_y = -(turned * back + rail_bend * apart) / determinant
        move_x = -(rate * apart - along * turned) / determinant
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
