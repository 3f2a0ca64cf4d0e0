"""Walk over the raster of the wheel from a node outwards, and search the cells that may hold a minimum of the
gap.

Gap, slope and a lower bound of the second derivative tell over how many cells the gap cannot have a value of
interest; that stretch, of up to 32 cells, is skipped. Where not even one cell can be skipped, the cell itself
is searched. One walk serves two questions: the smallest gap (``listing`` = 0) and all local minima below
``side.reach`` (``listing`` = 1).

The overlap of a pressed wheel has a walk of its own (contact/overlaps.py): it keeps what it finds at the
nodes, does not look between them, and ends at the first node beside the rail.

Local minima are sought inside one cell of the raster, or inside the part of it that is above the rail.
A cell that could hold a minimum is halved until that is settled. The gap between both ends lies above its
chord by no less than -M h^2 / 8, where M bounds its second derivative from above. Two loops do this, since
they ask for different things: ``search_cell`` for any value below the smallest gap, which narrows as it goes,
also at ends; ``list_cell`` for all minima below a fixed reach, in their order, each of them once.
"""

from math import fabs
from typing import Final

from ..layout import CANDIDATES, EXPONENTS, Cell, Place, SideSearch, State, Tables
from ..surface.gap import FOLDED, above_rail, vertical_gap
from .bounds import (WIDEST, above_rail_end, bend_bounds, clear_exponent, least_bend, leaves_rail, node_gap,
                     only_rises_or_falls, rail_below, rail_place, rising_exponent)

#: Cells are halved down to this width [m]; what a cell can then hide is less than M (2e-6
#: m)^2 / 8, 1e-11 m at worst.
NARROW: Final[float] = 2e-6
#: A stretch that has a further minimum is not halved below this [m]: two would be one contact.
LISTED_ONE: Final[float] = 2.5e-4
#: Abscissa to which a minimum is refined [m]; its gap is then exact to rounding, being second order.
SHARP: Final[float] = 1e-13
#: The same for a further minimum, from which a region's own is refined.
LISTED_SHARP: Final[float] = 2e-6
REFINEMENTS: Final[int] = 60
#: Rounding of gaps [m].
ROUNDING: Final[float] = 1e-15
#: A gap that is larger than any [m].
LARGE_GAP: Final[float] = 1e3


def write_cell(cell: Cell, low: float, high: float, gap_low: float, gap_high: float, mismatch_low: float,
               mismatch_high: float):
    """Fill in a cell that waits to be searched."""
    cell.low = low
    cell.high = high
    cell.gap_low = gap_low
    cell.gap_high = gap_high
    cell.mismatch_low = mismatch_low
    cell.mismatch_high = mismatch_high


def cell_ends(cell: Cell):
    """Abscissae, gaps [m] and mismatches [-] at both ends of a cell."""
    return cell.low, cell.high, cell.gap_low, cell.gap_high, cell.mismatch_low, cell.mismatch_high


def search_cell(tables: Tables, side: SideSearch, state: State, least: float, most: float, first: float,
                last: float):
    """Keep the smallest gap between ``first`` and ``last`` [m] if it is the side's smallest: halve
    while a smaller one is possible, refine where the slope turns. ``least`` and ``most`` bound the
    second derivative [1/m]."""
    at = side.place
    gap_low, mismatch_low, rate = vertical_gap(tables, at, first)
    gap_high, mismatch_high, rate = vertical_gap(tables, at, last)
    state.gap_count += 2.0
    write_cell(side.stack[0], first, last, gap_low, gap_high, mismatch_low, mismatch_high)
    depth = 1
    while depth > 0:
        depth -= 1
        cell = side.stack[depth]
        low, high, gap_low, gap_high, mismatch_low, mismatch_high = cell_ends(cell)
        width = high - low
        lowest = gap_low
        keep_smaller(side, low, gap_low)
        if gap_high < gap_low:
            lowest = gap_high
            keep_smaller(side, high, gap_high)
        if lowest - most * width * width / 8.0 < side.best:
            folded = mismatch_low == FOLDED or mismatch_high == FOLDED
            turns = mismatch_low < 0.0 and mismatch_high >= 0.0 and not folded
            steady = only_rises_or_falls(least, most, width, mismatch_low, mismatch_high) and not folded
            if turns and (least > 0.0 or width <= NARROW):
                y, gap = refine_minimum(tables, at, state, cell, SHARP)
                keep_refined(side, y, gap, width)
            elif width > NARROW and not steady and (folded or not least > 0.0):
                middle = 0.5 * (low + high)
                gap, mismatch, rate = vertical_gap(tables, at, middle)
                state.gap_count += 1.0
                write_cell(side.stack[depth + 1], middle, high, gap, gap_high, mismatch, mismatch_high)
                write_cell(cell, low, middle, gap_low, gap, mismatch_low, mismatch)
                depth += 2


def list_cell(tables: Tables, side: SideSearch, state: State, node: int, direction: int, abscissa: float):
    """List the local minima below ``side.reach`` in the first cell of the stack, which lies between
    ``node`` and the next one.

    abscissa : of its lower end on the rail [m].
    """
    at = side.place
    scan = tables.scan
    first = side.stack[0]
    nothing, most = bend_bounds(scan, at, node, abscissa)
    least, stretch = least_bend(scan, at, node, 0, first.high - first.low, rail_place(scan, abscissa))
    if not stretch < WIDEST:
        # the outline may be folded there
        least = nothing
        gap_low, mismatch_low, rate = vertical_gap(tables, at, first.low)
        gap_high, mismatch_high, rate = vertical_gap(tables, at, first.high)
        state.gap_count += 2.0
        write_cell(first, first.low, first.high, gap_low, gap_high, mismatch_low, mismatch_high)
    depth = 1
    while depth > 0:
        depth -= 1
        cell = side.stack[depth]
        low, high, gap_low, gap_high, mismatch_low, mismatch_high = cell_ends(cell)
        width = high - low
        if min(gap_low, gap_high) - most * width * width / 8.0 < side.reach:
            folded = mismatch_low == FOLDED or mismatch_high == FOLDED
            turns = mismatch_low < 0.0 and mismatch_high >= 0.0 and not folded
            if turns and (least > 0.0 or width <= LISTED_ONE):
                y, gap = refine_minimum(tables, at, state, cell, LISTED_SHARP)
                if gap < side.reach:
                    list_minimum(side, y, rail_below(tables, at, y), direction)
            elif (width > NARROW
                  and (folded or not only_rises_or_falls(least, most, width, mismatch_low, mismatch_high))):
                middle = 0.5 * (low + high)
                gap, mismatch, rate = vertical_gap(tables, at, middle)
                state.gap_count += 1.0
                # the one that comes first in ``direction`` on top
                other = side.stack[depth + 1]
                if direction > 0:
                    write_cell(cell, middle, high, gap, gap_high, mismatch, mismatch_high)
                    write_cell(other, low, middle, gap_low, gap, mismatch_low, mismatch)
                else:
                    write_cell(cell, low, middle, gap_low, gap, mismatch_low, mismatch)
                    write_cell(other, middle, high, gap, gap_high, mismatch, mismatch_high)
                depth += 2


def list_minimum(side: SideSearch, y: float, abscissa: float, direction: int):
    """Add the minimum at ``y`` [m] to the candidates, at the end for ``direction`` =
    1, else at the beginning."""
    entry = side.last + 1
    if direction < 0:
        entry = side.first - 1
    if entry >= 0 and entry < 2 * CANDIDATES:
        candidate = side.candidates[entry]
        candidate.y = y
        candidate.rail = abscissa
        if direction < 0:
            side.first = entry
        else:
            side.last = entry


def keep_smaller(side: SideSearch, y: float, gap: float):
    """Keep (y, gap) if it is the side's smallest so far, by more than rounding: a
    node beside a contact is none."""
    if gap < side.best - ROUNDING:
        side.best = gap
        side.best_y = y


def keep_refined(side: SideSearch, y: float, gap: float, width: float):
    """Keep (y, gap), a place of contact, if it is the side's smallest so far: rather than a node within
    ``width`` [m] that has the same gap but for the last bits."""
    allowed = side.best
    if fabs(y - side.best_y) < width:
        allowed += ROUNDING
    if gap < allowed:
        side.best = gap
        side.best_y = y


def refine_minimum(tables: Tables, at: Place, state: State, cell: Cell, sharp: float):
    """Abscissa [m], to ``sharp`` [m], and gap [m] where the slope difference vanishes in a cell:
    bracketed Newton's method."""
    low = cell.low
    high = cell.high
    y = low - cell.mismatch_low * (high - low) / (cell.mismatch_high - cell.mismatch_low)
    gap = 0.0
    for i in range(REFINEMENTS):
        gap, mismatch, rate = vertical_gap(tables, at, y)
        state.gap_count += 1.0
        if mismatch < 0.0:
            low = y
        else:
            high = y
        following = 0.5 * (low + high)
        if rate > 0.0:
            move = -mismatch / rate
            if fabs(move) < sharp:
                break
            if y + move > low and y + move < high:
                following = y + move
        if fabs(following - y) < sharp:
            break
        y = following
    return y, gap


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
