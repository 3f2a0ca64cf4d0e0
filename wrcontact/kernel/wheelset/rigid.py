"""Rigid contact: the roll at which both wheels touch, and the load that each carries there."""

from math import fabs, isfinite
from typing import Final

from ..layout import NOT_CONVERGED, OFF_PROFILE, VALID, State, Tables, Work
from ..search.first_root import solve_roll
from ..search.roll import nearest_start
from .rolled_rails import (
    MEETINGS,
    RIGID_MET,
    has_rolled_rail,
    next_reference,
    note_reference,
    open_reference,
    set_reference,
)
from .input_checks import counted_status, is_needed, side_force
from .side import clear_side, solve_side
from .residuals import DEEPEST

#: After a longer lateral move the search does not start at the last contacts [m].
NEAR_SHIFT: Final[float] = 2e-4


def find_roll(tables: Tables, work: Work, state: State):
    """Roll [rad] and status; starts at the given guess, or at the last roll and contacts if the wheelset has
    moved little, or at those known near its lateral shift."""
    shift = work.inputs.lateral_shift
    guess = work.inputs.roll_guess
    warm = False
    if guess == 0.0:
        row = nearest_start(tables.starts, shift)
        if state.warm and (row < 0 or fabs(shift - state.shift) < NEAR_SHIFT):
            guess = state.roll
            work.sides[0].best_y = state.y_left
            work.sides[1].best_y = state.y_right
            warm = True
        elif row >= 0:
            start = tables.starts.rows[row]
            guess = start.roll
            work.sides[0].best_y = start.left
            work.sides[1].best_y = start.right
            warm = True
    set_reference(work.sides, 0.0)
    roll, status = solve_roll(tables, work.inputs, work.sides, work.trials, guess, warm)
    if status == VALID and has_rolled_rail(work.sides):
        roll, status = find_roll_on_rolled_rails(tables, work, roll)
    return roll, status


def find_roll_on_rolled_rails(tables: Tables, work: Work, roll: float):
    """Roll [rad] and status over rolled rails, from the ``roll`` that was found for a reference of zero
    on: both are sought together with the vertical shift."""
    open_reference(work.reference, 0.0, work.sides[1].best)
    for i in range(MEETINGS):
        height = next_reference(work.reference, RIGID_MET)
        set_reference(work.sides, height)
        roll, status = solve_roll(tables, work.inputs, work.sides, work.trials, roll, True)
        if status != VALID:
            return roll, status
        if note_reference(work.reference, height, work.sides[1].best, RIGID_MET):
            return roll, VALID
    return roll, NOT_CONVERGED


def solve_rigid(tables: Tables, work: Work, roll: float):
    """Both wheels touch at ``roll``, and each carries its load there; the status."""
    status = VALID
    work.wheelset.roll = roll
    work.wheelset.vertical_shift = work.sides[1].best
    clear_side(work.sides[0])
    clear_side(work.sides[1])
    for index in range(2):
        if is_needed(tables, work.inputs, index):
            side_status = solve_side(tables, work, index, side_force(work, index))
            status = counted_status(tables, index, status, side_status)
    return status


def penetration_status(tables: Tables, work: Work, status: int):
    """``status``, or OFF_PROFILE if a rigid wheel carries its load deeper in its rail than DEEPEST, which the
    other modes refuse too.  A penetration that is prescribed is taken as it is."""
    for index in range(2):
        if not isfinite(tables.penetration[index]) and work.sides[index].penetration > DEEPEST:
            status = OFF_PROFILE
    return status


def keep_roll(work: Work, state: State, roll: float):
    """Keep where both wheels touched, for the next search."""
    state.roll = roll
    state.y_left = work.sides[0].best_y
    state.y_right = work.sides[1].best_y
    state.shift = work.inputs.lateral_shift
    state.warm = True
