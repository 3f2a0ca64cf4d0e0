"""Kalker's creepage coefficients C11, C22 and C23 of elliptic patches.

Kalker's table E3 (Three-dimensional elastic bodies in rolling contact, 1990) as CONTACT prints it, between
axis ratios of 0.1 and 10; beyond, his asymptotes, scaled so that they join the table and are approached as
the ratio grows.  Between the nodes 1/C is taken, because that is smooth in the axis ratio and, as in CONTACT,
a parabola in Poisson's ratio.
"""

import numpy as np

#: Poisson's ratios of the table.
POISSON_NODES = (0.0, 0.25, 0.5)
#: C11, C22, C23 by (short over long half as the patch is short or long, g = 0.1 ... 1, coefficient, nu).
COEFFICIENTS = np.array(
    [
        [
            [[2.51, 3.31, 4.85], [2.51, 2.52, 2.53], [0.334, 0.473, 0.731]],
            [[2.59, 3.37, 4.81], [2.59, 2.63, 2.66], [0.483, 0.603, 0.809]],
            [[2.68, 3.44, 4.80], [2.68, 2.75, 2.81], [0.607, 0.715, 0.889]],
            [[2.78, 3.53, 4.82], [2.78, 2.88, 2.98], [0.720, 0.823, 0.977]],
            [[2.88, 3.62, 4.83], [2.88, 3.01, 3.14], [0.827, 0.929, 1.07]],
            [[2.98, 3.72, 4.91], [2.98, 3.14, 3.31], [0.930, 1.03, 1.18]],
            [[3.09, 3.81, 4.97], [3.09, 3.28, 3.48], [1.03, 1.14, 1.29]],
            [[3.19, 3.91, 5.05], [3.19, 3.41, 3.65], [1.13, 1.25, 1.40]],
            [[3.29, 4.01, 5.12], [3.29, 3.54, 3.82], [1.23, 1.36, 1.51]],
            [[3.40, 4.12, 5.20], [3.40, 3.67, 3.98], [1.33, 1.47, 1.63]],
        ],
        [
            [[10.7, 11.7, 12.9], [10.7, 12.8, 16.0], [12.2, 14.6, 18.0]],
            [[6.96, 7.78, 8.82], [6.96, 8.14, 9.79], [5.72, 6.63, 7.89]],
            [[5.57, 6.34, 7.34], [5.57, 6.40, 7.51], [3.79, 4.32, 5.01]],
            [[4.84, 5.57, 6.57], [4.84, 5.48, 6.31], [2.88, 3.24, 3.70]],
            [[4.37, 5.10, 6.11], [4.37, 4.90, 5.56], [2.35, 2.62, 2.96]],
            [[4.06, 4.78, 5.80], [4.06, 4.50, 5.04], [2.01, 2.23, 2.50]],
            [[3.82, 4.54, 5.58], [3.82, 4.21, 4.67], [1.76, 1.95, 2.18]],
            [[3.65, 4.36, 5.42], [3.65, 3.99, 4.39], [1.58, 1.75, 1.94]],
            [[3.51, 4.22, 5.30], [3.51, 3.81, 4.16], [1.44, 1.59, 1.77]],
            [[3.40, 4.12, 5.20], [3.40, 3.67, 3.98], [1.33, 1.47, 1.63]],
        ],
    ]
)
#: ln(a/b) of the rows, from the shortest patch to the longest, and 1/C there (row, coefficient, nu).
NODES = np.log(np.concatenate([np.arange(1, 11) / 10, 10.0 / np.arange(9, 0, -1)]))
INVERSES = 1.0 / np.concatenate([COEFFICIENTS[0], COEFFICIENTS[1, -2::-1]])
#: Step of numerical slopes, in ln(a/b).
STEP = 1e-4


def asymptotes(shape, nu):
    """C11, C22, C23 (3, n) of very short or very long patches with ln(a/b) = ``shape`` (n,)."""
    shape = np.asarray(shape, dtype=float)
    g = np.exp(-np.abs(shape))
    long = np.log(16.0 / g**2)
    first, second = long - 2.0 * nu, (1.0 - nu) * long + 2.0 * nu
    rest = 3.0 - np.log(4.0)
    short_patch = [
        np.full_like(g, np.pi**2 / (4.0 * (1.0 - nu))),
        np.full_like(g, np.pi**2 / 4.0),
        np.pi * np.sqrt(g) / (3.0 * (1.0 - nu)) * (1.0 + nu * (np.log(16.0 / g) - 5.0)),
    ]
    with np.errstate(divide="ignore", invalid="ignore"):
        long_patch = [
            2.0 * np.pi / (first * g) * (1.0 + rest / first),
            2.0 * np.pi / (g * second) * (1.0 + (1.0 - nu) * rest / second),
            2.0 * np.pi / (3.0 * g**1.5 * ((1.0 - nu) * long - 2.0 + 4.0 * nu)),
        ]
    return np.where(shape < 0.0, short_patch, long_patch)


def beyond(shape, nu, column):
    """1/C (3, n) where the table has ended: the asymptote, times what joins it to the table's last row at
    g = 0.1 and fades with g."""
    end = NODES[0] if shape[0] < 0.0 else NODES[-1]
    row = INVERSES[0 if shape[0] < 0.0 else -1, :, column]
    factor = row * asymptotes([end], nu)[:, 0]
    fade = np.exp(-(np.abs(shape) - abs(end)))
    return (1.0 + (factor[:, None] - 1.0) * fade) / asymptotes(shape, nu)


def inverse_coefficients(shape, column):
    """1/C11, 1/C22, 1/C23 (3, n) at ln(a/b) = ``shape`` (n,) for POISSON_NODES[column]."""
    shape = np.asarray(shape, dtype=float)
    nu, rows = POISSON_NODES[column], INVERSES[:, :, column]
    slopes = np.gradient(rows, NODES, axis=0)
    for end in (0, -1):
        outward = NODES[end] * (1.0 + STEP)
        slopes[end] = (beyond(np.array([outward]), nu, column)[:, 0] - rows[end]) / (outward - NODES[end])
    cell = np.clip(np.searchsorted(NODES, shape) - 1, 0, len(NODES) - 2)
    width = (NODES[cell + 1] - NODES[cell])[:, None]
    values = hermite(
        rows[cell],
        rows[cell + 1],
        slopes[cell] * width,
        slopes[cell + 1] * width,
        (shape - NODES[cell])[:, None] / width,
    ).T
    for outside in (shape < NODES[0], shape > NODES[-1]):
        if outside.any():
            values[:, outside] = beyond(shape[outside], nu, column)
    return values


def hermite(low, high, rise, fall, x):
    """The cubic at x, 0 ... 1, with these values and slopes at its ends."""
    return low + x * (
        rise + x * (3.0 * (high - low) - 2.0 * rise - fall + x * (rise + fall - 2.0 * (high - low)))
    )


def hermite_cubic(value, slope):
    """Rows (cell, power) of the cubics with these values and slopes, per cell, at the ends of the cells
    (n,)."""
    low, high, rise, fall = value[:-1], value[1:], slope[:-1], slope[1:]
    return np.stack(
        [low, rise, 3.0 * (high - low) - 2.0 * rise - fall, rise + fall - 2.0 * (high - low)], axis=-1
    )


def parabola_weights(nodes, nu):
    """Weights (3,) of the values at three nodes in the parabola through them at ``nu``."""
    one, two, three = nodes
    return np.array(
        [
            (nu - two) * (nu - three) / ((one - two) * (one - three)),
            (nu - one) * (nu - three) / ((two - one) * (two - three)),
            (nu - one) * (nu - two) / ((three - one) * (three - two)),
        ]
    )


def kalker_coefficients(axis_ratio, nu):
    """C11, C22, C23 (3, n) of ellipses with a/b = ``axis_ratio`` (n,), length over width."""
    shape = np.log(np.atleast_1d(np.asarray(axis_ratio, dtype=float)))
    columns = [inverse_coefficients(shape, column) for column in range(3)]
    return 1.0 / sum(w * column for w, column in zip(parabola_weights(POISSON_NODES, nu), columns))
