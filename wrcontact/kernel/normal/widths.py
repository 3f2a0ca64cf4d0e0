"""How wide the interpenetration of a region is, and the lateral curvatures that follow from it."""

from math import sqrt
from typing import Final

from ..contact.contact_plane import is_yawed
from ..contact.zone_width import zone_width
from ..layout import WHEEL, Contact, Region, State, Tables
from ..surface.locus import outline_x

#: The narrower half of a region counts as at most so many times narrower than the mean.
NARROWER: Final[float] = 4.0
#: Second derivative of the gap, over 1/R_x, that a first half-width is guessed with.
LEAST_BEND: Final[float] = 1.0
MOST_BEND: Final[float] = 100.0


def measure_widths(tables: Tables, contact: Contact, state: State, region: Region, local_penetration: float):
    """Half-widths of a region's interpenetration at this local penetration [m], the lateral curvatures on
    both sides that follow from them, and the station its load is thought to act at."""
    # the first guess: the gap's own second derivative, as far as it is a usual one
    bend = region.bend
    if bend < LEAST_BEND * region.curvature:
        bend = LEAST_BEND * region.curvature
    if bend > MOST_BEND * region.curvature:
        bend = MOST_BEND * region.curvature
    low = sqrt(2.0 * local_penetration / bend)
    high = low
    if region.width_penetration > 0.0:
        grown = sqrt(local_penetration / region.width_penetration)
        low = region.width_low * grown
        high = region.width_high * grown
    high = zone_width(tables, contact.frame, contact.origin, region, state, 1.0, local_penetration, high)
    high_reached = region.reached
    slant = 0.0
    start = contact.frame.station
    yawed = is_yawed(contact.frame)
    if yawed:
        slant = outline_x(tables, contact.frame.place, contact.frame.traces[WHEEL].abscissa)
    if not region.width_penetration > 0.0:
        low = high
    low = zone_width(tables, contact.frame, contact.origin, region, state, -1.0, local_penetration, low)
    if yawed:
        slant -= outline_x(tables, contact.frame.place, contact.frame.traces[WHEEL].abscissa)
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
        ratio = mean / own
        if ratio > NARROWER:
            ratio = NARROWER
        curvature = reached / (own * own) * ratio * ratio
    return curvature
