"""Steady rolling contact of two equal elastic half-spaces on given pressures: the solution on one grid.

Tractions are constant on each cell.  Their displacements are Cerruti's (Johnson 1985, section 3.6),
integrated over a cell in closed form, and summed by fast Fourier transforms.  Equations (R3) ... (R5) of
docs/theory/rolling.md.
"""

import math
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from scipy import fft, ndimage

from .newton import solve_friction
from .pressure import PressureField

#: The rigid slip of a cell is taken at this share of a cell upstream of its middle; the elastic slip belongs
#: to its upstream edge.  Extrapolated forces hardly depend on it: 0 and 0.5 differ by 0.06 % of the friction
#: limit with spin.
SLIP_OFFSET = 0.4
#: Bounds of falling friction that change by less than this, of the largest bound, stand.
LAW_PRECISION = 1e-4
LAW_LIMIT = 40
#: Way of slip over which friction follows the slip [m].  With none the solution depends on the cells.
MEMORY = 1e-6


def _log_of_sum(along, across):
    """ln(along + r) with r = hypot(along, across), for any sign of ``along``, without cancellation."""
    r = np.hypot(along, across)
    direct = np.log(np.where(along >= 0.0, along + r, 1.0))
    mirrored = 2.0 * np.log(np.abs(across)) - np.log(r - np.minimum(along, 0.0))
    return np.where(along >= 0.0, direct, mirrored)


def corner_displacements(x, y, poisson_ratio):
    """pi G times the displacement at the origin under a unit traction, integrated twice: xx, xy, yy (3, ...).

    The integrals of Cerruti's ``(1 - nu)/r + nu x^2/r^3``, ``nu x y/r^3`` and ``(1 - nu)/r + nu y^2/r^3``
    over x and y, whose differences over the four corners of a cell are its influence.  (R4)

    Parameters
    ----------
    x, y : corners seen from the place [m]; arrays of one shape, never zero.
    """
    along = y * _log_of_sum(x, y)
    across = x * _log_of_sum(y, x)
    both = (1.0 - poisson_ratio) * (along + across)
    return np.stack(
        [both + poisson_ratio * along, -poisson_ratio * np.hypot(x, y), both + poisson_ratio * across]
    )


class SlipInfluence:
    """Tractions (2, ny, nx) [Pa] on the wheel to the elastic part of the slip (2, ny, nx) [1] over V.

    The displacement difference u of the bodies gives the slip of a particle that passes through the patch
    against x: ``-du/dx``, taken over the cell's width at its upstream edge:

        s_i = (u(x_i) - u(x_i + dx)) / dx                                                            (R5)

    so that no traction jumps at the leading edge.  Grids are padded, so that the periodic convolution of the
    Fourier transform is the plain one.

    Parameters
    ----------
    shape : (ny, nx), rows along y.
    steps : (dy, dx), sides of a cell [m].
    shear_modulus : G of both bodies [Pa].
    poisson_ratio : of both bodies.

    Attributes
    ----------
    own : slip of a cell under its own unit traction along x, along y [1/Pa] (2,).
    rows : influence of a row's cells on each other, along x and along y [1/Pa] (2, nx, nx).
    """

    def __init__(self, shape, steps, shear_modulus, poisson_ratio):
        rows, columns = self.shape = shape
        dy, dx = steps
        x = (np.arange(-columns, columns + 1) + 0.5) * dx
        y = (np.arange(-rows, rows) + 0.5) * dy
        corners = corner_displacements(*np.meshgrid(x, y), poisson_ratio)
        displacement = np.diff(np.diff(corners, axis=1), axis=2) / (math.pi * shear_modulus)
        slip = -np.diff(displacement, axis=2) / dx  # offsets 1 - rows ..., 1 - columns ...
        self.padded = tuple(fft.next_fast_len(2 * count - 1, real=True) for count in shape)
        kernel = np.zeros((3, *self.padded))
        kernel[:, : 2 * rows - 1, : 2 * columns - 1] = slip
        kernel = np.roll(kernel, (1 - rows, 1 - columns), (1, 2))
        self._kernel = fft.rfft2(kernel)
        offsets = columns - 1 + np.subtract.outer(np.arange(columns), np.arange(columns))
        self.rows = slip[::2, rows - 1][:, offsets]
        self.own = self.rows[:, 0, 0]

    def __call__(self, tractions):
        rows, columns = self.shape
        along, across = fft.rfft2(tractions, self.padded)
        spectrum = np.stack(
            [
                self._kernel[0] * along + self._kernel[1] * across,
                self._kernel[1] * along + self._kernel[2] * across,
            ]
        )
        return fft.irfft2(spectrum, self.padded)[:, :rows, :columns]


@lru_cache(maxsize=4)
def slip_influence(shape, steps, shear_modulus, poisson_ratio):
    """The :class:`SlipInfluence` of a grid, kept for the next solution on the same grid."""
    return SlipInfluence(shape, steps, shear_modulus, poisson_ratio)


@dataclass(frozen=True)
class RollingSolution:
    """Tractions on the wheel, forces on it, and slip of the wheel over the rail.

    Attributes
    ----------
    field : the :class:`PressureField`.
    tractions : along x and y on the cells (2, ny, nx) [Pa].
    slip : of the wheel over the rail, along x and y, over the rolling speed (2, ny, nx) [1].
    slips : where friction is used up (ny, nx).
    friction : coefficient of friction of the cells (ny, nx) [1].
    steps : Newton steps.
    """

    field: PressureField
    tractions: np.ndarray
    slip: np.ndarray
    slips: np.ndarray
    friction: np.ndarray
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
    def mean_friction(self):
        """Mean coefficient of friction of the cells, weighted with their pressure, that of rest where it
        sticks [-]."""
        return float((self.friction * self.field.pressure).sum() / self.field.pressure.sum())

    @property
    def dissipation(self):
        """Friction power over the rolling speed, W/(m/s) = N."""
        return float(-(self.tractions * self.slip).sum() * self.field.cell_area)

    def line_loads(self):
        """Traction of each row per metre across, along x and y (2, ny) [N/m]."""
        return self.tractions.sum(axis=2) * self.field.steps[1]


def rigid_slip(field, creepage_x, creepage_y, spin, offset=SLIP_OFFSET):
    """Slip of the rigid bodies over V, (xi - phi y, eta + phi x), on the cells (2, ny, nx) [1].  (R2)

    Each of the three is a number or has one value for each row (ny,).
    """
    x, y = np.meshgrid(field.x + offset * field.steps[1], field.y)
    creepage_x, creepage_y, spin = (
        np.broadcast_to(each, len(field.y))[:, None] for each in (creepage_x, creepage_y, spin)
    )
    return np.stack([creepage_x - spin * y, creepage_y + spin * x])


def refined(tractions, shape):
    """Tractions (2, n, m) on another number of cells over the same rectangle, by straight lines."""
    factors = [new / old for new, old in zip(shape, tractions.shape[1:])]
    return np.stack(
        [ndimage.zoom(each, factors, order=1, mode="nearest", grid_mode=True) for each in tractions]
    )


def rolling_contact(field, *, creepage_x, creepage_y, spin, **material):
    """The :class:`RollingSolution` on the cells of ``field``: Kalker's steady rolling problem.

    Both bodies are half-spaces of the same material.  Rolling towards +x; creepages are the slip of the
    wheel over the rail divided by the rolling speed, forces and tractions act on the wheel.

        w - du/dx = s,   |p| <= mu p_n,   s = 0 or p = -mu p_n s/|s|                             (R1) ... (R3)

    Kalker (1990), chapters 4 and 5.

    Parameters
    ----------
    field : :class:`PressureField`.
    creepage_x, creepage_y, spin : xi, eta [1], phi [1/m]; a number, or one for each row (ny,).
    material : as for :func:`contact_of_slip`.

    Raises
    ------
    ValueError, ArithmeticError
        as :func:`contact_of_slip`.
    """
    return contact_of_slip(field, rigid_slip(field, creepage_x, creepage_y, spin), **material)


def contact_of_slip(field, slip, *, friction, shear_modulus, poisson_ratio, fall=None, start=None):
    """The :class:`RollingSolution` for any slip of the rigid bodies over V, ``slip`` (2, ny, nx) [1].

    Parameters
    ----------
    field : :class:`PressureField`.
    friction : mu [1], that of rest where it falls.
    shear_modulus, poisson_ratio : of both bodies [Pa], [1].
    fall : (floor, rate) of friction that falls with the slip s of each cell by itself:
        mu ((1 - floor) exp(-rate |s|) + floor), with s over V [1]; None: it does not fall.
    start : :class:`RollingSolution` to start from, of the same patch on any number of cells.

    Raises
    ------
    ValueError
        if the friction, the shear modulus or Poisson's ratio is out of its range.
    ArithmeticError
        if the Newton steps or the bounds of falling friction do not converge.
    """
    check_material(friction, shear_modulus, poisson_ratio)
    shape = field.pressure.shape
    influence = slip_influence(shape, field.steps, float(shear_modulus), float(poisson_ratio))
    tractions, local = np.zeros((2, *shape)), np.full(shape, float(friction))
    if start is not None:
        tractions = refined(start.tractions, shape)
    steps = 0
    for _ in range(LAW_LIMIT):
        state, count = solve_friction(influence, slip, local * field.pressure, tractions)
        tractions, steps = state.tractions, steps + count
        fallen = local if fall is None else friction * falling_share(state, field, *fall)
        change = np.abs(fallen - local).max()
        if change <= LAW_PRECISION * friction:
            return RollingSolution(field, tractions, state.slip, state.slips, local, steps)
        local = fallen
    raise ArithmeticError(
        f"falling friction: its coefficient still changes by {change:.1e} (allowed {LAW_PRECISION * friction:.1e})"
    )


def falling_share(state, field, floor, rate):
    """Friction over that of rest (ny, nx) [1], by the slip of the cells at a
    :class:`~wrcontact.halfspace.rolling.newton.Friction`.

    From the leading edge on it follows the law over the way MEMORY of slip; where a cell sticks, it is that
    of rest.
    """
    slip = np.where(state.slips, np.hypot(*state.slip), 0.0)
    wanted = (1.0 - floor) * np.exp(-rate * slip) + floor
    kept = np.exp(-slip * field.steps[1] / MEMORY)
    share, before = np.ones(slip.shape), np.ones(len(slip))
    for column in reversed(range(slip.shape[1])):
        before = wanted[:, column] + kept[:, column] * (before - wanted[:, column])
        before = np.where(state.slips[:, column], before, 1.0)
        share[:, column] = before
    return share


def check_material(friction, shear_modulus, poisson_ratio):
    """Refuses values out of their range with a ValueError."""
    if not (np.isfinite(friction) and friction > 0.0):
        raise ValueError(f"friction: {friction} must be positive")
    if not (np.isfinite(shear_modulus) and shear_modulus > 0.0):
        raise ValueError(f"shear_modulus: {shear_modulus} Pa must be positive")
    if not 0.0 <= poisson_ratio <= 0.5:
        raise ValueError(f"poisson_ratio: {poisson_ratio} must be 0 ... 0.5")
