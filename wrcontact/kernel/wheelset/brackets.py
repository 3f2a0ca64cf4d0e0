"""Elastic equilibrium by brackets around brackets: slow, and it cannot fail while the
flatter wheel carries its load.

A steep flange may carry its load at several heights of one roll, or at none that is not too deep; at the
height of the other wheel its load has one value at every roll. So the flatter wheel gives the height of each
roll, and the steeper one the residual that changes its sign at the roll in equilibrium. Where that jumps,
since a region comes or goes, the roll of the jump is taken.
"""

from math import fabs
from typing import Final

from ..layout import (
    NOT_CONVERGED,
    OFF_PROFILE,
    ROLL_LIMIT,
    UNLOADED,
    VALID,
    Bracket,
    Regions,
    Sides,
    Tables,
    Work,
    seldom,
)
from .side import load_side, lower_wheel
from .residuals import DEEPEST, SHALLOWEST, balance_side, depth_status, permitted_approach, turn_to

#: Brackets end here, or when they or what they enclose are this small [m, rad].
BRACKETINGS: Final[int] = 90
BRACKET_SHARP: Final[float] = 1e-13
#: First distance from the rigid roll at which the other end of a bracket is looked for [rad].
FIRST_REACH: Final[float] = 2e-5
#: The share by which the approach grows while the lower end of a bracket is looked for [-].
DEEPER: Final[float] = 1.5


@seldom
def next_in_bracket(bracket: Bracket, i: int):
    """Where to look next for a root in a bracket: on the chord between both values,
    and every other time half way."""
    low = bracket.low
    high = bracket.high
    place = 0.5 * (low + high)
    if i % 2 == 0:
        chord = low - bracket.at_low * (high - low) / (bracket.at_high - bracket.at_low)
        if chord > low and chord < high:
            place = chord
    return place


@seldom
def open_bracket(bracket: Bracket, place: float, value: float):
    """Let both ends of the bracket be at ``place``, with this ``value``."""
    bracket.low = place
    bracket.high = place
    bracket.at_low = value
    bracket.at_high = value


@seldom
def is_within(bracket: Bracket, place: float) -> bool:
    """Whether a place lies between both ends of a bracket."""
    return place > bracket.low and place < bracket.high


@seldom
def narrow_bracket(bracket: Bracket, place: float, value: float):
    """Let ``place`` be an end of the bracket: the low one if its ``value`` is positive, else the high one."""
    if value > 0.0:
        bracket.low = place
        bracket.at_low = value
    else:
        bracket.high = place
        bracket.at_high = value


# --- the height of one side -------------------------------------------------------------------------------


@seldom
def carried_load(regions: Regions, count: int):
    """What ``count`` regions carry [N], vertically where the prescribed load is vertical."""
    total = 0.0
    for index in range(count):
        region = regions[index]
        total += region.share * region.carried
    return total


@seldom
def height_residual(tables: Tables, work: Work, index: int, force: float, height: float):
    """How much lower than ``height`` [m] a side carries ``force`` [N], with regions and nodes as they are
    there [m]; whether they can carry it; and the status.

    The nodes of a deep wheel may carry more than the force at every approach, or less; then what they carry
    at ``height`` shows whether that is too low or too high, and the residual counts as the whole approach.
    """
    support = work.supports[index]
    status = balance_side(tables, work, index, force, height)
    residual = support.height - height
    satisfied = True
    if status == NOT_CONVERGED:
        satisfied = False
        approach = permitted_approach(support, work.sides[index], height)
        status = lower_wheel(tables, work, index, approach)
        if status == VALID:
            # what regions carry is known with their patches
            filling = work.contact.filling
            work.contact.filling = True
            count, status = load_side(tables, work, index, 0.0, work.contact.frame.depth)
            work.contact.filling = filling
            residual = approach
            if carried_load(work.contact.regions, count) > force:
                residual = -approach
            support.height = height + residual
    return residual, satisfied, status


@seldom
def bracket_height(tables: Tables, work: Work, index: int, force: float):
    """Find the height at which a side carries ``force`` [N] with regions and nodes as they
    are just there; the status.

    The residual is positive where the side is too high, negative where it is too low. Where its load jumps
    past the force as it comes down, since a region comes or goes, the height of the jump is taken, with the
    regions just below it, or just above where those cannot carry the force. Where DEEPEST is too high the
    height is what it would be with regions as they are there.
    """
    support = work.supports[index]
    bracket = work.height_bracket
    best = work.sides[index].best
    if not force > 0.0:
        return balance_side(tables, work, index, force, best)
    height = best + SHALLOWEST * support.approach
    residual, satisfied, status = height_residual(tables, work, index, force, height)
    if status > UNLOADED:
        return status
    if residual <= 0.0:
        if not satisfied:
            status = NOT_CONVERGED
        return status
    bracket.high = height
    bracket.at_high = residual
    while bracket.at_high > 0.0:
        if bracket.high >= best + DEEPEST:
            return status
        bracket.low = bracket.high
        bracket.at_low = bracket.at_high
        height = min(best + DEEPER * (bracket.high - best), best + DEEPEST)
        residual, satisfied, status = height_residual(tables, work, index, force, height)
        bracket.high = height
        bracket.at_high = residual
        if status > UNLOADED:
            return status
    for i in range(BRACKETINGS):
        height = next_in_bracket(bracket, i)
        residual, satisfied, status = height_residual(tables, work, index, force, height)
        if status > UNLOADED or fabs(residual) < BRACKET_SHARP:
            return status
        narrow_bracket(bracket, height, residual)
        if bracket.high - bracket.low < BRACKET_SHARP:
            break
    status = balance_side(tables, work, index, force, bracket.high)
    if status == NOT_CONVERGED:
        status = balance_side(tables, work, index, force, bracket.low)
    support.height = bracket.high
    return status


# --- the roll ---------------------------------------------------------------------------------------------


@seldom
def flatter_side(sides: Sides):
    """The side whose wheel touches at the smaller angle; the left one where they are equal."""
    flat = 0
    if fabs(sides[1].point.contact_angle) < fabs(sides[0].point.contact_angle):
        flat = 1
    return flat


@seldom
def roll_residual(tables: Tables, work: Work, roll: float, left: float, right: float, flat: int):
    """Let side ``flat`` carry its load at ``roll``, and move the other one to this height;
    how much lower the right one carries its load than the left one [m], whether both can carry
    their loads, and the status."""
    if not turn_to(tables, work, roll):
        return 0.0, False, OFF_PROFILE
    work.sides[1].roll_count += 1.0
    if flat == 1:
        residual, satisfied, status = level_residual(tables, work, 1, right, left)
        residual = -residual
    else:
        residual, satisfied, status = level_residual(tables, work, 0, left, right)
    return residual, satisfied, status


@seldom
def level_residual(tables: Tables, work: Work, flat: int, flat_force: float, steep_force: float):
    """Let side ``flat`` carry ``flat_force`` [N], and move the other one to this height; how much lower the
    other one carries ``steep_force`` [N] [m], whether both can carry their loads, and the status."""
    status = bracket_height(tables, work, flat, flat_force)
    if status > UNLOADED:
        return 0.0, False, status
    height = work.supports[flat].height
    residual, satisfied, side_status = height_residual(tables, work, 1 - flat, steep_force, height)
    work.supports[1 - flat].height = height
    status = max(status, side_status)
    return residual, satisfied, status


@seldom
def enclose_roll(tables: Tables, work: Work, roll: float, left: float, right: float, flat: int):
    """Bracket the roll in equilibrium by looking further and further from ``roll`` on; the status,
    NOT_CONVERGED if there is none within ROLL_LIMIT."""
    bracket = work.roll_bracket
    residual, satisfied, status = roll_residual(tables, work, roll, left, right, flat)
    if status > UNLOADED:
        return status
    open_bracket(bracket, roll, residual)
    reach = FIRST_REACH
    while bracket.at_low * bracket.at_high > 0.0:
        if reach > ROLL_LIMIT:
            return NOT_CONVERGED
        if residual > 0.0:
            bracket.low = bracket.high
            bracket.at_low = bracket.at_high
            bracket.high = roll + reach
            value, satisfied, status = roll_residual(tables, work, bracket.high, left, right, flat)
            bracket.at_high = value
        else:
            bracket.high = bracket.low
            bracket.at_high = bracket.at_low
            bracket.low = roll - reach
            value, satisfied, status = roll_residual(tables, work, bracket.low, left, right, flat)
            bracket.at_low = value
        if status > UNLOADED:
            return status
        reach *= 2.0
    return status


@seldom
def bracket_roll(tables: Tables, work: Work, roll: float, left: float, right: float):
    """Roll [rad] of the wheelset in equilibrium under ``left`` and ``right`` [N], and the status,
    from the rigid ``roll``."""
    bracket = work.roll_bracket
    flat = flatter_side(work.sides)
    status = enclose_roll(tables, work, roll, left, right, flat)
    if status > UNLOADED:
        return roll, status
    residual = 0.0
    satisfied = False
    for i in range(BRACKETINGS):
        roll = next_in_bracket(bracket, i)
        residual, satisfied, status = roll_residual(tables, work, roll, left, right, flat)
        if status > UNLOADED:
            return roll, status
        narrow_bracket(bracket, roll, residual)
        if fabs(residual) < BRACKET_SHARP or bracket.high - bracket.low < BRACKET_SHARP:
            break
    if fabs(residual) >= BRACKET_SHARP:
        # of both ends of a jump always the same, at which the steeper wheel carries no less than its load
        end = bracket.high
        if flat == 1:
            end = bracket.low
        if roll != end:
            roll = end
            residual, satisfied, status = roll_residual(tables, work, roll, left, right, flat)
    if not satisfied:
        # or the one whose nodes can carry the force
        other = bracket.low
        if roll == bracket.low:
            other = bracket.high
        roll = other
        residual, satisfied, status = roll_residual(tables, work, roll, left, right, flat)
    if status <= UNLOADED:
        if not satisfied:
            status = NOT_CONVERGED
        status = depth_status(work, status)
    return roll, status
