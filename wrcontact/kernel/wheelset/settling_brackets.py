"""Rails that settle on their springs, by brackets in brackets: slow, for places where a region comes or goes
and Broyden's method finds nothing.

The vertical force falls as the rail comes down.  So for each lateral deflection a bracket finds the vertical
one; the lateral residual there changes its sign between the rail at rest and the deflection that the lateral
force at rest would give.  Where a force jumps past what the springs carry, the end of the bracket is taken at
which it is nearer to that.
"""

from math import fabs
from typing import Final

from ..layout import NOT_CONVERGED, OFF_PROFILE, UNLOADED, Bracket, Tables, Work, seldom
from ..search.roll import follow_side, place_both
from ..search.smallest_gap import search_side
from .at_height import GRAZING, is_damped
from .brackets import BRACKET_SHARP, BRACKETINGS, narrow_bracket, next_in_bracket
from .requested import is_moving
from .rubbing import open_given_motion
from .springs import deflect, has_settled, weigh_rail
from .trial import DEEPEST

#: A wheel is pressed no deeper than this share of DEEPEST while its rail is let down [-].
NOT_DEEPEST: Final[float] = 0.999
#: A rail has settled if its springs carry what the wheel presses but for this share of it [-].
BALANCED: Final[float] = 1e-12
#: A force that falls by more than this in a bracket so narrow jumps there [N/m, m]; contacts have 3e9 N/m.
STEEPEST_FORCE: Final[float] = 1e11
JUMP_WIDTH: Final[float] = 1e-8
#: Values whose difference falls by less while a bracket narrows belong to a jump [-].
LEAST_FALL: Final[float] = 0.75
#: A rail that is displaced settles higher or lower by less than this multiple of that [-].
STEEPEST_WAY: Final[float] = 3.0
#: The other end of a bracket is looked for from this distance [m] on, in so many doublings.
NEAR_END: Final[float] = 2e-4
DOUBLINGS: Final[int] = 10


@seldom
def stand_on(tables: Tables, work: Work, index: int, lateral: float, vertical: float) -> bool:
    """Deflect the rail of a side and find its smallest gap; whether its wheel is above it."""
    deflect(work, index, lateral, vertical)
    place_both(tables, work.inputs, work.sides, work.inputs.roll)
    side = work.sides[index]
    known = follow_side(tables.pairs[index], side)
    return search_side(tables.pairs[index], side, known)


@seldom
def press_rail(tables: Tables, work: Work, index: int, height: float, lateral: float, vertical: float):
    """The side with its rail deflected: its load, and the residuals; the outcome."""
    if not stand_on(tables, work, index, lateral, vertical):
        return OFF_PROFILE
    if is_damped(tables) or is_moving(tables, work.inputs):
        open_given_motion(tables, work)
    return weigh_rail(tables, work, index, height)


@seldom
def encloses_jump(bracket: Bracket) -> bool:
    """Whether a bracket is so narrow that its values can only differ by a jump."""
    width = bracket.high - bracket.low
    return width < JUMP_WIDTH and bracket.at_low - bracket.at_high > STEEPEST_FORCE * width


@seldom
def nearer_end(bracket: Bracket):
    """The end of a bracket with the smaller value."""
    end = bracket.low
    if -bracket.at_high < bracket.at_low:
        end = bracket.high
    return end


@seldom
def half_way(i: int, fall: float, before: float):
    """1 where a bracket is to be halved: every other time ``i``, and where the values at its ends differ by
    as much as ``before``, as across a jump; else 0."""
    halved = i % 2
    if before > 0.0 and fall > LEAST_FALL * before:
        halved = 1
    return halved


@seldom
def bracket_vertical(
    tables: Tables, work: Work, index: int, height: float, lateral: float, near: float, reach: float
):
    """Let the rail of a side with this ``lateral`` deflection [m] settle vertically, within ``reach`` [m] of
    ``near`` if it does; the outcome."""
    settling = work.settling
    side = work.sides[index]
    bracket = work.height_bracket
    rest = settling.vertical_rest
    if not settling.vertical_stiffness > 0.0:
        return press_rail(tables, work, index, height, lateral, rest)
    if not stand_on(tables, work, index, lateral, rest):
        return OFF_PROFILE
    approach = height - side.best
    if not approach > GRAZING:
        return press_rail(tables, work, index, height, lateral, rest)
    bracket.high = rest + approach
    bracket.at_high = -settling.vertical_stiffness * approach
    bracket.low = max(rest, bracket.high - NOT_DEEPEST * DEEPEST)
    bracket.at_low = 0.0
    if reach < DEEPEST:
        status = narrow_beside(tables, work, index, height, lateral, near + reach)
        if status <= UNLOADED:
            status = narrow_beside(tables, work, index, height, lateral, near - reach)
        if status > UNLOADED:
            return status
    if not bracket.at_low > 0.0:
        status = press_rail(tables, work, index, height, lateral, bracket.low)
        if status > UNLOADED:
            return status
        bracket.at_low = -settling.vertical
        if not bracket.at_low > 0.0:
            return OFF_PROFILE
    fall = 0.0
    for i in range(BRACKETINGS):
        before = fall
        fall = bracket.at_low - bracket.at_high
        # a chord is no good across a jump
        vertical = next_in_bracket(bracket, half_way(i, fall, before))
        status = press_rail(tables, work, index, height, lateral, vertical)
        if status > UNLOADED:
            return status
        if fabs(settling.vertical) <= BALANCED * fabs(side.forces.force[2]):
            return status
        narrow_bracket(bracket, vertical, -settling.vertical)
        if bracket.high - bracket.low < BRACKET_SHARP or encloses_jump(bracket):
            break
    return press_rail(tables, work, index, height, lateral, nearer_end(bracket))


@seldom
def narrow_beside(tables: Tables, work: Work, index: int, height: float, lateral: float, vertical: float):
    """Let a vertical deflection be an end of the bracket if it lies within; the outcome."""
    bracket = work.height_bracket
    status = UNLOADED
    if vertical > bracket.low and vertical < bracket.high:
        status = press_rail(tables, work, index, height, lateral, vertical)
        if status <= UNLOADED:
            narrow_bracket(bracket, vertical, -work.settling.vertical)
    return status


@seldom
def bracket_rail(tables: Tables, work: Work, index: int, height: float):
    """Let the rail of a side settle; the outcome."""
    settling = work.settling
    bracket = work.roll_bracket
    deflection = work.sides[index].deflection
    lateral = settling.lateral_rest
    status = bracket_vertical(tables, work, index, height, lateral, 0.0, DEEPEST)
    if status > UNLOADED or not settling.lateral_stiffness > 0.0 or settling.lateral == 0.0:
        return status
    bracket.low = lateral
    bracket.high = lateral
    bracket.at_low = -settling.lateral
    bracket.at_high = -settling.lateral
    reach = NEAR_END
    if settling.lateral > 0.0:
        reach = -NEAR_END
    for i in range(DOUBLINGS):
        lateral = settling.lateral_rest + reach
        status = bracket_vertical(tables, work, index, height, lateral, 0.0, DEEPEST)
        if status > UNLOADED:
            return status
        narrow_bracket(bracket, lateral, -settling.lateral)
        if bracket.at_low > 0.0 and bracket.at_high <= 0.0:
            break
        reach *= 2.0
    if not (bracket.at_low > 0.0 and bracket.at_high <= 0.0):
        return NOT_CONVERGED
    fall = 0.0
    for i in range(BRACKETINGS):
        before = fall
        fall = bracket.at_low - bracket.at_high
        lateral = next_in_bracket(bracket, half_way(i, fall, before))
        near = deflection.vertical
        reach = STEEPEST_WAY * fabs(lateral - deflection.lateral) + JUMP_WIDTH
        status = bracket_vertical(tables, work, index, height, lateral, near, reach)
        if status > UNLOADED or has_settled(settling, work.sides[index], BALANCED):
            return status
        narrow_bracket(bracket, lateral, -settling.lateral)
        if bracket.high - bracket.low < BRACKET_SHARP or encloses_jump(bracket):
            break
    return bracket_vertical(tables, work, index, height, nearer_end(bracket), 0.0, DEEPEST)
