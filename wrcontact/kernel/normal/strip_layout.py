"""How the rail is divided into strips: evenly over the zones first, then by the pressure that was found.

The places of the strips follow the pose without jumps: pieces of the rail have weights that do, and strips
of one weight are cut from them, one after the other.  A strip that reaches over a hole between two pieces is
cut in two.
"""

from math import fabs
from typing import Final

from ..layout import Regions, StripCell, StripProblem, Strips

#: Of the strips of the second layout, the first ones are this share.
FIRST_SHARE: Final[float] = 2.0 / 3.0
#: Share of the first layout that the zones get by their depths, the rest by their widths.
DEEP: Final[float] = 0.5
#: Share of the second layout that is spread evenly over what is loaded; the rest follows the change of the
#: pressure.
EVEN: Final[float] = 0.5
#: A strip counts as loaded as far as its pressure, or a neighbour's, is this share of the largest one.
LOADED: Final[float] = 0.1
#: Pieces closer than this touch [m].
TOUCHING: Final[float] = 1e-9


def zone_cells(problem: StripProblem, count: int):
    """The zones of ``count`` regions as cells, weighted by how wide and how deep they are."""
    width = 0.0
    depth = 0.0
    for index in range(count):
        width += problem.zones[index].stop - problem.zones[index].start
        depth += problem.zones[index].level
    cells = 0
    for index in range(count):
        zone = problem.zones[index]
        if zone.stop > zone.start:
            cell = problem.cells[cells]
            cell.start = zone.start
            cell.stop = zone.stop
            cell.weight = (1.0 - DEEP) * (zone.stop - zone.start) / width + DEEP * zone.level / depth
            cells += 1
    problem.cell_count = cells
    return 0


def touch(strips: Strips, count: int):
    """Note which strips touch the next one."""
    for i in range(count):
        joined = 0
        if i < count - 1:
            reach = 0.5 * (strips[i].width + strips[i + 1].width)
            if strips[i + 1].station - strips[i].station < reach + TOUCHING:
                joined = 1
        strips[i].joined = joined
    return 0


def strip_cells(problem: StripProblem):
    """The solved strips as cells, weighted by their pressures."""
    strips = problem.strips
    count = problem.count
    largest = 0.0
    for i in range(count):
        if strips[i].pressure > largest:
            largest = strips[i].pressure
    width = 0.0
    change = 0.0
    for i in range(count):
        width += loaded_share(strips, count, i, largest) * strips[i].width
        if i < count - 1 and strips[i].joined:
            change += fabs(strips[i + 1].pressure - strips[i].pressure)
    for i in range(count):
        strip = strips[i]
        cell = problem.cells[i]
        cell.start = strip.station - 0.5 * strip.width
        cell.stop = strip.station + 0.5 * strip.width
        cell.half_length = strip.half_length
        cell.lead = strip.lead
        cell.loaded = strip.pressure > 0.0
        weight = EVEN * loaded_share(strips, count, i, largest) * strip.width / width
        if change > 0.0:
            weight += (1.0 - EVEN) * 0.5 * pressure_changes(strips, count, i) / change
        cell.weight = weight
    problem.cell_count = count
    return 0


def loaded_share(strips: Strips, count: int, i: int, largest: float):
    """How far strip ``i`` counts as loaded, where the ``largest`` pressure is given [Pa]."""
    pressure = strips[i].pressure
    if i > 0 and strips[i - 1].joined:
        if strips[i - 1].pressure > pressure:
            pressure = strips[i - 1].pressure
    if i < count - 1 and strips[i].joined:
        if strips[i + 1].pressure > pressure:
            pressure = strips[i + 1].pressure
    share = pressure / (LOADED * largest)
    if share > 1.0:
        share = 1.0
    return share


def pressure_changes(strips: Strips, count: int, i: int):
    """Changes of the pressure from strip ``i`` to those that touch it [Pa]."""
    change = 0.0
    if i > 0 and strips[i - 1].joined:
        change += fabs(strips[i].pressure - strips[i - 1].pressure)
    if i < count - 1 and strips[i].joined:
        change += fabs(strips[i + 1].pressure - strips[i].pressure)
    return change


def divide_cells(problem: StripProblem, regions: Regions, region_count: int, wanted: int):
    """Cut strips from the cells: ``wanted``, and one more for every hole."""
    total = 0.0
    for index in range(problem.cell_count):
        total += problem.cells[index].weight
    each = total / float(wanted)
    made = 0
    cuts = 0
    done = 0.0
    edge = 0.0
    stop = 0.0
    opened = 0
    for index in range(problem.cell_count):
        cell = problem.cells[index]
        if cell.weight > 0.0:
            if opened == 1 and cell.start - stop > TOUCHING:
                made += cut_strip(problem.strips, made, edge, stop)
                opened = 0
            if opened == 0:
                edge = cell.start
                opened = 1
            while cuts < wanted - 1 and done + cell.weight >= each * float(cuts + 1):
                share = (each * float(cuts + 1) - done) / cell.weight
                cut = cell.start + share * (cell.stop - cell.start)
                made += cut_strip(problem.strips, made, edge, cut)
                edge = cut
                cuts += 1
            done += cell.weight
            stop = cell.stop
    made += cut_strip(problem.strips, made, edge, stop)
    problem.count = made
    touch(problem.strips, made)
    place_in_regions(problem.strips, made, regions, region_count)
    return 0


def cut_strip(strips: Strips, i: int, start: float, stop: float):
    """Let strip ``i`` lie between two stations [m]; how many strips that is, 0 where it has no width."""
    made = 0
    if stop - start > TOUCHING:
        strips[i].station = 0.5 * (start + stop)
        strips[i].width = stop - start
        made = 1
    return made


def place_in_regions(strips: Strips, count: int, regions: Regions, region_count: int):
    """Give every strip the region that its middle lies in."""
    index = 0
    for i in range(count):
        while index < region_count - 1 and strips[i].station > regions[index].offset + regions[index].high:
            index += 1
        strips[i].region = index
    return 0


def length_before(problem: StripProblem):
    """Half-length and lead of every strip from those of the cells, on straight lines between their
    middles."""
    strips = problem.strips
    cells = problem.cells
    last = problem.cell_count - 1
    index = 0
    for i in range(problem.count):
        strip = strips[i]
        while index < last - 1 and strip.station > cell_middle(cells[index + 1]):
            index += 1
        after = index
        if index < last:
            after = index + 1
        share = 0.0
        reach = cell_middle(cells[after]) - cell_middle(cells[index])
        if reach > 0.0:
            share = (strip.station - cell_middle(cells[index])) / reach
            if share < 0.0:
                share = 0.0
            if share > 1.0:
                share = 1.0
        rest = 1.0 - share
        strip.half_length = rest * cells[index].half_length + share * cells[after].half_length
        strip.lead = rest * cells[index].lead + share * cells[after].lead
        strip.loaded = cells[index].loaded
        if share > 0.5:
            strip.loaded = cells[after].loaded
    return 0


def cell_middle(cell: StripCell):
    """Station [m] of the middle of a cell."""
    return 0.5 * (cell.start + cell.stop)
