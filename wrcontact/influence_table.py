"""How a strip of contact pressure pushes the half-space down beside it: the table that the strip correction reads.

A line load along x with the profile sqrt(1 - (x/a)^2), |x| < a, displaces the surface at x = 0 and the distance eta by

    Phi(t) = integral from -1 to 1 of sqrt(1 - u^2) / sqrt(u^2 + t^2) du = 2 sqrt(1 + t^2) [K(m) - E(m)]

times a factor, with t = eta / a, m = 1 / (1 + t^2), and K, E the complete elliptic integrals of parameter m.
"""

from functools import cache

import numpy as np
from scipy.interpolate import CubicHermiteSpline
from scipy.special import ellipe, ellipkm1

#: Range of ln t; below it no two strips lie, above it nothing is felt.
RANGE = (-11.0, 7.0)
CELLS_PER_UNIT = 10  # cubics over these cells hold Phi to 1e-6


def influence(t):
    """Phi(t) and its derivative with respect to ln t; t > 0, any shape."""
    t = np.asarray(t, dtype=float)
    root, complement = np.sqrt(1.0 + t * t), t * t / (1.0 + t * t)
    K, E = ellipkm1(complement), ellipe(1.0 - complement)
    # far away K - E loses digits: (pi / 4) m (1 + 3 m / 8) instead
    far = 1.0 / (1.0 + t * t)
    difference = np.where(far < 1e-4, np.pi / 4 * far * (1.0 + 3.0 / 8.0 * far), K - E)
    # t dPhi/dt = -2 sqrt(1 + t^2) [E - (1 - m) K], far away -(pi / 2) sqrt(1 + t^2) m (1 + m / 8)
    slope = np.where(far < 1e-4, -np.pi / 2 * root * far * (1.0 + far / 8.0), -2.0 * root * (E - complement * K))
    return 2.0 * root * difference, slope


@cache
def influence_table():
    """Head (start, cells per unit, last cell, 0) and the cubics' four coefficients per cell, as strips.py reads them."""
    start, stop = RANGE
    count = round((stop - start) * CELLS_PER_UNIT)
    nodes = start + np.arange(count + 1) / CELLS_PER_UNIT
    value, slope = influence(np.exp(nodes))
    spline = CubicHermiteSpline(nodes, value, slope)
    rows = spline.c[::-1].T * (1.0 / CELLS_PER_UNIT) ** np.arange(4)
    table = np.concatenate([[start, CELLS_PER_UNIT, count, 0.0], rows.ravel(), np.zeros(4)])
    table[-4] = value[-1]
    table.flags.writeable = False
    return table
