"""How the rotation of wheels that turn freely, or under a torque, follows the inputs (wheelset_rules.py has the
method)."""

from math import fabs
from ..creep.motion import are_independent
from ..layout import Tables, Work
from ..surface.rails import on_springs
from ..wheelset.forces import add_creep_force
from ..wheelset.free_rolling import UNCARRIED, nominal_rate
from ..wheelset.input_checks import is_free, outer_torque
from ..wheelset.rolling_contact import move_side, open_given_motion, solve_side_creep
from .intrinsics import held, nonzero, rate_of, seeded
from .compliant_rules import follow_compliant


def follow_turning(tables: Tables, work: Work) -> bool:
    """The rotations that follow from the torque on the axle (``free_rolling.roll_freely``); whether their
    rates are not defined."""
    undefined = False
    if are_independent(tables):
        for index in range(2):
            if is_free(tables, work.inputs, index):
                lost = follow_turn(tables, work, index, index)
                undefined = undefined or lost
            else:
                move_side(tables, work.sides[index])
                solve_side_creep(tables, work, index)
    else:
        undefined = follow_turn(tables, work, 0, 1)
    return undefined


def follow_turn(tables: Tables, work: Work, first: int, last: int) -> bool:
    """The rotation of the wheels ``first`` ... ``last``: the torque that is left vanishes; whether it does
    not, or does not change with the rotation."""
    rate = held(work.turning.rates[first])
    torque, scale = follow_torque(tables, work, first, last, rate)
    if not scale > 0.0:
        follow_torque(tables, work, first, last, nominal_rate(tables, work, first))
        return False
    if fabs(torque) > UNCARRIED * scale:
        return True
    missing = rate_of(torque)
    torque, scale = follow_torque(tables, work, first, last, seeded(rate, 1.0))
    slope = rate_of(torque) - missing
    if not nonzero(slope):
        return True
    follow_torque(tables, work, first, last, seeded(rate, -missing / slope))
    return False


def follow_torque(tables: Tables, work: Work, first: int, last: int, rate: float):
    """What ``rate`` leaves of the torques about the axle, and the torque of all friction [N m]."""
    for index in range(first, last + 1):
        work.turning.rates[index] = rate
    if on_springs(tables):
        follow_compliant(tables, work)
        open_given_motion(tables, work)
    scale = 0.0
    torque = outer_torque(tables, work.inputs, first)
    for index in range(first, last + 1):
        side = work.sides[index]
        side.motion.wheel_rate = rate
        move_side(tables, side)
        solve_side_creep(tables, work, index)
        for number in range(side.patch_count):
            patch = side.patches[number]
            add_creep_force(side.motion, patch)
            torque += patch.forces.driving_torque
            scale += held(patch.friction * patch.totals.load * patch.rolling_radius)
    return torque, scale
