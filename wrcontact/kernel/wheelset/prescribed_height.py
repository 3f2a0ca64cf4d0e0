"""One side of a wheelset whose height and roll are given: its smallest gap, and the load that follows from
how deep the wheel is in its rail.

With contact damping the force of a patch is multiplied by 1 + d a, with the damping d [s/m] and the speed a
[m/s] at which wheel and rail approach each other along the patch's normal at its centre of load; it is never
below zero.  Areas and pressures stay those of the elastic contact.  What the forces of the pressures take
more from the motion than without damping is the power of damping.
"""

from typing import Final

from ..layout import (
    DEPTH_GEOMETRY,
    MODE_COMPLIANT,
    OFF_PROFILE,
    ROLLING_STRIP_LIMIT,
    VALID,
    Motion,
    Patch,
    SideSearch,
    Tables,
    Work,
    seldom,
)
from ..creep.creepage import approach_rate
from ..patch.filling import total_patches
from ..search.roll import follow_side, nearest_start
from ..search.smallest_gap import search_side
from ..surface.rails import is_sprung
from .side import load_side, lower_wheel, touch_side
from .residuals import DEEPEST

#: A wheel that overlaps its rail by less than this [m], to which smallest gaps are known,
#: does not touch; 5e-9 N.
GRAZING: Final[float] = 1e-13


@seldom
def search_near(tables: Tables, work: Work, index: int, row: int) -> bool:
    """Search a side, from the smallest gap that is known near the lateral shift in this ``row`` if it can be
    followed; whether its wheel is above its rail."""
    side = work.sides[index]
    known = row >= 0
    if known:
        start = tables.starts.rows[row]
        side.best_y = start.left
        if index == 1:
            side.best_y = start.right
        known = follow_side(tables.pairs[index], side)
    return search_side(tables.pairs[index], side, known)


@seldom
def load_at_height(tables: Tables, work: Work, index: int, height: float):
    """The load of a side whose wheelset has the vertical shift ``height`` [m], if it is requested; its
    outcome, UNLOADED if lifted."""
    approach = height - work.sides[index].best
    if not approach > GRAZING:
        return touch_side(tables, work, index)
    if approach > DEEPEST:
        return OFF_PROFILE
    status = lower_wheel(tables, work, index, approach)
    if tables.depth == DEPTH_GEOMETRY and not is_sprung(tables, index):
        return status
    if status == VALID:
        count, status = load_side(tables, work, index, 0.0, work.contact.frame.depth)
    if status == VALID and is_damped(tables):
        damp_patches(tables, work.sides[index])
    return status


# --- damping ----------------------------------------------------------------------------------------------


@seldom
def is_damped(tables: Tables) -> bool:
    """Whether contact is damped."""
    return tables.mode == MODE_COMPLIANT and tables.parameters.contact_damping > 0.0


@seldom
def damp_patches(tables: Tables, side: SideSearch):
    """Damp the patches of a side."""
    for number in range(side.patch_count):
        patch = side.patches[number]
        factor = damping_factor(tables, approach_rate(side.motion, patch))
        patch.damping_power = (factor - 1.0) * pressing_power(side.motion, patch)
        damp_patch(patch, factor)
    total_patches(side)


@seldom
def damping_factor(tables: Tables, approach: float):
    """What the force of a patch is multiplied by whose wheel and rail ``approach`` each other [m/s]."""
    return max(1.0 + tables.parameters.contact_damping * approach, 0.0)


@seldom
def pressing_power(motion: Motion, patch: Patch):
    """Power [W] that the pressures of a patch take from the motion of wheel and rail towards each other, all
    its regions along their own normals; the rotation of a round wheel about its axle has no part of it."""
    rail = motion.rail
    force_y = patch.normal_y
    force_z = patch.normal_z
    moment_x = patch.normal_moment[0] - (motion.centre_y * force_z - motion.centre_z * force_y)
    rail_moment = patch.normal_moment[0] - (rail.y * force_z - rail.z * force_y)
    return (
        rail_moment * rail.roll
        - force_y * (motion.lateral - rail.lateral)
        - force_z * (motion.vertical - rail.vertical)
        - moment_x * motion.turn_x
        - patch.normal_moment[1] * motion.turn_y
        - patch.normal_moment[2] * motion.turn_z
    )


@seldom
def damp_patch(patch: Patch, factor: float):
    """Multiply load, force and moments of a patch by ``factor``."""
    patch.totals.load *= factor
    patch.totals.moment *= factor
    patch.normal_x *= factor
    patch.normal_y *= factor
    patch.normal_z *= factor
    for i in range(3):
        patch.normal_moment[i] *= factor
    for i in range(ROLLING_STRIP_LIMIT):
        strip = patch.strips[i]
        strip.line_load *= factor
