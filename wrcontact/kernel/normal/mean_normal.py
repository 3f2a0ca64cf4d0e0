"""The direction along which the force of a region acts, where that is the mean of the rail's normals."""

from math import sqrt

from ..layout import LOAD_VERTICAL, Frame, Nodes, Region, Tables
from ..surface.profile_table import height_slope


def rail_per_station(tables: Tables, frame: Frame, abscissa: float):
    """Change of the rail's abscissa per station of the open frame [-]."""
    height, slope = height_slope(tables.rail, abscissa)
    along = sqrt(1.0 + slope * slope)
    if not frame.pressed:
        along = frame.plane.cos + slope * frame.plane.sin
    return 1.0 / along


def mean_normal(tables: Tables, frame: Frame, region: Region, nodes: Nodes, local_penetration: float):
    """Let the force of a region act along the mean of the rail's normals, weighted by the line load at a
    local penetration [m].

    The rail is followed from node to node by the midpoint rule; nodes of a pressed wheel lie along it, others
    in the plane.
    """
    total = 0.0
    cosines = 0.0
    sines = 0.0
    for direction in range(-1, 2, 2):
        x = region.rail
        step = float(direction) * region.spacing
        last = region.last
        if direction < 0:
            last = -region.first
        for k in range(last + 1):
            height, slope = height_slope(tables.rail, x)
            cosine = 1.0 / sqrt(1.0 + slope * slope)
            weight = nodes.line[direction * k] * (local_penetration - nodes.rise[direction * k])
            if weight <= 0.0:
                break
            if k == 0:
                weight *= 0.5
            total += weight
            cosines += weight * cosine
            sines += weight * slope * cosine
            x += step * rail_per_station(tables, frame, x + 0.5 * step * rail_per_station(tables, frame, x))
    if total > 0.0:
        region.cos = cosines / total
        region.sin = sines / total
        if tables.load == LOAD_VERTICAL:
            region.share = region.cos
    return 0
