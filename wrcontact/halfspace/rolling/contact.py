"""Steady rolling contact on given pressures: the solution on one grid."""

from dataclasses import dataclass

import numpy as np
from scipy import ndimage

from .influence import slip_influence
from .newton import solve_friction
from .pressure import PressureField

#: The rigid slip of a cell is taken at this share of a cell upstream of its middle; the elastic slip belongs
#: to its upstream edge.  Extrapolated forces hardly depend on it: 0 and 0.5 differ by 0.06 % of the friction
#: limit with spin.
SLIP_OFFSET = 0.4


@dataclass(frozen=True)
class RollingSolution:
    """Tractions on the wheel, forces on it, and slip of the wheel over the rail.

    Attributes
    ----------
    field : the :class:`PressureField`.
    tractions : along x and y on the cells (2, ny, nx) [Pa].
    slip : of the wheel over the rail, along x and y, over the rolling speed (2, ny, nx) [1].
    slips : where friction is used up (ny, nx).
    steps : Newton steps.
    """

    field: PressureField
    tractions: np.ndarray
    slip: np.ndarray
    slips: np.ndarray
    steps: int

    @property
    def force_x(self):
        """Along the rolling direction [N]."""
        return float(self.tractions[0].sum() * self.field.cell_area)

    @property
    def force_y(self):
        """Across [N]."""
        return float(self.tractions[1].sum() * self.field.cell_area)

    @property
    def moment(self):
        """About the normal through the origin [N m]."""
        x, y = np.meshgrid(self.field.x, self.field.y)
        return float((x * self.tractions[1] - y * self.tractions[0]).sum() * self.field.cell_area)

    @property
    def stick_share(self):
        """Share of the patch's area without slip, 0 ... 1."""
        cover = self.field.cover
        return float(cover[~self.slips].sum() / cover.sum())

    @property
    def max_shear(self):
        """Largest traction of a cell [Pa]."""
        return float(np.hypot(*self.tractions).max())

    @property
    def dissipation(self):
        """Friction power over the rolling speed, W/(m/s) = N."""
        return float(-(self.tractions * self.slip).sum() * self.field.cell_area)

    def line_loads(self):
        """Traction of each row per metre across, along x and y (2, ny) [N/m]."""
        return self.tractions.sum(axis=2) * self.field.steps[1]


def rigid_slip(field, creepage_x, creepage_y, spin, offset=SLIP_OFFSET):
    """Slip of the rigid bodies over V, (xi - phi y, eta + phi x), on the cells (2, ny, nx) [1].  (R2)

    ``creepage_x`` and ``creepage_y`` are numbers or one value for each row (ny,).
    """
    x, y = np.meshgrid(field.x + offset * field.steps[1], field.y)
    creepage_x, creepage_y = (np.broadcast_to(each, len(field.y))[:, None]
                              for each in (creepage_x, creepage_y))
    return np.stack([creepage_x - spin * y, creepage_y + spin * x])


def refined(tractions, shape):
    """Tractions (2, n, m) on another number of cells over the same rectangle, by straight lines."""
    factors = [new / old for new, old in zip(shape, tractions.shape[1:])]
    return np.stack([ndimage.zoom(each, factors, order=1, mode="nearest", grid_mode=True)
                     for each in tractions])


def rolling_contact(field, *, creepage_x, creepage_y, spin, friction, shear_modulus, poisson_ratio,
                    start=None):
    """The :class:`RollingSolution` on the cells of ``field``: Kalker's steady rolling problem.

    Both bodies are half-spaces of the same material.  Rolling towards +x; creepages are the slip of the
    wheel over the rail divided by the rolling speed, forces and tractions act on the wheel.

        w - du/dx = s,   |p| <= mu p_n,   s = 0 or p = -mu p_n s/|s|                             (R1) ... (R3)

    Kalker (1990), chapters 4 and 5.

    Parameters
    ----------
    field : :class:`PressureField`.
    creepage_x, creepage_y : xi, eta [1]; a number, or one for each row (ny,).
    spin : phi [1/m].
    friction : mu [1].
    shear_modulus, poisson_ratio : of both bodies [Pa], [1].
    start : :class:`RollingSolution` to start from, of the same patch on any number of cells.

    Raises
    ------
    ValueError
        if the friction, the shear modulus or Poisson's ratio is out of its range.
    ArithmeticError
        if the Newton steps do not converge.
    """
    slip = rigid_slip(field, creepage_x, creepage_y, spin)
    return contact_of_slip(field, slip, friction=friction, shear_modulus=shear_modulus,
                           poisson_ratio=poisson_ratio, start=start)


def contact_of_slip(field, slip, *, friction, shear_modulus, poisson_ratio, start=None):
    """The :class:`RollingSolution` for any slip of the rigid bodies over V, ``slip`` (2, ny, nx) [1].

    Other parameters and errors as for :func:`rolling_contact`.
    """
    check_material(friction, shear_modulus, poisson_ratio)
    bound = friction * field.pressure
    influence = slip_influence(bound.shape, field.steps, float(shear_modulus), float(poisson_ratio))
    tractions = np.zeros((2, *bound.shape)) if start is None else refined(start.tractions, bound.shape)
    state, steps = solve_friction(influence, slip, bound, tractions)
    return RollingSolution(field, state.tractions, state.slip, state.slips, steps)


def check_material(friction, shear_modulus, poisson_ratio):
    """Refuses values out of their range with a ValueError."""
    if not (np.isfinite(friction) and friction > 0.0):
        raise ValueError(f"friction: {friction} must be positive")
    if not (np.isfinite(shear_modulus) and shear_modulus > 0.0):
        raise ValueError(f"shear_modulus: {shear_modulus} Pa must be positive")
    if not 0.0 <= poisson_ratio <= 0.5:
        raise ValueError(f"poisson_ratio: {poisson_ratio} must be 0 ... 0.5")
