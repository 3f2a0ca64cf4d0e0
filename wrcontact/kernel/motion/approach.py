"""How fast a wheel and its rail approach each other."""

from math import cos, sin

from ..layout import Motion, PatchForce


def approach_rate(motion: Motion, index: int, at: PatchForce, angle: float):
    """Speed [m/s] at which wheel and rail of side ``index`` approach each other along a patch's normal, at
    its centre of load; ``angle`` [rad] is the normal's, positive towards the flange.

    Neither the rotation of a round wheel about its axle nor the course of a curve brings them closer.
    """
    rail = motion.rails[index]
    y = at.y_track - motion.centre_y
    z = at.z_track - motion.centre_z
    lateral = (motion.lateral + motion.turn_z * at.x_track - motion.turn_x * z - rail.lateral
               + rail.roll * (at.z_track - rail.z))
    vertical = (motion.vertical + motion.turn_x * y - motion.turn_y * at.x_track - rail.vertical
                - rail.roll * (at.y_track - rail.y))
    return float(2 * index - 1) * sin(angle) * lateral + cos(angle) * vertical
