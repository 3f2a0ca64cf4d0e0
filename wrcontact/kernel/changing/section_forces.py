"""Where the forces on rails whose section changes add up: pressures push along the track, too."""

from ..layout import Forces, Motion, Patch, Tables, Work, clear
from ..wheelset.forces import add_forces, press_patch
from ..wheelset.input_checks import has_creep_forces
from ..wheelset.leaning_wheel import force_one


def sum_pushes(tables: Tables, work: Work):
    """The forces on both wheels and on the wheelset."""
    total = work.wheelset.forces
    clear(total)
    for index in range(2):
        mirror = float(2 * index - 1)
        side = work.sides[index]
        side.motion.centre_y = mirror * work.inputs.lateral_shift
        side.motion.centre_z = work.wheelset.vertical_shift - tables.height
        push_side(tables, work, index)
        add_forces(total, side.forces, mirror)


def push_side(tables: Tables, work: Work, index: int):
    """The forces on the wheel of side ``index``."""
    side = work.sides[index]
    with_creep = has_creep_forces(tables, work)
    clear(side.forces)
    for number in range(side.patch_count):
        patch = side.patches[number]
        press_patch(side.motion, patch)
        push_along(side.motion, patch, patch.forces)
        if with_creep:
            force_one(tables, work, index, number)
        add_forces(side.forces, patch.forces, 1.0)


def push_along(motion: Motion, patch: Patch, forces: Forces):
    """Add to the forces of a patch what pushes along the track, which only a changing rail does."""
    forces.normal_force[0] = patch.normal_x
    forces.force[0] += patch.normal_x
    forces.normal_moment[1] -= motion.centre_z * patch.normal_x
    forces.normal_moment[2] += motion.centre_y * patch.normal_x
    forces.moment[1] -= motion.centre_z * patch.normal_x
    forces.moment[2] += motion.centre_y * patch.normal_x
