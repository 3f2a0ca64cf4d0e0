"""The rotation of wheels about their axle that follows from the torque on it: zero where they roll freely.

Contact does not change with the rotation, unless rails stand on springs.  For each rate that is tried the
patches have other creepages, and so other creep forces; what is sought is the rate at which their torque
about the axle cancels the one from outside (creep/turning.py).  Both wheels of a wheelset have one rate;
independent wheels have their own.

Where friction falls with the sliding velocity, the torque may rise with the rate, and there may be several
rates.  The one that is taken is that with the friction of rest, followed as friction begins to fall: from
there the first one to the side to which the torque turns the wheels.  A torque from outside which only the
friction of rest carries has none: rates are tried at growing distances until the torque is carried, or the
creep forces carry less again.

Without creep forces or friction no torque tells the rate, which is then that of the nominal radius.
"""

from math import fabs
from typing import Final

from ..creep.friction import set_friction
from ..creep.motion import are_independent
from ..creep.turning import (
    TURNS,
    add_stand_in,
    begin_search,
    begin_turning,
    is_at_jump,
    is_balanced,
    is_beyond,
    next_rate,
    note_torque,
    reopen_enclosure,
    stand_in,
    stand_in_rate,
    widen_enclosure,
)
from ..layout import (
    BEYOND_ADHESION,
    NOT_CONVERGED,
    TANGENTIAL_FASTRIP,
    TANGENTIAL_FASTSIM,
    TANGENTIAL_POLACH,
    TANGENTIAL_STRIPS,
    UNLOADED,
    VALID,
    Tables,
    Work,
)
from ..surface.rails import on_springs
from .compliant import leave_jumps, turn_compliant
from .input_checks import has_creep_forces, is_free, outer_torque
from .leaning_wheel import enclose_wheel, force_one, move_one, move_wheel
from .rolling_contact import open_given_motion, solve_wheel_creep, side_friction, write_side_wear

#: Growth of the distances at which rates are tried where friction falls.
GROWTH: Final[float] = 1.5
#: The largest torque that falling friction carries is found when the rates around it differ by less than this
#: share [-].
PEAK_SHARP: Final[float] = 1e-7
#: A torque that is left beyond this share of that of all friction tells of a jump of the creep forces [-].
UNCARRIED: Final[float] = 1e-7


def release_rates(tables: Tables, work: Work):
    """Wheels whose rotation follows begin with that of their nominal radius."""
    turning = work.turning
    turning.sought = False
    for index in range(2):
        turning.rates[index] = nominal_rate(tables, work, index)


def nominal_rate(tables: Tables, work: Work, index: int):
    """The rotation of a wheel that rolls on its nominal radius [rad/s]."""
    radius = tables.height
    if are_independent(tables):
        radius = tables.pairs[index].radius
    return work.inputs.speed / radius


def turns_freely(tables: Tables, work: Work) -> bool:
    """Whether the rotation of some wheel follows."""
    free = is_free(tables, work.inputs, 0) or is_free(tables, work.inputs, 1)
    return free and has_creep_forces(tables, work)


def roll_freely(tables: Tables, work: Work):
    """Creepages and creep forces of all patches, with the rotations that follow; VALID, or why there are
    none."""
    if are_independent(tables):
        status = VALID
        for index in range(2):
            outcome = VALID
            if is_free(tables, work.inputs, index):
                outcome = turn(tables, work, index, index)
            else:
                solve_creep_at(tables, work, index, index, work.sides[index].motion.wheel_rate)
            status = max(status, outcome)
    else:
        status = turn(tables, work, 0, 1)
    work.turning.sought = True
    if status == VALID:
        write_side_wear(tables, work.sides[0])
        write_side_wear(tables, work.sides[1])
    return status


def turn(tables: Tables, work: Work, first: int, last: int):
    """Find the rotation of the wheels ``first`` ... ``last``, with their creep forces; the outcome."""
    turning = work.turning
    rolling = work.rolling
    found = open_turning(tables, work, first, last)
    if not found:
        status = VALID
        if turning.wanted != 0.0:
            status = BEYOND_ADHESION
        torque, outcome = torque_at(tables, work, first, last, nominal_rate(tables, work, first))
        return max(status, outcome)
    start = stand_in_rate(turning)
    if turning.sought and turning.rates[first] > turning.low and turning.rates[first] < turning.high:
        start = turning.rates[first]
    if not is_known_model(tables):
        torque, status = torque_at(tables, work, first, last, start)
        return status
    rolling.keeping = not on_springs(tables)
    rolling.kept = False
    rolling.resting = True
    status = seek(tables, work, first, last, start)
    if status <= UNLOADED and on_springs(tables):
        left, status = leave_jumps(tables, work, first, last)
        if left and status <= UNLOADED:
            reopen_enclosure(turning)
            status = seek(tables, work, first, last, turning.rates[first])
    rolling.resting = False
    if tables.parameters.friction_fall_rate > 0.0 and status <= UNLOADED:
        status = seek_falling(tables, work, first, last)
    rolling.keeping = False
    return status


def is_known_model(tables: Tables) -> bool:
    """Whether the kernel has the chosen model of creep forces."""
    model = tables.tangential
    return (
        model == TANGENTIAL_STRIPS
        or model == TANGENTIAL_FASTSIM
        or model == TANGENTIAL_FASTRIP
        or model == TANGENTIAL_POLACH
    )


def open_turning(tables: Tables, work: Work, first: int, last: int) -> bool:
    """Enclosure and stand-in of the wheels ``first`` ... ``last``; whether any friction turns them."""
    turning = work.turning
    begin_turning(turning, outer_torque(tables, work.inputs, first), work.inputs.speed)
    for index in range(first, last + 1):
        enclose_wheel(tables, work, index)
    turning.count = 0
    middle = 0.5 * (turning.low + turning.high)
    for index in range(first, last + 1):
        side = work.sides[index]
        side.motion.wheel_rate = middle
        for number in range(side.patch_count):
            patch = side.patches[number]
            set_friction(tables, patch, side_friction(work, index), True)
            if patch.half_width > 0.0 and patch.half_length > 0.0:
                move_one(tables, work, index, number)
            add_stand_in(tables, turning, side.motion, patch, patch.friction)
    widen_enclosure(turning)
    begin_search(turning, middle)
    return turning.scale > 0.0


def torque_at(tables: Tables, work: Work, first: int, last: int, rate: float):
    """Torque of the creep forces about the axle [N m] of the wheels ``first`` ... ``last`` at ``rate``
    [rad/s], and the outcome of their contact, which changes with it on springs."""
    for index in range(first, last + 1):
        work.turning.rates[index] = rate
    if on_springs(tables):
        for index in range(first, last + 1):
            outcome = turn_compliant(tables, work, index)
            if outcome > UNLOADED:
                return 0.0, outcome
        open_given_motion(tables, work)
    return solve_creep_at(tables, work, first, last, rate), VALID


def solve_creep_at(tables: Tables, work: Work, first: int, last: int, rate: float):
    """Creepages and creep forces of wheels whose contact is known, at ``rate`` [rad/s]; their torque about
    the axle [N m], summed as the report sums it."""
    torque = 0.0
    for index in range(first, last + 1):
        side = work.sides[index]
        side.motion.wheel_rate = rate
        move_wheel(tables, work, index)
        own = 0.0
        solve_wheel_creep(tables, work, index)
        for number in range(side.patch_count):
            force_one(tables, work, index, number)
            own += side.patches[number].forces.driving_torque
        torque += own
    return torque


def seek(tables: Tables, work: Work, first: int, last: int, start: float):
    """Seek the rate within the enclosure from ``start`` on; the outcome."""
    turning = work.turning
    begin_search(turning, start)
    rate = start
    for i in range(TURNS):
        status = try_rate(tables, work, first, last, rate)
        if status > UNLOADED or is_balanced(turning):
            return status
        if is_beyond(turning):
            return BEYOND_ADHESION
        if is_at_jump(turning):
            torque, status = torque_at(tables, work, first, last, turning.low)
            return status
        rate = next_rate(turning)
    return NOT_CONVERGED


def try_rate(tables: Tables, work: Work, first: int, last: int, rate: float):
    """Try a rate and keep its torque; the outcome of the contact."""
    torque, status = torque_at(tables, work, first, last, rate)
    work.rolling.kept = True
    if status <= UNLOADED:
        note_torque(work.turning, rate, torque)
    return status


def seek_falling(tables: Tables, work: Work, first: int, last: int):
    """Seek the rate with falling friction, from the one with the friction of rest; the outcome."""
    turning = work.turning
    rate = turning.rates[first]
    reopen_enclosure(turning)
    if turning.wanted != 0.0:
        return leave_rest(tables, work, first, last, rate)
    return seek(tables, work, first, last, rate)


def leave_rest(tables: Tables, work: Work, first: int, last: int, start: float):
    """Seek the first rate beyond ``start`` at which falling friction carries a torque from outside; the
    outcome, BEYOND_ADHESION where it carries less again."""
    turning = work.turning
    begin_search(turning, start)
    status = try_rate(tables, work, first, last, start)
    if status > UNLOADED or is_balanced(turning):
        return status
    model, slope = stand_in(turning, start)
    away = turning.torque
    step = 1e-6 * fabs(start)
    if slope < 0.0:
        step = max(step, fabs(away / slope))
    if away < 0.0:
        step = -step
    before = start
    rate = start
    least = away
    for i in range(TURNS):
        following = rate + step
        status = try_rate(tables, work, first, last, following)
        if status > UNLOADED or is_balanced(turning):
            return status
        if turning.torque * away < 0.0:
            return seek_between(tables, work, first, last, rate, following)
        if is_beyond(turning):
            return BEYOND_ADHESION
        if fabs(turning.torque) >= fabs(least):
            return seek_peak(tables, work, first, last, before, following)
        least = turning.torque
        before = rate
        rate = following
        step *= GROWTH
    return NOT_CONVERGED


def seek_between(tables: Tables, work: Work, first: int, last: int, one: float, other: float):
    """Seek the rate between two that leave torques of opposite signs; the outcome."""
    turning = work.turning
    turning.low = min(one, other)
    turning.high = max(one, other)
    turning.low_known = True
    turning.high_known = True
    return seek(tables, work, first, last, 0.5 * (one + other))


def seek_peak(tables: Tables, work: Work, first: int, last: int, near: float, far: float):
    """Seek the largest torque that falling friction carries, between two rates around it, by thirds: where it
    is enough, the rate before it; the outcome."""
    turning = work.turning
    away = turning.torque
    for i in range(TURNS):
        if fabs(far - near) < PEAK_SHARP * fabs(far):
            return BEYOND_ADHESION
        inner = near + (far - near) / 3.0
        outer = far - (far - near) / 3.0
        status = try_rate(tables, work, first, last, inner)
        if status > UNLOADED or is_balanced(turning):
            return status
        at_inner = turning.torque
        if at_inner * away < 0.0:
            return seek_between(tables, work, first, last, near, inner)
        status = try_rate(tables, work, first, last, outer)
        if status > UNLOADED or is_balanced(turning):
            return status
        if turning.torque * away < 0.0:
            return seek_between(tables, work, first, last, inner, outer)
        if fabs(at_inner) < fabs(turning.torque):
            far = outer
        else:
            near = inner
    return BEYOND_ADHESION
