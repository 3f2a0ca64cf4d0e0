"""Creepages and creep forces of the patches of one wheel, whose rail may change along the track (creep/leaning.py)."""

from ..creep.creepage import move_patch
from ..creep.leaning import (
    enclose_leaning_rates,
    move_leaning_patch,
    move_leaning_strips,
)
from ..creep.turning import enclose_rates
from ..layout import (
    ROLLING_STRIP_LIMIT,
    SOLVED_PATCH_LIMIT,
    TANGENTIAL_NONE,
    Forces,
    Leaning,
    LeaningPatch,
    Motion,
    Patch,
    Tables,
    Work,
)
from .forces import add_creep_force, turn_creep_force
from .rolling_contact import move_side


def leaning_place(index: int, number: int):
    """Where the places of contact of patch ``number`` of side ``index`` are."""
    return SOLVED_PATCH_LIMIT * index + number


def move_wheel(tables: Tables, work: Work, index: int):
    """Creepages of the patches of side ``index``, whose motion is known, and of their strips."""
    side = work.sides[index]
    if not tables.pairs[index].changing:
        move_side(tables, side)
        return
    for number in range(side.patch_count):
        patch = side.patches[number]
        leaning = work.leaning[leaning_place(index, number)]
        move_leaning_patch(side.motion, leaning, patch)
        if tables.tangential != TANGENTIAL_NONE:
            move_leaning_strips(side.motion, leaning, patch)


def enclose_wheel(tables: Tables, work: Work, index: int):
    """Let the enclosure of the rotation hold the rates of all strips of side ``index``."""
    side = work.sides[index]
    for number in range(side.patch_count):
        if tables.pairs[index].changing:
            leaning = work.leaning[leaning_place(index, number)]
            enclose_leaning_rates(work.turning, side.motion, leaning, side.patches[number])
        else:
            enclose_rates(work.turning, side.motion, side.patches[number])


def move_one(tables: Tables, work: Work, index: int, number: int):
    """Creepages of patch ``number`` of side ``index``, but not of its strips."""
    side = work.sides[index]
    if tables.pairs[index].changing:
        move_leaning_patch(side.motion, work.leaning[leaning_place(index, number)], side.patches[number])
    else:
        move_patch(side.motion, side.patches[number])


def force_one(tables: Tables, work: Work, index: int, number: int):
    """Add the creep force of patch ``number`` of side ``index`` to its forces."""
    side = work.sides[index]
    if tables.pairs[index].changing:
        add_leaning_force(side.motion, work.leaning[leaning_place(index, number)], side.patches[number])
    else:
        add_creep_force(side.motion, side.patches[number])


def add_leaning_force(motion: Motion, leaning: LeaningPatch, patch: Patch):
    """Add the creep force of a patch on a rail that changes to its forces: as forces.add_creep_force, with planes that lean
    along the track, too."""
    forces = patch.forces
    rest_x = patch.creep_x
    rest_y = patch.creep_y
    turning = patch.creep_moment
    moment_x = 0.0
    moment_y = 0.0
    moment_z = 0.0
    missing = 0.0
    for i in range(ROLLING_STRIP_LIMIT):
        strip = patch.strips[i]
        ahead = strip.force_x * strip.width
        across = strip.force_y * strip.width
        spinning = strip.moment * strip.width
        rest_x -= ahead
        rest_y -= across
        turning += strip.y * ahead - spinning
        part_x, part_y, part_z, about = add_traction(motion, leaning.strips[i], forces, ahead, across)
        spinning -= strip.x * across
        moment_x += part_x + leaning.strips[i].down[0] * spinning
        moment_y += part_y + leaning.strips[i].down[1] * spinning
        moment_z += part_z + leaning.strips[i].down[2] * spinning
        missing += (strip.radius_share - 1.0) * about
    part_x, part_y, part_z, about = add_traction(motion, leaning.own, forces, rest_x, rest_y)
    moment_x += part_x + leaning.own.down[0] * turning
    moment_y += part_y + leaning.own.down[1] * turning
    moment_z += part_z + leaning.own.down[2] * turning
    missing += (patch.radius_share - 1.0) * about
    turn_creep_force(motion, patch, moment_x, moment_y, moment_z, missing)


def add_traction(motion: Motion, at: Leaning, forces: Forces, ahead: float, across: float):
    """Add a force in the plane of a place [N] to the ``forces`` of its patch; its moment about the wheelset's centre, and the
    part of that about the axle [N m]."""
    x = at.ahead[0] * ahead + at.aside[0] * across
    y = at.ahead[1] * ahead + at.aside[1] * across
    z = at.ahead[2] * ahead + at.aside[2] * across
    forces.force[0] += x
    forces.force[1] += y
    forces.force[2] += z
    away_y = at.y - motion.centre_y
    away_z = at.z - motion.centre_z
    moment_x = away_y * z - away_z * y
    moment_y = away_z * x - at.x * z
    moment_z = at.x * y - away_y * x
    about = moment_x * motion.axle_x + moment_y * motion.axle_y + moment_z * motion.axle_z
    return moment_x, moment_y, moment_z, about
