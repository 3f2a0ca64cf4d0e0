"""Generalised minimal residuals (Saad and Schultz 1986), preconditioned from the right."""

import numpy as np
from scipy.linalg import solve_triangular

DIMENSION_LIMIT = 120


def gmres(multiply, right, precondition, precision):
    """x (n,) with |A x - b| <= precision |b|, or the best within DIMENSION_LIMIT vectors.

    Parameters
    ----------
    multiply : A, called with a vector (n,).
    right : b (n,).
    precondition : roughly the inverse of A, called with a vector (n,).
    precision : relative residual at which to stop.
    """
    norm = np.linalg.norm(right)
    basis = np.empty((DIMENSION_LIMIT + 1, len(right)))
    basis[0] = right / norm
    factor = np.zeros((DIMENSION_LIMIT + 1, DIMENSION_LIMIT))
    turns = np.zeros((DIMENSION_LIMIT, 2))
    rest = np.zeros(DIMENSION_LIMIT + 1)
    rest[0] = norm
    for k in range(DIMENSION_LIMIT):
        vector = multiply(precondition(basis[k]))
        known = basis[:k + 1]
        column = known @ vector
        vector -= column @ known
        again = known @ vector          # a second time, against rounding
        vector -= again @ known
        length = np.linalg.norm(vector)
        column = np.append(column + again, length)
        for j, (c, s) in enumerate(turns[:k]):
            column[j], column[j + 1] = c * column[j] + s * column[j + 1], c * column[j + 1] - s * column[j]
        radius = np.hypot(column[k], column[k + 1])
        c, s = turns[k] = column[k] / radius, column[k + 1] / radius
        column[k], column[k + 1] = radius, 0.0
        factor[:k + 2, k] = column
        rest[k], rest[k + 1] = c * rest[k], -s * rest[k]
        if abs(rest[k + 1]) <= precision * norm or length == 0.0:
            break
        basis[k + 1] = vector / length
    weights = solve_triangular(factor[:k + 1, :k + 1], rest[:k + 1])
    return precondition(weights @ basis[:k + 1])
