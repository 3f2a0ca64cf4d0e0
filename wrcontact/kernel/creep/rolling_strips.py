"""The strips of a patch that roll: the patch cut along the rolling direction.

The cuts are closer together near both ends of the patch, like Gauss-Chebyshev points:

    e_k = middle - half cos(k pi / n),   k = 0 ... n                                            (C1)

A strip has the mean of a^2 over its width as the square of its half-length, and the mean line load.  Both are
exact for an ellipse.  Between the strips of the normal model they follow straight lines, to zero at the
patch's edges.  The line loads are scaled so that they carry the load of the patch.

All places are taken from the patch's centre of load, for which its creepages hold.  The middles of a yawed
wheel's strips lie on a slanted line through it.
"""

from math import pi, sqrt
from typing import Final

from ..layout import ROLLING_STRIP_LIMIT, RULE_ELLIPSE, Patch, SolvedStrips

#: cos(pi / 16), for ROLLING_STRIP_LIMIT strips.
COSINE: Final[float] = 0.98078528040323044913
#: Patches shorter or longer than this, length over width, count as so short or so long.
SHORTEST_PATCH: Final[float] = 0.05
LONGEST_PATCH: Final[float] = 40.0


def divide_into_strips(patch: Patch, strips: SolvedStrips):
    """Cut a patch, which lies on ``strips`` of its normal model, along the rolling direction; creepages and
    friction stay."""
    totals = patch.totals
    describe_ellipse(patch)
    divide_patch(patch, totals.start, totals.stop)
    if totals.width > 0.0:
        if patch.rule == RULE_ELLIPSE:
            divide_ellipse(patch)
        else:
            divide_strips(patch, strips)
    finish_strips(patch)
    plane_slips(patch)


def clear_creep(patch: Patch):
    """No creep force."""
    patch.creep_x = 0.0
    patch.creep_y = 0.0
    patch.creep_moment = 0.0
    patch.stick_share = 0.0
    patch.max_shear = 0.0
    for i in range(ROLLING_STRIP_LIMIT):
        strip = patch.strips[i]
        strip.force_x = 0.0
        strip.force_y = 0.0
        strip.moment = 0.0


def describe_ellipse(patch: Patch):
    """Semi-axes of the ellipse with the patch's area and length over width."""
    totals = patch.totals
    patch.half_length = 0.0
    patch.half_width = 0.0
    if totals.width > 0.0 and totals.max_half_length > 0.0:
        ratio = min(max(2.0 * totals.max_half_length / totals.width, SHORTEST_PATCH), LONGEST_PATCH)
        patch.half_length = sqrt(totals.area / pi * ratio)
        patch.half_width = sqrt(totals.area / pi / ratio)


def divide_patch(patch: Patch, start: float, stop: float):
    """Edges of the strips between both stations [m]; eq. (C1).  The cosines follow from each other:
    cos((k + 1) t) = 2 cos t cos(k t) - cos((k - 1) t)."""
    middle = 0.5 * (start + stop)
    half = 0.5 * (stop - start)
    before = COSINE
    here = 1.0
    edge = start
    for i in range(ROLLING_STRIP_LIMIT):
        strip = patch.strips[i]
        after = 2.0 * COSINE * here - before
        before = here
        here = after
        strip.start = edge
        edge = middle - half * here
        if i == ROLLING_STRIP_LIMIT - 1:
            edge = stop
        strip.stop = edge
        strip.station = 0.5 * (strip.start + edge)
        strip.width = edge - strip.start
        strip.half_length = 0.0
        strip.line_load = 0.0


def divide_ellipse(patch: Patch):
    """Integrals over each strip of a^2 and of a shape of the line load, 1 - (s/b)^2, into its half-length
    and its line load; the ellipse is around station zero."""
    totals = patch.totals
    square = totals.max_half_length * totals.max_half_length
    third = 1.0 / (3.0 * totals.stop * totals.stop)
    for i in range(ROLLING_STRIP_LIMIT):
        strip = patch.strips[i]
        low = strip.start
        high = strip.stop
        share = strip.width * (1.0 - third * (low * low + low * high + high * high))
        strip.half_length = square * share
        strip.line_load = share


def divide_strips(patch: Patch, strips: SolvedStrips):
    """Integrals over each strip of a^2 and of the line load, into its half-length and its line load, from the
    patch's strips in the normal model."""
    low = patch.totals.start
    low_square = 0.0
    low_load = 0.0
    at = 0
    for k in range(patch.first, patch.last + 1):
        node = strips[k]
        inside = node.station > low and node.station < patch.totals.stop
        loaded = node.half_length_square > 0.0 and node.line_load > 0.0
        if inside and loaded and node.width > 0.0:
            at = add_piece(
                patch, at, low, low_square, low_load, node.station, node.half_length_square, node.line_load
            )
            low = node.station
            low_square = node.half_length_square
            low_load = node.line_load
    add_piece(patch, at, low, low_square, low_load, patch.totals.stop, 0.0, 0.0)


def add_piece(
    patch: Patch,
    at: int,
    low: float,
    low_square: float,
    low_load: float,
    high: float,
    high_square: float,
    high_load: float,
):
    """Add a piece between two stations [m], over which a^2 and the line load follow straight lines, to the
    strips from ``at`` on; the strip in which it ends."""
    width = high - low
    square_slope = (high_square - low_square) / width
    load_slope = (high_load - low_load) / width
    start = low
    while start < high:
        strip = patch.strips[at]
        stop = high
        if strip.stop < high and at < ROLLING_STRIP_LIMIT - 1:
            stop = strip.stop
        middle = 0.5 * (start + stop) - low
        strip.half_length += (stop - start) * (low_square + square_slope * middle)
        strip.line_load += (stop - start) * (low_load + load_slope * middle)
        if stop < high:
            at += 1
        start = stop
    return at


def finish_strips(patch: Patch):
    """Half-lengths and line loads from their integrals, and places from the centre of load."""
    carried = 0.0
    for i in range(ROLLING_STRIP_LIMIT):
        carried += patch.strips[i].line_load
    scale = 0.0
    if carried > 0.0:
        scale = patch.totals.load / carried
    for i in range(ROLLING_STRIP_LIMIT):
        strip = patch.strips[i]
        strip.y = strip.station - patch.totals.centroid
        strip.x = patch.slant * strip.y
        if strip.width > 0.0:
            strip.half_length = sqrt(strip.half_length / strip.width)
            strip.line_load *= scale / strip.width


def plane_slips(patch: Patch):
    """Creepages and spin of each strip where the patch is plane and all of it turns at one rate."""
    for i in range(ROLLING_STRIP_LIMIT):
        strip = patch.strips[i]
        strip.slip = patch.creepage_x - patch.spin * strip.y
        strip.lateral = patch.creepage_y + patch.spin * strip.x
        strip.spin = patch.spin
