"""Slip that tangential tractions cause between two equal elastic half-spaces in steady rolling.

Tractions are constant on each cell of a grid.  Their displacements are Cerruti's (Johnson 1985, section 3.6),
integrated over a cell in closed form, and summed by fast Fourier transforms.  Equations (R3) ... (R5) of
docs/rolling.md.
"""

import math
from functools import lru_cache

import numpy as np
from scipy import fft


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
    return np.stack([both + poisson_ratio * along, -poisson_ratio * np.hypot(x, y),
                     both + poisson_ratio * across])


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
        slip = -np.diff(displacement, axis=2) / dx          # offsets 1 - rows ..., 1 - columns ...
        self.padded = tuple(fft.next_fast_len(2 * count - 1, real=True) for count in shape)
        kernel = np.zeros((3, *self.padded))
        kernel[:, :2 * rows - 1, :2 * columns - 1] = slip
        kernel = np.roll(kernel, (1 - rows, 1 - columns), (1, 2))
        self._kernel = fft.rfft2(kernel)
        offsets = columns - 1 + np.subtract.outer(np.arange(columns), np.arange(columns))
        self.rows = slip[::2, rows - 1][:, offsets]
        self.own = self.rows[:, 0, 0]

    def __call__(self, tractions):
        rows, columns = self.shape
        along, across = fft.rfft2(tractions, self.padded)
        spectrum = np.stack([self._kernel[0] * along + self._kernel[1] * across,
                             self._kernel[1] * along + self._kernel[2] * across])
        return fft.irfft2(spectrum, self.padded)[:, :rows, :columns]


@lru_cache(maxsize=4)
def slip_influence(shape, steps, shear_modulus, poisson_ratio):
    """The :class:`SlipInfluence` of a grid, kept for the next solution on the same grid."""
    return SlipInfluence(shape, steps, shear_modulus, poisson_ratio)
