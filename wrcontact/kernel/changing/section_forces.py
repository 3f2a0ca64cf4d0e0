"""Where the forces of rails whose section changes add up: those of pressures, which push along the track, too."""

from ..layout import Forces, Motion, Patch, SideSearch, Tables, Work, clear
from ..wheelset.forces import add_forces, press_patch


def sum_pushes(tables: Tables, work: Work):
    """The forces of the pressures on both wheels and on the wheelset."""
    total = work.wheelset.forces
    clear(total)
    for index in range(2):
        mirror = float(2 * index - 1)
        side = work.sides[index]
        side.motion.centre_y = mirror * work.inputs.lateral_shift
        side.motion.centre_z = work.wheelset.vertical_shift - tables.height
        push_side(side)
        add_forces(total, side.forces, mirror)


def push_side(side: SideSearch):
    """The forces of the pressures on a wheel."""
    clear(side.forces)
    for number in range(side.patch_count):
        patch = side.patches[number]
        press_patch(side.motion, patch)
        push_along(side.motion, patch, patch.forces)
        add_forces(side.forces, patch.forces, 1.0)


def push_along(motion: Motion, patch: Patch, forces: Forces):
    """Add to the forces of a patch what pushes along the track, which only a changing rail does."""
    forces.normal_force[0] = patch.normal_x
    forces.force[0] += patch.normal_x
    forces.normal_moment[1] -= motion.centre_z * patch.normal_x
    forces.normal_moment[2] += motion.centre_y * patch.normal_x
    forces.moment[1] -= motion.centre_z * patch.normal_x
    forces.moment[2] += motion.centre_y * patch.normal_x
