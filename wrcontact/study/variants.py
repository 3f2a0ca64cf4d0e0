"""Two other ways to search: the source's proposals for a cheaper 3-D search, and nonlinear equations.

The proposals are those of the source's chapter 9: a dx that adapts, and denser nodes near the contact. Both
begin with coarse nodes on all of the wheel that yaw can bring to the rail, ahead and behind, so that neither
Wang's limit nor a 2-D search is needed. Then they add finer nodes around the contact just found and roll on
from there, level after level. The coarse nodes stay, so another minimum is still seen, up to what the coarse
nodes can hide.

The equations are the approach of De Pater and of Yang that the source describes in its section 2.1.
Of each wheel a point has to coincide with one of the rail and the normals there to be parallel; lateral shift
and yaw are given, and both wheels are solved at once. (The source's authors give roll and yaw and ask for the
lateral shift.) Yang's third condition, that nothing penetrates, is not an equation: what a solver finds is a
stationary point of the gap, and is looked at afterwards.
"""

import math
from dataclasses import replace

import numpy as np
from scipy.optimize import root

from ..conventions import MILLIMETRE as MM
from ..conventions import SIDES
from .search import Contact, Pose, ProfileMatrix, Result, Surfaces, balance, profile_nodes, rail_polyline

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
            found = balance(
                {side: base[side] + finer[side] for side in SIDES},
                pose,
                gain=self.gain,
                tolerance=self.tolerance,
            )
            steps, evaluations = steps + found.steps, evaluations + found.gap_evaluations
            settled = (
                level == 0
                or repeats == REPEATS
                or all(inside(finer[side][0], getattr(found, side)) for side in SIDES)
            )
            remark = found.remark or (
                "" if settled and repeats < REPEATS else "the contact moves between the levels"
            )
            level, repeats = (level + 1, 0) if settled else (level, repeats + 1)
            if not found.converged or level == len(self.levels):
                return replace(found, steps=steps, gap_evaluations=evaluations, remark=remark)
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

    def __init__(
        self,
        system,
        dx=1e-5,
        spacing=1e-5,
        coarse_dx=2e-3,
        coarse_spacing=5e-4,
        factor=6,
        gain=1.2,
        tolerance=1e-7,
    ):
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
    return [coarse * (fine / coarse) ** (k / max(count, 1)) for k in range(count + 1)]


def near(centre, half_width, step):
    """Nodes (n,) at multiples of ``step`` from ``centre`` within ``half_width`` [m]."""
    count = math.ceil(half_width / step)
    return centre + step * np.arange(-count, count + 1)


def inside(matrix, contact):
    """Whether ``contact`` is one of the matrix's inner nodes."""
    return all(
        len(nodes) == 1 or nodes[0] < value < nodes[-1]
        for nodes, value in ((matrix.x, contact.x_wheel), (matrix.y, contact.y_wheel))
    )


# --- equations -------------------------------------------------------------------------------------


#: Largest residual of a solution: lengths [m], and normals [-].
RESIDUAL = 1e-12
#: A wheel deeper in its rail than this [m] is no contact; the nodes of the check see some 1e-7 less or more.
DEPTH = 1e-6


class ConstraintSearch:
    """Roll, vertical shift and both contacts from eight equations, by ``scipy.optimize.root``.

    The unknowns are roll and vertical shift, and for each wheel the angle phi around the wheel,
    y_wheel and y_rail. With the wheel point P = R (r sin phi, b + y, r cos phi) + centre and its
    normal n = R (sin phi, -r', cos phi):

        P_y = y_rail,   P_z = z_rail(y_rail),   n_x = 0,   n_y + z_rail' n_z = 0.

    Parameters
    ----------
    system : :class:`~wrcontact.system.ContactSystem`.
    method : of ``scipy.optimize.root``.
    """

    def __init__(self, system, method="hybr"):
        self.surfaces, self.method = Surfaces(system), method
        self._rail = rail_polyline(self.surfaces, 1e-4)
        self._nodes = profile_nodes(self.surfaces.wheel_ends, 1e-4)
        # lengths in mm, angles as the mm that they move a contact
        arm, radius = self.surfaces.arm / MM, self.surfaces.radius / MM
        self._scale = 1.0 / np.array([arm, 1 / MM, radius, 1 / MM, 1 / MM, radius, 1 / MM, 1 / MM])

    def solve(self, lateral_shift=0.0, yaw=0.0, *, start):
        """:class:`~wrcontact.study.search.Result` at ``lateral_shift`` [m] and ``yaw`` [rad].

        Parameters
        ----------
        start : where the solver begins: roll [rad], and y_wheel [m] of the left and of the right wheel; the
            angle around the wheel begins where the normal's n_x is about zero, y_rail below the wheel point.
        """
        evaluations = 0

        def residuals(scaled):
            nonlocal evaluations
            evaluations += 1
            return self._residuals(scaled * self._scale, lateral_shift, yaw)

        first = self._first(Pose(lateral_shift, yaw, start[0]), start[1:])
        with np.errstate(all="ignore"):  # far from the profiles their end pieces overflow
            values = root(residuals, first / self._scale, method=self.method, tol=1e-15).x * self._scale
            residual = np.max(np.abs(self._residuals(values, lateral_shift, yaw)))
        converged = bool(residual < RESIDUAL / MM)
        remark = self._fault(values, lateral_shift, yaw) if converged else "the equations are not met"
        return Result(
            float(values[0]),
            float(values[1]),
            *map(self._contact, (values[2:5], values[5:])),
            evaluations,
            2 * evaluations,
            converged,
            remark,
        )

    def _contact(self, unknowns):
        phi, y, y_rail = map(float, unknowns)
        return Contact(
            (self.surfaces.radius + float(self.surfaces.wheel(np.array(y))[0])) * math.sin(phi), y, y_rail
        )

    def _first(self, pose, places):
        values = [pose.roll, 0.0]
        for side, y in zip(SIDES, places):
            here = pose.of(side)
            # where n_x is about zero
            phi = -math.tan(here.yaw) * float(self.surfaces.wheel(np.array(y))[1])
            values += [phi, y, self._wheel_point(here, phi, y)[0][1] - self.surfaces.rail_y]
        return np.array(values)

    def _wheel_point(self, pose, phi, y):
        """Point of a right wheel and its normal in the track frame, (3,) each; vertical shift 0."""
        z, slope = self.surfaces.wheel(np.array(y))
        r, s, c = self.surfaces.radius + z, math.sin(phi), math.cos(phi)
        point = turned(pose, r * s, self.surfaces.arm + y, r * c)
        return (point[0], point[1] + pose.lateral_shift, point[2] - self.surfaces.radius), turned(
            pose, s, -slope, c
        )

    def _residuals(self, values, lateral_shift, yaw):
        """Residuals (8,): lengths in mm, normals in 1e-3."""
        pose, residuals = Pose(lateral_shift, yaw, values[0]), []
        for side, (phi, y, y_rail) in zip(SIDES, (values[2:5], values[5:])):
            point, normal = self._wheel_point(pose.of(side), phi, y)
            height, slope = self.surfaces.rail(np.array(y_rail))
            residuals += [
                point[1] - self.surfaces.rail_y - y_rail,
                point[2] + values[1] - height,
                normal[0],
                normal[1] + slope * normal[2],
            ]
        return np.array(residuals, dtype=float) / MM

    def _fault(self, values, lateral_shift, yaw):
        """What is wrong with a solution of the equations, "" if nothing: beside the profiles,
        or a wheel in its rail."""
        for phi_y in (values[2:5], values[5:]):
            for place, ends in zip(phi_y[1:], (self.surfaces.wheel_ends, self.surfaces.rail_ends)):
                if not ends[0] <= place <= ends[1]:
                    return "a solution beside the profiles"
        reach = self.surfaces.reach(yaw) if yaw else 0.0
        matrix = ProfileMatrix(
            self.surfaces, self._rail, np.unique(np.linspace(-reach, reach, 161)), self._nodes
        )
        pose = Pose(lateral_shift, yaw, values[0])
        depth = max(values[1] - matrix.lowest(pose.of(side)).gap for side in SIDES)
        return (
            f"another stationary point: a wheel is {depth / MM:.3g} mm in its rail" if depth > DEPTH else ""
        )


def turned(pose, x, y, z):
    """R (x, y, z) with R = Rz(yaw) Rx(roll)."""
    ct, st, cp, sp = math.cos(pose.roll), math.sin(pose.roll), math.cos(pose.yaw), math.sin(pose.yaw)
    across, down = ct * y - st * z, st * y + ct * z
    return cp * x - sp * across, sp * x + cp * across, down
