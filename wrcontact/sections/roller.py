"""A roller in the place of a rail: the rail's section, turned about an axis across the track.

At the distance x ahead of its axis a roller of nominal radius R, whose section has the height z(y), stands at

    z = R - sqrt((R - z(y))^2 - x^2).
"""

import numpy as np

from .curves import ProfileCurve
from .knots import knot_lengths
from .surface import Surface

#: Distance of the slices as a share of the radius, and how far they reach as one.
STEP, FARTHEST = 0.01, 0.6
#: A wheel touches within this angle ahead of or behind its lowest point [rad], the search's, and its axle stands at most so far
#: ahead of the roller's [m].
ANGLE, AHEAD = 0.13, 0.02
#: Slices beyond that.
BEYOND = 4


def roller_surface(profile, radius, wheel_radius):
    """The :class:`~wrcontact.sections.surface.Surface` of a roller of nominal ``radius`` [m], whose section is the rail
    ``profile`` with its highest place at the height 0, as far ahead and behind as a wheel of ``wheel_radius`` [m] touches.

    Raises
    ------
    ValueError
        in one sentence, if the section is deeper than the roller.
    """
    curve = ProfileCurve(profile)
    (lengths,) = knot_lengths([curve], np.array([[0.0, curve.length]]))
    y, z, slope, *bends = curve.at(lengths).T
    step = STEP * radius
    reach = min(ANGLE * wheel_radius + AHEAD + BEYOND * step, FARTHEST * radius)
    distance = radius - z
    if not distance.min() > reach:
        raise ValueError(
            f"roller_radius is {radius:.6g} m, but the section of {profile.name} is {z.max():.6g} m deep and touched up to "
            f"{reach:.6g} m beside the axis; permitted are larger radii"
        )
    u = np.linspace(-reach, reach, 2 * int(np.ceil(reach / step)) + 1)
    root = np.sqrt(distance**2 - u[:, None] ** 2)
    lean = distance * slope
    values = [np.broadcast_to(y, root.shape), radius - root, lean / root]
    values += [(distance * bend - slope**2) / root + lean**2 / root**3 for bend in bends]
    return Surface(u, np.stack(values, axis=-1))
