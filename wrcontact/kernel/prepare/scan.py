"""The search's raster over the wheel, with the bounds that certify it.

The table is the record Scan. Scratch holds, for each piece of the profile at work, the smallest and largest
second derivative and the largest absolute slope of its samples.
"""

from math import fabs
from typing import Final

from ..elementary.whole import rounded_up
from ..layout import (
    EXPONENTS,
    PIECE_SIZE,
    RAIL_CELL_SIZE,
    SCAN_LIMIT,
    SCAN_NODE_SIZE,
    Pair,
    Profile,
    Scan,
    Setup,
    Tables,
    offset,
)
from ..search.bounds import STEEP, WIDEST
from ..surface.tables import find_piece, height_slope, height_slope_bend
from .pieces import FULL

COARSE_STEP: Final[float] = 1.0e-3  # [m]
FINE_STEP: Final[float] = 0.5e-3  # [m]
FLAT_BEND: Final[float] = 20.0  # the coarse step does where the wheel bends less [1/m]
TOO_STEEP: Final[float] = 1e9  # [1/m]
FOOT_REACH: Final[float] = 0.2e-3  # a foot lies no farther aside [m]
# samples of the second derivative in a piece, a cubic there, and of levers in a cell
LAST_SAMPLE: Final[int] = 16
TOO_WIDE: Final[int] = -2  # in place of an offset: the wheel is wider than the raster
FAR: Final[float] = 1e300


def first_piece(tables: "float[:]", base: int):
    """Offset of a profile's first piece."""
    return offset(Profile.at(tables, base).pieces, tables)


def piece_count(tables: "float[:]", base: int):
    """How many pieces a profile has."""
    return (
        offset(find_piece(Profile.at(tables, base), Profile.at(tables, base).stop), tables)
        - first_piece(tables, base)
    ) // PIECE_SIZE + 1


def piece_width(tables: "float[:]", base: int, at: int):
    """Width of the piece at ``at`` [m]."""
    stop = tables[at + PIECE_SIZE]
    if not stop < Profile.at(tables, base).stop:
        stop = Profile.at(tables, base).stop
    return stop - tables[at]


def slope_bend(tables: "float[:]", at: int, u: float):
    """Slope [-] and second derivative [1/m] of the piece at ``at``, ``u`` [m] from its start."""
    c1 = tables[at + 2]
    c2 = tables[at + 3]
    c3 = tables[at + 4]
    c4 = tables[at + 5]
    c5 = tables[at + 6]
    slope = c1 + u * (2.0 * c2 + u * (3.0 * c3 + u * (4.0 * c4 + u * 5.0 * c5)))
    bend = 2.0 * c2 + u * (6.0 * c3 + u * (12.0 * c4 + u * 20.0 * c5))
    return slope, bend


def piece_range(tables: "float[:]", at: int, width: float, low: float, high: float):
    """Smallest and largest second derivative and largest absolute slope of a piece's samples between
    ``low`` and ``high``."""
    least = FAR
    most = -FAR
    steepest = 0.0
    for k in range(LAST_SAMPLE + 1):
        u = width * (float(k) / float(LAST_SAMPLE))
        y = tables[at] + u
        if low <= y and y <= high:
            slope, bend = slope_bend(tables, at, u)
            least = min(least, bend)
            most = max(most, bend)
            steepest = max(steepest, fabs(slope))
    return least, most, steepest


def sample_pieces(tables: "float[:]", base: int, work: "float[:]", scratch: int):
    """The ranges of all pieces of a profile into scratch."""
    first = first_piece(tables, base)
    for i in range(piece_count(tables, base)):
        at = first + PIECE_SIZE * i
        least, most, steepest = piece_range(tables, at, piece_width(tables, base, at), -FAR, FAR)
        work[scratch + 3 * i] = least
        work[scratch + 3 * i + 1] = most
        work[scratch + 3 * i + 2] = steepest


def bend_range(tables: "float[:]", base: int, work: "float[:]", scratch: int, low: float, high: float):
    """Smallest and largest second derivative [1/m] and largest absolute slope [-] between ``low`` and
    ``high`` [m], clipped to the profile; every piece counts with both its ends, so that a jump of curvature
    counts with both its sides."""
    start = Profile.at(tables, base).start
    stop = Profile.at(tables, base).stop
    low = min(max(low, start), stop)
    high = min(max(high, start), stop)
    z, slope, least = height_slope_bend(Profile.at(tables, base), low)
    z, other, most = height_slope_bend(Profile.at(tables, base), high)
    steepest = max(fabs(slope), fabs(other))
    if most < least:
        bend = least
        least = most
        most = bend
    first = first_piece(tables, base)
    last = offset(find_piece(Profile.at(tables, base), high), tables)
    begin = offset(find_piece(Profile.at(tables, base), low), tables)
    at = max(begin - PIECE_SIZE, first)  # whose last sample may lie at ``low``
    while at <= last:
        piece_least = FAR
        piece_most = -FAR
        piece_steepest = 0.0
        if at > begin and at < last - PIECE_SIZE:
            i = (at - first) // PIECE_SIZE
            piece_least = work[scratch + 3 * i]
            piece_most = work[scratch + 3 * i + 1]
            piece_steepest = work[scratch + 3 * i + 2]
        else:
            piece_least, piece_most, piece_steepest = piece_range(
                tables, at, piece_width(tables, base, at), low, high
            )
        least = min(least, piece_least)
        most = max(most, piece_most)
        steepest = max(steepest, piece_steepest)
        at += PIECE_SIZE
    return least, most, steepest


def coarse_count(start: float, stop: float):
    """How many coarse steps the wheel is divided into."""
    return rounded_up((stop - start) / COARSE_STEP)


def raster_place(start: float, stop: float, count: int, i: int):
    """Abscissa [m] of coarse node ``i`` of ``count`` + 1, the ends to the last bit."""
    y = start + (stop - start) / float(count) * float(i)
    if i == count:
        y = stop
    return y


def write_raster(tables: Tables, pair: Pair, scan: Scan, work: "float[:]", scratch: int, firsts: int):
    """Abscissae of the scan nodes, no more than COARSE_STEP apart from one end of the wheel to the other,
    half as much where it is not nearly straight; the number of the first node in each coarse step goes to
    ``work`` at ``firsts``. How many nodes, or TOO_WIDE or FULL."""
    wheel = pair.wheel
    start = wheel.start
    stop = wheel.stop
    count = coarse_count(start, stop)
    step = (stop - start) / float(count)
    if offset(scan.nodes, tables) + SCAN_NODE_SIZE * (2 * count + 1) > tables.raw.shape[0]:
        return FULL
    node = 0
    for i in range(count + 1):
        y = raster_place(start, stop, count, i)
        scan.nodes[node].y = y
        work[firsts + i] = float(node)
        node += 1
        if i < count:
            least, most, steepest = bend_range(
                tables.raw, offset(wheel, tables), work, scratch, y, raster_place(start, stop, count, i + 1)
            )
            if max(fabs(least), fabs(most)) > FLAT_BEND:
                scan.nodes[node].y = y + 0.5 * step
                node += 1
    if node > SCAN_LIMIT:
        node = TOO_WIDE
    return node


def write_wheel_bounds(tables: Tables, pair: Pair, scan: Scan, count: int, work: "float[:]", scratch: int):
    """Height, slope and bounds of the nodes; stretches end with the table.

    Stretches that are steeper than the search's bounds allow get a second derivative with
    which they are not skipped.
    """
    wheel = pair.wheel
    for i in range(count):
        node = scan.nodes[i]
        y = node.y
        z, slope = height_slope(wheel, y)
        node.height = z
        node.slope = slope
        cells = 1
        for exponent in range(EXPONENTS):
            end = min(i + cells, count - 1)
            least, most, steepest = bend_range(
                tables.raw, offset(wheel, tables), work, scratch, y, scan.nodes[end].y
            )
            node.steepest_bends[exponent] = max(fabs(least), fabs(most))
            if not steepest < STEEP:
                most = TOO_STEEP
            node.most_bends[exponent] = most
            if exponent == 0:
                node.least_bend = least
            cells += cells


def write_levers(pair: Pair, scan: Scan, count: int):
    """The largest lever of each node and all beyond it: by how much the gap there would change with the roll
    of a wheelset at zero roll, if wheel and rail were parallel there."""
    largest = -FAR
    for i in range(count):
        node = scan.nodes[count - 1 - i]
        width = 0.0
        if i > 0:
            width = scan.nodes[count - i].y - node.y
        for k in range(LAST_SAMPLE):
            y = node.y + width * (float(k) / float(LAST_SAMPLE))
            z, slope = height_slope(pair.wheel, y)
            largest = max(largest, -slope * (pair.radius + z) - (pair.tables.arm + y))
        node.lever = largest


def write_rail_bounds(tables: Tables, pair: Pair, scan: Scan, work: "float[:]", scratch: int):
    """Bounds of the rail's raster.

    A stretch starts in a raster cell and is as long as 1, 2, 4 ... FINE_STEPs of the
    wheel, stretched by WIDEST.
    """
    rail = offset(pair.rail, tables)
    for i in range(scan.rail_count):
        cell = scan.rail[i]
        edge = pair.rail.start + FINE_STEP * float(i)
        least, most, steepest = bend_range(
            tables.raw, rail, work, scratch, edge - FINE_STEP, edge + FINE_STEP + 1.5 * COARSE_STEP
        )
        cell.least_bend = least
        cell.most_bend = most
        cells = 1.0
        for exponent in range(EXPONENTS + 1):
            length = FINE_STEP * (1.01 + (1.0 + WIDEST) * 1.01 * cells)
            least, most, steepest = bend_range(
                tables.raw, rail, work, scratch, edge - 0.01 * FINE_STEP, edge + length
            )
            cell.least_bends[exponent] = least
            least, most, steepest = bend_range(
                tables.raw, rail, work, scratch, edge - FOOT_REACH, edge + length + FOOT_REACH
            )
            # s / (1 + s^2) is below s, and nowhere above a half
            cell.turns[exponent] = max(fabs(least), fabs(most)) * min(steepest, 0.5)
            cells += cells


def write_scan(setup: Setup, tables: Tables, pair: Pair, at: int, work: "float[:]"):
    """The raster over wheel and rail at ``at``, and where the pair finds it; the offset after it, or
    TOO_WIDE or FULL."""
    scratch = 0
    pair.scan = Scan.at(tables, at)
    scan = pair.scan
    wheel = pair.wheel
    rail = pair.rail
    pieces = max(
        piece_count(tables.raw, offset(wheel, tables)), piece_count(tables.raw, offset(rail, tables))
    )
    firsts = scratch + 3 * pieces
    sample_pieces(tables.raw, offset(wheel, tables), work, scratch)
    count = write_raster(tables, pair, scan, work, scratch, firsts)
    if count == TOO_WIDE:
        setup.width = wheel.stop - wheel.start
    if count < 0:
        return count
    bins = coarse_count(wheel.start, wheel.stop)
    cells = rounded_up((rail.stop - rail.start) / FINE_STEP)
    scan.count = count
    scan.rail_count = cells
    scan.rail_start = rail.start
    scan.rail_per_metre = 1.0 / FINE_STEP
    scan.rail = offset(scan.nodes, scan) + SCAN_NODE_SIZE * count
    scan.bins = offset(scan.rail, scan) + RAIL_CELL_SIZE * cells
    scan.bin_count = bins
    scan.bins_per_metre = float(bins) / (wheel.stop - wheel.start)
    end = offset(scan.bins, tables) + bins
    if end > tables.raw.shape[0]:
        return FULL
    write_wheel_bounds(tables, pair, scan, count, work, scratch)
    write_levers(pair, scan, count)
    least, most, steepest = bend_range(
        tables.raw, offset(wheel, tables), work, scratch, wheel.start, wheel.stop
    )
    scan.steepest = steepest
    sample_pieces(tables.raw, offset(rail, tables), work, scratch)
    write_rail_bounds(tables, pair, scan, work, scratch)
    for i in range(bins):
        scan.bins[i] = work[firsts + i]
    return end
