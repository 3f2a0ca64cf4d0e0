"""Elastic equilibrium: the height and roll at which both wheels carry their loads.

The wheels sink into their rails.  At a given roll each side has one height at which it carries its load; where these heights
are equal the wheelset stands.  Their difference D(roll) = height_right - height_left falls as that of the rigid gaps does
(:mod:`roll`), and a small load leaves the gaps themselves.  How a side's height follows the roll,

    d height / d roll = sum k_i cos(angle_i) G_i / sum k_i cos(angle_i),

is the mean of its regions' rigid levers G_i = gap_per_roll, weighted by their stiffnesses k_i: Newton's slope.

Regions and nodes are laid for the depth that a side has sunk to, which is found along with the roll: every trial of the
roll presses each wheel as deep as the one before found, and solves its load.  The compliant form is given height and roll,
and each wheel's load follows from how deep it stands.
"""

from math import fabs
from typing import Final

from .contact_plane import FRAME_COS, FRAME_DEPTH
from .gap import vertical_gap
from .layout import (IN_ROLL, IN_VERTICAL_SHIFT, NOT_CONVERGED, OFF_PROFILE, OUT_ROLL, OUT_VERTICAL_SHIFT, PLACE_BLOCK,
                     SET_ABSENT, SET_RAIL_Y, SET_WHEEL, SIDE_BEST, SIDE_BEST_RAIL, SIDE_BEST_Y, SIDE_BLOCK,
                     SIDE_PENETRATION, STATE_GAP_COUNT, STATE_ROLL_COUNT, SUPPORT_BLOCK, UNLOADED, VALID, WORK_INPUTS,
                     WORK_OUTPUTS, WORK_PLACE, WORK_SIDE, WORK_SUPPORT)
from .locus import outline_point
from .normal_contact import first_penetration
from .profile_table import START, STOP, height_slope
from .resultant import clear_resultant
from .roll import ROLL_LIMIT, place_both, search_both, turn_both
from .search import SHARP
from .side import (SUPPORT_CARRIED, SUPPORT_HEIGHT, SUPPORT_LEVER, SUPPORT_SINK, load_side, press_side, rest_side,
                   side_lever, side_outputs)

TRIALS: Final[int] = 90
#: The roll is found when it moves by less [rad]: 1e-12 m at the wheels, and the gap is traced to about that.
ELASTIC_SHARP: Final[float] = 1e-12
#: and the depths that wheels were laid down to by less, relative, or [m].
SETTLED: Final[float] = 1e-7
SMALLEST: Final[float] = 1e-15
#: After so many trials the depths for which regions and nodes are laid stay as they are: where a region comes and goes with
#: the depth, the two would chase each other.
FROZEN: Final[int] = 20
#: Longest move of the roll in one trial [rad].
ELASTIC_TURN: Final[float] = 5e-3
#: The slope of two trials replaces Newton's while it is within this factor of it, and they are this far apart [rad].
SLOPE_FACTOR: Final[float] = 2.0
SLOPE_APART: Final[float] = 1e-10
#: At a jump of D the roll is bracketed to this [rad].
JUMP_SHARP: Final[float] = 1e-13
#: A wheel that stands deeper in its rail than this [m] is off the profile.
DEEPEST: Final[float] = 2e-3
FOLLOW_STEPS: Final[int] = 8
FOLLOW_REACH: Final[float] = 2e-3    # [m]


def first_sink(tables: 'float[:]', work: 'float[:]', state: 'float[:]', index: int, force: float):
    """How far [m] a wheel under ``force`` [N] is estimated to sink below its smallest gap, and the outcome."""
    status = rest_side(tables, work, state, index)
    sink = 0.0
    if status == UNLOADED:
        sink = first_penetration(tables, work, state, force) / work[FRAME_COS]
        status = VALID
    return sink, status


def carry_side(tables: 'float[:]', work: 'float[:]', state: 'float[:]', index: int, force: float):
    """Find the height at which a side carries ``force`` [N], from where it was laid down; its outcome.  Outputs are those of
    the side under this force."""
    support = WORK_SUPPORT + SUPPORT_BLOCK * index
    best = work[WORK_SIDE + SIDE_BLOCK * index + SIDE_BEST]
    if not force > 0.0:
        work[support + SUPPORT_SINK] = 0.0
        work[support + SUPPORT_CARRIED] = 0.0
        work[support + SUPPORT_HEIGHT] = best
        work[support + SUPPORT_LEVER] = side_lever(tables, work, index, 0)
        return rest_side(tables, work, state, index)
    sink = work[support + SUPPORT_SINK]
    if not sink > 0.0:
        sink, status = first_sink(tables, work, state, index, force)
        if status != VALID:
            return status
        work[support + SUPPORT_SINK] = sink
    status = press_side(tables, work, state, index, sink)
    if status == VALID:
        count, status = load_side(tables, work, state, index, force, tables[SET_ABSENT])
        carried = sink + (work[side_outputs(index) + SIDE_PENETRATION] - work[FRAME_DEPTH]) / work[FRAME_COS]
        if not carried > 0.0:
            carried = 0.5 * sink
        work[support + SUPPORT_CARRIED] = carried
        work[support + SUPPORT_HEIGHT] = best + carried
        work[support + SUPPORT_LEVER] = side_lever(tables, work, index, count)
    return status


def settled_side(work: 'float[:]', index: int):
    """1 if a side stands as deep as it was laid down, else 0."""
    support = WORK_SUPPORT + SUPPORT_BLOCK * index
    off = fabs(work[support + SUPPORT_CARRIED] - work[support + SUPPORT_SINK])
    settled = 0
    if off <= SETTLED * work[support + SUPPORT_CARRIED] or off <= SMALLEST:
        settled = 1
    return settled


def follow_side(tables: 'float[:]', work: 'float[:]', state: 'float[:]', index: int):
    """Move a side's known smallest gap to this roll's by Newton's method; 1 if it is found near, else 0."""
    side = WORK_SIDE + SIDE_BLOCK * index
    at = WORK_PLACE + PLACE_BLOCK * index
    wheel = int(tables[SET_WHEEL])
    y = work[side + SIDE_BEST_Y]
    for i in range(FOLLOW_STEPS):
        gap, mismatch, rate = vertical_gap(tables, work, at, y)
        state[STATE_GAP_COUNT] += 1.0
        if not rate > 0.0:
            return 0
        move = -mismatch / rate
        if fabs(move) < SHARP:
            z, slope = height_slope(tables, wheel, y)
            y_track, z_track, outline_slope = outline_point(work, at, y, z, slope)
            work[side + SIDE_BEST] = gap
            work[side + SIDE_BEST_Y] = y
            work[side + SIDE_BEST_RAIL] = y_track - tables[SET_RAIL_Y]
            return 1
        y += move
        if fabs(y - work[side + SIDE_BEST_Y]) > FOLLOW_REACH or not (y > tables[wheel + START] and y < tables[wheel + STOP]):
            return 0
    return 0


def turn_to(tables: 'float[:]', work: 'float[:]', state: 'float[:]', roll: float):
    """Turn the wheelset to ``roll`` [rad] and find both smallest gaps; 1 if both wheels are above their rails, else 0."""
    turn_both(work, roll)
    known = follow_side(tables, work, state, 0)
    if known == 1:
        known = follow_side(tables, work, state, 1)
    return search_both(tables, work, state, known)


def carry_both(tables: 'float[:]', work: 'float[:]', state: 'float[:]', left: float, right: float):
    """``carry_side`` for both, under ``left`` and ``right`` [N]; the worse outcome."""
    clear_resultant(work)
    status = carry_side(tables, work, state, 0, left)
    if status <= UNLOADED:
        outcome = carry_side(tables, work, state, 1, right)
        if outcome > status:
            status = outcome
    return status


def solve_elastic(tables: 'float[:]', work: 'float[:]', state: 'float[:]', roll: float, left: float, right: float):
    """Roll [rad] at which the wheelset stands under ``left`` and ``right`` [N], and the outcome; outputs are those of the two
    sides.  Starts at the rigid ``roll``, whose smallest gaps are known."""
    first = WORK_SUPPORT
    second = WORK_SUPPORT + SUPPORT_BLOCK
    work[first + SUPPORT_SINK] = 0.0
    work[second + SUPPORT_SINK] = 0.0
    low = -ROLL_LIMIT
    high = ROLL_LIMIT
    before = 0.0
    difference_before = 0.0
    for trial in range(TRIALS):
        state[STATE_ROLL_COUNT] += 1.0
        status = carry_both(tables, work, state, left, right)
        if status > UNLOADED:
            return roll, status
        difference = work[second + SUPPORT_HEIGHT] - work[first + SUPPORT_HEIGHT]
        slope = work[second + SUPPORT_LEVER] + work[first + SUPPORT_LEVER]
        settled = 1
        if trial < FROZEN:
            settled = settled_side(work, 0) * settled_side(work, 1)
            work[first + SUPPORT_SINK] = work[first + SUPPORT_CARRIED]
            work[second + SUPPORT_SINK] = work[second + SUPPORT_CARRIED]
        if trial > 0 and fabs(roll - before) > SLOPE_APART:
            found = (difference - difference_before) / (roll - before)
            if found < slope / SLOPE_FACTOR and found > slope * SLOPE_FACTOR:
                slope = found
        move = 0.0
        if slope < 0.0:
            move = -difference / slope
        elif difference > 0.0:
            move = ELASTIC_TURN
        else:
            move = -ELASTIC_TURN
        if settled == 1 and fabs(move) < ELASTIC_SHARP:
            return roll, status
        if settled == 1 and trial >= FROZEN:
            if difference > 0.0:
                low = roll
            else:
                high = roll
            if high - low < JUMP_SHARP:
                return roll, status
        before = roll
        difference_before = difference
        if move > ELASTIC_TURN:
            move = ELASTIC_TURN
        if move < -ELASTIC_TURN:
            move = -ELASTIC_TURN
        roll += move
        if not (roll > low and roll < high):
            roll = 0.5 * (low + high)
        if turn_to(tables, work, state, roll) == 0:
            return roll, OFF_PROFILE
    return roll, NOT_CONVERGED


def bear_side(tables: 'float[:]', work: 'float[:]', state: 'float[:]', index: int, height: float):
    """The load of a side whose wheelset stands at the vertical shift ``height`` [m]; its outcome, UNLOADED if lifted."""
    sink = height - work[WORK_SIDE + SIDE_BLOCK * index + SIDE_BEST]
    if not sink > 0.0:
        return rest_side(tables, work, state, index)
    if sink > DEEPEST:
        return OFF_PROFILE
    status = press_side(tables, work, state, index, sink)
    if status == VALID:
        count, status = load_side(tables, work, state, index, 0.0, work[FRAME_DEPTH])
    return status


def stand_compliant(tables: 'float[:]', work: 'float[:]', state: 'float[:]'):
    """Compliant contact: the wheelset stands at the height and roll of the inputs; the outcome."""
    roll = work[WORK_INPUTS + IN_ROLL]
    height = work[WORK_INPUTS + IN_VERTICAL_SHIFT]
    place_both(tables, work, roll)
    work[WORK_OUTPUTS + OUT_ROLL] = roll
    work[WORK_OUTPUTS + OUT_VERTICAL_SHIFT] = height
    clear_resultant(work)
    status = VALID
    if search_both(tables, work, state, 0) == 0:
        return OFF_PROFILE
    for index in range(2):
        outcome = bear_side(tables, work, state, index, height)
        if outcome > status:
            status = outcome
    return status
