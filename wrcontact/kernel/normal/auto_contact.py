"""ANALYN where it is within its field, strips elsewhere, by the estimate of ANALYN's error (model_error).

Strips have the share

    w = u^2 (3 - 2 u),   u = (error - FIRST) / (FULL - FIRST),   within 0 ... 1                  (E3)

At w = 0 the answer is ANALYN's, at w = 1 the strips', both to the last bit.  Between them both are solved: the
penetration under a force, or the load at a penetration, is (1 - w) of ANALYN's and w of the strips', so that
heights and loads follow the pose without a step.  As soon as strips have a share the patches are theirs,
multiplied so that they carry the load: areas and pressures step at FIRST from one model's to the other's.

The answer depends on the pose alone: there is no memory that would keep a model on.  Where strips find
nothing, ANALYN's answer stays.
"""

from math import isfinite
from typing import Final

from ..contact.penetrated_regions import raise_wheel
from ..layout import REGION_LIMIT, Contact, Pair, Patch, Regions, SideSearch, SolvedStrips, seldom
from .analyn_contact import analyn_contact, fill_from_analyn, solve_analyn
from .model_error import STRIPS_MISS, analyn_error
from .strip_contact import strip_contact

#: ANALYN's error from which on strips have a share, and from which on they have all of it.
FIRST: Final[float] = 0.04
FULL: Final[float] = 0.05


@seldom
def auto_contact(pair: Pair, contact: Contact, side: SideSearch, force: float, prescribed: float):
    """Fill the patches of a side by ANALYN or strips if they are wanted; penetration [m], number of regions,
    and whether the force is satisfied.  First trials of an equilibrium are ANALYN's."""
    sunk = not contact.frame.pressed
    penetration, count, satisfied = solve_analyn(pair, contact, side, force, prescribed)
    error = FULL
    if satisfied:
        error = analyn_error(pair.tables, contact.regions, contact.nodes, count)
    share = strips_share(error)
    side.model_error = error
    if share > 0.0 and not contact.coarse:
        load = total_load(contact.regions, count)
        raise_wheel(contact.frame, sunk)
        found, strip_count, solved = strip_contact(pair, contact, side, force, prescribed)
        if solved:
            side.model_error = error * (1.0 - share * (1.0 - STRIPS_MISS))
            if satisfied and share < 1.0:
                found = penetration + share * (found - penetration)
                if isfinite(prescribed) and contact.filling:
                    scale_patches(contact, side, share + (1.0 - share) * load / side.totals.load, strip_count)
            return found, strip_count, True
        raise_wheel(contact.frame, sunk)
        penetration, count, satisfied = analyn_contact(pair, contact, side, force, prescribed)
    elif satisfied and contact.filling:
        fill_from_analyn(pair, contact, side, count)
    return penetration, count, satisfied


@seldom
def strips_share(error: float):
    """The share of the strips at this estimate of ANALYN's error; eq. (E3)."""
    u = min(max((error - FIRST) / (FULL - FIRST), 0.0), 1.0)
    return u * u * (3.0 - 2.0 * u)


@seldom
def total_load(regions: Regions, count: int):
    """What ``count`` regions of ANALYN carry together [N]."""
    load = 0.0
    for index in range(count):
        load += regions[index].load
    return load


@seldom
def scale_patches(contact: Contact, side: SideSearch, factor: float, count: int):
    """Multiply the loads and pressures of a side's patches, which lie in ``count`` regions, by ``factor``."""
    for index in range(count):
        region = contact.regions[index]
        region.carried *= factor
        region.moment *= factor
        region.stiffness *= factor
    for number in range(side.patch_count):
        scale_patch(side.patches[number], contact.strips, factor)
    side.totals.max_pressure *= factor
    side.totals.load *= factor
    side.totals.moment *= factor


@seldom
def scale_patch(patch: Patch, strips: SolvedStrips, factor: float):
    """Multiply load and pressures of a patch, which lies on ``strips``, by ``factor``."""
    totals = patch.totals
    totals.load *= factor
    totals.moment *= factor
    totals.max_pressure *= factor
    patch.pressure_square *= factor * factor
    for index in range(REGION_LIMIT):
        patch.loads[index] *= factor
        patch.moments[index] *= factor
    for k in range(patch.first, patch.last + 1):
        strip = strips[k]
        strip.line_load *= factor
        strip.pressure_square *= factor * factor
