"""Rails on springs and dampers: what they carry, and what the wheel presses.

A rail has no mass.  With its deflection u from the foot of its springs, laterally and vertically, the
stiffness k and the damping c of a direction, and the force F(u, du/dt) of the wheel on the rail, creep forces
with it,

    k u + c du/dt = F.

Over the time h since the deflection was u0 its rate is (u - u0) / h (Euler's implicit rule), with which the
rail moves below the contact, too: a damper is a spring with the stiffness c / h from u0.  Both together have
the stiffness k + c / h and carry nothing at u0 (c / h) / (k + c / h).  Without h the rail is at rest, and
dampers carry nothing.
"""

from math import fabs
from typing import Final

from ..layout import UNLOADED, RailEquilibrium, SideSearch, Tables, Work
from .prescribed_height import load_at_height
from .forces import sum_side
from .input_checks import has_creep_forces, is_moving
from .rolling_contact import move_side, solve_side_creep

#: Springs carry what the wheel presses but for this share of it [-]; what misses it lies on a jump.
UNSETTLED: Final[float] = 1e-8


def damper_stiffness(damping: float, time_step: float):
    """Stiffness [N/m] of a damper over a step in time [s]."""
    stiffness = 0.0
    if time_step > 0.0:
        stiffness = damping / time_step
    return stiffness


def open_equilibrium(tables: Tables, work: Work, index: int):
    """Springs and dampers of side ``index`` over the step in time."""
    equilibrium = work.equilibrium
    spring = tables.springs[index]
    time_step = work.inputs.rail_time_step
    lateral = -work.inputs.left_rail_deflection_lateral_before
    vertical = work.inputs.left_rail_deflection_vertical_before
    if index == 1:
        lateral = work.inputs.right_rail_deflection_lateral_before
        vertical = work.inputs.right_rail_deflection_vertical_before
    equilibrium.lateral_stiffness = 0.0
    equilibrium.lateral_rest = 0.0
    equilibrium.lateral_before = 0.0
    if spring.lateral_stiffness > 0.0:
        damper = damper_stiffness(spring.lateral_damping, time_step)
        equilibrium.lateral_stiffness = spring.lateral_stiffness + damper
        equilibrium.lateral_rest = damper * lateral / equilibrium.lateral_stiffness
        equilibrium.lateral_before = lateral
    equilibrium.vertical_stiffness = 0.0
    equilibrium.vertical_rest = 0.0
    equilibrium.vertical_before = 0.0
    if spring.vertical_stiffness > 0.0:
        damper = damper_stiffness(spring.vertical_damping, time_step)
        equilibrium.vertical_stiffness = spring.vertical_stiffness + damper
        equilibrium.vertical_rest = damper * vertical / equilibrium.vertical_stiffness
        equilibrium.vertical_before = vertical


def deflect(work: Work, index: int, lateral: float, vertical: float):
    """Let the rail of side ``index`` have this deflection [m], and the rates that it has come with."""
    equilibrium = work.equilibrium
    deflection = work.sides[index].deflection
    deflection.lateral = lateral
    deflection.vertical = vertical
    deflection.lateral_rate = 0.0
    deflection.vertical_rate = 0.0
    time_step = work.inputs.rail_time_step
    if time_step > 0.0:
        deflection.lateral_rate = (lateral - equilibrium.lateral_before) / time_step
        deflection.vertical_rate = (vertical - equilibrium.vertical_before) / time_step


def rest_rail(tables: Tables, work: Work, index: int):
    """Let the rail of side ``index`` stand where nothing presses it."""
    open_equilibrium(tables, work, index)
    deflect(work, index, work.equilibrium.lateral_rest, work.equilibrium.vertical_rest)


def spring_residual(stiffness: float, rest: float, deflection: float, force: float):
    """What a spring of this ``stiffness`` carries more than ``force`` [N]; of a rigid support the
    deflection."""
    residual = deflection
    if stiffness > 0.0:
        residual = stiffness * (deflection - rest) - force
    return residual


def weigh_rail(tables: Tables, work: Work, index: int, height: float):
    """What the springs of a placed side carry more than its wheel at ``height`` [m] presses; the status."""
    status = load_at_height(tables, work, index, height)
    if status <= UNLOADED:
        side = work.sides[index]
        equilibrium = work.equilibrium
        with_creep = has_creep_forces(tables, work)
        if is_moving(tables, work.inputs):
            move_side(tables, side)
        if with_creep:
            solve_side_creep(tables, work, index)
        sum_side(side, with_creep)
        equilibrium.lateral = spring_residual(
            equilibrium.lateral_stiffness,
            equilibrium.lateral_rest,
            side.deflection.lateral,
            -side.forces.force[1],
        )
        equilibrium.vertical = spring_residual(
            equilibrium.vertical_stiffness,
            equilibrium.vertical_rest,
            side.deflection.vertical,
            -side.forces.force[2],
        )
    return status


def is_balanced(equilibrium: RailEquilibrium, side: SideSearch, share: float) -> bool:
    """Whether the springs carry what the wheel presses but for this ``share`` of it."""
    force = side.forces.force
    limit = share * (fabs(force[1]) + fabs(force[2]))
    return fabs(equilibrium.lateral) + fabs(equilibrium.vertical) <= limit
