"""Which roll of several: the first root of the difference of both gaps, starting from zero roll.

While a flange is less steep than both levers allow, D(roll) = gap_right - gap_left (roll.py) falls
and has one root. A large wheel on a steep flange (600 mm on 70 deg), or strong yaw with both flanges
on the rails, lets D rise in between, and it has three. The roll is then the first root on the way
from zero roll to the side on which the sign of D(0) says that there is one: it depends on nothing but
the pose, and D falls through it.

That no root lies before a known one is certified. On that way the contact of the wheel that rises
moves towards its flange and the other's away from it, since rails are convex; so D' is bounded by the
steepest places of the wheels between their contacts at both ends of the way. Where this does not
settle it, the way is halved.
"""

from math import fabs
from typing import Final

from ..layout import (
    NOT_CONVERGED,
    OFF_PROFILE,
    ROLL_LIMIT,
    TRIAL_LIMIT,
    VALID,
    Inputs,
    Pair,
    Place,
    RollTrial,
    RollTrials,
    Sides,
    Tables,
    copy,
)
from ..surface.locus import around_wheel, outline_point
from ..surface.tables import height_slope
from .bounds import REACH_SHARE, node_below
from .roll import any_roll, equalize_minima, follow_side, newton_move, roll_between, search_both, turn_both
from .smallest_gap import search_side

#: Roots of D closer than this are one [rad]; the gaps between differ by no more than 1e-13 m.
APART: Final[float] = 1e-13
ROOT_TRIALS: Final[int] = 300
#: Adding and subtracting it rounds to a multiple of GRID, 2^-30.
ROUNDS: Final[float] = 6291456.0
GRID: Final[float] = 9.313225746154785e-10
#: What a search has found differs by less than this from what another start finds [rad, m]; a value this close
#: to the middle between two places of the grid may have been rounded to either.
UNSURE: Final[float] = 2e-12
#: A settled roll and its places of contact are no farther than this from those before [rad, m].
SETTLED_ROLL: Final[float] = 1e-12
SETTLED_PLACE: Final[float] = 1e-9
#: How a lever changes with roll and yaw, as shares of what slopes change at first order [-].
LEVER_TURNED_SHARE: Final[float] = 1.1
LEVER_YAWED_SHARE: Final[float] = 1.2
#: A rolled rail sees the wheelset rolled the other way: shares of its roll and of the wheel's radius by which
#: that changes levers and places at most [-].
ROLLED_RAIL_SHARE: Final[float] = 1.1
#: Share by which the outline's slope changes faster along a yawed wheel than the profile's [-].
FASTER: Final[float] = 1.5


def solve_roll(tables: Tables, inputs: Inputs, sides: Sides, trials: RollTrials, guess: float, warm: bool):
    """Roll [rad] of the wheelset and status; the smallest gaps of both sides are known at it.

    With ``warm`` = 1 ``best_y`` of both sides holds minima to start from. A start from which there is
    no roll does not decide that. The roll and both places of contact depend on the inputs alone, to the last bit.
    """
    roll, status = certified_roll(tables, inputs, sides, trials, guess, warm)
    settled = False
    if status == VALID:
        roll, settled = settled_roll(tables, sides, roll)
    if not settled and (guess != 0.0 or warm):
        roll, status = certified_roll(tables, inputs, sides, trials, 0.0, False)
        if status == VALID:
            roll, settled = settled_roll(tables, sides, roll)
    return roll, status


def on_grid(x: float):
    """The multiple of GRID that is nearest to ``x``."""
    return (x + ROUNDS) - ROUNDS


def is_unsure(x: float) -> bool:
    """Whether ``x`` is so close to the middle between two places of the grid that its last bits decide to
    which of them it is rounded."""
    return fabs(x - on_grid(x)) > 0.5 * GRID - UNSURE


def on_other_grid(x: float):
    """The place of the grid that is nearest to ``x``, or where that is unsure the middle between two."""
    place = on_grid(x)
    if is_unsure(x):
        place = on_grid(x + 0.25 * GRID) - 0.5 * GRID
    return place


def settled_roll(tables: Tables, sides: Sides, roll: float):
    """The ``roll`` [rad] and the known minima once more, from the nearest places of a grid; second value:
    whether they are found there.

    They were found to 1e-14, from somewhere else for every start. The places of the grid are the same for
    all, and so is each bit of what Newton's method finds from there. Where one of the three lies in the
    middle between two places of the grid, two starts may have gone on from different ones, and what they have
    found is rounded to other places.
    """
    left = sides[0].best_y
    right = sides[1].best_y
    sides[0].best_y = on_grid(left)
    sides[1].best_y = on_grid(right)
    settled, found = equalize_minima(tables, sides, on_grid(roll), -ROLL_LIMIT, ROLL_LIMIT)
    if found and (is_unsure(settled) or is_unsure(sides[0].best_y) or is_unsure(sides[1].best_y)):
        sides[0].best_y = on_other_grid(sides[0].best_y)
        sides[1].best_y = on_other_grid(sides[1].best_y)
        settled, found = equalize_minima(tables, sides, on_other_grid(settled), -ROLL_LIMIT, ROLL_LIMIT)
    if (
        found
        and fabs(settled - roll) < SETTLED_ROLL
        and fabs(sides[0].best_y - left) < SETTLED_PLACE
        and fabs(sides[1].best_y - right) < SETTLED_PLACE
    ):
        return settled, True
    sides[0].best_y = left
    sides[1].best_y = right
    turn_both(sides, roll)
    search_both(tables, sides, False)
    return roll, False


def certified_roll(
    tables: Tables, inputs: Inputs, sides: Sides, trials: RollTrials, guess: float, warm: bool
):
    """``solve_roll`` from this start alone."""
    roll, status = any_roll(tables, inputs, sides, guess, warm)
    if status == VALID and not falls_at_zero_roll(tables, sides, roll):
        if not is_certainly_first(tables, sides, roll):
            roll, status = first_root(tables, sides, trials, roll)
    return roll, status


def falls_at_zero_roll(tables: Tables, sides: Sides, roll: float) -> bool:
    """Whether D falls through its known root at ``roll``, and that is zero roll."""
    falls = False
    if fabs(roll) < APART:
        difference, move = newton_move(tables, sides)
        if fabs(move) < 0.5:
            falls = True
    return falls


# --- the first certificate: the steepest places of the wheels ---------------------------------------------


def lever_per_roll(steep: float, radius: float, arm: float):
    """How fast a lever changes with the roll at most [m], where profiles are as steep as ``steep`` [-]."""
    return LEVER_TURNED_SHARE * ((1.0 + steep * steep) * radius + steep * arm + radius)


def largest_lever_beyond(pair: Pair, y: float, roll: float, sine: float):
    """The largest lever [m] of a wheel at ``y`` [m] and beyond, towards the field side, for any roll up to
    ``roll`` [rad] and the yaw whose sine is given."""
    scan = pair.scan
    lever = scan.nodes[node_below(scan, y)].lever
    radius = pair.radius
    arm = pair.tables.arm
    steep = fabs(lever + arm) / radius
    yawed = LEVER_YAWED_SHARE * 0.5 * steep * (1.0 + steep * steep) * radius * sine * sine
    return lever + lever_per_roll(steep, radius, arm) * fabs(roll) + yawed


def is_beside_rail(pair: Pair, at: Place, known: float, roll: float, sine: float) -> bool:
    """Whether all places of a wheel whose levers are not below -``known`` [m] are beside the
    rail at zero roll."""
    scan = pair.scan
    low = -1
    high = scan.count - 1
    while high - low > 1:
        middle = (low + high) // 2
        if known + largest_lever_beyond(pair, scan.nodes[middle].y, roll, sine) < 0.0:
            high = middle
        else:
            low = middle
    beside = True
    if low >= 0:
        reach = REACH_SHARE * sine * sine * pair.radius * scan.steepest
        reach += ROLLED_RAIL_SHARE * pair.radius * fabs(at.rail_sin)
        furthest = at.shift + pair.tables.arm + scan.nodes[high].y + reach
        if furthest > pair.rail_y + pair.rail.start:
            beside = False
    return beside


def is_certainly_first(tables: Tables, sides: Sides, roll: float) -> bool:
    """Whether D falls all the way from zero roll to its root at ``roll``, as far as the
    steepest places tell.

    The contact of the wheel that stands higher is known there. Of the other wheel count the
    places that are not beside the rail at zero roll; or those beyond its contact at zero
    roll, for which that one is searched.
    """
    sine = sides[1].place.sin_yaw
    turned = fabs(roll) + ROLLED_RAIL_SHARE * max(
        fabs(sides[0].place.rail_sin), fabs(sides[1].place.rail_sin)
    )
    certain = False
    if roll < 0.0:
        known = largest_lever_beyond(tables.pairs[1], sides[1].best_y, turned, sine)
        certain = is_beside_rail(tables.pairs[0], sides[0].place, known, turned, sine)
        if not certain:
            certain = falls_from_zero_roll(tables.pairs[0], sides, 0, known, roll, turned)
    else:
        known = largest_lever_beyond(tables.pairs[0], sides[0].best_y, turned, sine)
        certain = is_beside_rail(tables.pairs[1], sides[1].place, known, turned, sine)
        if not certain:
            certain = falls_from_zero_roll(tables.pairs[1], sides, 1, known, roll, turned)
    return certain


def falls_from_zero_roll(
    pair: Pair, sides: Sides, index: int, known: float, roll: float, turned: float
) -> bool:
    """Whether D falls from zero roll to ``roll`` [rad] by the places of the lower wheel, that of side
    ``index``, beyond its contact at zero roll; the levers of the higher one are not above ``known`` [m], and
    either wheel is rolled against its rail by up to ``turned`` [rad]."""
    lower = sides[index]
    gap = lower.best
    y = lower.best_y
    abscissa = lower.best_rail
    certain = False
    turn_both(sides, 0.0)
    followed = follow_side(pair, lower)
    if search_side(pair, lower, followed):
        if known + largest_lever_beyond(pair, lower.best_y, turned, sides[1].place.sin_yaw) < 0.0:
            certain = True
    turn_both(sides, roll)
    lower.best = gap
    lower.best_y = y
    lower.best_rail = abscissa
    return certain


# --- the second certificate: the places of the wheels between their contacts ------------------------------


def lever_at(pair: Pair, at: Place, y: float):
    """How the gap at ``y`` [m] would change with the roll if the rail there were
    parallel to the wheel [m]."""
    z, slope = height_slope(pair.wheel, y)
    y_track, z_track, outline_slope = outline_point(at, y, z, slope)
    sin_phi, cos_phi = around_wheel(at, slope)
    arm = at.arm + y
    height = (at.radius + z) * cos_phi
    sin_roll = at.sin_roll
    cos_roll = at.cos_roll
    return (
        -outline_slope * at.cos_yaw * (arm * sin_roll + height * cos_roll)
        - arm * cos_roll
        + height * sin_roll
    )


def lever_range(pair: Pair, at: Place, one: float, other: float):
    """Smallest and largest ``lever_at`` between two places of the wheel [m]."""
    scan = pair.scan
    y = one
    last = other
    if other < one:
        y = other
        last = one
    node = node_below(scan, y)
    before = lever_at(pair, at, y)
    at.gap_count += 1.0
    least = before
    most = before
    while y < last:
        bend = scan.nodes[node].steepest_bends[0]
        node += 1
        following = scan.nodes[node].y
        if following > last or following <= y:
            following = last
        lever = lever_at(pair, at, following)
        at.gap_count += 1.0
        beyond = 0.5 * FASTER * bend * (following - y) * (at.radius + at.arm)
        least = min(least, min(lever, before) - beyond)
        most = max(most, max(lever, before) + beyond)
        before = lever
        y = following
    return least, most


def note_trial(trial: RollTrial, sides: Sides, roll: float):
    """Note what is known of D at ``roll`` [rad]."""
    trial.roll = roll
    trial.difference = sides[1].best - sides[0].best
    trial.left = sides[0].best_y
    trial.right = sides[1].best_y


def note_root(trial: RollTrial, sides: Sides, roll: float):
    """Note a root of D at ``roll`` [rad]."""
    note_trial(trial, sides, roll)
    trial.difference = 0.0


def has_no_root(tables: Tables, sides: Sides, near: RollTrial, far: RollTrial, sign: float) -> bool:
    """Whether D certainly has no root between the rolls ``near`` and ``far``, where it has the sign of
    ``sign`` or, at ``far``, is zero."""
    width = fabs(far.roll - near.roll)
    turn_both(sides, 0.5 * (far.roll + near.roll))
    left_least, left_most = lever_range(tables.pairs[0], sides[0].place, near.left, far.left)
    right_least, right_most = lever_range(tables.pairs[1], sides[1].place, near.right, far.right)
    arm = tables.arm
    radius = max(tables.pairs[0].radius, tables.pairs[1].radius)
    steep = (
        max(max(fabs(left_least), fabs(left_most)), max(fabs(right_least), fabs(right_most))) + arm
    ) / min(tables.pairs[0].radius, tables.pairs[1].radius)
    margin = width * lever_per_roll(steep, radius, arm)
    least = left_least + right_least - margin
    most = left_most + right_most + margin
    if least >= 0.0 or most <= 0.0:
        return True
    at_near = sign * near.difference
    at_far = sign * far.difference
    # the lines that bound D from below, from either end
    meet = (at_far - most * width - at_near) / (least - most)
    return meet >= width or at_near + least * meet > 0.0


def first_root(tables: Tables, sides: Sides, trials: RollTrials, roll: float):
    """The first root [rad] of D from zero roll, and the status; D has a root at ``roll``."""
    near = trials.near
    note_root(trials.far[0], sides, roll)
    turn_both(sides, 0.0)
    if not search_both(tables, sides, False):
        return 0.0, OFF_PROFILE
    note_trial(near, sides, 0.0)
    if near.difference == 0.0:
        return 0.0, VALID
    sign = 1.0
    first = 0.0
    last = ROLL_LIMIT
    if near.difference < 0.0:
        sign = -1.0
        first = -ROLL_LIMIT
        last = 0.0
    status = VALID
    if sign * roll < 0.0:
        roll, status = roll_between(tables, sides, 0.5 * (first + last), first, last, False)
        note_root(trials.far[0], sides, roll)
    end = 0
    trial = 0
    while end >= 0 and status == VALID:
        far = trials.far[end]
        width = fabs(far.roll - near.roll)
        if width < APART or has_no_root(tables, sides, near, far, sign):
            copy(far, near)
            end -= 1
        else:
            middle = 0.5 * (far.roll + near.roll)
            turn_both(sides, middle)
            if not search_both(tables, sides, False):
                status = OFF_PROFILE
            elif sign * (sides[1].best - sides[0].best) > 0.0:
                end += 1
                note_trial(trials.far[end], sides, middle)
            else:
                # a root before: it is the known one now
                end = 0
                roll, status = root_before(tables, sides, near.roll, middle, sign)
                note_root(trials.far[0], sides, roll)
        trial += 1
        if trial == ROOT_TRIALS or end >= TRIAL_LIMIT - 2:
            status = NOT_CONVERGED
    if status == VALID:
        turn_both(sides, roll)
        search_both(tables, sides, False)
    return roll, status


def root_before(tables: Tables, sides: Sides, near: float, middle: float, sign: float):
    """A root [rad] of D between the rolls ``near``, where D has the sign of ``sign``, and ``middle``, where
    it has not; and the status."""
    first = near
    last = middle + APART
    if sign < 0.0:
        first = middle - APART
        last = near
    return roll_between(tables, sides, middle, first, last, False)
