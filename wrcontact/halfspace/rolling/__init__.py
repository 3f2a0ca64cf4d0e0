"""Creep forces by the complete theory: Kalker's steady rolling problem on the half-space, for any pressures.

>>> from wrcontact.halfspace.rolling import roll_ellipse
>>> forces = roll_ellipse(6e-3, 4e-3, 80e3, creepage_x=-2e-3, creepage_y=0.0, spin=0.0,
...                       friction=0.3, shear_modulus=82e9, poisson_ratio=0.28)
>>> f"{forces.force_x / 24e3:.2f} of the friction limit, {forces.stick_share:.2f} of the area sticks"
'0.60 of the friction limit, 0.62 of the area sticks'

The equations (R1) ... are those of docs/theory/rolling.md.  Lengths in m, pressures in Pa, forces in N;
arrays are
(ny, nx), x along the rolling direction.  Python only; the models of the kernel are measured against it.
"""

from .contact import RollingSolution, contact_of_slip, rigid_slip, rolling_contact
from .extrapolation import (
    RollingForces,
    extrapolated,
    outline_of_patch,
    roll_ellipse,
    roll_outline,
    roll_patch,
)
from .pressure import Outline, PressureField

__all__ = [
    "Outline",
    "PressureField",
    "RollingForces",
    "RollingSolution",
    "contact_of_slip",
    "extrapolated",
    "outline_of_patch",
    "rigid_slip",
    "roll_ellipse",
    "roll_outline",
    "roll_patch",
    "rolling_contact",
]
