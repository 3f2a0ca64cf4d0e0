"""Deflection of two elastic bodies under pressures that are constant on each cell of a grid.

Love (1929); Johnson (1985), section 3.3; the convolution by fast Fourier transform. Equations
(H2), (H3), (H10) of docs/theory.
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


def corner_slope(x, s):
    """Integral of s / r^2 over the rectangle from (0, 0) to (x, s) [m], but for terms of one coordinate
    alone, which vanish between the corners of a rectangle; arrays broadcast.  (H13)"""
    return x * np.log(np.hypot(x, s)) + s * np.arctan(x / s)


def coupling_of(wheel, rail):
    """Coupling of normal pressure and tangential displacement between the bodies, -1/2 ... 1/2; zero for
    equal materials.

    Dundurs' second constant, ``[(1 - 2 nu_w)/G_w - (1 - 2 nu_r)/G_r] / 2[(1 - nu_w)/G_w + (1 - nu_r)/G_r]``
    (Johnson 1985, eq. 5.3a); ``wheel`` and ``rail`` are (Young's modulus [Pa], Poisson's ratio).  (H12)
    """
    (shift_w, press_w), (shift_r, press_r) = (
        ((1.0 - 2.0 * ratio) * 2.0 * (1.0 + ratio) / modulus, (1.0 - ratio) * 2.0 * (1.0 + ratio) / modulus)
        for modulus, ratio in (wheel, rail)
    )
    return 0.5 * (shift_w - shift_r) / (press_w + press_r)


def influence(away_x, away_s, *, contact_modulus, coupling=0.0):
    """Deflection [m] at cells away (n,), (m,) [m] from a cell under 1 Pa, (n, m); spacings are the cell's
    sides.

    Its real part is K, that of parallel normals, by the four corners of the cell seen from the place: Love
    (1929), Johnson (1985) eq. (3.25).  (H3)  With a ``coupling`` the imaginary part counts where normals
    differ.  (H11)
    """
    edges = [
        np.append(away - 0.5 * step, away[-1] + 0.5 * step)
        for away, step in ((away, away[1] - away[0]) for away in (away_x, away_s))
    ]
    x, s = edges[0][:, None], edges[1]
    corners = corner_potential(x, s)
    if coupling:
        corners = corners + 1j * coupling * corner_slope(x, s)
    return np.diff(np.diff(corners, axis=0), axis=1) / (math.pi * contact_modulus)


class Deflection:
    """Pressure (n, m) [Pa] to what both bodies together give way along the normals (n, m) [m].

        u_i = Re sum_j exp(i (a_j - a_i)) (K + i T)_ij p_j                                          (H11)

    with the angles a of the normals: for equal materials K times the cosine of the angle between two places'
    normals (H10), for parallel ones Love's K (H2).  Grids are padded to twice their size, so that the
    periodic convolution of the Fourier transform is the plain one.

    Parameters
    ----------
    shape : (n, m), or (b, n, m) of several grids that press on each other.
    dx, ds : sides of the cells [m].
    contact_modulus : E* [Pa].
    corners : first cells of the grids (b, 2), counted in cells.
    angle : of the normals (m,) or (b, m) [rad]; None where all are parallel.
    coupling : of :func:`coupling_of`.
    """

    def __init__(self, shape, dx, ds, contact_modulus, *, corners=None, angle=None, coupling=0.0):
        self.shape = shape[-2:]
        corners = np.zeros((1, 2), dtype=int) if corners is None else np.asarray(corners)
        self.padded = tuple(fft.next_fast_len(2 * count - 1, real=True) for count in self.shape)
        turns = angle is not None and bool(np.ptp(angle) > 0.0)
        self.turn = np.exp(1j * np.asarray(angle))[..., None, :] if turns else None
        self._along, self._back = (fft.fft, fft.ifft) if turns else (fft.rfft, fft.irfft)
        waves = np.hypot(
            *np.meshgrid(
                *(2.0 * math.pi * fft.fftfreq(count, step) for count, step in zip(self.shape, (dx, ds))),
                indexing="ij",
            )
        )
        longest = math.pi / max(count * step for count, step in zip(self.shape, (dx, ds)))
        self._stiffness = 0.5 * contact_modulus * np.maximum(waves, longest)[:, : self.shape[1] // 2 + 1]
        material = {"contact_modulus": contact_modulus, "coupling": coupling if turns else 0.0}
        self.transfer = np.stack(
            [
                np.stack([self._transfer(one - other, dx, ds, material) for other in corners])
                for one in corners
            ]
        )

    def _transfer(self, away, dx, ds, material):
        """Transform of the influence on a grid whose first cell is ``away`` (2,) cells from the other's."""
        low = [count - size for count, size in zip(self.shape, self.padded)]
        places = [
            step * (np.arange(start, count) + shift)
            for start, count, shift, step in zip(low, self.shape, away, (dx, ds))
        ]
        kernel = np.roll(influence(*places, **material), low, (0, 1))
        return fft.fft(self._along(kernel, axis=1), axis=0)

    def __call__(self, pressure):
        rows, columns = self.padded
        inside = pressure.reshape(-1, *self.shape)
        if self.turn is not None:
            inside = inside * self.turn
        # one axis after the other: the padding rows are not transformed along s, nor back
        spectrum = fft.fft(self._along(inside, columns, axis=2), rows, axis=1, overwrite_x=True)
        if len(spectrum) > 1:
            spectrum = np.einsum("abij,bij->aij", self.transfer, spectrum)
        else:
            spectrum *= self.transfer[0]
        inside = fft.ifft(spectrum, axis=1, overwrite_x=True)[:, : self.shape[0]]
        bent = self._back(inside, columns, axis=2)[..., : self.shape[1]]
        if self.turn is not None:
            bent = (bent * self.turn.conj()).real
        return bent.reshape(pressure.shape)

    def stiff(self, bent):
        """Pressures (n, m) [Pa] that cause a deflection (n, m) [m], roughly: each wave of the grid by itself,
        |k| E* / 2, with parallel normals, grids for themselves and repeated without end.  Symmetric and
        positive. (H15)"""
        spectrum = fft.rfft2(bent.reshape(-1, *self.shape)) * self._stiffness
        return fft.irfft2(spectrum, self.shape).reshape(bent.shape)
