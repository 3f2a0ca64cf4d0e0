"""How far the interpenetration of a region reaches to either side, and the lateral curvatures that follow
from its width.
"""

from math import fabs, sqrt
from typing import Final

from ..layout import RAIL, WHEEL, Contact, FirstWidths, Frame, Origin, Pair, Region
from ..surface.locus import outline_x
from .curves import open_origin
from .frame import NO_GAP, is_yawed
from .separation import separation_jet
from .traces import start_traces

#: Tolerance of the traces [m]: this share of the estimated half-width, or less; as that of nodes.
TRACE_OF_WIDTH: Final[float] = 1e-2
WIDTH_TRACE: Final[float] = 5e-6
WIDTH_ITERATIONS: Final[int] = 60
#: Steps that are shorter, relative, are corrected by the bend of the root [-].
BENT_STEP: Final[float] = 0.1
#: Last halving, relative [-].
HALVED_SHARP: Final[float] = 1e-9
#: Last Newton step, relative [-]; its error is a tenth of the square.
WIDTH_SHARP: Final[float] = 1e-2
#: The same of the nodes of a wheel that stands where it just touches or a little deeper, and where height and
#: roll are sought, which asks for a smooth answer [-].
SUNK_SHARP: Final[float] = 2e-3
PRESSED_SHARP: Final[float] = 1e-5
#: A region begins with the half-widths about the contact point if its minimum leaves this share of both.
LEAST_LEFT: Final[float] = 0.2
#: The narrower half of a region counts as at most so many times narrower than the mean.
NARROWER: Final[float] = 4.0
#: Second derivative of the gap, over 1/R_x, that a first half-width is guessed with.
LEAST_BEND: Final[float] = 1.0
MOST_BEND: Final[float] = 100.0


def width_limit(region: Region, direction: float):
    """Distance [m] from the region's minimum to its bound in ``direction`` (1.0 or -1.0)."""
    limit = region.high - region.station
    if direction < 0.0:
        limit = region.station - region.low
    return limit


def width_tolerance(estimate: float):
    """Tolerance of the traces [m] for an estimated half-width [m]."""
    tolerance = min(TRACE_OF_WIDTH * estimate, WIDTH_TRACE)
    return tolerance


def zone_width(
    pair: Pair, frame: Frame, origin: Origin, region: Region, direction: float, level: float, estimate: float
):
    """Distance [m] from the region's minimum to where the gap has risen by ``level`` [m], or to the region's
    bound or the end of a profile; ``region.reached`` is how far it has risen there, and there the traces are.

    Doubling to a bracket, then Newton on the square root of the gap, which is nearly linear; the last
    steps with its bend, which makes them of third order (Chebyshev's method).  The gap is the chosen
    separation, with arcs in place of the chords whose length follows from this width.
    """
    limit = width_limit(region, direction)
    start_traces(frame, region.station, region.rail, region.wheel)
    open_origin(pair, frame, origin, region, 0.0)
    tolerance = width_tolerance(estimate)
    root = sqrt(level)
    low = 0.0
    high = -1.0
    width = estimate
    region.reached = 0.0
    station = region.station
    abscissa = region.rail
    y = region.wheel
    near = WIDTH_SHARP
    if frame.sunk:
        near = SUNK_SHARP
    elif frame.pressed:
        near = PRESSED_SHARP
    for i in range(WIDTH_ITERATIONS):
        width = min(width, limit)
        gap, rate, bend = separation_jet(pair, frame, origin, region.station + direction * width, tolerance)
        if gap >= NO_GAP:
            # beyond an end the traces are lost
            start_traces(frame, station, abscissa, y)
        else:
            station = frame.station
            abscissa = frame.traces[RAIL].abscissa
            y = frame.traces[WHEEL].abscissa
        rise = gap - region.gap
        if rise < level:
            low = width
            region.reached = rise
            if width >= limit:
                return limit
        else:
            high = width
        following = 2.0 * width
        sharp = HALVED_SHARP
        if high > 0.0:
            following = 0.5 * (low + high)
        if rise > 0.0 and rate * direction > 0.0:
            square = sqrt(rise)
            rising = rate * direction
            step = (root - square) * 2.0 * square / rising
            if fabs(step) < BENT_STEP * width:
                step -= 0.5 * step * step * (bend / rising - 0.5 * rising / rise)
            newton = width + step
            if newton > low and newton < 4.0 * width and (high < 0.0 or newton < high):
                following = newton
                sharp = near
        if fabs(following - width) < sharp * width:
            if sharp == near:
                region.reached = level
            return following
        width = following
    return width


def keep_widths(first: FirstWidths, region: Region):
    """Note the half-widths of a region about the contact point."""
    first.penetration = region.width_penetration
    first.low = region.width_low
    first.high = region.width_high


def begin_widths(known: FirstWidths, region: Region):
    """Let a region begin with the half-widths that it had."""
    region.width_penetration = known.penetration
    region.width_low = known.low
    region.width_high = known.high


def start_widths(first: FirstWidths, region: Region):
    """Let a region whose minimum lies within the ``first`` widths begin with them."""
    region.width_penetration = 0.0
    low = first.low + region.offset
    high = first.high - region.offset
    if first.penetration > 0.0 and low > LEAST_LEFT * first.low and high > LEAST_LEFT * first.high:
        region.width_penetration = first.penetration
        region.width_low = low
        region.width_high = high


def measure_widths(pair: Pair, contact: Contact, region: Region, local_penetration: float):
    """Half-widths of a region's interpenetration at this local penetration [m], the lateral curvatures on
    both sides that follow from them, and the station its load is thought to act at."""
    # the first guess: the gap's own second derivative, as far as it is a usual one
    bend = min(max(region.bend, LEAST_BEND * region.curvature), MOST_BEND * region.curvature)
    low = sqrt(2.0 * local_penetration / bend)
    high = low
    if region.width_penetration > 0.0:
        grown = sqrt(local_penetration / region.width_penetration)
        low = region.width_low * grown
        high = region.width_high * grown
    high = zone_width(pair, contact.frame, contact.origin, region, 1.0, local_penetration, high)
    high_reached = region.reached
    slant = 0.0
    start = contact.frame.station
    yawed = is_yawed(contact.frame)
    if yawed:
        slant = outline_x(pair, contact.frame.place, contact.frame.traces[WHEEL].abscissa)
    if not region.width_penetration > 0.0:
        low = high
    low = zone_width(pair, contact.frame, contact.origin, region, -1.0, local_penetration, low)
    if yawed:
        slant -= outline_x(pair, contact.frame.place, contact.frame.traces[WHEEL].abscissa)
        if start > contact.frame.station:
            region.slant = slant / (start - contact.frame.station)
    region.side_high = side_curvature(high_reached, high, 0.5 * (low + high))
    region.side_low = side_curvature(region.reached, low, 0.5 * (low + high))
    region.width_high = high
    region.width_low = low
    region.width_penetration = local_penetration
    region.middle = region.station + 0.5 * (high - low)


def side_curvature(reached: float, own: float, mean: float):
    """g / w^2 [1/m] where the gap has risen to g = ``reached`` [m] at the half-width w = ``own`` [m],
    enlarged where that side is the narrower, up to NARROWER times."""
    curvature = 0.0
    if own > 0.0:
        ratio = min(mean / own, NARROWER)
        curvature = reached / (own * own) * ratio * ratio
    return curvature
