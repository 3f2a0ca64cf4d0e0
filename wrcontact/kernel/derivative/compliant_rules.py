"""How a placed wheel and its rail on springs follow the inputs (wheelset_rules.py has the method)."""

from ..layout import Tables, Work
from ..surface.gap import vertical_gap
from ..surface.rails import is_sprung
from ..wheelset.prescribed_height import is_damped, load_at_height
from ..wheelset.input_checks import is_moving, is_needed
from ..wheelset.rolled_rails import set_reference
from ..wheelset.rolling_contact import open_given_motion
from ..wheelset.springs import UNSETTLED, deflect, is_balanced, open_equilibrium, weigh_rail
from .intrinsics import held, moving, nonzero, rate_of, seeded
from .motion_rules import place_moving


def follow_minimum(tables: Tables, work: Work, index: int):
    """Let the smallest gap of side ``index`` and its place move with the placed wheel: there the slopes of
    wheel and rail agree, mismatch(y) = 0."""
    pair = tables.pairs[index]
    side = work.sides[index]
    at = work.sides[index].place
    y = held(side.best_y)
    gap, mismatch, rate = vertical_gap(pair, at, y)
    y = moving(y, -mismatch / held(rate))
    gap, mismatch, rate = vertical_gap(pair, at, y)
    side.best_y = y
    side.best = moving(side.best, gap)


def follow_deflection(tables: Tables, work: Work, index: int, lateral: float, vertical: float):
    """A side at the height and roll of the inputs with its rail deflected."""
    deflect(work, index, lateral, vertical)
    place_moving(tables, work, work.inputs, work.inputs.roll)
    if is_damped(tables) or is_moving(tables, work.inputs):
        open_given_motion(tables, work)
    follow_minimum(tables, work, index)
    weigh_rail(tables, work, index, work.inputs.vertical_shift)


def follow_balanced(tables: Tables, work: Work, index: int) -> bool:
    """The rail of a side, settled on its springs: the residuals of both deflections vanish.

    Whether they do not: then a force jumps past what the springs carry (rail_deflection_brackets.py), and no
    equation gives the rate of that place.
    """
    equilibrium = work.equilibrium
    open_equilibrium(tables, work, index)
    lateral = held(work.sides[index].deflection.lateral)
    vertical = held(work.sides[index].deflection.vertical)
    follow_deflection(tables, work, index, lateral, vertical)
    if not is_balanced(equilibrium, work.sides[index], UNSETTLED):
        return True
    residual_lateral = rate_of(equilibrium.lateral)
    residual_vertical = rate_of(equilibrium.vertical)
    follow_deflection(tables, work, index, seeded(lateral, 1.0), vertical)
    lateral_lateral = rate_of(equilibrium.lateral) - residual_lateral
    vertical_lateral = rate_of(equilibrium.vertical) - residual_vertical
    follow_deflection(tables, work, index, lateral, seeded(vertical, 1.0))
    lateral_vertical = rate_of(equilibrium.lateral) - residual_lateral
    vertical_vertical = rate_of(equilibrium.vertical) - residual_vertical
    determinant = lateral_lateral * vertical_vertical - lateral_vertical * vertical_lateral
    if not nonzero(determinant):
        return True
    lateral_rate = (residual_vertical * lateral_vertical - residual_lateral * vertical_vertical) / determinant
    vertical_rate = (residual_lateral * vertical_lateral - residual_vertical * lateral_lateral) / determinant
    follow_deflection(tables, work, index, seeded(lateral, lateral_rate), seeded(vertical, vertical_rate))
    return False


def follow_compliant(tables: Tables, work: Work) -> bool:
    """Both sides of a wheelset at the height and roll of the inputs; whether their rates are not defined
    (``follow_balanced``)."""
    undefined = False
    roll = work.inputs.roll
    height = work.inputs.vertical_shift
    set_reference(work.sides, height)
    place_moving(tables, work, work.inputs, roll)
    work.wheelset.roll = roll
    work.wheelset.vertical_shift = height
    if is_damped(tables):
        open_given_motion(tables, work)
    for index in range(2):
        if is_needed(tables, work.inputs, index):
            if is_sprung(tables, index):
                side_undefined = follow_balanced(tables, work, index)
                undefined = undefined or side_undefined
            else:
                follow_minimum(tables, work, index)
                load_at_height(tables, work, index, height)
    return undefined
