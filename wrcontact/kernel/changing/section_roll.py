"""The smallest gaps of both wheels over rails whose section changes, and the roll at which they are equal."""

from math import fabs
from typing import Final

from ..elementary.circle import sine_cosine
from ..layout import (
    NOT_CONVERGED,
    OFF_PROFILE,
    ROLL_LIMIT,
    VALID,
    Inputs,
    Pair,
    SectionSearch,
    SectionTouch,
    Tables,
    Work,
)
from ..sections.section_gap import turned_back
from ..sections.section_search import MOST_BOXES, follow_sections, probe_sections, search_sections
from ..sections.wheel_radius import radius_jet, within_turn
from ..surface.locus import mirror_place, place_wheelset
from ..surface.rails import move_rail

#: Newton's method stops when it moves the roll by less [rad], and rolls that differ by less are one.
ROLL_SHARP: Final[float] = 1e-14
SEARCHES: Final[int] = 80
#: Minima are followed in so many steps at most, none longer than this [rad].
FOLLOW_STEPS: Final[int] = 12
LONGEST_TURN: Final[float] = 0.03
#: Gaps that still differ by more than this when no roll is left between jump there [m].
EQUAL: Final[float] = 1e-9
#: Slopes of the smallest gap by the abscissa [-] and the angle [m]; larger ones are those of the end of a profile.
LEVEL_ACROSS: Final[float] = 1e-6
LEVEL_AROUND: Final[float] = 1e-7


def place_touches(tables: Tables, inputs: Inputs, work: Work, roll: float):
    """Both wheels at ``roll`` [rad], the left one mirrored, over rails where they are displaced."""
    right = work.touches[1].place
    left = work.touches[0].place
    place_wheelset(
        right,
        inputs.lateral_shift,
        inputs.yaw,
        roll,
        tables.pairs[1].radius,
        tables.height,
        tables.arm,
    )
    mirror_place(right, left, tables.pairs[0].radius)
    left.rail_lateral = 0.0
    left.rail_vertical = 0.0
    move_rail(right, inputs.right_rail_lateral, inputs.right_rail_vertical)
    move_rail(left, -inputs.left_rail_lateral, inputs.left_rail_vertical)


def touch_rail(tables: Tables, work: Work, index: int):
    """Search the smallest gap of the wheel that is placed on side ``index``; the outcome."""
    pair = tables.pairs[index]
    search = work.section_search
    touch = work.touches[index]
    pair.rail_y = pair.sections.lateral
    search.position = work.inputs.track_position
    search.rotation = within_turn(work.inputs.wheel_rotation)
    certain = search_sections(pair, touch.place, search)
    keep_touch(pair, search, touch)
    if search.box_count > MOST_BOXES:
        return NOT_CONVERGED
    if not certain:
        return OFF_PROFILE
    if not (fabs(search.at.across) < LEVEL_ACROSS and fabs(search.at.around) < LEVEL_AROUND):
        return OFF_PROFILE
    return VALID


def keep_touch(pair: Pair, search: SectionSearch, touch: SectionTouch):
    """Note what the search has found, and how the gap there follows the roll."""
    at = search.at
    touch.best = search.best
    touch.y = search.best_y
    touch.angle = search.best_angle
    touch.rail_x = at.x
    touch.rail_y = at.y
    touch.along = at.along
    touch.slope = at.slope
    place = touch.place
    sine, cosine = sine_cosine(touch.angle)
    r, r_y, r_yy, r_f, r_fy, r_ff = radius_jet(pair, place, search.rotation, touch.y, touch.angle)
    arm = place.arm + touch.y
    down = arm * place.sin_roll + r * cosine * place.cos_roll
    level = arm * place.cos_roll - r * cosine * place.sin_roll
    touch.rail_z = down - place.height + touch.best
    ahead, aside, into = turned_back(place, at.along, at.slope)
    touch.turn_rate = r_f * (ahead * sine + into * cosine)
    touch.rate = at.along * place.sin_yaw * down - at.slope * place.cos_yaw * down - level


def touch_both(tables: Tables, work: Work, roll: float):
    """Place both wheels at ``roll`` [rad] and search their smallest gaps; the worse outcome."""
    place_touches(tables, work.inputs, work, roll)
    status = touch_rail(tables, work, 0)
    outcome = touch_rail(tables, work, 1)
    return max(status, outcome)


def probe_both(tables: Tables, work: Work, roll: float):
    """Place both wheels at ``roll`` [rad] and note the minima that a few places lead to."""
    place_touches(tables, work.inputs, work, roll)
    work.section_search.position = work.inputs.track_position
    work.section_search.rotation = within_turn(work.inputs.wheel_rotation)
    for index in range(2):
        pair = tables.pairs[index]
        pair.rail_y = pair.sections.lateral
        probe_sections(pair, work.touches[index].place, work.section_search)
        keep_touch(pair, work.section_search, work.touches[index])


def follow_both(tables: Tables, work: Work, roll: float) -> bool:
    """Follow the minima that are known of both wheels to another ``roll`` [rad]; whether they are found."""
    place_touches(tables, work.inputs, work, roll)
    for index in range(2):
        pair = tables.pairs[index]
        touch = work.touches[index]
        if not follow_sections(pair, touch.place, work.section_search, touch.y, touch.angle):
            return False
        keep_touch(pair, work.section_search, touch)
    return True


def newton_roll(work: Work):
    """D [m] at the minima that are known, and Newton's move of the roll [rad]; 1 where D does not fall."""
    difference = work.touches[1].best - work.touches[0].best
    rate = work.touches[1].rate + work.touches[0].rate
    move = 1.0
    if rate < 0.0:
        move = -difference / rate
    return difference, move


def equalize_touches(tables: Tables, work: Work, roll: float, low: float, high: float):
    """The roll [rad] between ``low`` and ``high`` at which the minima that are known near ``roll`` are equal, or ``roll``
    itself where they are lost."""
    following = roll
    for i in range(FOLLOW_STEPS):
        difference, move = newton_roll(work)
        following += move
        if not (following > low and following < high and fabs(move) < LONGEST_TURN):
            return roll
        if not follow_both(tables, work, following):
            return roll
        if fabs(move) < ROLL_SHARP:
            return following
    return roll


def find_section_roll(tables: Tables, work: Work):
    """The roll [rad] at which both wheels touch, and the outcome; the gaps are known at it.

    Their difference D falls with the roll; Newton's method with the derivative at fixed places of the wheels, which by the
    envelope theorem is that of the smallest gaps, follows two minima to the roll at which they are equal.  There both
    sides are searched: if nothing is smaller this is the roll, otherwise the smaller minima are followed, within a bracket.
    D has to fall at the root that is found; whether there are others, which takes flanges steeper than about 73 degrees, is
    not looked at.
    """
    low = -ROLL_LIMIT
    high = ROLL_LIMIT
    difference = 0.0
    probe_both(tables, work, 0.0)
    roll = equalize_touches(tables, work, 0.0, low, high)
    for i in range(SEARCHES):
        status = touch_both(tables, work, roll)
        if status == NOT_CONVERGED:
            return roll, status
        difference, move = newton_roll(work)
        if status == VALID and fabs(move) < ROLL_SHARP:
            return roll, VALID
        if status != VALID and difference == 0.0:
            return roll, OFF_PROFILE
        if difference > 0.0:
            low = roll
        else:
            high = roll
        if high - low < ROLL_SHARP:
            break
        if status != VALID or not (roll + move > low and roll + move < high):
            following = 0.5 * (low + high)
        else:
            following = equalize_touches(tables, work, roll, low, high)
            if following == roll:
                following = roll + move
        if following == roll:
            break
        roll = following
    if status == VALID and move < 1.0 and fabs(difference) < EQUAL:
        return roll, VALID
    if status != VALID:
        return roll, status
    return roll, NOT_CONVERGED
