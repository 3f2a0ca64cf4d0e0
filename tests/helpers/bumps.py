"""A rail with bumps beside each other, on which a wheel has four patches."""

from functools import cache

import numpy as np
from numpy.polynomial import chebyshev, polynomial

import wrcontact
from wrcontact import Profile
from wrcontact.profiles.zones import Polynomial

#: Slope of the cone and of the rail below it, height of the bumps and half of their width [mm].
SLOPE, HEIGHT, HALF = 0.02, 0.02, 12
#: Under this load [N] four bumps carry.
LOAD = 1e5


@cache
def bumpy_system(**parameters):
    """A cone on a Chebyshev polynomial."""
    bumps = HEIGHT * chebyshev.cheb2poly([0.0] * 8 + [1.0]) / float(HALF)**np.arange(9)
    head = polynomial.polyadd(bumps, [0.0, -SLOPE, 1.0 / 6000.0])
    slope = polynomial.polyder(head)

    def beyond(y):
        """The head goes on with its slope at ``y`` and a radius of 80 mm."""
        z, m, bend = polynomial.polyval(y, head), polynomial.polyval(y, slope), 1.0 / 160.0
        return z - m * y + bend * y * y, m - 2.0 * bend * y, bend

    rail = Profile("bumps", "rail", (Polynomial(-60, -HALF, beyond(-HALF)),
                                     Polynomial(-HALF, HALF, tuple(head)),
                                     Polynomial(HALF, 60, beyond(HALF))))
    wheel = Profile("cone", "wheel", (Polynomial(-70, 60, (0.0, -SLOPE)),))
    return wrcontact.ContactSystem(wheel=wheel, rail=rail, rail_inclination=0.0, gauge_depth=5.5e-3,
                                   **parameters)
