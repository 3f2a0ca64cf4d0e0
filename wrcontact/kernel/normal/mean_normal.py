"""The direction along which the force of a region acts, where that is the mean of the rail's normals."""

from math import sqrt

from ..layout import LOAD_VERTICAL, Frame, Nodes, Region, Tables
from ..surface.cubic_table import read_cubic
from ..surface.profile_table import height_slope
from ..surface.rails import upright_share


def mean_normal(tables: Tables, frame: Frame, region: Region, nodes: Nodes, local_penetration: float):
    """Let the force of a region act along the mean of the rail's normals, weighted by the line load at a
    local penetration [m].

    The nodes lie along the rail.
    """
    arc = read_cubic(tables.rail_arc, region.rail)
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
            x = read_cubic(tables.rail_at_arc, arc + step * float(k + 1))
    if total > 0.0:
        region.cos = cosines / total
        region.sin = sines / total
        if tables.load == LOAD_VERTICAL:
            region.share = upright_share(frame.place, region.cos, region.sin)
