"""The kernel's table of rolling, for all Poisson's ratios; the kernel's preparation makes the record
RollingTable of it for one of them (prepare/tables.py)."""

from functools import lru_cache
from pathlib import Path

import numpy as np

from .. import layout
from .kalker_table import POISSON_NODES, hermite_cubic, inverse_coefficients, kalker_coefficients
from .reach_table import reach_parts, stored

#: What exact forces differ from those of the strips by (tools/make_rolling_correction.py).
CORRECTION = Path(__file__).parents[1] / "data" / "rolling_correction.npz"
#: Poisson's ratios of its tables.
CORRECTION_NODES = (0.25, 0.28, 0.30)
#: Unit of their numbers, of mu N and of mu N sqrt(ab).
CORRECTION_UNIT = 1e-5
#: Step of numerical slopes, of a cell.
STEP = 1e-4


def shape_nodes():
    """ln(a/b) of the nodes (n,)."""
    return layout.SHAPE_START + np.arange(layout.SHAPE_CELLS + 1) / layout.SHAPE_PER_UNIT


def with_slope(function, nodes, per_unit):
    """Value and slope per cell (..., 2, n) at the nodes (n,) of a function that gives (..., n)."""
    step = STEP / per_unit
    slope = (function(nodes + step) - function(nodes - step)) / (2.0 * STEP)
    return np.stack([function(nodes), slope], axis=-2)


def shapes(column, factors):
    """Rows (n,) of the table of shapes for POISSON_NODES[column] and factors f (3, value or slope, node)."""
    nodes = shape_nodes()
    inverses = with_slope(lambda shape: inverse_coefficients(shape, column), nodes, layout.SHAPE_PER_UNIT)
    cubics = [hermite_cubic(*pair) for pair in (*inverses, *factors)]
    return np.stack(cubics, axis=1).ravel()


def points():
    """Cosines and sines (n,) of the points of a strip."""
    angles = np.arange(1, layout.POINT_LIMIT + 1) * np.pi / (layout.POINT_LIMIT + 1)
    return np.concatenate([np.cos(angles), np.sin(angles)])


@lru_cache(maxsize=1)
def corrections():
    """Radii, scales and corrections as the kernel reads them (n,): the radii, then both others for
    CORRECTION_NODES."""
    with np.load(CORRECTION) as found:
        radius, coefficients = found["rho"], found["creep_coefficients"]
        values = found["correction"] * CORRECTION_UNIT
        ratio = found["ratio"]
    # by the coefficients that the saturation of the nodes is meant with
    scales = [own / kalker_coefficients(ratio, nu).T for own, nu in zip(coefficients, CORRECTION_NODES)]
    # nothing to correct for no creepage and for an infinite one
    padded = np.pad(values, [(0, 0)] * 4 + [(1, 1), (0, 0)])
    return np.concatenate([[0.0], radius / (1.0 + radius), [1.0], np.ravel(scales), padded.ravel()])


def assemble(factors, correction):
    """The table as the kernel's preparation reads it (n,): the points of a strip, shapes for POISSON_NODES,
    both parts of the reaches, and what :func:`corrections` gives."""
    table = np.concatenate([points(), *(shapes(column, rows) for column, rows in enumerate(factors)),
                            reach_parts().ravel(), correction])
    wanted = (2 * layout.POINT_LIMIT + 3 * layout.SHAPE_ROW * layout.SHAPE_CELLS
              + 2 * layout.REACH_ROW * (layout.REACH_CELLS + 1) + layout.CORRECTION_RADII
              + 3 * (layout.CORRECTION_SCALES + layout.CORRECTION_SIZE))
    if len(table) != wanted:
        raise TypeError(f"the table of rolling has {len(table)} numbers, its record asks for {wanted}")
    return table


def uncorrected():
    """Corrections of nothing (n,), for tools that make the true ones."""
    radii = np.linspace(0.0, 1.0, layout.CORRECTION_RADII)
    return np.concatenate([radii, np.ones(3 * layout.CORRECTION_SCALES),
                           np.zeros(3 * layout.CORRECTION_SIZE)])


@lru_cache(maxsize=1)
def rolling_table():
    """The table as the kernel's preparation reads it (n,)."""
    return assemble(stored()["factors"], corrections())
