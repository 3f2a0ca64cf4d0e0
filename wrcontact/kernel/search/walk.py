"""Walk over the raster of the wheel from a node outwards, and search the cells that
may hold a minimum of the gap.

Gap, slope and a lower bound of the second derivative tell over how many cells the gap cannot have a value of
interest; that stretch, of up to 32 cells, is skipped. Where not even one cell can be skipped, the cell itself
is searched. One walk serves two questions: the smallest gap (``listing`` = 0) and all local minima below
``side.reach`` (``listing`` = 1).

The overlap of a pressed wheel has a walk of its own (contact/overlaps.py): it keeps what it finds at the
nodes, does not look between them, and ends at the first node beside the rail.
"""

from typing import Final

from ..layout import EXPONENTS, SideSearch, State, Tables
from ..surface.gap import above_rail, vertical_gap
from .bounds import bend_bounds, clear_exponent, rising_exponent
from .cells import keep_smaller, list_cell, search_cell, write_cell
from .raster import above_rail_end, leaves_rail, node_gap, rail_below

#: A gap that is larger than any [m].
LARGE_GAP: Final[float] = 1e3


def walk(tables: Tables, side: SideSearch, state: State, node: int, direction: int, listing: bool):
    """Search from ``node`` on in ``direction`` (1 or -1), up to the end of rail or wheel."""
    scan = tables.scan
    at = side.place
    count = scan.count
    exponent = EXPONENTS - 1
    gap_before = LARGE_GAP
    mismatch_before = 0.0
    abscissa_before = 0.0
    skipped = True
    beside = False
    while node >= 0 and node < count:
        gap, mismatch, abscissa = node_gap(tables, at, node)
        state.gap_count += 1.0
        if not above_rail(tables, abscissa):
            if not skipped and not beside:
                search_end(tables, side, state, node - direction, direction, direction, listing)
            if leaves_rail(tables, at, node, direction, abscissa):
                return
            beside = True
            skipped = False
            exponent = 0
        else:
            if not listing:
                keep_smaller(side, scan.nodes[node].y, gap)
            if beside:
                search_end(tables, side, state, node, -direction, direction, listing)
            elif not skipped:
                if direction > 0:
                    write_cell(side.stack[0], scan.nodes[node - 1].y, scan.nodes[node].y, gap_before, gap,
                               mismatch_before, mismatch)
                    search_between(tables, side, state, node - 1, direction, abscissa_before, listing)
                else:
                    write_cell(side.stack[0], scan.nodes[node].y, scan.nodes[node + 1].y, gap, gap_before,
                               mismatch, mismatch_before)
                    search_between(tables, side, state, node, direction, abscissa, listing)
            beside = False
            gap_before = gap
            mismatch_before = mismatch
            abscissa_before = abscissa
            slope = float(direction) * mismatch
            if not listing:
                exponent = clear_exponent(scan, at, node, direction, abscissa, gap - side.best, slope,
                                          exponent)
            else:
                exponent = rising_exponent(scan, at, node, direction, abscissa, gap - side.reach, slope,
                                           exponent)
            skipped = True
            if exponent < 0:
                exponent = 0
                skipped = False
        node += direction * (1 << exponent)
        if not beside and exponent < EXPONENTS - 1:
            exponent += 1


def search_between(tables: Tables, side: SideSearch, state: State, node: int, direction: int, abscissa: float,
                   listing: bool):
    """Search the first cell of the stack, which lies between ``node`` and the next one, if it
    can hold what is asked for.

    abscissa : of ``node`` on the rail [m].
    """
    if listing:
        list_cell(tables, side, state, node, direction, abscissa)
    else:
        least, most = bend_bounds(tables.scan, side.place, node, abscissa)
        cell = side.stack[0]
        width = cell.high - cell.low
        if min(cell.gap_low, cell.gap_high) - most * width * width / 8.0 < side.best:
            search_cell(tables, side, state, least, most, cell.low, cell.high)


def search_end(tables: Tables, side: SideSearch, state: State, node: int, outward: int, direction: int,
               listing: bool):
    """Search between ``node``, above the rail, and the end of the rail, which lies before the next node
    ``outward`` (1 or -1)."""
    at = side.place
    inner = tables.scan.nodes[node].y
    end = above_rail_end(tables, at, node, outward)
    low = min(inner, end)
    high = max(inner, end)
    cell = node
    if outward < 0:
        cell = node - 1
    if low < high:
        if listing:
            gap_low, mismatch_low, rate = vertical_gap(tables, at, low)
            gap_high, mismatch_high, rate = vertical_gap(tables, at, high)
            state.gap_count += 2.0
            write_cell(side.stack[0], low, high, gap_low, gap_high, mismatch_low, mismatch_high)
            list_cell(tables, side, state, cell, direction, rail_below(tables, at, low))
        else:
            gap, mismatch, abscissa = node_gap(tables, at, node)
            gap, mismatch, beyond = node_gap(tables, at, node + outward)
            if beyond < abscissa:
                abscissa = tables.rail.start
            least, most = bend_bounds(tables.scan, at, cell, abscissa)
            search_cell(tables, side, state, -1.0, most, low, high)
