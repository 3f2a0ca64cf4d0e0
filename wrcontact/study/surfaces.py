"""Wheel and rail surfaces of a ContactSystem as the searches read them, in numpy.

Everything is written for a right wheel; the left one comes in mirrored (conventions.MIRROR). The profiles are
the kernel's own tables, so a search can differ from the exact one by its method only.
"""

import math
from dataclasses import dataclass

import numpy as np

from ..conventions import MIRROR
from ..profiles.compiled import ends, evaluate_table


@dataclass(frozen=True)
class Pose:
    """Pose of a wheel seen as a right one: lateral shift [m], yaw [rad], roll [rad]."""

    lateral_shift: float
    yaw: float
    roll: float = 0.0

    def of(self, side):
        """This wheelset's pose as that of the ``side`` wheel, mirrored if it is the left one."""
        return self if side == "right" else Pose(*(sign * value for sign, value in
                                                   zip(MIRROR, (self.lateral_shift, self.yaw, self.roll))))


class Surfaces:
    """Profiles, places and radius of ``system``.

    Attributes
    ----------
    radius, arm : nominal radius, and half the distance of the running circles [m].
    rail_y : lateral track coordinate of the right rail's highest point [m].
    wheel_ends, rail_ends : first and last abscissa of the profiles (2,) [m].
    """

    def __init__(self, system):
        chosen = system.parameters
        self.radius, self.arm = chosen["nominal_radius"], 0.5 * chosen["running_circle_distance"]
        self._wheel, self._rail, self.rail_y = system.profile_tables()
        self.wheel_ends, self.rail_ends = ends(self._wheel), ends(self._rail)

    def wheel(self, y):
        """Height [m] and slope [-] of the wheel profile at ``y`` [m], two arrays of its shape."""
        return evaluate_table(self._wheel, y)[:2]

    def rail(self, y):
        """Height [m] and slope [-] of the placed rail's profile at ``y`` [m]."""
        return evaluate_table(self._rail, y)[:2]

    def reach(self, yaw):
        """How far ahead of or behind its principal profile the wheel can touch at ``yaw``,
        whatever the contact [m]."""
        y = np.linspace(*self.wheel_ends, 2001)
        return self.radius * min(1.0, abs(math.tan(yaw)) * 1.05 * np.abs(self.wheel(y)[1][20:-20]).max())


def profile_nodes(ends, spacing):
    """Multiples of ``spacing`` [m] between ``ends`` (2,)."""
    first, last = math.ceil(ends[0] / spacing + 1e-9), math.floor(ends[1] / spacing - 1e-9)
    return spacing * np.arange(first, last + 1)


@dataclass(frozen=True)
class Lowest:
    """The smallest gap [m] of a wheel, where it is (x_wheel, y_wheel, y_rail, y_axle) [m],
    and the gaps taken for it.

    ``y_axle`` is its distance from the wheelset's centre along the yawed, unrolled axle.
    """

    gap: float
    x_wheel: float
    y_wheel: float
    y_rail: float
    y_axle: float
    evaluations: int


class ProfileMatrix:
    """The wheel cut by planes across its axle at x (n,), each a profile at y (m,):
    source eqs. (5.10), (5.11).

    ``R_n(y) = R_0(y) cos(alpha_n)``, ``sin(alpha_n) = x_n / R_0(y)``; the 2-D search has x = 0 alone.
    """

    CHUNK = 2**17  #: gaps at a time, to stay in the cache

    def __init__(self, surfaces, rail, x, y):
        self.surfaces, self.x, self.y = surfaces, np.atleast_1d(np.asarray(x, dtype=float)), y
        self.rail = rail
        R0 = surfaces.radius + surfaces.wheel(y)[0]
        self.heights = np.sqrt(R0**2 - self.x[:, None]**2)          # (n, m), below the axle

    def lowest(self, pose, mapping=1.0):
        """The smallest of source eq. (5.13)'s distances at ``pose``, as (5.14) asks for; a :class:`Lowest`.

        The matrix is rolled about the axle's centre; the rail, a polyline (2, k), is read below each node.
        ``mapping`` stretches the rail's abscissa about its top, for source eq. (5.12) as printed. The gap is
        infinite beside the rail.
        """
        best = Lowest(math.inf, math.nan, math.nan, math.nan, math.nan, self.heights.size)
        rows = max(1, self.CHUNK // len(self.y))
        for first in range(0, len(self.x), rows):
            gap, abscissa, along = self._gaps(pose, slice(first, first + rows), mapping)
            row, column = np.unravel_index(np.argmin(gap), gap.shape)
            if gap[row, column] < best.gap:
                best = Lowest(float(gap[row, column]), float(self.x[first + row]), float(self.y[column]),
                              float(abscissa[row, column]), float(along[row, column]), self.heights.size)
        return best

    def _gaps(self, pose, rows, mapping):
        c, s = math.cos(pose.roll), math.sin(pose.roll)
        heights, arm = self.heights[rows], self.surfaces.arm + self.y
        along = c * arm - s * heights                               # y_w of source fig. 5.2
        depth = s * arm + c * heights - self.surfaces.radius
        lateral = pose.lateral_shift + math.sin(pose.yaw) * self.x[rows, None] + math.cos(pose.yaw) * along
        abscissa = lateral - self.surfaces.rail_y
        heights = np.interp(mapping * abscissa, *self.rail, left=math.inf, right=math.inf)
        return heights - depth, abscissa, along


def rail_polyline(surfaces, spacing):
    """Abscissae and heights (2, n) [m] of the rail's nodes at multiples of ``spacing`` [m]."""
    y = profile_nodes(surfaces.rail_ends, spacing)
    return np.array([y, surfaces.rail(y)[0]])
