"""What is to be solved: two surfaces, their materials, and a load or an approach."""

from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from .deflection import Deflection


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
        return Deflection(shape, dx, ds, self.contact_modulus, corners=corners, angle=angle,
                          coupling=self.coupling)

    def weight(self, angle):
        """What the pressures at places with these ``angle`` add to the force, as a share."""
        return np.cos(angle) if self.vertical else np.ones_like(angle)
