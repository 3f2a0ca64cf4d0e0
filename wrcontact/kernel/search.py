"""The smallest vertical gap of one side: scan, bound, refine.

The gap has up to three local minima (tread, flange root, flange) that exchange rank.  The scan nodes lie on a fixed
raster of the wheel profile.  Between two nodes the gap lies above its chord by no less than -M h^2 / 8, where M bounds
its second derivative from above; where a lower bound of the second derivative is positive the cell is convex and holds
one minimum at most.  Cells that could hold a value below the best one known are halved until neither is left open, so
the global minimum is bounded and not assumed.
"""

from math import fabs
from typing import Final

from .gap import FOLDED, above_rail, vertical_gap
from .layout import (SET_RAIL, SET_RAIL_Y, SET_SCAN, SET_WHEEL, SIDE_ABSCISSA, SIDE_BEST, SIDE_BEST_Y, SIDE_FIRST,
                     SIDE_GAP, SIDE_LAST, SIDE_STACK, STATE_GAP_COUNT, STATE_SCAN_COUNT)
from .locus import PLACE_ARM, PLACE_RADIUS, PLACE_SHIFT, PLACE_SIN_YAW, PLACE_YAWED, outline_point
from .profile_table import START, STOP, find_piece, height_slope

# the scan table: sizes, then the nodes, then the raster of the rail's bounds
SCAN_COUNT: Final[int] = 0           # nodes
SCAN_RAIL_COUNT: Final[int] = 1      # cells of the rail's raster
SCAN_RAIL_START: Final[int] = 2      # [m]
SCAN_RAIL_STEP: Final[int] = 3       # [m]
SCAN_RAIL_OFFSET: Final[int] = 4
SCAN_NODES: Final[int] = 8
SCAN_ROW: Final[int] = 5             # of a node:
ROW_Y: Final[int] = 0                # abscissa [m]
ROW_HEIGHT: Final[int] = 1           # [m]
ROW_SLOPE: Final[int] = 2
ROW_LEAST_BEND: Final[int] = 3       # smallest and largest second derivative up to the next node [1/m]
ROW_MOST_BEND: Final[int] = 4
RAIL_ROW: Final[int] = 2             # smallest and largest second derivative around a cell of the rail's raster

#: Share by which roll and yaw change the second derivative of either profile, as seen along the track; with yaw also in
#: proportion to how much the outline is stretched or folded.  Held against dense sampling in tests/test_rigid.py.
YAWED_SHARE: Final[float] = 0.3
STRETCHED_SHARE: Final[float] = 10.0
ROLLED_SHARE: Final[float] = 0.02
#: No cell dips further below its ends than this [m]: a flange root at 6 deg of yaw, 2.3 mm.  Bounds of higher cells are
#: not looked up.
DEEPEST: Final[float] = 4e-3
#: Cells are halved down to this width [m]; what a cell can then hide is less than M (3e-5 m)^2 / 8, 2e-9 m at worst.
NARROW: Final[float] = 3.2e-5
#: Abscissa to which a minimum is refined [m]; its gap is then exact to rounding, being second order.
SHARP: Final[float] = 1e-13
#: A known minimum that moves by more than this in a Newton step is looked for anew [m].
LONGEST_MOVE: Final[float] = 5e-4
FOLLOW_ITERATIONS: Final[int] = 12
#: The end of the rail is located to this [m].
END_SHARP: Final[float] = 1e-9
#: The scan starts this far before the first wheel point that can be above the rail [m]: yaw and roll shift the outline.
SCAN_LEAD: Final[float] = 0.03
LARGE_GAP: Final[float] = 1e3


def scan_side(tables: 'float[:]', work: 'float[:]', side: int, place: 'float[:]', at: int, state: 'float[:]'):
    """Gap and rail abscissa at all scan nodes above the rail; the node with the smallest gap, -1 if there are not two."""
    scan = int(tables[SET_SCAN])
    rail = int(tables[SET_RAIL])
    start = tables[rail + START]
    stop = tables[rail + STOP]
    lead = tables[SET_RAIL_Y] + start - place[at + PLACE_SHIFT] - place[at + PLACE_ARM] - SCAN_LEAD
    first = -1
    last = -1
    node = -1
    best = LARGE_GAP
    for i in range(int(tables[scan + SCAN_COUNT])):
        row = scan + SCAN_NODES + SCAN_ROW * i
        if tables[row + ROW_Y] > lead:
            y_track, z_track, outline_slope = outline_point(place, at, tables[row + ROW_Y], tables[row + ROW_HEIGHT],
                                                            tables[row + ROW_SLOPE])
            abscissa = y_track - tables[SET_RAIL_Y]
            if abscissa >= start and abscissa <= stop:
                piece = find_piece(tables, rail, abscissa)
                u = abscissa - tables[piece]
                height = tables[piece + 1] + u * (tables[piece + 2] + u * (tables[piece + 3] + u * (
                    tables[piece + 4] + u * (tables[piece + 5] + u * tables[piece + 6]))))
                gap = height - z_track
                if first < 0:
                    first = i
                last = i
                if gap < best:
                    best = gap
                    node = i
                work[side + SIDE_GAP + i] = gap
                work[side + SIDE_ABSCISSA + i] = abscissa
            elif abscissa > stop and first >= 0:
                break
            else:
                work[side + SIDE_GAP + i] = LARGE_GAP
    work[side + SIDE_FIRST] = float(first)
    work[side + SIDE_LAST] = float(last)
    state[STATE_GAP_COUNT] += float(last - first + 1)
    state[STATE_SCAN_COUNT] += 1.0
    if last <= first:
        node = -1
    return node


def bend_bounds(tables: 'float[:]', place: 'float[:]', at: int, cell: int, abscissa: float):
    """Bounds [1/m] of the gap's second derivative between scan nodes ``cell`` and ``cell`` + 1, the first of them above
    the rail's ``abscissa`` [m]: rail minus wheel."""
    scan = int(tables[SET_SCAN])
    u = (abscissa - tables[scan + SCAN_RAIL_START]) / tables[scan + SCAN_RAIL_STEP]
    if not u > 0.0:
        u = 0.0
    if u > tables[scan + SCAN_RAIL_COUNT] - 1.0:
        u = tables[scan + SCAN_RAIL_COUNT] - 1.0
    rail = scan + int(tables[scan + SCAN_RAIL_OFFSET]) + RAIL_ROW * int(u)
    row = scan + SCAN_NODES + SCAN_ROW * cell
    share = ROLLED_SHARE
    if place[at + PLACE_YAWED] != 0.0:
        # how much the outline is stretched: |dY/dy - 1| is about sin^2(yaw) r |r''|
        steepest = fabs(tables[row + ROW_MOST_BEND])
        if fabs(tables[row + ROW_LEAST_BEND]) > steepest:
            steepest = fabs(tables[row + ROW_LEAST_BEND])
        sine = place[at + PLACE_SIN_YAW]
        share = YAWED_SHARE + STRETCHED_SHARE * sine * sine * place[at + PLACE_RADIUS] * steepest
    least = tables[rail] - tables[row + ROW_MOST_BEND] - share * (fabs(tables[rail]) + fabs(tables[row + ROW_MOST_BEND]))
    most = (tables[rail + 1] - tables[row + ROW_LEAST_BEND]
            + share * (fabs(tables[rail + 1]) + fabs(tables[row + ROW_LEAST_BEND])))
    if not most > 0.0:
        most = 0.0
    return least, most


def search_side(tables: 'float[:]', work: 'float[:]', side: int, place: 'float[:]', at: int, state: 'float[:]',
                known: int):
    """Put the smallest gap of the side and its abscissa into SIDE_BEST, SIDE_BEST_Y; 1 if there is one, else 0.

    With ``known`` = 1 the two already hold a local minimum of this pose, and only a smaller one is looked for.
    """
    node = scan_side(tables, work, side, place, at, state)
    if node < 0:
        return 0
    scan = int(tables[SET_SCAN])
    if known == 0:
        work[side + SIDE_BEST] = work[side + SIDE_GAP + node]
        work[side + SIDE_BEST_Y] = tables[scan + SCAN_NODES + SCAN_ROW * node + ROW_Y]
    first = int(work[side + SIDE_FIRST])
    last = int(work[side + SIDE_LAST])
    for i in range(first, last):
        lowest = work[side + SIDE_GAP + i]
        if work[side + SIDE_GAP + i + 1] < lowest:
            lowest = work[side + SIDE_GAP + i + 1]
        # most cells are far above; the bounds are looked up for the others only
        if lowest < work[side + SIDE_BEST] + DEEPEST:
            least, most = bend_bounds(tables, place, at, i, work[side + SIDE_ABSCISSA + i])
            row = scan + SCAN_NODES + SCAN_ROW * i
            low = tables[row + ROW_Y]
            high = tables[row + SCAN_ROW + ROW_Y]
            if lowest - most * (high - low) * (high - low) / 8.0 < work[side + SIDE_BEST]:
                own = known == 1 and work[side + SIDE_BEST_Y] >= low and work[side + SIDE_BEST_Y] <= high
                if not (own and least > 0.0):
                    search_cell(tables, work, side, place, at, state, least, most, low, high)
    search_ends(tables, work, side, place, at, state, first, last)
    return 1


def search_ends(tables: 'float[:]', work: 'float[:]', side: int, place: 'float[:]', at: int, state: 'float[:]',
                first: int, last: int):
    """Search between the outermost scan nodes and the rail's ends, where the gap falls outwards."""
    scan = int(tables[SET_SCAN])
    if first > 0 and work[side + SIDE_GAP + first] < work[side + SIDE_GAP + first + 1]:
        search_end(tables, work, side, place, at, state, first, -1)
    if last + 1 < int(tables[scan + SCAN_COUNT]) and work[side + SIDE_GAP + last] < work[side + SIDE_GAP + last - 1]:
        search_end(tables, work, side, place, at, state, last, 1)
    return 0


def search_end(tables: 'float[:]', work: 'float[:]', side: int, place: 'float[:]', at: int, state: 'float[:]', node: int,
               outward: int):
    """Search between scan node ``node`` and the end of the rail beyond it."""
    scan = int(tables[SET_SCAN])
    row = scan + SCAN_NODES + SCAN_ROW * node
    inner = tables[row + ROW_Y]
    inside = inner
    outside = tables[row + SCAN_ROW * outward + ROW_Y]
    while fabs(outside - inside) > END_SHARP:
        middle = 0.5 * (inside + outside)
        z, slope = height_slope(tables, int(tables[SET_WHEEL]), middle)
        y_track, z_track, outline_slope = outline_point(place, at, middle, z, slope)
        if above_rail(tables, y_track - tables[SET_RAIL_Y]) == 1:
            inside = middle
        else:
            outside = middle
    cell = node
    abscissa = work[side + SIDE_ABSCISSA + node]
    if outward < 0:
        cell = node - 1
        abscissa = tables[int(tables[SET_RAIL]) + START]
    least, most = bend_bounds(tables, place, at, cell, abscissa)
    if inside < inner:
        search_cell(tables, work, side, place, at, state, -1.0, most, inside, inner)
    elif inside > inner:
        search_cell(tables, work, side, place, at, state, -1.0, most, inner, inside)
    return 0


def search_cell(tables: 'float[:]', work: 'float[:]', side: int, place: 'float[:]', at: int, state: 'float[:]',
                least: float, most: float, first: float, last: float):
    """Local minima between ``first`` and ``last`` [m]: halve while a better value is possible, refine where the slope
    turns.  ``least`` and ``most`` bound the second derivative."""
    stack = side + SIDE_STACK
    gap_low, mismatch_low, rate = vertical_gap(tables, place, at, first)
    gap_high, mismatch_high, rate = vertical_gap(tables, place, at, last)
    state[STATE_GAP_COUNT] += 2.0
    push_cell(work, stack, first, last, gap_low, gap_high, mismatch_low, mismatch_high)
    depth = 1
    while depth > 0:
        depth -= 1
        top = stack + 6 * depth
        low = work[top]
        high = work[top + 1]
        gap_low = work[top + 2]
        gap_high = work[top + 3]
        mismatch_low = work[top + 4]
        mismatch_high = work[top + 5]
        width = high - low
        lowest = gap_low
        keep_best(work, side, low, gap_low)
        if gap_high < gap_low:
            lowest = gap_high
            keep_best(work, side, high, gap_high)
        if lowest - most * width * width / 8.0 < work[side + SIDE_BEST]:
            folded = mismatch_low == FOLDED or mismatch_high == FOLDED
            if mismatch_low < 0.0 and mismatch_high >= 0.0 and not folded:
                y, gap = refine_minimum(tables, place, at, state, low, high, mismatch_low, mismatch_high)
                keep_best(work, side, y, gap)
            elif width > NARROW and (folded or not least > 0.0):
                middle = 0.5 * (low + high)
                gap, mismatch, rate = vertical_gap(tables, place, at, middle)
                state[STATE_GAP_COUNT] += 1.0
                push_cell(work, top, low, middle, gap_low, gap, mismatch_low, mismatch)
                push_cell(work, top + 6, middle, high, gap, gap_high, mismatch, mismatch_high)
                depth += 2
    return 0


def push_cell(work: 'float[:]', top: int, low: float, high: float, gap_low: float, gap_high: float, mismatch_low: float,
              mismatch_high: float):
    """Write a cell to the stack at ``top``."""
    work[top] = low
    work[top + 1] = high
    work[top + 2] = gap_low
    work[top + 3] = gap_high
    work[top + 4] = mismatch_low
    work[top + 5] = mismatch_high
    return 0


def keep_best(work: 'float[:]', side: int, y: float, gap: float):
    """Keep (y, gap) if it is the side's best so far."""
    if gap < work[side + SIDE_BEST]:
        work[side + SIDE_BEST] = gap
        work[side + SIDE_BEST_Y] = y
    return 0


def refine_minimum(tables: 'float[:]', place: 'float[:]', at: int, state: 'float[:]', low: float, high: float,
                   mismatch_low: float, mismatch_high: float):
    """Abscissa [m] and gap [m] where the slope difference vanishes between ``low`` and ``high``: bracketed Newton."""
    y = low - mismatch_low * (high - low) / (mismatch_high - mismatch_low)
    gap = 0.0
    for i in range(60):
        gap, mismatch, rate = vertical_gap(tables, place, at, y)
        state[STATE_GAP_COUNT] += 1.0
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


def follow_minimum(tables: 'float[:]', work: 'float[:]', side: int, place: 'float[:]', at: int, state: 'float[:]'):
    """Refine the side's known minimum after a small change of pose; 1 if it is found again close by, else 0.

    Between nearly conformal profiles it can run away or vanish.
    """
    y = work[side + SIDE_BEST_Y]
    for k in range(FOLLOW_ITERATIONS):
        gap, mismatch, rate = vertical_gap(tables, place, at, y)
        state[STATE_GAP_COUNT] += 1.0
        if not rate > 0.0:
            return 0
        move = -mismatch / rate
        if fabs(move) < SHARP:
            work[side + SIDE_BEST] = gap
            work[side + SIDE_BEST_Y] = y
            return 1
        if not fabs(move) < LONGEST_MOVE:
            return 0
        y += move
    return 0
