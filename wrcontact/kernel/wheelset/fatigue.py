"""Rolling contact fatigue of a patch.  wrcontact.fatigue has the same, and more, of tables."""

from typing import Final

from ..layout import Patch

#: T gamma [N] at which damage begins, and at which it is largest; beyond 175 N wear removes cracks.
FIRST_BREAK: Final[float] = 20.0
LARGEST: Final[float] = 65.0
#: Damage [1] between them, and beyond: slope [1/N] and constant.
RISE: Final[float] = 2.22e-7
RISE_CONSTANT: Final[float] = -4.44e-6
FALL: Final[float] = -9.09e-8
FALL_CONSTANT: Final[float] = 1.59e-5


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


def shakedown_ratio(patch: Patch, yield_shear: float):
    """p0 over the yield stress in cyclic shear [Pa], with p0 = 3 N / (2 A), the peak of an ellipse (Ekberg,
    Kabo and Andersson 2002)."""
    ratio = 0.0
    if patch.totals.area > 0.0:
        ratio = 1.5 * patch.totals.load / (patch.totals.area * yield_shear)
    return ratio
