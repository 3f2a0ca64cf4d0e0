"""Where two surfaces are closest along x, station by station: what a look for missed patches goes by."""

from dataclasses import dataclass

import numpy as np

# samples along and across the domain of the look for places that a solution has missed
LOOK = 25, 800
LOOK_SLACK = 0.25        # what a parabola along x finds below its samples is known to this share


@dataclass(frozen=True)
class Ridge:
    """The least gap along x at many stations.

    Attributes
    ----------
    s : stations (m,), rising [m].
    x : place of the least gap (m,) [m].
    low : that gap, at no penetration (m,) [m].
    spare : how much lower it may be (m,) [m].
    step : how well the places x are known [m].
    """

    s: np.ndarray
    x: np.ndarray
    low: np.ndarray
    spare: np.ndarray
    step: float
