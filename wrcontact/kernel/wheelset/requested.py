"""What is asked of a step: whether its inputs can be evaluated, each side's force, and which
outputs are requested."""

from math import fabs, isfinite

from ..layout import (
    DEPTH_GEOMETRY,
    DEPTH_PATCHES,
    FRICTION_LIMIT,
    INPUT_COUNT,
    INVALID_INPUT,
    MODE_COMPLIANT,
    MODE_RIGID,
    OFF_PROFILE,
    RAIL_LIMIT,
    RAIL_ROLL_LIMIT,
    ROLL_LIMIT,
    SIDE_PENETRATION,
    SIDE_SIZE,
    SIDE_STATION,
    SIDES_BOTH,
    SIDES_LEFT,
    VALID,
    Inputs,
    Tables,
    Work,
)
from ..motion.wheelset_motion import is_moderate
from .friction import is_frictional
from .outlines import fill_apart


def check_inputs(tables: Tables, inputs: Inputs):
    """VALID, INVALID_INPUT if an input has no meaning, or OFF_PROFILE if the pose is outside the
    range of the profiles."""
    status = VALID
    if fabs(inputs.lateral_shift) > tables.lateral_limit or fabs(inputs.yaw) > tables.yaw_limit:
        status = OFF_PROFILE
    if tables.mode == MODE_COMPLIANT and fabs(inputs.roll) > ROLL_LIMIT:
        status = OFF_PROFILE
    if is_rail_far(inputs) == 1:
        status = OFF_PROFILE
    if inputs.normal_force < 0.0 or fabs(inputs.load_transfer) > 1.0:
        status = INVALID_INPUT
    if is_moderate(inputs) == 0:
        status = INVALID_INPUT
    if is_frictional(inputs.left_friction, FRICTION_LIMIT) == 0:
        status = INVALID_INPUT
    if is_frictional(inputs.right_friction, FRICTION_LIMIT) == 0:
        status = INVALID_INPUT
    for i in range(INPUT_COUNT):
        if not isfinite(inputs[i]):
            status = INVALID_INPUT
    return status


def is_rail_far(inputs: Inputs):
    """1 if a rail is displaced further than RAIL_LIMIT, or rolled further than RAIL_ROLL_LIMIT, else 0."""
    far = 0
    if fabs(inputs.left_rail_lateral) > RAIL_LIMIT or fabs(inputs.right_rail_lateral) > RAIL_LIMIT:
        far = 1
    if fabs(inputs.left_rail_roll) > RAIL_ROLL_LIMIT or fabs(inputs.right_rail_roll) > RAIL_ROLL_LIMIT:
        far = 1
    if fabs(inputs.left_rail_vertical) > RAIL_LIMIT or fabs(inputs.right_rail_vertical) > RAIL_LIMIT:
        far = 1
    return far


def side_force(work: Work, index: int):
    """The prescribed force of side ``index`` [N], with load transfer; where friction carries some of it, what
    is left to the normal forces (friction_load.py)."""
    sign = float(2 * index - 1)
    return (work.inputs.normal_force * (1.0 + sign * work.inputs.load_transfer)
            * work.supports[index].friction_load)


def is_requested(tables: Tables, index: int):
    """1 if the outputs of side ``index`` are requested, else 0."""
    requested = 0
    if tables.sides == SIDES_BOTH or tables.sides == SIDES_LEFT + index:
        requested = 1
    return requested


def first_omitted(tables: Tables):
    """The first of a side's outputs that is not requested; SIDE_SIZE if all are."""
    first = SIDE_SIZE
    if tables.depth == DEPTH_PATCHES:
        first = SIDE_STATION
    if tables.depth == DEPTH_GEOMETRY:
        first = SIDE_PENETRATION
    return first


def omit_outputs(tables: Tables, work: Work):
    """Take back the outputs that are not requested; the resultant needs both sides and their loads."""
    for index in range(2):
        first = first_omitted(tables)
        if is_requested(tables, index) == 0:
            first = 0
        if first < SIDE_SIZE:
            omit_from(tables, work, index, first)
    partial = tables.sides != SIDES_BOTH or tables.depth == DEPTH_GEOMETRY
    if partial and tables.mode == MODE_RIGID:
        for i in range(3):
            work.outputs.force[i] = tables.absent
            work.outputs.moment[i] = tables.absent
            work.outputs.normal_part[i] = tables.absent
            work.outputs.normal_moment[i] = tables.absent
        work.outputs.driving_torque = tables.absent
    return 0


def omit_from(tables: Tables, work: Work, index: int, first: int):
    """Write what stands for outputs that are not requested, from a side's output ``first`` on."""
    out = work.outputs.left[index]
    for i in range(first, SIDE_SIZE):
        out[i] = tables.absent
    fill_apart(tables, work, index, tables.absent)
    if first <= SIDE_PENETRATION:
        out.patch_count = tables.absent
    return 0
