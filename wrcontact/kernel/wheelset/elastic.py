"""Elastic equilibrium: the height and roll at which both wheels carry their loads.

The wheels are pressed into their rails. At a given roll each side has one height at which it carries its
load; where these heights are equal the wheelset is in equilibrium. Their difference D(roll) = height_right -
height_left falls as that of the rigid gaps does (:mod:`roll`), and a small load leaves the gaps themselves.
How a side's height follows the roll,

    d height / d roll = sum k_i cos(angle_i) G_i / sum k_i cos(angle_i),

is the mean of its regions' rigid levers G_i = gap_per_roll, weighted by their stiffnesses k_i: Newton's
slope, by the envelope theorem (docs/theory/elastic.md).

Both unknowns are found by Newton's method, in trials (residuals.py).  A wheel's residual depends on little more
than how deep it stands, so that what a move has changed says by which factor its derivatives are wrong; where
a move leaves it nearly as deep, they are renewed by Broyden's formula (Broyden 1965).  Where this finds
nothing, brackets do (brackets.py).
"""

from math import fabs
from typing import Final

from ..contact.penetrated import limited
from ..elementary.pair import solve_pair
from ..layout import (
    NOT_CONVERGED,
    OFF_PROFILE,
    ROLL_LIMIT,
    UNLOADED,
    VALID,
    Broyden,
    Supports,
    Tables,
    Work,
    seldom,
)
from ..normal.normal_contact import has_coarse_form, residual_rate
from .brackets import bracket_roll
from .enclosing import enclose_equilibrium, gaps_hold, ELASTIC_SHARP, NOT_LAST, LONGEST_MOVE, LEAST_LEVER
from .side import begin_trial, side_lever
from .residuals import balance_both, depth_status, estimate_approach, turn_near, turn_to

#: Broyden's method needs eight trials; what it has not found after so many, it will not.
TRIALS: Final[int] = 18
#: Nor will it where so many trials in a row have found no smaller residuals: there it alternates between the two
#: sides of a jump.
STALLED: Final[float] = 5.0
#: Strips are solved coarsely in the first trials, until a move is shorter [m]: the residual that it leaves is
#: then as large as what is off in coarse penetrations.
COARSE: Final[float] = 1.5e-5
#: After a longer move [m] Broyden's formula is taken: it finds the way among several equilibria.
NEAR: Final[float] = 2e-6
#: Of a side's expected change, this share of its two parts' sizes has to be left for a factor to be found
#: from it, and the factor has to lie between SMALLEST_FACTOR and its inverse [-].
CLEAR_SHARE: Final[float] = 0.15
SMALLEST_FACTOR: Final[float] = 0.5
#: Larger than any sum of residuals [m].
FARTHEST: Final[float] = 1.0
#: Smallest determinant of the residuals' derivatives [-]; -(lever_left + lever_right) / arm
#: to begin with, 0.3 ... 2.
SINGULAR: Final[float] = 0.02


@seldom
def solve_elastic(tables: Tables, work: Work, roll: float, left: float, right: float):
    """Roll [rad] of the wheelset in equilibrium under ``left`` and ``right`` [N], and the status; outputs
    are those of the two sides. Starts at the rigid ``roll``, whose smallest gaps are known."""
    status = estimate_approach(tables, work, 0, left)
    if status == VALID:
        status = estimate_approach(tables, work, 1, right)
    if status != VALID:
        return roll, status
    height, move = first_estimate(tables, work)
    rigid_roll = roll
    roll += move
    if not turn_near(tables, work, roll):
        return roll, OFF_PROFILE
    roll, status = iterate(tables, work, roll, height, left, right)
    begin_trial(work.contact, True, False, False)
    if status == NOT_CONVERGED:
        roll, status = enclose_equilibrium(
            tables, work, work.broyden.best_roll, work.broyden.best_height, left, right
        )
    if status == NOT_CONVERGED:
        work.contact.filling = True
        roll, status = bracket_roll(tables, work, rigid_roll, left, right)
    return roll, status


@seldom
def first_estimate(tables: Tables, work: Work):
    """Height [m] and move of the roll [rad] in equilibrium, if each wheel approaches
    its rail as far as estimated."""
    left = work.supports[0]
    right = work.supports[1]
    lever_left = side_lever(tables, work, 0, 0)
    lever_right = side_lever(tables, work, 1, 0)
    move = 0.0
    if lever_left + lever_right < -LEAST_LEVER:
        move = (right.approach - left.approach) / -(lever_left + lever_right)
    move = limited(move, LONGEST_MOVE / tables.arm)
    # in one order for a wheelset and its mirror image
    height = work.sides[0].best + 0.5 * (
        (left.approach - lever_left * move) + (right.approach + lever_right * move)
    )
    return height, move


@seldom
def iterate(tables: Tables, work: Work, roll: float, height: float, left: float, right: float):
    """Roll [rad] in equilibrium by Broyden's method from ``roll`` and ``height`` on, and the status;
    NOT_CONVERGED where it finds nothing."""
    method = work.broyden
    arm = tables.arm
    method.left = 0.0
    method.right = 0.0
    method.move_height = 0.0
    method.move_roll = 0.0
    method.best = FARTHEST
    method.best_height = height
    method.best_roll = roll
    work.contact.coarse = has_coarse_form(tables)
    for trial in range(TRIALS):
        moved = fabs(method.move_height) + fabs(method.move_roll)
        work.contact.filling = False
        followed = work.contact.following
        work.contact.following = trial > 0
        if trial > 0 and work.contact.coarse and moved < COARSE:
            work.contact.coarse = False
            # the change to the whole model does not show how residuals follow a move, nor which are smallest
            method.best = FARTHEST
            method.move_height = 0.0
            method.move_roll = 0.0
        elif trial > 0 and moved < NOT_LAST:
            work.contact.filling = True
            work.contact.following = False
            if followed:
                # nor does the change from points that are followed to those of a search
                method.move_height = 0.0
                method.move_roll = 0.0
        status = balance_both(tables, work, left, right, height)
        if status > UNLOADED:
            return roll, NOT_CONVERGED
        if trial == 0:
            begin_derivatives(method, work.supports, arm, residual_rate(tables))
        note_best(method, work.supports, height, roll)
        update(
            method,
            work.supports[0].height - height,
            work.supports[1].height - height,
            fabs(method.move_height) + fabs(method.move_roll) < NEAR,
        )
        if method.stalled > STALLED or not find_move(method, work.supports, arm, residual_rate(tables)):
            return roll, NOT_CONVERGED
        if fabs(method.move_height) < ELASTIC_SHARP and fabs(method.move_roll) < ELASTIC_SHARP:
            if work.contact.filling and gaps_hold(tables, work, roll):
                for index in range(2):
                    work.supports[index].height = height + method.move_height
                return roll + method.move_roll / arm, depth_status(work, status)
            # the same place again, with patches, or with the smaller gap that was found
            method.move_height = 0.0
            method.move_roll = 0.0
        elif work.contact.filling and fabs(method.move_height) + fabs(method.move_roll) > NOT_LAST:
            return roll, NOT_CONVERGED
        method.move_height = limited(method.move_height, LONGEST_MOVE)
        method.move_roll = limited(method.move_roll, LONGEST_MOVE)
        height += method.move_height
        roll += method.move_roll / arm
        if not fabs(roll) < ROLL_LIMIT:
            return roll, NOT_CONVERGED
        if not turn_near(tables, work, roll):
            return roll, NOT_CONVERGED
    return roll, NOT_CONVERGED


@seldom
def note_best(method: Broyden, supports: Supports, height: float, roll: float):
    """Note ``height`` [m] and ``roll`` [rad] of the trial if its residuals are the smallest so far, else that
    it has found no smaller ones."""
    lack = fabs(supports[0].height - height) + fabs(supports[1].height - height)
    method.stalled += 1.0
    if lack < method.best:
        method.stalled = 0.0
        method.best = lack
        method.best_height = height
        method.best_roll = roll


@seldom
def begin_derivatives(method: Broyden, supports: Supports, arm: float, rate: float):
    """The residuals' derivatives from both levers [m] and the ``rate`` at which they fall with the height."""
    method.left_height = -rate
    method.right_height = -rate
    method.left_roll = -rate * supports[0].lever / arm
    method.right_roll = rate * supports[1].lever / arm


@seldom
def update(method: Broyden, left: float, right: float, near: bool):
    """The residuals of a trial, ``left`` and ``right``, and the derivatives that the last move has shown;
    ``near`` says whether that was a small one."""
    before_left = method.left
    before_right = method.right
    method.left = left
    method.right = right
    if fabs(method.move_height) + fabs(method.move_roll) > 0.0:
        method.left_height, method.left_roll = renewed(
            method, method.left_height, method.left_roll, method.left - before_left, near
        )
        method.right_height, method.right_roll = renewed(
            method, method.right_height, method.right_roll, method.right - before_right, near
        )


@seldom
def renewed(method: Broyden, by_height: float, by_roll: float, change: float, near: bool):
    """A side's derivatives, by which the last move changes its residual by as much as it has."""
    height = by_height * method.move_height
    roll = by_roll * method.move_roll
    expected = height + roll
    if near and fabs(expected) > CLEAR_SHARE * (fabs(height) + fabs(roll)):
        factor = change / expected
        if factor > SMALLEST_FACTOR and factor * SMALLEST_FACTOR < 1.0:
            return factor * by_height, factor * by_roll
    size = method.move_height * method.move_height + method.move_roll * method.move_roll
    off = (change - expected) / size
    return by_height + off * method.move_height, by_roll + off * method.move_roll


@seldom
def find_move(method: Broyden, supports: Supports, arm: float, rate: float) -> bool:
    """The move of height and roll that lets the residuals vanish; whether there is one."""
    determinant, height, roll = solve_residuals(method)
    if not fabs(determinant) > SINGULAR:
        begin_derivatives(method, supports, arm, rate)
        determinant, height, roll = solve_residuals(method)
        if not fabs(determinant) > SINGULAR:
            return False
    method.move_height = height
    method.move_roll = roll
    return True


@seldom
def solve_residuals(method: Broyden):
    """Determinant of the residuals' derivatives [-], and the moves of height and roll that they ask for [m]."""
    return solve_pair(
        method.left,
        method.right,
        method.left_height,
        method.left_roll,
        method.right_height,
        method.right_roll,
    )
