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

from ..layout import NOT_CONVERGED, OFF_PROFILE, ROLL_LIMIT, VALID, WORK_ROLLS, Place, State, Tables, Work
from ..surface.locus import around_wheel, outline_point
from ..surface.profile_table import height_slope
from .roll import close_in, follow_side, newton_move, search_both, some_roll, turn_both
from .search import (
    REACH_SHARE,
    ROW_LEVER,
    ROW_STEEPEST_BENDS,
    ROW_Y,
    SCAN_COUNT,
    SCAN_NODES,
    SCAN_ROW,
    SCAN_STEEPEST,
    node_below,
    search_side,
)

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


def lever_beyond(tables: Tables, y: float, roll: float, sine: float):
    """The largest lever of a wheel at ``y`` [m] and beyond, towards the field side, for any roll up to ``roll`` [rad] and the
    yaw whose sine is given."""
    scan = int(tables.scan) + SCAN_NODES
    lever = tables[scan + SCAN_ROW * node_below(tables, y) + ROW_LEVER]
    radius = tables.radius
    arm = tables.arm
    steep = fabs(lever + arm) / radius
    yawed = YAWED_SHARE * 0.5 * steep * (1.0 + steep * steep) * radius * sine * sine
    return lever + turned(steep, radius, arm) * fabs(roll) + yawed


def beside_rail(tables: Tables, work: Work, at: Place, known: float, roll: float, sine: float):
    """1 if all places of a wheel whose levers are not below -``known`` [m] are beside the rail when level, else 0."""
    scan = int(tables.scan)
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
        reach = REACH_SHARE * sine * sine * tables.radius * tables[scan + SCAN_STEEPEST]
        furthest = at.shift + tables.arm + tables[nodes + SCAN_ROW * high + ROW_Y] + reach
        if furthest > tables.rail_y + tables.rail.start:
            beside = 0
    return beside


def certainly_first(tables: Tables, work: Work, state: State, roll: float):
    """1 if D falls all the way from level to its zero at ``roll``, as far as the steepest places tell, else 0.

    The wheel that stands higher is known there; of the other one what is not beside the rail when level is taken, or what lies
    beyond its contact when level, for which that one is searched.
    """
    sine = work.places[1].sin_yaw
    higher = work.sides[0]
    lower = work.sides[1]
    lower_place = work.places[1]
    index = 1
    if roll < 0.0:
        higher = work.sides[1]
        lower = work.sides[0]
        lower_place = work.places[0]
        index = 0
    known = lever_beyond(tables, higher.best_y, roll, sine)
    if beside_rail(tables, work, lower_place, known, roll, sine) == 1:
        return 1
    gap = lower.best
    y = lower.best_y
    abscissa = lower.best_rail
    certain = 0
    turn_both(work, 0.0)
    followed = follow_side(tables, work, state, index)
    if search_side(tables, work, lower, work, lower_place, state, followed) == 1:
        if known + lever_beyond(tables, lower.best_y, roll, sine) < 0.0:
            certain = 1
    turn_both(work, roll)
    lower.best = gap
    lower.best_y = y
    lower.best_rail = abscissa
    return certain


def falls_at_level(tables: Tables, work: Work, roll: float):
    """1 if D falls through its known zero at ``roll``, and that is level, else 0."""
    falls = 0
    if fabs(roll) < APART:
        difference, move = newton_move(tables, work)
        if fabs(move) < 0.5:
            falls = 1
    return falls


def lever_at(tables: Tables, work: Work, at: Place, y: float):
    """How the gap at ``y`` [m] would change with the roll if the rail there were parallel to the wheel [m]."""
    z, slope = height_slope(tables.wheel, y)
    y_track, z_track, outline_slope = outline_point(at, y, z, slope)
    sin_phi, cos_phi = around_wheel(at, slope)
    arm = at.arm + y
    height = (at.radius + z) * cos_phi
    sin_roll = at.sin_roll
    cos_roll = at.cos_roll
    return (-outline_slope * at.cos_yaw * (arm * sin_roll + height * cos_roll)
            - arm * cos_roll + height * sin_roll)


def lever_range(tables: Tables, work: Work, state: State, at: Place, one: float, other: float):
    """Smallest and largest ``lever_at`` between two places of the wheel [m]."""
    scan = int(tables.scan) + SCAN_NODES
    y = one
    last = other
    if other < one:
        y = other
        last = one
    node = node_below(tables, y)
    before = lever_at(tables, work, at, y)
    state.gap_count += 1.0
    least = before
    most = before
    while y < last:
        bend = tables[scan + SCAN_ROW * node + ROW_STEEPEST_BENDS]
        node += 1
        following = tables[scan + SCAN_ROW * node + ROW_Y]
        if following > last or following <= y:
            following = last
        lever = lever_at(tables, work, at, following)
        state.gap_count += 1.0
        beyond = 0.5 * FASTER * bend * (following - y) * (at.radius + at.arm)
        least = min(least, min(lever, before) - beyond)
        most = max(most, max(lever, before) + beyond)
        before = lever
        y = following
    return least, most


def note_entry(work: Work, entry: int, roll: float):
    """Keep what is known of D at ``roll`` [rad]."""
    work[entry + ENTRY_ROLL] = roll
    work[entry + ENTRY_DIFFERENCE] = work.sides[1].best - work.sides[0].best
    work[entry + ENTRY_LEFT] = work.sides[0].best_y
    work[entry + ENTRY_RIGHT] = work.sides[1].best_y
    return 0


def is_clear(tables: Tables, work: Work, state: State, near: int, far: int, sign: float):
    """1 if D certainly has no zero between the entries ``near`` and ``far``, where it has the sign of ``sign`` or, at ``far``, is
    zero; else 0."""
    width = fabs(work[far + ENTRY_ROLL] - work[near + ENTRY_ROLL])
    turn_both(work, 0.5 * (work[far + ENTRY_ROLL] + work[near + ENTRY_ROLL]))
    left_least, left_most = lever_range(tables, work, state, work.places[0], work[near + ENTRY_LEFT], work[far + ENTRY_LEFT])
    right_least, right_most = lever_range(tables, work, state, work.places[1], work[near + ENTRY_RIGHT],
                                          work[far + ENTRY_RIGHT])
    arm = tables.arm
    radius = tables.radius
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


def first_from_level(tables: Tables, work: Work, state: State, roll: float):
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
            elif sign * (work.sides[1].best - work.sides[0].best) > 0.0:
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


def certified_roll(tables: Tables, work: Work, state: State, guess: float, warm: int):
    """``solve_roll`` from this start alone."""
    roll, status = some_roll(tables, work, state, guess, warm)
    if status == VALID and falls_at_level(tables, work, roll) == 0:
        if certainly_first(tables, work, state, roll) == 0:
            roll, status = first_from_level(tables, work, state, roll)
    return roll, status


def solve_roll(tables: Tables, work: Work, state: State, guess: float, warm: int):
    """Roll [rad] of the wheelset and outcome; the sides' smallest gaps stay in the workspace.

    With ``warm`` = 1 SIDE_BEST_Y holds minima to start from.  A start from which there is no roll does not decide that.
    """
    roll, status = certified_roll(tables, work, state, guess, warm)
    if status != VALID and (guess != 0.0 or warm == 1):
        roll, status = certified_roll(tables, work, state, 0.0, 0)
    return roll, status
