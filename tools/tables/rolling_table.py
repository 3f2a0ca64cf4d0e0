"""The kernel's table of rolling, for all Poisson's ratios; the kernel's preparation makes the record
RollingTable of it for one of them (wrcontact/kernel/prepare/tables.py).

Its reaches are the functions S of eq. (K2): how a strip of tractions along the rolling direction reaches
beside itself.  A strip carries X sqrt((1 - x)/(1 + x)), x from the trailing to the leading edge, or in spin
X sqrt(1 - x^2); the slip that this takes from the surface at the distance eta beside it is weighted with
sqrt((1 + x)/(1 - x)), in spin with x sqrt(1 - x^2).  Cerruti's solution for a half-space of Poisson's ratio
nu gives, over eta, with r^2 = (cos t - cos t')^2 + eta^2 and the integrals over 0 < t, t' < pi,

    P = 1/(2 pi^2) int int eta / r,    P_s = 2/pi^2 int int sin^2 t sin^2 t' eta / r
    R = 1/(2 pi^2) int int eta^3 / r^3,   R_s = 2/pi^2 int int sin^2 t sin^2 t' eta^3 / r^3      (K4)
    S_x = P + nu/(1 - nu) (P - R),   S_y = P + nu (R - P),   S_s = P_s + nu (R_s - P_s)          (K5)

all 1/2 far away.  tools/make_rolling_kernels.py makes P, R, P_s, R_s and their slopes over ln eta, and the
factors f of eq. (K3), which are stored in data/rolling_kernels.json.

The kernel's table is over z = eta^(1/4), which takes two square roots and no logarithm.  Nearer than the
first stored node the reaches go on with their slope there as eta (A - B ln eta), as eta/r integrates.
"""

import json
from functools import lru_cache
from pathlib import Path

import numpy as np

from wrcontact.creep.kalker_table import (
    hermite_cubic,
    inverse_coefficients,
    kalker_coefficients,
)
from wrcontact.kernel import layout
from wrcontact.kernel.binding.fixed_tables import CORRECTION, corrections

DATA = Path(__file__).with_name("data") / "rolling_kernels.json"
#: Poisson's ratios of its tables.
CORRECTION_NODES = (0.25, 0.28, 0.30)
#: Step of numerical slopes, of a cell.
STEP = 1e-4


@lru_cache(maxsize=1)
def stored():
    """What the tool has stored, as arrays: ``reaches`` (P R P_s R_s, value or slope, node) and ``factors``
    (Poisson's ratio, f1 f2 f3, value or slope, node)."""
    return {name: np.array(values) for name, values in json.loads(DATA.read_text()).items()}


#: ln eta of the first stored node, nodes per unit, and intervals between them.
START = -7.5
PER_UNIT = 8.0
INTERVALS = 93


def reach_nodes():
    """ln eta of the stored nodes (n,)."""
    return START + np.arange(INTERVALS + 1) / PER_UNIT


def resampled(value, slope):
    """Value and slope per cell (2, n) at the nodes of the kernel's table, of a function that is stored as its
    value and slope over ln eta (m,) at the stored nodes; behind the last of these it stays as it is."""
    z = np.arange(1, layout.REACH_CELLS + 1) / layout.REACH_PER_UNIT
    logarithm = 4.0 * np.log(z)
    place = np.clip((logarithm - START) * PER_UNIT, 0.0, INTERVALS)
    cell = np.minimum(place.astype(int), INTERVALS - 1)
    u, (c0, c1, c2, c3) = place - cell, hermite_cubic(value, slope / PER_UNIT)[cell].T
    values = c0 + u * (c1 + u * (c2 + u * c3))
    slopes = np.where(place < INTERVALS, PER_UNIT * (c1 + u * (2.0 * c2 + u * 3.0 * c3)), 0.0)
    near = place <= 0.0
    nearness = np.exp(logarithm[near] - START)
    values[near] = nearness * (value[0] - (value[0] - slope[0]) * (logarithm[near] - START))
    slopes[near] = values[near] - nearness * (value[0] - slope[0])
    slopes *= 4.0 / (z * layout.REACH_PER_UNIT)
    # in the first cell the cube of z, which falls to zero without a change of sign
    slopes[0] = 3.0 * values[0]
    return np.insert([values, slopes], 0, 0.0, axis=1)


def reach_parts():
    """The two parts (part, n) of the table of reaches: S = first + weight second, with the weights
    nu/(1 - nu) for S_x and nu for the others, as cubics over the cells; behind them what stays as it is."""
    near, far, near_spin, far_spin = stored()["reaches"]
    pairs = (near, near - far), (near, far - near), (near_spin, far_spin - near_spin)
    parts = []
    for part in range(2):
        nodes = [resampled(*pair[part]) for pair in pairs]
        rows = np.stack([hermite_cubic(*pair) for pair in nodes], axis=1)
        last = [[value[-1], 0.0, 0.0, 0.0] for value, _ in nodes]
        parts.append(np.concatenate([rows.ravel(), np.ravel(last)]))
    return np.array(parts)


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


def scales():
    """Radii, and the scales for CORRECTION_NODES, of the corrections (n,)."""
    with np.load(CORRECTION) as found:
        radius, coefficients, ratio = found["rho"], found["creep_coefficients"], found["ratio"]
    # by the coefficients that the saturation of the nodes is meant with
    parts = [own / kalker_coefficients(ratio, nu).T for own, nu in zip(coefficients, CORRECTION_NODES)]
    return np.concatenate([[0.0], radius / (1.0 + radius), [1.0], np.ravel(parts)])


def assemble(factors, correction):
    """The table as the kernel's preparation reads it (n,): the points of a strip, shapes for POISSON_NODES,
    both parts of the reaches, and radii, scales and corrections."""
    table = np.concatenate(
        [
            points(),
            *(shapes(column, rows) for column, rows in enumerate(factors)),
            reach_parts().ravel(),
            correction,
        ]
    )
    wanted = (
        2 * layout.POINT_LIMIT
        + 3 * layout.SHAPE_ROW * layout.SHAPE_CELLS
        + 2 * layout.REACH_ROW * (layout.REACH_CELLS + 1)
        + layout.CORRECTION_RADII
        + 3 * (layout.CORRECTION_SCALES + layout.CORRECTION_SIZE + layout.CORRECTION_SLOPES)
    )
    if len(table) != wanted:
        raise TypeError(f"the table of rolling has {len(table)} numbers, its record asks for {wanted}")
    return table


def uncorrected():
    """Corrections of nothing (n,), for tools that make the true ones."""
    radii = np.linspace(0.0, 1.0, layout.CORRECTION_RADII)
    return np.concatenate(
        [
            radii,
            np.ones(3 * layout.CORRECTION_SCALES),
            np.zeros(3 * (layout.CORRECTION_SIZE + layout.CORRECTION_SLOPES)),
        ]
    )


def made_table():
    """The table, made anew (n,)."""
    return assemble(stored()["factors"], np.concatenate([scales(), corrections()]))
