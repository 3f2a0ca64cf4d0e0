"""Arc lengths of the curves across the track, in two ways for two purposes.

Gauss     exact to rounding, piece by piece of the profile: the arcs of the equidistant separation, which are
          compared on wheel and rail to 1e-13 m and must not depend on where a piece ends.
a table   prepared with the profiles: the stations of a pressed wheel along its rail; any coordinate is
          suitable for them that is smooth, the same at every use, and cheap.
"""

from math import sqrt
from typing import Final

from ..layout import PIECE_SIZE, Frame, Origin, Piece, Tables, seldom
from ..surface.cubic_table import read_cubic_jet, read_cubic
from ..surface.profile_table import find_piece, height_slope
from .curves import curve_profile, curve_speed

#: Gauss's abscissae and weights for six points on -1 ... 1; the kernel's pieces are shorter than their
#: own radii.
GAUSS_1: Final[float] = 0.2386191860831969
GAUSS_2: Final[float] = 0.6612093864662645
GAUSS_3: Final[float] = 0.9324695142031521
WEIGHT_1: Final[float] = 0.4679139345726910
WEIGHT_2: Final[float] = 0.3607615730481386
WEIGHT_3: Final[float] = 0.1713244923791704


@seldom
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


@seldom
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


@seldom
def rail_length(tables: Tables, start: float, stop: float):
    """Length of the rail profile between two abscissae [m], negative where ``stop`` is the smaller one."""
    return read_cubic(tables.rail_arc, stop) - read_cubic(tables.rail_arc, start)


@seldom
def rail_abscissa(tables: Tables, start: float, length: float):
    """Abscissa [m] of the rail at ``length`` [m] of arc from ``start``; beyond an end, by what is missing.

    The table of abscissae is within 1e-8 m of the other's inverse, and a step of Newton's method on that one
    leaves rounding.
    """
    rail = tables.rail
    arcs = tables.rail_arc
    abscissae = tables.rail_at_arc
    arc = read_cubic(arcs, start) + length
    if arc < 0.0:
        x = rail.start + arc
    elif arc * abscissae.cells_per_unit > abscissae.count:
        x = rail.stop + (arc - abscissae.count / abscissae.cells_per_unit)
    else:
        x = read_cubic(abscissae, arc)
        found, speed = read_cubic_jet(arcs, x)
        x += (arc - found) / speed
    return x
