"""Rails that settle on their springs where Broyden's method finds nothing: between two deflections from which
Newton's moves lead towards each other.

What springs carry more than the wheel presses rises with the deflection, but it may jump where a region comes
or goes. Then no deflection is in balance. Between both sides of a jump a share of each force balances the
springs but for a rest; the next place is half way between them, moved by what lets this rest vanish. It
becomes the one of both to whose residual its own is nearer. Where residuals are smooth, the share itself is
the place.
"""

from math import fabs
from typing import Final

from ..layout import NOT_CONVERGED, UNLOADED, Settled, Settling, Tables, Work, copy, seldom
from .settling_brackets import press_rail, stand_on
from .settling_slopes import begin_slopes, find_settling
from .springs import UNSETTLED, has_settled

#: A rail has settled when it moves by less [m].
SETTLED: Final[float] = 2e-14
#: Longest move of a rail in one trial [m].
LONGEST_SETTLING: Final[float] = 5e-4
#: Trials at most, and halvings of a move to where the wheel stands too deep.
ENCLOSINGS: Final[int] = 28
RETREATS: Final[int] = 12
#: After each so many trials the two deflections have to be this much nearer to each other [-].
CLOSING: Final[int] = 6
CLOSER: Final[float] = 0.25
#: Both sides of a jump are this near [m].
JUMP_SHARP: Final[float] = 1e-10
#: and their residuals differ by more than this multiple of the distance, as deflections of the springs [-].
STEEPEST: Final[float] = 1e4
#: A trial that has not reduced the residuals by this factor is followed by a halving [-].
REDUCED: Final[float] = 0.5


@seldom
def enclose_deflection(tables: Tables, work: Work, index: int, height: float):
    """Let the rail of a side settle from where it stands; the outcome, NOT_CONVERGED where nothing is
    found."""
    settling = work.settling
    deflection = work.sides[index].deflection
    status = press_rail(tables, work, index, height, deflection.lateral, deflection.vertical)
    if status > UNLOADED:
        status = let_down(tables, work, index, height)
    if status > UNLOADED:
        return NOT_CONVERGED
    places = 0
    before = 0.0
    span = 0.0
    for trial in range(ENCLOSINGS):
        begin_slopes(tables, work, index, height)
        if not find_settling(tables, work, index, height):
            return NOT_CONVERGED
        if fabs(settling.move_lateral) < SETTLED and fabs(settling.move_vertical) < SETTLED:
            if has_settled(settling, work.sides[index], UNSETTLED):
                return status
        shorten_settling(settling)
        places = note_settling(settling, deflection.lateral, deflection.vertical, places)
        size = residual_size(settling)
        reduced = size < REDUCED * before
        before = size
        if places == 2:
            if trial % CLOSING == CLOSING - 1:
                apart = places_apart(settling)
                if span > 0.0 and not apart < CLOSER * span:
                    return NOT_CONVERGED
                span = apart
            if not move_between(tables, work, index, height, reduced):
                return NOT_CONVERGED
            if is_at_jump(settling, deflection.lateral, deflection.vertical):
                return stand_nearer(tables, work, index, height)
        status = move_rail(tables, work, index, height)
        if status > UNLOADED:
            return NOT_CONVERGED
    return NOT_CONVERGED


@seldom
def shorten_settling(settling: Settling):
    """Let the move be no longer than is permitted, in its direction."""
    longest = max(fabs(settling.move_lateral), fabs(settling.move_vertical))
    if longest > LONGEST_SETTLING:
        settling.move_lateral *= LONGEST_SETTLING / longest
        settling.move_vertical *= LONGEST_SETTLING / longest


@seldom
def let_down(tables: Tables, work: Work, index: int, height: float):
    """Let the rail down until the wheel just touches it; the outcome."""
    settling = work.settling
    vertical = settling.vertical_rest
    if settling.vertical_stiffness > 0.0 and stand_on(tables, work, index, settling.lateral_rest, vertical):
        vertical += max(height - work.sides[index].best, 0.0)
    return press_rail(tables, work, index, height, settling.lateral_rest, vertical)


@seldom
def scaled(stiffness: float, residual: float):
    """A residual as a deflection of its spring [m]."""
    if stiffness > 0.0:
        residual = residual / stiffness
    return residual


@seldom
def residual_size(settling: Settling):
    """The last residuals as deflections of their springs [m]."""
    return fabs(scaled(settling.lateral_stiffness, settling.lateral)) + fabs(
        scaled(settling.vertical_stiffness, settling.vertical)
    )


@seldom
def keep_settled(settling: Settling, place: Settled, lateral: float, vertical: float):
    """Keep the deflection of the last trial and its residuals."""
    place.lateral = lateral
    place.vertical = vertical
    place.residual_lateral = settling.lateral
    place.residual_vertical = settling.vertical


@seldom
def distance_to(settling: Settling, place: Settled):
    """How far the last residuals are from those of a place, as deflections [m]."""
    return fabs(scaled(settling.lateral_stiffness, settling.lateral - place.residual_lateral)) + fabs(
        scaled(settling.vertical_stiffness, settling.vertical - place.residual_vertical)
    )


@seldom
def note_settling(settling: Settling, lateral: float, vertical: float, places: int):
    """Let the deflection of the last trial be one of the two; how many of them are known."""
    one = settling.one
    if places == 2:
        if distance_to(settling, one) < distance_to(settling, settling.other):
            keep_settled(settling, one, lateral, vertical)
        else:
            keep_settled(settling, settling.other, lateral, vertical)
        return 2
    if places == 1:
        way_lateral = lateral - one.lateral
        way_vertical = vertical - one.vertical
        there = settling.away_lateral * way_lateral + settling.away_vertical * way_vertical
        back = settling.move_lateral * way_lateral + settling.move_vertical * way_vertical
        if there > 0.0 and back < 0.0:
            keep_settled(settling, settling.other, lateral, vertical)
            return 2
    keep_settled(settling, one, lateral, vertical)
    settling.away_lateral = settling.move_lateral
    settling.away_vertical = settling.move_vertical
    return 1


@seldom
def move_between(tables: Tables, work: Work, index: int, height: float, reduced: bool) -> bool:
    """The move from the last trial to the next place between both, which is that of the share of their forces
    if the last trial has ``reduced`` the residuals, else half way; whether there is one."""
    settling = work.settling
    deflection = work.sides[index].deflection
    one = settling.one
    other = settling.other
    lateral = scaled(settling.lateral_stiffness, one.residual_lateral)
    vertical = scaled(settling.vertical_stiffness, one.residual_vertical)
    across = scaled(settling.lateral_stiffness, other.residual_lateral) - lateral
    down = scaled(settling.vertical_stiffness, other.residual_vertical) - vertical
    size = across * across + down * down
    share = 0.5
    if size > 0.0:
        share = min(max(-(lateral * across + vertical * down) / size, 0.0), 1.0)
    settling.lateral = one.residual_lateral + share * (other.residual_lateral - one.residual_lateral)
    settling.vertical = one.residual_vertical + share * (other.residual_vertical - one.residual_vertical)
    if not find_settling(tables, work, index, height):
        return False
    if not reduced:
        share = 0.5
    settling.move_lateral += one.lateral + share * (other.lateral - one.lateral) - deflection.lateral
    settling.move_vertical += one.vertical + share * (other.vertical - one.vertical) - deflection.vertical
    shorten_settling(settling)
    return True


@seldom
def places_apart(settling: Settling):
    """How far both places are from each other [m]."""
    one = settling.one
    other = settling.other
    return fabs(other.lateral - one.lateral) + fabs(other.vertical - one.vertical)


@seldom
def is_at_jump(settling: Settling, lateral: float, vertical: float) -> bool:
    """Whether both places, and the next one, are the same but for a jump."""
    one = settling.one
    other = settling.other
    apart = places_apart(settling)
    move = fabs(settling.move_lateral) + fabs(settling.move_vertical)
    jump = fabs(scaled(settling.lateral_stiffness, other.residual_lateral - one.residual_lateral)) + fabs(
        scaled(settling.vertical_stiffness, other.residual_vertical - one.residual_vertical)
    )
    return apart < JUMP_SHARP and move < JUMP_SHARP and jump > STEEPEST * apart


@seldom
def stand_nearer(tables: Tables, work: Work, index: int, height: float):
    """Stand on the side of a jump on which the wheel's force is nearer to that of the springs; the
    outcome."""
    settling = work.settling
    one = settling.one
    other = settling.other
    settling.lateral = 0.0
    settling.vertical = 0.0
    if distance_to(settling, other) < distance_to(settling, one):
        copy(other, one)
    return press_rail(tables, work, index, height, one.lateral, one.vertical)


@seldom
def move_rail(tables: Tables, work: Work, index: int, height: float):
    """Move the rail, less far where its wheel would stand too deep; the outcome."""
    settling = work.settling
    deflection = work.sides[index].deflection
    lateral = deflection.lateral
    vertical = deflection.vertical
    status = NOT_CONVERGED
    share = 1.0
    for i in range(RETREATS):
        status = press_rail(
            tables,
            work,
            index,
            height,
            lateral + share * settling.move_lateral,
            vertical + share * settling.move_vertical,
        )
        if status <= UNLOADED:
            return status
        share *= 0.5
    return status
