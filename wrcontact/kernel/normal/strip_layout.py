"""How the rail is divided into strips: evenly over the zones first, then by the pressure that was found.

Pieces of the rail have weights.  Each run of pieces that touch gets as many strips as its weight is worth,
all of one weight, and no fewer than FEWEST: with less a patch has no shape.
"""

from math import fabs
from typing import Final

from ..layout import STRIP_LIMIT, Regions, StripCell, StripProblem, Strips

#: Of the strips of the second layout, the first ones are this share.
FIRST_SHARE: Final[float] = 2.0 / 3.0
#: Share of the first layout that the zones get by their depths, the rest by their widths.
DEEP: Final[float] = 0.5
#: Share of the second layout that is spread evenly over what is loaded; the rest follows the change of the
#: pressure.
EVEN: Final[float] = 0.5
#: A strip counts as loaded as far as its pressure, or a neighbour's, is this share of the largest one.
LOADED: Final[float] = 0.1
#: Strips of a run of cells, at least.
FEWEST: Final[int] = 4
#: Runs of equal weights get together 1 + MORE (n - 1) times as many strips as one.
MORE: Final[float] = 0.5
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


def touch(strips: Strips, count: int):
    """Note which strips touch the next one."""
    for i in range(count):
        joined = False
        if i < count - 1:
            reach = 0.5 * (strips[i].width + strips[i + 1].width)
            if strips[i + 1].station - strips[i].station < reach + TOUCHING:
                joined = True
        strips[i].joined = joined


def strip_cells(problem: StripProblem):
    """The solved strips as cells, weighted by their pressures."""
    strips = problem.strips
    count = problem.count
    largest = 0.0
    for i in range(count):
        largest = max(largest, strips[i].pressure)
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


def loaded_share(strips: Strips, count: int, i: int, largest: float):
    """How far strip ``i`` counts as loaded, where the ``largest`` pressure is given [Pa]."""
    pressure = strips[i].pressure
    if i > 0 and strips[i - 1].joined:
        pressure = max(pressure, strips[i - 1].pressure)
    if i < count - 1 and strips[i].joined:
        pressure = max(pressure, strips[i + 1].pressure)
    share = min(pressure / (LOADED * largest), 1.0)
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
    """Cut about ``wanted`` strips from the cells, from each run of cells that touch as many as its weight is
    worth; more, where there are several runs."""
    total = 0.0
    for index in range(problem.cell_count):
        total += problem.cells[index].weight
    squares = 0.0
    first = 0
    while first < problem.cell_count:
        last, weight = run_of_cells(problem, first)
        squares += weight * weight
        first = last + 1
    several = total * total / squares - 1.0
    each = total / (float(wanted) * (1.0 + MORE * several))
    made = 0
    first = 0
    while first < problem.cell_count:
        last, weight = run_of_cells(problem, first)
        if weight > 0.0:
            number = min(max(int(weight / each + 0.5), FEWEST), STRIP_LIMIT - made)
            cut_run(problem, first, made, number, weight)
            made += number
        first = last + 1
    problem.count = made
    touch(problem.strips, made)
    place_in_regions(problem.strips, made, regions, region_count)


def run_of_cells(problem: StripProblem, first: int):
    """The last cell of the run of cells that touch and begins with ``first``, and the weight of the run."""
    last = first
    weight = problem.cells[first].weight
    while last < problem.cell_count - 1 and weight > 0.0 and continued(problem, last):
        last += 1
        weight += problem.cells[last].weight
    return last, weight


def continued(problem: StripProblem, index: int) -> bool:
    """Whether the cell after ``index`` touches it and has a weight."""
    following = problem.cells[index + 1]
    return following.weight > 0.0 and following.start - problem.cells[index].stop < TOUCHING


def cut_run(problem: StripProblem, first: int, made: int, number: int, weight: float):
    """Cut ``number`` strips of equal weight from a run of cells that begins with ``first`` and has this
    ``weight``; strips are numbered from ``made`` on."""
    each = weight / float(number)
    index = first
    done = 0.0
    edge = problem.cells[first].start
    for cut in range(number):
        wanted = each * float(cut + 1)
        while cut < number - 1 and done + problem.cells[index].weight < wanted:
            done += problem.cells[index].weight
            index += 1
        cell = problem.cells[index]
        stop = cell.start + (wanted - done) / cell.weight * (cell.stop - cell.start)
        if cut == number - 1:
            stop = run_stop(problem, index)
        strip = problem.strips[made + cut]
        strip.station = 0.5 * (edge + stop)
        strip.width = stop - edge
        edge = stop


def run_stop(problem: StripProblem, index: int):
    """Station [m] of the end of the run of cells that ``index`` is in."""
    while index < problem.cell_count - 1 and continued(problem, index):
        index += 1
    return problem.cells[index].stop


def place_in_regions(strips: Strips, count: int, regions: Regions, region_count: int):
    """Give every strip the region that its middle lies in."""
    index = 0
    for i in range(count):
        while index < region_count - 1 and strips[i].station > regions[index].offset + regions[index].high:
            index += 1
        strips[i].region = index


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
            share = min(max((strip.station - cell_middle(cells[index])) / reach, 0.0), 1.0)
        rest = 1.0 - share
        strip.half_length = rest * cells[index].half_length + share * cells[after].half_length
        strip.lead = rest * cells[index].lead + share * cells[after].lead
        strip.loaded = cells[index].loaded
        if share > 0.5:
            strip.loaded = cells[after].loaded


def cell_middle(cell: StripCell):
    """Station [m] of the middle of a cell."""
    return 0.5 * (cell.start + cell.stop)
