"""The rotation of wheels that follows from the torque on their axle, with creep forces that are found in
Python: the search of the kernel (wrcontact/kernel/creep/turning.py), one patch after the other."""

from ..kernel import layout
from ..kernel.creep.motion import are_independent
from ..kernel.creep.turning import (
    TURNS,
    begin_search,
    is_at_jump,
    is_beyond,
    next_rate,
    note_torque,
    stand_in_rate,
)
from ..kernel.wheelset.forces import add_creep_force
from ..kernel.wheelset.free_rolling import nominal_rate, open_turning, turns_freely
from ..kernel.wheelset.input_checks import is_free
from ..kernel.wheelset.rolling_contact import (
    close_rolling,
    move_side,
    open_rolling,
    side_friction,
    write_side_wear,
)

#: The torque that is left is less than this share of that of all friction [-]; the half-space's forces are
#: known to some 1e-3.
BALANCED = 1e-6


class BeyondAdhesion(ArithmeticError):
    """The wheels do not carry the torque on their axle."""


def rub_wheels(tables, work, find):
    """Creep forces of all patches in the workspace, at the rotation that is given or follows, as
    :func:`~wrcontact.kernel.wheelset.rolling_contact.solve_creep_forces` and
    :func:`~wrcontact.kernel.wheelset.free_rolling.roll_freely` find them.

    Parameters
    ----------
    tables : record Tables.
    work : record Work.
    find : called with a side's index and a record Patch, into which it writes what it finds.

    Raises
    ------
    BeyondAdhesion
        where the wheels do not carry ``axle_torque``.
    ArithmeticError
        where no rotation is found.
    """
    together = [(0,), (1,)] if are_independent(tables) else [(0, 1)]
    for wheels in together:
        if turns_freely(tables, work) and is_free(tables, work.inputs, wheels[0]):
            _turn(tables, work, find, wheels)
        else:
            _rub(tables, work, find, wheels)
    for side in work.sides:
        write_side_wear(tables, side)


def _turn(tables, work, find, wheels):
    """Find the rotation of these ``wheels``, indices of sides, with their creep forces."""
    turning = work.turning
    if not open_turning(tables, work, wheels[0], wheels[-1]):
        if turning.wanted != 0.0:
            raise BeyondAdhesion
        _torque(tables, work, find, wheels, nominal_rate(tables, work, wheels[0]))
        return
    work.rolling.resting = True
    try:
        _seek(tables, work, find, wheels, stand_in_rate(turning))
    finally:
        work.rolling.resting = False
    if tables.parameters.friction_fall_rate > 0.0:
        turning.low, turning.high = turning.end_low, turning.end_high
        turning.low_known = turning.high_known = False
        _seek(tables, work, find, wheels, turning.rate)


def _seek(tables, work, find, wheels, rate):
    """Seek the rotation from ``rate`` [rad/s] on."""
    turning = work.turning
    begin_search(turning, rate)
    for _ in range(TURNS):
        note_torque(turning, rate, _torque(tables, work, find, wheels, rate))
        if abs(turning.torque) <= BALANCED * turning.scale or is_at_jump(turning):
            return
        if is_beyond(turning):
            raise BeyondAdhesion
        rate = next_rate(turning)
    raise ArithmeticError("no rotation of the wheels was found")


def _torque(tables, work, find, wheels, rate):
    """Torque of the creep forces about the axle [N m] at ``rate`` [rad/s]."""
    for index in wheels:
        work.turning.rates[index] = work.sides[index].motion.wheel_rate = rate
        move_side(tables, work.sides[index])
    _rub(tables, work, find, wheels)
    torque = 0.0
    for index in wheels:
        side = work.sides[index]
        for patch in side.patches[: side.patch_count]:
            add_creep_force(side.motion, patch)
            torque += patch.forces.driving_torque
    return torque


def _rub(tables, work, find, wheels):
    """Creep forces of the patches of these ``wheels``."""
    for index in wheels:
        side = work.sides[index]
        for number, patch in enumerate(side.patches[: side.patch_count]):
            work.rolling.place = layout.SOLVED_PATCH_LIMIT * index + number
            factor = open_rolling(tables, work.rolling, patch, side_friction(work, index))
            find(index, patch)
            close_rolling(patch, factor)
