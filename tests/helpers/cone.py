"""A cone on rails with round heads, in closed form but for one root: where it stands and touches.

In the plane across the track each wheel is a straight line that falls by the angle d towards the field side,
and each rail a circle of radius HEAD around (+-y0, HEAD). With the height H of the circles' centres below the
wheelset's centre, the line of the right wheel touches at the roll q where

    (y0 - y) sin(d - q) + H cos(d - q) = HEAD + b sin(d) + r0 cos(d)

and that of the left one with y and q of the other sign.
"""

from dataclasses import dataclass
from functools import cache
from math import atan, cos, sin

from scipy.optimize import brentq

import wrcontact
from wrcontact import Profile
from wrcontact.profiles.zones import Arc, Polynomial

HEAD, RADIUS, ARM = 0.30, 0.46, 0.75


@dataclass(frozen=True)
class Wheel:
    """One wheel that touches: the angle of the contact towards the flange [rad], its rolling radius, and the
    track coordinate of the contact [m]."""

    angle: float
    radius: float
    y: float


@cache
def cone_system(slope, **parameters):
    """Cones on round heads; Hertz's patch has its centre at the contact point."""
    wheel = Profile("cone", "wheel", (Polynomial(-70, 60, (0.0, -slope)),))
    rail = Profile("head", "rail", (Arc(-60, 60, 1e3 * HEAD, 0.0, 1e3 * HEAD, -1),))
    return wrcontact.ContactSystem(
        wheel=wheel,
        rail=rail,
        rail_inclination=0.0,
        gauge_depth=5.5e-3,
        **{"normal_model": "hertz", **parameters},
    )


def stand(slope, shift, rail_y):
    """Roll [rad], height [m] of the wheelset's centre above the rails, left and right :class:`Wheel`."""
    d = atan(slope)
    reach = HEAD + ARM * sin(d) + RADIUS * cos(d)

    def below(sign, roll):
        """H by the wheel of this side."""
        return (reach - (rail_y - sign * shift) * sin(d - sign * roll)) / cos(d - sign * roll)

    roll = brentq(lambda q: below(1, q) - below(-1, q), -0.02, 0.02, xtol=1e-17, rtol=1e-15)
    centre = below(1, roll)

    def wheel(sign):
        angle = d - sign * roll
        along = (rail_y - sign * shift) * cos(angle) - centre * sin(angle) - ARM * cos(d) + RADIUS * sin(d)
        return Wheel(angle, RADIUS - along * sin(d), sign * (rail_y - HEAD * sin(angle)))

    return roll, centre - HEAD, wheel(-1), wheel(1)


def rail_place(system):
    """Track coordinate of the right rail's highest point [m]."""
    return system.profile_tables()[2]
