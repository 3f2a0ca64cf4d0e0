"""Many wheels on many rails: each file is read once, each pair is checked, and a report has a row for each.

>>> import wrcontact
>>> fleet = wrcontact.check_fleet(["S1002", "cone40"], "60E1")
>>> fleet[0]["wheel"], fleet["conicity_3mm"].round(3).tolist()
('S1002', [0.174, 0.025])

docs/guides/fleets.md; ``wrcontact check --batch`` is the same on the command line.
"""

from .run import check_fleet
from .table import Fleet

__all__ = ["Fleet", "check_fleet"]
