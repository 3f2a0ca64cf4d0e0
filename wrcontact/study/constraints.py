"""Contact as nonlinear equations, the approach of De Pater and of Yang that the source
describes in its section 2.1.

Of each wheel a point has to coincide with one of the rail and the normals there to be parallel; lateral shift
and yaw are given, and both wheels are solved at once. (The source's authors give roll and yaw and ask for the
lateral shift.) Yang's third condition, that nothing penetrates, is not an equation: what a solver finds is a
stationary point of the gap, and is looked at afterwards.
"""

import math

import numpy as np
from scipy.optimize import root

from ..conventions import MILLIMETRE as MM
from ..conventions import SIDES
from .search import Contact, Result
from .surfaces import Pose, ProfileMatrix, Surfaces, profile_nodes, rail_polyline

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
        with np.errstate(all="ignore"):     # far from the profiles their end pieces overflow
            values = root(residuals, first / self._scale, method=self.method, tol=1e-15).x * self._scale
            residual = np.max(np.abs(self._residuals(values, lateral_shift, yaw)))
        converged = bool(residual < RESIDUAL / MM)
        remark = self._fault(values, lateral_shift, yaw) if converged else "the equations are not met"
        return Result(float(values[0]), float(values[1]), *map(self._contact, (values[2:5], values[5:])),
                      evaluations, 2 * evaluations, converged, remark)

    def _contact(self, unknowns):
        phi, y, y_rail = map(float, unknowns)
        return Contact((self.surfaces.radius + float(self.surfaces.wheel(np.array(y))[0])) * math.sin(phi), y,
                       y_rail)

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
        return (point[0], point[1] + pose.lateral_shift,
                point[2] - self.surfaces.radius), turned(pose, s, -slope, c)

    def _residuals(self, values, lateral_shift, yaw):
        """Residuals (8,): lengths in mm, normals in 1e-3."""
        pose, residuals = Pose(lateral_shift, yaw, values[0]), []
        for side, (phi, y, y_rail) in zip(SIDES, (values[2:5], values[5:])):
            point, normal = self._wheel_point(pose.of(side), phi, y)
            height, slope = self.surfaces.rail(np.array(y_rail))
            residuals += [point[1] - self.surfaces.rail_y - y_rail, point[2] + values[1] - height,
                          normal[0], normal[1] + slope * normal[2]]
        return np.array(residuals, dtype=float) / MM

    def _fault(self, values, lateral_shift, yaw):
        """What is wrong with a solution of the equations, "" if nothing: beside the profiles,
        or a wheel in its rail."""
        for phi_y in (values[2:5], values[5:]):
            for place, ends in zip(phi_y[1:], (self.surfaces.wheel_ends, self.surfaces.rail_ends)):
                if not ends[0] <= place <= ends[1]:
                    return "a solution beside the profiles"
        reach = self.surfaces.reach(yaw) if yaw else 0.0
        matrix = ProfileMatrix(self.surfaces, self._rail, np.unique(np.linspace(-reach, reach, 161)),
                               self._nodes)
        pose = Pose(lateral_shift, yaw, values[0])
        depth = max(values[1] - matrix.lowest(pose.of(side)).gap for side in SIDES)
        return (f"another stationary point: a wheel is {depth / MM:.3g} mm in its rail" if depth > DEPTH
                else "")


def turned(pose, x, y, z):
    """R (x, y, z) with R = Rz(yaw) Rx(roll)."""
    ct, st, cp, sp = math.cos(pose.roll), math.sin(pose.roll), math.cos(pose.yaw), math.sin(pose.yaw)
    across, down = ct * y - st * z, st * y + ct * z
    return cp * x - sp * across, sp * x + cp * across, down
