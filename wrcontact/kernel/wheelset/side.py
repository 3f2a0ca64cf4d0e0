"""One side of a wheelset, from where its wheel stands to its outputs: contact, patches, and its share of the resultant."""

from math import isfinite
from typing import Final

from ..contact.contact_point import describe_contact
from ..surface.gap import gap_per_roll
from ..layout import (DEPTH_GEOMETRY, DEPTH_PATCHES, NOT_CONVERGED, OFF_PROFILE, OUT_LEFT, OUT_RIGHT, PLACE_BLOCK,
                     SET_ABSENT, SET_DEPTH, SET_PENETRATION_LEFT, SIDE_BEST, SIDE_BEST_Y, SIDE_BLOCK, SIDE_PATCH_COUNT,
                     SIDE_PENETRATION, SIDE_SIZE, SIDE_STATION, SUPPORT_BLOCK, UNLOADED, VALID, WORK_OUTPUTS, WORK_PLACE,
                     WORK_SIDE, WORK_SUPPORT)
from ..normal.normal_contact import solve_normal
from ..patch.outline import fill_apart
from ..contact.overlaps import (DEEP_DEPTH, DEEP_FIRST, DEEP_SIZE, DEEP_WHEEL, deepest_entry, find_overlaps, press_frame,
                       touching_shift)
from ..contact.regions import REGION_COS, REGION_SHARE, REGION_STIFFNESS, REGION_WHEEL, region_block
from .resultant import add_region, clear_resultant

# how a side carries its load, at WORK_SUPPORT + SUPPORT_BLOCK * index
SUPPORT_FIRST: Final[int] = 0        # how far below its smallest gap the wheel is estimated to sink [m]
SUPPORT_HEIGHT: Final[int] = 1       # the vertical shift at which it carries its load [m]
SUPPORT_LEVER: Final[int] = 2        # how that follows the roll [m]
SUPPORT_RESULTANT: Final[int] = 8    # force on the wheel and its moment about the track's origin


def side_outputs(index: int):
    """Offset in the workspace of the outputs of side ``index`` (0 left, 1 right)."""
    return WORK_OUTPUTS + OUT_LEFT + (OUT_RIGHT - OUT_LEFT) * index


def side_resultant(index: int):
    """Offset in the workspace of the force and moment of side ``index``."""
    return WORK_SUPPORT + SUPPORT_BLOCK * index + SUPPORT_RESULTANT


def clear_side(tables: 'float[:]', work: 'float[:]', out: int):
    """Zeros in a side's outputs."""
    for i in range(SIDE_SIZE):
        work[out + i] = 0.0
    fill_apart(tables, work, out, 0.0)
    return 0


def clear_from(tables: 'float[:]', work: 'float[:]', out: int, first: int):
    """Write what stands for outputs that are not wanted, from a side's output ``first`` on."""
    for i in range(first, SIDE_SIZE):
        work[out + i] = tables[SET_ABSENT]
    fill_apart(tables, work, out, tables[SET_ABSENT])
    if first <= SIDE_PENETRATION:
        work[out + SIDE_PATCH_COUNT] = tables[SET_ABSENT]
    return 0


def first_unwanted(tables: 'float[:]'):
    """The first of a side's outputs that is not wanted; SIDE_SIZE if all are."""
    depth = int(tables[SET_DEPTH])
    first = SIDE_SIZE
    if depth == DEPTH_PATCHES:
        first = SIDE_STATION
    if depth == DEPTH_GEOMETRY:
        first = SIDE_PENETRATION
    return first


def load_side(tables: 'float[:]', work: 'float[:]', state: 'float[:]', index: int, force: float, prescribed: float):
    """Normal contact of the side whose frame is open, and its part of the resultant; number of its regions and outcome."""
    status = VALID
    count, met = solve_normal(tables, work, state, WORK_SIDE + SIDE_BLOCK * index, side_outputs(index), force, prescribed)
    if met == 0:
        status = NOT_CONVERGED
    else:
        for region in range(count):
            add_region(tables, work, region, float(2 * index - 1), side_resultant(index))
    return count, status


def rest_side(tables: 'float[:]', work: 'float[:]', state: 'float[:]', index: int):
    """Describe the side whose wheel just touches, with the vertical shift of its smallest gap; its outcome, UNLOADED."""
    side = WORK_SIDE + SIDE_BLOCK * index
    clear_side(tables, work, side_outputs(index))
    clear_resultant(work, side_resultant(index))
    status = UNLOADED
    if describe_contact(tables, work, state, index, work[side + SIDE_BEST_Y], 0.0, work[side + SIDE_BEST]) == 0:
        status = OFF_PROFILE
    return status


def step_side(tables: 'float[:]', work: 'float[:]', state: 'float[:]', index: int, force: float):
    """Contact and patches of one side of a rigid wheelset, as far as they are wanted; its outcome."""
    status = rest_side(tables, work, state, index)
    if status == UNLOADED:
        penetration = tables[SET_PENETRATION_LEFT + index]
        pressed = force
        if isfinite(penetration):
            pressed = penetration
        if pressed > 0.0:
            status = VALID
            if int(tables[SET_DEPTH]) != DEPTH_GEOMETRY:
                count, status = load_side(tables, work, state, index, force, penetration)
    return status


def press_side(tables: 'float[:]', work: 'float[:]', state: 'float[:]', index: int, sink: float):
    """Describe the side whose wheel stands ``sink`` [m] below its smallest gap, where it overlaps its rail most; its outcome."""
    side = WORK_SIDE + SIDE_BLOCK * index
    at = WORK_PLACE + PLACE_BLOCK * index
    height = work[side + SIDE_BEST] + sink
    clear_side(tables, work, side_outputs(index))
    clear_resultant(work, side_resultant(index))
    if find_overlaps(tables, work, state, side, at, height) == 0:
        # it overlaps most at the end of a profile
        return OFF_PROFILE
    deepest = deepest_entry(work)
    deep = DEEP_FIRST + DEEP_SIZE * deepest
    aside, shift = touching_shift(tables, work, at, deepest, height)
    describe_contact(tables, work, state, index, work[deep + DEEP_WHEEL], aside, shift)
    press_frame(work, height, work[deep + DEEP_DEPTH], 0.0)
    return VALID


def side_lever(tables: 'float[:]', work: 'float[:]', index: int, count: int):
    """How the height at which a side carries its load follows the roll [m], from its regions' levers and stiffnesses."""
    at = WORK_PLACE + PLACE_BLOCK * index
    total = 0.0
    weight = 0.0
    for region in range(count):
        block = region_block(region)
        stiffness = work[block + REGION_STIFFNESS] * work[block + REGION_SHARE] * work[block + REGION_COS]
        weight += stiffness
        total += stiffness * gap_per_roll(tables, work, at, work[block + REGION_WHEEL])
    lever = gap_per_roll(tables, work, at, work[WORK_SIDE + SIDE_BLOCK * index + SIDE_BEST_Y])
    if weight > 0.0:
        lever = total / weight
    return lever
