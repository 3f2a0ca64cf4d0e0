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

from ..layout import UNLOADED, Settling, SideSearch, Tables, Work
from .at_height import load_at_height
from .forces import sum_side
from .requested import has_creep_forces, is_moving
from .rubbing import move_side, rub_side

#: Springs carry what the wheel presses but for this share of it [-]; what misses it lies on a jump.
UNSETTLED: Final[float] = 1e-8


def damper_stiffness(damping: float, time_step: float):
    """Stiffness [N/m] of a damper over a step in time [s]."""
    stiffness = 0.0
    if time_step > 0.0:
        stiffness = damping / time_step
    return stiffness


def open_settling(tables: Tables, work: Work, index: int):
    """Springs and dampers of side ``index`` over the step in time."""
    settling = work.settling
    spring = tables.springs[index]
    time_step = work.inputs.rail_time_step
    lateral = -work.inputs.left_rail_deflection_lateral_before
    vertical = work.inputs.left_rail_deflection_vertical_before
    if index == 1:
        lateral = work.inputs.right_rail_deflection_lateral_before
        vertical = work.inputs.right_rail_deflection_vertical_before
    settling.lateral_stiffness = 0.0
    settling.lateral_rest = 0.0
    settling.lateral_before = 0.0
    if spring.lateral_stiffness > 0.0:
        damper = damper_stiffness(spring.lateral_damping, time_step)
        settling.lateral_stiffness = spring.lateral_stiffness + damper
        settling.lateral_rest = damper * lateral / settling.lateral_stiffness
        settling.lateral_before = lateral
    settling.vertical_stiffness = 0.0
    settling.vertical_rest = 0.0
    settling.vertical_before = 0.0
    if spring.vertical_stiffness > 0.0:
        damper = damper_stiffness(spring.vertical_damping, time_step)
        settling.vertical_stiffness = spring.vertical_stiffness + damper
        settling.vertical_rest = damper * vertical / settling.vertical_stiffness
        settling.vertical_before = vertical


def deflect(work: Work, index: int, lateral: float, vertical: float):
    """Let the rail of side ``index`` have this deflection [m], and the rates that it has come with."""
    settling = work.settling
    deflection = work.sides[index].deflection
    deflection.lateral = lateral
    deflection.vertical = vertical
    deflection.lateral_rate = 0.0
    deflection.vertical_rate = 0.0
    time_step = work.inputs.rail_time_step
    if time_step > 0.0:
        deflection.lateral_rate = (lateral - settling.lateral_before) / time_step
        deflection.vertical_rate = (vertical - settling.vertical_before) / time_step


def rest_rail(tables: Tables, work: Work, index: int):
    """Let the rail of side ``index`` stand where nothing presses it."""
    open_settling(tables, work, index)
    deflect(work, index, work.settling.lateral_rest, work.settling.vertical_rest)


def spring_residual(stiffness: float, rest: float, deflection: float, force: float):
    """What a spring of this ``stiffness`` carries more than ``force`` [N]; of a rigid support the
    deflection."""
    residual = deflection
    if stiffness > 0.0:
        residual = stiffness * (deflection - rest) - force
    return residual


def weigh_rail(tables: Tables, work: Work, index: int, height: float):
    """What the springs of a placed side carry more than its wheel at ``height`` [m] presses; the outcome."""
    status = load_at_height(tables, work, index, height)
    if status <= UNLOADED:
        side = work.sides[index]
        settling = work.settling
        rubbing = has_creep_forces(tables, work)
        if is_moving(tables, work.inputs):
            move_side(tables, side)
        if rubbing:
            rub_side(tables, work, index)
        sum_side(side, rubbing)
        settling.lateral = spring_residual(
            settling.lateral_stiffness, settling.lateral_rest, side.deflection.lateral, -side.forces.force[1]
        )
        settling.vertical = spring_residual(
            settling.vertical_stiffness,
            settling.vertical_rest,
            side.deflection.vertical,
            -side.forces.force[2],
        )
    return status


def has_settled(settling: Settling, side: SideSearch, share: float) -> bool:
    """Whether the springs carry what the wheel presses but for this ``share`` of it."""
    force = side.forces.force
    limit = share * (fabs(force[1]) + fabs(force[2]))
    return fabs(settling.lateral) + fabs(settling.vertical) <= limit
