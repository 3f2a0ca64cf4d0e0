"""Rules for the motion (wheelset_rules.py has the method): wheels that begin to yaw, and the velocities of an
elastic wheelset."""

from ..creep.motion import constraint_residual, set_rates
from ..layout import Inputs, Tables, Work
from ..search.roll import roll_rails, place_both, turn_both
from ..wheelset.depth_rates import DISPLACED, displace_inputs, keep_sides, motion_size, restore_sides
from ..wheelset.rolled_rails import set_reference
from ..wheelset.input_checks import side_force
from ..wheelset.residuals import balance_side
from .elementary_rules import sine_cosine_rule
from .intrinsics import held, nonzero, rate_of, seeded


def place_moving(tables: Tables, work: Work, inputs: Inputs, roll: float):
    """Both wheels at ``roll``; one that begins to yaw is placed as a yawed one."""
    place_both(tables, inputs, work.sides, roll)
    if work.sides[1].place.leaning:
        begin_yaw(work, inputs, roll)
    else:
        begin_yaw(work, inputs, roll)
        if nonzero(rate_of(inputs.left_rail_roll)) or nonzero(rate_of(inputs.right_rail_roll)):
            roll_rails(tables, inputs, work.sides, roll)


def begin_yaw(work: Work, inputs: Inputs, roll: float):
    """Place wheels that begin to yaw as yawed ones."""
    yaw = inputs.yaw
    if yaw == 0.0 and nonzero(rate_of(yaw)):
        sine, cosine = sine_cosine_rule(yaw)
        work.sides[1].place.sin_yaw = sine
        work.sides[1].place.cos_yaw = cosine
        work.sides[1].place.yawed = True
        work.sides[0].place.sin_yaw = -sine
        work.sides[0].place.cos_yaw = cosine
        work.sides[0].place.yawed = True
        for index in range(2):
            place = work.sides[index].place
            if place.leaning:
                place.track_sin_yaw = place.sin_yaw
                place.track_cos_yaw = place.cos_yaw
        turn_both(work.sides, roll)


def follow_residuals(tables: Tables, work: Work, time: float, vertical: float, roll_rate: float):
    """How much faster than the wheelset each side of an elastic one comes down [m/s], from ``time`` [s] before
    to after or, in a standing one, until then (``depth_rates.find_residuals``)."""
    set_rates(work.sides[0].motion, work.sides[1].motion, vertical, roll_rate)
    follow_displaced(tables, work, time, vertical, roll_rate)
    left = work.supports[0].height
    right = work.supports[1].height
    if motion_size(tables, work.inputs) > 0.0:
        follow_displaced(tables, work, -time, vertical, roll_rate)
        time *= 2.0
    else:
        work.supports[0].height = work.wheelset.vertical_shift
        work.supports[1].height = work.wheelset.vertical_shift
    left = (left - work.supports[0].height) / time - vertical
    right = (right - work.supports[1].height) / time - vertical
    if not side_force(work, 0) > 0.0:
        left = constraint_residual(work.sides[0].motion)
    if not side_force(work, 1) > 0.0:
        right = constraint_residual(work.sides[1].motion)
    return left, right


def follow_displaced(tables: Tables, work: Work, time: float, vertical: float, roll_rate: float):
    """Both sides of an elastic wheelset that has moved on by ``time`` [s], each under its load."""
    displace_inputs(work, time)
    height = work.wheelset.vertical_shift + time * vertical
    set_reference(work.sides, height)
    place_moving(tables, work, work.displaced, work.wheelset.roll + time * roll_rate)
    work.contact.filling = False
    for index in range(2):
        force = side_force(work, index)
        if force > 0.0:
            balance_side(tables, work, index, force, height)
    work.contact.filling = True


def follow_rates(tables: Tables, work: Work):
    """Vertical velocity and roll rate of an elastic wheelset: the residuals of both sides vanish
    (``depth_rates.settle_rates``).  Their own derivatives by both are taken where the sides are displaced to: a
    kink may lie on the way, and then those of the heights in between are others.

    A wheelset that stands still has none, but begins to move; time, by which rates are multiplied, is any
    then."""
    vertical = held(work.wheelset.vertical_velocity)
    roll_rate = held(work.wheelset.roll_rate)
    left_motion = work.sides[0].motion
    right_motion = work.sides[1].motion
    speed = motion_size(tables, work.inputs)
    time = 1.0
    if speed > 0.0:
        time = DISPLACED / speed
    keep_sides(work)
    left, right = follow_residuals(tables, work, time, seeded(vertical, 1.0), roll_rate)
    left_vertical = rate_of(left)
    right_vertical = rate_of(right)
    left, right = follow_residuals(tables, work, time, vertical, seeded(roll_rate, 1.0))
    left_roll = rate_of(left)
    right_roll = rate_of(right)
    left, right = follow_residuals(tables, work, time, vertical, roll_rate)
    restore_sides(work)
    left_vertical -= rate_of(left)
    right_vertical -= rate_of(right)
    left_roll -= rate_of(left)
    right_roll -= rate_of(right)
    determinant = left_vertical * right_roll - right_vertical * left_roll
    vertical_rate = (rate_of(right) * left_roll - rate_of(left) * right_roll) / determinant
    rate = (rate_of(left) * right_vertical - rate_of(right) * left_vertical) / determinant
    set_rates(left_motion, right_motion, seeded(vertical, vertical_rate), seeded(roll_rate, rate))
