"""From solved regions to contact patches: loads, areas, pressures, centroids, and the outline at evenly spaced stations.

A patch is a connected run of loaded strips.  Between nodes the line load and the squares of half-length and pressure
are the quadratics through the cell's nodes and its inner neighbour, so that an ellipse comes out exact.
"""

from math import atan, atan2, fabs, pi, sqrt
from typing import Final

from ..layout import PATCH_LIMIT, WORK_ISLANDS, Patch, SideOutputs, Work
from ..normal.analyn import bend_of, cell_part, clip_to_bound, quadratic_integral
from ..normal.nodes import (
    NODE_LENGTH,
    NODE_LINE,
    NODE_LOAD,
    NODE_PRESSURE,
    NODE_RISE,
    NODE_SQUARE,
    node_field,
)

# an island: a run of loaded cells under construction
ISLAND_SIZE: Final[int] = 10
ISLAND_LIMIT: Final[int] = 8
ISLAND_LOAD: Final[int] = 0
ISLAND_AREA: Final[int] = 1
ISLAND_MOMENT: Final[int] = 2        # integral of the line load times station [N m]
ISLAND_PRESSURE: Final[int] = 3      # squares of the largest pressure and half-length
ISLAND_HALF_LENGTH: Final[int] = 4
ISLAND_START: Final[int] = 5
ISLAND_STOP: Final[int] = 6
ISLAND_ANGLE: Final[int] = 7

#: Bend, as a share of the end values, below which a quadratic is expanded about its chord: leaves the square of it.
STRAIGHT: Final[float] = 1e-4
#: Loaded parts closer than this share of the spacing are one patch.
JOINED: Final[float] = 1e-9


def quadratic_moment(before: float, low: float, high: float, start: float, stop: float):
    """Integral over [start, stop] of x times the quadratic of ``bend_of``."""
    bend = bend_of(before, low, high)
    slope = high - low - bend
    upper = stop * stop * (low / 2.0 + stop * (slope / 3.0 + stop * bend / 4.0))
    lower = start * start * (low / 2.0 + start * (slope / 3.0 + start * bend / 4.0))
    return upper - lower


def bent_integral(low: float, slope: float, bend: float, start: float, stop: float):
    """Integral over [start, stop] of sqrt(low + slope x + bend x^2) for bend < 0, in closed form.

    The angle between both ends is taken from the roots themselves, not from how far x has come: at the end of a loaded
    stretch the rounding of root and angle then cancels.
    """
    first = low + start * (slope + start * bend)
    last = low + stop * (slope + stop * bend)
    if first < 0.0:
        first = 0.0
    if last < 0.0:
        last = 0.0
    spread = slope * slope - 4.0 * bend * low
    if not spread > 0.0:
        return 0.0
    first_root = sqrt(first)
    last_root = sqrt(last)
    first_rate = 2.0 * bend * start + slope
    last_rate = 2.0 * bend * stop + slope
    across = sqrt(-bend)
    height = 2.0 * across * last_root
    height_before = 2.0 * across * first_root
    angle = atan2(height * first_rate - height_before * last_rate, height * height_before + last_rate * first_rate)
    return ((last_rate * last_root - first_rate * first_root) / (4.0 * bend)
            + spread / (8.0 * -bend * across) * angle)


def root_integral(before: float, low: float, high: float, start: float, stop: float):
    """Integral over [start, stop] of the square root of the quadratic of ``bend_of``, which is not negative there.

    In closed form where the quadratic bends down noticeably.  Otherwise with the roots p, q of the end values and the
    width w, expanded about the chord: w [2/3 (p^2 + p q + q^2)/(p + q) - 2/15 bend w^2 (p^2 + 3 p q + q^2)/(p + q)^3].
    """
    bend = bend_of(before, low, high)
    slope = high - low - bend
    if bend < -STRAIGHT * (fabs(low) + fabs(high)):
        return bent_integral(low, slope, bend, start, stop)
    first = low + start * (slope + start * bend)
    last = low + stop * (slope + stop * bend)
    if first < 0.0:
        first = 0.0
    if last < 0.0:
        last = 0.0
    p = sqrt(first)
    q = sqrt(last)
    total = p + q
    if not total > 0.0:
        return 0.0
    width = stop - start
    chord = 2.0 / 3.0 * (first + p * q + last) / total
    return width * (chord - 2.0 / 15.0 * bend * width * width * (first + 3.0 * p * q + last) / (total * total * total))


def load_nodes(work: Work, region: int, level: float):
    """Line load, square of half-length and of pressure at the region's nodes for its ``level`` [m]."""
    block = work.regions[region]
    rises = node_field(region, NODE_RISE)
    lines = node_field(region, NODE_LINE)
    lengths = node_field(region, NODE_LENGTH)
    loads = node_field(region, NODE_LOAD)
    squares = node_field(region, NODE_SQUARE)
    pressures = node_field(region, NODE_PRESSURE)
    for k in range(block.first, block.last + 1):
        d = level - work[rises + k]
        load = work[lines + k] * d
        work[loads + k] = load
        work[squares + k] = d / work[lengths + k]
        # p0 = (2/pi) (E*/(n r)) sqrt(d (1 + alpha) A)
        work[pressures + k] = 4.0 / (pi * pi) * work[lines + k] * load * work[lengths + k]
    return 0


def peak_square(work: 'float[:]', field: int, k: int):
    """Square of the largest value of the parabola through the roots at nodes ``k`` - 1, ``k``, ``k`` + 1 of a field of
    squares, where node ``k`` is a peak and both neighbours are loaded; else the node's own."""
    square = work[field + k]
    before = work[field + k - 1]
    after = work[field + k + 1]
    if before > 0.0 and after > 0.0 and square >= before and square >= after:
        top = sqrt(square)
        left = sqrt(before)
        right = sqrt(after)
        bend = left - 2.0 * top + right
        if bend < 0.0:
            top -= (right - left) * (right - left) / (8.0 * bend)
            square = top * top
    return square


def open_island(work: 'float[:]', count: int, start: float, angle: float):
    """Begin island ``count`` at station ``start``."""
    at = WORK_ISLANDS + ISLAND_SIZE * count
    for i in range(ISLAND_SIZE):
        work[at + i] = 0.0
    work[at + ISLAND_START] = start
    work[at + ISLAND_STOP] = start
    work[at + ISLAND_ANGLE] = angle
    return 0


def gather_islands(tables: 'float[:]', work: Work, count: int):
    """Walk over all regions by rising station and collect the islands; their number."""
    islands = 0
    for region in range(count):
        block = work.regions[region]
        level = block.level
        block.carried = 0.0
        block.moment = 0.0
        if level > 0.0:
            angle = -atan(block.lean)
            load_nodes(work, region, level)
            for k in range(block.first, block.last):
                islands = gather_cell(work, region, level, k, islands, angle)
    return islands


def gather_cell(work: Work, region: int, level: float, k: int, islands: int, angle: float):
    """Add the cell between nodes ``k`` and ``k`` + 1 to the last island, or to a new one; the number of islands."""
    block = work.regions[region]
    spacing = block.spacing
    outward = 1
    low = k
    if k < 0:
        outward = -1
        low = k + 1
    before = low - outward
    high = low + outward
    rises = node_field(region, NODE_RISE)
    start, stop = cell_part(level - work[rises + before], level - work[rises + low], level - work[rises + high])
    if k == block.first or k == block.last - 1:
        stop = clip_to_bound(work, block, low, outward, stop)
    if stop > start:
        inner = block.offset + block.station + spacing * float(low)
        begin = inner + spacing * start
        end = inner + spacing * stop
        if outward < 0:
            begin = inner - spacing * stop
            end = inner - spacing * start
        joined = 0
        if islands > 0:
            if begin - work[WORK_ISLANDS + ISLAND_SIZE * (islands - 1) + ISLAND_STOP] < JOINED * spacing:
                joined = 1
        if joined == 0 and islands < ISLAND_LIMIT:
            open_island(work.raw, islands, begin, angle)
            islands += 1
        at = WORK_ISLANDS + ISLAND_SIZE * (islands - 1)
        work[at + ISLAND_STOP] = end
        add_cell(work, region, before, low, high, start, stop, at, inner, spacing * float(outward))
    return islands


def add_cell(work: Work, region: int, before: int, low: int, high: int, start: float, stop: float, at: int,
             inner: float, step: float):
    """Add load, moment and area of a cell's loaded part to the island at ``at``, and its inner node's extremes."""
    loads = node_field(region, NODE_LOAD)
    squares = node_field(region, NODE_SQUARE)
    pressures = node_field(region, NODE_PRESSURE)
    width = fabs(step)
    load = width * quadratic_integral(work[loads + before], work[loads + low], work[loads + high], start, stop)
    moment = quadratic_moment(work[loads + before], work[loads + low], work[loads + high], start, stop)
    area = root_integral(work[squares + before], work[squares + low], work[squares + high], start, stop)
    moment = inner * load + width * step * moment
    work.regions[region].carried += load
    work.regions[region].moment += moment
    work[at + ISLAND_LOAD] += load
    work[at + ISLAND_MOMENT] += moment
    work[at + ISLAND_AREA] += 2.0 * width * area
    if work[squares + low] > work[at + ISLAND_HALF_LENGTH]:
        work[at + ISLAND_HALF_LENGTH] = peak_square(work.raw, squares, low)
    if work[pressures + low] > work[at + ISLAND_PRESSURE]:
        work[at + ISLAND_PRESSURE] = peak_square(work.raw, pressures, low)
    return 0


def write_patches(work: Work, side: SideOutputs, islands: int):
    """The side's totals and its heaviest patches, from the islands, into the outputs at ``side``."""
    load = 0.0
    area = 0.0
    moment = 0.0
    pressure = 0.0
    half = 0.0
    for i in range(islands):
        at = WORK_ISLANDS + ISLAND_SIZE * i
        load += work[at + ISLAND_LOAD]
        area += work[at + ISLAND_AREA]
        moment += work[at + ISLAND_MOMENT]
        if work[at + ISLAND_PRESSURE] > pressure:
            pressure = work[at + ISLAND_PRESSURE]
        if work[at + ISLAND_HALF_LENGTH] > half:
            half = work[at + ISLAND_HALF_LENGTH]
    side.patch_count = float(islands)
    side.normal_force = load
    side.area = area
    side.max_pressure = sqrt(pressure)
    side.patch_length = 2.0 * sqrt(half)
    if islands > 0:
        last = WORK_ISLANDS + ISLAND_SIZE * (islands - 1)
        side.patch_width = work[last + ISLAND_STOP] - work[WORK_ISLANDS + ISLAND_START]
        side.patch_centroid = moment / load
    for rank in range(PATCH_LIMIT):
        heaviest = -1
        for i in range(islands):
            at = WORK_ISLANDS + ISLAND_SIZE * i
            if work[at + ISLAND_LOAD] > 0.0:
                if heaviest < 0:
                    heaviest = at
                elif work[at + ISLAND_LOAD] > work[heaviest + ISLAND_LOAD]:
                    heaviest = at
        if heaviest >= 0:
            write_patch(work, side.patch[rank], heaviest)
            work[heaviest + ISLAND_LOAD] = 0.0
    return 0


def write_patch(work: Work, to: Patch, at: int):
    """One patch from the island at ``at`` to the outputs at ``to``."""
    to.normal_force = work[at + ISLAND_LOAD]
    to.area = work[at + ISLAND_AREA]
    to.max_pressure = sqrt(work[at + ISLAND_PRESSURE])
    to.length = 2.0 * sqrt(work[at + ISLAND_HALF_LENGTH])
    to.width = work[at + ISLAND_STOP] - work[at + ISLAND_START]
    to.centroid = work[at + ISLAND_MOMENT] / work[at + ISLAND_LOAD]
    to.contact_angle = work[at + ISLAND_ANGLE]
    return 0


def write_outline(work: Work, side: SideOutputs, place: int, stations: int, count: int, islands: int):
    """Half-length and pressure at ``stations`` stations from the first loaded station to the last, to ``place``."""
    if islands > 0:
        start = work[WORK_ISLANDS + ISLAND_START]
        stop = work[WORK_ISLANDS + ISLAND_SIZE * (islands - 1) + ISLAND_STOP]
        for j in range(stations):
            station = start + (stop - start) * float(j) / float(stations - 1)
            half = 0.0
            pressure = 0.0
            if j > 0 and j < stations - 1:
                for region in range(count):
                    block = work.regions[region]
                    own = station - block.offset
                    if own >= block.low and own <= block.high and half == 0.0:
                        half, pressure = strip_at(work, region, own)
            # between nodes a root can overshoot at a kink
            if half > 0.5 * side.patch_length:
                half = 0.5 * side.patch_length
            if pressure > side.max_pressure:
                pressure = side.max_pressure
            work[place + j] = station
            work[place + stations + j] = half
            work[place + 2 * stations + j] = pressure
    return 0


def strip_at(work: Work, region: int, station: float):
    """Half-length [m] and pressure [Pa] of ``region`` at ``station``; zeros where it is not loaded."""
    block = work.regions[region]
    level = block.level
    half = 0.0
    pressure = 0.0
    u = (station - block.station) / block.spacing
    inside = u > block.first and u < block.last
    if level > 0.0 and inside:
        outward = 1
        if u < 0.0:
            outward = -1
            u = -u
        low = int(u)
        x = u - float(low)
        low = outward * low
        squares = node_field(region, NODE_SQUARE) + low
        pressures = node_field(region, NODE_PRESSURE) + low
        length = quadratic_value(work[squares - outward], work[squares], work[squares + outward], x)
        square = quadratic_value(work[pressures - outward], work[pressures], work[pressures + outward], x)
        if length > 0.0 and square > 0.0:
            half = sqrt(length)
            pressure = sqrt(square)
    return half, pressure


def quadratic_value(before: float, low: float, high: float, x: float):
    """The quadratic of ``bend_of`` at x."""
    bend = bend_of(before, low, high)
    return low + x * (high - low - bend + x * bend)
