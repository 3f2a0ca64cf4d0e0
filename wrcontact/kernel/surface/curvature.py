"""Curvatures of wheel and rail: across the track as prepared once (prepare/curvatures.py) and read off along
the profiles, and that of the wheel along the track.
"""

from math import sqrt
from typing import Final

from ..layout import (
    LONGITUDINAL_BASIC,
    LONGITUDINAL_EFFECTIVE,
    CurvatureTable,
    Pair,
    Place,
    Tables,
    inlined,
    seldom,
)
from .locus import around_wheel
from .tables import table_cell

#: Smallest share of the wheel's own 1/r that is left for the longitudinal curvature of a strongly yawed
#: flange root [-].
CURVATURE_FLOOR: Final[float] = 0.05


def profile_curvature(table: CurvatureTable, y: float):
    """Curvature [1/m] of the profile at ``y`` [m], linear between two values; beyond an end, the value at
    that end."""
    cell, share = table_cell((y - table.start) * table.per_metre, table.count - 1.0)
    before = table.curvatures[cell]
    return before + share * (table.curvatures[cell + 1] - before)


def relative_curvature(pair: Pair, y: float, abscissa: float):
    """B = (kappa_wheel + kappa_rail) / 2 [1/m] at wheel abscissa ``y`` and rail abscissa ``abscissa`` [m],
    the source's eq. (6.5)."""
    wheel = profile_curvature(pair.wheel_curvature, y)
    rail = profile_curvature(pair.rail_curvature, abscissa)
    return 0.5 * (wheel + rail)


def longitudinal_curvature(tables: Tables, place: Place, y: float, z: float, slope: float, bend: float):
    """Curvature 1/R_x of the wheel along the track [1/m] at the locus point with profile abscissa ``y`` and height
    ``z`` [m], ``slope`` [-] and second derivative ``bend`` [1/m].

    effective: of the surface cut by the plane of the track's x and the contact normal.  With e the track's x
    in the wheelset frame, [(e1 cos(phi) - e3 sin(phi))^2 / r - r'' e2^2] / sqrt(1 + r'^2); without yaw
    cos(delta) / r, the source's eq. (6.1). basic: 1/r.  On a rail whose section changes, the relative one.
    """
    if tables.longitudinal != LONGITUDINAL_EFFECTIVE:
        return other_curvature(tables, place, y, z, slope, bend)
    return effective_curvature(place, z, slope, bend)


@inlined
def effective_curvature(place: Place, z: float, slope: float, bend: float):
    """The effective curvature [1/m]."""
    r = place.radius + z
    curvature = 0.0
    if not place.yawed:
        curvature = 1.0 / (r * sqrt(1.0 + slope * slope))
    else:
        sin_phi, cos_phi = around_wheel(place, slope)
        e1 = place.cos_yaw
        e2 = place.sin_yaw * place.cos_roll
        e3 = place.sin_yaw * place.sin_roll
        around = e1 * cos_phi - e3 * sin_phi
        steep = sqrt(1.0 + slope * slope)
        curvature = max((around * around / r - bend * e2 * e2) / steep, CURVATURE_FLOOR / (r * steep))
    return curvature


@seldom
def other_curvature(tables: Tables, place: Place, y: float, z: float, slope: float, bend: float):
    """The basic curvature [1/m], or where the section of the rail changes, the effective one and that of the rail."""
    if tables.longitudinal == LONGITUDINAL_BASIC:
        return 1.0 / (place.radius + z)
    return effective_curvature(place, z, slope, bend) + rail_bend(tables, y)


@seldom
def rail_bend(tables: Tables, y: float):
    """Curvature [1/m] along the frame of the changing rail at work, where the wheel's abscissa is ``y`` [m]; linear between
    two lines (changing/valley.py)."""
    low = tables.valley_first
    high = tables.valley_last
    while high - low > 1:
        middle = (low + high) // 2
        if tables.valley[middle].wheel <= y:
            low = middle
        else:
            high = middle
    before = tables.valley[low]
    behind = tables.valley[high]
    share = 0.0
    if behind.wheel > before.wheel:
        share = min(max((y - before.wheel) / (behind.wheel - before.wheel), 0.0), 1.0)
    return before.bend + share * (behind.bend - before.bend)
