"""Contact damping on a rail whose section changes: as wheelset/prescribed_height.py, with what the force does along the
track."""

from ..creep.leaning import leaning_approach_rate
from ..layout import Motion, Patch, Tables, Work
from ..patch.filling import total_patches
from ..wheelset.leaning_wheel import leaning_place
from ..wheelset.prescribed_height import damp_patch, damping_factor, pressing_power


def damp_leaning_patches(tables: Tables, work: Work, index: int):
    """Damp the patches of side ``index``, whose motion is known."""
    side = work.sides[index]
    for number in range(side.patch_count):
        patch = side.patches[number]
        at = work.leaning[leaning_place(index, number)].own
        factor = damping_factor(tables, leaning_approach_rate(side.motion, at))
        power = pressing_power(side.motion, patch) + pushing_power(side.motion, patch)
        power += patch.totals.load * side.motion.wheel_rate * at.swelling
        patch.damping_power = (factor - 1.0) * power
        damp_patch(patch, factor)
    total_patches(side)


def pushing_power(motion: Motion, patch: Patch):
    """What the force of a patch along the track adds to the power of its pressures [W]; below a wheelset on rollers there is
    no track that runs."""
    running = motion.speed
    if motion.rail.turn != 0.0:
        running = 0.0
    return -patch.normal_x * (running - motion.centre_z * motion.turn_y + motion.centre_y * motion.turn_z)
