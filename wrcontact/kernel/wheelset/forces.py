"""Where forces add up: those of a patch, then of a wheel, then of the wheelset, and nowhere else.

The pressures of a patch push the wheel along the rail's normals (normal/patch_places.py); those of a body of
revolution go through its axle.  The creep force lies in the plane of the patch, with x forward and y to the
field side, where the normal into the rail is x times y.  Moments are those about the wheelset's centre, which
is the nominal radius above the running circles; the torque about the axle is that of the creep forces.

Tractions act where they slip, so that the power of friction, -V_ref sum w F over the strips, is that of the
outputs: with the velocity v of the centre and the rotation W of the wheelset, the one about the axle with it,

    P = -(F . v + M . W)
"""

from math import fabs

from ..layout import ROLLING_STRIP_LIMIT, Forces, Motion, Patch, SideSearch, Tables, Vector, Work, clear, copy
from ..creep.friction import creep_gain
from .input_checks import has_creep_forces


def sum_forces(tables: Tables, work: Work):
    """The forces on both wheels and on the wheelset."""
    total = work.wheelset.forces
    with_creep = has_creep_forces(tables, work)
    clear(total)
    for index in range(2):
        mirror = float(2 * index - 1)
        side = work.sides[index]
        side.motion.centre_y = mirror * work.inputs.lateral_shift
        side.motion.centre_z = work.wheelset.vertical_shift - tables.height
        sum_side(side, with_creep)
        add_forces(total, side.forces, mirror)


def sum_side(side: SideSearch, with_creep: bool):
    """The forces on a wheel; with creep forces if ``with_creep``."""
    clear(side.forces)
    for number in range(side.patch_count):
        patch = side.patches[number]
        press_patch(side.motion, patch)
        if with_creep:
            add_creep_force(side.motion, patch)
        add_forces(side.forces, patch.forces, 1.0)


def press_patch(motion: Motion, patch: Patch):
    """Let the forces of a patch be those of its pressures."""
    forces = patch.forces
    clear(forces)
    forces.damping_power = patch.damping_power
    forces.normal_force[1] = patch.normal_y
    forces.normal_force[2] = patch.normal_z
    copy(patch.normal_moment, forces.normal_moment)
    forces.normal_moment[0] -= motion.centre_y * patch.normal_z - motion.centre_z * patch.normal_y
    copy(forces.normal_force, forces.force)
    copy(forces.normal_moment, forces.moment)


def add_creep_force(motion: Motion, patch: Patch):
    """Add the creep force of a patch to its forces: tractions act at their strips, in the strips' own planes,
    and what a model adds to the strips acts at the centre of load.  About the axle all have the rolling
    radius as their arm."""
    forces = patch.forces
    rest_x = patch.creep_x
    rest_y = patch.creep_y
    turning = patch.creep_moment
    force_y = 0.0
    force_z = 0.0
    moment_x = 0.0
    moment_y = 0.0
    moment_z = 0.0
    missing = 0.0
    for i in range(ROLLING_STRIP_LIMIT):
        strip = patch.strips[i]
        along = strip.force_x * strip.width
        across = strip.force_y * strip.width
        spinning = strip.moment * strip.width
        rest_x -= along
        rest_y -= across
        turning += strip.y * along - spinning
        spinning -= strip.x * across
        down = strip.sin * across
        across *= strip.cos
        x = patch.x_track + strip.x
        y = strip.y_track - motion.centre_y
        z = strip.z_track - motion.centre_z
        lever_x = y * down - z * across
        lever_y = z * along - x * down
        lever_z = x * across - y * along
        force_y += across
        force_z += down
        moment_x += lever_x
        moment_y += lever_y - strip.sin * spinning
        moment_z += lever_z + strip.cos * spinning
        missing += (strip.radius_share - 1.0) * about_axle(motion, lever_x, lever_y, lever_z)
    sine = -patch.angle_sin
    cosine = patch.angle_cos
    across = cosine * rest_y
    down = sine * rest_y
    y = patch.y_track - motion.centre_y
    z = patch.z_track - motion.centre_z
    lever_x = y * down - z * across
    lever_y = z * rest_x - patch.x_track * down
    lever_z = patch.x_track * across - y * rest_x
    missing += (patch.radius_share - 1.0) * about_axle(motion, lever_x, lever_y, lever_z)
    moment_x += lever_x
    moment_y += lever_y - sine * turning
    moment_z += lever_z + cosine * turning
    forces.force[0] += patch.creep_x
    forces.force[1] += force_y + across
    forces.force[2] += force_z + down
    turn_creep_force(motion, patch, moment_x, moment_y, moment_z, missing)


def turn_creep_force(
    motion: Motion, patch: Patch, moment_x: float, moment_y: float, moment_z: float, missing: float
):
    """Add to the forces of a patch the moment of its creep force about the wheelset's centre [N m], which is ``missing`` so
    much about the axle, and what else follows from that force."""
    forces = patch.forces
    forces.moment[0] += moment_x + missing * motion.axle_x
    forces.moment[1] += moment_y + missing * motion.axle_y
    forces.moment[2] += moment_z + missing * motion.axle_z
    forces.driving_torque = -(about_axle(motion, moment_x, moment_y, moment_z) + missing)
    forces.friction_power = -patch.speed * creep_gain(patch)
    forces.wear_number = fabs(patch.creep_x * patch.creepage_x) + fabs(patch.creep_y * patch.creepage_y)


def about_axle(motion: Motion, moment_x: float, moment_y: float, moment_z: float):
    """The part about the axle of a moment about the wheelset's centre."""
    return moment_x * motion.axle_x + moment_y * motion.axle_y + moment_z * motion.axle_z


def add_forces(total: Forces, part: Forces, mirror: float):
    """Add the forces of a patch to those of its wheel, or those of a wheel to the wheelset's; ``mirror`` = -1
    for the left wheel, which is mirrored."""
    add_vector(total.force, part.force, 1.0, mirror)
    add_vector(total.moment, part.moment, mirror, 1.0)
    add_vector(total.normal_force, part.normal_force, 1.0, mirror)
    add_vector(total.normal_moment, part.normal_moment, mirror, 1.0)
    total.driving_torque += part.driving_torque
    total.friction_power += part.friction_power
    total.damping_power += part.damping_power
    total.wear_number += part.wear_number


def add_vector(total: Vector, part: Vector, plane: float, across: float):
    """Add a vector, x and z with the sign ``plane`` and y with the sign ``across``."""
    total[0] += plane * part[0]
    total[1] += across * part[1]
    total[2] += plane * part[2]
