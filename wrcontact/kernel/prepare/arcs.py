"""Tables of the rail's arc length over its abscissa, and of the abscissa over the arc length.

Cubics of Hermite over even cells: value and slope at the ends of a cell are exact.
"""

from math import ceil, sqrt
from typing import Final

from ..layout import CUBIC_SIZE, CubicTable, Profile, Tables, offset
from ..surface.profile_table import height_slope
from .curvatures import arc_length, place_at_length, write_lengths
from .pieces import FULL

#: Longest cell of either table [m].
ARC_STEP: Final[float] = 1e-4


def open_table(tables: Tables, base: int, start: float, length: float):
    """A table of cubics over ``length`` [m] from ``start`` [m] on, at ``base``; its number of cells and the
    offset after it, or FULL."""
    cells = int(ceil(length / ARC_STEP))
    table = CubicTable.at(tables.raw, base)
    end = offset(table.cells[0], tables) + CUBIC_SIZE * cells
    if end > tables.raw.shape[0]:
        return cells, FULL
    table.count = float(cells)
    table.start = start
    table.cells_per_unit = float(cells) / length
    return cells, end


def write_cubic(tables: Tables, base: int, cell: int, low: float, high: float, low_rise: float,
                high_rise: float):
    """Cell ``cell`` of the table at ``base``, with these values at its ends, and slopes per cell."""
    cubic = CubicTable.at(tables.raw, base).cells[cell]
    rise = high - low
    cubic.value = low
    cubic.slope = low_rise
    cubic.bend = 3.0 * rise - 2.0 * low_rise - high_rise
    cubic.third = low_rise + high_rise - 2.0 * rise


def rail_speed(tables: Tables, rail: int, abscissa: float):
    """Arc length per abscissa of the rail [-]."""
    height, slope = height_slope(Profile.at(tables.raw, rail), abscissa)
    return sqrt(1.0 + slope * slope)


def write_arcs(tables: Tables, base: int, rail: int, work: 'float[:]', scratch: int):
    """The arc length of the rail over its abscissa, at ``base``; the offset after it, or FULL."""
    start = Profile.at(tables.raw, rail).start
    width = Profile.at(tables.raw, rail).stop - start
    cells, end = open_table(tables, base, start, width)
    if end == FULL:
        return FULL
    total = write_lengths(tables.raw, rail, work, scratch)
    step = width / float(cells)
    low = 0.0
    low_rise = step * rail_speed(tables, rail, start)
    for cell in range(cells):
        x = start + step * float(cell + 1)
        high = total
        if cell + 1 < cells:
            high = arc_length(tables.raw, rail, x, work, scratch)
        high_rise = step * rail_speed(tables, rail, x)
        write_cubic(tables, base, cell, low, high, low_rise, high_rise)
        low = high
        low_rise = high_rise
    return end


def write_abscissae(tables: Tables, base: int, rail: int, work: 'float[:]', scratch: int):
    """The abscissa of the rail over its arc length, at ``base``; the offset after it, or FULL."""
    start = Profile.at(tables.raw, rail).start
    total = write_lengths(tables.raw, rail, work, scratch)
    cells, end = open_table(tables, base, 0.0, total)
    if end == FULL:
        return FULL
    step = total / float(cells)
    low = start
    low_rise = step / rail_speed(tables, rail, start)
    for cell in range(cells):
        high = Profile.at(tables.raw, rail).stop
        if cell + 1 < cells:
            high = place_at_length(tables.raw, rail, step * float(cell + 1), work, scratch)
        high_rise = step / rail_speed(tables, rail, high)
        write_cubic(tables, base, cell, low, high, low_rise, high_rise)
        low = high
        low_rise = high_rise
    return end
