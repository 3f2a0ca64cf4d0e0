"""Arc lengths of the curves across the track, in two ways for two purposes.

Gauss     exact to rounding, piece by piece of the profile: the arcs of the equidistant separation, which are
          compared on wheel and rail to 1e-13 m and must not depend on where a piece ends.
Simpson   an evaluation for each half millimetre: the stations of a pressed wheel along its rail; any
          coordinate is suitable for them that is smooth, the same at every use, and cheap.
"""

from math import fabs, sqrt
from typing import Final

from ..layout import PIECE_SIZE, Frame, Origin, Piece, Tables
from ..surface.profile_table import find_piece, height_slope, height_slope_bend
from .curves import curve_profile, curve_speed

#: Gauss's abscissae and weights for six points on -1 ... 1; the kernel's pieces are shorter than their
#: own radii.
GAUSS_1: Final[float] = 0.2386191860831969
GAUSS_2: Final[float] = 0.6612093864662645
GAUSS_3: Final[float] = 0.9324695142031521
WEIGHT_1: Final[float] = 0.4679139345726910
WEIGHT_2: Final[float] = 0.3607615730481386
WEIGHT_3: Final[float] = 0.1713244923791704
#: Simpson's rule is applied to stretches of no more than this [m].
SIMPSON_STEP: Final[float] = 1e-3
#: The rail's abscissa is found when Newton's last move is no longer than this [m]; the error is of
#: second order in it.
SIMPSON_SHARP: Final[float] = 1e-9
SIMPSON_ITERATIONS: Final[int] = 20


def panel_length(tables: Tables, frame: Frame, origin: Origin, curve: int, low: float, high: float):
    """Arc length [m] between abscissae within one piece of the profile, by Gauss's
    formula with six points."""
    middle = 0.5 * (low + high)
    half = 0.5 * (high - low)
    total = 0.0
    for i in range(-1, 2, 2):
        side = half * float(i)
        for k in range(3):
            away = GAUSS_1
            weight = WEIGHT_1
            if k == 1:
                away = GAUSS_2
                weight = WEIGHT_2
            if k == 2:
                away = GAUSS_3
                weight = WEIGHT_3
            total += weight * curve_speed(tables, frame, origin, curve, middle + side * away)
    return half * total


def arc_length(tables: Tables, frame: Frame, origin: Origin, curve: int, start: float, stop: float):
    """Arc length [m] of a curve from abscissa ``start`` to ``stop``, negative where
    ``stop`` is the smaller one.

    Piece by piece: within one the curve has all derivatives, at the ends its curvature may jump.
    """
    low = start
    high = stop
    if stop < start:
        low = stop
        high = start
    total = 0.0
    piece = find_piece(curve_profile(tables, curve), low)
    while low < high:
        end = high
        piece = Piece.at(piece, PIECE_SIZE)
        if piece.start < high:
            end = piece.start
        total += panel_length(tables, frame, origin, curve, low, end)
        low = end
    if stop < start:
        total = -total
    return total


def rail_speed(tables: Tables, abscissa: float):
    """Arc length per abscissa of the rail [-]."""
    height, slope = height_slope(tables.rail, abscissa)
    return sqrt(1.0 + slope * slope)


def rail_length(tables: Tables, start: float, stop: float):
    """Length of the rail profile between two abscissae [m] by Simpson's rule, negative where ``stop`` is the
    smaller one."""
    cells = int(fabs(stop - start) / SIMPSON_STEP) + 1
    step = (stop - start) / float(cells)
    total = 0.0
    low = rail_speed(tables, start)
    for i in range(cells):
        begin = start + step * float(i)
        middle = rail_speed(tables, begin + 0.5 * step)
        high = rail_speed(tables, begin + step)
        total += low + 4.0 * middle + high
        low = high
    return total * step / 6.0


def rail_abscissa(tables: Tables, start: float, length: float):
    """Abscissa [m] of the rail at ``length`` [m] of arc from ``start``, in steps of no more than
    SIMPSON_STEP: a parabola gives a first estimate, and Newton's method on Simpson's rule the result."""
    steps = int(fabs(length) / SIMPSON_STEP) + 1
    way = length / float(steps)
    x = start
    for step in range(steps):
        height, slope, bend = height_slope_bend(tables.rail, x)
        before = sqrt(1.0 + slope * slope)
        cosine = 1.0 / before
        following = x + way * cosine * (1.0 - 0.5 * way * slope * bend * cosine * cosine * cosine)
        for i in range(SIMPSON_ITERATIONS):
            middle = rail_speed(tables, 0.5 * (x + following))
            after = rail_speed(tables, following)
            move = (way - (following - x) * (before + 4.0 * middle + after) / 6.0) / after
            following += move
            if fabs(move) < SIMPSON_SHARP:
                break
        x = following
    return x
