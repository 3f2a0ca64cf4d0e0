"""What bounds the constant rail of a pose, as prepare/scan.py writes it for one that does not change, but from the ends of
its pieces alone: the second derivative of a piece is a cubic, which lies between the values of its Bezier form."""

from math import fabs
from typing import Final

from ..layout import EXPONENTS, PIECE_SIZE, Pair, RailCell, Scan, Tables, offset
from ..prepare.scan import FAR, FINE_STEP, FOOT_REACH, slope_bend
from ..prepare.scan_bends import third_fourth
from ..search.bounds import WIDEST

#: A piece that begins where a cell ends counts for it, too [m].
BESIDE: Final[float] = 1e-9


def reached_cells(cells: float):
    """How many cells a stretch reaches beyond the one that it begins in, which is as long as ``cells`` of the wheel, and the
    feet of its normals."""
    return int(1.01 + (1.0 + WIDEST) * 1.01 * cells + FOOT_REACH / FINE_STEP)


def piece_bounds(tables: "float[:]", at: int, width: float):
    """Smallest and largest second derivative [1/m] of the piece at ``at``, and its largest absolute slope [-]."""
    slope, first = slope_bend(tables, at, 0.0)
    end_slope, last = slope_bend(tables, at, width)
    rise, fourth = third_fourth(tables, at, 0.0)
    end_rise, fourth = third_fourth(tables, at, width)
    low = first + width * rise / 3.0
    high = last - width * end_rise / 3.0
    least = min(min(first, last), min(low, high))
    most = max(max(first, last), max(low, high))
    steepest = max(fabs(slope), fabs(end_slope))
    if least < 0.0 and most > 0.0:
        steepest += width * max(-least, most)
    return least, most, steepest


def write_bounds_at_pose(tables: Tables, pair: Pair, scan: Scan):
    """Bounds of the cells of the rail that is laid: as write_rail_bounds, or wider."""
    clear_cells(scan)
    at = offset(pair.rail.pieces, tables)
    start = pair.rail.start
    low = start
    while low < pair.rail.stop:
        stop = tables.raw[at + PIECE_SIZE]
        if not stop < pair.rail.stop:
            stop = pair.rail.stop
        least, most, steepest = piece_bounds(tables.raw, at, stop - low)
        turn = max(fabs(least), fabs(most)) * min(steepest, 0.5)
        first = max(int((low - start - BESIDE) / FINE_STEP), 0)
        last = min(int((stop - start + BESIDE) / FINE_STEP), scan.rail_count - 1)
        for i in range(first, last + 1):
            widen_cell(scan.rail[i], least, most, turn)
        low = stop
        at += PIECE_SIZE
    write_stretches(scan)


def clear_cells(scan: Scan):
    """Make bounds those of nothing."""
    for i in range(scan.rail_count):
        cell = scan.rail[i]
        cell.least_bend = FAR
        cell.most_bend = -FAR
        cell.turns[EXPONENTS] = 0.0


def widen_cell(cell: RailCell, least: float, most: float, turn: float):
    """Let the bounds of a cell alone hold for a piece, too; that of the turn stands at the last place meanwhile."""
    cell.least_bend = min(cell.least_bend, least)
    cell.most_bend = max(cell.most_bend, most)
    cell.turns[EXPONENTS] = max(cell.turns[EXPONENTS], turn)


def write_stretches(scan: Scan):
    """The bounds over stretches, which begin one cell before their own, from those of the cells alone: a stretch is two
    shorter ones that overlap."""
    end = scan.rail_count - 1
    reached = reached_cells(1.0)
    least_before = FAR
    most_before = -FAR
    turn_before = 0.0
    for i in range(scan.rail_count):
        cell = scan.rail[i]
        least = least_before
        most = most_before
        turn = turn_before
        least_before = cell.least_bend
        most_before = cell.most_bend
        turn_before = cell.turns[EXPONENTS]
        for k in range(i, min(i + reached, end) + 1):
            least = min(least, scan.rail[k].least_bend)
            most = max(most, scan.rail[k].most_bend)
            turn = max(turn, scan.rail[k].turns[EXPONENTS])
        cell.least_bends[0] = least
        cell.turns[0] = turn
        for k in range(min(i + reached, end) + 1, min(i + 4, end) + 1):
            least = min(least, scan.rail[k].least_bend)
            most = max(most, scan.rail[k].most_bend)
        cell.least_bend = least
        cell.most_bend = most
    cells = 1.0
    for exponent in range(1, EXPONENTS + 1):
        away = reached_cells(2.0 * cells) - reached_cells(cells)
        cells += cells
        for i in range(scan.rail_count):
            cell = scan.rail[i]
            other = scan.rail[min(i + away, end)]
            cell.least_bends[exponent] = min(cell.least_bends[exponent - 1], other.least_bends[exponent - 1])
            cell.turns[exponent] = max(cell.turns[exponent - 1], other.turns[exponent - 1])
