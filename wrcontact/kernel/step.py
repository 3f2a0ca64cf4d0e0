"""One step of a wheelset: from pose and load to contact positions, roll and patches.

The recipe: check the inputs, find the roll at which both wheels touch, describe each contact, solve its normal contact.
"""

from math import atan, fabs, isfinite
from typing import Final

from .contact_plane import open_frame
from .gap import vertical_gap
from .layout import (PLACE_BLOCK, IN_LATERAL_SHIFT, IN_LOAD_TRANSFER, IN_NORMAL_FORCE, IN_ROLL_GUESS, IN_YAW, INPUT_COUNT,
                     INVALID_INPUT, NOT_CONVERGED, OFF_PROFILE, OUT_LEFT, OUT_RIGHT, OUT_ROLL, OUT_VERTICAL_SHIFT,
                     OUTPUT_COUNT, SET_LATERAL_LIMIT, SET_PENETRATION_LEFT, SET_RADIUS, SET_RAIL, SET_RAIL_Y,
                     SET_WHEEL, SET_YAW_LIMIT, SIDE_BEST, SIDE_BEST_Y, SIDE_CONTACT_ANGLE, SIDE_CURVATURE_X,
                     SIDE_CURVATURE_Y, SIDE_ROLLING_RADIUS, SIDE_SIZE, SIDE_X_TRACK, SIDE_X_WHEEL, SIDE_Y_RAIL,
                     SIDE_Y_TRACK, SIDE_Y_WHEEL, SIDE_Z_RAIL, SIDE_Z_TRACK, SIDE_Z_WHEEL, STATE_ROLL, STATE_WARM, STATE_Y_LEFT, STATE_Y_RIGHT,
                     UNLOADED, VALID, WORK_INPUTS, WORK_OUTPUTS, WORK_PLACE, WORK_SIDE, SIDE_BLOCK)
from .locus import (PLACE_ARM, PLACE_COS_ROLL, PLACE_COS_YAW, PLACE_SIN_ROLL, PLACE_SIN_YAW, around_wheel,
                    outline_point)
from .normal_contact import solve_normal
from .profile_table import height_slope, height_slope_bend
from .regions import REGION_BEND, REGION_CURVATURE, open_contact_region, region_block
from .roll import solve_roll

#: The slopes of wheel and rail agree to this at a contact [-]; more means that the smallest gap lies at a profile's end.
PARALLEL: Final[float] = 1e-6


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


def describe_contact(tables: 'float[:]', work: 'float[:]', state: 'float[:]', index: int, shift: float):
    """Positions, angle, radius and curvatures of side ``index`` (0 left, 1 right); opens its contact plane.

    1 if the profiles are parallel at the smallest gap, else 0.
    """
    side = WORK_SIDE + SIDE_BLOCK * index
    at = WORK_PLACE + PLACE_BLOCK * index
    out = WORK_OUTPUTS + OUT_LEFT + (OUT_RIGHT - OUT_LEFT) * index
    y = work[side + SIDE_BEST_Y]
    gap, mismatch, rate = vertical_gap(tables, work, at, y)
    z, slope, bend = height_slope_bend(tables, int(tables[SET_WHEEL]), y)
    y_track, z_track, outline_slope = outline_point(work, at, y, z, slope)
    abscissa = y_track - tables[SET_RAIL_Y]
    z_rail, rail_slope = height_slope(tables, int(tables[SET_RAIL]), abscissa)
    sin_phi, cos_phi = around_wheel(work, at, slope)
    r = tables[SET_RADIUS] + z
    lateral = (work[at + PLACE_ARM] + y) * work[at + PLACE_COS_ROLL] - r * cos_phi * work[at + PLACE_SIN_ROLL]
    work[out + SIDE_X_WHEEL] = r * sin_phi
    work[out + SIDE_Y_WHEEL] = y
    work[out + SIDE_Z_WHEEL] = r * cos_phi - tables[SET_RADIUS]
    work[out + SIDE_Y_RAIL] = abscissa
    work[out + SIDE_Z_RAIL] = z_rail
    work[out + SIDE_X_TRACK] = work[at + PLACE_COS_YAW] * r * sin_phi - work[at + PLACE_SIN_YAW] * lateral
    work[out + SIDE_Y_TRACK] = y_track
    if index == 0:
        work[out + SIDE_Y_TRACK] = -y_track
    work[out + SIDE_Z_TRACK] = z_rail
    work[out + SIDE_CONTACT_ANGLE] = -atan(rail_slope)
    work[out + SIDE_ROLLING_RADIUS] = r
    open_frame(tables, work, at, y, shift)
    open_contact_region(tables, work, state)
    work[out + SIDE_CURVATURE_X] = work[region_block(0) + REGION_CURVATURE]
    work[out + SIDE_CURVATURE_Y] = work[region_block(0) + REGION_BEND]
    parallel = 0
    if fabs(mismatch) < PARALLEL:
        parallel = 1
    return parallel


def step_side(tables: 'float[:]', work: 'float[:]', state: 'float[:]', index: int, shift: float, force: float):
    """Contact and patches of one side; its outcome."""
    side = WORK_SIDE + SIDE_BLOCK * index
    out = WORK_OUTPUTS + OUT_LEFT + (OUT_RIGHT - OUT_LEFT) * index
    for i in range(SIDE_SIZE):
        work[out + i] = 0.0
    status = VALID
    if describe_contact(tables, work, state, index, shift) == 0:
        status = OFF_PROFILE
    else:
        penetration = tables[SET_PENETRATION_LEFT + index]
        if force > 0.0 or penetration > 0.0:
            if solve_normal(tables, work, state, side, out, force, penetration) == 0:
                status = NOT_CONVERGED
        else:
            status = UNLOADED
    return status


def find_roll(tables: 'float[:]', work: 'float[:]', state: 'float[:]'):
    """Roll [rad] and outcome; starts at the given guess, or at the last roll and contacts where none is given."""
    guess = work[WORK_INPUTS + IN_ROLL_GUESS]
    warm = 0
    if state[STATE_WARM] == 1.0 and guess == 0.0:
        guess = state[STATE_ROLL]
        work[WORK_SIDE + SIDE_BEST_Y] = state[STATE_Y_LEFT]
        work[WORK_SIDE + SIDE_BLOCK + SIDE_BEST_Y] = state[STATE_Y_RIGHT]
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
        force = work[WORK_INPUTS + IN_NORMAL_FORCE] * (1.0 + sign * work[WORK_INPUTS + IN_LOAD_TRANSFER])
        shift = work[WORK_SIDE + SIDE_BLOCK * index + SIDE_BEST]
        outcome = step_side(tables, work, state, index, shift, force)
        if outcome > status:
            status = outcome
    if status <= UNLOADED:
        state[STATE_ROLL] = roll
        state[STATE_Y_LEFT] = work[WORK_SIDE + SIDE_BEST_Y]
        state[STATE_Y_RIGHT] = work[WORK_SIDE + SIDE_BLOCK + SIDE_BEST_Y]
        state[STATE_WARM] = 1.0
    return status


def step_row(tables: 'float[:]', state: 'float[:]', workspace: 'float[:]', inputs: 'float[:]', outputs: 'float[:]',
             row: int):
    """Evaluate row ``row`` of ``inputs`` into that of ``outputs``; the status."""
    for i in range(INPUT_COUNT):
        workspace[WORK_INPUTS + i] = inputs[INPUT_COUNT * row + i]
    status = evaluate(tables, workspace, state)
    if status <= UNLOADED:
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
