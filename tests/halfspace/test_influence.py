"""Influence numbers against quadrature of Cerruti's displacements, and their convolution against sums."""

import numpy as np
import pytest

from wrcontact.halfspace.rolling.contact import SlipInfluence, corner_displacements

SHEAR_MODULUS, POISSON_RATIO = 80e9, 0.28


def cerruti(x, y):
    """Displacements pi G u under a unit force: xx, xy, yy; Johnson (1985), eqs. (3.75)."""
    r = np.hypot(x, y)
    nu = POISSON_RATIO
    return np.array([(1 - nu) / r + nu * x * x / r**3, nu * x * y / r**3, (1 - nu) / r + nu * y * y / r**3])


def by_quadrature(x, y, dx, dy, points=60):
    """The same, of a cell around the origin, at (x, y): Gauss points in the four rectangles that the place
    cuts from it, in coordinates whose square removes the singularity."""
    nodes, weights = np.polynomial.legendre.leggauss(points)
    t, w = 0.5 * (nodes + 1.0), 0.5 * weights
    total = np.zeros(3)
    cuts_x = sorted({-0.5 * dx, min(max(x, -0.5 * dx), 0.5 * dx), 0.5 * dx})
    cuts_y = sorted({-0.5 * dy, min(max(y, -0.5 * dy), 0.5 * dy), 0.5 * dy})
    for x_low, x_high in zip(cuts_x, cuts_x[1:]):
        for y_low, y_high in zip(cuts_y, cuts_y[1:]):
            # two triangles that meet in the corner next to the place (Duffy 1982)
            near = [
                low if abs(low - at) <= abs(high - at) else high
                for low, high, at in ((x_low, x_high, x), (y_low, y_high, y))
            ]
            far = [x_low + x_high - near[0], y_low + y_high - near[1]]
            size = (far[0] - near[0]) * (far[1] - near[1])
            u, v = t[:, None], t[None, :]
            for a, b in ((u + 0 * v, u * v), (u * v, u + 0 * v)):
                px, py = near[0] + a * (far[0] - near[0]), near[1] + b * (far[1] - near[1])
                total += np.einsum("kij,i,j->k", cerruti(x - px, y - py), w * t, w) * abs(size)
    return total


@pytest.mark.parametrize(
    "place", [(0.0, 0.0), (1.0, 0.0), (0.0, 2.0), (-1.0, 1.0), (3.0, -2.0), (20.0, 7.0)], ids=str
)
@pytest.mark.parametrize("dx, dy", [(1.0, 1.0), (1.0, 0.3), (0.2, 1.0)])
def test_displacements_are_cerrutis(place, dx, dy):
    """1e-9 of the cell's own displacement: rounding of differences over four corners, and the quadrature."""
    x, y = place[0] * dx, place[1] * dy
    corners = corner_displacements(
        *np.meshgrid([x - 0.5 * dx, x + 0.5 * dx], [y - 0.5 * dy, y + 0.5 * dy]), POISSON_RATIO
    )
    found = corners[:, 1, 1] - corners[:, 0, 1] - corners[:, 1, 0] + corners[:, 0, 0]
    own = by_quadrature(0.0, 0.0, dx, dy)
    assert np.abs(found - by_quadrature(x, y, dx, dy)).max() < 1e-9 * own.max(), place


def test_slip_is_the_sum_over_all_cells():
    """Two rows of three cells with random tractions: minus the difference of displacements one cell upstream,
    summed cell by cell."""
    shape, (dy, dx) = (2, 3), (0.7, 0.4)
    tractions = np.random.default_rng(2).normal(size=(2, *shape))
    slip = SlipInfluence(shape, (dy, dx), SHEAR_MODULUS, POISSON_RATIO)(tractions)
    for i, j in np.ndindex(shape):
        wanted = np.zeros(2)
        for k, m in np.ndindex(shape):
            here, ahead = (by_quadrature((j - m + step) * dx, (i - k) * dy, dx, dy) for step in (0, 1))
            xx, xy, yy = here - ahead
            wanted += np.array([[xx, xy], [xy, yy]]) @ tractions[:, k, m]
        wanted /= np.pi * SHEAR_MODULUS * dx
        assert slip[:, i, j] == pytest.approx(wanted, rel=1e-8, abs=1e-20), (i, j)
