"""From corrected strips to solved patches: each run of loaded strips that touch each other is a patch."""

from math import atan

from ..layout import (
    REGION_LIMIT,
    RULE_STRAIGHT,
    SOLVED_PATCH_LIMIT,
    Region,
    Regions,
    SolvedPatch,
    SolvedPatches,
    SolvedStrip,
    Strip,
    StripProblem,
    Strips,
)
from ..patch.filling import add_part, begin_patch, clear_patches, finish_patch, finish_patches
from ..patch.quadrature import root_integral
from .strip_edges import run_edge, run_end


def fill_from_strips(problem: StripProblem, regions: Regions, solved: SolvedPatches):
    """Fill the solved patches from the runs of loaded strips."""
    for index in range(REGION_LIMIT):
        regions[index].carried = 0.0
        regions[index].moment = 0.0
    clear_patches(solved)
    strips = problem.strips
    count = problem.count
    first = 0
    while first < count and solved.count < SOLVED_PATCH_LIMIT:
        last = first
        if strips[first].line_load > 0.0:
            last = run_end(strips, count, first)
            start = run_edge(strips, count, first, last, -1)
            stop = run_edge(strips, count, last, first, 1)
            region = regions[strips[first].region]
            index = begin_patch(solved, region, start, first, RULE_STRAIGHT, -atan(region.inclination))
            patch = solved.patches[index]
            for i in range(first, last + 1):
                add_strip(patch, regions[strips[i].region], strips[i], solved.strips[i])
                load = strips[i].line_load * strips[i].width
                add_part(solved, index, strips[i].region, load, load * strips[i].station)
            patch.totals.stop = stop
            patch.last = last
            patch.totals.area = run_area(strips, first, last, start, stop)
            pressure = largest_pressure(strips, first, last)
            solved.pressure_square = pressure * pressure
            solved.half_length_square = largest_square(strips, first, last)
            finish_patch(solved)
        first = last + 1
    finish_patches(solved)
    return 0


def add_strip(patch: SolvedPatch, region: Region, strip: Strip, to: SolvedStrip):
    """Add a strip of ``region`` to a patch, as the solved strip ``to``, and its load to the region."""
    load = strip.line_load * strip.width
    patch.totals.load += load
    patch.totals.moment += load * strip.station
    region.carried += load
    region.moment += load * strip.station
    to.station = strip.station
    to.width = strip.width
    to.x = region.x_track + region.slant * (strip.station - region.offset - region.station)
    to.curvature = strip.curvature
    to.line_load = strip.line_load
    to.half_length_square = strip.half_length_square
    to.pressure_square = strip.pressure * strip.pressure
    return 0


def divided_bend(strips: Strips, i: int, before: float, value: float, after: float):
    """Second divided difference of a quantity with these values at the strips ``i`` - 1, ``i``, ``i`` + 1."""
    left = strips[i].station - strips[i - 1].station
    right = strips[i + 1].station - strips[i].station
    upper = (after - value) / right
    lower = (value - before) / left
    return (upper - lower) / (left + right)


def square_bend(strips: Strips, i: int):
    """Second divided difference of the square of the half-length at strip ``i`` [-]."""
    before = strips[i - 1].half_length_square
    return divided_bend(strips, i, before, strips[i].half_length_square, strips[i + 1].half_length_square)


def cell_bend(strips: Strips, i: int, first: int, last: int):
    """Second coefficient of the square of the half-length between strips ``i`` and ``i`` + 1 of the run first
    ... last [-]."""
    bend = 0.0
    found = 0.0
    if i > first and i < last:
        bend += square_bend(strips, i)
        found += 1.0
    if i + 1 < last and i + 1 > first:
        bend += square_bend(strips, i + 1)
        found += 1.0
    if found > 0.0:
        bend /= found
    return bend


def cell_area(low: float, high: float, bend: float, width: float):
    """Integral over a cell of the root of the quadratic with end values ``low``, ``high`` [m^2] and second
    coefficient ``bend``."""
    return width * root_integral(2.0 * low - high + 2.0 * bend * width * width, low, high, 0.0, 1.0)


def run_area(strips: Strips, first: int, last: int, start: float, stop: float):
    """Area [m^2] of the run first ... last between its edges ``start`` and ``stop`` [m]."""
    bend = cell_bend(strips, first, first, last)
    half = cell_area(0.0, strips[first].half_length_square, bend, strips[first].station - start)
    for i in range(first, last):
        bend = cell_bend(strips, i, first, last)
        half += cell_area(strips[i].half_length_square, strips[i + 1].half_length_square, bend,
                          strips[i + 1].station - strips[i].station)
    bend = cell_bend(strips, last - 1, first, last)
    half += cell_area(strips[last].half_length_square, 0.0, bend, stop - strips[last].station)
    return 2.0 * half


def summit(strips: Strips, i: int, before: float, value: float, after: float):
    """Largest value of the parabola through a quantity at strip ``i``, where it is largest, and at both
    neighbours."""
    bend = divided_bend(strips, i, before, value, after)
    if bend < 0.0:
        left = strips[i].station - strips[i - 1].station
        slope = (value - before) / left + bend * left
        value -= slope * slope / (4.0 * bend)
    return value


def largest_pressure(strips: Strips, first: int, last: int):
    """Largest pressure [Pa] on the middle lines of a run, also between strips."""
    best = first
    for i in range(first, last + 1):
        if strips[i].pressure > strips[best].pressure:
            best = i
    pressure = strips[best].pressure
    if best > first and best < last:
        before = strips[best - 1].pressure
        pressure = summit(strips, best, before, pressure, strips[best + 1].pressure)
    return pressure


def largest_square(strips: Strips, first: int, last: int):
    """Square of the largest half-length [m^2] of a run, also between strips."""
    best = first
    for i in range(first, last + 1):
        if strips[i].half_length_square > strips[best].half_length_square:
            best = i
    square = strips[best].half_length_square
    if best > first and best < last:
        before = strips[best - 1].half_length_square
        square = summit(strips, best, before, square, strips[best + 1].half_length_square)
    return square
