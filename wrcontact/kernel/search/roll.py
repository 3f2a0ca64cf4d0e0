"""The roll of the wheelset: the angle at which both wheels have the same smallest gap.

D(roll) = gap_right - gap_left falls strictly while one flange is less steep than atan(2 arm / radius) (73 deg
for 750 mm and 460 mm), so a bracket and Newton's method with the envelope derivative cannot fail. Where it
has several roots, first_root.py decides which is the roll.

Solve first, certify then: with two minima at hand Newton finds the roll that makes them equal, following each
one; at that roll both sides are searched for a smaller one. If there is none, this is the roll; otherwise the
smaller minima take over, within a bracket that every search narrows.

Without a near pose before, the search starts from contacts without yaw, which are known for a row of lateral
shifts.  A start sets the cost and never the answer, which is certified.
"""

from math import fabs
from typing import Final

from ..layout import (
    NOT_CONVERGED,
    OFF_PROFILE,
    ROLL_LIMIT,
    VALID,
    Inputs,
    Pair,
    Place,
    SideSearch,
    Sides,
    Starts,
    Tables,
)
from ..surface.gap import above_rail, gap_jet, gap_per_roll, vertical_gap
from ..surface.locus import mirror_place, mirror_roll, place_wheelset, turn_wheelset
from ..surface.rails import deflect_rail, roll_rail, move_rail, on_springs, turn_rolled_rail
from .bounds import rail_below
from .smallest_gap import SHARP, search_side

#: Newton stops when it moves the roll by less [rad]; rounding of the gaps is 1e-16 m over a
#: lever of 0.2 m and more.
ROLL_SHARP: Final[float] = 1e-14
SEARCHES: Final[int] = 120
#: Gaps that still differ by more than this when no roll is left between jump there [m].
EQUAL: Final[float] = 1e-9
NEWTON_STEPS: Final[int] = 25
#: Largest move of the roll in one Newton step with followed minima [rad]; larger ones are searched anew.
LONGEST_TURN: Final[float] = 5e-3
#: A known minimum that moves by more than this in a Newton step is looked for anew [m].
LONGEST_MOVE: Final[float] = 5e-3
#: A smallest gap is followed to another roll in so many steps, and no farther than this [m].
FOLLOW_STEPS: Final[int] = 8
FOLLOW_REACH: Final[float] = 2e-3


def nearest_start(starts: Starts, shift: float):
    """The row of the table that is nearest to the lateral ``shift`` [m]; -1 if nothing is known there."""
    u = (shift - starts.first_shift) * starts.per_metre + 0.5
    if not (u >= 0.0 and u < starts.count):
        return -1
    row = int(u)
    if not starts.rows[row].known:
        row = -1
    return row


def place_both(tables: Tables, inputs: Inputs, sides: Sides, roll: float):
    """Both wheels at ``roll``; the left one mirrored into a right one (conventions.MIRROR)."""
    place_wheelset(
        sides[1].place,
        inputs.lateral_shift,
        inputs.yaw,
        roll,
        tables.pairs[1].radius,
        tables.height,
        tables.arm,
    )
    mirror_place(sides[1].place, sides[0].place, tables.pairs[0].radius)
    move_rail(sides[1].place, inputs.right_rail_lateral, inputs.right_rail_vertical)
    move_rail(sides[0].place, -inputs.left_rail_lateral, inputs.left_rail_vertical)
    if on_springs(tables):
        deflect_rail(sides[1].place, sides[1].deflection)
        deflect_rail(sides[0].place, sides[0].deflection)
    if inputs.left_rail_roll != 0.0 or inputs.right_rail_roll != 0.0:
        roll_rails(tables, inputs, sides, roll)


def roll_rails(tables: Tables, inputs: Inputs, sides: Sides, roll: float):
    """Let both rails have their roll below wheels that are placed at ``roll``."""
    roll_rail(sides[1].place, tables.pairs[1].rail_y, inputs.right_rail_roll)
    roll_rail(sides[0].place, tables.pairs[0].rail_y, -inputs.left_rail_roll)
    turn_both(sides, roll)


def turn_both(sides: Sides, roll: float):
    """Both placed wheels at another ``roll``."""
    if sides[1].place.leaning:
        restore_yaw(sides[1].place)
        restore_yaw(sides[0].place)
    turn_wheelset(sides[1].place, roll)
    mirror_roll(sides[1].place, sides[0].place)
    if sides[1].place.leaning:
        turn_rolled_rail(sides[1].place)
        turn_rolled_rail(sides[0].place)


def restore_yaw(place: Place):
    """The yaw in the track, where that in the frame of a rolled rail stood."""
    place.sin_yaw = place.track_sin_yaw
    place.cos_yaw = place.track_cos_yaw


def search_both(tables: Tables, sides: Sides, known: bool) -> bool:
    """Search both sides; whether both wheels are above their rails."""
    left = search_side(tables.pairs[0], sides[0], known)
    right = search_side(tables.pairs[1], sides[1], known)
    return left and right


def follow_side(pair: Pair, side: SideSearch) -> bool:
    """Move a side's known smallest gap to this roll's by Newton's method; whether it is found near."""
    at = side.place
    wheel = pair.wheel
    y = side.best_y
    for i in range(FOLLOW_STEPS):
        gap, mismatch, rate = vertical_gap(pair, at, y)
        at.gap_count += 1.0
        if not rate > 0.0:
            return False
        move = -mismatch / rate
        if fabs(move) < SHARP:
            abscissa = rail_below(pair, at, y)
            if not above_rail(pair, abscissa):
                return False
            keep_known(side, y, gap, abscissa)
            return True
        y += move
        if fabs(y - side.best_y) > FOLLOW_REACH or not (y > wheel.start and y < wheel.stop):
            return False
    return False


def newton_move(tables: Tables, sides: Sides):
    """D [m] and Newton's move of the roll [rad] at the known minima; a move of 1 where D does not fall."""
    difference = sides[1].best - sides[0].best
    rate = gap_per_roll(tables.pairs[1], sides[1].place, sides[1].best_y) + gap_per_roll(
        tables.pairs[0], sides[0].place, sides[0].best_y
    )
    move = 1.0
    if rate < 0.0:
        move = -difference / rate
    return difference, move


def equalize_minima(tables: Tables, sides: Sides, roll: float, low: float, high: float):
    """Roll [rad] at which the two known minima are equal, following them; second value: whether found.

    Newton's method for three unknowns at once: the roll and the minima's places, where the slopes of wheel
    and rail agree. It starts with the minima known near ``roll`` and stays between ``low`` and ``high``.
    Between nearly conformal profiles a minimum can run away or vanish.
    """
    left = sides[0].best_y
    right = sides[1].best_y
    for i in range(NEWTON_STEPS):
        sides[1].roll_count += 1.0
        sides[0].place.gap_count += 1.0
        sides[1].place.gap_count += 1.0
        turn_both(sides, roll)
        gap_left, mismatch_left, rate_left, lever_left, turn_left, rail_left = gap_jet(
            tables.pairs[0], sides[0].place, left
        )
        gap_right, mismatch_right, rate_right, lever_right, turn_right, rail_right = gap_jet(
            tables.pairs[1], sides[1].place, right
        )
        if not (rate_left > 0.0 and rate_right > 0.0):
            return roll, False
        move_left = -mismatch_left / rate_left
        move_right = -mismatch_right / rate_right
        # gaps and levers at the minima next to these places, to second and first order
        difference = gap_right - gap_left + 0.5 * (mismatch_right * move_right - mismatch_left * move_left)
        lever = lever_right + lever_left + turn_right * move_right + turn_left * move_left
        if not lever < 0.0:
            return roll, False
        move = -difference / lever
        move_left += turn_left * move / rate_left
        move_right -= turn_right * move / rate_right
        if fabs(move) < ROLL_SHARP and fabs(move_left) < SHARP and fabs(move_right) < SHARP:
            if not on_profiles(tables.pairs[0], left, rail_left) or not on_profiles(
                tables.pairs[1], right, rail_right
            ):
                return roll, False
            keep_known(sides[0], left, gap_left, rail_left)
            keep_known(sides[1], right, gap_right, rail_right)
            return roll, True
        if not (
            fabs(move) < LONGEST_TURN and fabs(move_left) < LONGEST_MOVE and fabs(move_right) < LONGEST_MOVE
        ):
            return roll, False
        left += move_left
        right += move_right
        roll += move
        if not (roll > low and roll < high):
            return roll, False
    return roll, False


def on_profiles(pair: Pair, y: float, abscissa: float) -> bool:
    """Whether there is a wheel at ``y`` and a rail at ``abscissa`` [m]."""
    wheel = pair.wheel
    on = above_rail(pair, abscissa)
    if y < wheel.start or y > wheel.stop:
        on = False
    return on


def keep_known(side: SideSearch, y: float, gap: float, abscissa: float):
    """Let the side's known minimum be at ``y``, ``abscissa`` on the rail [m]."""
    side.best = gap
    side.best_y = y
    side.best_rail = abscissa


def roll_between(tables: Tables, sides: Sides, roll: float, first: float, last: float, known: bool):
    """A roll [rad] between ``first`` and ``last`` at which both smallest gaps are equal, and the status;
    both gaps are known at it. D has to be positive at ``first`` and negative at ``last``.

    With ``known`` = 1 the sides hold local minima that are equal at ``roll``.

    A long move can end where one wheel is beside its rail, and D has no sign.  Then the root lies between there
    and the last roll at which both were above theirs.
    """
    low = first
    high = last
    width = high - low
    difference = 0.0
    both_above = False
    last_above = 0.0
    for i in range(SEARCHES):
        if not known:
            turn_both(sides, roll)
        before_left = sides[0].best_y
        before_right = sides[1].best_y
        found = search_both(tables, sides, known)
        if known and before_left == sides[0].best_y and before_right == sides[1].best_y:
            return roll, VALID
        known = False
        # a wheel beside its rail has a large gap
        difference = sides[1].best - sides[0].best
        if not found and difference == 0.0 and not both_above:
            return roll, OFF_PROFILE
        move = 1.0
        below = difference > 0.0
        if found:
            difference, move = newton_move(tables, sides)
            if fabs(move) < ROLL_SHARP:
                return roll, VALID
            below = difference > 0.0
            both_above = True
            last_above = roll
        elif both_above:
            below = roll < last_above
        if below:
            low = roll
        else:
            high = roll
        if high - low < ROLL_SHARP:
            break
        # between flange and tread Newton can creep along one side: halve where it did not
        slow = low > first and high < last and high - low > 0.5 * width
        width = high - low
        if slow or not (roll + move > low and roll + move < high):
            roll = 0.5 * (low + high)
        elif fabs(move) > LONGEST_TURN:
            roll += move
        else:
            balanced, known = equalize_minima(tables, sides, roll + move, low, high)
            roll += move
            if known:
                roll = balanced
    status = NOT_CONVERGED
    if high - low < ROLL_SHARP:
        status = VALID
        if fabs(difference) > EQUAL:
            # an end of a profile comes above or leaves the rail there
            status = OFF_PROFILE
    return roll, status


def any_roll(tables: Tables, inputs: Inputs, sides: Sides, guess: float, warm: bool):
    """A roll [rad] at which both smallest gaps are equal, and the status; both gaps are known at it.

    With ``warm`` = 1 ``best_y`` of both sides holds minima to start from.
    """
    start = guess
    if not (start > -ROLL_LIMIT and start < ROLL_LIMIT):
        start = 0.0
    known = False
    place_both(tables, inputs, sides, start)
    if warm:
        balanced, known = equalize_minima(tables, sides, start, -ROLL_LIMIT, ROLL_LIMIT)
        if known:
            start = balanced
    roll, status = roll_between(tables, sides, start, -ROLL_LIMIT, ROLL_LIMIT, known)
    if status != VALID and start != 0.0:
        # far from zero roll a wheel may be beside its rail, and D without a sign
        roll, status = roll_between(tables, sides, 0.0, -ROLL_LIMIT, ROLL_LIMIT, False)
    return roll, status
