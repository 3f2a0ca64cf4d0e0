"""Stability of the centred motion: eigenvalues from the contact FMU's own derivatives.

The state (9,) holds the places and rates of the wheelset (``MOTION`` in wheelset.py).  Its matrix consists of
the wheelset's matrices and of the derivatives of the contact's forces at the steady motion in the middle.
"""

import numpy as np
from scipy.optimize import brentq

from .coupling import CONES, Loop
from .wheelset import Wheelset

#: What linear theory has in closed form: Kalker's table with Hertz's patch on cones, friction far from its
#: limit, so that creep forces are linear.
LINEAR = CONES | {"normal_model": "hertz", "contact_damping": 0.0}
LINEAR_FRICTION = 2.0
#: Hunting is slower [rad/s] than the wheelset on the springs of its contacts.
SLOW = 300.0


class Linear:
    """The wheelset near its steady motion in the middle of a straight track.

    Parameters are those of :class:`Loop`, without starts.  An instance opens the FMUs; use it in ``with``.
    """

    def __init__(self, archives, wheelset=None, contact=None, friction=0.3):
        self.parameters = dict(wheelset or {})
        self.loop = Loop(archives, self.parameters, {"contact_damping": 0.0} | (contact or {}), friction)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.loop.close()

    def steady(self, speed):
        """Forces (6,) and their derivatives (6, 9) in the steady motion at ``speed`` [m/s], by Newton's
        method for the height, at which the load is carried, and the rotation, at which nothing drives the
        axle."""
        wheelset = Wheelset(instance_name="linear")
        wheelset.parameters.update(self.parameters, frame_speed=speed)
        wheelset.prepare()
        motion = np.zeros(9)
        motion[[1, 8]] = self.loop.stand[0], wheelset.rolling
        for _ in range(8):
            self.loop.moved.write([*motion, speed, 0.0])
            forces, by = np.array(self.loop.given.read()), self.loop.derivatives()
            missing = np.array([forces[1] + wheelset.parameters["load"], forces[5]])
            motion[[1, 8]] -= np.linalg.solve(by[np.ix_([1, 5], [1, 8])], missing)
        return wheelset, forces, by

    def matrix(self, speed):
        """Of the linear motion at ``speed`` [m/s]: (9, 9)."""
        wheelset, forces, by = self.steady(speed)
        wheelset.derivatives = by
        wheelset.forces = dict(zip(wheelset.forces, forces))
        return np.vstack([np.eye(4, 9, 4), wheelset.jacobian()])

    def root(self, speed):
        """The eigenvalue of hunting: growth [1/s] and circular frequency [rad/s]."""
        found = [root for root in np.linalg.eigvals(self.matrix(speed)) if 1e-3 < root.imag < SLOW]
        return max(found, key=lambda root: root.real) if found else complex(np.nan, np.nan)

    def critical_speed(self, low, high):
        """Speed [m/s] between ``low`` and ``high`` at which hunting begins to grow; ValueError without
        one."""
        return brentq(lambda speed: self.root(speed).real, low, high, xtol=1e-6)
