"""Contact damping of a compliant wheelset: forces grow with the speed of the approach.

The force of a patch is multiplied by 1 + d a, with the contact damping d [s/m] and the speed a [m/s] at which
wheel and rail approach each other along the patch's normal at its centre of load; it is never below zero.
Areas and pressures stay those of the elastic contact.
"""

from ..layout import MODE_COMPLIANT, RESULTANT_COUNT, Motion, Resultant, SolvedPatch, SolvedPatches, Tables
from ..motion.approach import approach_rate


def is_damped(tables: Tables):
    """1 if contact is damped, else 0."""
    damped = 0
    if tables.mode == MODE_COMPLIANT and tables.parameters.contact_damping > 0.0:
        damped = 1
    return damped


def damp_patches(tables: Tables, motion: Motion, solved: SolvedPatches, index: int, resultant: Resultant):
    """Damp the forces of the solved patches of side ``index``, and add them up to its ``resultant``."""
    for i in range(RESULTANT_COUNT):
        resultant[i] = 0.0
    load = 0.0
    moment = 0.0
    for number in range(solved.count):
        patch = solved.patches[number]
        damp_patch(patch, damping_factor(tables, motion, patch, index))
        force = patch.force
        resultant[1] += force.y
        resultant[2] += force.z
        resultant[3] += force.moment_x
        resultant[4] += force.moment_y
        resultant[5] += force.moment_z
        load += patch.totals.load
        moment += patch.totals.moment
    totals = solved.totals
    totals.load = load
    totals.moment = moment
    if load > 0.0:
        totals.centroid = moment / load
    return 0


def damping_factor(tables: Tables, motion: Motion, patch: SolvedPatch, index: int):
    """By what the force of a patch of side ``index`` is multiplied."""
    factor = 1.0 + tables.parameters.contact_damping * approach_rate(motion, index, patch.force,
                                                                     patch.contact_angle)
    if factor < 0.0:
        factor = 0.0
    return factor


def damp_patch(patch: SolvedPatch, factor: float):
    """Multiply load, force and moments of a patch by ``factor``."""
    patch.totals.load *= factor
    patch.totals.moment *= factor
    force = patch.force
    force.y *= factor
    force.z *= factor
    force.moment_x *= factor
    force.moment_y *= factor
    force.moment_z *= factor
    return 0
