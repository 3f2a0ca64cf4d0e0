"""Deflection of two elastic half-spaces under pressures that are constant on each cell of a grid.

Love (1929); Johnson (1985), section 3.3; the convolution by fast Fourier transform. Equations
(H2), (H3) of docs/method.md.
"""

import math

import numpy as np
from scipy import fft


def corner_potential(x, s):
    """Integral of 1/r over the rectangle from (0, 0) to (x, s) [m]; odd in both, arrays broadcast.

    ``x arsinh(s / x) + s arsinh(x / s)``: Love (1929), Johnson (1985) eq. (3.25) with its
    logarithms gathered. (H3)
    """
    return x * np.arcsinh(s / np.abs(x)) + s * np.arcsinh(x / np.abs(s))


def influence(rows, columns, dx, ds, *, contact_modulus):
    """Deflection [m] at 0 ... ``rows``, 0 ... ``columns`` cells' distance from a cell
    dx x ds [m] under 1 Pa: K.

    The four corners of the cell, seen from the place: Love (1929), Johnson (1985) eq. (3.25).  (H3)
    """
    x = (np.arange(rows + 2) - 0.5) * dx
    s = (np.arange(columns + 2) - 0.5) * ds
    corners = corner_potential(x[:, None], s[None, :])
    return np.diff(np.diff(corners, axis=0), axis=1) / (math.pi * contact_modulus)


class Deflection:
    """Pressure (n, m) [Pa] to deflection of both bodies together (n, m) [m]: the convolution (H2).

    The grid is padded to twice its size, so that the periodic convolution of the Fourier
    transform is the plain one.
    """

    def __init__(self, shape, dx, ds, contact_modulus):
        self.shape = shape
        self.padded = tuple(fft.next_fast_len(2 * count - 1, real=True) for count in shape)
        rows, columns = (np.minimum(np.arange(size), size - np.arange(size)) for size in self.padded)
        kernel = influence(rows.max(), columns.max(), dx, ds, contact_modulus=contact_modulus)
        self.transfer = fft.rfft2(kernel[rows[:, None], columns])

    def __call__(self, pressure):
        rows, columns = self.padded
        # one axis after the other: the padding rows are not transformed along s, nor back
        spectrum = fft.fft(fft.rfft(pressure, columns, axis=1), rows, axis=0, overwrite_x=True)
        spectrum *= self.transfer
        inside = fft.ifft(spectrum, axis=0, overwrite_x=True)[: self.shape[0]]
        return fft.irfft(inside, columns, axis=1)[:, : self.shape[1]]


class BlockDeflection:
    """As :class:`Deflection` for several grids (b, n, m) of equal cells, which press on each other.

    ``corners`` (b, 2) are the grids' first cells, counted in cells.
    """

    def __init__(self, shape, corners, dx, ds, contact_modulus):
        self.count, *self.shape = shape
        self.padded = tuple(fft.next_fast_len(2 * count - 1, real=True) for count in self.shape)
        places = [np.arange(size) for size in self.padded]
        places = [np.where(k < count, k, k - size) for k, count, size in zip(places, self.shape, self.padded)]
        self.transfer = np.empty((self.count, self.count, self.padded[0], self.padded[1] // 2 + 1),
                                 dtype=complex)
        for one in range(self.count):
            for other in range(self.count):
                away = [k + int(corners[one][axis] - corners[other][axis]) for axis, k in enumerate(places)]
                edges = [np.stack([k - 0.5, k + 0.5]) * step for k, step in zip(away, (dx, ds))]
                low, high = (corner_potential(edge[:, None], edges[1][:, None, :]) for edge in edges[0])
                kernel = (high[1] - high[0] - low[1] + low[0]) / (math.pi * contact_modulus)
                self.transfer[one, other] = fft.rfft2(kernel)

    def __call__(self, pressure):
        spectrum = np.einsum("abij,bij->aij", self.transfer, fft.rfft2(pressure, self.padded))
        return fft.irfft2(spectrum, self.padded)[:, : self.shape[0], : self.shape[1]]
