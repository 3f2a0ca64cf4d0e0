"""A solved half-space contact."""

from dataclasses import dataclass, field

import numpy as np


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
