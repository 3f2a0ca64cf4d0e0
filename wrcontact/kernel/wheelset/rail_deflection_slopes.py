"""How what the springs of a rail carry more than its wheel presses follows both deflections of the rail."""

from math import fabs
from typing import Final

from ..elementary.pair import solve_pair
from ..layout import UNLOADED, RailEquilibrium, Tables, Work, seldom
from .prescribed_height import is_damped
from .input_checks import has_creep_forces
from .rolling_contact import open_given_motion
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
    equilibrium = work.equilibrium
    slopes = equilibrium.slopes
    side = work.sides[index]
    slopes.lateral_lateral = equilibrium.lateral_stiffness
    slopes.lateral_vertical = 0.0
    slopes.vertical_lateral = 0.0
    slopes.vertical_vertical = equilibrium.vertical_stiffness
    for number in range(side.patch_count):
        patch = side.patches[number]
        if patch.totals.load > 0.0 and patch.penetration > 0.0:
            stiffness = GROWTH / (patch.totals.load * patch.penetration)
            force = patch.forces.force
            slopes.lateral_lateral += stiffness * force[1] * patch.normal_y
            slopes.lateral_vertical += stiffness * force[1] * patch.normal_z
            slopes.vertical_lateral += stiffness * force[2] * patch.normal_y
            slopes.vertical_vertical += stiffness * force[2] * patch.normal_z
    if work.inputs.rail_time_step > 0.0 and (is_damped(tables) or has_creep_forces(tables, work)):
        add_rates(tables, work, index, height)
    hold_rigid(equilibrium)


@seldom
def hold_rigid(equilibrium: RailEquilibrium):
    """Directions in which a rail is rigid keep its deflection."""
    slopes = equilibrium.slopes
    if not equilibrium.lateral_stiffness > 0.0:
        slopes.lateral_lateral = 1.0
        slopes.lateral_vertical = 0.0
    if not equilibrium.vertical_stiffness > 0.0:
        slopes.vertical_lateral = 0.0
        slopes.vertical_vertical = 1.0


@seldom
def add_rates(tables: Tables, work: Work, index: int, height: float):
    """Add how the forces follow the rates of the rail, over the step in time in which these follow its
    deflections: by differences."""
    equilibrium = work.equilibrium
    slopes = equilibrium.slopes
    side = work.sides[index]
    deflection = side.deflection
    lateral = equilibrium.lateral
    vertical = equilibrium.vertical
    step = LEAST_RATE
    if side.patch_count > 0:
        step = max(step, RATE_SHARE * side.patches[0].speed)
    over = 1.0 / (step * work.inputs.rail_time_step)
    if equilibrium.lateral_stiffness > 0.0:
        deflection.lateral_rate += step
        if weigh_anew(tables, work, index, height):
            slopes.lateral_lateral += (equilibrium.lateral - lateral) * over
            slopes.vertical_lateral += (equilibrium.vertical - vertical) * over
        deflection.lateral_rate -= step
    if equilibrium.vertical_stiffness > 0.0:
        deflection.vertical_rate += step
        if weigh_anew(tables, work, index, height):
            slopes.lateral_vertical += (equilibrium.lateral - lateral) * over
            slopes.vertical_vertical += (equilibrium.vertical - vertical) * over
        deflection.vertical_rate -= step
    weigh_anew(tables, work, index, height)


@seldom
def weigh_anew(tables: Tables, work: Work, index: int, height: float) -> bool:
    """The residuals with other rates of the rail; whether they are known."""
    open_given_motion(tables, work)
    return weigh_rail(tables, work, index, height) <= UNLOADED


@seldom
def find_equilibrium_of_rail(tables: Tables, work: Work, index: int, height: float) -> bool:
    """The move that lets both residuals vanish; whether there is one."""
    equilibrium = work.equilibrium
    least = SINGULAR_SPRINGS
    if equilibrium.lateral_stiffness > 0.0:
        least *= equilibrium.lateral_stiffness
    if equilibrium.vertical_stiffness > 0.0:
        least *= equilibrium.vertical_stiffness
    determinant, lateral, vertical = solve_deflections(equilibrium)
    if not determinant > least:
        begin_slopes(tables, work, index, height)
        determinant, lateral, vertical = solve_deflections(equilibrium)
        if not determinant > least:
            return False
    equilibrium.move_lateral = lateral
    equilibrium.move_vertical = vertical
    return True


@seldom
def solve_deflections(equilibrium: RailEquilibrium):
    """Determinant of the residuals' derivatives [N^2/m^2], and the moves of both deflections that they ask for
    [m]."""
    slopes = equilibrium.slopes
    return solve_pair(
        equilibrium.lateral,
        equilibrium.vertical,
        slopes.lateral_lateral,
        slopes.lateral_vertical,
        slopes.vertical_lateral,
        slopes.vertical_vertical,
    )


@seldom
def update_slopes(equilibrium: RailEquilibrium, before_lateral: float, before_vertical: float):
    """The derivatives that the last move has shown (Broyden 1965)."""
    slopes = equilibrium.slopes
    lateral = equilibrium.move_lateral
    vertical = equilibrium.move_vertical
    size = lateral * lateral + vertical * vertical
    if size > 0.0:
        off_lateral = (
            equilibrium.lateral
            - before_lateral
            - slopes.lateral_lateral * lateral
            - slopes.lateral_vertical * vertical
        ) / size
        off_vertical = (
            equilibrium.vertical
            - before_vertical
            - slopes.vertical_lateral * lateral
            - slopes.vertical_vertical * vertical
        ) / size
        slopes.lateral_lateral += off_lateral * lateral
        slopes.lateral_vertical += off_lateral * vertical
        slopes.vertical_lateral += off_vertical * lateral
        slopes.vertical_vertical += off_vertical * vertical
