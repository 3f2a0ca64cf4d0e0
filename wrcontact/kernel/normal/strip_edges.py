"""Edges of the patches that loaded strips form, and strips that are cut at them between two sweeps.

Near the edge of a patch the line load falls to zero in proportion to the distance, so the edge is where the
straight line through the line loads of the last two strips ends.
"""

from math import fabs

from ..layout import NodesOfRegions, Regions, StripProblem, Strips
from .strip_influence import measure_distances
from .strip_surfaces import node_cell, read_surfaces


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


def fit_edges(problem: StripProblem, regions: Regions, nodes: NodesOfRegions):
    """Let the outermost strips of every run of loaded strips end at the edges of the run."""
    strips = problem.strips
    count = problem.count
    first = 0
    while first < count:
        last = first
        if strips[first].line_load > 0.0:
            last = run_end(strips, count, first)
            if last > first + 2:
                start = run_edge(strips, count, first, last, -1)
                stop = run_edge(strips, count, last, first, 1)
                fit_edge(problem, regions, nodes, first, start, -1)
                fit_edge(problem, regions, nodes, last, stop, 1)
        first = last + 1
    return 0


def fit_edge(problem: StripProblem, regions: Regions, nodes: NodesOfRegions, last: int, edge: float,
             outward: int):
    """Let the run that ends with strip ``last`` end at ``edge`` [m], which lies within one and a half of its
    widths.

    A strip is never cut to less than half of its width, because a narrow one answers the smallest mismatch
    with a large pressure: the strip before it takes over what remains, and the last one is unloaded.
    """
    strips = problem.strips
    direction = float(outward)
    width = strips[last].width
    inner = strips[last].station - 0.5 * direction * width
    outer = inner + direction * width
    beyond = last + outward
    pair = last
    if outward < 0:
        pair = beyond
    touching = 0
    if pair >= 0 and pair < problem.count:
        if strips[pair].joined:
            touching = 1
    if (edge - inner) * direction > 0.5 * width:
        move_strip(problem, regions, nodes, last, inner, edge)
        if (edge - outer) * direction > 0.0 and touching == 1:
            far = strips[beyond].station + 0.5 * direction * strips[beyond].width
            move_strip(problem, regions, nodes, beyond, edge, far)
    else:
        before = last - outward
        near = strips[before].station - 0.5 * direction * strips[before].width
        move_strip(problem, regions, nodes, before, near, edge)
        move_strip(problem, regions, nodes, last, edge, outer)
        strips[last].loaded = False
    return 0


def move_strip(problem: StripProblem, regions: Regions, nodes: NodesOfRegions, i: int, start: float,
               stop: float):
    """Let strip ``i`` lie between two stations [m], with the surfaces and distances there."""
    strip = problem.strips[i]
    strip.width = fabs(stop - start)
    strip.station = 0.5 * (start + stop)
    region = regions[strip.region]
    k, x = node_cell(strip, region)
    read_surfaces(strip, region, nodes[strip.region], k, x)
    measure_distances(problem.distances, problem.strips, regions, i, problem.count)
    return 0
