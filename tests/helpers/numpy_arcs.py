"""Tables of the rail's arc length by numpy, as a witness of kernel/prepare/curvatures.py.

Cubics of Hermite over even cells (the kernel's record CubicTable): value and slope at the ends are exact.
"""

import numpy as np

from tests.helpers.numpy_curvatures import ArcLength

#: Longest cell [m].
ARC_STEP = 1e-4


def arc_tables(profile):
    """Tables (n,) of a compiled profile's arc length over its abscissa, and of the abscissa over its arc."""
    arc = ArcLength(profile)
    x = even(arc.start, arc.stop)
    length = even(0.0, arc.total)
    place = np.append(arc.start, np.append(arc.place(length[1:-1]), arc.stop))
    return (hermite(x, np.append(0.0, np.append(arc.at(x[1:-1]), arc.total)), arc.speed(x)),
            hermite(length, place, 1.0 / arc.speed(place)))


def even(start, stop):
    """Even places (n,) from ``start`` to ``stop`` [m], no farther apart than ARC_STEP."""
    return np.linspace(start, stop, int(np.ceil((stop - start) / ARC_STEP)) + 1)


def hermite(at, value, slope):
    """Table (n,) of the cubics with this value and slope at even places ``at``."""
    step = (at[-1] - at[0]) / (len(at) - 1)
    rise, low, high = np.diff(value), step * slope[:-1], step * slope[1:]
    cells = np.stack([value[:-1], low, 3 * rise - 2 * low - high, low + high - 2 * rise], axis=1)
    return np.concatenate([[len(at) - 1, at[0], 1.0 / step], cells.ravel()])
