"""Rails that settle on their springs, by brackets in brackets: slow, for places where a region comes or goes
and Broyden's method finds nothing.

The vertical force falls as the rail comes down.  So for each lateral deflection a bracket finds the vertical
one; the lateral residual there changes its sign between the rail at rest and the deflection that the lateral
force at rest would give.  Where a force jumps past what the springs carry, the end of the bracket is taken at
which it is nearer to that.
"""

from math import fabs
from typing import Final

from ..layout import (
    NOT_CONVERGED,
    OFF_PROFILE,
    UNLOADED,
    VALID,
    Bracket,
    RailEquilibrium,
    SideSearch,
    Tables,
    Work,
    seldom,
)
from ..search.roll import follow_side, place_both
from ..search.smallest_gap import search_side
from .prescribed_height import GRAZING, is_damped
from .brackets import (
    BRACKET_SHARP,
    BRACKETINGS,
    is_within,
    narrow_bracket,
    next_in_bracket,
    open_bracket,
)
from .input_checks import is_moving
from .rolling_contact import open_given_motion
from .rail_deflection_slopes import GROWTH
from .springs import deflect, is_balanced, weigh_rail
from .residuals import DEEPEST

#: A wheel is pressed no deeper than this share of DEEPEST while its rail is let down [-].
NOT_DEEPEST: Final[float] = 0.999
#: A rail has settled if its springs carry what the wheel presses but for this share of it [-].
BALANCED: Final[float] = 1e-12
#: A force that falls by more than this in a bracket so narrow jumps there [N/m, m]; contacts have 3e9 N/m.
STEEPEST_FORCE: Final[float] = 1e11
JUMP_WIDTH: Final[float] = 1e-8
#: A first guess of the stiffness of a contact [N/m].
CONTACT_STIFFNESS: Final[float] = 1e9
#: A force that falls by more than this in a bracket may jump there [N/m].
STEEPEST_CONTACT: Final[float] = 1e10
#: A rail that is displaced settles higher or lower by less than this multiple of that [-].
STEEPEST_WAY: Final[float] = 6.0
#: The last move corrects a slope by a factor between this and its inverse [-].
SLOPE_FACTOR: Final[float] = 0.5
#: A step that has not reduced the residual by this factor is followed by a halving [-].
REDUCED: Final[float] = 0.5
#: Where no deflection is known at which the wheel presses too much, a slow step is followed by one that is
#: longer by this factor [-].
LONGER: Final[float] = 3.0
#: A rail is level when Newton's method moves it by less [m].
LEVEL_SHARP: Final[float] = 2e-14
#: A vertical residual of this share of the lateral one leaves its sign as it is, and itself but for so much
#: times the slope of a flange [-].
SMALL_SHARE: Final[float] = 1e-3
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
    """The side with its rail deflected: its load, and the residuals; the status."""
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
def vertical_slope(tables: Tables, work: Work, index: int):
    """How what the springs carry more than the wheel presses follows the vertical deflection [N/m], from the
    springs, and from patches whose forces grow as Hertz's along their normals."""
    slope = work.equilibrium.vertical_stiffness
    side = work.sides[index]
    for number in range(side.patch_count):
        patch = side.patches[number]
        if patch.totals.load > 0.0 and patch.penetration > 0.0:
            share = GROWTH * patch.normal_z / (patch.totals.load * patch.penetration)
            slope += share * patch.forces.force[2]
    return slope


@seldom
def corrected_slope(slope: float, change: float, move: float):
    """A slope, by which the last ``move`` changes the residual by as much as it has, if that is near."""
    if move != 0.0:
        factor = change / (slope * move)
        if factor > SLOPE_FACTOR and factor * SLOPE_FACTOR < 1.0:
            slope *= factor
    return slope


@seldom
def bracket_vertical(
    tables: Tables, work: Work, index: int, height: float, lateral: float, exact: bool, reach: float
):
    """Let the rail of a side with this ``lateral`` deflection [m] settle vertically, by Newton's method from
    where it stands, within a bracket that is halved where a step has not halved the residual; the status.

    exact : else the vertical residual that is left, or what the width of a jump leaves open, is small against
        the lateral residual.
    reach : where it stands is at a jump, and so it is within this distance [m] if it does.
    """
    equilibrium = work.equilibrium
    bracket = work.height_bracket
    near = work.sides[index].deflection.vertical
    status = open_vertical(tables, work, index, height, lateral)
    if status != VALID:
        return status
    lowest = bracket.low
    vertical = near
    if not is_within(bracket, near):
        stiffness = equilibrium.vertical_stiffness
        touching = bracket.high - equilibrium.vertical_rest
        vertical = max(bracket.high - touching * stiffness / (stiffness + CONTACT_STIFFNESS), lowest)
    if reach > 0.0:
        status = narrow_beside(tables, work, index, height, lateral, near + reach)
        if status <= UNLOADED:
            status = narrow_beside(tables, work, index, height, lateral, near - reach)
        if status > UNLOADED:
            return status
    before = 0.0
    move = 0.0
    width = 0.0
    for i in range(BRACKETINGS):
        status = press_rail(tables, work, index, height, lateral, vertical)
        if status > UNLOADED or is_level(equilibrium, work.sides[index], exact):
            return status
        residual = equilibrium.vertical
        if vertical == lowest and residual >= 0.0:
            return OFF_PROFILE
        narrow_bracket(bracket, vertical, -residual)
        enclosed = bracket.at_low > 0.0
        if enclosed and is_narrow(bracket, vertical, fabs(equilibrium.lateral), exact):
            break
        slope = corrected_slope(vertical_slope(tables, work, index), residual - before, move)
        following = vertical - residual / slope
        if fabs(following - vertical) < LEVEL_SHARP:
            return status
        slow = i > 0 and fabs(residual) > REDUCED * fabs(before)
        if not enclosed:
            if slow and residual > 0.0:
                following = min(following, vertical - LONGER * fabs(move))
            following = max(following, lowest)
        elif slow or not is_within(bracket, following):
            following = next_in_bracket(bracket, int(bracket.high - bracket.low > REDUCED * width))
        width = bracket.high - bracket.low
        before = residual
        move = following - vertical
        vertical = following
    if vertical != nearer_end(bracket):
        status = press_rail(tables, work, index, height, lateral, nearer_end(bracket))
    return status


@seldom
def open_vertical(tables: Tables, work: Work, index: int, height: float, lateral: float):
    """Bracket the vertical deflection of a rail with this ``lateral`` one [m]: from where its wheel just
    touches it down to where it is deepest; VALID, or the status if no vertical one is sought."""
    equilibrium = work.equilibrium
    bracket = work.height_bracket
    rest = equilibrium.vertical_rest
    open_bracket(bracket, rest, 0.0)
    approach = 0.0
    if equilibrium.vertical_stiffness > 0.0:
        if not stand_on(tables, work, index, lateral, rest):
            return OFF_PROFILE
        approach = height - work.sides[index].best
    if not approach > GRAZING:
        return max(press_rail(tables, work, index, height, lateral, rest), UNLOADED)
    bracket.high = rest + approach
    bracket.at_high = -equilibrium.vertical_stiffness * approach
    bracket.low = max(rest, bracket.high - NOT_DEEPEST * DEEPEST)
    return VALID


@seldom
def is_level(equilibrium: RailEquilibrium, side: SideSearch, exact: bool) -> bool:
    """Whether the vertical residual is small: against the force, or, if it is not to be ``exact``, against the
    lateral residual."""
    limit = BALANCED * fabs(side.forces.force[2])
    if not exact:
        limit = max(limit, SMALL_SHARE * fabs(equilibrium.lateral))
    return fabs(equilibrium.vertical) <= limit


@seldom
def is_narrow(bracket: Bracket, vertical: float, lateral: float, exact: bool) -> bool:
    """Whether a bracket need not become narrower, one end of which is ``vertical`` [m], with the size of the
    residual ``lateral`` [N] there."""
    width = bracket.high - bracket.low
    if width < BRACKET_SHARP or encloses_jump(bracket):
        return True
    return (
        not exact
        and vertical == nearer_end(bracket)
        and bracket.at_low - bracket.at_high > STEEPEST_CONTACT * width
        and lateral > STEEPEST_CONTACT * width
    )


@seldom
def ends_at_jump(bracket: Bracket) -> bool:
    """Whether the last bracket of a vertical deflection encloses a jump."""
    width = bracket.high - bracket.low
    return bracket.at_low > 0.0 and bracket.at_low - bracket.at_high > STEEPEST_CONTACT * width


@seldom
def narrow_beside(tables: Tables, work: Work, index: int, height: float, lateral: float, vertical: float):
    """Let a vertical deflection be an end of the bracket if it lies within; the status."""
    bracket = work.height_bracket
    status = UNLOADED
    if is_within(bracket, vertical):
        status = press_rail(tables, work, index, height, lateral, vertical)
        if status <= UNLOADED:
            narrow_bracket(bracket, vertical, -work.equilibrium.vertical)
    return status


@seldom
def bracket_rail(tables: Tables, work: Work, index: int, height: float):
    """Let the rail of a side settle; the status."""
    equilibrium = work.equilibrium
    bracket = work.roll_bracket
    lateral = equilibrium.lateral_rest
    sideways = equilibrium.lateral_stiffness > 0.0
    status = bracket_vertical(tables, work, index, height, lateral, not sideways, 0.0)
    if status > UNLOADED or not sideways or equilibrium.lateral == 0.0:
        return status
    open_bracket(bracket, lateral, -equilibrium.lateral)
    reach = NEAR_END
    if equilibrium.lateral > 0.0:
        reach = -NEAR_END
    for i in range(DOUBLINGS):
        lateral = equilibrium.lateral_rest + reach
        status = bracket_vertical(tables, work, index, height, lateral, False, 0.0)
        if status > UNLOADED:
            return status
        narrow_bracket(bracket, lateral, -equilibrium.lateral)
        if bracket.at_low > 0.0 and bracket.at_high <= 0.0:
            break
        reach *= 2.0
    if not (bracket.at_low > 0.0 and bracket.at_high <= 0.0):
        return NOT_CONVERGED
    return narrow_lateral(tables, work, index, height)


@seldom
def narrow_lateral(tables: Tables, work: Work, index: int, height: float):
    """Let the rail of a side settle within the bracket of its lateral deflection; the status."""
    equilibrium = work.equilibrium
    bracket = work.roll_bracket
    deflection = work.sides[index].deflection
    width = bracket.high - bracket.low
    shrunk = False
    lateral = next_in_bracket(bracket, 0)
    before = 0.0
    place = lateral
    for i in range(BRACKETINGS):
        reach = 0.0
        if ends_at_jump(work.height_bracket):
            reach = STEEPEST_WAY * fabs(lateral - deflection.lateral) + JUMP_WIDTH
        status = bracket_vertical(tables, work, index, height, lateral, False, reach)
        if status > UNLOADED or is_balanced(equilibrium, work.sides[index], BALANCED):
            return status
        residual = equilibrium.lateral
        narrow_bracket(bracket, lateral, -residual)
        shrunk = bracket.high - bracket.low < REDUCED * width
        width = bracket.high - bracket.low
        jumping = width < JUMP_WIDTH and ends_at_jump(work.height_bracket)
        if jumping or width < BRACKET_SHARP or encloses_jump(bracket):
            break
        following = next_in_bracket(bracket, int(not shrunk))
        if i > 0 and fabs(residual) < REDUCED * fabs(before):
            secant = lateral - residual * (lateral - place) / (residual - before)
            if is_within(bracket, secant):
                following = secant
        place = lateral
        before = residual
        lateral = following
    reach = 0.0
    if ends_at_jump(work.height_bracket):
        reach = (STEEPEST_WAY + 1.0) * JUMP_WIDTH
    return bracket_vertical(tables, work, index, height, nearer_end(bracket), True, reach)
