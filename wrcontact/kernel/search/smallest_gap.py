"""The smallest vertical gap of one side, and the further local minima of the gap.

The gap has up to three local minima (tread, flange root, flange) that exchange rank. From a known
place, or the best of a few nodes, the search walks outwards over the raster of the wheel. Whatever it
leaves out cannot hold a smaller gap, by the bounds of the gap's second derivative: so the global
minimum is bounded and not assumed.
"""

from typing import Final

from ..layout import CANDIDATES, SideSearch, State, Tables
from ..surface.gap import above_rail
from .bounds import leaves_rail, node_below, node_gap, rising_from_minimum
from .walk import LARGE_GAP, walk

#: Without a known place the search begins at the best of every eighth node.
PROBE_STRIDE: Final[int] = 8


def search_side(tables: Tables, side: SideSearch, state: State, known: bool) -> bool:
    """Write the side's smallest gap and its abscissa to ``best`` and ``best_y``; whether there is one.

    With ``known`` = 1 the two, and ``best_rail``, already hold a local minimum of this pose, and only a
    smaller one is looked for.
    """
    scan = tables.scan
    at = side.place
    state.scan_count += 1.0
    if known:
        cell = node_below(scan, side.best_y)
        ahead = rising_from_minimum(scan, at, side.best_y, 1, side.best_rail)
        behind = rising_from_minimum(scan, at, side.best_y, -1, side.best_rail)
        if ahead >= 0 and behind >= 0:
            walk(tables, side, state, cell + (1 << ahead), 1, False)
            walk(tables, side, state, cell + 1 - (1 << behind), -1, False)
            return True
        node = cell
        gap, mismatch, abscissa = node_gap(tables, at, node)
        if not above_rail(tables, abscissa):
            node = cell + 1
    else:
        side.best = LARGE_GAP
        node = best_node(tables, side, state, PROBE_STRIDE)
        if node < 0:
            node = best_node(tables, side, state, 1)
        if node < 0:
            return False
    walk(tables, side, state, node, 1, False)
    walk(tables, side, state, node, -1, False)
    return True


def best_node(tables: Tables, side: SideSearch, state: State, stride: int):
    """The node with the smallest gap among every ``stride``-th one above the rail, which becomes the best
    known; -1 if there is none."""
    scan = tables.scan
    at = side.place
    found = -1
    node = 0
    while node < scan.count:
        gap, mismatch, abscissa = node_gap(tables, at, node)
        state.gap_count += 1.0
        if above_rail(tables, abscissa):
            if gap < side.best:
                side.best = gap
                side.best_y = scan.nodes[node].y
                found = node
        elif found >= 0 and leaves_rail(tables, at, node, 1, abscissa):
            return found
        node += stride
    return found


def list_minima(tables: Tables, side: SideSearch, state: State, reach: float, abscissa: float):
    """List the local minima of the gap below ``reach`` [m] other than the known smallest one, which lies at
    ``abscissa`` on the rail [m]: the candidates ``first`` ... ``last`` of the side."""
    scan = tables.scan
    cell = node_below(scan, side.best_y)
    side.reach = reach
    side.first = CANDIDATES
    side.last = CANDIDATES - 1
    ahead = rising_from_minimum(scan, side.place, side.best_y, 1, abscissa)
    if ahead < 0:
        ahead = 0
    walk(tables, side, state, cell + (1 << ahead), 1, True)
    behind = rising_from_minimum(scan, side.place, side.best_y, -1, abscissa)
    if behind < 0:
        behind = 0
    walk(tables, side, state, cell + 1 - (1 << behind), -1, True)
