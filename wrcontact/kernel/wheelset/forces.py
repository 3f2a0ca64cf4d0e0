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
from .requested import has_creep_forces


def sum_forces(tables: Tables, work: Work):
    """The forces on both wheels and on the wheelset."""
    total = work.wheelset.forces
    rubbing = has_creep_forces(tables, work)
    clear(total)
    for index in range(2):
        mirror = float(2 * index - 1)
        side = work.sides[index]
        side.motion.centre_y = mirror * work.inputs.lateral_shift
        side.motion.centre_z = work.wheelset.vertical_shift - tables.height
        sum_side(side, rubbing)
        add_forces(total, side.forces, mirror)


def sum_side(side: SideSearch, rubbing: bool):
    """The forces on a wheel; with creep forces if its patches are ``rubbing``."""
    clear(side.forces)
    for number in range(side.patch_count):
        patch = side.patches[number]
        press_patch(side.motion, patch)
        if rubbing:
            rub_patch(side.motion, patch)
        add_forces(side.forces, patch.forces, 1.0)


def press_patch(motion: Motion, patch: Patch):
    """Let the forces of a patch be those of its pressures."""
    forces = patch.forces
    clear(forces)
    forces.normal_force[1] = patch.normal_y
    forces.normal_force[2] = patch.normal_z
    copy(patch.normal_moment, forces.normal_moment)
    forces.normal_moment[0] -= motion.centre_y * patch.normal_z - motion.centre_z * patch.normal_y
    copy(forces.normal_force, forces.force)
    copy(forces.normal_moment, forces.moment)


def rub_patch(motion: Motion, patch: Patch):
    """Add the creep force of a patch to its forces: longitudinal tractions act at their strips, with the
    rolling radius as their arm about the axle, all else at the centre of load."""
    forces = patch.forces
    sine = patch.angle_sin
    cosine = patch.angle_cos
    x = patch.x_track
    y = patch.y_track - motion.centre_y
    z = patch.z_track - motion.centre_z
    rest = patch.creep_x
    turning = patch.creep_moment
    along_y = 0.0
    along_z = 0.0
    rolled = 0.0
    for i in range(ROLLING_STRIP_LIMIT):
        strip = patch.strips[i]
        force = strip.force_x * strip.width
        strip_y = strip.y_track - motion.centre_y
        strip_z = strip.z_track - motion.centre_z
        rest -= force
        turning += strip.y * force
        along_y += strip_y * force
        along_z += strip_z * force
        rolled += strip.radius_share * (motion.axle_y * strip_z - motion.axle_z * strip_y) * force
    along_y += y * rest
    along_z += z * rest
    force_y = cosine * patch.creep_y
    force_z = -sine * patch.creep_y
    moment_x = y * force_z - z * force_y
    moment_y = along_z - x * force_z + sine * turning
    moment_z = x * force_y - along_y + cosine * turning
    rolled += patch.radius_share * ((motion.axle_y * z - motion.axle_z * y) * rest
                                    + (motion.axle_z * x - motion.axle_x * z) * force_y
                                    + (motion.axle_x * y - motion.axle_y * x) * force_z)
    torque = rolled + turning * (sine * motion.axle_y + cosine * motion.axle_z)
    # about the axle tractions have the arm of the wheel's circumference
    missing = torque - (moment_x * motion.axle_x + moment_y * motion.axle_y + moment_z * motion.axle_z)
    forces.force[0] += patch.creep_x
    forces.force[1] += force_y
    forces.force[2] += force_z
    forces.moment[0] += moment_x + missing * motion.axle_x
    forces.moment[1] += moment_y + missing * motion.axle_y
    forces.moment[2] += moment_z + missing * motion.axle_z
    forces.driving_torque = -torque
    forces.friction_power = -patch.speed * creep_gain(patch)
    forces.wear_number = fabs(patch.creep_x * patch.creepage_x) + fabs(patch.creep_y * patch.creepage_y)


def add_forces(total: Forces, part: Forces, mirror: float):
    """Add the forces of a patch to those of its wheel, or those of a wheel to the wheelset's; ``mirror`` = -1
    for the left wheel, which is mirrored."""
    add_vector(total.force, part.force, 1.0, mirror)
    add_vector(total.moment, part.moment, mirror, 1.0)
    add_vector(total.normal_force, part.normal_force, 1.0, mirror)
    add_vector(total.normal_moment, part.normal_moment, mirror, 1.0)
    total.driving_torque += part.driving_torque
    total.friction_power += part.friction_power
    total.wear_number += part.wear_number


def add_vector(total: Vector, part: Vector, plane: float, across: float):
    """Add a vector, x and z with the sign ``plane`` and y with the sign ``across``."""
    total[0] += plane * part[0]
    total[1] += across * part[1]
    total[2] += plane * part[2]
