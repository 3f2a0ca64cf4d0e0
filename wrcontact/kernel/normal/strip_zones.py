"""Where wheel and rail overlap as they are laid: there the first strips lie."""

from math import sqrt
from typing import Final

from ..contact.planes import enter_plane, leave_plane
from ..contact.zone_width import zone_width
from ..layout import Contact, Region, State, StripZone, Tables

#: A zone ends where the overlap has fallen to this share of the deepest one, or of its own: far from the
#: deepest, a region is loaded long before it is so deep.
SHALLOW: Final[float] = 0.03
OWN_SHALLOW: Final[float] = 0.25


def find_zones(tables: Tables, contact: Contact, state: State, count: int, deepest: float):
    """The zones of ``count`` regions, of which the deepest overlaps by ``deepest`` [m]."""
    for index in range(count):
        region = contact.regions[index]
        enter_plane(contact.frame, contact.frames, region, index)
        measure_zone(tables, contact, state, region, contact.strip_problem.zones[index], deepest)
        leave_plane(contact.frame, contact.frames, region)


def measure_zone(tables: Tables, contact: Contact, state: State, region: Region, zone: StripZone,
                 deepest: float):
    """The zone of a region whose frame is open; without width where nothing overlaps."""
    zone.start = region.offset + region.station
    zone.stop = zone.start
    depth = contact.frame.depth
    shallow = SHALLOW * deepest
    if shallow > OWN_SHALLOW * depth:
        shallow = OWN_SHALLOW * depth
    level = depth - shallow
    zone.level = 0.0
    if level > 0.0:
        zone.level = level
        bend = region.bend
        if bend < region.curvature:
            bend = region.curvature
        estimate = sqrt(2.0 * level / bend)
        contact.frame.blur = 0.0
        high = zone_width(tables, contact.frame, contact.origin, region, state, 1.0, level, estimate)
        low = zone_width(tables, contact.frame, contact.origin, region, state, -1.0, level, high)
        zone.stop = zone.start + high
        zone.start -= low
