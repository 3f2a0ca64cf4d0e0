"""Compliant contact: height and roll of the wheelset are given, and each wheel's load follows from
how deep it is in its rail."""

from typing import Final

from ..layout import OFF_PROFILE, VALID, State, Tables, Work
from ..patch.totals import write_patches
from ..search.roll import follow_side, place_both, search_both
from ..search.starts import nearest_start
from .damping import damp_patches, is_damped
from .leaning import set_reference
from .moving import open_given_motion
from .side import load_side, press_side, touch_side
from .trial import DEEPEST

#: A wheel that overlaps its rail by less than this [m], to which smallest gaps are known,
#: does not touch; 5e-9 N.
GRAZING: Final[float] = 1e-13


def solve_compliant(left_tables: Tables, right_tables: Tables, work: Work, state: State):
    """Both sides of the wheelset at the height and roll of the inputs; the outcome."""
    roll = work.inputs.roll
    height = work.inputs.vertical_shift
    set_reference(work.sides, height)
    place_both(left_tables, right_tables, work.inputs, work.sides, roll)
    work.outputs.roll = roll
    work.outputs.vertical_shift = height
    if is_damped(right_tables) == 1:
        open_given_motion(left_tables, right_tables, work)
    if search_both(left_tables, right_tables, work.sides, state,
                   follow_starts(left_tables, right_tables, work, state)) == 0:
        return OFF_PROFILE
    status = load_at_height(left_tables, work, state, 0, height)
    outcome = load_at_height(right_tables, work, state, 1, height)
    if outcome > status:
        status = outcome
    return status


def follow_starts(left_tables: Tables, right_tables: Tables, work: Work, state: State):
    """1 if both smallest gaps could be followed from where they are known near the lateral shift, else 0."""
    row = nearest_start(right_tables.starts, work.inputs.lateral_shift)
    known = 0
    if row >= 0:
        start = right_tables.starts.rows[row]
        work.sides[0].best_y = start.left
        work.sides[1].best_y = start.right
        known = follow_side(left_tables, work.sides[0], state)
        if known == 1:
            known = follow_side(right_tables, work.sides[1], state)
    return known


def load_at_height(tables: Tables, work: Work, state: State, index: int, height: float):
    """The load of a side whose wheelset has the vertical shift ``height`` [m]; its
    outcome, UNLOADED if lifted."""
    approach = height - work.sides[index].best
    if not approach > GRAZING:
        return touch_side(tables, work, state, index)
    if approach > DEEPEST:
        return OFF_PROFILE
    status = press_side(tables, work, state, index, approach)
    if status == VALID:
        count, status = load_side(tables, work, state, index, 0.0, work.contact.frame.depth)
    if status == VALID and is_damped(tables) == 1:
        damp_patches(tables, work.motion, work.contact.solved, index, work.supports[index].resultant)
        write_patches(work.contact.solved, work.outputs.left[index])
    return status
