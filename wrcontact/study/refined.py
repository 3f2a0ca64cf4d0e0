"""The source's two proposals for a cheaper 3-D search, its chapter 9: a dx that adapts, and
denser nodes near the contact.

Both begin with coarse nodes on all of the wheel that yaw can bring to the rail, ahead and behind, so
that neither Wang's limit nor a 2-D search is needed. Then they add finer nodes around the contact
just found and roll on from there, level after level. The coarse nodes stay, so another minimum is
still seen, up to what the coarse nodes can hide.
"""

import math

import numpy as np

from ..conventions import SIDES
from .search import Result, balance
from .surfaces import Pose, ProfileMatrix, Surfaces, profile_nodes, rail_polyline

#: A level is repeated around the new contact while that moves out of the finer nodes, so often at most.
REPEATS = 6
#: A level's nodes reach so many nodes of the coarser level to either side of the contact.
WINDOW = 2


class AdaptiveSearch:
    """3-D search with a dx that adapts: from ``coarse_dx`` to ``dx`` [m] in steps of
    ``factor``, all nodes in y.

    ``spacing``, ``gain``, ``tolerance`` as for :class:`~wrcontact.study.search.Search3D`.
    """

    def __init__(self, system, dx=1e-5, spacing=1e-4, coarse_dx=2e-3, factor=6, gain=1.2, tolerance=1e-7):
        self.surfaces = Surfaces(system)
        self.gain, self.tolerance = gain, tolerance
        self.levels = [(step, spacing) for step in spacings(coarse_dx, dx, factor)]
        self._rail = rail_polyline(self.surfaces, spacing)

    def solve(self, lateral_shift=0.0, yaw=0.0):
        """:class:`~wrcontact.study.search.Result` at ``lateral_shift`` [m] and ``yaw`` [rad];
        counts are of all levels."""
        pose, steps, evaluations = Pose(lateral_shift, yaw), 0, 0
        base = {side: [self._matrix(self._all_rows(pose), self._all_nodes())] for side in SIDES}
        finer, level, repeats = {side: [] for side in SIDES}, 0, 0
        while True:
            found = balance({side: base[side] + finer[side] for side in SIDES}, pose, gain=self.gain,
                            tolerance=self.tolerance)
            steps, evaluations = steps + found.steps, evaluations + found.gap_evaluations
            settled = (level == 0 or repeats == REPEATS
                       or all(inside(finer[side][0], getattr(found, side)) for side in SIDES))
            remark = (found.remark
                      or ("" if settled and repeats < REPEATS else "the contact moves between the levels"))
            level, repeats = (level + 1, 0) if settled else (level, repeats + 1)
            if not found.converged or level == len(self.levels):
                return Result(found.roll, found.vertical_shift, found.left, found.right, steps, evaluations,
                              found.converged, remark)
            finer = {side: [self._around(getattr(found, side), level, yaw)] for side in SIDES}
            pose = Pose(lateral_shift, yaw, found.roll)

    def _matrix(self, x, y):
        return ProfileMatrix(self.surfaces, self._rail, x, y)

    def _all_rows(self, pose):
        dx = self.levels[0][0]
        count = math.ceil(self.surfaces.reach(pose.yaw) / dx) if pose.yaw else 0
        return dx * np.arange(-count, count + 1)

    def _all_nodes(self):
        return profile_nodes(self.surfaces.wheel_ends, self.levels[0][1])

    def _around(self, contact, level, yaw):
        """Finer nodes around ``contact``."""
        return self._matrix(self._near_rows(contact, level, yaw), self._all_nodes())

    def _near_rows(self, contact, level, yaw):
        if yaw == 0.0:
            return np.zeros(1)
        return near(contact.x_wheel, WINDOW * self.levels[level - 1][0], self.levels[level][0])


class DenserSearch(AdaptiveSearch):
    """3-D search with denser nodes near the contact, in both directions: from (``coarse_dx``,
    ``coarse_spacing``) to (``dx``, ``spacing``) [m] in steps of ``factor``."""

    def __init__(self, system, dx=1e-5, spacing=1e-5, coarse_dx=2e-3, coarse_spacing=5e-4, factor=6, gain=1.2,
                 tolerance=1e-7):
        super().__init__(system, dx, spacing, coarse_dx, factor, gain, tolerance)
        across = spacings(coarse_spacing, spacing, factor)
        along = [step for step, _ in self.levels]
        count = max(len(along), len(across))
        self.levels = [(along[min(k, len(along) - 1)], across[min(k, len(across) - 1)]) for k in range(count)]

    def _around(self, contact, level, yaw):
        coarser, spacing = self.levels[level - 1][1], self.levels[level][1]
        # where the profiles are nearly conformal the coarse nodes tell the place to a few of them only
        y = near(contact.y_wheel, 2 * WINDOW * coarser, spacing)
        y = y[(y > self.surfaces.wheel_ends[0]) & (y < self.surfaces.wheel_ends[1])]
        return self._matrix(self._near_rows(contact, level, yaw), y)


def spacings(coarse, fine, factor):
    """Falling distances from ``coarse`` to ``fine`` [m], each at most ``factor`` times the
    next one, in equal ratios."""
    count = max(0, math.ceil(math.log(coarse / fine) / math.log(factor) - 1e-9))
    return [coarse * (fine / coarse)**(k / max(count, 1)) for k in range(count + 1)]


def near(centre, half_width, step):
    """Nodes (n,) at multiples of ``step`` from ``centre`` within ``half_width`` [m]."""
    count = math.ceil(half_width / step)
    return centre + step * np.arange(-count, count + 1)


def inside(matrix, contact):
    """Whether ``contact`` is one of the matrix's inner nodes."""
    return all(len(nodes) == 1 or nodes[0] < value < nodes[-1]
               for nodes, value in ((matrix.x, contact.x_wheel), (matrix.y, contact.y_wheel)))
