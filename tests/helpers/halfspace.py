"""Gaps with closed solutions for the half-space solver."""

import numpy as np

from data.hertz import MODULUS, hertz
from wrcontact.halfspace import one_grid

WIDE = (-0.2, 0.2, -0.2, 0.2)


def paraboloid(A, B):
    return lambda x, s: A * x[:, None] ** 2 + B * s**2


def on_hertz(A, B, force, cells, precision=1e-8, **load):
    """Solution on ``cells`` over Hertz's ellipse and two more on each side; and Hertz's numbers."""
    exact = hertz(A, B, force)
    x, s = (
        half * (1 + 4 / cells) * (2 * np.arange(cells + 4) + 1 - cells - 4) / (cells + 4)
        for half in exact[1:3]
    )
    gap = paraboloid(A, B)(x, s)
    return one_grid.solve(
        x, s, gap, contact_modulus=MODULUS, precision=precision, **(load or {"force": force})
    ), exact
