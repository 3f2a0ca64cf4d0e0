"""How far second derivatives depart from straight lines: of the wheel between the raster's nodes, and of the
rail around each of its cells.

With them two samples of an overlap bound its bend between them (contact/turning_cells.py).  From its chord
over a length L a function departs by no more than L^2 / 8 times its largest second derivative and L / 4 times
the jumps of its first one.  Where the rail's second derivative itself jumps is a joint, and the rest of it is
bounded so.
"""

from math import fabs
from typing import Final

from ..layout import PIECE_SIZE, RAIL_JOINT_SIZE, Pair, Scan, Tables, offset
from ..surface.tables import find_piece
from .pieces import FULL
from .scan import FAR, FINE_STEP, FOOT_REACH, piece_width, slope_bend

#: A cell's bounds hold for a stretch of the wheel that begins above it, and for feet of normals beside both
#: [m].
CELL_REACH: Final[float] = 1.3e-3
#: Smaller jumps of the second derivative are rounding [1/m].
LEAST_JUMP: Final[float] = 1e-3
#: A piece of the wheel is compared with the straight line at the ends of so many parts.
DEPARTURE_PARTS: Final[int] = 8


def third_fourth(tables: "float[:]", at: int, u: float):
    """Third and fourth derivative [1/m^2, 1/m^3] of the piece at ``at``, ``u`` [m] from its start."""
    c4 = tables[at + 5]
    c5 = tables[at + 6]
    return 6.0 * tables[at + 4] + u * (24.0 * c4 + u * 60.0 * c5), 24.0 * c4 + u * 120.0 * c5


def largest_fourth(tables: "float[:]", at: int, low: float, high: float):
    """Largest absolute fourth derivative [1/m^3] between two places [m] of the piece at ``at``: it is
    straight."""
    third, first = third_fourth(tables, at, low - tables[at])
    third, last = third_fourth(tables, at, high - tables[at])
    return max(fabs(first), fabs(last))


def piece_departure(tables: "float[:]", at: int, low: float, high: float, value: float, rise: float):
    """Largest departure [1/m] of the second derivative of the piece at ``at``, between ``low`` and ``high``
    [m], from the straight line that has the ``value`` at ``low`` and this ``rise`` [1/m^2]."""
    part = (high - low) / float(DEPARTURE_PARTS)
    largest = 0.0
    for i in range(DEPARTURE_PARTS + 1):
        along = part * float(i)
        slope, bend = slope_bend(tables, at, low + along - tables[at])
        largest = max(largest, fabs(bend - value - rise * along))
    return largest + 0.125 * part * part * largest_fourth(tables, at, low, high)


def write_departures(tables: Tables, pair: Pair, scan: Scan):
    """The wheel's second derivative at each node, and its departure up to the next one."""
    base = offset(pair.wheel, tables)
    for i in range(scan.count):
        node = scan.nodes[i]
        at = offset(find_piece(pair.wheel, node.y), tables)
        slope, node.bend = slope_bend(tables.raw, at, node.y - tables.raw[at])
        node.departure = 0.0
    for i in range(scan.count - 1):
        node = scan.nodes[i]
        following = scan.nodes[i + 1]
        rise = (following.bend - node.bend) / (following.y - node.y)
        at = offset(find_piece(pair.wheel, node.y), tables)
        low = node.y
        while low < following.y:
            stop = tables.raw[at] + piece_width(tables.raw, base, at)
            high = min(stop, following.y)
            departure = piece_departure(tables.raw, at, low, high, node.bend + rise * (low - node.y), rise)
            node.departure = max(node.departure, departure)
            low = stop
            at += PIECE_SIZE


def jumps_after(tables: "float[:]", base: int, at: int):
    """By how much second and third derivative [1/m, 1/m^2] jump at the end of the piece at ``at``."""
    width = piece_width(tables, base, at)
    slope, bend = slope_bend(tables, at, width)
    third, fourth = third_fourth(tables, at, width)
    slope, next_bend = slope_bend(tables, at + PIECE_SIZE, 0.0)
    next_third, fourth = third_fourth(tables, at + PIECE_SIZE, 0.0)
    return next_bend - bend, next_third - third


def write_joints(tables: Tables, pair: Pair, scan: Scan, at: int):
    """The joints of the rail at ``at``; the offset after them, or FULL."""
    base = offset(pair.rail, tables)
    last = offset(find_piece(pair.rail, pair.rail.stop), tables)
    piece = offset(pair.rail.pieces, tables)
    scan.joints = at - offset(scan, tables)
    count = 0
    while at + RAIL_JOINT_SIZE <= tables.raw.shape[0]:
        joint = scan.joints[count]
        joint.place = FAR
        joint.jump = 0.0
        if piece >= last:
            return at + RAIL_JOINT_SIZE
        jump, kink = jumps_after(tables.raw, base, piece)
        piece += PIECE_SIZE
        if fabs(jump) > LEAST_JUMP:
            joint.place = tables.raw[piece]
            joint.jump = jump
            at += RAIL_JOINT_SIZE
            count += 1
    return FULL


def write_waves(tables: Tables, pair: Pair, scan: Scan):
    """What bounds the rail's second derivative around each cell, but for its joints."""
    base = offset(pair.rail, tables)
    joint = 0
    for i in range(scan.rail_count):
        cell = scan.rail[i]
        edge = pair.rail.start + FINE_STEP * float(i)
        low = max(edge - FOOT_REACH, pair.rail.start)
        high = min(edge + FINE_STEP + CELL_REACH + FOOT_REACH, pair.rail.stop)
        while scan.joints[joint].place < low:
            joint += 1
        cell.joint = joint
        cell.wave = 0.0
        cell.kinks = 0.0
        at = offset(find_piece(pair.rail, low), tables)
        while low < high:
            stop = tables.raw[at] + piece_width(tables.raw, base, at)
            cell.wave = max(cell.wave, largest_fourth(tables.raw, at, low, min(stop, high)))
            if stop < high:
                jump, kink = jumps_after(tables.raw, base, at)
                cell.kinks += fabs(kink)
            low = stop
            at += PIECE_SIZE


def write_scan_bends(tables: Tables, pair: Pair, at: int):
    """All of it for the pair's raster, the joints at ``at``; the offset after them, or FULL."""
    scan = pair.scan
    end = write_joints(tables, pair, scan, at)
    if end != FULL:
        write_departures(tables, pair, scan)
        write_waves(tables, pair, scan)
    return end
