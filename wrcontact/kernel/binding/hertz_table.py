"""The kernel's table of Hertz coefficients from elliptic integrals; its record is HertzTable.

numpy alone, because an FMU makes this table on a machine that may have nothing else: K and E come from the
arithmetic-geometric mean, which gives K - E and E - q^2 K without cancellation.
Witness in tests: scipy.special.
"""

from functools import lru_cache

import numpy as np

from .. import layout

#: table range of |ln(B/A)|; curvatures that differ more than 6e7-fold count as differing by that
LIMIT = 18.0
CELLS_PER_UNIT = 8
DEGREE = 5


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


def basis(nodes):
    """Coefficients of 1, t, t^2, ... of the polynomials that are 1 at one of the nodes and 0 at the
    others (node, power)."""
    rows = []
    for node in nodes:
        row = np.eye(1, len(nodes))[0]
        for other in nodes[nodes != node]:
            row = (np.roll(row, 1) - other * row) / (node - other)
        rows.append(row)
    return np.array(rows)


@lru_cache(maxsize=1)
def hertz_table():
    """The table as the kernel reads it (n,): without products of matrices, whose last bits
    depend on the processor."""
    count = int(2 * LIMIT * CELLS_PER_UNIT)
    nodes = 0.5 - 0.5 * np.cos(np.pi * (np.arange(DEGREE + 1) + 0.5) / (DEGREE + 1))
    cells = -LIMIT + (np.arange(count)[:, None] + nodes) / CELLS_PER_UNIT
    columns = [sum(value[:, None] * row for value, row in zip(values.reshape(count, -1).T, basis(nodes)))
               for values in coefficients(cells.ravel())]
    head = np.array([count, -LIMIT, CELLS_PER_UNIT])
    assert 2 * (DEGREE + 1) == layout.HERTZ_ROW
    return np.concatenate([head, np.hstack(columns).ravel()])
