"""How a strip of tractions along the rolling direction reaches beside itself: the functions S of eq. (K2).

A strip carries X sqrt((1 - x)/(1 + x)), x from the trailing to the leading edge, or in spin X sqrt(1 - x^2);
the slip that this takes from the surface at the distance eta beside it is weighted with
sqrt((1 + x)/(1 - x)), in spin with x sqrt(1 - x^2).  Cerruti's solution for a half-space of Poisson's ratio
nu gives, over eta, with r^2 = (cos t - cos t')^2 + eta^2 and the integrals over 0 < t, t' < pi,

    P = 1/(2 pi^2) int int eta / r,    P_s = 2/pi^2 int int sin^2 t sin^2 t' eta / r
    R = 1/(2 pi^2) int int eta^3 / r^3,   R_s = 2/pi^2 int int sin^2 t sin^2 t' eta^3 / r^3      (K4)
    S_x = P + nu/(1 - nu) (P - R),   S_y = P + nu (R - P),   S_s = P_s + nu (R_s - P_s)          (K5)

all 1/2 far away.  tools/make_rolling_kernels.py makes P, R, P_s, R_s and their slopes over ln eta, and the
factors f of eq. (K3), which are stored in kernel/data/rolling_kernels.json.
"""

import json
from functools import lru_cache
from pathlib import Path

import numpy as np

from .. import layout
from .kalker_table import hermite_cubic

DATA = Path(__file__).parents[1] / "data" / "rolling_kernels.json"


@lru_cache(maxsize=1)
def stored():
    """What the tool has stored, as arrays: ``reaches`` (P R P_s R_s, value or slope, node) and ``factors``
    (Poisson's ratio, f1 f2 f3, value or slope, node)."""
    return {name: np.array(values) for name, values in json.loads(DATA.read_text()).items()}


def reach_nodes():
    """ln eta of the nodes (n,)."""
    return layout.REACH_START + np.arange(layout.REACH_CELLS + 1) / layout.REACH_PER_UNIT


def reach_parts():
    """The two parts (part, n) of the table of reaches: S = first + weight second, with the weights
    nu/(1 - nu) for S_x and nu for the others, as cubics over the cells; behind them the same at the first
    node."""
    near, far, near_spin, far_spin = stored()["reaches"]
    pairs = (near, near - far), (near, far - near), (near_spin, far_spin - near_spin)
    parts = []
    for part in range(2):
        rows = [hermite_cubic(pair[part][0], pair[part][1] / layout.REACH_PER_UNIT) for pair in pairs]
        first = [pair[part][0, 0] for pair in pairs]
        parts.append(np.concatenate([np.stack(rows, axis=1).ravel(), first]))
    return np.array(parts)
