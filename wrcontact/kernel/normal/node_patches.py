"""From ANALYN's regions to patches: every node becomes a strip, every run of loaded cells a patch.

Between the strips the line load and the squares of half-length and pressure follow quadratics
(:mod:`quadrature`), so that an ellipse comes out exactly.  A patch may reach over the bound between two
regions, and a region may hold two patches.
"""

from math import fabs, pi, sqrt
from typing import Final

from ..layout import RULE_QUADRATIC, Contact, Nodes, Patch, Region, SideSearch, SolvedStrip, SolvedStrips
from ..patch.filling import add_load, begin_patch, clear_patches, finish_patch, finish_patches
from ..patch.quadrature import cell_part, quadratic_integral, quadratic_moment, root_integral
from .analyn import clip_to_bound

#: Loaded parts closer than this share of the spacing are one patch.
JOINED: Final[float] = 1e-9


def fill_from_nodes(contact: Contact, side: SideSearch, count: int):
    """Fill the patches of a side from ``count`` regions at their local penetrations."""
    clear_patches(side)
    strips = 0
    for index in range(count):
        region = contact.regions[index]
        region.carried = 0.0
        region.moment = 0.0
        if region.local_penetration > 0.0:
            region.strip = strips - region.first
            fill_strips(region, contact.nodes[index], contact.strips)
            strips += region.last - region.first + 1
            for k in range(region.first, region.last):
                add_cell(contact, side, index, k)
    finish_patch(side)
    finish_patches(side)


def fill_strips(region: Region, nodes: Nodes, strips: SolvedStrips):
    """The strips of a region, one at each node, also where it is not loaded.  Each is as wide as the spacing,
    the outermost ones half of it; :func:`add_cell` takes away what is not loaded.

    The pressure on x = 0 is p0 = (2/pi) (E*/(n r)) sqrt(d (1 + alpha) A), with d as in :mod:`analyn`.
    """
    deepest = region.local_penetration
    middle = region.strip
    spacing = region.spacing
    origin = region.offset + region.station
    along = region.x_track
    slant = region.slant
    for k in range(region.first, region.last + 1):
        strip = strips[middle + k]
        d = deepest - nodes.rise[k]
        load = nodes.line[k] * d
        strip.line_load = load
        strip.half_length_square = d / nodes.length[k]
        strip.pressure_square = 4.0 / (pi * pi) * nodes.line[k] * load * nodes.length[k]
        away = spacing * float(k)
        strip.station = origin + away
        strip.width = spacing
        strip.x = along + slant * away
        strip.curvature = 2.0 * nodes.A[k]
    strips[middle + region.first].width = 0.5 * spacing
    strips[middle + region.last].width = 0.5 * spacing


def add_cell(contact: Contact, side: SideSearch, number: int, k: int):
    """Add the cell between nodes ``k`` and ``k`` + 1 of region ``number`` to the last patch, or to a
    new one that begins in it."""
    region = contact.regions[number]
    nodes = contact.nodes[number]
    strips = contact.strips
    spacing = region.spacing
    deepest = region.local_penetration
    outward = 1
    low = k
    if k < 0:
        outward = -1
        low = k + 1
    before = low - outward
    high = low + outward
    start, stop = cell_part(
        deepest - nodes.rise[before], deepest - nodes.rise[low], deepest - nodes.rise[high]
    )
    if k == region.first or k == region.last - 1:
        stop = clip_to_bound(region, low, outward, stop)
    strip = region.strip
    inner = strips[strip + low]
    outer = strips[strip + high]
    if start > 0.0 or stop < 1.0:
        narrow_strips(inner, outer, start, stop, spacing)
    if stop > start:
        begin = inner.station + spacing * start
        end = inner.station + spacing * stop
        if outward < 0:
            begin = inner.station - spacing * stop
            end = inner.station - spacing * start
        index = patch_from(side, region, begin, strip + k)
        patch = side.patches[index]
        patch.totals.stop = end
        patch.last = strip + k + 1
        load, moment = add_part(
            patch, region, strips[strip + before], inner, outer, start, stop, spacing * float(outward)
        )
        add_load(patch, number, load, moment)
        keep_largest(patch, strips, strip + low)


def narrow_strips(inner: SolvedStrip, outer: SolvedStrip, start: float, stop: float, spacing: float):
    """Take from the strips at the ends of a cell what of it is not loaded, so that the widths of a patch's
    strips add up to its own: the loaded part [start, stop] belongs to the strip that is inside the patch,
    which has half the cell so far."""
    inner_share = 0.0
    outer_share = 0.0
    if stop > start:
        if start > 0.0:
            outer_share = stop - start
        else:
            inner_share = stop - start
    inner.width += (inner_share - 0.5) * spacing
    outer.width += (outer_share - 0.5) * spacing


def patch_from(side: SideSearch, region: Region, start: float, strip: int):
    """Index of the patch that a loaded part that begins at station ``start`` [m], beside ``strip``, belongs
    to: the last one if that ends there, else a new one."""
    index = side.patch_count - 1
    joined = False
    if index >= 0:
        last = side.patches[index]
        if start - last.totals.stop < JOINED * region.spacing:
            joined = True
    if not joined:
        finish_patch(side)
        index = begin_patch(side, region, start, strip, RULE_QUADRATIC)
    return index


def add_part(
    patch: Patch,
    region: Region,
    before: SolvedStrip,
    low: SolvedStrip,
    high: SolvedStrip,
    start: float,
    stop: float,
    step: float,
):
    """Add load and moment of the loaded part [start, stop] of a cell to its region, and its area to its
    patch; the load [N] and the moment [N m].

    ``low`` and ``high`` are the strips at its inner and outer end, ``step`` [m] from each other, and
    ``before`` the next one further in.
    """
    width = fabs(step)
    load = quadratic_integral(before.line_load, low.line_load, high.line_load, stop)
    moment = quadratic_moment(before.line_load, low.line_load, high.line_load, stop)
    if start > 0.0:
        load -= quadratic_integral(before.line_load, low.line_load, high.line_load, start)
        moment -= quadratic_moment(before.line_load, low.line_load, high.line_load, start)
    load *= width
    area = root_integral(
        before.half_length_square, low.half_length_square, high.half_length_square, start, stop
    )
    moment = low.station * load + width * step * moment
    region.carried += load
    region.moment += moment
    patch.totals.area += 2.0 * width * area
    return load, moment


def keep_largest(patch: Patch, strips: SolvedStrips, strip: int):
    """Let a patch have the squares of half-length and pressure at ``strip``, if they are its largest
    ones so far."""
    low = strips[strip - 1]
    here = strips[strip]
    high = strips[strip + 1]
    if here.half_length_square > patch.half_length_square:
        patch.half_length_square = peak_square(
            low.half_length_square, here.half_length_square, high.half_length_square
        )
    if here.pressure_square > patch.pressure_square:
        patch.pressure_square = peak_square(low.pressure_square, here.pressure_square, high.pressure_square)


def peak_square(before: float, square: float, after: float):
    """Square of the largest value of the parabola through the roots of three squares, where the middle one is
    a peak and both others are loaded; else the middle one."""
    if before > 0.0 and after > 0.0 and square >= before and square >= after:
        top = sqrt(square)
        left = sqrt(before)
        right = sqrt(after)
        bend = left - 2.0 * top + right
        if bend < 0.0:
            top -= (right - left) * (right - left) / (8.0 * bend)
            square = top * top
    return square
