"""How the depth of an elastic wheelset changes while it moves: its vertical velocity and roll rate.

Under a load that stays, a wheel sinks deeper where its patches change their shape.  The velocities that
follow from the loads' work (rolling_contact.py) leave this out.  Here both sides are displaced along the run, a
little ahead and as far back, by these velocities, and the heights at which they carry their loads there show
what is missing.  The residual of a side, how much faster than the wheelset it comes down, vanishes in the
velocities that are sought, as that of its height does in equilibrium: the derivatives of both are the same,
and so is the method, Broyden's (elastic.py).
"""

from math import fabs, sqrt
from typing import Final

from ..creep.motion import constraint_residual, set_rates
from ..layout import MODE_ELASTIC, UNLOADED, Inputs, Tables, Work, copy, seldom
from ..normal.normal_contact import residual_rate
from ..search.roll import place_both
from .elastic import find_move, update
from .rolled_rails import set_reference
from .input_checks import is_moving, side_force
from .residuals import balance_side
from .side import begin_trial

#: So far both ways a wheel is displaced against its rail [m].
DISPLACED: Final[float] = 5e-7
#: The velocities are found when they change by less than this share of how fast wheel and rail move [-].
SETTLED: Final[float] = 1e-5
#: Residuals are found so often at most.
PASSES: Final[int] = 6


def follow_depths(tables: Tables, work: Work):
    """Correct the vertical velocity and roll rate of an elastic wheelset by how its depth changes."""
    if tables.mode == MODE_ELASTIC and is_moving(tables, work.inputs):
        right = work.sides[1].motion
        work.wheelset.vertical_velocity = right.vertical
        work.wheelset.roll_rate = right.turn_x * right.ahead_x + right.turn_y * right.ahead_y
        work.wheelset.settled = True
        speed = motion_size(tables, work.inputs)
        if speed > 0.0:
            keep_sides(work)
            settle_rates(tables, work, speed)
            restore_sides(work)


def motion_size(tables: Tables, inputs: Inputs):
    """About how fast wheels and rails move against each other [m/s], but for rolling; smooth, as the velocities
    that are found follow it where a kink lies within the displacement."""
    turning = tables.arm * inputs.yaw_rate
    left_rolling = tables.height * inputs.left_rail_roll_velocity
    right_rolling = tables.height * inputs.right_rail_roll_velocity
    square = inputs.lateral_velocity * inputs.lateral_velocity + turning * turning
    square += (
        inputs.left_rail_lateral_velocity * inputs.left_rail_lateral_velocity
        + inputs.left_rail_vertical_velocity * inputs.left_rail_vertical_velocity
        + left_rolling * left_rolling
    )
    square += (
        inputs.right_rail_lateral_velocity * inputs.right_rail_lateral_velocity
        + inputs.right_rail_vertical_velocity * inputs.right_rail_vertical_velocity
        + right_rolling * right_rolling
    )
    return sqrt(square)


@seldom
def settle_rates(tables: Tables, work: Work, speed: float):
    """The velocities in which both sides' residuals vanish, from those of the loads' work on, which stay
    where none are found."""
    method = work.broyden
    left = work.sides[0].motion
    right = work.sides[1].motion
    vertical = work.wheelset.vertical_velocity
    roll_rate = work.wheelset.roll_rate
    method.move_height = 0.0
    method.move_roll = 0.0
    settled = False
    for i in range(PASSES):
        if not settled and find_residuals(tables, work, vertical, roll_rate, DISPLACED / speed, i > 0):
            update(method, work.supports[0].residual, work.supports[1].residual, False)
            if find_move(method, work.supports, tables.arm, residual_rate(tables)):
                vertical += method.move_height
                roll_rate += method.move_roll / tables.arm
                set_rates(left, right, vertical, roll_rate)
                settled = fabs(method.move_height) + fabs(method.move_roll) < SETTLED * speed and i > 0
    work.wheelset.settled = settled
    if settled:
        work.wheelset.vertical_velocity = vertical
        work.wheelset.roll_rate = roll_rate
    else:
        set_rates(left, right, work.wheelset.vertical_velocity, work.wheelset.roll_rate)


@seldom
def find_residuals(
    tables: Tables, work: Work, vertical: float, roll_rate: float, time: float, central: bool
) -> bool:
    """How much faster than with ``vertical`` [m/s] and ``roll_rate`` [rad/s] each side comes down [m/s],
    until ``time`` [s] from now, or from as long before where it is ``central``; whether the sides carry
    their loads there."""
    found = displace(tables, work, vertical, roll_rate, time)
    left = work.supports[0].height
    right = work.supports[1].height
    work.supports[0].height = work.wheelset.vertical_shift
    work.supports[1].height = work.wheelset.vertical_shift
    if found and central:
        time *= 2.0
        found = displace(tables, work, vertical, roll_rate, -0.5 * time)
    work.supports[0].residual = (left - work.supports[0].height) / time - vertical
    work.supports[1].residual = (right - work.supports[1].height) / time - vertical
    for index in range(2):
        if not side_force(work, index) > 0.0:
            work.supports[index].residual = constraint_residual(work.sides[index].motion)
    return found


@seldom
def displace(tables: Tables, work: Work, vertical: float, roll_rate: float, time: float) -> bool:
    """Move wheelset and rails on by ``time`` [s] and find the heights at which the sides carry their loads;
    whether they do."""
    displace_inputs(work, time)
    height = work.wheelset.vertical_shift + time * vertical
    set_reference(work.sides, height)
    place_both(tables, work.displaced, work.sides, work.wheelset.roll + time * roll_rate)
    begin_trial(work.contact, False, False, True)
    found = True
    for index in range(2):
        force = side_force(work, index)
        if force > 0.0 and found:
            found = balance_side(tables, work, index, force, height) <= UNLOADED
    begin_trial(work.contact, True, False, False)
    return found


def displace_inputs(work: Work, time: float):
    """The inputs of a wheelset and rails that have moved on by ``time`` [s]."""
    inputs = work.inputs
    displaced = work.displaced
    copy(inputs, displaced)
    displaced.lateral_shift += time * inputs.lateral_velocity
    displaced.yaw += time * inputs.yaw_rate
    displaced.left_rail_lateral += time * inputs.left_rail_lateral_velocity
    displaced.left_rail_vertical += time * inputs.left_rail_vertical_velocity
    displaced.left_rail_roll += time * inputs.left_rail_roll_velocity
    displaced.right_rail_lateral += time * inputs.right_rail_lateral_velocity
    displaced.right_rail_vertical += time * inputs.right_rail_vertical_velocity
    displaced.right_rail_roll += time * inputs.right_rail_roll_velocity


def keep_sides(work: Work):
    """Keep what displaced wheels overwrite."""
    for index in range(2):
        support = work.supports[index]
        side = work.sides[index]
        copy(side.point, support.point)
        copy(side.totals, support.totals)
        support.penetration = side.penetration
        support.model_error = side.model_error
        support.patch_count = side.patch_count


def restore_sides(work: Work):
    """Put back what displaced wheels have overwritten."""
    for index in range(2):
        support = work.supports[index]
        side = work.sides[index]
        copy(support.point, side.point)
        copy(support.totals, side.totals)
        side.penetration = support.penetration
        side.model_error = support.model_error
        side.patch_count = support.patch_count
