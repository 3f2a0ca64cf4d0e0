"""The roll of the wheelset: the angle at which both wheels have the same smallest gap.

D(roll) = gap_right - gap_left falls strictly while flanges are less steep than atan(2 arm / radius) (73 deg for
750 mm and 460 mm), so a bracket and Newton with the envelope derivative cannot fail.  D has kinks where minima exchange
rank; there the bracket takes over.
"""

from math import fabs
from typing import Final

from .gap import gap_per_roll
from .layout import (IN_LATERAL_SHIFT, IN_YAW, NOT_CONVERGED, OFF_PROFILE, SET_ARM, SET_RADIUS, SIDE_BEST, SIDE_BEST_Y,
                     STATE_ROLL_COUNT, VALID, WORK_INPUTS, WORK_PLACE, WORK_SIDE, WORK_SIDE_SIZE)
from .locus import PLACE_SIZE, place_wheelset
from .search import REACH, find_minima, follow_minima, scan_side

#: The roll is searched within this [rad]; 12 mm of lateral shift need 0.013.
ROLL_LIMIT: Final[float] = 0.12
#: Newton stops when it moves the roll by less [rad]; rounding of the gaps is 1e-16 m over a lever of 0.2 m and more.
ROLL_SHARP: Final[float] = 1e-14
ROLL_ITERATIONS: Final[int] = 80


def place_both(tables: 'float[:]', work: 'float[:]', roll: float):
    """Both wheels at ``roll``; the left one mirrored into a right one (conventions.MIRROR)."""
    shift = work[WORK_INPUTS + IN_LATERAL_SHIFT]
    yaw = work[WORK_INPUTS + IN_YAW]
    place_wheelset(work, WORK_PLACE, -shift, -yaw, -roll, tables[SET_RADIUS], tables[SET_ARM])
    place_wheelset(work, WORK_PLACE + PLACE_SIZE, shift, yaw, roll, tables[SET_RADIUS], tables[SET_ARM])
    return 0


def search_both(tables: 'float[:]', work: 'float[:]', state: 'float[:]'):
    """Scan and refine both sides; 1 if both wheels are above their rails, else 0."""
    found = 1
    for i in range(2):
        side = WORK_SIDE + WORK_SIDE_SIZE * i
        at = WORK_PLACE + PLACE_SIZE * i
        if scan_side(tables, work, side, work, at, state) == 0:
            found = 0
        else:
            find_minima(tables, work, side, work, at, state)
    return found


def follow_both(tables: 'float[:]', work: 'float[:]', state: 'float[:]'):
    """Refine the known minima of both sides; 1 if all were found again, else 0."""
    found = 1
    for i in range(2):
        if found == 1:
            found = follow_minima(tables, work, WORK_SIDE + WORK_SIDE_SIZE * i, work, WORK_PLACE + PLACE_SIZE * i,
                                  state)
    return found


def solve_roll(tables: 'float[:]', work: 'float[:]', state: 'float[:]', guess: float):
    """Roll [rad] and outcome; the sides' minima stay in the workspace."""
    left = WORK_SIDE
    right = WORK_SIDE + WORK_SIDE_SIZE
    low = -ROLL_LIMIT
    high = ROLL_LIMIT
    roll = guess
    if not (roll > low and roll < high):
        roll = 0.0
    scanned = 1.0
    retried = 0
    for i in range(ROLL_ITERATIONS):
        state[STATE_ROLL_COUNT] += 1.0
        place_both(tables, work, roll)
        known = 0
        if fabs(roll - scanned) < REACH:
            known = follow_both(tables, work, state)
        if known == 0:
            if search_both(tables, work, state) == 0:
                if retried == 1 or roll == 0.0:
                    return roll, OFF_PROFILE
                retried = 1
                roll = 0.0
                low = -ROLL_LIMIT
                high = ROLL_LIMIT
                continue
            scanned = roll
        difference = work[right + SIDE_BEST] - work[left + SIDE_BEST]
        rate = (gap_per_roll(tables, work, WORK_PLACE + PLACE_SIZE, work[right + SIDE_BEST_Y])
                + gap_per_roll(tables, work, WORK_PLACE, work[left + SIDE_BEST_Y]))
        if difference > 0.0:
            low = roll
        else:
            high = roll
        following = 0.5 * (low + high)
        if rate < 0.0:
            move = -difference / rate
            if fabs(move) < ROLL_SHARP:
                return roll, VALID
            if roll + move > low and roll + move < high:
                following = roll + move
        if fabs(following - roll) < ROLL_SHARP:
            return roll, VALID
        roll = following
    return roll, NOT_CONVERGED
