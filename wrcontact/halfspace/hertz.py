"""Hertz's coefficients of elliptic patches from elliptic integrals; K and E from the arithmetic-geometric mean, which
gives K - E and E - q^2 K without cancellation.  Witness in tests: scipy.special.

The kernel reads a table of them (kernel/normal/coefficients.py).
"""

import numpy as np


def elliptic_parts(q):
    """K, E, (K - E) and (E - q^2 K) for the modulus sqrt(1 - q^2), 0 < q <= 1 (n,);
    Abramowitz & Stegun 17.6."""
    q = np.asarray(q, dtype=float)
    a, b = np.ones_like(q), q.copy()
    first, rest, weight = 0.5 * (1 - q) * (1 + q), np.zeros_like(q), 0.5
    for _ in range(9):
        a, b, c = 0.5 * (a + b), np.sqrt(a * b), 0.5 * (a - b)
        weight *= 2
        rest += weight * c**2
    K = np.pi / (2 * a)
    return K, K * (1 - first - rest), K * (first + rest), K * (first - rest)


def axis_ratio(curvature_ratio):
    """Short over long semi-axis for small over large relative curvature, (K - E) / (E
    / q^2 - K) = ratio (n,)."""
    target = np.log(np.asarray(curvature_ratio, dtype=float))
    low, high = np.full_like(target, -20.0), np.zeros_like(target)
    for _ in range(80):
        middle = 0.5 * (low + high)
        _, _, upper, lower = elliptic_parts(np.exp(middle))
        with np.errstate(divide="ignore", invalid="ignore"):
            ratio = np.where(lower > 0, np.log(upper / lower) + 2 * middle, 0.0)
        low, high = np.where(ratio < target, middle, low), np.where(ratio < target, high, middle)
    return np.exp(0.5 * (low + high))


def coefficients(log_ratio):
    """(1 + alpha, n r) at ln(B/A) (n,)."""
    log_ratio = np.asarray(log_ratio, dtype=float)
    q = axis_ratio(np.exp(-np.abs(log_ratio)))
    K, E, _, _ = elliptic_parts(q)
    a_share = 1 / (1 + np.exp(log_ratio))
    across = log_ratio < 0  # A > B: the patch is longer across
    return np.where(across, K / E, K * q**2 / E) / a_share, 2 / np.pi * np.where(across, K, K * q)
