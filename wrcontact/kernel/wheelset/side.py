"""One side of a wheelset, from where its wheel is to its patches."""

from math import isfinite

from ..contact.deep_points import deepest_entry
from ..contact.followed_overlaps import follow_overlaps, keep_points
from ..contact.overlaps import find_overlaps
from ..contact.pressed_regions import press_frame, touching_shift
from ..layout import (DEPTH_ALL, DEPTH_GEOMETRY, NOT_CONVERGED, OFF_PROFILE, TANGENTIAL_NONE, UNLOADED, VALID,
                      Contact, SideSearch, State, Tables, Work)
from ..normal.normal_contact import solve_normal
from ..normal.patch_places import place_patches, place_strips
from ..patch.filling import clear_patches
from ..patch.outline import write_outline
from ..surface.gap import gap_per_roll
from ..tangential.sections import cut_patch
from .contact_point import describe_contact


def clear_side(side: SideSearch):
    """A side without load."""
    side.penetration = 0.0
    clear_patches(side)


def load_side(tables: Tables, work: Work, state: State, index: int, force: float, prescribed: float):
    """Normal contact of the side whose frame is open, and its patches if they are filled in; number of its
    regions and outcome."""
    side = work.sides[index]
    penetration, count, satisfied = solve_normal(tables, work.contact, state, side, force, prescribed)
    side.penetration = penetration
    if not satisfied and count == 0:
        # it overlaps most at the end of a profile
        return count, OFF_PROFILE
    if not satisfied:
        return count, NOT_CONVERGED
    if work.contact.filling:
        place_patches(tables, work.contact, side)
        if tables.tangential != TANGENTIAL_NONE:
            for number in range(side.patch_count):
                cut_patch(side.patches[number], work.contact.strips)
                place_strips(tables, work.contact, side.patches[number])
        if tables.depth == DEPTH_ALL:
            write_outline(side.outline, tables.stations, side, work.contact.strips, work.contact.regions,
                          count)
    return count, VALID


def touch_side(tables: Tables, work: Work, state: State, index: int):
    """Describe the side whose wheel just touches, with the vertical shift of its smallest
    gap; its outcome, UNLOADED."""
    side = work.sides[index]
    clear_side(side)
    status = UNLOADED
    if not describe_contact(tables, work, state, index, side.best_y, 0.0, side.best):
        status = OFF_PROFILE
    return status


def solve_side(tables: Tables, work: Work, state: State, index: int, force: float):
    """Contact and patches of one side of a rigid wheelset, as far as they are requested; its outcome."""
    status = touch_side(tables, work, state, index)
    if status == UNLOADED:
        penetration = tables.penetration[index]
        pressed = force
        if isfinite(penetration):
            pressed = penetration
        if pressed > 0.0:
            status = VALID
            if tables.depth != DEPTH_GEOMETRY:
                count, status = load_side(tables, work, state, index, force, penetration)
    return status


def press_side(tables: Tables, work: Work, state: State, index: int, approach: float):
    """Describe the side whose wheel is ``approach`` [m] below its smallest gap, where it overlaps its
    rail most; its outcome."""
    side = work.sides[index]
    height = side.best + approach
    clear_side(side)
    if find_points(tables, work.contact, state, side, index, height) == 0:
        # it overlaps most at the end of a profile
        return OFF_PROFILE
    deepest = work.contact.overlap.points[deepest_entry(work.contact.overlap)]
    aside, shift = touching_shift(tables, side.place, deepest)
    describe_contact(tables, work, state, index, deepest.wheel, aside, shift)
    press_frame(work.contact.frame, height, deepest.depth, 0.0)
    return VALID


def find_points(tables: Tables, contact: Contact, state: State, side: SideSearch, index: int, height: float):
    """List the deepest points of a wheel moved down by ``height`` [m]; how many.  Those of the last search
    are followed where the contact's ``following`` permits it."""
    kept = contact.deep_points[index]
    count = 0
    if contact.following and kept.count > 0:
        count = follow_overlaps(tables, contact.overlap, kept, side.place, height)
    if count == 0:
        count = find_overlaps(tables, contact.overlap, side, state, height)
    keep_points(contact.overlap, kept)
    return count


def side_lever(tables: Tables, work: Work, index: int, count: int):
    """How the height at which a side carries its load follows the roll [m], from its regions'
    levers and stiffnesses."""
    at = work.sides[index].place
    total = 0.0
    weight = 0.0
    for region in range(count):
        block = work.contact.regions[region]
        stiffness = block.stiffness * block.share * block.cos
        weight += stiffness
        total += stiffness * gap_per_roll(tables, at, block.wheel)
    lever = gap_per_roll(tables, at, work.sides[index].best_y)
    if weight > 0.0:
        lever = total / weight
    return lever
