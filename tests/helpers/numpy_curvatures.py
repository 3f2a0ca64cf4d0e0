"""Lateral curvature of a profile all along it by numpy, as a witness of kernel/prepare/curvatures.py.

The table is the kernel's record CurvatureTable. Curvatures here are d(angle)/d(arc length) with z down,
positive where the profile is hollow upwards; the kernel's table has them positive where the profile bulges
towards the other body, which is this sign on a rail and the other one on a wheel.
"""

import numpy as np

from wrcontact.kernel.layout import Profile
from wrcontact.profiles.compiled import evaluate_table, table_pieces

#: Distance of the values: this share of the arc length or reach they are averaged
#: over, and between these [m].
RASTER_SHARE, FINEST, COARSEST = 0.25, 0.01e-3, 0.05e-3
SAMPLES = 61                   # points of a profile that a circle is fitted to
GAUSS_POINTS = 10
ARC_ITERATIONS = 30
ARC_SHARP = 1e-15              # last Newton step to a node [m]


def smooth_curvature_table(profile, sign, reach):
    """Table (n,) of :func:`fitted_curvature`; ``profile`` is a compiled one, ``sign`` +1 for
    a rail, -1 for a wheel."""
    return _table(profile, sign, reach, fitted_curvature)


def rough_curvature_table(profile, sign, step):
    """Table (n,) of :func:`turned_curvature`, likewise."""
    return _table(profile, sign, step, turned_curvature)


def empty_curvature_table():
    """A table with nothing in it, for a choice that reads none."""
    return np.zeros(0)


def _table(profile, sign, scale, curvature):
    start, stop = Profile.at(profile).start, Profile.at(profile).stop
    count = int(np.ceil((stop - start) / np.clip(RASTER_SHARE * scale, FINEST, COARSEST))) + 1
    head = [count, start, (count - 1) / (stop - start)]
    return np.concatenate([head, sign * curvature(profile, np.linspace(start, stop, count), scale)])


def fitted_curvature(profile, y, reach):
    """Curvature [1/m] of the circle fitted to a compiled profile over y - reach ... y +
    reach, at ``y`` (n,) [m].

    The source's smooth one. Least squares of the algebraic distance, in axes along the tangent at y: with u
    along and v across, c (u^2 + v^2) + b u + a = v, whose curvature 2 c / sqrt(1 + b^2 - 4 a c) is exact for
    a circle and zero for a straight line. At an end of the profile only what is there is fitted.
    """
    start, stop = Profile.at(profile).start, Profile.at(profile).stop
    low, high = np.maximum(y - reach, start), np.minimum(y + reach, stop)
    at = low[:, None] + (high - low)[:, None] * np.linspace(0.0, 1.0, SAMPLES)
    z0, slope, _ = evaluate_table(profile, y)
    across, down = at - y[:, None], evaluate_table(profile, at)[0] - z0[:, None]
    cosine = 1 / np.sqrt(1 + slope[:, None]**2)
    sine = slope[:, None] * cosine
    u, v = (across * cosine + down * sine) / reach, (down * cosine - across * sine) / reach
    columns = np.stack([np.ones_like(u), u, u**2 + v**2], axis=2)
    turned = np.swapaxes(columns, 1, 2)
    a, b, c = np.moveaxis(np.linalg.solve(turned @ columns, turned @ v[:, :, None])[:, :, 0], 1, 0)
    return 2 * c / np.sqrt(1 + b**2 - 4 * a * c) / reach


def turned_curvature(profile, y, step):
    """Change of a compiled profile's angle per arc length [1/m], from chord to chord between nodes ``step``
    [m] of arc before ``y`` (n,), at y and after it.

    The source's rough one, eq. (6.3), which writes what nodes n, n + 1 and n + 2 give to node n; here it
    stands at the middle one. Nodes beyond an end of the profile are not there: the three are moved inward.
    """
    arc = ArcLength(profile)
    step = min(step, 0.5 * arc.total)
    middle = np.clip(arc.at(y), step, arc.total - step)
    nodes = [arc.place(middle + k * step) for k in (-1, 0, 1)]
    heights = [evaluate_table(profile, at)[0] for at in nodes]
    before, after = (np.arctan2(heights[k + 1] - heights[k], nodes[k + 1] - nodes[k]) for k in (0, 1))
    return (after - before) / step


class ArcLength:
    """Arc length along a compiled profile from its start, and back; exact to rounding.

    Gauss's formula within each piece of the profile: at the pieces' ends the curvature may jump.
    """

    def __init__(self, profile):
        self.profile = profile
        self.start, self.stop = Profile.at(profile).start, Profile.at(profile).stop
        pieces = table_pieces(profile)
        self._ends = np.append(pieces[:-1, 0], self.stop)
        self._lengths = np.append(0.0, np.cumsum(self._panel(self._ends[:-1], self._ends[1:])))
        self.total = self._lengths[-1]

    def speed(self, y):
        """Arc length per abscissa [-] at ``y``."""
        return np.sqrt(1 + evaluate_table(self.profile, y)[1] ** 2)

    def _panel(self, low, high):
        nodes, weights = np.polynomial.legendre.leggauss(GAUSS_POINTS)
        half = 0.5 * (high - low)
        return half * (self.speed((0.5 * (low + high))[:, None] + half[:, None] * nodes) @ weights)

    def at(self, y):
        """Arc length [m] at ``y`` (n,) [m]."""
        piece = np.clip(np.searchsorted(self._ends, y, side="right") - 1, 0, len(self._ends) - 2)
        return self._lengths[piece] + self._panel(self._ends[piece], y)

    def place(self, length):
        """Abscissa (n,) [m] at arc length ``length`` (n,) [m]: Newton's method within
        the piece that holds it."""
        piece = np.clip(np.searchsorted(self._lengths, length, side="right") - 1, 0, len(self._ends) - 2)
        low, high = self._ends[piece], self._ends[piece + 1]
        share = (length - self._lengths[piece]) / (self._lengths[piece + 1] - self._lengths[piece])
        y = low + share * (high - low)
        for _ in range(ARC_ITERATIONS):
            before, y = y, np.clip(y + (length - self._lengths[piece] - self._panel(low, y)) / self.speed(y),
                                   low, high)
            if np.all(np.abs(y - before) <= ARC_SHARP):
                break
        return y
