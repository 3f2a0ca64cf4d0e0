"""One step of a wheelset: from pose and load to contact positions, roll and patches.

The recipe: check the inputs, find the roll at which both wheels touch, describe each contact, solve its normal contact.
"""

from math import fabs, isfinite
from typing import Final

from .contact_point import describe_contact
from .layout import (DEPTH_GEOMETRY, DEPTH_PATCHES, INPUT_COUNT, INVALID_INPUT, IN_LATERAL_SHIFT, IN_LOAD_TRANSFER,
                     IN_NORMAL_FORCE, IN_ROLL_GUESS, IN_YAW, NOT_CONVERGED, OFF_PROFILE, OUTPUT_COUNT, OUT_LEFT,
                     OUT_RIGHT, OUT_ROLL, OUT_VERTICAL_SHIFT, SET_ABSENT, SET_DEPTH, SET_LATERAL_LIMIT,
                     SET_PENETRATION_LEFT, SET_SIDES, SET_YAW_LIMIT, SIDES_BOTH, SIDES_LEFT, SIDE_BEST, SIDE_BEST_Y,
                     SIDE_BLOCK, SIDE_PATCH_COUNT, SIDE_PENETRATION, SIDE_SIZE, SIDE_STATION, STATE_ROLL, STATE_SHIFT,
                     STATE_WARM, STATE_Y_LEFT, STATE_Y_RIGHT, UNLOADED, VALID, WORK_INPUTS, WORK_KNOWN, WORK_OUTPUTS,
                     WORK_SIDE, WORK_STATUS)
from .normal_contact import solve_normal
from .roll import solve_roll
from .starts import START_LEFT, START_RIGHT, START_ROLL, nearest_start

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
    return inside


def clear_side(tables: 'float[:]', work: 'float[:]', out: int, first: int):
    """Zeros in a side's outputs; from ``first`` on what stands for outputs that are not wanted."""
    for i in range(first):
        work[out + i] = 0.0
    for i in range(first, SIDE_SIZE):
        work[out + i] = tables[SET_ABSENT]
    if first <= SIDE_PENETRATION:
        work[out + SIDE_PATCH_COUNT] = tables[SET_ABSENT]
    return 0


def step_side(tables: 'float[:]', work: 'float[:]', state: 'float[:]', index: int, shift: float, force: float):
    """Contact and patches of one side, as far as they are wanted; its outcome."""
    side = WORK_SIDE + SIDE_BLOCK * index
    out = WORK_OUTPUTS + OUT_LEFT + (OUT_RIGHT - OUT_LEFT) * index
    depth = int(tables[SET_DEPTH])
    first = SIDE_SIZE
    if depth == DEPTH_PATCHES:
        first = SIDE_STATION
    if depth == DEPTH_GEOMETRY:
        first = SIDE_PENETRATION
    clear_side(tables, work, out, first)
    status = VALID
    if describe_contact(tables, work, state, index, shift) == 0:
        status = OFF_PROFILE
    else:
        penetration = tables[SET_PENETRATION_LEFT + index]
        pressed = force
        if isfinite(penetration):
            pressed = penetration
        if not pressed > 0.0:
            status = UNLOADED
        elif depth != DEPTH_GEOMETRY:
            if solve_normal(tables, work, state, side, out, force, penetration) == 0:
                status = NOT_CONVERGED
    return status


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


def evaluate(tables: 'float[:]', work: 'float[:]', state: 'float[:]'):
    """Evaluate the wheelset at the workspace's inputs into its outputs; the status."""
    if inputs_valid(work) == 0:
        return INVALID_INPUT
    if inputs_in_range(tables, work) == 0:
        return OFF_PROFILE
    roll, status = find_roll(tables, work, state)
    if status != VALID:
        return status
    work[WORK_OUTPUTS + OUT_ROLL] = roll
    work[WORK_OUTPUTS + OUT_VERTICAL_SHIFT] = work[WORK_SIDE + SIDE_BLOCK + SIDE_BEST]
    for index in range(2):
        sign = float(2 * index - 1)
        outcome = VALID
        force = work[WORK_INPUTS + IN_NORMAL_FORCE] * (1.0 + sign * work[WORK_INPUTS + IN_LOAD_TRANSFER])
        shift = work[WORK_SIDE + SIDE_BLOCK * index + SIDE_BEST]
        if int(tables[SET_SIDES]) == SIDES_BOTH or int(tables[SET_SIDES]) == SIDES_LEFT + index:
            outcome = step_side(tables, work, state, index, shift, force)
        else:
            clear_side(tables, work, WORK_OUTPUTS + OUT_LEFT + (OUT_RIGHT - OUT_LEFT) * index, 0)
        if outcome > status:
            status = outcome
    if status <= UNLOADED:
        state[STATE_ROLL] = roll
        state[STATE_Y_LEFT] = work[WORK_SIDE + SIDE_BEST_Y]
        state[STATE_Y_RIGHT] = work[WORK_SIDE + SIDE_BLOCK + SIDE_BEST_Y]
        state[STATE_SHIFT] = work[WORK_INPUTS + IN_LATERAL_SHIFT]
        state[STATE_WARM] = 1.0
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
        for i in range(OUTPUT_COUNT):
            outputs[OUTPUT_COUNT * row + i] = workspace[WORK_OUTPUTS + i]
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
