"""What is asked of a step: whether its inputs can be evaluated, each side's force, and which sides are
requested.

Vertical loads of which friction carries a part.

With ``load="vertical"`` a wheel's whole force, creep forces included, has the vertical component Q that is
prescribed.  The first solution leaves creep forces out; it has the component s Q.  Were all forces
proportional to the load, normal forces for the load Q / s would give Q: this is the second solution.  From
there on a secant through the last two finds the load of each wheel, with two or three more solutions: what is
left would otherwise show as noise in differences of the outputs.
"""

from math import fabs, isfinite
from typing import Final

from ..creep.friction import is_frictional
from ..creep.motion import are_independent, is_moderate
from ..layout import (DEPTH_ALL, FRICTION_LIMIT, INPUT_COUNT, INVALID_INPUT, LOAD_VERTICAL, MODE_COMPLIANT,
                      OFF_PROFILE, RAIL_LIMIT, RAIL_ROLL_LIMIT, ROLL_LIMIT, SIDES_BOTH, SIDES_LEFT,
                      TANGENTIAL_NONE, TIME_LIMIT, UNLOADED, VALID, Inputs, Support, Tables, Work)

#: The load is met when no wheel misses it by more than this share [-].
LOAD_MET: Final[float] = 1e-9
#: What is missed by more than this share in the end has no solution: friction carries the wheel, or its
#: contact
#: jumps between tread and flange [-].
LOAD_MISSED: Final[float] = 1e-3
#: The wheelset is solved again so often at most.
LOAD_PASSES: Final[int] = 8
#: Turns in which the rate of the load is found; each leaves a tenth of the one before at most.
LOAD_RATES: Final[int] = 6
#: In one turn the load changes by a factor between this and its inverse; friction that carries more than half
#: of it would jam the wheel.
LARGEST_CHANGE: Final[float] = 2.0
#: A secant through two loads that differ by less than this share is not tried [-].
LEAST_CHANGE: Final[float] = 1e-12


def check_inputs(tables: Tables, inputs: Inputs):
    """VALID, INVALID_INPUT if an input has no meaning, or OFF_PROFILE if the pose is outside the
    range of the profiles."""
    status = VALID
    if fabs(inputs.lateral_shift) > tables.lateral_limit or fabs(inputs.yaw) > tables.yaw_limit:
        status = OFF_PROFILE
    if tables.mode == MODE_COMPLIANT and fabs(inputs.roll) > ROLL_LIMIT:
        status = OFF_PROFILE
    if is_rail_far(inputs):
        status = OFF_PROFILE
    if inputs.normal_force < 0.0 or fabs(inputs.load_transfer) > 1.0:
        status = INVALID_INPUT
    if not (inputs.rail_time_step >= 0.0 and inputs.rail_time_step <= TIME_LIMIT):
        status = INVALID_INPUT
    if not is_moderate(inputs):
        status = INVALID_INPUT
    if not is_frictional(inputs.left_friction, FRICTION_LIMIT):
        status = INVALID_INPUT
    if not is_frictional(inputs.right_friction, FRICTION_LIMIT):
        status = INVALID_INPUT
    for i in range(INPUT_COUNT):
        if not isfinite(inputs[i]):
            status = INVALID_INPUT
    return status


def is_rail_far(inputs: Inputs) -> bool:
    """Whether a rail is displaced further than RAIL_LIMIT, or rolled further than RAIL_ROLL_LIMIT."""
    far = fabs(inputs.left_rail_lateral) > RAIL_LIMIT or fabs(inputs.right_rail_lateral) > RAIL_LIMIT
    if fabs(inputs.left_rail_roll) > RAIL_ROLL_LIMIT or fabs(inputs.right_rail_roll) > RAIL_ROLL_LIMIT:
        far = True
    if fabs(inputs.left_rail_vertical) > RAIL_LIMIT or fabs(inputs.right_rail_vertical) > RAIL_LIMIT:
        far = True
    if (fabs(inputs.left_rail_deflection_lateral_before) > RAIL_LIMIT
            or fabs(inputs.left_rail_deflection_vertical_before) > RAIL_LIMIT):
        far = True
    if (fabs(inputs.right_rail_deflection_lateral_before) > RAIL_LIMIT
            or fabs(inputs.right_rail_deflection_vertical_before) > RAIL_LIMIT):
        far = True
    return far


def side_force(work: Work, index: int):
    """The prescribed force of side ``index`` [N], with load transfer; where friction carries some of it, what
    is left to the normal forces (requested.py)."""
    sign = float(2 * index - 1)
    return (work.inputs.normal_force * (1.0 + sign * work.inputs.load_transfer)
            * work.supports[index].friction_load)


def is_requested(tables: Tables, index: int) -> bool:
    """Whether the outputs of side ``index`` are requested."""
    return tables.sides == SIDES_BOTH or tables.sides == SIDES_LEFT + index


def requested_outcome(tables: Tables, work: Work, status: int):
    """The outcome of an elastic wheelset as the requested sides have it: a wheel that is not requested may be
    without load."""
    outcome = status
    if status == UNLOADED and tables.sides != SIDES_BOTH:
        if side_force(work, tables.sides - SIDES_LEFT) > 0.0:
            outcome = VALID
    return outcome


def is_rolling(tables: Tables, inputs: Inputs) -> bool:
    """Whether the wheelset runs or its wheels turn: otherwise there are no creepages."""
    rolling = inputs.speed != 0.0 or inputs.wheel_rate != 0.0
    if are_independent(tables):
        rolling = inputs.speed != 0.0 or inputs.left_wheel_rate != 0.0 or inputs.right_wheel_rate != 0.0
    return rolling


def has_creep_forces(tables: Tables, work: Work) -> bool:
    """Whether there are creep forces: a model is chosen, and the wheelset rolls."""
    return tables.tangential != TANGENTIAL_NONE and is_rolling(tables, work.inputs)


def has_wear(tables: Tables) -> bool:
    """Whether the outputs of wear are requested."""
    return tables.wear and tables.depth == DEPTH_ALL


def release_friction(work: Work):
    """Friction carries nothing yet."""
    for index in range(2):
        support = work.supports[index]
        support.friction_load = 1.0
        support.load_before = 0.0
        support.share_before = 0.0


def carries_friction(tables: Tables, work: Work) -> bool:
    """Whether a part of the prescribed load is carried by friction."""
    carried = False
    if tables.load == LOAD_VERTICAL and tables.mode != MODE_COMPLIANT:
        carried = has_creep_forces(tables, work)
    return carried


def carried_share(work: Work, index: int):
    """The vertical force of a wheel over the load that is wanted of it; 1 for a wheel without load."""
    share = 1.0
    wanted = work.inputs.normal_force * (1.0 + float(2 * index - 1) * work.inputs.load_transfer)
    forces = work.sides[index].forces
    if wanted > 0.0 and forces.normal_force[2] < 0.0:
        share = -forces.force[2] / wanted
    return share


def is_load_met(work: Work, share: float) -> bool:
    """Whether neither wheel misses the vertical force that is wanted by more than this ``share``."""
    met = True
    for index in range(2):
        if fabs(carried_share(work, index) - 1.0) > share:
            met = False
    return met


def share_load(work: Work):
    """Let the normal forces of both sides carry what friction leaves of the load, or adds to it."""
    for index in range(2):
        share = carried_share(work, index)
        support = work.supports[index]
        load = next_load(support, share)
        support.load_before = support.friction_load
        support.share_before = share
        support.friction_load = load


def next_load(support: Support, share: float):
    """The next load of a side over that of the inputs, where the last one has given ``share`` of what is
    wanted: from a secant, or in proportion."""
    load = support.friction_load
    change = load - support.load_before
    slope = share / load
    if support.load_before > 0.0 and fabs(change) > LEAST_CHANGE * load:
        secant = (share - support.share_before) / change
        if secant > slope / LARGEST_CHANGE and secant < slope * LARGEST_CHANGE:
            slope = secant
    following = max(min(load - (share - 1.0) / slope, load * LARGEST_CHANGE), load / LARGEST_CHANGE)
    return following
