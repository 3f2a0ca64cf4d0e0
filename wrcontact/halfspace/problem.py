"""A contact problem on elastic half-spaces, and its solution."""

from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from .deflection import Deflection


@dataclass(frozen=True)
class HalfspaceContact:
    """A solved contact.

    Attributes
    ----------
    x, s : cell centres (n,), (m,) [m]; evenly spaced, but for jumps where patches far from
        each other have their own grids.
    angle : of the normals at s (m,) [rad].
    pressure : (n, m) [Pa], zero where the bodies are apart.
    clearance : distance of the deformed bodies u + h - delta (n, m) [m], zero to the precision where they
        touch; NaN where rows of one grid cross columns of another.
    penetration : delta, approach of distant points of the bodies [m].
    force : N, the sum of all pressures [N].
    area : of the loaded cells, the edge found within the cells [m^2]; see
    :func:`~wrcontact.halfspace.edge.loaded_area`.
    max_pressure : [Pa], see :func:`~wrcontact.halfspace.edge.peak_pressure`.
    iterations : of the conjugate gradients, over all grids.
    error : estimated relative errors of the grid by name ("penetration" or "force", "area", "max_pressure");
        empty from :func:`~wrcontact.halfspace.one_grid.solve`, which knows one grid.
    """

    x: np.ndarray
    s: np.ndarray
    pressure: np.ndarray
    clearance: np.ndarray
    penetration: float
    force: float
    area: float
    max_pressure: float
    iterations: int
    angle: np.ndarray
    error: dict = field(default_factory=dict)


@dataclass(frozen=True)
class Problem:
    """A contact to be solved.

    Attributes
    ----------
    surfaces : :class:`~wrcontact.halfspace.flat_gap.FlatGap` or
        :class:`~wrcontact.halfspace.turning_gap.TurningGap`.
    domain : (x_low, x_high, s_low, s_high) [m], within which all patches lie.
    contact_modulus : E* [Pa].
    force, penetration : [N], [m]; exactly one of the two.
    precision : residual of the contact condition, rms over the loaded cells, as a share of the largest
        deflection.
    coupling : of :func:`~wrcontact.halfspace.deflection.coupling_of`.
    vertical : whether the force is the vertical part of the pressures, not their sum.
    """

    surfaces: Any
    domain: tuple
    contact_modulus: float
    force: float | None
    penetration: float | None
    precision: float
    coupling: float = 0.0
    vertical: bool = False

    @property
    def wanted(self):
        """The name of what is not prescribed."""
        return "force" if self.force is None else "penetration"

    def near(self, penetration):
        """The same with gaps that are exact at this penetration [m]."""
        return replace(self, surfaces=self.surfaces.near(penetration))

    def deflection(self, shape, dx, ds, angle, corners=None):
        """The :class:`~wrcontact.halfspace.deflection.Deflection` on grids whose normals have these
        angles."""
        return Deflection(
            shape, dx, ds, self.contact_modulus, corners=corners, angle=angle, coupling=self.coupling
        )

    def weight(self, angle):
        """What the pressures at places with these ``angle`` add to the force, as a share."""
        return np.cos(angle) if self.vertical else np.ones_like(angle)
