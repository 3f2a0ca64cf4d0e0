"""Kalker's linear theory of rolling: creepage coefficients of elliptic patches."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .kalker_table import NODES, POISSON_NODES, hermite, parabola_weights
from .kalker_table import kalker_coefficients as first_three

#: Range of the table.
LEAST, MOST = 0.1, 10.0
#: C33 of Kalker's table E3 by nu: a/b = 0.1 ... 1, then b/a = 0.9 ... 0.1. The others are as CONTACT prints them; of
#: C33 no print could be compared, and its witness is the complete theory (tests/creep/test_linear_theory.py), to 5 %.
TWIST = {
    0.0: (6.42, 3.46, 2.49, 2.02, 1.74, 1.56, 1.43, 1.34, 1.27, 1.21)
    + (1.16, 1.10, 1.05, 1.01, 0.958, 0.912, 0.868, 0.828, 0.795),
    0.25: (8.28, 4.27, 2.96, 2.32, 1.93, 1.68, 1.50, 1.37, 1.27, 1.19)
    + (1.11, 1.04, 0.965, 0.892, 0.819, 0.747, 0.674, 0.601, 0.526),
    0.5: (11.7, 5.66, 3.72, 2.77, 2.22, 1.86, 1.60, 1.42, 1.27, 1.16)
    + (1.06, 0.954, 0.852, 0.751, 0.650, 0.549, 0.446, 0.341, 0.228),
}


def kalker_coefficients(
    a_over_b: ArrayLike, poisson_ratio: float
) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    """Kalker's creepage coefficients (C11, C22, C23, C33) [1] of elliptic patches, each of the shape of ``a_over_b``.

    With c = sqrt(a b) and the shear modulus G, linear theory has the forces of an ellipse with the semi-axes a along
    and b across the rolling direction, on the wheel, at small creepages xi and eta and small spin phi [1/m]:

        Fx = -G c^2 C11 xi,  Fy = -G c^2 (C22 eta + c C23 phi),  Mz = G c^3 (C23 eta - c C33 phi)

    C33 is confirmed to 5 % by the complete theory; the others are compared with a print.
    Kalker, Three-dimensional elastic bodies in rolling contact (1990), table E3; between its rows 1/C is a cubic of
    ln(a/b) and, as in CONTACT, a parabola in Poisson's ratio.

    Parameters
    ----------
    a_over_b : length over width of the patch, 0.1 ... 10.
    poisson_ratio : 0 ... 0.5, of wheel and rail.

    Raises
    ------
    ValueError
        if one is outside its range.

    >>> [round(float(c), 2) for c in kalker_coefficients(1.0, 0.25)]
    [4.12, 3.67, 1.47, 1.19]
    """
    ratio = np.asarray(a_over_b, dtype=float)
    if not np.all((ratio >= LEAST) & (ratio <= MOST)):
        raise ValueError(f"a_over_b is {a_over_b!r}; permitted are {LEAST:g} ... {MOST:g}")
    if not 0.0 <= poisson_ratio <= 0.5:
        raise ValueError(f"poisson_ratio is {poisson_ratio!r}; permitted are 0 ... 0.5")
    weights = parabola_weights(POISSON_NODES, poisson_ratio)
    shape = np.log(ratio.ravel())
    twist = 1.0 / sum(weight * _inverse_twist(shape, nu) for weight, nu in zip(weights, POISSON_NODES))
    first, second, third = first_three(ratio.ravel(), poisson_ratio)
    return tuple(found.reshape(ratio.shape) for found in (first, second, third, twist))


def _inverse_twist(shape, nu):
    """1/C33 (n,) at ln(a/b) = ``shape`` (n,) for a Poisson's ratio of the table."""
    rows = 1.0 / np.array(TWIST[nu])
    slopes = np.gradient(rows, NODES)
    cell = np.clip(np.searchsorted(NODES, shape) - 1, 0, len(NODES) - 2)
    width = NODES[cell + 1] - NODES[cell]
    ends = slopes[cell] * width, slopes[cell + 1] * width
    return hermite(rows[cell], rows[cell + 1], *ends, (shape - NODES[cell]) / width)
