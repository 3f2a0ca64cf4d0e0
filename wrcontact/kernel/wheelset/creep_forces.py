"""Creep forces of a wheelset whose contact is solved and whose creepages are known.

For each reported patch: its friction and the creepage of each strip, which has its own rolling radius; then
the tangential model, and its force and moment on the wheel in the track frame.  On the right y to the field
side is the opposite of the creepages' y_c, and the normal x times y that of the normal n from the rail to the
wheel; on the left they are the same:

    xi' = xi,   eta' = -+ eta,   phi' = -+ phi,   M = -+ M'       (upper sign: right)

Normal forces of a body of revolution go through its axle; the torque about the axle is that of the creep
forces.
"""

from math import cos, fabs, sin, sqrt

from ..layout import (
    DEPTH_ALL,
    TANGENTIAL_NONE,
    Motion,
    Outline,
    Outputs,
    Patch,
    RollingPatch,
    SideOutputs,
    Tables,
    Work,
)
from ..motion.creepage import STANDSTILL, patch_speed, reference_speed, rolling_velocity, velocity_along
from ..tangential.tangential_contact import solve_tangential
from .friction import patch_friction, reduce_slope
from .moving import is_rolling
from .outlines import outline_place
from .wear_outline import write_wear


def has_creep_forces(tables: Tables, work: Work):
    """1 if there are creep forces: a model is chosen, and the wheelset rolls."""
    wanted = 0
    if tables.tangential != TANGENTIAL_NONE and is_rolling(work.inputs) == 1:
        wanted = 1
    return wanted


def write_creep_forces(left_tables: Tables, right_tables: Tables, work: Work):
    """Creep forces of all patches into the outputs, and their part of the resultants."""
    write_side_creep(left_tables, work, 0, work.inputs.left_friction)
    write_side_creep(right_tables, work, 1, work.inputs.right_friction)
    return 0


def write_side_creep(tables: Tables, work: Work, index: int, friction: float):
    """Creep forces of the patches of side ``index``, whose coefficient of friction is ``friction``."""
    rolling = work.rolling_sides[index]
    side = work.outputs.left[index]
    mirror = float(2 * index - 1)
    for number in range(rolling.count):
        patch = rolling.patches[number]
        to = side.patch[number]
        if patch_speed(work.motion, to) > STANDSTILL:
            open_rolling(tables, work.motion, patch, to, mirror, friction)
            limit = patch.friction * patch.load
            solve_tangential(tables, patch)
            write_creep(patch, to, mirror, limit)
            add_creep(work.motion, work.outputs, side, to, mirror)
    write_side_wear(tables, work, index)
    return 0


def write_side_wear(tables: Tables, work: Work, index: int):
    """Shear and slip over the outline of side ``index``, where that is wanted."""
    if tables.depth == DEPTH_ALL:
        write_wear(Outline.at(work, outline_place(tables, work, index)), tables.stations,
                   work.rolling_sides[index])
    return 0


def open_rolling(tables: Tables, motion: Motion, patch: RollingPatch, to: Patch, mirror: float,
                 friction: float):
    """Load, creepages and friction of a patch, from its outputs ``to``."""
    set_load(patch, to.normal_force)
    patch.creepage_x = to.creepage_x
    patch.creepage_y = -mirror * to.creepage_y
    patch.spin = -mirror * to.spin
    rolling_x, rolling_y, rolling_z = rolling_velocity(motion, to.x_track, to.y_track - motion.centre_y,
                                                       to.z_track - motion.centre_z, to.rolling_radius)
    speed = reference_speed(motion, rolling_x)
    patch.speed = speed
    patch.backwards = motion.speed + rolling_x < 0.0
    patch.published = tables.parameters.published_spin == 1.0
    for index in range(patch.count):
        strip = patch.strips[index]
        y = strip.y_track - motion.centre_y
        z = strip.z_track - motion.centre_z
        rolling_x, rolling_y, rolling_z = rolling_velocity(motion, to.x_track + strip.x, y, z,
                                                           strip.rolling_radius)
        strip.slip = velocity_along(motion, y, z, rolling_x) / speed
    sliding = speed * sqrt(to.creepage_x * to.creepage_x + to.creepage_y * to.creepage_y)
    patch.friction = patch_friction(tables, friction, to.contact_angle, sliding)
    reduce_slope(tables, patch)
    return 0


def set_load(patch: RollingPatch, load: float):
    """Let a patch carry ``load`` [N]: contact damping changes it."""
    if load != patch.load and patch.load > 0.0:
        factor = load / patch.load
        for index in range(patch.count):
            strip = patch.strips[index]
            strip.line_load *= factor
        patch.load = load
    return 0


def write_creep(patch: RollingPatch, to: Patch, mirror: float, limit: float):
    """What the tangential model has found into the outputs of a patch, whose creep force is at most ``limit``
    [N]."""
    to.creep_force_x = patch.force_x
    to.creep_force_y = patch.force_y
    to.creep_moment = -mirror * patch.moment
    to.stick_share = patch.stick_share
    to.max_shear = patch.max_shear
    if limit > 0.0:
        to.saturation = sqrt(patch.force_x * patch.force_x + patch.force_y * patch.force_y) / limit
    to.friction_power = -patch.speed * (
        to.creepage_x * to.creep_force_x - mirror * to.creepage_y * to.creep_force_y
        + to.spin * to.creep_moment)
    return 0


def add_creep(motion: Motion, outputs: Outputs, side: SideOutputs, to: Patch, mirror: float):
    """Add the creep force of a patch to its force and to those of its wheel and the wheelset."""
    sine = sin(to.contact_angle)
    cosine = cos(to.contact_angle)
    force_x = to.creep_force_x
    force_y = mirror * cosine * to.creep_force_y
    force_z = -sine * to.creep_force_y
    x = to.x_track
    y = to.y_track - motion.centre_y
    z = to.z_track - motion.centre_z
    moment_x = y * force_z - z * force_y
    moment_y = z * force_x - x * force_z - mirror * sine * to.creep_moment
    moment_z = x * force_y - y * force_x - cosine * to.creep_moment
    to.force[0] += force_x
    to.force[1] += force_y
    to.force[2] += force_z
    side.force[0] += force_x
    side.force[1] += force_y
    side.force[2] += force_z
    side.moment[0] += moment_x
    side.moment[1] += moment_y
    side.moment[2] += moment_z
    outputs.force[0] += force_x
    outputs.force[1] += force_y
    outputs.force[2] += force_z
    outputs.moment[0] += moment_x
    outputs.moment[1] += moment_y
    outputs.moment[2] += moment_z
    outputs.driving_torque -= moment_x * motion.axle_x + moment_y * motion.axle_y + moment_z * motion.axle_z
    side.friction_power += to.friction_power
    side.wear_number += (fabs(to.creep_force_x * to.creepage_x) + fabs(to.creep_force_y * to.creepage_y))
    return 0
