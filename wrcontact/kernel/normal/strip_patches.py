"""From corrected strips to patches: each run of loaded strips that touch each other is a patch.

Near the edge of a patch the line load falls to zero in proportion to the distance, so the edge is where the
straight line through the line loads of the last two strips ends.
"""

from math import pi, sqrt
from typing import Final

from ..layout import (LOAD_VERTICAL, RULE_STRAIGHT, SOLVED_PATCH_LIMIT, Contact, Equations, Frame, Region,
                      Regions, SideSearch, SolvedStrip, Strip, StripProblem, Strips, Tables)
from ..patch.filling import add_load, begin_patch, clear_patches, finish_patch, finish_patches
from ..patch.quadrature import root_integral
from ..surface.rails import upright_share

#: Strips of a region that lie closer together than this have no slant [m].
CLOSE: Final[float] = 1e-6


def run_end(strips: Strips, count: int, first: int):
    """Last strip of the run of loaded strips that begins with strip ``first``."""
    last = first
    while last < count - 1 and strips[last + 1].line_load > 0.0 and strips[last].joined:
        last += 1
    return last


def run_edge(strips: Strips, count: int, last: int, first: int, outward: int):
    """Station [m] of the edge beyond strip ``last`` of a run that reaches to ``first`` on the other side."""
    station = strips[last].station
    edge = station + 0.5 * float(outward) * strips[last].width
    if last != first:
        # no farther than the middle of the next strip, which is not loaded
        limit = edge
        after = last + outward
        pair = last
        if outward < 0:
            pair = last - 1
        if after >= 0 and after < count:
            if strips[pair].joined:
                limit = strips[after].station
        inner = last - outward
        fall = strips[inner].line_load - strips[last].line_load
        edge = limit
        if fall > 0.0:
            reach = strips[last].line_load / fall * (station - strips[inner].station)
            if reach * float(outward) < (limit - station) * float(outward):
                edge = station + reach
    return edge


def fill_from_strips(tables: Tables, contact: Contact, side: SideSearch, count: int):
    """Fill the patches of a side from the runs of loaded strips, which lie in ``count`` regions."""
    problem = contact.strip_problem
    strips = problem.strips
    for index in range(count):
        load_region(tables, contact.frame, contact.regions[index], problem, index)
    clear_patches(side)
    first = 0
    while first < problem.count and side.patch_count < SOLVED_PATCH_LIMIT:
        last = first
        if strips[first].line_load > 0.0:
            last = run_end(strips, problem.count, first)
            fill_run(contact, side, first, last)
        first = last + 1
    finish_patches(side)


def fill_run(contact: Contact, side: SideSearch, first: int, last: int):
    """Fill the next patch from the loaded strips ``first`` ... ``last``."""
    problem = contact.strip_problem
    strips = problem.strips
    if last > first:
        end_like_ellipse(strips[first], strips[first + 1])
        end_like_ellipse(strips[last], strips[last - 1])
    start = run_edge(strips, problem.count, first, last, -1)
    stop = run_edge(strips, problem.count, last, first, 1)
    region = contact.regions[strips[first].region]
    index = begin_patch(side, region, start, first, RULE_STRAIGHT)
    patch = side.patches[index]
    for i in range(first, last + 1):
        keep_strip(strips[i], contact.strips[i])
        load = strips[i].line_load * strips[i].width
        add_load(patch, strips[i].region, load, load * strips[i].station)
    patch.totals.stop = stop
    patch.last = last
    patch.totals.area = run_area(strips, first, last, start, stop)
    pressure = largest_pressure(strips, first, last)
    patch.pressure_square = pressure * pressure
    patch.half_length_square = largest_square(strips, first, last)
    finish_patch(side)


def end_like_ellipse(edge: Strip, inner: Strip):
    """Shorten the strip ``edge`` at the end of a run as the strip ``inner`` beside it asks for; its load
    stays.

    Where a patch ends like an ellipse, the squares of the half-lengths fall like the line loads.  A strip
    that has just begun to carry has had the half-length of its neighbour, which is too long; eq. (S9).
    """
    square = inner.half_length_square * edge.line_load / inner.line_load
    if square < edge.half_length_square:
        edge.pressure *= sqrt(edge.half_length_square / square)
        edge.half_length_square = square


def keep_strip(strip: Strip, to: SolvedStrip):
    """Keep a strip as the solved strip ``to``."""
    to.station = strip.station
    to.width = strip.width
    to.x = strip.x + strip.next_lead
    to.curvature = 2.0 * strip.A
    to.line_load = strip.line_load
    to.half_length_square = strip.half_length_square
    to.pressure_square = strip.pressure * strip.pressure


def load_region(tables: Tables, frame: Frame, region: Region, problem: StripProblem, index: int):
    """What the strips of the region with number ``index`` carry: load, moment, the mean direction of the
    force, and the slant of the line through their middles."""
    strips = problem.strips
    load = 0.0
    moment = 0.0
    cosines = 0.0
    sines = 0.0
    x = 0.0
    for i in range(problem.count):
        strip = strips[i]
        if strip.region == index:
            own = strip.line_load * strip.width
            load += own
            moment += own * strip.station
            cosines += own * strip.cos
            sines += own * strip.sin
            x += own * (strip.x + strip.next_lead)
    region.carried = load
    region.moment = moment
    region.slant = 0.0
    if load > 0.0:
        region.cos = cosines / load
        region.sin = sines / load
        if tables.load == LOAD_VERTICAL:
            region.share = upright_share(frame.place, region.cos, region.sin)
        slant_region(region, problem, index, moment / load, x / load)


def slant_region(region: Region, problem: StripProblem, index: int, station: float, x: float):
    """Slant of the line through the middles of a region's strips, whose load has its centre at ``station``
    and ``x`` [m]."""
    strips = problem.strips
    along = 0.0
    spread = 0.0
    for i in range(problem.count):
        strip = strips[i]
        if strip.region == index:
            own = strip.line_load * strip.width
            away = strip.station - station
            along += own * away * (strip.x + strip.next_lead - x)
            spread += own * away * away
    if spread > CLOSE * CLOSE * region.carried:
        region.slant = along / spread


def add_stiffness(tables: Tables, regions: Regions, problem: StripProblem, equations: Equations, count: int):
    """How the load of each region follows the penetration [N/m], from the last equations that were
    solved."""
    for index in range(count):
        regions[index].stiffness = 0.0
    scale = 0.5 * pi * pi * tables.contact_modulus
    size = 0
    for i in range(problem.count):
        if problem.strips[i].loaded:
            size += 1
    for rank in range(size):
        row = equations[rank]
        strip = problem.strips[int(problem.loaded[rank])]
        region = regions[strip.region]
        region.stiffness += scale * strip.half_length * row[size]


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
