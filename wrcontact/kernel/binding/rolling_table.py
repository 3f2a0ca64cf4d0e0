"""The kernel's table of rolling, for all Poisson's ratios; the kernel's preparation makes the record
RollingTable of it for one of them (prepare/fixed.py)."""

from functools import lru_cache

import numpy as np

from .. import layout
from .kalker_table import POISSON_NODES, inverse_coefficients

#: Step of numerical slopes, of a cell.
STEP = 1e-4


def cubics(function):
    """Rows (cell, column, power) of the cubics with value and slope of ``function`` of ln(a/b), which gives
    (columns, n), at the ends of the cells."""
    nodes = layout.SHAPE_START + np.arange(layout.SHAPE_CELLS + 1) / layout.SHAPE_PER_UNIT
    step = STEP / layout.SHAPE_PER_UNIT
    value = function(nodes).T
    slope = (function(nodes + step) - function(nodes - step)).T / (2.0 * STEP)
    low, high, rise, fall = value[:-1], value[1:], slope[:-1], slope[1:]
    return np.stack([low, rise, 3.0 * (high - low) - 2.0 * rise - fall, rise + fall - 2.0 * (high - low)],
                    axis=-1)


@lru_cache(maxsize=1)
def rolling_table():
    """The table as the kernel's preparation reads it (n,): cosines and sines of the points of a strip, then
    the shapes for POISSON_NODES."""
    angles = np.arange(1, layout.POINT_LIMIT + 1) * np.pi / (layout.POINT_LIMIT + 1)
    shapes = [cubics(lambda shape: inverse_coefficients(shape, column)).ravel()
              for column in range(len(POISSON_NODES))]
    return np.concatenate([np.cos(angles), np.sin(angles), *shapes])
