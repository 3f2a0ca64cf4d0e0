"""The patches of a wheel as the models of creep forces read them: cut into strips when they are solved, for
the solved patches of one wheel give way to those of the other."""

from ..contact.arc_length import rail_abscissa
from ..layout import (
    PATCH_LIMIT,
    TANGENTIAL_NONE,
    Contact,
    Region,
    RollingPatch,
    RollingSide,
    RollingStrip,
    SolvedPatch,
    Tables,
)
from ..surface.profile_table import height_slope
from ..surface.rails import on_track
from ..tangential.sections import cut_patch


def keep_rolling(tables: Tables, contact: Contact, rolling: RollingSide, mirror: float):
    """Cut the heaviest solved patches of a side into strips, if creep forces are wanted; ``mirror`` = 1 on
    the right, -1 on the left."""
    rolling.count = 0
    if tables.tangential == TANGENTIAL_NONE:
        return 0
    solved = contact.solved
    for index in range(solved.part_count):
        part = solved.parts[index]
        rank = solved.patches[part.patch].rank
        # the first part of a patch tells its region
        if rank > 0 and rank <= PATCH_LIMIT and is_first_part(contact, index) == 1:
            patch = rolling.patches[rank - 1]
            cut_patch(solved, part.patch, patch)
            place_strips(tables, contact, contact.regions[part.region], patch, mirror)
            if rank > rolling.count:
                rolling.count = rank
    return rolling.count


def is_first_part(contact: Contact, number: int):
    """1 if no part before ``number`` is of the same patch, else 0."""
    solved = contact.solved
    first = 1
    for index in range(number):
        if solved.parts[index].patch == solved.parts[number].patch:
            first = 0
    return first


def place_strips(tables: Tables, contact: Contact, region: Region, patch: RollingPatch, mirror: float):
    """Where the strips of a patch are in the track, and the wheel's rolling radius there."""
    for index in range(patch.count):
        place_strip(tables, contact, region, patch.strips[index], mirror)
    return 0


def place_strip(tables: Tables, contact: Contact, region: Region, strip: RollingStrip, mirror: float):
    """Place of one strip.  Wheel and rail lie on each other: from the region's point on, both abscissae run
    alike."""
    frame = contact.frame
    away = strip.station - region.offset - region.station
    abscissa = region.rail + away * frame.plane.cos
    if frame.pressed:
        abscissa = rail_abscissa(tables, region.rail, away)
    height, slope = height_slope(tables.rail, abscissa)
    y, z = on_track(frame.place, tables.rail_y, tables.rail_y + abscissa, height)
    strip.y_track = mirror * y
    strip.z_track = z
    height, slope = height_slope(tables.wheel, region.wheel + abscissa - region.rail)
    strip.rolling_radius = tables.radius + height
    return 0
