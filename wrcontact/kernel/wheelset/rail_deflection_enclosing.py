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

from ..layout import NOT_CONVERGED, UNLOADED, TriedDeflection, RailEquilibrium, Tables, Work, copy, seldom
from .rail_deflection_brackets import press_rail, stand_on
from .rail_deflection_slopes import begin_slopes, find_equilibrium_of_rail
from .springs import UNSETTLED, is_balanced

#: A rail has settled when it moves by less [m].
SETTLED: Final[float] = 2e-14
#: Longest move of a rail in one trial [m].
LONGEST_MOVE: Final[float] = 5e-4
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
    """Let the rail of a side settle from where it stands; the status, NOT_CONVERGED where nothing is
    found."""
    equilibrium = work.equilibrium
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
        if not find_equilibrium_of_rail(tables, work, index, height):
            return NOT_CONVERGED
        if fabs(equilibrium.move_lateral) < SETTLED and fabs(equilibrium.move_vertical) < SETTLED:
            if is_balanced(equilibrium, work.sides[index], UNSETTLED):
                return status
        shorten_move(equilibrium)
        places = note_equilibrium(equilibrium, deflection.lateral, deflection.vertical, places)
        size = residual_size(equilibrium)
        reduced = size < REDUCED * before
        before = size
        if places == 2:
            if trial % CLOSING == CLOSING - 1:
                apart = places_apart(equilibrium)
                if span > 0.0 and not apart < CLOSER * span:
                    return NOT_CONVERGED
                span = apart
            if not move_between(tables, work, index, height, reduced):
                return NOT_CONVERGED
            if is_at_jump(equilibrium, deflection.lateral, deflection.vertical):
                return stand_nearer(tables, work, index, height)
        status = move_rail(tables, work, index, height)
        if status > UNLOADED:
            return NOT_CONVERGED
    return NOT_CONVERGED


@seldom
def shorten_move(equilibrium: RailEquilibrium):
    """Let the move be no longer than is permitted, in its direction."""
    longest = max(fabs(equilibrium.move_lateral), fabs(equilibrium.move_vertical))
    if longest > LONGEST_MOVE:
        equilibrium.move_lateral *= LONGEST_MOVE / longest
        equilibrium.move_vertical *= LONGEST_MOVE / longest


@seldom
def let_down(tables: Tables, work: Work, index: int, height: float):
    """Let the rail down until the wheel just touches it; the status."""
    equilibrium = work.equilibrium
    vertical = equilibrium.vertical_rest
    if equilibrium.vertical_stiffness > 0.0 and stand_on(
        tables, work, index, equilibrium.lateral_rest, vertical
    ):
        vertical += max(height - work.sides[index].best, 0.0)
    return press_rail(tables, work, index, height, equilibrium.lateral_rest, vertical)


@seldom
def scaled(stiffness: float, residual: float):
    """A residual as a deflection of its spring [m]."""
    if stiffness > 0.0:
        residual = residual / stiffness
    return residual


@seldom
def residual_size(equilibrium: RailEquilibrium):
    """The last residuals as deflections of their springs [m]."""
    return fabs(scaled(equilibrium.lateral_stiffness, equilibrium.lateral)) + fabs(
        scaled(equilibrium.vertical_stiffness, equilibrium.vertical)
    )


@seldom
def keep_deflection(equilibrium: RailEquilibrium, place: TriedDeflection, lateral: float, vertical: float):
    """Keep the deflection of the last trial and its residuals."""
    place.lateral = lateral
    place.vertical = vertical
    place.residual_lateral = equilibrium.lateral
    place.residual_vertical = equilibrium.vertical


@seldom
def distance_to(equilibrium: RailEquilibrium, place: TriedDeflection):
    """How far the last residuals are from those of a place, as deflections [m]."""
    return fabs(scaled(equilibrium.lateral_stiffness, equilibrium.lateral - place.residual_lateral)) + fabs(
        scaled(equilibrium.vertical_stiffness, equilibrium.vertical - place.residual_vertical)
    )


@seldom
def note_equilibrium(equilibrium: RailEquilibrium, lateral: float, vertical: float, places: int):
    """Let the deflection of the last trial be one of the two; how many of them are known."""
    one = equilibrium.one
    if places == 2:
        if distance_to(equilibrium, one) < distance_to(equilibrium, equilibrium.other):
            keep_deflection(equilibrium, one, lateral, vertical)
        else:
            keep_deflection(equilibrium, equilibrium.other, lateral, vertical)
        return 2
    if places == 1:
        way_lateral = lateral - one.lateral
        way_vertical = vertical - one.vertical
        there = equilibrium.away_lateral * way_lateral + equilibrium.away_vertical * way_vertical
        back = equilibrium.move_lateral * way_lateral + equilibrium.move_vertical * way_vertical
        if there > 0.0 and back < 0.0:
            keep_deflection(equilibrium, equilibrium.other, lateral, vertical)
            return 2
    keep_deflection(equilibrium, one, lateral, vertical)
    equilibrium.away_lateral = equilibrium.move_lateral
    equilibrium.away_vertical = equilibrium.move_vertical
    return 1


@seldom
def move_between(tables: Tables, work: Work, index: int, height: float, reduced: bool) -> bool:
    """The move from the last trial to the next place between both, which is that of the share of their forces
    if the last trial has ``reduced`` the residuals, else half way; whether there is one."""
    equilibrium = work.equilibrium
    deflection = work.sides[index].deflection
    one = equilibrium.one
    other = equilibrium.other
    lateral = scaled(equilibrium.lateral_stiffness, one.residual_lateral)
    vertical = scaled(equilibrium.vertical_stiffness, one.residual_vertical)
    across = scaled(equilibrium.lateral_stiffness, other.residual_lateral) - lateral
    down = scaled(equilibrium.vertical_stiffness, other.residual_vertical) - vertical
    size = across * across + down * down
    share = 0.5
    if size > 0.0:
        share = min(max(-(lateral * across + vertical * down) / size, 0.0), 1.0)
    equilibrium.lateral = one.residual_lateral + share * (other.residual_lateral - one.residual_lateral)
    equilibrium.vertical = one.residual_vertical + share * (other.residual_vertical - one.residual_vertical)
    if not find_equilibrium_of_rail(tables, work, index, height):
        return False
    if not reduced:
        share = 0.5
    equilibrium.move_lateral += one.lateral + share * (other.lateral - one.lateral) - deflection.lateral
    equilibrium.move_vertical += one.vertical + share * (other.vertical - one.vertical) - deflection.vertical
    shorten_move(equilibrium)
    return True


@seldom
def places_apart(equilibrium: RailEquilibrium):
    """How far both places are from each other [m]."""
    one = equilibrium.one
    other = equilibrium.other
    return fabs(other.lateral - one.lateral) + fabs(other.vertical - one.vertical)


@seldom
def is_at_jump(equilibrium: RailEquilibrium, lateral: float, vertical: float) -> bool:
    """Whether both places, and the next one, are the same but for a jump."""
    one = equilibrium.one
    other = equilibrium.other
    apart = places_apart(equilibrium)
    move = fabs(equilibrium.move_lateral) + fabs(equilibrium.move_vertical)
    jump = fabs(scaled(equilibrium.lateral_stiffness, other.residual_lateral - one.residual_lateral)) + fabs(
        scaled(equilibrium.vertical_stiffness, other.residual_vertical - one.residual_vertical)
    )
    return apart < JUMP_SHARP and move < JUMP_SHARP and jump > STEEPEST * apart


@seldom
def stand_nearer(tables: Tables, work: Work, index: int, height: float):
    """Stand on the side of a jump on which the wheel's force is nearer to that of the springs; the
    status."""
    equilibrium = work.equilibrium
    one = equilibrium.one
    other = equilibrium.other
    equilibrium.lateral = 0.0
    equilibrium.vertical = 0.0
    if distance_to(equilibrium, other) < distance_to(equilibrium, one):
        copy(other, one)
    return press_rail(tables, work, index, height, one.lateral, one.vertical)


@seldom
def move_rail(tables: Tables, work: Work, index: int, height: float):
    """Move the rail, less far where its wheel would stand too deep; the status."""
    equilibrium = work.equilibrium
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
            lateral + share * equilibrium.move_lateral,
            vertical + share * equilibrium.move_vertical,
        )
        if status <= UNLOADED:
            return status
        share *= 0.5
    return status
