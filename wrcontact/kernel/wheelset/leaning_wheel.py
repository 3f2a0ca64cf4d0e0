"""Creepages and creep forces of the patches of one wheel, whose rail may change along the track (creep/leaning.py)."""

from ..creep.creepage import move_patch
from ..creep.leaning import (
    enclose_leaning_rates,
    move_leaning_patch,
    move_leaning_strips,
)
from ..creep.turning import enclose_rates
from ..layout import (
    SOLVED_PATCH_LIMIT,
    TANGENTIAL_NONE,
    Tables,
    Work,
)
from .forces import add_creep_force, add_leaning_force
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
