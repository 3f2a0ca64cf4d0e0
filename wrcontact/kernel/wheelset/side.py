"""One side of a wheelset, from where its wheel is to its outputs: contact, patches, and its
share of the resultant."""

from math import isfinite

from ..contact.deep_points import deepest_entry
from ..contact.followed_overlaps import follow_overlaps, keep_points
from ..contact.overlaps import find_overlaps
from ..contact.pressed_regions import press_frame, touching_shift
from ..layout import (
    DEPTH_ALL,
    DEPTH_GEOMETRY,
    NOT_CONVERGED,
    OFF_PROFILE,
    SIDE_SIZE,
    UNLOADED,
    VALID,
    Contact,
    Outline,
    SideSearch,
    State,
    Tables,
    Work,
)
from ..normal.normal_contact import solve_normal
from ..patch.outline import write_outline
from ..patch.totals import write_patches
from ..surface.gap import gap_per_roll
from .contact_point import describe_contact
from .outlines import fill_apart, outline_place
from .resultant import add_patches, clear_resultant
from .rolling_patches import keep_rolling


def clear_side(tables: Tables, work: Work, index: int):
    """Zeros in a side's outputs."""
    out = work.outputs.left[index]
    for i in range(SIDE_SIZE):
        out[i] = 0.0
    work.rolling_sides[index].count = 0
    fill_apart(tables, work, index, 0.0)
    return 0


def load_side(tables: Tables, work: Work, state: State, index: int, force: float, prescribed: float):
    """Normal contact of the side whose frame is open, and its part of the resultant if patches are filled in;
    number of its regions and outcome."""
    out = work.outputs.left[index]
    penetration, count, satisfied = solve_normal(tables, work.contact, state, work.sides[index], out, force,
                                                 prescribed)
    out.penetration = penetration
    if satisfied == 0 and count == 0:
        # it overlaps most at the end of a profile
        return count, OFF_PROFILE
    if satisfied == 0:
        return count, NOT_CONVERGED
    if work.contact.filling:
        add_patches(tables, work.contact, penetration, float(2 * index - 1), work.supports[index].resultant)
        write_patches(work.contact.solved, out)
        keep_rolling(tables, work.contact, work.rolling_sides[index], float(2 * index - 1))
        if tables.depth == DEPTH_ALL:
            outline = Outline.at(work, outline_place(tables, work, index))
            write_outline(outline, tables.stations, work.contact.solved, work.contact.regions, count)
    return count, VALID


def touch_side(tables: Tables, work: Work, state: State, index: int):
    """Describe the side whose wheel just touches, with the vertical shift of its smallest
    gap; its outcome, UNLOADED."""
    side = work.sides[index]
    clear_side(tables, work, index)
    clear_resultant(work.supports[index].resultant)
    status = UNLOADED
    if describe_contact(tables, work, state, index, side.best_y, 0.0, side.best) == 0:
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
    clear_side(tables, work, index)
    clear_resultant(work.supports[index].resultant)
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
