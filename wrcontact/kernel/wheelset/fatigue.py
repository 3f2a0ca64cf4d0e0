"""The outputs of rolling contact fatigue of each patch.  wrcontact.fatigue has the same, and more, of tables."""

from math import sqrt
from typing import Final

from ..layout import PATCH_LIMIT, Patch, PatchOutputs, SideOutputs, SideSearch, seldom

#: T gamma [N] at which damage begins, and at which it is largest; beyond 175 N wear removes cracks.
FIRST_BREAK: Final[float] = 20.0
LARGEST: Final[float] = 65.0
#: Damage [1] between them, and beyond: slope [1/N] and constant.
RISE: Final[float] = 2.22e-7
RISE_CONSTANT: Final[float] = -4.44e-6
FALL: Final[float] = -9.09e-8
FALL_CONSTANT: Final[float] = 1.59e-5


@seldom
def report_fatigue(side: SideSearch, out: SideOutputs, yield_shear: float):
    """The outputs of fatigue of a side, of steel with this yield stress in cyclic shear [Pa]."""
    for number in range(side.patch_count):
        rank = side.patches[number].rank
        if rank > 0 and rank <= PATCH_LIMIT:
            report_damage(side.patches[number], out.patch[rank - 1], yield_shear)


@seldom
def report_damage(patch: Patch, out: PatchOutputs, yield_shear: float):
    """Those of one patch: p0 is 3 N / (2 A), the peak of an ellipse (Ekberg, Kabo and Andersson 2002)."""
    out.wear_number = patch.forces.wear_number
    out.fatigue_damage = wear_number_damage(patch.forces.wear_number)
    load = patch.totals.load
    if load > 0.0 and patch.totals.area > 0.0:
        out.shakedown_ratio = 1.5 * load / (patch.totals.area * yield_shear)
        force = sqrt(patch.creep_x * patch.creep_x + patch.creep_y * patch.creep_y)
        out.surface_fatigue_index = force / load - 1.0 / out.shakedown_ratio


def wear_number_damage(wear_number: float):
    """T gamma damage [1] of a passage."""
    damage = 0.0
    if wear_number >= LARGEST:
        damage = FALL * wear_number + FALL_CONSTANT
        if damage < 0.0:
            damage = 0.0
    elif wear_number >= FIRST_BREAK:
        damage = RISE * wear_number + RISE_CONSTANT
    return damage
