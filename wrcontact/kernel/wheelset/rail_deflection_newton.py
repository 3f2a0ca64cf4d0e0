"""Rails that settle on their springs where the contact goes far along its rail as this moves, as between tread
and flange: Newton's method with derivatives by differences, whose moves are shortened until they reduce what is
left.

The derivatives of Broyden's method begin without how the normal turns as the contact goes along.
"""

from math import fabs
from typing import Final

from ..layout import NOT_CONVERGED, UNLOADED, Tables, Work, seldom
from .rail_deflection_brackets import press_rail
from .rail_deflection_enclosing import SETTLED, let_down, residual_size, shorten_move
from .rail_deflection_slopes import find_equilibrium_of_rail, hold_rigid, update_slopes
from .springs import UNSETTLED, is_balanced

#: Moves at most, and parts of a move that are tried.
MOVES: Final[int] = 16
PARTS: Final[int] = 5
#: Each part is this share of the one before, and has to leave less than LEFT of the residuals [-].
PART: Final[float] = 0.3
LEFT: Final[float] = 0.95
#: Differences are taken over this distance [m]; a penetration is 1e-5 ... 2e-4.
DIFFERENCE: Final[float] = 1e-8
#: Derivatives that have left less than this share of the residuals are renewed by Broyden's formula [-].
GOOD: Final[float] = 0.05


@seldom
def approach_balance(tables: Tables, work: Work, index: int, height: float):
    """Let the rail of a side settle from where it stands; the status, NOT_CONVERGED where no part of a move
    reduces what is left."""
    equilibrium = work.equilibrium
    side = work.sides[index]
    deflection = side.deflection
    status = press_rail(tables, work, index, height, deflection.lateral, deflection.vertical)
    if status > UNLOADED:
        status = let_down(tables, work, index, height)
    good = False
    for i in range(MOVES):
        if status > UNLOADED:
            return NOT_CONVERGED
        lateral = deflection.lateral
        vertical = deflection.vertical
        if not good and not difference_slopes(tables, work, index, height):
            return NOT_CONVERGED
        if not find_equilibrium_of_rail(tables, work, index, height):
            return NOT_CONVERGED
        if fabs(equilibrium.move_lateral) < SETTLED and fabs(equilibrium.move_vertical) < SETTLED:
            status = press_rail(tables, work, index, height, lateral, vertical)
            if status > UNLOADED or not is_balanced(equilibrium, side, UNSETTLED):
                return NOT_CONVERGED
            return status
        shorten_move(equilibrium)
        left_lateral = equilibrium.lateral
        left_vertical = equilibrium.vertical
        size = residual_size(equilibrium)
        status = move_part(tables, work, index, height, lateral, vertical)
        good = status <= UNLOADED and residual_size(equilibrium) < GOOD * size
        if good:
            update_slopes(equilibrium, left_lateral, left_vertical)
    return NOT_CONVERGED


@seldom
def move_part(tables: Tables, work: Work, index: int, height: float, lateral: float, vertical: float):
    """Move the rail from ``lateral`` and ``vertical`` [m], and less far until this reduces the residuals; the
    status."""
    equilibrium = work.equilibrium
    size = residual_size(equilibrium)
    for i in range(PARTS):
        status = press_rail(
            tables,
            work,
            index,
            height,
            lateral + equilibrium.move_lateral,
            vertical + equilibrium.move_vertical,
        )
        if status <= UNLOADED and residual_size(equilibrium) < LEFT * size:
            return status
        equilibrium.move_lateral *= PART
        equilibrium.move_vertical *= PART
    return NOT_CONVERGED


@seldom
def difference_slopes(tables: Tables, work: Work, index: int, height: float) -> bool:
    """The residuals' derivatives by both deflections, by differences; whether the contact is known there."""
    equilibrium = work.equilibrium
    slopes = equilibrium.slopes
    deflection = work.sides[index].deflection
    lateral = deflection.lateral
    vertical = deflection.vertical
    left_lateral = equilibrium.lateral
    left_vertical = equilibrium.vertical
    found = True
    if equilibrium.lateral_stiffness > 0.0:
        status = press_rail(tables, work, index, height, lateral + DIFFERENCE, vertical)
        found = status <= UNLOADED
        slopes.lateral_lateral = (equilibrium.lateral - left_lateral) / DIFFERENCE
        slopes.vertical_lateral = (equilibrium.vertical - left_vertical) / DIFFERENCE
    if equilibrium.vertical_stiffness > 0.0:
        status = press_rail(tables, work, index, height, lateral, vertical + DIFFERENCE)
        found = found and status <= UNLOADED
        slopes.lateral_vertical = (equilibrium.lateral - left_lateral) / DIFFERENCE
        slopes.vertical_vertical = (equilibrium.vertical - left_vertical) / DIFFERENCE
    hold_rigid(equilibrium)
    equilibrium.lateral = left_lateral
    equilibrium.vertical = left_vertical
    return found
