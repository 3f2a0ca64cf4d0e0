"""One step of a wheelset: from pose and load to contact positions, roll and patches.

The recipe: check the inputs, find the roll at which both wheels touch, describe each contact, solve its normal contact.
"""

from math import fabs, isfinite
from typing import Final

from ..layout import (
    DEPTH_GEOMETRY,
    INPUT_COUNT,
    INVALID_INPUT,
    MODE_COMPLIANT,
    MODE_ELASTIC,
    MODE_RIGID,
    OFF_PROFILE,
    ROLL_LIMIT,
    SIDE_SIZE,
    SIDES_BOTH,
    SIDES_LEFT,
    UNLOADED,
    VALID,
    WORK_INPUTS,
    WORK_OUTPUTS,
    State,
    Tables,
    Work,
)
from ..patch.outline import row_size
from ..search.level import solve_roll
from ..search.starts import START_LEFT, START_RIGHT, START_ROLL, nearest_start
from .elastic import solve_elastic, stand_compliant
from .resultant import clear_resultant, write_resultant
from .side import clear_from, first_unwanted, step_side

#: After a longer lateral move the search does not start at the last contacts [m].
NEAR_SHIFT: Final[float] = 2e-4


def inputs_valid(work: Work):
    """1 if all inputs are finite, the force is not negative and the load transfer within -1 ... 1, else 0."""
    valid = 1
    for i in range(INPUT_COUNT):
        if not isfinite(work.inputs[i]):
            valid = 0
    if valid == 1:
        if work.inputs.normal_force < 0.0 or fabs(work.inputs.load_transfer) > 1.0:
            valid = 0
    return valid


def inputs_in_range(tables: Tables, work: Work):
    """1 if shift and yaw are within the range of the profiles, else 0."""
    inside = 1
    if fabs(work.inputs.lateral_shift) > tables.lateral_limit:
        inside = 0
    if fabs(work.inputs.yaw) > tables.yaw_limit:
        inside = 0
    if int(tables.mode) == MODE_COMPLIANT and fabs(work.inputs.roll) > ROLL_LIMIT:
        inside = 0
    return inside


def find_roll(tables: Tables, work: Work, state: State):
    """Roll [rad] and outcome; starts at the given guess, or at the last roll and contacts if the wheelset has moved little,
    or at those known near its lateral shift."""
    shift = work.inputs.lateral_shift
    guess = work.inputs.roll_guess
    warm = 0
    if guess == 0.0:
        row = nearest_start(tables, shift)
        if state.warm == 1.0 and (row < 0 or fabs(shift - state.shift) < NEAR_SHIFT):
            guess = state.roll
            work.sides[0].best_y = state.y_left
            work.sides[1].best_y = state.y_right
            warm = 1
        elif row >= 0:
            guess = tables[row + START_ROLL]
            work.sides[0].best_y = tables[row + START_LEFT]
            work.sides[1].best_y = tables[row + START_RIGHT]
            warm = 1
    return solve_roll(tables, work, state, guess, warm)


def side_force(work: Work, index: int):
    """The prescribed force of side ``index`` [N], with load transfer."""
    sign = float(2 * index - 1)
    return work.inputs.normal_force * (1.0 + sign * work.inputs.load_transfer)


def is_wanted(tables: Tables, index: int):
    """1 if the outputs of side ``index`` are wanted, else 0."""
    wanted = 0
    if int(tables.sides) == SIDES_BOTH or int(tables.sides) == SIDES_LEFT + index:
        wanted = 1
    return wanted


def stand_rigid(tables: Tables, work: Work, state: State, roll: float):
    """Rigid contact: both wheels touch at ``roll``, and each carries its load there; the outcome."""
    status = VALID
    work.outputs.roll = roll
    work.outputs.vertical_shift = work.sides[1].best
    for index in range(2):
        clear_resultant(work.supports[index].resultant)
    for index in range(2):
        if is_wanted(tables, index) == 1:
            outcome = step_side(tables, work, state, index, side_force(work, index))
            if outcome > status:
                status = outcome
    return status


def stand_elastic(tables: Tables, work: Work, state: State, rigid_roll: float):
    """Elastic contact: the height and roll at which both wheels carry their loads; the outcome."""
    roll, status = solve_elastic(tables, work, state, rigid_roll, side_force(work, 0), side_force(work, 1))
    work.outputs.roll = roll
    work.outputs.vertical_shift = 0.5 * (work.supports[0].height
                                                     + work.supports[1].height)
    return status


def remember(work: Work, state: State, roll: float):
    """Keep where the rigid wheelset stood, for the next search."""
    state.roll = roll
    state.y_left = work.sides[0].best_y
    state.y_right = work.sides[1].best_y
    state.shift = work.inputs.lateral_shift
    state.warm = 1.0
    return 0


def withhold(tables: Tables, work: Work):
    """Take back what is not wanted of the outputs; the resultant needs both sides and their loads."""
    for index in range(2):
        first = first_unwanted(tables)
        if is_wanted(tables, index) == 0:
            first = 0
        if first < SIDE_SIZE:
            clear_from(tables, work, work.outputs.left[index], first)
    partial = int(tables.sides) != SIDES_BOTH or int(tables.depth) == DEPTH_GEOMETRY
    if partial and int(tables.mode) == MODE_RIGID:
        for i in range(3):
            work.outputs.force[i] = tables.absent
            work.outputs.moment[i] = tables.absent
    return 0


def evaluate(tables: Tables, work: Work, state: State):
    """Evaluate the wheelset at the workspace's inputs into its outputs; the status."""
    if inputs_valid(work) == 0:
        return INVALID_INPUT
    if inputs_in_range(tables, work) == 0:
        return OFF_PROFILE
    mode = int(tables.mode)
    status = VALID
    if mode == MODE_COMPLIANT:
        status = stand_compliant(tables, work, state)
    else:
        roll, status = find_roll(tables, work, state)
        if status != VALID:
            return status
        if mode == MODE_RIGID:
            status = stand_rigid(tables, work, state, roll)
        if status <= UNLOADED:
            remember(work, state, roll)
        if mode == MODE_ELASTIC:
            status = stand_elastic(tables, work, state, roll)
    write_resultant(tables, work, work.supports[0].resultant, work.supports[1].resultant)
    withhold(tables, work)
    return status


def step_row(tables: Tables, state: State, workspace: Work, inputs: 'float[:]', outputs: 'float[:]',
             row: int):
    """Evaluate row ``row`` of ``inputs`` into that of ``outputs``; the status.  Inputs as before are not evaluated again."""
    changed = 1
    if workspace.known == 1.0:
        changed = 0
    for i in range(INPUT_COUNT):
        if not workspace[WORK_INPUTS + i] == inputs[INPUT_COUNT * row + i]:
            changed = 1
        workspace[WORK_INPUTS + i] = inputs[INPUT_COUNT * row + i]
    status = int(workspace.status)
    if changed == 1:
        workspace.known = 0.0
        status = evaluate(tables, workspace, state)
    if status <= UNLOADED:
        workspace.known = 1.0
        workspace.status = float(status)
        size = row_size(tables)
        for i in range(size):
            outputs[size * row + i] = workspace[WORK_OUTPUTS + i]
    return status


def step(tables: Tables, state: State, workspace: Work, inputs: 'float[:]', outputs: 'float[:]'):
    """Evaluate one wheelset at ``inputs`` into ``outputs``; the status.

    Outputs keep their values unless the status is VALID or UNLOADED.  ``state`` holds where the next roll search
    starts; it never changes an answer.
    """
    return step_row(tables, state, workspace, inputs, outputs, 0)


def step_many(count: int, tables: Tables, state: State, workspace: Work, inputs: 'float[:]',
              outputs: 'float[:]', statuses: 'float[:]'):
    """Evaluate ``count`` rows of inputs, one after the other."""
    for row in range(count):
        statuses[row] = float(step_row(tables, state, workspace, inputs, outputs, row))
    return 0
