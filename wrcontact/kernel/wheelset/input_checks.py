"""What is asked of a step: whether its inputs can be evaluated, each side's force, and which sides are
requested.
"""

from math import fabs, isfinite
from typing import Final

from ..creep.friction import is_frictional
from ..creep.motion import are_independent, is_moderate
from ..layout import (
    DEPTH_ALL,
    DEPTH_GEOMETRY,
    FRICTION_LIMIT,
    INPUT_COUNT,
    INVALID_INPUT,
    MODE_COMPLIANT,
    OFF_PROFILE,
    RAIL_LIMIT,
    RAIL_ROLL_LIMIT,
    ROLL_LIMIT,
    SIDES_BOTH,
    SIDES_LEFT,
    TANGENTIAL_NONE,
    TIME_LIMIT,
    UNLOADED,
    VALID,
    Inputs,
    Tables,
    Work,
)

#: A smaller force [N] is none: it presses a wheel in by 1e-14 m, the rounding of its height.
NO_FORCE: Final[float] = 1e-10


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
    if (
        fabs(inputs.left_rail_deflection_lateral_before) > RAIL_LIMIT
        or fabs(inputs.left_rail_deflection_vertical_before) > RAIL_LIMIT
    ):
        far = True
    if (
        fabs(inputs.right_rail_deflection_lateral_before) > RAIL_LIMIT
        or fabs(inputs.right_rail_deflection_vertical_before) > RAIL_LIMIT
    ):
        far = True
    return far


def side_force(work: Work, index: int):
    """The prescribed force of side ``index`` [N], with load transfer; where friction carries some of it, what
    is left to the normal forces (vertical_load.py)."""
    return wanted_force(work.inputs, index) * work.supports[index].friction_load


def wanted_force(inputs: Inputs, index: int):
    """The force that is wanted of side ``index`` [N]; none below NO_FORCE."""
    force = inputs.normal_force * (1.0 + float(2 * index - 1) * inputs.load_transfer)
    if force < NO_FORCE:
        force = 0.0
    return force


def is_requested(tables: Tables, index: int) -> bool:
    """Whether the outputs of side ``index`` are requested."""
    return tables.sides == SIDES_BOTH or tables.sides == SIDES_LEFT + index


def is_needed(tables: Tables, inputs: Inputs, index: int) -> bool:
    """Whether side ``index`` is requested, or the rotation of the wheelset follows from it, too."""
    needed = is_requested(tables, index)
    if not needed and not tables.alone and tables.depth != DEPTH_GEOMETRY:
        needed = is_free(tables, inputs, index) and not are_independent(tables) and is_moving(tables, inputs)
    return needed


def counted_status(tables: Tables, index: int, status: int, side_status: int):
    """``status`` with the ``side_status`` of side ``index``; a wheel that is needed and not requested may be
    without load."""
    counted = status
    if side_status > UNLOADED or is_requested(tables, index):
        counted = max(status, side_status)
    return counted


def requested_status(tables: Tables, work: Work, status: int):
    """The status of an elastic wheelset as the requested sides have it: a wheel that is not requested may be
    without load."""
    requested = status
    if status == UNLOADED and tables.sides != SIDES_BOTH:
        if side_force(work, tables.sides - SIDES_LEFT) > 0.0:
            requested = VALID
    return requested


def is_free(tables: Tables, inputs: Inputs, index: int) -> bool:
    """Whether the rotation of the wheel of side ``index`` follows from the torque on it, where creep forces
    tell of one."""
    if tables.tangential == TANGENTIAL_NONE:
        return False
    given = inputs.wheel_rate
    if are_independent(tables):
        given = inputs.left_wheel_rate
        if index == 1:
            given = inputs.right_wheel_rate
    return given == 0.0 and inputs.free_rolling != 0.0 and tables.parameters.nominal_rolling == 0.0


def outer_torque(tables: Tables, inputs: Inputs, index: int):
    """Torque from outside on the wheelset, or on the wheel of side ``index`` that turns by itself [N m]."""
    torque = inputs.axle_torque
    if are_independent(tables):
        torque = inputs.left_axle_torque
        if index == 1:
            torque = inputs.right_axle_torque
    return torque


def is_driven(tables: Tables, inputs: Inputs, index: int) -> bool:
    """Whether a torque from outside is carried by the creep forces of side ``index``."""
    return outer_torque(tables, inputs, index) != 0.0 and is_free(tables, inputs, index)


def is_rolling(tables: Tables, inputs: Inputs) -> bool:
    """Whether the wheelset runs or its wheels turn: otherwise there is no rolling speed for creepages."""
    rolling = inputs.speed != 0.0 or inputs.wheel_rate != 0.0
    if are_independent(tables):
        rolling = inputs.speed != 0.0 or inputs.left_wheel_rate != 0.0 or inputs.right_wheel_rate != 0.0
    return rolling or is_driven(tables, inputs, 0) or is_driven(tables, inputs, 1)


def is_moving(tables: Tables, inputs: Inputs) -> bool:
    """Whether wheelset or rails have a velocity: otherwise nothing rolls or slides."""
    if is_rolling(tables, inputs) or inputs.lateral_velocity != 0.0 or inputs.yaw_rate != 0.0:
        return True
    moving = is_rail_moving(inputs)
    if tables.mode == MODE_COMPLIANT and (inputs.vertical_velocity != 0.0 or inputs.roll_rate != 0.0):
        moving = True
    return moving


def is_rail_moving(inputs: Inputs) -> bool:
    """Whether a rail is given a velocity."""
    left = (
        inputs.left_rail_lateral_velocity != 0.0
        or inputs.left_rail_vertical_velocity != 0.0
        or inputs.left_rail_roll_velocity != 0.0
    )
    return (
        left
        or inputs.right_rail_lateral_velocity != 0.0
        or inputs.right_rail_vertical_velocity != 0.0
        or inputs.right_rail_roll_velocity != 0.0
    )


def has_creep_forces(tables: Tables, work: Work) -> bool:
    """Whether there are creep forces: a model is chosen, and the wheelset rolls or slides."""
    return tables.tangential != TANGENTIAL_NONE and is_moving(tables, work.inputs)


def has_wear(tables: Tables) -> bool:
    """Whether the outputs of wear are requested."""
    return tables.wear and tables.depth == DEPTH_ALL
