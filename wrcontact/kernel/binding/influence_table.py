"""How a strip of contact pressure pushes the half-space down beside it: the table
that the strip correction reads.

A line load along x with the profile sqrt(1 - (x/a)^2), |x| < a, displaces the surface at x = 0 and the
distance eta by a factor times

    Phi(t) = integral from -1 to 1 of sqrt(1 - u^2) / sqrt(u^2 + t^2) du = 2 sqrt(1 + t^2) [K(m) - E(m)]

with t = eta / a, m = 1 / (1 + t^2), and K, E the complete elliptic integrals of parameter m.
Numpy alone, because an FMU makes this table on a machine that may have nothing else. Witness
in tests: the integral itself.
"""

from functools import lru_cache

import numpy as np

from ..layout import Cubic, InfluenceTable
from ..layout.record import OPEN, size
from .hertz_table import elliptic_parts

RANGE = (-11.0, 7.0)  #: of ln t; no two strips lie closer, and farther away nothing is felt
CELLS_PER_UNIT = 10   #: cubics over these cells hold Phi to 1e-6


def influence(t):
    """Phi(t) and t dPhi/dt = -2 sqrt(1 + t^2) [E - (1 - m) K] for t > 0 (n,)."""
    t = np.asarray(t, dtype=float)
    root = np.sqrt(1.0 + t * t)
    _, _, difference, remainder = elliptic_parts(t / root)
    return 2.0 * root * difference, -2.0 * root * remainder


@lru_cache(maxsize=1)
def influence_table():
    """The table as the kernel reads it (n,): cubics through value and slope at even steps of ln t."""
    start, stop = RANGE
    count = round((stop - start) * CELLS_PER_UNIT)
    value, slope = influence(np.exp(start + np.arange(count + 1) / CELLS_PER_UNIT))
    slope = slope / CELLS_PER_UNIT
    rise = np.diff(value)
    cubics = np.zeros((count + 1, 4))           # the record Cubic
    cubics[:, 0] = value
    cubics[:-1, 1] = slope[:-1]
    cubics[:-1, 2] = 3.0 * rise - 2.0 * slope[:-1] - slope[1:]
    cubics[:-1, 3] = slope[:-1] + slope[1:] - 2.0 * rise
    table = np.concatenate([np.zeros(size(InfluenceTable) - OPEN * size(Cubic)), cubics.ravel()])
    head = InfluenceTable.at(table)
    head.start, head.cells_per_unit, head.count = start, CELLS_PER_UNIT, count
    return table
