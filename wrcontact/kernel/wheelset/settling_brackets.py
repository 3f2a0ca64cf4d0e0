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
def nearer_end(bracket: Bracket):
    """The end of a bracket with the smaller value."""
    end = bracket.low
    if -bracket.at_high < bracket.at_low:
        end = bracket.high
    return end


@seldom
def bracket_vertical(tables: Tables, work: Work, index: int, height: float, lateral: float):
    """Let the rail of a side with this ``lateral`` deflection [m] settle vertically; the outcome."""
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
    status = press_rail(tables, work, index, height, lateral, bracket.low)
    if status > UNLOADED:
        return status
    bracket.at_low = -settling.vertical
    if not bracket.at_low > 0.0:
        return OFF_PROFILE
    for i in range(BRACKETINGS):
        vertical = next_in_bracket(bracket, i)
        status = press_rail(tables, work, index, height, lateral, vertical)
        if status > UNLOADED:
            return status
        if fabs(settling.vertical) <= BALANCED * fabs(side.forces.force[2]):
            return status
        narrow_bracket(bracket, vertical, -settling.vertical)
        if bracket.high - bracket.low < BRACKET_SHARP:
            break
    return press_rail(tables, work, index, height, lateral, nearer_end(bracket))


@seldom
def bracket_rail(tables: Tables, work: Work, index: int, height: float):
    """Let the rail of a side settle; the outcome."""
    settling = work.settling
    bracket = work.roll_bracket
    lateral = settling.lateral_rest
    status = bracket_vertical(tables, work, index, height, lateral)
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
        status = bracket_vertical(tables, work, index, height, lateral)
        if status > UNLOADED:
            return status
        narrow_bracket(bracket, lateral, -settling.lateral)
        if bracket.at_low > 0.0 and bracket.at_high <= 0.0:
            break
        reach *= 2.0
    if not (bracket.at_low > 0.0 and bracket.at_high <= 0.0):
        return NOT_CONVERGED
    for i in range(BRACKETINGS):
        lateral = next_in_bracket(bracket, i)
        status = bracket_vertical(tables, work, index, height, lateral)
        if status > UNLOADED or has_settled(settling, work.sides[index], BALANCED):
            return status
        narrow_bracket(bracket, lateral, -settling.lateral)
        if bracket.high - bracket.low < BRACKET_SHARP:
            break
    return bracket_vertical(tables, work, index, height, nearer_end(bracket))
