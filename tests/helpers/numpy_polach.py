"""Polach's formula of 1999 in numpy, from the paper, with Kalker's printed table of coefficients.

O. Polach, A fast wheel-rail forces calculation computer code, Vehicle System Dynamics Supplement 33 (1999)
728-739; data/creep/kalker_cij.json is Kalker's table E3.
"""

import json

import numpy as np

from tests.helpers.paths import DATA

#: C11, C22, C23 by (a < b or a > b, ratio 0.1 ... 1, coefficient, Poisson's ratio 0, 0.25, 0.5).
KALKER = np.array(json.loads((DATA / "creep" / "kalker_cij.json").read_text())["table"])


def kalker(a, b, nu):
    """C11, C22, C23 of an ellipse a along, b across: 1/C linear in ln(a/b) and a parabola in nu."""
    nodes = np.array([0.0, 0.25, 0.5])
    weights = [np.prod([(nu - other) / (node - other) for other in nodes if other != node]) for node in nodes]
    ratios = np.arange(1, 11) / 10
    rows = 1.0 / KALKER[0 if a < b else 1] @ weights
    at = np.log(min(a / b, b / a))
    return np.array([1.0 / np.interp(at, np.log(ratios), rows[:, k]) for k in range(3)])


def polach(*, a, b, load, friction, shear_modulus, nu, x, y, spin):
    """Force (2,) on the wheel [N] of an ellipse with the creepages x, y [1] and spin [1/m].

    The frame is x forward, y across, spin about x times y; creepages are those of the wheel.
    """
    c11, c22, c23 = kalker(a, b, nu)
    bound = friction * load
    lateral = y + spin * a if abs(y + spin * a) > abs(y) else y
    whole = np.hypot(x, lateral)
    slope = np.hypot(c11 * x, c22 * y) / np.hypot(x, y)
    epsilon = np.pi * a * b * shear_modulus * slope * whole / (4.0 * bound)
    push = 2.0 * bound / np.pi * (epsilon / (1.0 + epsilon**2) + np.arctan(epsilon))
    wide = 1.0 + 6.3 * (1.0 - np.exp(-a / b))
    of_spin = 8.0 / 3.0 * shear_modulus * b * np.sqrt(a * b) * c23 * whole / (bound * wide)
    delta = (of_spin**2 - 1.0) / (of_spin**2 + 1.0)
    k = of_spin * (delta**3 / 3 - delta**2 / 2 + 1 / 6) - (1.0 - delta**2) ** 1.5 / 3.0
    force = -push / whole * np.array([x, y]) + [0.0, 9.0 / 16.0 * a * bound * k * wide * spin / whole]
    return force * min(1.0, bound / np.hypot(*force))
