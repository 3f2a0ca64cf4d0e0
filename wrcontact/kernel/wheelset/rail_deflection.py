"""Equilibrium of a rail on springs with the forces of its wheel: both deflections of a side by
Broyden's method (Broyden 1965), from an estimate for one contact place; where it finds nothing, by brackets
(rail_deflection_brackets.py)."""

from math import fabs
from typing import Final

from ..elementary.circle import sine_cosine
from ..elementary.powers import cube_root
from ..layout import NOT_CONVERGED, UNLOADED, Tables, Work, copy, seldom
from ..normal.estimate import first_penetration
from .prescribed_height import GRAZING
from .rail_deflection_brackets import bracket_rail, press_rail, stand_on
from .rail_deflection_enclosing import SETTLED, enclose_deflection, shorten_move
from .rail_deflection_newton import approach_balance
from .rail_deflection_slopes import begin_slopes, find_equilibrium_of_rail, update_slopes
from .side import touch_side
from .springs import UNSETTLED, is_balanced, open_equilibrium

#: Places at which one contact is estimated, and how near two of them are [m].
ESTIMATES: Final[int] = 5
SAME_PLACE: Final[float] = 1e-5
#: Newton's steps for the force of the estimate, from above.
FORCE_STEPS: Final[int] = 12
#: Broyden's method needs seven trials; what it has not found after so many, it seldom will.
DEFLECTION_TRIALS: Final[int] = 14
#: The same where the rail has settled with nearly the same forces.
AGAIN_TRIALS: Final[int] = 8
#: and when it moves by less [m]: what each rate leaves open is by chance, and shows in differences of forces.
AGAIN_SHARP: Final[float] = 1e-15


@seldom
def equilibrate_rail(tables: Tables, work: Work, index: int, height: float):
    """Let the rail of a side settle under its wheel at ``height`` [m], from the rail at rest on, whose
    smallest gap is known; the status."""
    open_equilibrium(tables, work, index)
    side = work.sides[index]
    work.settled[index].lifted = not height - side.best > GRAZING
    if work.settled[index].lifted:
        return touch_side(tables, work, index)
    status = NOT_CONVERGED
    if estimate_deflection(tables, work, index, height):
        status = iterate_deflection(
            tables, work, index, height, side.deflection.lateral, side.deflection.vertical, DEFLECTION_TRIALS
        )
    if status > UNLOADED:
        status = approach_balance(tables, work, index, height)
    if status > UNLOADED:
        status = enclose_deflection(tables, work, index, height)
    if status > UNLOADED:
        status = bracket_rail(tables, work, index, height)
    keep_slopes(work, index)
    return status


@seldom
def keep_slopes(work: Work, index: int):
    """Keep how a rail that has settled follows its forces, and whether they balance."""
    equilibrium = work.equilibrium
    settled = work.settled[index]
    settled.standing = not is_balanced(equilibrium, work.sides[index], UNSETTLED)
    copy(equilibrium.slopes, settled.slopes)


@seldom
def equilibrate_again(tables: Tables, work: Work, index: int, height: float):
    """Let the rail of a side settle from where it has settled in this step, since its wheel turns at another
    rate; the status, NOT_CONVERGED where it has to settle from rest on.

    A rail that stands at a jump of the forces stays there (``leave_jumps``).
    """
    equilibrium = work.equilibrium
    settled = work.settled[index]
    deflection = work.sides[index].deflection
    open_equilibrium(tables, work, index)
    if settled.lifted:
        return UNLOADED
    if settled.standing:
        return press_rail(tables, work, index, height, deflection.lateral, deflection.vertical)
    copy(settled.slopes, equilibrium.slopes)
    status = iterate_deflection(
        tables, work, index, height, deflection.lateral, deflection.vertical, AGAIN_TRIALS
    )
    if status <= UNLOADED:
        keep_slopes(work, index)
    return status


@seldom
def estimate_deflection(tables: Tables, work: Work, index: int, height: float) -> bool:
    """Deflect the rail as one contact would, at the place of the smallest gap; whether there is one.

    The place moves with the rail: between two places that take turns, as on flange and tread, lateral
    deflections are halved, and at last the vertical one is found for that.
    """
    side = work.sides[index]
    for i in range(ESTIMATES):
        if touch_side(tables, work, index) != UNLOADED:
            return False
        before = side.deflection.lateral
        lateral, vertical = one_contact(tables, work, index, height - side.best, True)
        if i > 0:
            lateral = 0.5 * (lateral + before)
        if not stand_on(tables, work, index, lateral, vertical):
            return False
        if fabs(lateral - before) < SAME_PLACE:
            break
    if touch_side(tables, work, index) != UNLOADED:
        return False
    lateral = side.deflection.lateral
    across, vertical = one_contact(tables, work, index, height - side.best, False)
    return stand_on(tables, work, index, lateral, vertical)


@seldom
def one_contact(tables: Tables, work: Work, index: int, approach: float, sideways: bool):
    """Deflections [m] under the force of one contact at the described place, whose wheel is ``approach`` [m]
    below its smallest gap; if not ``sideways`` the lateral one is as it is.

    With the flexibility s of the springs along the normal, and the penetration D F^(2/3), both together are
    the way A that the rail at rest would be penetrated: s x^3 + D x^2 = A for the force F = x^3.
    """
    equilibrium = work.equilibrium
    side = work.sides[index]
    sine, cosine = sine_cosine(side.point.contact_angle)
    across = 0.0
    down = 0.0
    if sideways and equilibrium.lateral_stiffness > 0.0:
        across = sine / equilibrium.lateral_stiffness
    if equilibrium.vertical_stiffness > 0.0:
        down = cosine / equilibrium.vertical_stiffness
    flexibility = across * sine + down * cosine
    way = (approach + side.deflection.vertical - equilibrium.vertical_rest) * cosine
    if sideways:
        way += (side.deflection.lateral - equilibrium.lateral_rest) * sine
    force = 0.0
    if way > 0.0 and flexibility > 0.0:
        x = cube_root(way / flexibility)
        soft = first_penetration(tables.pairs[index], work.contact, way / flexibility) / (x * x)
        for i in range(FORCE_STEPS):
            x -= (x * x * (flexibility * x + soft) - way) / (x * (3.0 * flexibility * x + 2.0 * soft))
        force = x * x * x
    return equilibrium.lateral_rest + across * force, equilibrium.vertical_rest + down * force


# --- Broyden's method -------------------------------------------------------------------------------------


@seldom
def iterate_deflection(
    tables: Tables, work: Work, index: int, height: float, lateral: float, vertical: float, trials: int
):
    """Settle the rail of a side by Broyden's method from ``lateral`` and ``vertical`` [m] on; the status,
    NOT_CONVERGED where so many ``trials`` find nothing.  Fewer begin with the derivatives that are known."""
    equilibrium = work.equilibrium
    side = work.sides[index]
    sharp = SETTLED
    if trials != DEFLECTION_TRIALS:
        sharp = AGAIN_SHARP
    for trial in range(trials):
        before_lateral = equilibrium.lateral
        before_vertical = equilibrium.vertical
        status = press_rail(tables, work, index, height, lateral, vertical)
        if status > UNLOADED:
            return NOT_CONVERGED
        before = fabs(before_lateral) + fabs(before_vertical)
        worse = fabs(equilibrium.lateral) + fabs(equilibrium.vertical) > before
        if trial == 0 and trials == DEFLECTION_TRIALS or trial > 0 and worse:
            begin_slopes(tables, work, index, height)
        elif trial > 0:
            update_slopes(equilibrium, before_lateral, before_vertical)
        if not find_equilibrium_of_rail(tables, work, index, height):
            return NOT_CONVERGED
        if fabs(equilibrium.move_lateral) < sharp and fabs(equilibrium.move_vertical) < sharp:
            if not is_balanced(equilibrium, side, UNSETTLED):
                status = NOT_CONVERGED
            return status
        shorten_move(equilibrium)
        lateral += equilibrium.move_lateral
        vertical += equilibrium.move_vertical
    return NOT_CONVERGED
