"""Conditioning of a pair of profiles: what to know about it before a simulation relies on it
(docs/guides/check.md).

>>> import wrcontact
>>> report = wrcontact.check(wrcontact.ContactSystem(rail="60E1"))
>>> report.usable, round(report.nearest_jump * 1e3, 2), round(float(report.conicity.level[2]), 3)   # at 3 mm
(True, 0.23, 0.174)

The package uses a ContactSystem; nothing in a simulation or an FMU uses it.
"""

from .conformal import ConformalZone
from .conicity import Conicity, equivalent_conicity, regressed_conicity
from .curves import Curves, Jump, SideCurves, find_jumps
from .quality import ProfileQuality
from .report import Conditioning, check

__all__ = [
    "Conditioning",
    "Conicity",
    "ConformalZone",
    "Curves",
    "Jump",
    "ProfileQuality",
    "SideCurves",
    "check",
    "equivalent_conicity",
    "regressed_conicity",
    "find_jumps",
]
