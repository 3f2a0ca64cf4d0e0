"""What other preparations of ANALYN's input change: each choice at a contact on tread, flange root and
flange, compared with the default (docs/method.md, section 8)."""

import numpy as np

from . import runs
from .errors import PATCH
from .rows import system

SHIFTS = {"1 mm (tread)": 1e-3, "6 mm (flange root)": 6e-3, "6.5 mm (flange)": 6.5e-3}  # [m]
CHOICES = (("separation", "vertical"), ("separation", "equidistant"), ("separation", "equidistant_chord"),
           ("longitudinal_curvature", "basic"), ("lateral_curvature", "smooth"),
           ("lateral_curvature", "rough"))
NODES = 38  # so many that their number has no part in the changes


def patches(**options):
    """Penetration, area and peak pressure (3, 3) of the right wheel at SHIFTS."""
    right = system(nodes=NODES, **options).evaluate_many(list(SHIFTS.values()), 0.0, runs.FORCE).right
    return np.array([getattr(right, name) for name in PATCH]).T


def changes():
    """Rows by choice: changes [%] of penetration, area and peak pressure at each shift."""
    usual = patches()
    return {f'{name} "{choice}"': dict(zip(SHIFTS, 100 * (patches(**{name: choice}) / usual - 1)))
            for name, choice in CHOICES}
