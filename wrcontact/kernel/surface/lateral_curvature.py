"""Lateral curvatures of wheel and rail profile, prepared once (prepare/curvatures.py) and read off along
them."""

from ..layout import CurvatureTable, Tables


def profile_curvature(table: CurvatureTable, y: float):
    """Curvature [1/m] of the profile at ``y`` [m], linear between two values; beyond an end, the value at
    that end."""
    u = (y - table.start) * table.per_metre
    last = table.count - 1.0
    if not u > 0.0:
        u = 0.0
    if u > last:
        u = last
    cell = int(u)
    if cell > int(last) - 1:
        cell = int(last) - 1
    before = table.curvatures[cell]
    return before + (u - float(cell)) * (table.curvatures[cell + 1] - before)


def relative_curvature(tables: Tables, y: float, abscissa: float):
    """B = (kappa_wheel + kappa_rail) / 2 [1/m] at wheel abscissa ``y`` and rail abscissa ``abscissa`` [m],
    the source's eq. (6.5)."""
    wheel = profile_curvature(tables.wheel_curvature, y)
    rail = profile_curvature(tables.rail_curvature, abscissa)
    return 0.5 * (wheel + rail)
