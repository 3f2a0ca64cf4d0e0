"""Local minima of the gap inside one cell of the raster, or inside the part of it that is above the rail.

A cell that could hold a minimum is halved until that is settled. The gap between both ends lies above its
chord by no less than -M h^2 / 8, where M bounds its second derivative from above. Two loops do this, since
they ask for different things: ``search_cell`` for any value below the smallest gap, which narrows as it goes,
also at ends; ``list_cell`` for all minima below a fixed reach, in their order, each of them once.
"""

from math import fabs
from typing import Final

from ..layout import CANDIDATES, Cell, Place, SideSearch, State, Tables
from ..surface.gap import FOLDED, vertical_gap
from .bounds import WIDEST, bend_bounds, least_bend, only_rises_or_falls, rail_place
from .raster import rail_below

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
