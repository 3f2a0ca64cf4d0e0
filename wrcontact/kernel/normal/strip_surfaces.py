"""What the surfaces are at each strip: gap, curvature, and ANALYN's half-length and coefficients, read from
the region's nodes."""

from math import log, sqrt
from typing import Final

from ..contact.arc_length import rail_abscissa
from ..layout import (
    NODE_MIDDLE,
    Frame,
    Nodes,
    NodesOfRegions,
    Region,
    Regions,
    Strip,
    StripProblem,
    Strips,
    Tables,
)
from ..surface.cubic import cubic_through
from ..surface.profile_table import height_slope

#: Smallest half-length, eq. (S9), as a share of the longest one, of that of the interpenetration, and of the
#: width of the strip.  Below the last, the strip's own pressure grows without limit, and a light load misses
#: its area by all of it.
SHORTEST: Final[float] = 0.1
INSIDE: Final[float] = 0.3
SQUARE: Final[float] = 0.5


def node_cell(strip: Strip, region: Region):
    """The node before the middle of a strip, and the share of the way from there to the next node."""
    u = (strip.station - region.offset - region.station) / region.spacing
    k = int(u + float(NODE_MIDDLE)) - NODE_MIDDLE
    if k > region.last - 1:
        k = region.last - 1
    if k < region.first:
        k = region.first
    return k, u - float(k)


def read_surfaces(strip: Strip, region: Region, nodes: Nodes, k: int, x: float):
    """Gap and curvature of a strip at the share ``x`` of the way from node ``k`` to the next one.

    Under yaw the patch is tilted; the strips are those of the upright ellipse with the same half-length,
    half-width and pressure (hertz.upright_coefficients).
    """
    gap = cubic_through(nodes.gap[k - 1], nodes.gap[k], nodes.gap[k + 1], nodes.gap[k + 2], x)
    if gap < 0.0:
        # next to a sudden rise the cubic falls below the region's smallest gap
        gap = 0.0
    A = nodes.A[k] + x * (nodes.A[k + 1] - nodes.A[k])
    strip.gap = region.upright_share * region.gap + gap * region.upright_b
    strip.A = A * region.upright_a
    strip.curvature = 2.0 * A
    strip.penetration_share = region.upright_share * region.alignment
    return 0


def incline_strips(tables: Tables, frame: Frame, problem: StripProblem, regions: Regions):
    """Inclination of the rail at every strip of a pressed wheel; of another one, that of its plane."""
    for i in range(problem.count):
        strip = problem.strips[i]
        region = regions[strip.region]
        strip.cos = frame.plane.cos
        strip.sin = frame.plane.sin
        if region.own:
            strip.cos = region.cos
            strip.sin = region.sin
        if frame.pressed:
            abscissa = rail_abscissa(tables, region.rail, strip.station - region.offset - region.station)
            height, slope = height_slope(tables.rail, abscissa)
            strip.cos = 1.0 / sqrt(1.0 + slope * slope)
            strip.sin = slope * strip.cos
    return 0


def describe_strips(problem: StripProblem, regions: Regions, nodes: NodesOfRegions):
    """Gap, curvature, and ANALYN's half-length and load of every placed strip."""
    strips = problem.strips
    count = problem.count
    longest = 0.0
    for i in range(count):
        strip = strips[i]
        region = regions[strip.region]
        own = nodes[strip.region]
        k, x = node_cell(strip, region)
        read_surfaces(strip, region, own, k, x)
        line = own.line[k] + x * (own.line[k + 1] - own.line[k])
        length = own.length[k] + x * (own.length[k + 1] - own.length[k])
        level = region.local_penetration - (own.rise[k] + x * (own.rise[k + 1] - own.rise[k]))
        strip.load_per_square = line * length
        loaded = 0
        square = 0.0
        if level > 0.0:
            loaded = 1
            square = level / length
        below = problem.penetration - strip.gap / strip.penetration_share
        below *= region.alignment
        inside = INSIDE * INSIDE * below / length
        if inside > square:
            square = inside
        strip.loaded = loaded
        strip.half_length = sqrt(square)
        if loaded == 1 and strip.half_length > longest:
            longest = strip.half_length
    limit_lengths(strips, count, longest)
    load_one(strips, count)
    return 0


def limit_lengths(strips: Strips, count: int, longest: float):
    """Raise half-lengths to their smallest, eq. (S9), where the longest of a loaded strip is ``longest`` [m];
    their logarithms."""
    for i in range(count):
        strip = strips[i]
        if strip.half_length < SHORTEST * longest:
            strip.half_length = SHORTEST * longest
        if strip.half_length < SQUARE * strip.width:
            strip.half_length = SQUARE * strip.width
        strip.log_half_length = log(strip.half_length)
    return 0


def load_one(strips: Strips, count: int):
    """Load the strip with the smallest gap if ANALYN loads none."""
    smallest = 0
    found = 0
    for i in range(count):
        if strips[i].loaded:
            found = 1
        if strips[i].gap < strips[smallest].gap:
            smallest = i
    if found == 0:
        strips[smallest].loaded = True
    return 0
