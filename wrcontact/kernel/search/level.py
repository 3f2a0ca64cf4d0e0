"""Where the wheels could stand at several rolls: the first one from level.

While a flange is less steep than both levers allow, D(roll) = gap_right - gap_left (roll.py) falls and has one zero.  A large
wheel on a steep flange (600 mm on 70 deg), or strong yaw with both flanges on the rails, lets D rise in between, and it has
three.
The roll is then the first zero on the way from level to the side on which D(0) tells that there is one: it depends on nothing
but the pose, and D falls through it.

That no zero lies before a known one is certified.  On that way the contact of the wheel that rises moves towards its flange and
the other's away from it, since rails are convex; so D' is bounded by the steepest places of the wheels between their contacts
at both ends of the way.  Where this does not settle it, the way is halved.
"""

from math import fabs
from typing import Final

from ..layout import (NOT_CONVERGED, OFF_PROFILE, SET_ARM, SET_RADIUS, SET_RAIL, SET_RAIL_Y, SET_SCAN, SET_WHEEL, SIDE_BEST,
                     SIDE_BEST_RAIL, SIDE_BEST_Y, STATE_GAP_COUNT, VALID, WORK_ROLLS)
from ..surface.locus import (PLACE_ARM, PLACE_COS_ROLL, PLACE_COS_YAW, PLACE_RADIUS, PLACE_SHIFT, PLACE_SIN_ROLL, PLACE_SIN_YAW,
                    around_wheel, outline_point)
from ..surface.profile_table import START, height_slope
from .roll import (LEFT, LEFT_PLACE, RIGHT, RIGHT_PLACE, ROLL_LIMIT, close_in, follow_side, newton_move, search_both,
                   some_roll, turn_both)
from .search import (REACH_SHARE, ROW_LEVER, ROW_STEEPEST_BENDS, ROW_Y, SCAN_COUNT, SCAN_NODES, SCAN_ROW, SCAN_STEEPEST,
                     node_below, search_side)

#: Zeros of D closer than this are one [rad]; the gaps between differ by no more than 1e-13 m.
APART: Final[float] = 1e-13
TRIALS: Final[int] = 300
#: How a lever changes with roll and yaw, as shares of what slopes change at first order.
TURNED_SHARE: Final[float] = 1.1
YAWED_SHARE: Final[float] = 1.2
#: Share by which the outline's slope changes faster along a yawed wheel than the profile's.
FASTER: Final[float] = 1.5

# an end of the way, at WORK_ROLLS + ROLL_ENTRY * index: the known zero, then those still to be reached, the nearest last
ENTRY_ROLL: Final[int] = 0
ENTRY_DIFFERENCE: Final[int] = 1     # D there [m]
ENTRY_LEFT: Final[int] = 2           # abscissae of the smallest gaps [m]
ENTRY_RIGHT: Final[int] = 3
ENTRY_SIZE: Final[int] = 4
ENTRY_LIMIT: Final[int] = 60
LEVEL: Final[int] = WORK_ROLLS                          # where the way begins
ENDS: Final[int] = WORK_ROLLS + ENTRY_SIZE              # and its ends


def turned(steep: float, radius: float, arm: float):
    """How fast a lever changes with the roll at most, where profiles are as steep as ``steep`` [m]."""
    return TURNED_SHARE * ((1.0 + steep * steep) * radius + steep * arm + radius)


def lever_beyond(tables: 'float[:]', y: float, roll: float, sine: float):
    """The largest lever of a wheel at ``y`` [m] and beyond, towards the field side, for any roll up to ``roll`` [rad] and the
    yaw whose sine is given."""
    scan = int(tables[SET_SCAN]) + SCAN_NODES
    lever = tables[scan + SCAN_ROW * node_below(tables, y) + ROW_LEVER]
    radius = tables[SET_RADIUS]
    arm = tables[SET_ARM]
    steep = fabs(lever + arm) / radius
    yawed = YAWED_SHARE * 0.5 * steep * (1.0 + steep * steep) * radius * sine * sine
    return lever + turned(steep, radius, arm) * fabs(roll) + yawed


def beside_rail(tables: 'float[:]', work: 'float[:]', at: int, known: float, roll: float, sine: float):
    """1 if all places of a wheel whose levers are not below -``known`` [m] are beside the rail when level, else 0."""
    scan = int(tables[SET_SCAN])
    nodes = scan + SCAN_NODES
    low = -1
    high = int(tables[scan + SCAN_COUNT]) - 1
    while high - low > 1:
        middle = (low + high) // 2
        if known + lever_beyond(tables, tables[nodes + SCAN_ROW * middle + ROW_Y], roll, sine) < 0.0:
            high = middle
        else:
            low = middle
    beside = 1
    if low >= 0:
        reach = REACH_SHARE * sine * sine * tables[SET_RADIUS] * tables[scan + SCAN_STEEPEST]
        furthest = work[at + PLACE_SHIFT] + tables[SET_ARM] + tables[nodes + SCAN_ROW * high + ROW_Y] + reach
        if furthest > tables[SET_RAIL_Y] + tables[int(tables[SET_RAIL]) + START]:
            beside = 0
    return beside


def certainly_first(tables: 'float[:]', work: 'float[:]', state: 'float[:]', roll: float):
    """1 if D falls all the way from level to its zero at ``roll``, as far as the steepest places tell, else 0.

    The wheel that stands higher is known there; of the other one what is not beside the rail when level is taken, or what lies
    beyond its contact when level, for which that one is searched.
    """
    sine = work[RIGHT_PLACE + PLACE_SIN_YAW]
    higher = LEFT
    lower = RIGHT
    lower_place = RIGHT_PLACE
    index = 1
    if roll < 0.0:
        higher = RIGHT
        lower = LEFT
        lower_place = LEFT_PLACE
        index = 0
    known = lever_beyond(tables, work[higher + SIDE_BEST_Y], roll, sine)
    if beside_rail(tables, work, lower_place, known, roll, sine) == 1:
        return 1
    gap = work[lower + SIDE_BEST]
    y = work[lower + SIDE_BEST_Y]
    abscissa = work[lower + SIDE_BEST_RAIL]
    certain = 0
    turn_both(work, 0.0)
    followed = follow_side(tables, work, state, index)
    if search_side(tables, work, lower, work, lower_place, state, followed) == 1:
        if known + lever_beyond(tables, work[lower + SIDE_BEST_Y], roll, sine) < 0.0:
            certain = 1
    turn_both(work, roll)
    work[lower + SIDE_BEST] = gap
    work[lower + SIDE_BEST_Y] = y
    work[lower + SIDE_BEST_RAIL] = abscissa
    return certain


def falls_at_level(tables: 'float[:]', work: 'float[:]', roll: float):
    """1 if D falls through its known zero at ``roll``, and that is level, else 0."""
    falls = 0
    if fabs(roll) < APART:
        difference, move = newton_move(tables, work)
        if fabs(move) < 0.5:
            falls = 1
    return falls


def lever_at(tables: 'float[:]', work: 'float[:]', at: int, y: float):
    """How the gap at ``y`` [m] would change with the roll if the rail there were parallel to the wheel [m]."""
    z, slope = height_slope(tables, int(tables[SET_WHEEL]), y)
    y_track, z_track, outline_slope = outline_point(work, at, y, z, slope)
    sin_phi, cos_phi = around_wheel(work, at, slope)
    arm = work[at + PLACE_ARM] + y
    height = (work[at + PLACE_RADIUS] + z) * cos_phi
    sin_roll = work[at + PLACE_SIN_ROLL]
    cos_roll = work[at + PLACE_COS_ROLL]
    return (-outline_slope * work[at + PLACE_COS_YAW] * (arm * sin_roll + height * cos_roll)
            - arm * cos_roll + height * sin_roll)


def lever_range(tables: 'float[:]', work: 'float[:]', state: 'float[:]', at: int, one: float, other: float):
    """Smallest and largest ``lever_at`` between two places of the wheel [m]."""
    scan = int(tables[SET_SCAN]) + SCAN_NODES
    y = one
    last = other
    if other < one:
        y = other
        last = one
    node = node_below(tables, y)
    before = lever_at(tables, work, at, y)
    state[STATE_GAP_COUNT] += 1.0
    least = before
    most = before
    while y < last:
        bend = tables[scan + SCAN_ROW * node + ROW_STEEPEST_BENDS]
        node += 1
        following = tables[scan + SCAN_ROW * node + ROW_Y]
        if following > last or following <= y:
            following = last
        lever = lever_at(tables, work, at, following)
        state[STATE_GAP_COUNT] += 1.0
        beyond = 0.5 * FASTER * bend * (following - y) * (work[at + PLACE_RADIUS] + work[at + PLACE_ARM])
        least = min(least, min(lever, before) - beyond)
        most = max(most, max(lever, before) + beyond)
        before = lever
        y = following
    return least, most


def note_entry(work: 'float[:]', entry: int, roll: float):
    """Keep what is known of D at ``roll`` [rad]."""
    work[entry + ENTRY_ROLL] = roll
    work[entry + ENTRY_DIFFERENCE] = work[RIGHT + SIDE_BEST] - work[LEFT + SIDE_BEST]
    work[entry + ENTRY_LEFT] = work[LEFT + SIDE_BEST_Y]
    work[entry + ENTRY_RIGHT] = work[RIGHT + SIDE_BEST_Y]
    return 0


def is_clear(tables: 'float[:]', work: 'float[:]', state: 'float[:]', near: int, far: int, sign: float):
    """1 if D certainly has no zero between the entries ``near`` and ``far``, where it has the sign of ``sign`` or, at ``far``, is
    zero; else 0."""
    width = fabs(work[far + ENTRY_ROLL] - work[near + ENTRY_ROLL])
    turn_both(work, 0.5 * (work[far + ENTRY_ROLL] + work[near + ENTRY_ROLL]))
    left_least, left_most = lever_range(tables, work, state, LEFT_PLACE, work[near + ENTRY_LEFT], work[far + ENTRY_LEFT])
    right_least, right_most = lever_range(tables, work, state, RIGHT_PLACE, work[near + ENTRY_RIGHT],
                                          work[far + ENTRY_RIGHT])
    arm = tables[SET_ARM]
    radius = tables[SET_RADIUS]
    steep = (max(max(fabs(left_least), fabs(left_most)), max(fabs(right_least), fabs(right_most))) + arm) / radius
    margin = width * turned(steep, radius, arm)
    least = left_least + right_least - margin
    most = left_most + right_most + margin
    if least >= 0.0 or most <= 0.0:
        return 1
    at_near = sign * work[near + ENTRY_DIFFERENCE]
    at_far = sign * work[far + ENTRY_DIFFERENCE]
    # the lines that bound D from below, from either end
    meet = (at_far - most * width - at_near) / (least - most)
    clear = 0
    if meet >= width or at_near + least * meet > 0.0:
        clear = 1
    return clear


def first_from_level(tables: 'float[:]', work: 'float[:]', state: 'float[:]', roll: float):
    """The first zero [rad] of D from level, and the outcome; D has a zero at ``roll``."""
    note_entry(work, ENDS, roll)
    work[ENDS + ENTRY_DIFFERENCE] = 0.0
    turn_both(work, 0.0)
    if search_both(tables, work, state, 0) == 0:
        return 0.0, OFF_PROFILE
    note_entry(work, LEVEL, 0.0)
    difference = work[LEVEL + ENTRY_DIFFERENCE]
    if difference == 0.0:
        return 0.0, VALID
    sign = 1.0
    first = 0.0
    last = ROLL_LIMIT
    if difference < 0.0:
        sign = -1.0
        first = -ROLL_LIMIT
        last = 0.0
    status = VALID
    if sign * roll < 0.0:
        roll, status = close_in(tables, work, state, 0.5 * (first + last), first, last, 0)
        note_entry(work, ENDS, roll)
        work[ENDS + ENTRY_DIFFERENCE] = 0.0
    end = 0
    trial = 0
    while end >= 0 and status == VALID:
        far = ENDS + ENTRY_SIZE * end
        width = fabs(work[far + ENTRY_ROLL] - work[LEVEL + ENTRY_ROLL])
        if width < APART or is_clear(tables, work, state, LEVEL, far, sign) == 1:
            for i in range(ENTRY_SIZE):
                work[LEVEL + i] = work[far + i]
            end -= 1
        else:
            middle = 0.5 * (work[far + ENTRY_ROLL] + work[LEVEL + ENTRY_ROLL])
            turn_both(work, middle)
            if search_both(tables, work, state, 0) == 0:
                status = OFF_PROFILE
            elif sign * (work[RIGHT + SIDE_BEST] - work[LEFT + SIDE_BEST]) > 0.0:
                end += 1
                note_entry(work, ENDS + ENTRY_SIZE * end, middle)
            else:
                # a zero before: it is the known one now
                near = work[LEVEL + ENTRY_ROLL]
                end = 0
                if sign > 0.0:
                    roll, status = close_in(tables, work, state, middle, near, middle + APART, 0)
                else:
                    roll, status = close_in(tables, work, state, middle, middle - APART, near, 0)
                note_entry(work, ENDS, roll)
                work[ENDS + ENTRY_DIFFERENCE] = 0.0
        trial += 1
        if trial == TRIALS or end >= ENTRY_LIMIT - 2:
            status = NOT_CONVERGED
    if status == VALID:
        turn_both(work, roll)
        search_both(tables, work, state, 0)
    return roll, status


def certified_roll(tables: 'float[:]', work: 'float[:]', state: 'float[:]', guess: float, warm: int):
    """``solve_roll`` from this start alone."""
    roll, status = some_roll(tables, work, state, guess, warm)
    if status == VALID and falls_at_level(tables, work, roll) == 0:
        if certainly_first(tables, work, state, roll) == 0:
            roll, status = first_from_level(tables, work, state, roll)
    return roll, status


def solve_roll(tables: 'float[:]', work: 'float[:]', state: 'float[:]', guess: float, warm: int):
    """Roll [rad] of the wheelset and outcome; the sides' smallest gaps stay in the workspace.

    With ``warm`` = 1 SIDE_BEST_Y holds minima to start from.  A start from which there is no roll does not decide that.
    """
    roll, status = certified_roll(tables, work, state, guess, warm)
    if status != VALID and (guess != 0.0 or warm == 1):
        roll, status = certified_roll(tables, work, state, 0.0, 0)
    return roll, status
