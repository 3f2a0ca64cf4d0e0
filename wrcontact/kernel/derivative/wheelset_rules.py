"""How a step's results follow its inputs: what is found by iteration, differentiated implicitly.

``tools/differentiate`` differentiates the kernel along a seed of its inputs, statement by statement. That
does not work for a search or an iteration: its steps do not follow the inputs as its result does. The
equation that the result solves gives its rate. From r(x, p) = 0 follows

    dx = -(dr/dp dp) / (dr/dx)

Each iteration has one rule: it takes the kernel's own result, evaluates the equation there with rates, and
gives the result the rate that follows. Values stay as they are. contact_rules.py has the rules of
the rooms contact and normal, motion_rules.py those of yaw and velocities, compliant_rules.py those of rails on
springs, turning_rules.py those of free rolling, this file the wheelset and the whole step, ``differentiate``.
The files are inputs of ``tools/differentiate`` and are not translated themselves; intrinsics.py has the words in which
they speak of rates.
"""

from math import fabs

from ..layout import MODE_COMPLIANT, MODE_ELASTIC, MODE_RIGID, Tables, Work
from ..surface.gap import gap_per_roll, vertical_gap
from ..wheelset.enclosing import UNBALANCED
from ..wheelset.forces import sum_forces
from ..wheelset.free_rolling import turns_freely
from ..wheelset.input_checks import is_moving, side_force
from ..wheelset.rolled_rails import set_reference
from ..wheelset.rolling_contact import move_patches, move_wheelset, solve_creep_forces
from ..wheelset.report import report
from ..wheelset.rigid import solve_rigid
from ..wheelset.residuals import balance_side
from ..wheelset.vertical_load import carried_share, carries_friction
from .compliant_rules import follow_compliant, follow_minimum
from .intrinsics import held, moving, nonzero, rate_of, seeded
from .motion_rules import follow_rates, place_moving
from .turning_rules import follow_turning


def follow_roll(tables: Tables, work: Work):
    """The rigid roll [rad], at which both smallest gaps are equal: a gap's place does not count for
    how it follows the roll."""
    roll = held(work.wheelset.roll)
    place_moving(tables, work, work.inputs, roll)
    left = held(work.sides[0].best_y)
    right = held(work.sides[1].best_y)
    gap_left, mismatch_left, rate_left = vertical_gap(tables.pairs[0], work.sides[0].place, left)
    gap_right, mismatch_right, rate_right = vertical_gap(tables.pairs[1], work.sides[1].place, right)
    lever = gap_per_roll(tables.pairs[1], work.sides[1].place, right) + gap_per_roll(
        tables.pairs[0], work.sides[0].place, left
    )
    return moving(roll, -(gap_right - gap_left) / held(lever))


def follow_gaps(tables: Tables, work: Work, roll: float, height: float):
    """How much lower than ``height`` [m] the smallest gaps of the left and the right side are [m], for this
    ``roll`` and this reference."""
    set_reference(work.sides, height)
    place_moving(tables, work, work.inputs, roll)
    left, mismatch, rate = vertical_gap(tables.pairs[0], work.sides[0].place, held(work.sides[0].best_y))
    right, mismatch, rate = vertical_gap(tables.pairs[1], work.sides[1].place, held(work.sides[1].best_y))
    return left - height, right - height


def follow_roll_on_rolled_rails(tables: Tables, work: Work):
    """The rigid roll [rad] over rolled rails: roll and vertical shift let both gaps end at the reference,
    which moves with them."""
    roll = held(work.wheelset.roll)
    height = held(work.wheelset.vertical_shift)
    left, right = follow_gaps(tables, work, roll, height)
    residual_left = rate_of(left)
    residual_right = rate_of(right)
    left, right = follow_gaps(tables, work, roll, seeded(height, 1.0))
    left_height = rate_of(left) - residual_left
    right_height = rate_of(right) - residual_right
    left, right = follow_gaps(tables, work, seeded(roll, 1.0), height)
    left_roll = rate_of(left) - residual_left
    right_roll = rate_of(right) - residual_right
    determinant = left_height * right_roll - right_height * left_roll
    height_rate = (residual_right * left_roll - residual_left * right_roll) / determinant
    roll_rate = (residual_left * right_height - residual_right * left_height) / determinant
    set_reference(work.sides, seeded(height, height_rate))
    return seeded(roll, roll_rate)


def follow_position(tables: Tables, work: Work, roll: float, height: float):
    """Both sides of an elastic wheelset at ``roll`` and ``height``, each under its load."""
    set_reference(work.sides, height)
    place_moving(tables, work, work.inputs, roll)
    follow_minimum(tables, work, 0)
    balance_side(tables, work, 0, side_force(work, 0), height)
    follow_minimum(tables, work, 1)
    balance_side(tables, work, 1, side_force(work, 1), height)


def follow_elastic(tables: Tables, work: Work) -> bool:
    """The elastic position: the residuals of both sides' heights vanish, over height and roll.

    Whether it does not: then the wheelset is where a side's load jumps past its force
    (enclosing.stand_at_jump), and no equation gives the rate of that place.
    """
    roll = work.wheelset.roll
    height = work.wheelset.vertical_shift
    left = work.supports[0]
    right = work.supports[1]
    follow_position(tables, work, held(roll), held(height))
    if fabs(left.height - height) + fabs(right.height - height) > UNBALANCED:
        return True
    residual_left = rate_of(left.height)
    residual_right = rate_of(right.height)
    follow_position(tables, work, held(roll), seeded(height, 1.0))
    left_height = rate_of(left.height) - residual_left - 1.0
    right_height = rate_of(right.height) - residual_right - 1.0
    follow_position(tables, work, seeded(roll, 1.0), held(height))
    left_roll = rate_of(left.height) - residual_left
    right_roll = rate_of(right.height) - residual_right
    determinant = left_height * right_roll - right_height * left_roll
    if not nonzero(determinant):
        return True
    height_rate = (residual_right * left_roll - residual_left * right_roll) / determinant
    roll_rate = (residual_left * right_height - residual_right * left_height) / determinant
    follow_position(tables, work, seeded(roll, roll_rate), seeded(height, height_rate))
    work.wheelset.roll = seeded(roll, roll_rate)
    work.wheelset.vertical_shift = seeded(height, height_rate)
    return False


def differentiate(tables: Tables, work: Work) -> bool:
    """Let the outputs of a step that was VALID or UNLOADED move with its inputs; the workspace is as the step
    left it; whether the rates are not defined (``follow_elastic``, ``follow_balanced``)."""
    undefined = follow_wheelset(tables, work)
    if carries_friction(tables, work):
        undefined = follow_load(tables, work)
    report(tables, work)
    return undefined


def follow_load(tables: Tables, work: Work) -> bool:
    """What friction leaves of the load: the vertical force of each wheel stays what is wanted, over the loads
    of both sides; whether the rates are not defined."""
    left = work.supports[0]
    right = work.supports[1]
    missing_left = rate_of(carried_share(work, 0))
    missing_right = rate_of(carried_share(work, 1))
    left.friction_load = seeded(left.friction_load, 1.0)
    follow_wheelset(tables, work)
    left_left = rate_of(carried_share(work, 0)) - missing_left
    right_left = rate_of(carried_share(work, 1)) - missing_right
    left.friction_load = held(left.friction_load)
    right.friction_load = seeded(right.friction_load, 1.0)
    follow_wheelset(tables, work)
    left_right = rate_of(carried_share(work, 0)) - missing_left
    right_right = rate_of(carried_share(work, 1)) - missing_right
    # a wheel without load has none to follow
    if not side_force(work, 0) > 0.0:
        left_left = 1.0
    if not side_force(work, 1) > 0.0:
        right_right = 1.0
    determinant = left_left * right_right - left_right * right_left
    left.friction_load = seeded(
        left.friction_load, (missing_right * left_right - missing_left * right_right) / determinant
    )
    right.friction_load = seeded(
        right.friction_load, (missing_left * right_left - missing_right * left_left) / determinant
    )
    return follow_wheelset(tables, work)


def follow_wheelset(tables: Tables, work: Work) -> bool:
    """Contact of both wheels, resultant, creepages and creep forces with their rates; whether the rates are
    not defined."""
    mode = tables.mode
    undefined = False
    if mode == MODE_RIGID:
        roll = follow_roll(tables, work)
        if work.sides[1].place.leaning:
            roll = follow_roll_on_rolled_rails(tables, work)
        place_moving(tables, work, work.inputs, roll)
        follow_minimum(tables, work, 0)
        follow_minimum(tables, work, 1)
        solve_rigid(tables, work, roll)
    if mode == MODE_ELASTIC:
        undefined = follow_elastic(tables, work)
    if mode == MODE_COMPLIANT:
        undefined = follow_compliant(tables, work)
    move_wheelset(tables, work)
    if mode == MODE_ELASTIC and is_moving(tables, work.inputs):
        if work.wheelset.settled and not undefined:
            follow_rates(tables, work)
    if turns_freely(tables, work):
        turning_undefined = follow_turning(tables, work)
        undefined = undefined or turning_undefined
    else:
        move_patches(tables, work)
        solve_creep_forces(tables, work)
    sum_forces(tables, work)
    return undefined
