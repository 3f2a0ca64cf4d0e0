"""Elastic equilibrium: the height and roll at which both wheels carry their loads.

The wheels sink into their rails.  At a given roll each side has one height at which it carries its load; where these heights
are equal the wheelset stands.  Their difference D(roll) = height_right - height_left falls as that of the rigid gaps does
(:mod:`roll`), and a small load leaves the gaps themselves.  How a side's height follows the roll,

    d height / d roll = sum k_i cos(angle_i) G_i / sum k_i cos(angle_i),

is the mean of its regions' rigid levers G_i = gap_per_roll, weighted by their stiffnesses k_i: Newton's slope, by the
envelope theorem (docs/method.md, section 11).  Both unknowns are found by Broyden's method (Broyden 1965).

Regions and nodes are laid where the wheels stand, which is found along with height and roll: a trial lays both wheels down at
one pose, and solves their loads; what either lacks of the height that it would carry its load at vanishes in equilibrium.
The compliant form is given height and roll,
and each wheel's load follows from how deep it stands.
"""

from math import fabs
from typing import Final

from ..contact.touching import limited
from ..layout import NOT_CONVERGED, OFF_PROFILE, ROLL_LIMIT, UNLOADED, VALID, State, Tables, Work
from ..normal.estimate import first_penetration
from ..search.roll import follow_side, place_both, search_both, turn_both
from .side import load_side, press_side, rest_side, side_lever

#: Broyden's method needs eight trials; what it has not found after so many, it will not.
TRIALS: Final[int] = 25
#: Brackets end here, or when they or what they enclose are this small [m, rad].
BRACKETINGS: Final[int] = 90
BRACKET_SHARP: Final[float] = 1e-13
#: First distance from the rigid roll at which the other end of a bracket is looked for [rad].
FIRST_REACH: Final[float] = 2e-5
#: Height and roll are found when either wheel moves by less [m].  At 1e-11 they were exact enough, but how they change from
#: pose to pose was off by up to 5e-5 of their derivatives; that costs 0.8 trials of 8.6.
ELASTIC_SHARP: Final[float] = 1e-13
#: Longest move of a wheel in one trial [m].
LONGEST: Final[float] = 2e-4
#: Smallest determinant of the lacks' derivatives; -(lever_left + lever_right) / arm to begin with, 0.3 ... 2.
SINGULAR: Final[float] = 0.02
#: Smallest sum of both levers [m] for a first stand; flanges of 73 deg have none.
LEAST_LEVER: Final[float] = 1e-2
#: A loaded wheel is laid down by this share of its first estimate at least.
SHALLOWEST: Final[float] = 0.1
#: A wheel that stands deeper in its rail than this [m] is off the profile.
DEEPEST: Final[float] = 2e-3
#: A wheel that overlaps its rail by less than this [m], to which smallest gaps are known, does not touch; 5e-9 N.
GRAZING: Final[float] = 1e-13


def first_sink(tables: Tables, work: Work, state: State, index: int, force: float):
    """Estimate how far a wheel under ``force`` [N] sinks below its smallest gap; the outcome."""
    support = work.supports[index]
    status = rest_side(tables, work, state, index)
    support.first = 0.0
    if status == UNLOADED:
        status = VALID
        if force > 0.0:
            support.first = first_penetration(tables, work, state, force) / work.frame.cos
    return status


def carry_side(tables: Tables, work: Work, state: State, index: int, force: float, height: float):
    """Find at which height a side carries ``force`` [N], with regions and nodes laid where it stands at ``height`` [m]; its
    outcome.  Outputs are those of the side under this force."""
    support = work.supports[index]
    best = work.sides[index].best
    if not force > 0.0:
        support.height = best
        support.lever = side_lever(tables, work, index, 0)
        return rest_side(tables, work, state, index)
    sink = height - best
    if sink < SHALLOWEST * support.first:
        sink = SHALLOWEST * support.first
    if sink > DEEPEST:
        sink = DEEPEST
    status = press_side(tables, work, state, index, sink)
    if status == VALID:
        count, status = load_side(tables, work, state, index, force, tables.absent)
        carried = sink + (work.outputs.left[index].penetration - work.frame.depth) / work.frame.cos
        support.height = best + carried
        support.lever = side_lever(tables, work, index, count)
    return status


def turn_to(tables: Tables, work: Work, state: State, roll: float):
    """Turn the wheelset to ``roll`` [rad] and find both smallest gaps; 1 if both wheels are above their rails, else 0."""
    turn_both(work, roll)
    known = follow_side(tables, work, state, 0)
    if known == 1:
        known = follow_side(tables, work, state, 1)
    return search_both(tables, work, state, known)


def carry_both(tables: Tables, work: Work, state: State, left: float, right: float, height: float):
    """``carry_side`` for both, under ``left`` and ``right`` [N]; the worse outcome."""
    state.roll_count += 1.0
    status = carry_side(tables, work, state, 0, left, height)
    if status <= UNLOADED:
        outcome = carry_side(tables, work, state, 1, right, height)
        if outcome > status:
            status = outcome
    return status


def too_deep(work: Work, index: int):
    """1 if a side carries its load deeper than DEEPEST, which the compliant form refuses too, else 0."""
    deep = 0
    best = work.sides[index].best
    if work.supports[index].height - best > DEEPEST:
        deep = 1
    return deep


def solve_elastic(tables: Tables, work: Work, state: State, roll: float, left: float, right: float):
    """Roll [rad] at which the wheelset stands under ``left`` and ``right`` [N], and the outcome; outputs are those of the two
    sides.  Starts at the rigid ``roll``, whose smallest gaps are known; where Broyden's method finds nothing, brackets do."""
    status = first_sink(tables, work, state, 0, left)
    if status == VALID:
        status = first_sink(tables, work, state, 1, right)
    if status != VALID:
        return roll, status
    first = work.supports[0]
    second = work.supports[1]
    rigid_roll = roll
    # where both would stand if each had sunk as estimated
    lever_left = side_lever(tables, work, 0, 0)
    lever_right = side_lever(tables, work, 1, 0)
    turn = 0.0
    if lever_left + lever_right < -LEAST_LEVER:
        turn = (second.first - first.first) / -(lever_left + lever_right)
    turn = limited(turn, LONGEST / tables.arm)
    # in one order for a wheelset and its mirror image
    height = work.sides[0].best + 0.5 * ((first.first - lever_left * turn)
                                                  + (second.first + lever_right * turn))
    roll += turn
    if turn_to(tables, work, state, roll) == 0:
        return roll, OFF_PROFILE
    # Broyden's (1965) method for what both sides lack of the height, over height and roll; the roll in metres at the wheels
    arm = tables.arm
    lack_left = 0.0
    lack_right = 0.0
    left_height = -1.0
    left_roll = 0.0
    right_height = -1.0
    right_roll = 0.0
    move_height = 0.0
    move_roll = 0.0
    for trial in range(TRIALS):
        status = carry_both(tables, work, state, left, right, height)
        if status > UNLOADED:
            break
        before_left = lack_left
        before_right = lack_right
        lack_left = first.height - height
        lack_right = second.height - height
        size = move_height * move_height + move_roll * move_roll
        if trial == 0:
            left_roll = -first.lever / arm
            right_roll = second.lever / arm
        elif size > 0.0:
            off_left = (lack_left - before_left - left_height * move_height - left_roll * move_roll) / size
            off_right = (lack_right - before_right - right_height * move_height - right_roll * move_roll) / size
            left_height += off_left * move_height
            left_roll += off_left * move_roll
            right_height += off_right * move_height
            right_roll += off_right * move_roll
        determinant = left_height * right_roll - right_height * left_roll
        if not fabs(determinant) > SINGULAR:
            left_height = -1.0
            right_height = -1.0
            left_roll = -first.lever / arm
            right_roll = second.lever / arm
            determinant = left_height * right_roll - right_height * left_roll
            if not fabs(determinant) > SINGULAR:
                break
        move_height = (lack_right * left_roll - lack_left * right_roll) / determinant
        move_roll = (lack_left * right_height - lack_right * left_height) / determinant
        if fabs(move_height) < ELASTIC_SHARP and fabs(move_roll) < ELASTIC_SHARP:
            if too_deep(work, 0) == 1 or too_deep(work, 1) == 1:
                status = OFF_PROFILE
            return roll, status
        move_height = limited(move_height, LONGEST)
        move_roll = limited(move_roll, LONGEST)
        height += move_height
        roll += move_roll / arm
        if not fabs(roll) < ROLL_LIMIT:
            break
        if turn_to(tables, work, state, roll) == 0:
            break
    roll, status = bracket_roll(tables, work, state, rigid_roll, left, right)
    return roll, status


def within_bracket(low: float, high: float, at_low: float, at_high: float, i: int):
    """Where to look next for a zero between two values of opposite sign: on their chord, and every other time half way."""
    place = 0.5 * (low + high)
    if i % 2 == 0:
        chord = low - at_low * (high - low) / (at_high - at_low)
        if chord > low and chord < high:
            place = chord
    return place


def carried_load(work: Work, count: int):
    """What ``count`` regions carry [N], vertically where the prescribed load is vertical."""
    total = 0.0
    for region in range(count):
        block = work.regions[region]
        total += block.share * block.carried
    return total


def lay_side(tables: Tables, work: Work, state: State, index: int, force: float, height: float):
    """What a side that is laid down at ``height`` lacks of the height at which it carries ``force`` [m]; 1 if it is carried
    there, else 0; and the outcome.

    The nodes of a deep stand may carry more than the force at every level, or less; then what they carry at ``height``
    tells whether that is too low or too high, and the lack counts as the whole depth.
    """
    support = work.supports[index]
    status = carry_side(tables, work, state, index, force, height)
    lack = support.height - height
    met = 1
    if status == NOT_CONVERGED:
        met = 0
        sink = height - work.sides[index].best
        if sink > DEEPEST:
            sink = DEEPEST
        if sink < SHALLOWEST * support.first:
            sink = SHALLOWEST * support.first
        status = press_side(tables, work, state, index, sink)
        if status == VALID:
            count, status = load_side(tables, work, state, index, 0.0, work.frame.depth)
            lack = sink
            if carried_load(work, count) > force:
                lack = -sink
            support.height = height + lack
    return lack, met, status


def bracket_height(tables: Tables, work: Work, state: State, index: int, force: float):
    """Find the height at which a side carries ``force`` [N] when it is laid down just there; the outcome.

    Laid down too high it lacks height, too low it has too much.  Where its load jumps past the force as it comes down, since
    a region comes or goes, the height of the jump is taken, with the regions just below it, or just above where those cannot
    carry the force.  Where DEEPEST is too high the height is what it would be with regions as they are there.
    """
    support = work.supports[index]
    best = work.sides[index].best
    if not force > 0.0:
        return carry_side(tables, work, state, index, force, best)
    low = best + SHALLOWEST * support.first
    lack_low, met, status = lay_side(tables, work, state, index, force, low)
    if status > UNLOADED:
        return status
    if lack_low <= 0.0:
        if met == 0:
            status = NOT_CONVERGED
        return status
    high = low
    lack_high = lack_low
    while lack_high > 0.0:
        if high >= best + DEEPEST:
            return status
        low = high
        lack_low = lack_high
        high = best + 1.5 * (high - best)
        if high > best + DEEPEST:
            high = best + DEEPEST
        lack_high, met, status = lay_side(tables, work, state, index, force, high)
        if status > UNLOADED:
            return status
    for i in range(BRACKETINGS):
        height = within_bracket(low, high, lack_low, lack_high, i)
        lack, met, status = lay_side(tables, work, state, index, force, height)
        if status > UNLOADED:
            return status
        if fabs(lack) < BRACKET_SHARP:
            return status
        if lack > 0.0:
            low = height
            lack_low = lack
        else:
            high = height
            lack_high = lack
        if high - low < BRACKET_SHARP:
            break
    status = carry_side(tables, work, state, index, force, high)
    if status == NOT_CONVERGED:
        status = carry_side(tables, work, state, index, force, low)
    support.height = high
    return status


def flatter_side(work: Work):
    """The side whose wheel touches at the smaller angle, by the outputs of both sides; the left one where they are equal."""
    flat = 0
    if fabs(work.outputs.left[1].contact_angle) < fabs(work.outputs.left[0].contact_angle):
        flat = 1
    return flat


def stand_at(tables: Tables, work: Work, state: State, roll: float, left: float, right: float, flat: int):
    """Let side ``flat`` carry its load at ``roll``, and lay down the other one at this height; how much lower the right one
    would stand than the left one [m], 1 if either load is carried, else 0, and the outcome."""
    if turn_to(tables, work, state, roll) == 0:
        return 0.0, 0, OFF_PROFILE
    state.roll_count += 1.0
    flat_force = left
    steep_force = right
    if flat == 1:
        flat_force = right
        steep_force = left
    status = bracket_height(tables, work, state, flat, flat_force)
    if status > UNLOADED:
        return 0.0, 0, status
    height = work.supports[flat].height
    lack, met, outcome = lay_side(tables, work, state, 1 - flat, steep_force, height)
    work.supports[1 - flat].height = height
    if outcome > status:
        status = outcome
    if flat == 1:
        lack = -lack
    return lack, met, status


def bracket_roll(tables: Tables, work: Work, state: State, roll: float, left: float, right: float):
    """``solve_elastic`` by brackets around brackets: slow, and it cannot fail while the flatter wheel carries its load.

    A steep flange may carry its load at several heights of one roll, or at none that is not too deep; at the
    height of the other wheel its load has one value at every roll.  Where that jumps past the force, since a region comes or
    goes, the roll of the jump is taken.
    """
    flat = flatter_side(work)
    difference, met, status = stand_at(tables, work, state, roll, left, right, flat)
    if status > UNLOADED:
        return roll, status
    low = roll
    high = roll
    at_low = difference
    at_high = difference
    reach = FIRST_REACH
    while at_low * at_high > 0.0:
        if reach > ROLL_LIMIT:
            return roll, NOT_CONVERGED
        if difference > 0.0:
            low = high
            at_low = at_high
            high = roll + reach
            at_high, met, status = stand_at(tables, work, state, high, left, right, flat)
        else:
            high = low
            at_high = at_low
            low = roll - reach
            at_low, met, status = stand_at(tables, work, state, low, left, right, flat)
        if status > UNLOADED:
            return roll, status
        reach *= 2.0
    for i in range(BRACKETINGS):
        roll = within_bracket(low, high, at_low, at_high, i)
        difference, met, status = stand_at(tables, work, state, roll, left, right, flat)
        if status > UNLOADED:
            return roll, status
        if difference > 0.0:
            low = roll
            at_low = difference
        else:
            high = roll
            at_high = difference
        if fabs(difference) < BRACKET_SHARP or high - low < BRACKET_SHARP:
            break
    if fabs(difference) >= BRACKET_SHARP:
        # of both ends of a jump always the same, at which the steeper wheel carries no less than its load
        end = high
        if flat == 1:
            end = low
        if roll != end:
            roll = end
            difference, met, status = stand_at(tables, work, state, roll, left, right, flat)
    if met == 0:
        # or the one whose nodes can carry the force
        other = low
        if roll == low:
            other = high
        roll = other
        difference, met, status = stand_at(tables, work, state, roll, left, right, flat)
    if status <= UNLOADED:
        if met == 0:
            status = NOT_CONVERGED
        if too_deep(work, 0) == 1 or too_deep(work, 1) == 1:
            status = OFF_PROFILE
    return roll, status


def bear_side(tables: Tables, work: Work, state: State, index: int, height: float):
    """The load of a side whose wheelset stands at the vertical shift ``height`` [m]; its outcome, UNLOADED if lifted."""
    sink = height - work.sides[index].best
    if not sink > GRAZING:
        return rest_side(tables, work, state, index)
    if sink > DEEPEST:
        return OFF_PROFILE
    status = press_side(tables, work, state, index, sink)
    if status == VALID:
        count, status = load_side(tables, work, state, index, 0.0, work.frame.depth)
    return status


def stand_compliant(tables: Tables, work: Work, state: State):
    """Compliant contact: the wheelset stands at the height and roll of the inputs; the outcome."""
    roll = work.inputs.roll
    height = work.inputs.vertical_shift
    place_both(tables, work, roll)
    work.outputs.roll = roll
    work.outputs.vertical_shift = height
    status = VALID
    if search_both(tables, work, state, 0) == 0:
        return OFF_PROFILE
    for index in range(2):
        outcome = bear_side(tables, work, state, index, height)
        if outcome > status:
            status = outcome
    return status
