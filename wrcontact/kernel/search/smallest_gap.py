"""The smallest vertical gap of one side.

The gap has up to three local minima (tread, flange root, flange) that exchange rank. From a known place, or
the best of a few nodes, the search walks outwards over the raster of the wheel. Whatever it leaves out cannot
hold a smaller gap, by the bounds of the gap's second derivative: so the global minimum is bounded and not
assumed.

Gap, slope and a lower bound of the second derivative tell over how many cells the gap cannot become smaller
than the smallest one known; that stretch, of up to 32 cells, is skipped. Where not even one cell can be
skipped, the cell itself is searched, or the part of it that is above the rail: it is halved until it is
settled. The gap between both ends lies above its chord by no less than -M h^2 / 8, where M bounds its second
derivative from above; of short parts M is that of the pieces that they cover.

The overlap of a pressed wheel has a walk of its own (contact/overlaps.py): it keeps what it finds at the
nodes, does not look between them, and ends at the first node beside the rail.
"""

from math import fabs
from typing import Final

from ..layout import EXPONENTS, Cell, Pair, Place, SideSearch, copy
from ..surface.gap import FOLDED, above_rail, vertical_gap
from .bounds import (
    above_rail_end,
    bend_bounds,
    clear_exponent,
    leaves_rail,
    node_below,
    node_gap,
    only_rises_or_falls,
    rising_from_minimum,
)
from .own_bounds import own_bounds
from .single_minimum import rises_in_cell

#: A part of a cell in which the gap is nowhere lower than this below both ends is not halved [m].
HIDDEN: Final[float] = 1e-11
#: Parts no wider than this are bounded by their own pieces [m].
SHORT: Final[float] = 5e-5
#: Abscissa to which a minimum is refined [m]; its gap is then exact to rounding, being second order.
SHARP: Final[float] = 1e-13
REFINEMENTS: Final[int] = 60
#: Rounding of gaps [m].
ROUNDING: Final[float] = 1e-15
#: A gap that is larger than any [m].
LARGE_GAP: Final[float] = 1e3
#: Without a known place the search begins at the best of every eighth node.
PROBE_STRIDE: Final[int] = 8


def write_cell(
    cell: Cell,
    low: float,
    high: float,
    gap_low: float,
    gap_high: float,
    mismatch_low: float,
    mismatch_high: float,
):
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


def search_cell(pair: Pair, side: SideSearch, least: float, most: float, first: float, last: float):
    """Keep the smallest gap between ``first`` and ``last`` [m] if it is the side's smallest: halve
    while a smaller one is possible, refine where the slope turns. ``least`` and ``most`` bound the
    second derivative [1/m]."""
    at = side.place
    gap_low, mismatch_low, rate = vertical_gap(pair, at, first)
    gap_high, mismatch_high, rate = vertical_gap(pair, at, last)
    at.gap_count += 2.0
    write_cell(side.stack[0], first, last, gap_low, gap_high, mismatch_low, mismatch_high)
    side.stack[0].least = least
    side.stack[0].most = most
    depth = 1
    while depth > 0:
        depth -= 1
        cell = side.stack[depth]
        low, high, gap_low, gap_high, mismatch_low, mismatch_high = cell_ends(cell)
        least = cell.least
        most = cell.most
        width = high - low
        lowest = gap_low
        keep_smaller(side, low, gap_low)
        if gap_high < gap_low:
            lowest = gap_high
            keep_smaller(side, high, gap_high)
        hidden = most * width * width / 8.0
        if width <= SHORT and lowest - hidden < side.best:
            least, most = own_bounds(pair, at, low, high, least, most)
            hidden = most * width * width / 8.0
        if lowest - hidden < side.best:
            folded = mismatch_low == FOLDED or mismatch_high == FOLDED
            turns = mismatch_low < 0.0 and mismatch_high >= 0.0 and not folded
            steady = only_rises_or_falls(least, most, width, mismatch_low, mismatch_high) and not folded
            if turns and (least > 0.0 or hidden <= HIDDEN):
                y, gap = refine_minimum(pair, at, cell)
                keep_refined(side, y, gap, width)
            elif hidden > HIDDEN and not steady and (folded or not least > 0.0):
                middle = 0.5 * (low + high)
                gap, mismatch, rate = vertical_gap(pair, at, middle)
                at.gap_count += 1.0
                cell.least = least
                cell.most = most
                copy(cell, side.stack[depth + 1])
                write_cell(side.stack[depth + 1], middle, high, gap, gap_high, mismatch, mismatch_high)
                write_cell(cell, low, middle, gap_low, gap, mismatch_low, mismatch)
                depth += 2


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


def refine_minimum(pair: Pair, at: Place, cell: Cell):
    """Abscissa [m] and gap [m] where the slope difference vanishes in a cell:
    bracketed Newton's method."""
    low = cell.low
    high = cell.high
    y = low - cell.mismatch_low * (high - low) / (cell.mismatch_high - cell.mismatch_low)
    gap = 0.0
    for i in range(REFINEMENTS):
        gap, mismatch, rate = vertical_gap(pair, at, y)
        at.gap_count += 1.0
        if mismatch < 0.0:
            low = y
        else:
            high = y
        following = 0.5 * (low + high)
        if rate > 0.0:
            move = -mismatch / rate
            if fabs(move) < SHARP:
                break
            if y + move > low and y + move < high:
                following = y + move
        if fabs(following - y) < SHARP:
            break
        y = following
    return y, gap


def walk(pair: Pair, side: SideSearch, node: int, direction: int):
    """Search from ``node`` on in ``direction`` (1 or -1), up to the end of rail or wheel."""
    scan = pair.scan
    at = side.place
    count = scan.count
    exponent = EXPONENTS - 1
    gap_before = LARGE_GAP
    mismatch_before = 0.0
    abscissa_before = 0.0
    skipped = True
    beside = False
    while node >= 0 and node < count:
        gap, mismatch, abscissa = node_gap(pair, at, node)
        at.gap_count += 1.0
        if not above_rail(pair, abscissa):
            if not skipped and not beside:
                search_end(pair, side, node - direction, direction)
            if leaves_rail(pair, at, node, direction, abscissa):
                return
            beside = True
            skipped = False
            exponent = 0
        else:
            keep_smaller(side, scan.nodes[node].y, gap)
            if beside:
                search_end(pair, side, node, -direction)
            elif not skipped:
                if direction > 0:
                    write_cell(
                        side.stack[0],
                        scan.nodes[node - 1].y,
                        scan.nodes[node].y,
                        gap_before,
                        gap,
                        mismatch_before,
                        mismatch,
                    )
                    search_between(pair, side, node - 1, abscissa_before)
                else:
                    write_cell(
                        side.stack[0],
                        scan.nodes[node].y,
                        scan.nodes[node + 1].y,
                        gap,
                        gap_before,
                        mismatch,
                        mismatch_before,
                    )
                    search_between(pair, side, node, abscissa)
            beside = False
            gap_before = gap
            mismatch_before = mismatch
            abscissa_before = abscissa
            slope = float(direction) * mismatch
            exponent = clear_exponent(scan, at, node, direction, abscissa, gap - side.best, slope, exponent)
            skipped = True
            if exponent < 0:
                exponent = 0
                skipped = False
        node += direction * (1 << exponent)
        if not beside and exponent < EXPONENTS - 1:
            exponent += 1


def search_between(pair: Pair, side: SideSearch, node: int, abscissa: float):
    """Search the first cell of the stack, which lies between ``node`` and the next one, if it can hold a
    smaller gap.

    abscissa : of ``node`` on the rail [m].
    """
    least, most = bend_bounds(pair.scan, side.place, node, abscissa)
    cell = side.stack[0]
    width = cell.high - cell.low
    if min(cell.gap_low, cell.gap_high) - most * width * width / 8.0 < side.best:
        search_cell(pair, side, least, most, cell.low, cell.high)


def search_end(pair: Pair, side: SideSearch, node: int, outward: int):
    """Search between ``node``, above the rail, and the end of the rail, which lies before the next node
    ``outward`` (1 or -1)."""
    at = side.place
    inner = pair.scan.nodes[node].y
    end = above_rail_end(pair, at, node, outward)
    low = min(inner, end)
    high = max(inner, end)
    cell = node
    if outward < 0:
        cell = node - 1
    if low < high:
        gap, mismatch, abscissa = node_gap(pair, at, node)
        gap, mismatch, beyond = node_gap(pair, at, node + outward)
        if beyond < abscissa:
            abscissa = pair.rail.start
        least, most = bend_bounds(pair.scan, at, cell, abscissa)
        # a minimum is not taken for the only one: the rail's bounds are those of its last cell
        search_cell(pair, side, min(least, -1.0), most, low, high)


def search_side(pair: Pair, side: SideSearch, known: bool) -> bool:
    """Write the side's smallest gap and its abscissa to ``best`` and ``best_y``; whether there is one.

    With ``known`` = 1 the two, and ``best_rail``, already hold a local minimum of this pose, and only a
    smaller one is looked for.
    """
    scan = pair.scan
    at = side.place
    side.scan_count += 1.0
    if known:
        cell = node_below(scan, side.best_y)
        ahead = rising_from_minimum(scan, at, side.best_y, 1, side.best_rail)
        behind = rising_from_minimum(scan, at, side.best_y, -1, side.best_rail)
        if (ahead >= 0 and behind >= 0) or rises_in_cell(pair, at, cell):
            walk(pair, side, cell + first_step(ahead), 1)
            walk(pair, side, cell + 1 - first_step(behind), -1)
            return True
        node = cell
        gap, mismatch, abscissa = node_gap(pair, at, node)
        if not above_rail(pair, abscissa):
            node = cell + 1
    else:
        side.best = LARGE_GAP
        node = best_node(pair, side, PROBE_STRIDE)
        if node < 0:
            node = best_node(pair, side, 1)
        if node < 0:
            return False
    walk(pair, side, node, 1)
    walk(pair, side, node, -1)
    return True


def first_step(exponent: int):
    """How many cells lie between the far node of a minimum's cell and the node where a walk begins: those
    where the gap only rises, or the cell alone with an ``exponent`` of -1."""
    if exponent < 0:
        return 1
    return 1 << exponent


def best_node(pair: Pair, side: SideSearch, stride: int):
    """The node with the smallest gap among every ``stride``-th one above the rail, which becomes the best
    known; -1 if there is none."""
    scan = pair.scan
    at = side.place
    found = -1
    node = 0
    while node < scan.count:
        gap, mismatch, abscissa = node_gap(pair, at, node)
        at.gap_count += 1.0
        if above_rail(pair, abscissa):
            if gap < side.best:
                side.best = gap
                side.best_y = scan.nodes[node].y
                found = node
        elif found >= 0 and leaves_rail(pair, at, node, 1, abscissa):
            return found
        node += stride
    return found
