"""Elastic equilibrium where trials that follow the deepest points find none, or contradict a search for them.

The height at which a wheel carries its load hardly depends on the height of the trial (elastic.py), so that
each trial gives D(roll) = height_right - height_left, and a better height for the next one.  Every trial now
searches for all deepest points.  So D is a function of the roll, which jumps where a region comes or goes.
Newton's method finds its root; where a step has not halved D, the bracket of the roll is cut: beside the jump of
one wheel where one is found (jumps.py), which takes some trials, else half way, which takes one for each bit.  If
it encloses a jump, no roll is an equilibrium, and the one of the jump is taken, at the height at which the wheel
that does not jump carries its load.
"""

from math import fabs
from typing import Final

from ..contact.penetrated import limited
from ..layout import NOT_CONVERGED, ROLL_LIMIT, UNLOADED, Bracket, Jump, Supports, Tables, Work, seldom
from ..normal.normal_contact import residual_rate
from .brackets import height_residual
from .jumps import find_jump
from .residuals import depth_status, turn_near, turn_to

#: Height and roll are found when either wheel moves by less [m], and this move is still made. Patches are
#: those before it: 1e-11 would let their differences over less than a micrometre miss their derivatives by up
#: to 1e-4.
ELASTIC_SHARP: Final[float] = 1e-13
#: After a longer move a trial is not the last one: it leaves out the patches, and follows the deepest points
#: of the one before instead of a search for all [m].
NOT_LAST: Final[float] = 1e-10
#: A smallest gap that has moved by less than this along the wheel is the same one, found anew [m].
SAME_GAP: Final[float] = 1e-9
#: Longest move of a wheel in one trial [m].
LONGEST_MOVE: Final[float] = 2e-4
#: Smallest sum of both levers [m] for a first estimate of the roll; flanges of 73 deg have none.
LEAST_LEVER: Final[float] = 1e-2
#: Trials at most, and how narrow the bracket of a jump becomes [m]: derivatives there are differences over
#: 1e-7 m, which 1e-9 would leave 1 % off.
ENCLOSINGS: Final[int] = 60
JUMP_SHARP: Final[float] = 1e-12
#: A trial shows on which side of the root it is where the steady wheel misses its height by no more than this
#: share of D [-], or this [m]: 8 micrometres from it D = 0.3 micrometres had the wrong sign.
NEAR_SHARE: Final[float] = 0.25
NEAR_HEIGHT: Final[float] = 1e-10
#: Wider than any bracket [m].
FARTHEST: Final[float] = 1.0
#: Where D falls by more than so many times what the levers say, it jumps [-].
STEEP: Final[float] = 4.0
#: In so narrow a bracket a value of D above this is a jump, and no equilibrium [m].
UNBALANCED: Final[float] = 1e-9
#: A step that has not reduced D by this factor halves the bracket; D falls by at least this share of what the
#: levers say, where it is taken to be smooth [-].
REDUCED: Final[float] = 0.5


@seldom
def level_both(tables: Tables, work: Work, left: float, right: float, height: float):
    """Press both wheels at ``height`` [m]; whether both can carry ``left`` and ``right`` [N], and the
    status. How much lower they do is in their supports."""
    work.sides[1].roll_count += 1.0
    residual, satisfied, status = height_residual(tables, work, 0, left, height)
    if status <= UNLOADED:
        residual, also, side_status = height_residual(tables, work, 1, right, height)
        satisfied = satisfied and also
        status = max(status, side_status)
    return satisfied, status


@seldom
def enclose_equilibrium(tables: Tables, work: Work, roll: float, height: float, left: float, right: float):
    """Roll [rad] of the wheelset in equilibrium under ``left`` and ``right`` [N], and the status, from
    ``roll`` and ``height`` on; NOT_CONVERGED where none is found.

    Long because each trial decides between four ways to go on."""
    bracket = work.roll_bracket
    supports = work.supports
    rate = residual_rate(tables)
    before = 0.0
    move = 0.0
    moved = LONGEST_MOVE
    begin_cuts(work.jump)
    if not turn_to(tables, work, roll):
        return roll, NOT_CONVERGED
    for trial in range(ENCLOSINGS):
        work.contact.filling = moved < NOT_LAST
        satisfied, status = level_both(tables, work, left, right, height)
        if status > UNLOADED:
            return roll, NOT_CONVERGED
        lack_left = (supports[0].height - height) / rate
        lack_right = (supports[1].height - height) / rate
        apart = lack_right - lack_left
        slope = slope_apart(supports, move, apart - before)
        steady = int(fabs(lack_right) < fabs(lack_left))
        lack = (supports[steady].height - height) / rate
        near = note_end(work, apart, roll, height, lack)
        enclosed = work.jump.apart_low > 0.0 and work.jump.apart_high <= 0.0
        if enclosed and bracket_width(tables, bracket) < JUMP_SHARP and fabs(apart) > UNBALANCED:
            roll, status = stand_at_jump(tables, work, steady, left, right)
            return roll, status
        following = roll - apart / slope
        inside = following > bracket.low and following < bracket.high
        slow = fabs(apart) > REDUCED * fabs(before)
        cut = near and (work.jump.found or not inside or slow)
        astray = not near and move != 0.0 and slow
        if enclosed and cut:
            following = cut_bracket(tables, work, steady, left, right, roll, fabs(lack))
        elif enclosed and not inside or astray and not enclosed:
            # the same roll again, nearer to where the wheels carry their loads: Newton's method alternates
            # between two rolls where it trusts D far from there
            following = roll
        before = apart
        move = limited(following - roll, LONGEST_MOVE / tables.arm)
        sink = lack + float(2 * steady - 1) * supports[steady].lever * move
        if not enclosed and not astray:
            # in one order for a wheelset and its mirror image
            sink = 0.5 * ((lack_left - supports[0].lever * move) + (lack_right + supports[1].lever * move))
        elif cut:
            share = (following - bracket.low) / (bracket.high - bracket.low)
            sink = bracket.at_low + share * (bracket.at_high - bracket.at_low) - height
        sink = limited(sink, LONGEST_MOVE)
        moved = fabs(sink) + tables.arm * fabs(move)
        if fabs(sink) < ELASTIC_SHARP and tables.arm * fabs(move) < ELASTIC_SHARP:
            if work.contact.filling and satisfied and gaps_hold(tables, work, roll):
                set_heights(supports, height + sink)
                return roll + move, depth_status(work, status)
            begin_cuts(work.jump)
        height += sink
        roll += move
        if not fabs(roll) < ROLL_LIMIT or not turn_near(tables, work, roll):
            break
    return roll, NOT_CONVERGED


@seldom
def note_end(work: Work, apart: float, roll: float, height: float, lack: float) -> bool:
    """Let ``roll`` [rad] with D = ``apart`` [m] be an end of the bracket, if the trial at ``height``, where the
    steady wheel lacks ``lack`` [m], shows on which side of the root it is; whether it does.  What was known of
    the other end at this same roll, farther from the height, is forgotten."""
    if not (fabs(lack) < NEAR_SHARE * fabs(apart) or fabs(lack) < NEAR_HEIGHT):
        return False
    bracket = work.roll_bracket
    if bracket.low == roll:
        work.jump.apart_low = -FARTHEST
    if bracket.high == roll:
        work.jump.apart_high = FARTHEST
    if apart > 0.0:
        bracket.low = roll
        bracket.at_low = height + lack
        work.jump.apart_low = apart
    else:
        bracket.high = roll
        bracket.at_high = height + lack
        work.jump.apart_high = apart
    return True


@seldom
def bracket_width(tables: Tables, bracket: Bracket):
    """Width of the bracket at the wheels [m].  Where D rises its low end is the higher one."""
    return tables.arm * fabs(bracket.high - bracket.low)


@seldom
def begin_cuts(jump: Jump):
    """Neither end of the bracket is known, and no jump is sought or found yet."""
    jump.apart_low = -FARTHEST
    jump.apart_high = FARTHEST
    jump.searched = FARTHEST
    jump.found = False


@seldom
def cut_bracket(
    tables: Tables, work: Work, steady: int, left: float, right: float, roll: float, missed: float
):
    """Next roll [rad] within the bracket after one at an end of it, ``roll``, where the ``steady`` wheel has
    ``missed`` its height by so much [m]: beside a jump of the other one, if one is found, or half way.

    After a search that has not halved the bracket, halving does.
    """
    bracket = work.roll_bracket
    jump = work.jump
    supports = work.supports
    following = 0.5 * (bracket.low + bracket.high)
    width = bracket_width(tables, bracket)
    jump.found = False
    if width < REDUCED * jump.searched:
        jump.searched = width
        force = left
        if steady == 0:
            force = right
        smooth = fabs(supports[0].lever + supports[1].lever) * fabs(bracket.high - bracket.low)
        steep = jump.apart_low - jump.apart_high > max(STEEP * smooth, UNBALANCED)
        place = find_jump(tables, work, 1 - steady, force, roll, missed, steep)
        if place > bracket.low and place < bracket.high:
            following = place
            jump.found = True
    return following


@seldom
def slope_apart(supports: Supports, move: float, change: float):
    """How D follows the roll [m], from the levers of both sides and its ``change`` [m] by the last ``move``
    [rad]."""
    slope = min(supports[0].lever + supports[1].lever, -LEAST_LEVER)
    if move != 0.0:
        factor = change / (slope * move)
        if factor > REDUCED:
            slope *= factor
    return slope


@seldom
def stand_at_jump(tables: Tables, work: Work, steady: int, left: float, right: float):
    """Stand at the jump that the bracket encloses, at the end at which the wheel that jumps carries no less
    than its load, the one that is not ``steady``, or at the other end if it cannot; roll [rad] and
    status."""
    bracket = work.roll_bracket
    roll = bracket.high
    height = bracket.at_high
    other = bracket.low
    other_height = bracket.at_low
    if steady == 1:
        roll = bracket.low
        height = bracket.at_low
        other = bracket.high
        other_height = bracket.at_high
    status = stand_beside(tables, work, steady, left, right, roll, height)
    if status == NOT_CONVERGED:
        roll = other
        status = stand_beside(tables, work, steady, left, right, roll, other_height)
    return roll, status


@seldom
def stand_beside(
    tables: Tables,
    work: Work,
    steady: int,
    left: float,
    right: float,
    roll: float,
    height: float,
):
    """Stand at the ``roll`` of one end of a jump, near ``height``, where the ``steady`` wheel carries its
    load; the status."""
    if not turn_to(tables, work, roll):
        return NOT_CONVERGED
    work.contact.filling = True
    satisfied, status = level_both(tables, work, left, right, height)
    if not satisfied:
        status = NOT_CONVERGED
    set_heights(work.supports, height)
    return depth_status(work, status)


@seldom
def set_heights(supports: Supports, height: float):
    """Both wheels carry their loads at ``height`` [m]."""
    supports[0].height = height
    supports[1].height = height


@seldom
def gaps_hold(tables: Tables, work: Work, roll: float) -> bool:
    """Whether both sides' known gaps are the smallest at ``roll`` [rad]; then smaller ones are known.

    Between trials they are only followed: an answer is certified once.
    """
    left = work.sides[0].best_y
    right = work.sides[1].best_y
    hold = turn_to(tables, work, roll)
    if fabs(work.sides[0].best_y - left) > SAME_GAP or fabs(work.sides[1].best_y - right) > SAME_GAP:
        hold = False
    return hold
