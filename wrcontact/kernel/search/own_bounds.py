"""Bounds of the gap's bend in a part of a cell, from the pieces of wheel and rail that it covers.

The bounds of the raster (``bounds.py``) are those of whole cells and their neighbours. Between points that
are micrometres apart, or beside a rounded corner, the pieces of a small part say far more about it.
"""

from math import fabs
from typing import Final

from ..layout import PIECE_SIZE, Pair, Piece, Place, Profile, seldom
from ..surface.tables import find_piece
from .bounds import (
    BEND_STRETCH,
    ROLL_BEND,
    ROLL_STRETCH,
    STEEP,
    STEEP_STRETCH,
    WIDEST,
    YAW_BEND,
    rail_below,
)

#: A part that covers more pieces of a profile than this is not judged.
MOST_PIECES: Final[int] = 6
TOO_MANY: Final[float] = 1e9  # in place of a slope


@seldom
def bends_between(profile: Profile, low: float, high: float):
    """Bounds of the second derivative between ``low`` and ``high`` [m] from the pieces there [1/m], and of the
    absolute slope [-]; TOO_MANY where they are more than MOST_PIECES.

    Around the middle of its part a piece's second derivative is a cubic, whose terms are bounded one by one.
    """
    piece = find_piece(profile, low)
    least = 0.0
    most = 0.0
    steepest = 0.0
    start = low
    for i in range(MOST_PIECES):
        following = Piece.at(piece, PIECE_SIZE)
        stop = high
        last = True
        if following.start < high:
            stop = following.start
            last = False
        half = 0.5 * (stop - start)
        u = 0.5 * (start + stop) - piece.start
        bend = 2.0 * piece.c2 + u * (6.0 * piece.c3 + u * (12.0 * piece.c4 + u * 20.0 * piece.c5))
        third = 6.0 * piece.c3 + u * (24.0 * piece.c4 + u * 60.0 * piece.c5)
        fourth = 24.0 * piece.c4 + u * 120.0 * piece.c5
        slope = piece.c1 + u * (
            2.0 * piece.c2 + u * (3.0 * piece.c3 + u * (4.0 * piece.c4 + u * 5.0 * piece.c5))
        )
        apart = half * (fabs(third) + half * (0.5 * fabs(fourth) + half * 20.0 * fabs(piece.c5)))
        if i == 0:
            least = bend - apart
            most = bend + apart
        least = min(least, bend - apart)
        most = max(most, bend + apart)
        steepest = max(steepest, fabs(slope) + half * (fabs(bend) + apart))
        if last:
            return least, most, steepest
        piece = following
        start = stop
    return least, most, TOO_MANY


@seldom
def own_bounds(pair: Pair, at: Place, low: float, high: float, least: float, most: float):
    """Bounds [1/m] of the rate at which the slope difference rises between ``low`` and ``high`` [m] on the
    wheel, such that (3.3) holds with them; ``least`` and ``most``, those that are known, where the part's own
    pieces say less."""
    least_wheel, most_wheel, steepest = bends_between(pair.wheel, low, high)
    roll = fabs(at.sin_roll)
    square = 0.0
    if at.yawed:
        square = at.sin_yaw * at.sin_yaw
    bend = max(fabs(least_wheel), fabs(most_wheel))
    stretch = ROLL_STRETCH * roll + square * (BEND_STRETCH * at.radius * bend + STEEP_STRETCH)
    if not (steepest < STEEP and stretch < WIDEST):
        return least, most
    width = high - low
    abscissa = rail_below(pair, at, low)
    reach = stretch * width
    least_rail, most_rail, steepest = bends_between(pair.rail, abscissa - reach, abscissa + width + reach)
    if not steepest < TOO_MANY:
        return least, most
    share = ROLL_BEND * roll + YAW_BEND * square
    own_least = least_rail - most_wheel - stretch * fabs(least_rail) - share * fabs(most_wheel)
    own_most = most_rail - least_wheel + stretch * fabs(most_rail) + share * fabs(least_wheel)
    own_most = max(own_most, 0.0) * (1.0 + stretch)
    return max(least, own_least), min(most, own_most)
