"""How what the springs of a rail carry more than its wheel presses follows both deflections of the rail."""

from math import fabs
from typing import Final

from ..layout import UNLOADED, Settling, Tables, Work, seldom
from .at_height import is_damped
from .requested import has_creep_forces
from .rubbing import open_given_motion
from .springs import weigh_rail

#: How the load of a patch grows: d ln(load) / d ln(penetration), by Hertz.
GROWTH: Final[float] = 1.5
#: Smallest determinant of the residuals' derivatives over that of the springs [-].
SINGULAR_SPRINGS: Final[float] = 0.01
#: Rates are varied by this share of the speed of a patch [-]: creep forces are nearly linear so far; and by
#: no less than this [m/s].
RATE_SHARE: Final[float] = 1e-6
LEAST_RATE: Final[float] = 1e-6


@seldom
def begin_slopes(tables: Tables, work: Work, index: int, height: float):
    """The residuals' derivatives from the springs, and from patches whose forces grow as Hertz's along their
    normals, friction in proportion; over a step in time also from how forces follow the rates of the rail."""
    settling = work.settling
    side = work.sides[index]
    settling.lateral_lateral = settling.lateral_stiffness
    settling.lateral_vertical = 0.0
    settling.vertical_lateral = 0.0
    settling.vertical_vertical = settling.vertical_stiffness
    for number in range(side.patch_count):
        patch = side.patches[number]
        if patch.totals.load > 0.0 and patch.penetration > 0.0:
            stiffness = GROWTH / (patch.totals.load * patch.penetration)
            force = patch.forces.force
            settling.lateral_lateral += stiffness * force[1] * patch.normal_y
            settling.lateral_vertical += stiffness * force[1] * patch.normal_z
            settling.vertical_lateral += stiffness * force[2] * patch.normal_y
            settling.vertical_vertical += stiffness * force[2] * patch.normal_z
    if work.inputs.rail_time_step > 0.0 and (is_damped(tables) or has_creep_forces(tables, work)):
        add_rates(tables, work, index, height)
    hold_rigid(settling)


@seldom
def hold_rigid(settling: Settling):
    """Directions in which a rail is rigid keep its deflection."""
    if not settling.lateral_stiffness > 0.0:
        settling.lateral_lateral = 1.0
        settling.lateral_vertical = 0.0
    if not settling.vertical_stiffness > 0.0:
        settling.vertical_lateral = 0.0
        settling.vertical_vertical = 1.0


@seldom
def add_rates(tables: Tables, work: Work, index: int, height: float):
    """Add how the forces follow the rates of the rail, over the step in time in which these follow its
    deflections: by differences."""
    settling = work.settling
    side = work.sides[index]
    deflection = side.deflection
    lateral = settling.lateral
    vertical = settling.vertical
    step = LEAST_RATE
    if side.patch_count > 0:
        step = max(step, RATE_SHARE * side.patches[0].speed)
    over = 1.0 / (step * work.inputs.rail_time_step)
    if settling.lateral_stiffness > 0.0:
        deflection.lateral_rate += step
        if weigh_anew(tables, work, index, height):
            settling.lateral_lateral += (settling.lateral - lateral) * over
            settling.vertical_lateral += (settling.vertical - vertical) * over
        deflection.lateral_rate -= step
    if settling.vertical_stiffness > 0.0:
        deflection.vertical_rate += step
        if weigh_anew(tables, work, index, height):
            settling.lateral_vertical += (settling.lateral - lateral) * over
            settling.vertical_vertical += (settling.vertical - vertical) * over
        deflection.vertical_rate -= step
    weigh_anew(tables, work, index, height)


@seldom
def weigh_anew(tables: Tables, work: Work, index: int, height: float) -> bool:
    """The residuals with other rates of the rail; whether they are known."""
    open_given_motion(tables, work)
    return weigh_rail(tables, work, index, height) <= UNLOADED


@seldom
def find_settling(tables: Tables, work: Work, index: int, height: float) -> bool:
    """The move that lets both residuals vanish; whether there is one."""
    settling = work.settling
    least = SINGULAR_SPRINGS
    if settling.lateral_stiffness > 0.0:
        least *= settling.lateral_stiffness
    if settling.vertical_stiffness > 0.0:
        least *= settling.vertical_stiffness
    determinant = (
        settling.lateral_lateral * settling.vertical_vertical
        - settling.lateral_vertical * settling.vertical_lateral
    )
    if not determinant > least:
        begin_slopes(tables, work, index, height)
        determinant = (
            settling.lateral_lateral * settling.vertical_vertical
            - settling.lateral_vertical * settling.vertical_lateral
        )
        if not determinant > least:
            return False
    settling.move_lateral = (
        settling.vertical * settling.lateral_vertical - settling.lateral * settling.vertical_vertical
    ) / determinant
    settling.move_vertical = (
        settling.lateral * settling.vertical_lateral - settling.vertical * settling.lateral_lateral
    ) / determinant
    return True


@seldom
def update_slopes(settling: Settling, before_lateral: float, before_vertical: float):
    """The derivatives that the last move has shown (Broyden 1965)."""
    lateral = settling.move_lateral
    vertical = settling.move_vertical
    size = lateral * lateral + vertical * vertical
    if size > 0.0:
        off_lateral = (
            settling.lateral
            - before_lateral
            - settling.lateral_lateral * lateral
            - settling.lateral_vertical * vertical
        ) / size
        off_vertical = (
            settling.vertical
            - before_vertical
            - settling.vertical_lateral * lateral
            - settling.vertical_vertical * vertical
        ) / size
        settling.lateral_lateral += off_lateral * lateral
        settling.lateral_vertical += off_lateral * vertical
        settling.vertical_lateral += off_vertical * lateral
        settling.vertical_vertical += off_vertical * vertical
