"""The smallest vertical gap of one side: scan, bound, refine.

The gap has up to three local minima (tread, flange root, flange) that exchange rank.  The scan nodes lie on a fixed
raster of the wheel profile; between two nodes the gap lies above its chord by no less than -M h^2 / 8, where M bounds
its second derivative.  Every cell that could hold a value within MARGIN of the best is searched, so the global minimum
is bounded and not assumed.
"""

from math import fabs
from typing import Final

from .gap import above_rail, vertical_gap
from .layout import (MINIMUM_LIMIT, SET_RAIL, SET_RAIL_Y, SET_SCAN, SET_WHEEL, SIDE_ABSCISSA, SIDE_BEST, SIDE_BEST_Y,
                     SIDE_FIRST, SIDE_GAP, SIDE_LAST, SIDE_MINIMUM_COUNT, SIDE_MINIMUM_GAP, SIDE_MINIMUM_Y,
                     SIDE_MISMATCH, SIDE_STACK, STATE_GAP_COUNT, STATE_SCAN_COUNT)
from .locus import outline_point
from .profile_table import height_slope

# the scan table: node count, first node [m], spacing [m], then the two bounds' rasters and the nodes
SCAN_COUNT: Final[int] = 0
SCAN_START: Final[int] = 1
SCAN_STEP: Final[int] = 2
SCAN_RAIL_COUNT: Final[int] = 3      # raster of the rail's largest second derivative
SCAN_RAIL_START: Final[int] = 4
SCAN_RAIL_STEP: Final[int] = 5
SCAN_RAIL_OFFSET: Final[int] = 6
SCAN_NODES: Final[int] = 8
SCAN_ROW: Final[int] = 3             # height, slope, smallest second derivative up to the next node

#: Minima this close to the smallest gap are followed while the roll changes by less than REACH [m].
MARGIN: Final[float] = 1e-5
#: Largest change of roll that cannot bring another minimum to the top [rad]: the lever arms of two wheel points differ
#: by less than 4 m (75 deg flanges included), so MARGIN / 4 m.
REACH: Final[float] = 2.5e-6
#: Cells are halved down to this width [m]; what a cell can then hide is less than M (6e-5 m)^2 / 8, 1e-8 m at worst.
NARROW: Final[float] = 6.5e-5
#: Abscissa to which a minimum is refined [m]; its gap is then exact to rounding, being second order.
SHARP: Final[float] = 1e-13
#: A known minimum that moves by more than this in a Newton step is looked for anew [m].
LONGEST_MOVE: Final[float] = 1e-4
FOLLOW_ITERATIONS: Final[int] = 12
#: The end of the rail is located to this [m].
END_SHARP: Final[float] = 1e-9
LARGE_GAP: Final[float] = 1e3


def scan_side(tables: 'float[:]', work: 'float[:]', side: int, place: 'float[:]', at: int, state: 'float[:]'):
    """Gap and slope difference at all scan nodes above the rail; 1 if there are at least two, else 0."""
    scan = int(tables[SET_SCAN])
    rail = int(tables[SET_RAIL])
    count = int(tables[scan + SCAN_COUNT])
    first = -1
    last = -1
    best = LARGE_GAP
    for i in range(count):
        row = scan + SCAN_NODES + SCAN_ROW * i
        y = tables[scan + SCAN_START] + tables[scan + SCAN_STEP] * float(i)
        y_track, z_track, outline_slope = outline_point(place, at, y, tables[row], tables[row + 1])
        abscissa = y_track - tables[SET_RAIL_Y]
        gap = LARGE_GAP
        mismatch = 0.0
        if above_rail(tables, abscissa) == 1:
            z_rail, rail_slope = height_slope(tables, rail, abscissa)
            gap = z_rail - z_track
            mismatch = rail_slope - outline_slope
            if first < 0:
                first = i
            last = i
            if gap < best:
                best = gap
                work[side + SIDE_BEST_Y] = y
        work[side + SIDE_GAP + i] = gap
        work[side + SIDE_MISMATCH + i] = mismatch
        work[side + SIDE_ABSCISSA + i] = abscissa
    work[side + SIDE_FIRST] = float(first)
    work[side + SIDE_LAST] = float(last)
    work[side + SIDE_BEST] = best
    work[side + SIDE_MINIMUM_COUNT] = 0.0
    state[STATE_GAP_COUNT] += float(last - first + 1)
    state[STATE_SCAN_COUNT] += 1.0
    found = 0
    if last > first:
        found = 1
    return found


def largest_bend(tables: 'float[:]', work: 'float[:]', side: int, cell: int):
    """Bound M [1/m] on the gap's second derivative between scan nodes ``cell`` and ``cell`` + 1.

    Rail minus wheel; 1.3 covers what yaw and roll change in either (6 deg of yaw change a slope's rate by less).
    """
    scan = int(tables[SET_SCAN])
    u = (work[side + SIDE_ABSCISSA + cell] - tables[scan + SCAN_RAIL_START]) / tables[scan + SCAN_RAIL_STEP]
    if not u > 0.0:
        u = 0.0
    if u > tables[scan + SCAN_RAIL_COUNT] - 1.0:
        u = tables[scan + SCAN_RAIL_COUNT] - 1.0
    rail_bend = tables[scan + int(tables[scan + SCAN_RAIL_OFFSET]) + int(u)]
    wheel_bend = tables[scan + SCAN_NODES + SCAN_ROW * cell + 2]
    bound = 1.3 * rail_bend
    if wheel_bend > 0.0:
        bound -= 0.7 * wheel_bend
    else:
        bound -= 1.3 * wheel_bend
    if not bound > 0.0:
        bound = 0.0
    return bound


def find_minima(tables: 'float[:]', work: 'float[:]', side: int, place: 'float[:]', at: int, state: 'float[:]'):
    """All local minima within MARGIN of the smallest gap, into the side's list; the smallest into SIDE_BEST."""
    scan = int(tables[SET_SCAN])
    step = tables[scan + SCAN_STEP]
    first = int(work[side + SIDE_FIRST])
    last = int(work[side + SIDE_LAST])
    for i in range(first, last):
        bend = largest_bend(tables, work, side, i)
        lowest = work[side + SIDE_GAP + i]
        if work[side + SIDE_GAP + i + 1] < lowest:
            lowest = work[side + SIDE_GAP + i + 1]
        if lowest - bend * step * step / 8.0 < work[side + SIDE_BEST] + MARGIN:
            low = tables[scan + SCAN_START] + step * float(i)
            search_cell(tables, work, side, place, at, state, bend, low, low + step, work[side + SIDE_GAP + i],
                        work[side + SIDE_GAP + i + 1], work[side + SIDE_MISMATCH + i],
                        work[side + SIDE_MISMATCH + i + 1])
    if work[side + SIDE_MISMATCH + first] > 0.0 and first > 0:
        search_end(tables, work, side, place, at, state, first, -1)
    if work[side + SIDE_MISMATCH + last] < 0.0 and last + 1 < int(tables[scan + SCAN_COUNT]):
        search_end(tables, work, side, place, at, state, last, 1)
    return 0


def search_end(tables: 'float[:]', work: 'float[:]', side: int, place: 'float[:]', at: int, state: 'float[:]', node: int,
               outward: int):
    """Search between scan node ``node``, where the gap falls outwards, and the end of the rail beyond it."""
    scan = int(tables[SET_SCAN])
    inner = tables[scan + SCAN_START] + tables[scan + SCAN_STEP] * float(node)
    inside = inner
    outside = inner + tables[scan + SCAN_STEP] * float(outward)
    while fabs(outside - inside) > END_SHARP:
        middle = 0.5 * (inside + outside)
        z, slope = height_slope(tables, int(tables[SET_WHEEL]), middle)
        y_track, z_track, outline_slope = outline_point(place, at, middle, z, slope)
        if above_rail(tables, y_track - tables[SET_RAIL_Y]) == 1:
            inside = middle
        else:
            outside = middle
    gap, mismatch, rate = vertical_gap(tables, place, at, inside)
    state[STATE_GAP_COUNT] += 1.0
    cell = node
    if outward < 0:
        cell = node - 1
    bend = largest_bend(tables, work, side, cell)
    if inside < inner:
        search_cell(tables, work, side, place, at, state, bend, inside, inner, gap, work[side + SIDE_GAP + node],
                    mismatch, work[side + SIDE_MISMATCH + node])
    elif inside > inner:
        search_cell(tables, work, side, place, at, state, bend, inner, inside, work[side + SIDE_GAP + node], gap,
                    work[side + SIDE_MISMATCH + node], mismatch)
    return 0


def search_cell(tables: 'float[:]', work: 'float[:]', side: int, place: 'float[:]', at: int, state: 'float[:]',
                bend: float, first: float, last: float, gap_first: float, gap_last: float, mismatch_first: float,
                mismatch_last: float):
    """Local minima in a cell: halve while the bound allows a better value, refine where the slope turns."""
    stack = side + SIDE_STACK
    work[stack] = first
    work[stack + 1] = last
    work[stack + 2] = gap_first
    work[stack + 3] = gap_last
    work[stack + 4] = mismatch_first
    work[stack + 5] = mismatch_last
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
        if gap_high < gap_low:
            lowest = gap_high
        if lowest - bend * width * width / 8.0 < work[side + SIDE_BEST] + MARGIN:
            if mismatch_low < 0.0 and mismatch_high >= 0.0:
                y, gap = refine_minimum(tables, place, at, state, low, high, mismatch_low, mismatch_high)
                keep_minimum(work, side, y, gap)
            elif width > NARROW:
                middle = 0.5 * (low + high)
                gap, mismatch, rate = vertical_gap(tables, place, at, middle)
                state[STATE_GAP_COUNT] += 1.0
                if gap < work[side + SIDE_BEST]:
                    work[side + SIDE_BEST] = gap
                    work[side + SIDE_BEST_Y] = middle
                work[top] = low
                work[top + 1] = middle
                work[top + 2] = gap_low
                work[top + 3] = gap
                work[top + 4] = mismatch_low
                work[top + 5] = mismatch
                work[top + 6] = middle
                work[top + 7] = high
                work[top + 8] = gap
                work[top + 9] = gap_high
                work[top + 10] = mismatch
                work[top + 11] = mismatch_high
                depth += 2
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


def keep_minimum(work: 'float[:]', side: int, y: float, gap: float):
    """Add a local minimum to the side's list, in place of the worst one when it is full."""
    count = int(work[side + SIDE_MINIMUM_COUNT])
    slot = count
    if count == MINIMUM_LIMIT:
        slot = 0
        for i in range(1, MINIMUM_LIMIT):
            if work[side + SIDE_MINIMUM_GAP + i] > work[side + SIDE_MINIMUM_GAP + slot]:
                slot = i
    else:
        work[side + SIDE_MINIMUM_COUNT] = float(count + 1)
    if count < MINIMUM_LIMIT or gap < work[side + SIDE_MINIMUM_GAP + slot]:
        work[side + SIDE_MINIMUM_Y + slot] = y
        work[side + SIDE_MINIMUM_GAP + slot] = gap
    if gap <= work[side + SIDE_BEST]:
        work[side + SIDE_BEST] = gap
        work[side + SIDE_BEST_Y] = y
    return 0


def follow_minima(tables: 'float[:]', work: 'float[:]', side: int, place: 'float[:]', at: int, state: 'float[:]'):
    """Refine the listed minima after a small change of roll; the smallest goes into SIDE_BEST.

    1 if all were found again close by, else 0: between nearly conformal profiles a minimum can run away or vanish, and
    the side must be scanned anew.
    """
    if work[side + SIDE_MINIMUM_COUNT] < 1.0:
        return 0
    best = LARGE_GAP
    for i in range(int(work[side + SIDE_MINIMUM_COUNT])):
        y = work[side + SIDE_MINIMUM_Y + i]
        met = 0
        for k in range(FOLLOW_ITERATIONS):
            gap, mismatch, rate = vertical_gap(tables, place, at, y)
            state[STATE_GAP_COUNT] += 1.0
            if not rate > 0.0:
                return 0
            move = -mismatch / rate
            if fabs(move) < SHARP:
                met = 1
                break
            if fabs(move) > LONGEST_MOVE:
                return 0
            y += move
        if met == 0:
            return 0
        work[side + SIDE_MINIMUM_Y + i] = y
        work[side + SIDE_MINIMUM_GAP + i] = gap
        if gap < best:
            best = gap
            work[side + SIDE_BEST] = gap
            work[side + SIDE_BEST_Y] = y
    return 1
