"""One side of a wheelset, from where its wheel is to its patches.

Its contact is described by where it is on wheel, rail and track, its angle, radius and curvatures.
"""

from math import fabs, isfinite
from typing import Final

from ..contact.curves import rail_way
from ..contact.penetration_maxima import deepest_entry, follow_overlaps, keep_points
from ..contact.frame import open_contact_region, open_frame
from ..contact.overlaps import find_overlaps
from ..contact.penetrated_regions import lower_frame, touching_shift
from ..creep.rolling_strips import divide_into_strips
from ..elementary.circle import atan
from ..layout import (
    DEPTH_ALL,
    DEPTH_GEOMETRY,
    LATERAL_ADAPTIVE,
    NOT_CONVERGED,
    OFF_PROFILE,
    TANGENTIAL_NONE,
    UNLOADED,
    VALID,
    Contact,
    Profile,
    SideSearch,
    Tables,
    Work,
)
from ..normal.normal_contact import solve_normal
from ..normal.patch_places import place_patches, place_strips
from ..normal.wear_places import place_wear
from ..patch.filling import clear_patches
from ..patch.outline import write_outline
from ..surface.curvature import relative_curvature
from ..surface.gap import gap_per_roll
from ..surface.locus import around_wheel
from ..surface.rails import on_track, pitch_of_frame
from .input_checks import has_wear

#: At the end of a profile the slopes of wheel and rail agree to this at a contact [-]; more means that it is
#: none.  Within a profile they may differ by CORNER, as where the contact stays on a step in height: one of 1 nm,
#: which is not repaired, holds it over sqrt(2e-9 m / bend), 5e-4 for a relative bend of 100 1/m.
PARALLEL: Final[float] = 1e-6
CORNER: Final[float] = 1e-3
#: A place this close to a profile's end is there [m]; the rail's is located to 1e-9 m.
AT_END: Final[float] = 1e-8


def describe_contact(tables: Tables, work: Work, index: int, y: float, aside: float, shift: float) -> bool:
    """Positions, angle, radius and curvatures of side ``index`` (0 left, 1 right) where its wheel touches
    with abscissa ``y`` when moved by ``aside`` and ``shift`` [m]; opens its contact plane.

    Whether this is a contact: the smallest gap at the end of a profile, or where a yawed outline is
    folded.
    """
    pair = tables.pairs[index]
    place = work.sides[index].place
    frame = work.contact.frame
    region = work.contact.regions[0]
    point = work.sides[index].point
    z, slope, y_track, rail_slope, mismatch = open_frame(pair, frame, place, y, aside, shift)
    sin_phi, cos_phi = around_wheel(place, slope)
    r = pair.radius + z
    lateral = (place.arm + y) * place.cos_roll - r * cos_phi * place.sin_roll
    x_track = place.cos_yaw * r * sin_phi - place.sin_yaw * lateral
    if place.leaning:
        pitch_sin, pitch_cos = pitch_of_frame(place)
        ahead = sin_phi * pitch_cos - cos_phi * pitch_sin
        cos_phi = sin_phi * pitch_sin + cos_phi * pitch_cos
        sin_phi = ahead
    point.x_wheel = r * sin_phi
    point.y_wheel = y
    point.z_wheel = r * cos_phi - pair.radius
    point.y_rail = frame.rail.y
    point.z_rail = frame.rail.z
    y_track, z_track = on_track(place, pair.rail_y, y_track, frame.rail.z)
    point.x_track = x_track
    point.y_track = y_track
    point.z_track = z_track
    point.contact_angle = -atan(rail_slope)
    if place.leaning:
        point.contact_angle = -atan(rail_slope) - place.rail_roll
    point.rolling_radius = r
    open_contact_region(tables, frame, region)
    point.curvature_x = region.curvature
    point.curvature_y = region.bend
    if tables.lateral != LATERAL_ADAPTIVE:
        point.curvature_y = 2.0 * relative_curvature(pair, y, frame.rail.y)
    touches = True
    if fabs(mismatch) >= PARALLEL:
        if fabs(mismatch) > CORNER or is_end(pair.wheel, y):
            touches = False
        if is_end(pair.rail, frame.rail.y):
            touches = False
    return touches


def is_end(profile: Profile, y: float) -> bool:
    """Whether ``y`` [m] is at an end of the profile."""
    return y < profile.start + AT_END or y > profile.stop - AT_END


def clear_side(side: SideSearch):
    """A side without load."""
    side.penetration = 0.0
    side.model_error = 0.0
    clear_patches(side)


def begin_trial(contact: Contact, filling: bool, coarse: bool, following: bool):
    """Say what the next contacts are for: whether their patches are filled in, whether an approximate penetration
    is enough, and whether deepest points may be followed from the contact before."""
    contact.filling = filling
    contact.coarse = coarse
    contact.following = following


def load_side(tables: Tables, work: Work, index: int, force: float, prescribed: float):
    """Normal contact of the side whose frame is open, and its patches if they are filled in; number of its
    regions and status."""
    pair = tables.pairs[index]
    side = work.sides[index]
    penetration, count, satisfied = solve_normal(pair, work.contact, side, force, prescribed)
    side.penetration = penetration
    if not satisfied and count == 0:
        # it overlaps most at the end of a profile
        return count, OFF_PROFILE
    if not satisfied:
        return count, NOT_CONVERGED
    if work.contact.filling:
        place_patches(pair, work.contact, side)
        if tables.tangential != TANGENTIAL_NONE or has_wear(tables):
            for number in range(side.patch_count):
                divide_into_strips(side.patches[number], work.contact.strips)
                place_strips(pair, work.contact, side.patches[number])
        if tables.depth == DEPTH_ALL:
            write_outline(
                side.outline, tables.stations, side, work.contact.strips, work.contact.regions, count
            )
            if has_wear(tables) and side.patch_count > 0:
                place_wear(pair, work.contact, side)
    return count, VALID


def touch_side(tables: Tables, work: Work, index: int):
    """Describe the side whose wheel just touches, with the vertical shift of its smallest
    gap; its status, UNLOADED."""
    side = work.sides[index]
    clear_side(side)
    status = UNLOADED
    if not describe_contact(tables, work, index, side.best_y, 0.0, side.best):
        status = OFF_PROFILE
    return status


def solve_side(tables: Tables, work: Work, index: int, force: float):
    """Contact and patches of one side of a rigid wheelset, as far as they are requested; its status."""
    status = touch_side(tables, work, index)
    if status == UNLOADED:
        penetration = tables.penetration[index]
        pressed = force
        if isfinite(penetration):
            pressed = penetration
        if pressed > 0.0:
            status = VALID
            if tables.depth != DEPTH_GEOMETRY:
                count, status = load_side(tables, work, index, force, penetration)
    return status


def lower_wheel(tables: Tables, work: Work, index: int, approach: float):
    """Describe the side whose wheel is ``approach`` [m] below its smallest gap, where it overlaps its
    rail most; its status."""
    pair = tables.pairs[index]
    side = work.sides[index]
    height = side.best + approach
    clear_side(side)
    if find_points(tables, work.contact, side, index, height) == 0:
        # it overlaps most at the end of a profile
        return OFF_PROFILE
    deepest = work.contact.overlap.points[deepest_entry(work.contact.overlap)]
    aside, shift = touching_shift(pair, side.place, deepest)
    describe_contact(tables, work, index, deepest.wheel, aside, shift)
    lower_frame(work.contact.frame, height, deepest.depth, 0.0)
    work.contact.frame.way = rail_way(pair, deepest.rail)
    return VALID


def find_points(tables: Tables, contact: Contact, side: SideSearch, index: int, height: float):
    """List the deepest points of a wheel moved down by ``height`` [m]; how many.  Those of the last search
    are followed where the contact's ``following`` permits it."""
    pair = tables.pairs[index]
    kept = contact.deep_points[index]
    contact.trial = kept
    count = 0
    if contact.following and kept.count > 0:
        count = follow_overlaps(pair, contact.overlap, kept, side.place, height)
    if count == 0:
        count = find_overlaps(pair, contact.overlap, side, height)
    keep_points(contact.overlap, kept)
    return count


def side_lever(tables: Tables, work: Work, index: int, count: int):
    """How the height at which a side carries its load follows the roll [m], from its regions'
    levers and stiffnesses."""
    pair = tables.pairs[index]
    at = work.sides[index].place
    total = 0.0
    weight = 0.0
    for region in range(count):
        block = work.contact.regions[region]
        stiffness = block.stiffness * block.share * block.cos
        weight += stiffness
        total += stiffness * gap_per_roll(pair, at, block.wheel)
    lever = gap_per_roll(pair, at, work.sides[index].best_y)
    if weight > 0.0:
        lever = total / weight
    return lever
