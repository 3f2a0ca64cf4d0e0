"""Height and roll of an elastic wheelset on rails whose section changes: where both wheels carry their loads.

As on constant rails (wheelset/elastic.py) each trial gives the height at which a side carries its load, and Broyden's method
moves height and roll until both are equal; each trial has the rails of its own pose.  In the last one both wheels are searched
anew.  Where loads jump with the roll there may be no equilibrium that the method finds, and the status is NOT_CONVERGED.

How height and roll change in time follows from two more equilibria, a little ahead along the run and as far back.
"""

from math import fabs, sqrt
from typing import Final

from ..contact.penetrated import limited
from ..creep.motion import rolling_rate
from ..layout import (
    INPUT_COUNT,
    LOAD_VERTICAL,
    NOT_CONVERGED,
    OFF_PROFILE,
    ROLL_LIMIT,
    UNLOADED,
    VALID,
    Tables,
    Work,
)
from ..normal.estimate import first_penetration
from ..normal.normal_contact import residual_rate
from ..wheelset.depth_rates import displace_inputs, motion_size
from ..wheelset.elastic import begin_derivatives, find_move, update
from ..wheelset.enclosing import ELASTIC_SHARP, LONGEST_MOVE, NOT_LAST
from ..wheelset.input_checks import is_moving, requested_status, side_force
from ..wheelset.residuals import DEEPEST, SHALLOWEST
from ..wheelset.side import load_side, lower_wheel, touch_side
from .section_roll import find_section_roll, follow_both, touch_both
from .bridges import is_oblique
from .facing_lines import ALL
from .section_side import NEAR, find_in_frame, finish_side, lay_rail

#: Trials at most.
SECTION_TRIALS: Final[int] = 40
#: After a longer move [m] Broyden's formula is taken.
SHORT: Final[float] = 2e-6
#: So far ahead and back along the run [m].
AHEAD: Final[float] = 2e-6


def stand_elastic(tables: Tables, work: Work):
    """The wheelset in equilibrium under its loads, with the patches of both wheels; the status."""
    roll, status = find_section_roll(tables, work)
    if status != VALID:
        return status
    height = 0.5 * (work.touches[0].best + work.touches[1].best)
    status, covered = balance_changing(tables, work, roll, height, NEAR)
    if not covered:
        status, covered = balance_changing(tables, work, roll, height, ALL)
    if not covered:
        return NOT_CONVERGED
    return requested_status(tables, work, status)


def balance_changing(tables: Tables, work: Work, roll: float, height: float, far: float):
    """Equilibrium from the rigid ``roll`` [rad] and ``height`` [m] on, with rails up to gaps of ``far`` [m]; the status, and
    whether the wheels overlap no rail farther away."""
    if not touch_both(tables, work, roll) == VALID:
        return NOT_CONVERGED, True
    method = work.broyden
    method.left = 0.0
    method.right = 0.0
    method.move_height = 0.0
    method.move_roll = 0.0
    status = VALID
    for index in range(2):
        status = max(status, estimate_side(tables, work, index, far))
    if status > UNLOADED:
        return status, far >= ALL
    height += 0.5 * (work.supports[0].approach + work.supports[1].approach)
    last = False
    for trial in range(SECTION_TRIALS):
        work.contact.filling = last
        status = VALID
        for index in range(2):
            status = max(status, press_side(tables, work, index, height, far))
        if status > UNLOADED:
            return NOT_CONVERGED, far >= ALL
        if trial == 0:
            begin_derivatives(method, work.supports, tables.arm, residual_rate(tables))
        moved = fabs(method.move_height) + fabs(method.move_roll)
        update(
            method,
            work.supports[0].height - height,
            work.supports[1].height - height,
            moved < SHORT,
        )
        if not find_move(method, work.supports, tables.arm, residual_rate(tables)):
            return NOT_CONVERGED, far >= ALL
        moved = fabs(method.move_height) + fabs(method.move_roll)
        if last and moved < NOT_LAST:
            work.wheelset.roll = roll
            work.wheelset.vertical_shift = height
            return finish_both(tables, work, status, far)
        method.move_height = limited(method.move_height, LONGEST_MOVE)
        method.move_roll = limited(method.move_roll, LONGEST_MOVE)
        height += method.move_height
        roll += method.move_roll / tables.arm
        if not fabs(roll) < ROLL_LIMIT:
            return NOT_CONVERGED, far >= ALL
        last = moved < ELASTIC_SHARP
        found = False
        if not last:
            found = follow_both(tables, work, roll)
        if not found:
            if not touch_both(tables, work, roll) == VALID:
                return NOT_CONVERGED, True
    return NOT_CONVERGED, far >= ALL


def frame_force(tables: Tables, work: Work, index: int):
    """The force of side ``index`` [N] that is prescribed in its frame."""
    force = side_force(work, index)
    if tables.load == LOAD_VERTICAL:
        force /= tables.pairs[index].sections.frame.down[2]
    return force


def estimate_side(tables: Tables, work: Work, index: int, far: float):
    """Estimate how far the wheel of side ``index`` comes down below its smallest gap; the status."""
    support = work.supports[index]
    touch = work.touches[index]
    support.approach = 0.0
    if not side_force(work, index) > 0.0:
        return UNLOADED
    if not lay_rail(tables, work, index, touch.best, far, 0.0):
        return NOT_CONVERGED
    if not find_in_frame(tables.pairs[index], work.sides[index], touch.y):
        return NOT_CONVERGED
    status = touch_side(tables, work, index)
    if status <= UNLOADED:
        down = tables.pairs[index].sections.frame.down[2]
        depth = first_penetration(tables.pairs[index], work.contact, frame_force(tables, work, index))
        support.approach = depth / work.contact.frame.plane.cos / down
    return status


def press_side(tables: Tables, work: Work, index: int, height: float, far: float):
    """The height at which side ``index`` carries its load with the rail and the regions at ``height`` [m], into its support;
    the status."""
    pair = tables.pairs[index]
    support = work.supports[index]
    touch = work.touches[index]
    side = work.sides[index]
    support.lever = touch.rate
    if not side_force(work, index) > 0.0:
        support.height = touch.best
        if not lay_rail(tables, work, index, touch.best, far, 0.0) or not find_in_frame(pair, side, touch.y):
            return NOT_CONVERGED
        return touch_side(tables, work, index)
    approach = min(max(height - touch.best, SHALLOWEST * support.approach), DEEPEST)
    if not lay_rail(tables, work, index, touch.best + approach, far, 0.0):
        return NOT_CONVERGED
    if not find_in_frame(pair, side, touch.y):
        return NOT_CONVERGED
    down = pair.sections.frame.down[2]
    side.best = -approach * down
    status = lower_wheel(tables, work, index, approach * down)
    if status != VALID:
        return status
    count, status = load_side(tables, work, index, frame_force(tables, work, index), tables.absent)
    more = (side.penetration - work.contact.frame.depth) / work.contact.frame.plane.cos
    support.height = touch.best + approach + more / down
    return status


def finish_both(tables: Tables, work: Work, status: int, far: float):
    """Turn both sides back into the track: the status, and whether enough of their rails was laid."""
    covered = True
    for index in range(2):
        touch = work.touches[index]
        height = work.wheelset.vertical_shift
        if not side_force(work, index) > 0.0:
            height = touch.best
        if height - touch.best > DEEPEST:
            return OFF_PROFILE, True
        side_status, enough = finish_side(tables, work, index, VALID, height, height - touch.best)
        status = max(status, side_status)
        if side_status == VALID and is_oblique(tables.pairs[index].sections, 0.0):
            status = NOT_CONVERGED
        covered = covered and enough
    return status, covered or far >= ALL


def find_section_rates(tables: Tables, work: Work):
    """Find the vertical velocity [m/s] and roll rate [rad/s] of the wheelset along its run, before it is solved itself; the
    status."""
    wheelset = work.wheelset
    wheelset.vertical_velocity = 0.0
    wheelset.roll_rate = 0.0
    size = motion_size(tables, work.inputs)
    speed = sqrt(size * size + work.inputs.speed * work.inputs.speed)
    if not (speed > 0.0 and is_moving(tables, work.inputs)):
        return VALID
    time = AHEAD / speed
    status = stand_displaced(tables, work, time)
    height = wheelset.vertical_shift
    roll = wheelset.roll
    if status <= UNLOADED:
        status = stand_displaced(tables, work, -time)
        wheelset.vertical_velocity = 0.5 * (height - wheelset.vertical_shift) / time
        wheelset.roll_rate = 0.5 * (roll - wheelset.roll) / time
    return status


def stand_displaced(tables: Tables, work: Work, time: float):
    """The equilibrium of a wheelset that has moved on by ``time`` [s], and its wheels with it, at the rate that is given or that of
    the nominal radius; the status.  Over rollers it stays where it is."""
    displace_inputs(work, time)
    work.displaced.wheel_rotation += time * rolling_rate(work.inputs, work.inputs.wheel_rate, tables.height)
    if not (tables.pairs[0].roller > 0.0 or tables.pairs[1].roller > 0.0):
        work.displaced.track_position += time * work.inputs.speed
    exchange_inputs(work)
    status = stand_elastic(tables, work)
    exchange_inputs(work)
    return status


def exchange_inputs(work: Work):
    """Let the inputs be those of the wheelset that has moved on, and back."""
    for i in range(INPUT_COUNT):
        kept = work.inputs[i]
        work.inputs[i] = work.displaced[i]
        work.displaced[i] = kept
