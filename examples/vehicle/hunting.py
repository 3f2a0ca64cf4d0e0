"""Small swings of the bogie, run in exudyn: growth, frequency, and the speed at which they begin to grow."""

import numpy as np
from scipy.optimize import least_squares

from . import manchester as data
from .contact import CONES, contact_system

#: Start [m], run [s], step [s], from when on the swing is read [s], friction far from its limit.
START, DURATION, STEP, LATER, FRICTION = 0.3e-3, 2.0, 0.5e-3, 0.4, 2.0
SPEEDS = (75.0, 80.0, 85.0)


def touching():
    """How far beside the middle the cones touch the rails [m]."""
    system = contact_system(**CONES | {"contact_mode": "elastic"})
    return system.evaluate(0.0, normal_force=data.LOAD / 2).right.contact.y_track


def swing(time, shifts, rate):
    """Growth g [1/s] and circular frequency w [rad/s] of a swing that several shifts (n, m) share, and what
    it does not explain [m]: ``exp(g t) (a cos w t + b sin w t) + c``, whose a, b and c follow from g and w.

    ``rate`` is near the frequency.
    """

    def basis(found):
        growth, rate = found
        waves = np.exp(growth * time)[:, None] * np.column_stack([np.cos(rate * time), np.sin(rate * time)])
        return np.column_stack([waves, np.ones(len(time))])

    def missing(found):
        own = basis(found)
        return (own @ np.linalg.lstsq(own, shifts, rcond=None)[0] - shifts).ravel() / START

    found = least_squares(missing, [0.0, rate])
    return *found.x, START * np.sqrt(np.mean(found.fun**2))


def grown(speed, rate, tangential_model="strips", duration=DURATION):
    """As :func:`swing`, of the bogie at a ``speed`` [m/s] that swings with about ``rate`` [rad/s]."""
    from .model import Vehicle  # needs exudyn

    contact = CONES | {"tangential_model": tangential_model}
    bogie = Vehicle(speed, bogies=1, start=START, primary=data.SOFT, friction=FRICTION, **contact)
    run = bogie.run(duration, STEP)
    later = run.time > LATER
    return swing(run.time[later], run["shift"][later], rate)


def critical_speed(speeds, growths):
    """Where growth begins [m/s], by the polynomial through what was found."""
    roots = np.roots(np.polyfit(speeds, growths, len(speeds) - 1)).real
    return min(roots, key=lambda root: abs(root - np.mean(speeds)))
