"""One trial of an elastic wheelset: both wheels pressed into their rails at one height and roll.

Regions and nodes are placed where the wheel is at the height of the trial. With them the height
follows at which the side carries its force; the residual, how much lower than the trial that is,
vanishes in equilibrium.
"""

from typing import Final

from ..layout import OFF_PROFILE, UNLOADED, VALID, SideSearch, Support, Tables, Work, seldom
from ..normal.estimate import first_penetration
from ..search.roll import follow_side, search_both, turn_both
from .side import load_side, lower_wheel, side_lever, touch_side

#: A loaded wheel is pressed down by this share of its first estimate at least [-].
SHALLOWEST: Final[float] = 0.1
#: A wheel that is pressed deeper into its rail than this [m] is off the profile.
DEEPEST: Final[float] = 2e-3


@seldom
def estimate_approach(tables: Tables, work: Work, index: int, force: float):
    """Estimate how far a wheel under ``force`` [N] comes down below its smallest gap; the status."""
    pair = tables.pairs[index]
    support = work.supports[index]
    status = touch_side(tables, work, index)
    support.approach = 0.0
    if status == UNLOADED:
        status = VALID
        if force > 0.0:
            support.approach = first_penetration(pair, work.contact, force) / work.contact.frame.plane.cos
    return status


@seldom
def permitted_approach(support: Support, side: SideSearch, height: float):
    """How far a wheel at ``height`` is below its smallest gap [m], within the range
    in which it is pressed."""
    approach = min(max(height - side.best, SHALLOWEST * support.approach), DEEPEST)
    return approach


@seldom
def balance_side(tables: Tables, work: Work, index: int, force: float, height: float):
    """Find the height at which a side carries ``force`` [N], with regions and nodes as they are at ``height``
    [m]; its status. Patches are those of the side under this force."""
    support = work.supports[index]
    side = work.sides[index]
    if not force > 0.0:
        support.height = side.best
        support.lever = side_lever(tables, work, index, 0)
        return touch_side(tables, work, index)
    approach = permitted_approach(support, side, height)
    status = lower_wheel(tables, work, index, approach)
    if status == VALID:
        count, status = load_side(tables, work, index, force, tables.absent)
        carried = approach + (side.penetration - work.contact.frame.depth) / work.contact.frame.plane.cos
        support.height = side.best + carried
        support.lever = side_lever(tables, work, index, count)
    return status


@seldom
def balance_both(tables: Tables, work: Work, left: float, right: float, height: float):
    """``balance_side`` for both, under ``left`` and ``right`` [N]; the worse status."""
    work.sides[1].roll_count += 1.0
    work.supports[0].trials += 1.0
    status = balance_side(tables, work, 0, left, height)
    if status <= UNLOADED:
        side_status = balance_side(tables, work, 1, right, height)
        status = max(status, side_status)
    return status


@seldom
def turn_to(tables: Tables, work: Work, roll: float) -> bool:
    """Turn the wheelset to ``roll`` [rad] and find both smallest gaps; whether both wheels are
    above their rails."""
    turn_both(work.sides, roll)
    known = follow_side(tables.pairs[0], work.sides[0])
    if known:
        known = follow_side(tables.pairs[1], work.sides[1])
    return search_both(tables, work.sides, known)


@seldom
def turn_near(tables: Tables, work: Work, roll: float) -> bool:
    """Turn the wheelset to a near ``roll`` [rad] and follow both smallest gaps, or search where they cannot
    be followed; whether both wheels are above their rails.  Whether there is a smaller gap is left
    open."""
    turn_both(work.sides, roll)
    known = follow_side(tables.pairs[0], work.sides[0])
    if known:
        known = follow_side(tables.pairs[1], work.sides[1])
    if not known:
        known = search_both(tables, work.sides, False)
    return known


@seldom
def depth_status(work: Work, status: int):
    """``status``, or OFF_PROFILE if a side carries its load deeper than DEEPEST, which the
    compliant form refuses too."""
    for index in range(2):
        best = work.sides[index].best
        if work.supports[index].height - best > DEEPEST:
            status = OFF_PROFILE
    return status
