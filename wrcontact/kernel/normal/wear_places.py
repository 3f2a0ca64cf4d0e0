"""Where the stations of an outline and the strips of its patches lie on both profiles, for models of wear.

The place on the rail follows from the station as for loads and strips (patch_places.py).  The wheel's is the
one that the rail's normal meets there, with the wheel as it stands or has sunk; where it meets none, between
patches that are far from each other, both abscissae run alike from the point of the patch on.
"""

from ..contact.penetrated import NODE_SHARP, meet_wheel
from ..layout import (
    REGION_LIMIT,
    ROLLING_STRIP_LIMIT,
    Contact,
    Frame,
    Pair,
    Patch,
    Region,
    SideSearch,
    StripOutputs,
    seldom,
)
from .patch_places import abscissa_at


@seldom
def place_wear(pair: Pair, contact: Contact, side: SideSearch):
    """The places of the stations of a side, the patch that each belongs to, and the places of all strips."""
    stations = pair.tables.stations
    index = 0
    for j in range(stations):
        station = side.outline.numbers[j]
        index = nearest_patch(side, index, station)
        patch = side.patches[index]
        rail, wheel = profile_places(pair, contact.frame, contact.regions[first_region(patch)], station)
        side.wear.numbers[j] = wheel
        side.wear.numbers[stations + j] = rail
        side.wear.numbers[3 * stations + j] = float(patch.rank)
    for number in range(side.patch_count):
        place_strips_of_wear(pair, contact, side.patches[number], side.worn[number])


@seldom
def place_strips_of_wear(pair: Pair, contact: Contact, patch: Patch, worn: StripOutputs):
    """The places of the strips of a patch."""
    region = contact.regions[first_region(patch)]
    for i in range(ROLLING_STRIP_LIMIT):
        rail, wheel = profile_places(pair, contact.frame, region, patch.strips[i].station)
        worn.rail_place[i] = rail
        worn.wheel_place[i] = wheel


@seldom
def profile_places(pair: Pair, frame: Frame, region: Region, station: float):
    """Rail and wheel abscissa [m] at a ``station`` [m] of the outputs, sought from a ``region``."""
    rail = abscissa_at(pair, frame, region, station - region.offset - region.station)
    wheel = region.wheel + rail - region.rail
    if meet_wheel(pair, frame.place, rail, wheel, frame.height, NODE_SHARP):
        wheel = frame.place.meeting.wheel
    return rail, wheel


@seldom
def first_region(patch: Patch):
    """The first region that carries some of a patch's load."""
    number = 0
    while number < REGION_LIMIT - 1 and patch.loads[number] == 0.0:
        number += 1
    return number


@seldom
def nearest_patch(side: SideSearch, index: int, station: float):
    """The patch, from ``index`` on, that a ``station`` [m] lies in or is nearest to."""
    while index < side.patch_count - 1 and (
        station - side.patches[index].totals.stop > side.patches[index + 1].totals.start - station
    ):
        index += 1
    return index
