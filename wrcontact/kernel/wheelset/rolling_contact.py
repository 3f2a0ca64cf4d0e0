"""The rolling of a wheelset whose contact is solved: its velocities, the creepages of its patches, then for
each patch its friction and the tangential model.

Shear and slip over the outline of a wheel, for models of wear.

Of a strip with the creep force F_i and the power P_i per width and the half-length a_i

    shear = |F_i| / (2 a_i),   slip = P_i / |F_i|,   P_i = -V_ref (w_x F_x + w_y F_y + phi_i M_i)

so that shear times slip is the friction power per area, as the strip has it from its leading to its trailing
edge.  Elastic deformation takes and gives back power within a strip and is no part of P_i.  Between the
middles of strips both follow straight lines; a strip that would gain power counts as one that sticks.
"""

from math import sqrt

from ..creep.creep_force import solve_creep_force
from ..creep.creepage import move_patch, move_strips
from ..creep.friction import multiply_creepages, set_friction, slope_factor
from ..creep.motion import (
    are_independent,
    carry_rail,
    constrain_loaded,
    constrain_touching,
    mirror_motion,
    open_left_rail,
    open_motion,
    open_right_rail,
    set_contact_rates,
    set_rates,
    turn_wheels,
)
from ..layout import (
    DEPTH_ALL,
    MODE_COMPLIANT,
    MODE_ELASTIC,
    ROLLING_STRIP_LIMIT,
    SOLVED_PATCH_LIMIT,
    TANGENTIAL_NONE,
    Outline,
    Patch,
    Rolling,
    RollingStrip,
    SideSearch,
    Tables,
    Work,
)
from ..surface.rails import on_springs
from .forces import sum_side
from .input_checks import has_creep_forces, is_free, is_moving, is_needed
from .side import touch_side


def open_given_motion(tables: Tables, work: Work):
    """The motion as the inputs give it, at the wheelset's pose."""
    left = work.sides[0].motion
    right = work.sides[1].motion
    open_motion(tables, right, work.inputs, work.wheelset)
    mirror_motion(right, left)
    if are_independent(tables):
        turn_wheels(tables, left, right, work.inputs)
    open_left_rail(tables.pairs[0], left.rail, work.inputs)
    open_right_rail(tables.pairs[1], right.rail, work.inputs)
    if on_springs(tables):
        carry_rail(left.rail, work.sides[0].deflection)
        carry_rail(right.rail, work.sides[1].deflection)
    for index in range(2):
        if is_free(tables, work.inputs, index):
            work.sides[index].motion.wheel_rate = work.turning.rates[index]
    set_rates(left, right, work.inputs.vertical_velocity, work.inputs.roll_rate)


def move_wheelset(tables: Tables, work: Work):
    """The velocities of the wheelset, if it rolls; in compliant contact vertical velocity and roll rate are
    given, otherwise they follow from contact with both rails, without what the depth of an elastic wheelset
    adds (depth_rates.py)."""
    if is_moving(tables, work.inputs):
        open_given_motion(tables, work)
        if tables.mode != MODE_COMPLIANT:
            constrain_side(tables, work, 0)
            constrain_side(tables, work, 1)
            set_contact_rates(work.sides[0].motion, work.sides[1].motion)


def move_patches(tables: Tables, work: Work):
    """Creepages of all patches and their strips, if the wheelset rolls."""
    if not is_moving(tables, work.inputs):
        return
    for index in range(2):
        move_side(tables, work.sides[index])


def move_side(tables: Tables, side: SideSearch):
    """Creepages of the patches of a side whose motion is known, and of their strips."""
    for number in range(side.patch_count):
        patch = side.patches[number]
        move_patch(side.motion, patch)
        if tables.tangential != TANGENTIAL_NONE:
            move_strips(side.motion, patch)


def constrain_side(tables: Tables, work: Work, index: int):
    """What keeps the wheel of side ``index`` on its rail: the normal where it touches, or its force if it is
    elastic and carries a load."""
    side = work.sides[index]
    if tables.mode == MODE_ELASTIC and side.patch_count > 0:
        sum_side(side, False)
        constrain_loaded(side.motion, side.forces)
    else:
        if not is_needed(tables, work.inputs, index):
            touch_side(tables, work, index)
        constrain_touching(side.motion, side.point)


def write_wear(side: SideSearch, stations: int):
    """Shear [Pa] and slip [m/s] of the patches of a wheel at the ``stations`` of its outline; zero between
    patches."""
    for i in range(3 * stations, 5 * stations):
        side.outline.numbers[i] = 0.0
    for number in range(side.patch_count):
        write_patch_wear(side.outline, stations, side.patches[number])


def write_patch_wear(outline: Outline, stations: int, patch: Patch):
    """Shear and slip of a patch at the stations that lie in it, which ascend, along with the strips."""
    first = patch.strips[0]
    last = patch.strips[ROLLING_STRIP_LIMIT - 1]
    start = first.station - 0.5 * first.width
    stop = last.station + 0.5 * last.width
    index = 0
    low_station = first.station
    high_station = first.station
    low_shear = 0.0
    low_slip = 0.0
    high_shear = strip_shear(first)
    high_slip = strip_slip(patch, first)
    for j in range(1, stations - 1):
        station = outline.numbers[j]
        if station > start and station < stop:
            while index < ROLLING_STRIP_LIMIT - 1 and high_station < station:
                index += 1
                strip = patch.strips[index]
                low_station = high_station
                low_shear = high_shear
                low_slip = high_slip
                high_station = strip.station
                high_shear = strip_shear(strip)
                high_slip = strip_slip(patch, strip)
            shear = high_shear
            slip = high_slip
            if index > 0 and station < high_station:
                share = (high_station - station) / (high_station - low_station)
                shear += share * (low_shear - shear)
                slip += share * (low_slip - slip)
            outline.numbers[3 * stations + j] = shear
            outline.numbers[4 * stations + j] = slip


def strip_shear(strip: RollingStrip):
    """Creep force per area of a strip [Pa]."""
    shear = 0.0
    if strip.half_length > 0.0:
        force = sqrt(strip.force_x * strip.force_x + strip.force_y * strip.force_y)
        shear = force / (2.0 * strip.half_length)
    return shear


def strip_slip(patch: Patch, strip: RollingStrip):
    """Friction power of a strip over its creep force [m/s]."""
    force = sqrt(strip.force_x * strip.force_x + strip.force_y * strip.force_y)
    slip = 0.0
    if force > 0.0:
        power = strip_power(patch, strip)
        if power > 0.0:
            slip = power / force
    return slip


def strip_power(patch: Patch, strip: RollingStrip):
    """Friction power of a strip per width [W/m]; zero for one that would gain power."""
    power = -(
        strip.slip * strip.force_x
        + (strip.lateral - strip.spin * strip.x) * strip.force_y
        + strip.spin * strip.moment
    )
    return patch.speed * max(power, 0.0)


def solve_creep_forces(tables: Tables, work: Work):
    """Creep forces of all patches, if there are any."""
    if has_creep_forces(tables, work):
        solve_side_creep(tables, work, 0)
        solve_side_creep(tables, work, 1)


def solve_side_creep(tables: Tables, work: Work, index: int):
    """Creep forces of the patches of side ``index``, and shear and slip over its outline."""
    solve_wheel_creep(tables, work, index)
    write_side_wear(tables, work.sides[index])


def write_side_wear(tables: Tables, side: SideSearch):
    """Shear and slip over the outline of a side, if it is requested."""
    if tables.depth == DEPTH_ALL:
        write_wear(side, tables.stations)


def side_friction(work: Work, index: int):
    """The coefficient of friction of side ``index``."""
    friction = work.inputs.left_friction
    if index == 1:
        friction = work.inputs.right_friction
    return friction


def solve_wheel_creep(tables: Tables, work: Work, index: int):
    """Creep forces of the patches of side ``index``."""
    side = work.sides[index]
    friction = side_friction(work, index)
    for number in range(side.patch_count):
        patch = side.patches[number]
        work.rolling.place = SOLVED_PATCH_LIMIT * index + number
        factor = open_rolling(tables, work.rolling, patch, friction)
        solve_creep_force(tables, work.rolling, patch)
        close_rolling(patch, factor)


def open_rolling(tables: Tables, rolling: Rolling, patch: Patch, friction: float):
    """Friction of a patch, and the factor of its creepages that stands for a reduced slope."""
    rolling.bare = False
    rolling.published = tables.parameters.published_spin == 1.0
    set_friction(tables, patch, friction, rolling.resting)
    factor = slope_factor(tables, patch)
    if factor != 1.0:
        multiply_creepages(patch, factor)
    return factor


def close_rolling(patch: Patch, factor: float):
    """The saturation of a patch whose creep force is known, and its own creepages again."""
    if factor != 1.0:
        multiply_creepages(patch, 1.0 / factor)
    limit = patch.friction * patch.totals.load
    if limit > 0.0:
        patch.saturation = sqrt(patch.creep_x * patch.creep_x + patch.creep_y * patch.creep_y) / limit
