"""From corrected strips to contact patches: edges, loads, areas and pressures.

A patch is a run of loaded strips that touch each other.  Near its edge the line load falls to zero in proportion to the
distance, so the edge is where the straight line through the last two strips' line loads ends.
"""

from math import atan, sqrt

from ..layout import REGION_LIMIT, RULE_STRAIGHT, SOLVED_PATCH_LIMIT, Work
from ..normal.strips import (
    STRIP_A,
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
from .filling import begin_patch, clear_patches, finish_patch, finish_patches
from .quadrature import root_integral


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
    """Fill the solved patches from the runs of loaded strips."""
    for region in range(REGION_LIMIT):
        work.regions[region].carried = 0.0
        work.regions[region].moment = 0.0
    clear_patches(work.solved)
    stations = strip_field(STRIP_STATION)
    widths = strip_field(STRIP_WIDTH)
    lines = strip_field(STRIP_LINE)
    squares = strip_field(STRIP_SQUARE)
    pressures = strip_field(STRIP_PRESSURE)
    first = 0
    while first < strips and work.solved.count < SOLVED_PATCH_LIMIT:
        last = first
        if work[lines + first] > 0.0:
            last = run_end(work.raw, strips, first)
            block = work.regions[int(work[strip_field(STRIP_REGION) + first])]
            start = run_edge(work.raw, strips, first, last, -1)
            stop = run_edge(work.raw, strips, last, first, 1)
            index = begin_patch(work.solved, block, start, first, RULE_STRAIGHT, -atan(block.lean))
            patch = work.solved.patches[index]
            for i in range(first, last + 1):
                load = work[lines + i] * work[widths + i]
                patch.totals.load += load
                patch.totals.moment += load * work[stations + i]
                region = int(work[strip_field(STRIP_REGION) + i])
                carrier = work.regions[region]
                carrier.carried += load
                carrier.moment += load * work[stations + i]
                strip = work.solved.strips[i]
                strip.station = work[stations + i]
                strip.width = work[widths + i]
                strip.x = carrier.along + carrier.slant * (work[stations + i] - carrier.offset - carrier.station)
                strip.curvature = 2.0 * work[strip_field(STRIP_A) + i]
                strip.line_load = work[lines + i]
                strip.half_length_square = work[squares + i]
                strip.pressure_square = work[pressures + i] * work[pressures + i]
            patch.totals.stop = stop
            patch.last = last
            patch.totals.area = run_area(work.raw, first, last, start, stop)
            pressure = top_value(work.raw, pressures, largest_of(work.raw, pressures, first, last), first, last)
            work.solved.pressure_square = pressure * pressure
            work.solved.half_length_square = top_value(work.raw, squares, largest_of(work.raw, squares, first, last), first, last)
            finish_patch(work.solved)
        first = last + 1
    finish_patches(work.solved)
    return 0
