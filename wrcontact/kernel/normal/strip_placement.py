"""Where the strips of the strip correction lie: how far the zone of each region reaches, and how strips
divide it.

Half of the strips are spread evenly.  The others have the density sqrt(B) sqrt(1 - g / penetration): they are
narrower where the gap bends and near the contact (docs/method.md, section 9).
"""

from math import sqrt
from typing import Final

from ..layout import Nodes, NodesOfRegions, Region, Regions, StripProblem, Strips, StripZone

#: Strips lie where the gap is below this share of ANALYN's penetration,
ZONE: Final[float] = 0.9
#: and, where a patch is short across, where ANALYN's local penetration less (1 + beta) g is above minus this
#: share of the penetration.
BEYOND: Final[float] = 0.6
#: Share of the strips that is spread evenly.
EVEN: Final[float] = 0.5
#: Fewest strips of a region.
FEWEST: Final[int] = 12
#: Strips touch if their edges are closer than this share of their width.
TOUCHING: Final[float] = 1e-6


def place_strips(problem: StripProblem, regions: Regions, nodes: NodesOfRegions, count: int, wanted: int,
                 penetration: float):
    """Lay about ``wanted`` strips over the zones of ``count`` regions at ANALYN's ``penetration`` [m]."""
    problem.penetration = penetration
    weight = 0.0
    width = 0.0
    for i in range(count):
        zone = problem.zones[i]
        measure_zone(zone, regions[i], nodes[i], penetration)
        weight += zone.weight
        width += zone.stop - zone.start
    strips = 0
    for i in range(count):
        zone = problem.zones[i]
        length = zone.stop - zone.start
        if length > 0.0 and weight > 0.0:
            problem.even = EVEN / width
            problem.graded = (1.0 - EVEN) / weight
            share = problem.even * length + problem.graded * zone.weight
            own = int(float(wanted) * share + 0.5)
            if own < FEWEST:
                own = FEWEST
            divide_zone(problem, regions[i], nodes[i], i, strips, own)
            strips += own
    problem.count = strips
    join_strips(problem.strips, strips)
    return 0


def measure_zone(zone: StripZone, region: Region, nodes: Nodes, penetration: float):
    """Ends and weight of a region's zone at the total ``penetration`` [m]."""
    own = region.alignment * penetration
    zone.penetration = own
    zone.start = zone_end(region, nodes, -1, own)
    zone.stop = zone_end(region, nodes, 1, own)
    zone.weight = zone_weight(zone, region, nodes)
    return 0


def zone_excess(region: Region, nodes: Nodes, k: int, penetration: float):
    """How far node ``k`` is inside the zone, as a height [m]; negative outside."""
    excess = ZONE * penetration - region.gap - nodes.gap[k]
    level = region.local_penetration - nodes.rise[k]
    beyond = level + BEYOND * penetration
    if beyond < excess:
        excess = beyond
    if level > excess:
        excess = level
    return excess


def zone_end(region: Region, nodes: Nodes, direction: int, penetration: float):
    """Station [m] where the region's zone ends in ``direction``; that of its minimum if there is no zone."""
    last = region.last
    bound = region.high
    if direction < 0:
        last = -region.first
        bound = region.low
    inner = zone_excess(region, nodes, 0, penetration)
    reach = 0.0
    if inner > 0.0:
        reach = float(last)
        for k in range(1, last + 1):
            outer = zone_excess(region, nodes, direction * k, penetration)
            if outer <= 0.0:
                reach = float(k - 1) + inner / (inner - outer)
                break
            inner = outer
    station = region.station + float(direction) * reach * region.spacing
    if (station - bound) * float(direction) > 0.0:
        station = bound
    return station


def node_weight(region: Region, nodes: Nodes, k: int, penetration: float):
    """sqrt(B) sqrt(1 - g / penetration) at node ``k`` [m^-1/2]."""
    share = 1.0 - (region.gap + nodes.gap[k]) / penetration
    weight = 0.0
    if share > 0.0:
        weight = sqrt(nodes.B[k] * share)
    return weight


def cell_overlap(zone: StripZone, region: Region, k: int):
    """Length of the cell between nodes ``k`` and ``k`` + 1 inside the zone [m], and the station where it
    begins there [m]."""
    spacing = region.spacing
    start = region.station + spacing * float(k)
    stop = start + spacing
    if start < zone.start:
        start = zone.start
    if stop > zone.stop:
        stop = zone.stop
    return stop - start, start


def zone_weight(zone: StripZone, region: Region, nodes: Nodes):
    """Integral of ``node_weight`` over the zone [m^1/2]."""
    total = 0.0
    before = node_weight(region, nodes, region.first, zone.penetration)
    for k in range(region.first, region.last):
        after = node_weight(region, nodes, k + 1, zone.penetration)
        length, start = cell_overlap(zone, region, k)
        if length > 0.0:
            total += 0.5 * (before + after) * length
        before = after
    return total


def divide_zone(problem: StripProblem, region: Region, nodes: Nodes, index: int, first: int, own: int):
    """Divide the zone of the region with number ``index`` into ``own`` strips of equal weight, from strip
    ``first`` on."""
    zone = problem.zones[index]
    even = problem.even
    graded = problem.graded
    each = (even * (zone.stop - zone.start) + graded * zone.weight) / float(own)
    done = 0.0
    made = 0
    edge = zone.start
    before = node_weight(region, nodes, region.first, zone.penetration)
    for k in range(region.first, region.last):
        after = node_weight(region, nodes, k + 1, zone.penetration)
        length, start = cell_overlap(zone, region, k)
        if length > 0.0:
            density = even + graded * 0.5 * (before + after)
            while made < own - 1 and done + density * length >= each * float(made + 1):
                cut = start + (each * float(made + 1) - done) / density
                cut_strip(problem.strips, first + made, index, region.offset, edge, cut)
                edge = cut
                made += 1
            done += density * length
        before = after
    while made < own:
        # the last one, and any that rounding has left over
        cut = edge + (zone.stop - edge) / float(own - made)
        cut_strip(problem.strips, first + made, index, region.offset, edge, cut)
        edge = cut
        made += 1
    return 0


def cut_strip(strips: Strips, i: int, index: int, offset: float, start: float, stop: float):
    """Let strip ``i`` lie between two stations [m] of the region with number ``index``, ``offset`` [m] from
    those of the outputs."""
    strips[i].station = offset + 0.5 * (start + stop)
    strips[i].width = stop - start
    strips[i].region = index
    return 0


def join_strips(strips: Strips, count: int):
    """Note which strips touch the next one."""
    for i in range(count):
        joined = 0
        if i < count - 1:
            reach = 0.5 * (strips[i].width + strips[i + 1].width)
            if strips[i + 1].station - strips[i].station < reach * (1.0 + TOUCHING):
                joined = 1
        strips[i].joined = joined
    return 0
