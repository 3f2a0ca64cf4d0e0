"""Arc lengths of the constant rail of a pose, tabled as prepare/curvatures.py does it, but piece after piece along the rail,
and with Gauss's formula of five points from one place that is known to the next."""

from math import fabs, sqrt
from typing import Final

from ..elementary.whole import rounded_up
from ..layout import CUBIC_SIZE, PIECE_SIZE, CubicTable, Pair, Piece, Tables, offset
from ..prepare.curvatures import ARC_STEP, write_cubic
from ..prepare.pieces import FULL
from ..surface.tables import find_piece

#: Places and weights of Gauss's formula, without the middle.
PLACE_1: Final[float] = 0.5384693101056831
PLACE_2: Final[float] = 0.9061798459386640
WEIGHT_0: Final[float] = 0.5688888888888889
WEIGHT_1: Final[float] = 0.4786286704993665
WEIGHT_2: Final[float] = 0.2369268850561891
#: Newton's method for an abscissa has ended when it moves by less: the next move would be below 1e-15 [m].
SETTLED_MOVE: Final[float] = 1e-9
ABSCISSA_ITERATIONS: Final[int] = 20
#: A cell that the rail only touches, but for rounding, is none of its own [cells].
ROUNDED: Final[float] = 1e-6


def piece_speed(piece: Piece, x: float):
    """Arc length per abscissa [-] at the abscissa ``x`` [m] of a piece."""
    u = x - piece.start
    slope = piece.c1 + u * (2.0 * piece.c2 + u * (3.0 * piece.c3 + u * (4.0 * piece.c4 + u * 5.0 * piece.c5)))
    return sqrt(1.0 + slope * slope)


def piece_arc(piece: Piece, low: float, high: float):
    """Arc length [m] between two abscissae [m] of a piece."""
    middle = 0.5 * (low + high)
    half = 0.5 * (high - low)
    near = half * PLACE_1
    far = half * PLACE_2
    return half * (
        WEIGHT_0 * piece_speed(piece, middle)
        + WEIGHT_1 * (piece_speed(piece, middle - near) + piece_speed(piece, middle + near))
        + WEIGHT_2 * (piece_speed(piece, middle - far) + piece_speed(piece, middle + far))
    )


def open_cells(tables: Tables, base: int, cells: int, start: float, per_metre: float):
    """A table of ``cells`` cubics from ``start`` [m] on, at ``base``; the offset after it, or FULL."""
    table = CubicTable.at(tables.raw, base)
    end = offset(table.cells[0], tables) + CUBIC_SIZE * cells
    if end > tables.raw.shape[0]:
        return FULL
    table.count = float(cells)
    table.start = start
    table.cells_per_unit = per_metre
    return end


def lower_whole(x: float):
    """The largest whole number that is not above ``x``."""
    count = int(x)
    if float(count) > x:
        count -= 1
    return count


def write_arcs_at_pose(tables: Tables, pair: Pair, base: int):
    """The arc length of the rail over its abscissa, from where its first cell begins, at ``base``; the whole of it [m], and
    the offset after it, or FULL.

    The cells are those of the whole section, of which a part is laid: what a table is wrong at joints of the section then
    does not follow how much of it that is.
    """
    section = pair.sections
    width = section.arc_stop - section.arc_start
    count = rounded_up(width / ARC_STEP)
    step = width / float(count)
    first = lower_whole((pair.rail.start - section.arc_start) / step + ROUNDED)
    last = -lower_whole(-(pair.rail.stop - section.arc_start) / step + ROUNDED)
    start = section.arc_start + step * float(first)
    cells = last - first
    end = open_cells(tables, base, cells, start, float(count) / width)
    if end == FULL:
        return 0.0, FULL
    piece = find_piece(pair.rail, start)
    x = start
    low = 0.0
    low_rise = step * piece_speed(piece, x)
    for cell in range(cells):
        target = section.arc_start + step * float(first + cell + 1)
        high = low
        while piece.stop < target:
            high += piece_arc(piece, x, piece.stop)
            x = piece.stop
            piece = Piece.at(piece, PIECE_SIZE)
        high += piece_arc(piece, x, target)
        x = target
        high_rise = step * piece_speed(piece, x)
        write_cubic(tables, base, cell, low, high, low_rise, high_rise)
        low = high
        low_rise = high_rise
    # what the section is long from its beginning to the first cell's
    section.arc_before -= piece_arc(find_piece(pair.rail, start), start, pair.rail.start)
    return low, end


def write_abscissae_at_pose(tables: Tables, pair: Pair, base: int, total: float):
    """The abscissa of the rail over its arc length, of which there is ``total`` [m], at ``base``; the offset after it, or
    FULL.  The cells are those of the whole section here, too."""
    section = pair.sections
    whole = section.arc_total
    if not (section.cut_first or section.cut_last):
        whole = total
    count = rounded_up(whole / ARC_STEP)
    step = whole / float(count)
    first = lower_whole(section.arc_before / step + ROUNDED)
    last = -lower_whole(-(section.arc_before + total) / step + ROUNDED)
    start = step * float(first) - section.arc_before
    cells = last - first
    end = open_cells(tables, base, cells, start, float(count) / whole)
    if end == FULL:
        return FULL
    # the last place that is known, from the first cell of the arcs on
    x = pair.rail_arc.start
    piece = find_piece(pair.rail, x)
    way = 0.0
    rate = 1.0 / piece_speed(piece, x)
    before = rate
    low = x
    low_rise = step * rate
    for node in range(cells + 1):
        target = start + step * float(node)
        high = x + (target - way) * (1.5 * rate - 0.5 * before)
        for i in range(ABSCISSA_ITERATIONS):
            while high > piece.stop and piece.stop < pair.rail.stop:
                stop_way = way + piece_arc(piece, x, piece.stop)
                if stop_way > target:
                    high = piece.stop
                    break
                way = stop_way
                x = piece.stop
                piece = Piece.at(piece, PIECE_SIZE)
            move = (target - way - piece_arc(piece, x, high)) / piece_speed(piece, high)
            # not far back behind what is known
            high = max(high + move, x - step)
            if fabs(move) < SETTLED_MOVE:
                break
        way = target
        before = rate
        x = high
        rate = 1.0 / piece_speed(piece, x)
        high_rise = step * rate
        if node > 0:
            write_cubic(tables, base, node - 1, low, high, low_rise, high_rise)
        low = high
        low_rise = high_rise
    return end
