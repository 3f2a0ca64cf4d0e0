"""The search's raster over the wheel, with the bounds that certify it.

Layout in search.py.  Scratch holds, for each piece of the profile at work, the smallest and largest second derivative and the
largest absolute slope of its samples.
"""

from math import ceil, fabs
from typing import Final

from ..layout import PIECE_SIZE, SCAN_LIMIT, Profile, Tables, offset
from ..search.search import (
    LEVELS,
    RAIL_LEAST_BEND,
    RAIL_LEAST_BENDS,
    RAIL_MOST_BEND,
    RAIL_ROW,
    ROW_HEIGHT,
    ROW_LEAST_BEND,
    ROW_LEVER,
    ROW_MOST_BENDS,
    ROW_SLOPE,
    ROW_STEEPEST_BENDS,
    ROW_Y,
    SCAN_BIN_COUNT,
    SCAN_BIN_OFFSET,
    SCAN_BINS_PER_METRE,
    SCAN_COUNT,
    SCAN_NODES,
    SCAN_RAIL_COUNT,
    SCAN_RAIL_OFFSET,
    SCAN_RAIL_PER_METRE,
    SCAN_RAIL_START,
    SCAN_ROW,
    SCAN_STEEPEST,
    STEEP,
    WIDEST,
)
from ..surface.profile_table import find_piece, height_slope, height_slope_bend
from .pieces import FULL

COARSE_STEP: Final[float] = 1.0e-3        # [m]
FINE_STEP: Final[float] = 0.5e-3          # [m]
STRAIGHT: Final[float] = 20.0             # the coarse step does where the wheel bends less [1/m]
TOO_STEEP: Final[float] = 1e9             # [1/m]
LAST_SAMPLE: Final[int] = 16              # samples of the second derivative in a piece, a cubic there, and of levers in a cell
TOO_WIDE: Final[int] = -2                 # in place of an offset: the wheel is wider than the raster
FAR: Final[float] = 1e300


def first_piece(tables: 'float[:]', base: int):
    """Offset of a profile's first piece."""
    return offset(Profile.at(tables, base).pieces, tables)


def piece_count(tables: 'float[:]', base: int):
    """How many pieces a profile has."""
    return (offset(find_piece(Profile.at(tables, base), Profile.at(tables, base).stop), tables) - first_piece(tables, base)) // PIECE_SIZE + 1


def piece_width(tables: 'float[:]', base: int, at: int):
    """Width of the piece at ``at`` [m]."""
    stop = tables[at + PIECE_SIZE]
    if not stop < Profile.at(tables, base).stop:
        stop = Profile.at(tables, base).stop
    return stop - tables[at]


def slope_bend(tables: 'float[:]', at: int, u: float):
    """Slope [-] and second derivative [1/m] of the piece at ``at``, ``u`` [m] from its start."""
    c1 = tables[at + 2]
    c2 = tables[at + 3]
    c3 = tables[at + 4]
    c4 = tables[at + 5]
    c5 = tables[at + 6]
    slope = c1 + u * (2.0 * c2 + u * (3.0 * c3 + u * (4.0 * c4 + u * 5.0 * c5)))
    bend = 2.0 * c2 + u * (6.0 * c3 + u * (12.0 * c4 + u * 20.0 * c5))
    return slope, bend


def piece_range(tables: 'float[:]', at: int, width: float, low: float, high: float):
    """Smallest and largest second derivative and largest absolute slope of a piece's samples between ``low`` and ``high``."""
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


def sample_pieces(tables: 'float[:]', base: int, work: 'float[:]', scratch: int):
    """The ranges of all pieces of a profile into scratch."""
    first = first_piece(tables, base)
    for i in range(piece_count(tables, base)):
        at = first + PIECE_SIZE * i
        least, most, steepest = piece_range(tables, at, piece_width(tables, base, at), -FAR, FAR)
        work[scratch + 3 * i] = least
        work[scratch + 3 * i + 1] = most
        work[scratch + 3 * i + 2] = steepest
    return 0


def bend_range(tables: 'float[:]', base: int, work: 'float[:]', scratch: int, low: float, high: float):
    """Smallest and largest second derivative [1/m] and largest absolute slope [-] between ``low`` and ``high`` [m], clipped to
    the profile; every piece counts with both its ends, so that a jump of curvature counts with both its sides."""
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
    at = max(begin - PIECE_SIZE, first)          # whose last sample may lie at ``low``
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
            piece_least, piece_most, piece_steepest = piece_range(tables, at, piece_width(tables, base, at), low, high)
        least = min(least, piece_least)
        most = max(most, piece_most)
        steepest = max(steepest, piece_steepest)
        at += PIECE_SIZE
    return least, most, steepest


def coarse_count(start: float, stop: float):
    """How many coarse steps the wheel is divided into."""
    return int(ceil((stop - start) / COARSE_STEP))


def raster_place(start: float, stop: float, count: int, i: int):
    """Abscissa [m] of coarse node ``i`` of ``count`` + 1, the ends to the last bit."""
    y = start + (stop - start) / float(count) * float(i)
    if i == count:
        y = stop
    return y


def write_raster(tables: 'float[:]', base: int, wheel: int, work: 'float[:]', scratch: int, firsts: int):
    """Abscissae of the scan nodes, no more than COARSE_STEP apart from one end of the wheel to the other, half as much where it
    is not nearly straight; the number of the first node in each coarse step goes to ``work`` at ``firsts``.  How many nodes,
    or TOO_WIDE or FULL."""
    start = Profile.at(tables, wheel).start
    stop = Profile.at(tables, wheel).stop
    count = coarse_count(start, stop)
    step = (stop - start) / float(count)
    if base + SCAN_NODES + SCAN_ROW * (2 * count + 1) > tables.shape[0]:
        return FULL
    node = 0
    for i in range(count + 1):
        y = raster_place(start, stop, count, i)
        tables[base + SCAN_NODES + SCAN_ROW * node + ROW_Y] = y
        work[firsts + i] = float(node)
        node += 1
        if i < count:
            least, most, steepest = bend_range(tables, wheel, work, scratch, y,
                                                raster_place(start, stop, count, i + 1))
            if max(fabs(least), fabs(most)) > STRAIGHT:
                tables[base + SCAN_NODES + SCAN_ROW * node + ROW_Y] = y + 0.5 * step
                node += 1
    if node > SCAN_LIMIT:
        node = TOO_WIDE
    return node


def write_wheel_rows(tables: 'float[:]', base: int, wheel: int, count: int, work: 'float[:]', scratch: int):
    """Height, slope and bounds of the nodes; stretches end with the table.

    Stretches that are steeper than the search's bounds allow get a second derivative with which they are not skipped.
    """
    for node in range(count):
        row = base + SCAN_NODES + SCAN_ROW * node
        y = tables[row + ROW_Y]
        z, slope = height_slope(Profile.at(tables, wheel), y)
        tables[row + ROW_HEIGHT] = z
        tables[row + ROW_SLOPE] = slope
        cells = 1
        for level in range(LEVELS):
            end = min(node + cells, count - 1)
            least, most, steepest = bend_range(tables, wheel, work, scratch, y,
                                               tables[base + SCAN_NODES + SCAN_ROW * end + ROW_Y])
            tables[row + ROW_STEEPEST_BENDS + level] = max(fabs(least), fabs(most))
            if not steepest < STEEP:
                most = TOO_STEEP
            tables[row + ROW_MOST_BENDS + level] = most
            if level == 0:
                tables[row + ROW_LEAST_BEND] = least
            cells += cells
    return 0


def write_levers(tables: Tables, base: int, wheel: int, count: int):
    """The largest lever of each node and all beyond it: by how much the gap there would change with the roll of a level
    wheelset, if wheel and rail were parallel there."""
    largest = -FAR
    for i in range(count):
        node = count - 1 - i
        row = base + SCAN_NODES + SCAN_ROW * node
        width = 0.0
        if i > 0:
            width = tables[row + SCAN_ROW + ROW_Y] - tables[row + ROW_Y]
        for k in range(LAST_SAMPLE):
            y = tables[row + ROW_Y] + width * (float(k) / float(LAST_SAMPLE))
            z, slope = height_slope(Profile.at(tables, wheel), y)
            largest = max(largest, -slope * (tables.radius + z) - (tables.arm + y))
        tables[row + ROW_LEVER] = largest
    return 0


def write_rail_rows(tables: 'float[:]', at: int, rail: int, count: int, work: 'float[:]', scratch: int):
    """Bounds of the rail's raster at offset ``at``.

    A stretch starts in a raster cell and is as long as 1, 2, 4 ... FINE_STEPs of the wheel, stretched by WIDEST.
    """
    for cell in range(count):
        row = at + RAIL_ROW * cell
        edge = Profile.at(tables, rail).start + FINE_STEP * float(cell)
        least, most, steepest = bend_range(tables, rail, work, scratch, edge - FINE_STEP, edge + FINE_STEP + 1.5 * COARSE_STEP)
        tables[row + RAIL_LEAST_BEND] = least
        tables[row + RAIL_MOST_BEND] = most
        cells = 1.0
        for level in range(LEVELS + 1):
            length = FINE_STEP * (1.01 + (1.0 + WIDEST) * 1.01 * cells)
            least, most, steepest = bend_range(tables, rail, work, scratch, edge - 0.01 * FINE_STEP, edge + length)
            tables[row + RAIL_LEAST_BENDS + level] = least
            cells += cells
    return 0


def write_scan(tables: Tables, base: int, wheel: int, rail: int, work: 'float[:]', scratch: int):
    """The scan table at ``base`` from the profile tables ``wheel`` and ``rail``; the offset after it, or TOO_WIDE or FULL."""
    pieces = max(piece_count(tables.raw, wheel), piece_count(tables.raw, rail))
    firsts = scratch + 3 * pieces
    sample_pieces(tables.raw, wheel, work, scratch)
    count = write_raster(tables.raw, base, wheel, work, scratch, firsts)
    if count < 0:
        return count
    bins = coarse_count(Profile.at(tables, wheel).start, Profile.at(tables, wheel).stop)
    cells = int(ceil((Profile.at(tables, rail).stop - Profile.at(tables, rail).start) / FINE_STEP))
    rail_offset = SCAN_NODES + SCAN_ROW * count
    bin_offset = rail_offset + RAIL_ROW * cells
    if base + bin_offset + bins > tables.raw.shape[0]:
        return FULL
    write_wheel_rows(tables.raw, base, wheel, count, work, scratch)
    write_levers(tables, base, wheel, count)
    least, most, steepest = bend_range(tables.raw, wheel, work, scratch, Profile.at(tables, wheel).start, Profile.at(tables, wheel).stop)
    tables[base + SCAN_STEEPEST] = steepest
    sample_pieces(tables.raw, rail, work, scratch)
    write_rail_rows(tables.raw, base + rail_offset, rail, cells, work, scratch)
    tables[base + SCAN_COUNT] = float(count)
    tables[base + SCAN_RAIL_COUNT] = float(cells)
    tables[base + SCAN_RAIL_START] = Profile.at(tables, rail).start
    tables[base + SCAN_RAIL_PER_METRE] = 1.0 / FINE_STEP
    tables[base + SCAN_RAIL_OFFSET] = float(rail_offset)
    tables[base + SCAN_BIN_OFFSET] = float(bin_offset)
    tables[base + SCAN_BIN_COUNT] = float(bins)
    tables[base + SCAN_BINS_PER_METRE] = float(bins) / (Profile.at(tables, wheel).stop - Profile.at(tables, wheel).start)
    for i in range(bins):
        tables[base + bin_offset + i] = work[firsts + i]
    return base + bin_offset + bins
