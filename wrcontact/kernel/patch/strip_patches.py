"""From corrected strips to contact patches: edges, loads, areas, pressures, and the outline at evenly spaced stations.

A patch is a run of loaded strips that touch each other.  Near its edge the line load falls to zero in proportion to the
distance, so the edge is where the straight line through the last two strips' line loads ends.
"""

from math import atan, sqrt

from ..layout import REGION_LIMIT, WORK_ISLANDS, Work
from ..normal.strips import (
    STRIP_LINE,
    STRIP_PRESSURE,
    STRIP_REGION,
    STRIP_SQUARE,
    STRIP_STATION,
    STRIP_WIDTH,
    run_edge,
    run_end,
    strip_field,
)
from .patches import (
    ISLAND_AREA,
    ISLAND_HALF_LENGTH,
    ISLAND_LIMIT,
    ISLAND_LOAD,
    ISLAND_MOMENT,
    ISLAND_PRESSURE,
    ISLAND_SIZE,
    ISLAND_START,
    ISLAND_STOP,
    open_island,
    root_integral,
)


def divided_bend(work: 'float[:]', field: int, i: int):
    """Second divided difference of ``field`` over the strips ``i`` - 1, ``i``, ``i`` + 1."""
    stations = strip_field(STRIP_STATION)
    left = work[stations + i] - work[stations + i - 1]
    right = work[stations + i + 1] - work[stations + i]
    after = (work[field + i + 1] - work[field + i]) / right
    before = (work[field + i] - work[field + i - 1]) / left
    return (after - before) / (left + right)


def cell_bend(work: 'float[:]', field: int, i: int, first: int, last: int):
    """Second coefficient of ``field`` between strips ``i`` and ``i`` + 1 of the run first ... last."""
    bend = 0.0
    found = 0.0
    if i > first and i < last:
        bend += divided_bend(work, field, i)
        found += 1.0
    if i + 1 < last and i + 1 > first:
        bend += divided_bend(work, field, i + 1)
        found += 1.0
    if found > 0.0:
        bend /= found
    return bend


def cell_area(low: float, high: float, bend: float, width: float):
    """Integral over a cell of the root of the quadratic with end values ``low``, ``high`` and second coefficient
    ``bend``."""
    return width * root_integral(2.0 * low - high + 2.0 * bend * width * width, low, high, 0.0, 1.0)


def run_area(work: 'float[:]', first: int, last: int, start: float, stop: float):
    """Area [m^2] of the run first ... last between its edges."""
    stations = strip_field(STRIP_STATION)
    squares = strip_field(STRIP_SQUARE)
    bend = cell_bend(work, squares, first, first, last)
    half = cell_area(0.0, work[squares + first], bend, work[stations + first] - start)
    for i in range(first, last):
        bend = cell_bend(work, squares, i, first, last)
        half += cell_area(work[squares + i], work[squares + i + 1], bend, work[stations + i + 1] - work[stations + i])
    bend = cell_bend(work, squares, last - 1, first, last)
    half += cell_area(work[squares + last], 0.0, bend, stop - work[stations + last])
    return 2.0 * half


def top_value(work: 'float[:]', field: int, i: int, first: int, last: int):
    """Largest value of the parabola through strip ``i``, the largest of its run, and its neighbours in the run."""
    value = work[field + i]
    if i > first and i < last:
        stations = strip_field(STRIP_STATION)
        bend = divided_bend(work, field, i)
        if bend < 0.0:
            left = work[stations + i] - work[stations + i - 1]
            slope = (value - work[field + i - 1]) / left + bend * left
            value -= slope * slope / (4.0 * bend)
    return value


def largest_of(work: 'float[:]', field: int, first: int, last: int):
    """Strip with the largest value of ``field`` in a run."""
    best = first
    for i in range(first, last + 1):
        if work[field + i] > work[field + best]:
            best = i
    return best


def gather_strips(work: Work, strips: int):
    """Collect the runs of loaded strips as islands; their number."""
    for region in range(REGION_LIMIT):
        work.regions[region].carried = 0.0
        work.regions[region].moment = 0.0
    stations = strip_field(STRIP_STATION)
    widths = strip_field(STRIP_WIDTH)
    lines = strip_field(STRIP_LINE)
    squares = strip_field(STRIP_SQUARE)
    pressures = strip_field(STRIP_PRESSURE)
    islands = 0
    first = 0
    while first < strips and islands < ISLAND_LIMIT:
        last = first
        if work[lines + first] > 0.0:
            last = run_end(work.raw, strips, first)
            block = work.regions[int(work[strip_field(STRIP_REGION) + first])]
            start = run_edge(work.raw, strips, first, last, -1)
            stop = run_edge(work.raw, strips, last, first, 1)
            open_island(work.raw, islands, start, -atan(block.lean))
            at = WORK_ISLANDS + ISLAND_SIZE * islands
            for i in range(first, last + 1):
                load = work[lines + i] * work[widths + i]
                work[at + ISLAND_LOAD] += load
                work[at + ISLAND_MOMENT] += load * work[stations + i]
                carrier = work.regions[int(work[strip_field(STRIP_REGION) + i])]
                carrier.carried += load
                carrier.moment += load * work[stations + i]
            work[at + ISLAND_STOP] = stop
            work[at + ISLAND_AREA] = run_area(work.raw, first, last, start, stop)
            pressure = top_value(work.raw, pressures, largest_of(work.raw, pressures, first, last), first, last)
            work[at + ISLAND_PRESSURE] = pressure * pressure
            work[at + ISLAND_HALF_LENGTH] = top_value(work.raw, squares, largest_of(work.raw, squares, first, last), first, last)
            islands += 1
        first = last + 1
    return islands


def write_strip_outline(work: 'float[:]', place: int, count: int, strips: int, islands: int):
    """Half-length and pressure at ``count`` stations from the first edge to the last, to ``place``."""
    start = work[WORK_ISLANDS + ISLAND_START]
    stop = work[WORK_ISLANDS + ISLAND_SIZE * (islands - 1) + ISLAND_STOP]
    stations = strip_field(STRIP_STATION)
    squares = strip_field(STRIP_SQUARE)
    pressures = strip_field(STRIP_PRESSURE)
    island = 0
    i = 0
    for j in range(count):
        station = start + (stop - start) * float(j) / float(count - 1)
        half = 0.0
        pressure = 0.0
        while island < islands - 1 and station > work[WORK_ISLANDS + ISLAND_SIZE * island + ISLAND_STOP]:
            island += 1
        at = WORK_ISLANDS + ISLAND_SIZE * island
        if j > 0 and j < count - 1 and station > work[at + ISLAND_START] and station < work[at + ISLAND_STOP]:
            while i < strips and work[stations + i] < station:
                i += 1
            # between strips i - 1 and i, or between one of them and the edge
            low = work[at + ISLAND_START]
            low_square = 0.0
            low_pressure = 0.0
            if i > 0:
                if work[stations + i - 1] > low:
                    low = work[stations + i - 1]
                    low_square = work[squares + i - 1]
                    low_pressure = work[pressures + i - 1]
            high = work[at + ISLAND_STOP]
            high_square = 0.0
            high_pressure = 0.0
            if i < strips:
                if work[stations + i] < high:
                    high = work[stations + i]
                    high_square = work[squares + i]
                    high_pressure = work[pressures + i]
            share = (station - low) / (high - low)
            half = sqrt(low_square + share * (high_square - low_square))
            pressure = sqrt(low_pressure * low_pressure
                            + share * (high_pressure * high_pressure - low_pressure * low_pressure))
        work[place + j] = station
        work[place + count + j] = half
        work[place + 2 * count + j] = pressure
    return 0
