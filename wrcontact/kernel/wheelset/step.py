"""One step of a wheelset: from pose and load to contact positions, roll and patches.

The recipe: check the inputs, find the roll at which both wheels touch, describe each contact, solve its normal contact.
"""

from math import fabs, isfinite
from typing import Final

from .elastic import solve_elastic, stand_compliant
from ..layout import (DEPTH_GEOMETRY, INPUT_COUNT, INVALID_INPUT, IN_LATERAL_SHIFT, IN_LOAD_TRANSFER, IN_NORMAL_FORCE,
                     IN_ROLL, IN_ROLL_GUESS, IN_YAW, MODE_COMPLIANT, MODE_ELASTIC, MODE_RIGID, OFF_PROFILE,
                     OUT_FORCE, OUT_MOMENT, OUT_ROLL, OUT_VERTICAL_SHIFT, SET_ABSENT, SET_DEPTH, SET_LATERAL_LIMIT,
                     SET_MODE, SET_SIDES, SET_YAW_LIMIT, SIDES_BOTH, SIDES_LEFT, SIDE_BEST, SIDE_BEST_Y, SIDE_BLOCK,
                     SIDE_SIZE, STATE_ROLL, STATE_SHIFT, STATE_WARM, STATE_Y_LEFT, STATE_Y_RIGHT, SUPPORT_BLOCK,
                     UNLOADED, VALID, WORK_INPUTS, WORK_KNOWN, WORK_OUTPUTS, WORK_SIDE, WORK_STATUS, WORK_SUPPORT)
from ..search.level import solve_roll
from ..patch.outline import row_size
from .resultant import clear_resultant, write_resultant
from ..search.roll import ROLL_LIMIT
from .side import SUPPORT_HEIGHT, clear_from, first_unwanted, side_outputs, side_resultant, step_side
from ..search.starts import START_LEFT, START_RIGHT, START_ROLL, nearest_start

#: After a longer lateral move the search does not start at the last contacts [m].
NEAR_SHIFT: Final[float] = 2e-4


def inputs_valid(work: 'float[:]'):
    """1 if all inputs are finite, the force is not negative and the load transfer within -1 ... 1, else 0."""
    valid = 1
    for i in range(INPUT_COUNT):
        if not isfinite(work[WORK_INPUTS + i]):
            valid = 0
    if valid == 1:
        if work[WORK_INPUTS + IN_NORMAL_FORCE] < 0.0 or fabs(work[WORK_INPUTS + IN_LOAD_TRANSFER]) > 1.0:
            valid = 0
    return valid


def inputs_in_range(tables: 'float[:]', work: 'float[:]'):
    """1 if shift and yaw are within the range of the profiles, else 0."""
    inside = 1
    if fabs(work[WORK_INPUTS + IN_LATERAL_SHIFT]) > tables[SET_LATERAL_LIMIT]:
        inside = 0
    if fabs(work[WORK_INPUTS + IN_YAW]) > tables[SET_YAW_LIMIT]:
        inside = 0
    if int(tables[SET_MODE]) == MODE_COMPLIANT and fabs(work[WORK_INPUTS + IN_ROLL]) > ROLL_LIMIT:
        inside = 0
    return inside


def find_roll(tables: 'float[:]', work: 'float[:]', state: 'float[:]'):
    """Roll [rad] and outcome; starts at the given guess, or at the last roll and contacts if the wheelset has moved little,
    or at those known near its lateral shift."""
    shift = work[WORK_INPUTS + IN_LATERAL_SHIFT]
    guess = work[WORK_INPUTS + IN_ROLL_GUESS]
    warm = 0
    if guess == 0.0:
        row = nearest_start(tables, shift)
        if state[STATE_WARM] == 1.0 and (row < 0 or fabs(shift - state[STATE_SHIFT]) < NEAR_SHIFT):
            guess = state[STATE_ROLL]
            work[WORK_SIDE + SIDE_BEST_Y] = state[STATE_Y_LEFT]
            work[WORK_SIDE + SIDE_BLOCK + SIDE_BEST_Y] = state[STATE_Y_RIGHT]
            warm = 1
        elif row >= 0:
            guess = tables[row + START_ROLL]
            work[WORK_SIDE + SIDE_BEST_Y] = tables[row + START_LEFT]
            work[WORK_SIDE + SIDE_BLOCK + SIDE_BEST_Y] = tables[row + START_RIGHT]
            warm = 1
    return solve_roll(tables, work, state, guess, warm)


def side_force(work: 'float[:]', index: int):
    """The prescribed force of side ``index`` [N], with load transfer."""
    sign = float(2 * index - 1)
    return work[WORK_INPUTS + IN_NORMAL_FORCE] * (1.0 + sign * work[WORK_INPUTS + IN_LOAD_TRANSFER])


def is_wanted(tables: 'float[:]', index: int):
    """1 if the outputs of side ``index`` are wanted, else 0."""
    wanted = 0
    if int(tables[SET_SIDES]) == SIDES_BOTH or int(tables[SET_SIDES]) == SIDES_LEFT + index:
        wanted = 1
    return wanted


def stand_rigid(tables: 'float[:]', work: 'float[:]', state: 'float[:]', roll: float):
    """Rigid contact: both wheels touch at ``roll``, and each carries its load there; the outcome."""
    status = VALID
    work[WORK_OUTPUTS + OUT_ROLL] = roll
    work[WORK_OUTPUTS + OUT_VERTICAL_SHIFT] = work[WORK_SIDE + SIDE_BLOCK + SIDE_BEST]
    for index in range(2):
        clear_resultant(work, side_resultant(index))
    for index in range(2):
        if is_wanted(tables, index) == 1:
            outcome = step_side(tables, work, state, index, side_force(work, index))
            if outcome > status:
                status = outcome
    return status


def stand_elastic(tables: 'float[:]', work: 'float[:]', state: 'float[:]', rigid_roll: float):
    """Elastic contact: the height and roll at which both wheels carry their loads; the outcome."""
    roll, status = solve_elastic(tables, work, state, rigid_roll, side_force(work, 0), side_force(work, 1))
    work[WORK_OUTPUTS + OUT_ROLL] = roll
    work[WORK_OUTPUTS + OUT_VERTICAL_SHIFT] = 0.5 * (work[WORK_SUPPORT + SUPPORT_HEIGHT]
                                                     + work[WORK_SUPPORT + SUPPORT_BLOCK + SUPPORT_HEIGHT])
    return status


def remember(work: 'float[:]', state: 'float[:]', roll: float):
    """Keep where the rigid wheelset stood, for the next search."""
    state[STATE_ROLL] = roll
    state[STATE_Y_LEFT] = work[WORK_SIDE + SIDE_BEST_Y]
    state[STATE_Y_RIGHT] = work[WORK_SIDE + SIDE_BLOCK + SIDE_BEST_Y]
    state[STATE_SHIFT] = work[WORK_INPUTS + IN_LATERAL_SHIFT]
    state[STATE_WARM] = 1.0
    return 0


def withhold(tables: 'float[:]', work: 'float[:]'):
    """Take back what is not wanted of the outputs; the resultant needs both sides and their loads."""
    for index in range(2):
        first = first_unwanted(tables)
        if is_wanted(tables, index) == 0:
            first = 0
        if first < SIDE_SIZE:
            clear_from(tables, work, side_outputs(index), first)
    partial = int(tables[SET_SIDES]) != SIDES_BOTH or int(tables[SET_DEPTH]) == DEPTH_GEOMETRY
    if partial and int(tables[SET_MODE]) == MODE_RIGID:
        for i in range(3):
            work[WORK_OUTPUTS + OUT_FORCE + i] = tables[SET_ABSENT]
            work[WORK_OUTPUTS + OUT_MOMENT + i] = tables[SET_ABSENT]
    return 0


def evaluate(tables: 'float[:]', work: 'float[:]', state: 'float[:]'):
    """Evaluate the wheelset at the workspace's inputs into its outputs; the status."""
    if inputs_valid(work) == 0:
        return INVALID_INPUT
    if inputs_in_range(tables, work) == 0:
        return OFF_PROFILE
    mode = int(tables[SET_MODE])
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
    write_resultant(tables, work, side_resultant(0), side_resultant(1))
    withhold(tables, work)
    return status


def step_row(tables: 'float[:]', state: 'float[:]', workspace: 'float[:]', inputs: 'float[:]', outputs: 'float[:]',
             row: int):
    """Evaluate row ``row`` of ``inputs`` into that of ``outputs``; the status.  Inputs as before are not evaluated again."""
    changed = 1
    if workspace[WORK_KNOWN] == 1.0:
        changed = 0
    for i in range(INPUT_COUNT):
        if not workspace[WORK_INPUTS + i] == inputs[INPUT_COUNT * row + i]:
            changed = 1
        workspace[WORK_INPUTS + i] = inputs[INPUT_COUNT * row + i]
    status = int(workspace[WORK_STATUS])
    if changed == 1:
        workspace[WORK_KNOWN] = 0.0
        status = evaluate(tables, workspace, state)
    if status <= UNLOADED:
        workspace[WORK_KNOWN] = 1.0
        workspace[WORK_STATUS] = float(status)
        size = row_size(tables)
        for i in range(size):
            outputs[size * row + i] = workspace[WORK_OUTPUTS + i]
    return status


def step(tables: 'float[:]', state: 'float[:]', workspace: 'float[:]', inputs: 'float[:]', outputs: 'float[:]'):
    """Evaluate one wheelset at ``inputs`` into ``outputs``; the status.

    Outputs keep their values unless the status is VALID or UNLOADED.  ``state`` holds where the next roll search
    starts; it never changes an answer.
    """
    return step_row(tables, state, workspace, inputs, outputs, 0)


def step_many(count: int, tables: 'float[:]', state: 'float[:]', workspace: 'float[:]', inputs: 'float[:]',
              outputs: 'float[:]', statuses: 'float[:]'):
    """Evaluate ``count`` rows of inputs, one after the other."""
    for row in range(count):
        statuses[row] = float(step_row(tables, state, workspace, inputs, outputs, row))
    return 0
