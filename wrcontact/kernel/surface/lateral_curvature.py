"""Lateral curvatures of wheel and rail profile, prepared once (prepare/curvatures.py) and read off along
them."""

from ..layout import CurvatureTable, Tables
from .table_cell import table_cell


def profile_curvature(table: CurvatureTable, y: float):
    """Curvature [1/m] of the profile at ``y`` [m], linear between two values; beyond an end, the value at
    that end."""
    cell, share = table_cell((y - table.start) * table.per_metre, table.count - 1.0)
    before = table.curvatures[cell]
    return before + share * (table.curvatures[cell + 1] - before)


def relative_curvature(tables: Tables, y: float, abscissa: float):
    """B = (kappa_wheel + kappa_rail) / 2 [1/m] at wheel abscissa ``y`` and rail abscissa ``abscissa`` [m],
    the source's eq. (6.5)."""
    wheel = profile_curvature(tables.wheel_curvature, y)
    rail = profile_curvature(tables.rail_curvature, abscissa)
    return 0.5 * (wheel + rail)
