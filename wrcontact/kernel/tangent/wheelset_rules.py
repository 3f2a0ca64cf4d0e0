"""How a step's results follow its inputs: what is found by iteration, differentiated implicitly.

``tools/tangent`` differentiates the kernel along a seed of its inputs, statement by statement. That does not
work for a search or an iteration: its steps do not follow the inputs as its result does. The equation that
the result solves gives its rate. From r(x, p) = 0 follows

    dx = -(dr/dp dp) / (dr/dx)

Each iteration has one rule: it takes the kernel's own result, evaluates the equation there with rates, and
gives the result the rate that follows. Values stay as they are. contact_rules.py and normal_rules.py have the
rules of their rooms, this file the wheelset and the whole step, ``differentiate``. The files are inputs of
``tools/tangent`` and are not translated themselves; intrinsics.py has the words in which they speak of rates.
"""

from math import cos, fabs, sin

from ..layout import MODE_COMPLIANT, MODE_ELASTIC, MODE_RIGID, State, Tables, Work
from ..search.roll import place_both
from ..surface.gap import gap_per_roll, vertical_gap
from ..surface.locus import mirror_place, turn_wheelset
from ..wheelset.compliant import load_at_height
from ..wheelset.damping import is_damped
from ..wheelset.elastic import UNBALANCED
from ..wheelset.moving import is_rolling, open_given_motion, write_creepages
from ..wheelset.requested import omit_outputs, side_force
from ..wheelset.resultant import write_resultant
from ..wheelset.rigid import solve_rigid
from ..wheelset.trial import balance_side
from .intrinsics import held, moving, rate_of, seeded


def place_moving(tables: Tables, work: Work, roll: float):
    """Both wheels at ``roll``; one that begins to yaw is placed as a yawed one."""
    place_both(tables, work.inputs, work.sides, roll)
    yaw = work.inputs.yaw
    if yaw == 0.0 and rate_of(yaw) != 0.0:
        work.sides[1].place.sin_yaw = sin(yaw)
        work.sides[1].place.cos_yaw = cos(yaw)
        work.sides[1].place.yawed = True
        turn_wheelset(work.sides[1].place, roll)
        mirror_place(work.sides[1].place, work.sides[0].place)
    return 0


def follow_minimum(tables: Tables, work: Work, index: int):
    """Let the smallest gap of side ``index`` and its place move with the placed wheel: there the slopes of
    wheel and rail agree, mismatch(y) = 0."""
    side = work.sides[index]
    at = work.sides[index].place
    y = held(side.best_y)
    gap, mismatch, rate = vertical_gap(tables, at, y)
    y = moving(y, -mismatch / held(rate))
    gap, mismatch, rate = vertical_gap(tables, at, y)
    side.best_y = y
    side.best = moving(side.best, gap)
    return 0


def follow_roll(tables: Tables, work: Work):
    """The rigid roll [rad], at which both smallest gaps are equal: a gap's place does not count for
    how it follows the roll."""
    roll = held(work.outputs.roll)
    place_moving(tables, work, roll)
    left = held(work.sides[0].best_y)
    right = held(work.sides[1].best_y)
    gap_left, mismatch_left, rate_left = vertical_gap(tables, work.sides[0].place, left)
    gap_right, mismatch_right, rate_right = vertical_gap(tables, work.sides[1].place, right)
    lever = (gap_per_roll(tables, work.sides[1].place, right)
             + gap_per_roll(tables, work.sides[0].place, left))
    return moving(roll, -(gap_right - gap_left) / held(lever))


def follow_position(tables: Tables, work: Work, state: State, roll: float, height: float):
    """Both sides of an elastic wheelset at ``roll`` and ``height``, each under its load."""
    place_moving(tables, work, roll)
    for index in range(2):
        follow_minimum(tables, work, index)
        balance_side(tables, work, state, index, side_force(work.inputs, index), height)
    return 0


def follow_elastic(tables: Tables, work: Work, state: State):
    """The elastic position: the residuals of both sides' heights vanish, over height and roll.

    1 where it does not, else 0: then the wheelset is where a side's load jumps past its force
    (elastic.bracket_height), and no equation gives the rate of that place.
    """
    roll = work.outputs.roll
    height = work.outputs.vertical_shift
    left = work.supports[0]
    right = work.supports[1]
    follow_position(tables, work, state, held(roll), held(height))
    if fabs(left.height - height) + fabs(right.height - height) > UNBALANCED:
        return 1
    residual_left = rate_of(left.height)
    residual_right = rate_of(right.height)
    follow_position(tables, work, state, held(roll), seeded(height, 1.0))
    left_height = rate_of(left.height) - residual_left - 1.0
    right_height = rate_of(right.height) - residual_right - 1.0
    follow_position(tables, work, state, seeded(roll, 1.0), held(height))
    left_roll = rate_of(left.height) - residual_left
    right_roll = rate_of(right.height) - residual_right
    determinant = left_height * right_roll - right_height * left_roll
    if determinant == 0.0:
        return 1
    height_rate = (residual_right * left_roll - residual_left * right_roll) / determinant
    roll_rate = (residual_left * right_height - residual_right * left_height) / determinant
    follow_position(tables, work, state, seeded(roll, roll_rate), seeded(height, height_rate))
    work.outputs.roll = seeded(roll, roll_rate)
    work.outputs.vertical_shift = seeded(height, height_rate)
    return 0


def follow_compliant(tables: Tables, work: Work, state: State):
    """Both sides of a wheelset at the height and roll of the inputs."""
    roll = work.inputs.roll
    height = work.inputs.vertical_shift
    place_moving(tables, work, roll)
    work.outputs.roll = roll
    work.outputs.vertical_shift = height
    if is_damped(tables) == 1:
        open_given_motion(tables, work)
    for index in range(2):
        follow_minimum(tables, work, index)
        load_at_height(tables, work, state, index, height)
    return 0


def differentiate(tables: Tables, work: Work, state: State):
    """Let the outputs of a step that was VALID or UNLOADED move with its inputs; the workspace is as the step
    left it. 1 where the rates are not defined (``follow_elastic``), else 0."""
    mode = tables.mode
    outcome = 0
    if mode == MODE_RIGID:
        roll = follow_roll(tables, work)
        place_moving(tables, work, roll)
        for index in range(2):
            follow_minimum(tables, work, index)
        solve_rigid(tables, work, state, roll)
    if mode == MODE_ELASTIC:
        outcome = follow_elastic(tables, work, state)
    if mode == MODE_COMPLIANT:
        follow_compliant(tables, work, state)
    write_resultant(tables, work.inputs, work.outputs, work.supports[0].resultant, work.supports[1].resultant)
    if is_rolling(work.inputs) == 1:
        write_creepages(tables, work, state)
    omit_outputs(tables, work)
    return outcome
