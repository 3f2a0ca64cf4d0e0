"""Wear of wheels and rails to a mileage, and rolling contact fatigue, from results with creep forces.

The recipe: rows of results (``rows``) become cells, short stretches of rubbing across a profile (``cells``);
a law (``laws``) says what each cell loses; bins of arc length collect it (``bins``, ``accumulate``); the
profile is moved along its normal (``update``) and measured (``shape``); ``run`` repeats that to a mileage.
``fatigue`` judges each patch.  Nothing here is part of an FMU: a profile does not change in a simulation.
"""

from .accumulate import Wear
from .fatigue import Fatigue, fatigue, shakedown_limit
from .laws import ArchardMap, BritishRail, Usfd, Zobory
from .run import wear_run
from .shape import WheelShape, wheel_shape
from .steps import WearRun, WearStep

__all__ = [
    "ArchardMap",
    "BritishRail",
    "Fatigue",
    "Usfd",
    "Wear",
    "WearRun",
    "WearStep",
    "WheelShape",
    "Zobory",
    "fatigue",
    "shakedown_limit",
    "wear_run",
    "wheel_shape",
]
