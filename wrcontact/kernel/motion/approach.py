"""How fast a wheel and its rail approach each other."""

from math import cos, sin

from ..layout import Motion, Patch


def approach_rate(motion: Motion, patch: Patch):
    """Speed [m/s] at which wheel and rail approach each other along a patch's normal, at its centre of load.

    Neither the rotation of a round wheel about its axle nor the course of a curve brings them closer.
    """
    rail = motion.rail
    y = patch.y_track - motion.centre_y
    z = patch.z_track - motion.centre_z
    lateral = (motion.lateral + motion.turn_z * patch.x_track - motion.turn_x * z - rail.lateral
               + rail.roll * (patch.z_track - rail.z))
    vertical = (motion.vertical + motion.turn_x * y - motion.turn_y * patch.x_track - rail.vertical
                - rail.roll * (patch.y_track - rail.y))
    return sin(patch.contact_angle) * lateral + cos(patch.contact_angle) * vertical
