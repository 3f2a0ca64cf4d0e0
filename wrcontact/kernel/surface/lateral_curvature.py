"""Lateral curvatures of wheel and rail profile, prepared once (prepare_curvatures.py) and read off along them.

Table at ``base``: count of values, start [m], values per metre, then the curvatures [1/m] at even distances, positive where
the profile bulges towards the other body.
"""

from typing import Final

from ..layout import Tables

CURVATURE_COUNT: Final[int] = 0
CURVATURE_START: Final[int] = 1
CURVATURE_PER_METRE: Final[int] = 2
CURVATURES: Final[int] = 3


def profile_curvature(tables: 'float[:]', base: int, y: float):
    """Curvature [1/m] of the profile at ``y`` [m], on the straight line between two values; beyond an end the end's."""
    u = (y - tables[base + CURVATURE_START]) * tables[base + CURVATURE_PER_METRE]
    last = tables[base + CURVATURE_COUNT] - 1.0
    if not u > 0.0:
        u = 0.0
    if u > last:
        u = last
    cell = int(u)
    if cell > int(last) - 1:
        cell = int(last) - 1
    at = base + CURVATURES + cell
    return tables[at] + (u - float(cell)) * (tables[at + 1] - tables[at])


def relative_curvature(tables: Tables, y: float, abscissa: float):
    """B = (kappa_wheel + kappa_rail) / 2 [1/m] at wheel abscissa ``y`` and rail abscissa ``abscissa`` [m], the source's
    eq. (6.5)."""
    wheel = profile_curvature(tables.raw, int(tables.wheel_curvature), y)
    rail = profile_curvature(tables.raw, int(tables.rail_curvature), abscissa)
    return 0.5 * (wheel + rail)
