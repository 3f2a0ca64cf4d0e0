"""The wheel's outline over the rail, at the nodes of the raster and at the ends of the rail."""

from math import fabs
from typing import Final

from ..layout import Place, Scan, Tables
from ..surface.gap import above_rail
from ..surface.locus import outline_point
from ..surface.profile_table import height_slope

#: The yawed outline comes back above the rail from no further than sin^2(yaw) times radius times slope, but
#: for this factor [-], and for the heights of the wheel, turned by the roll [m].
REACH_SHARE: Final[float] = 1.2
REACH_ROLL: Final[float] = 0.06
#: The wheel's abscissa above the end of the rail is located to this [m].
END_SHARP: Final[float] = 1e-9


def node_below(scan: Scan, y: float):
    """The node at or below ``y`` [m]; the second last one at most."""
    u = (y - scan.nodes[0].y) * scan.bins_per_metre
    if not u > 0.0:
        u = 0.0
    if u > scan.bin_count - 1.0:
        u = scan.bin_count - 1.0
    node = int(scan.bins[int(u)])
    if node + 2 < scan.count and scan.nodes[node + 1].y <= y:
        node += 1
    return node


def node_gap(tables: Tables, at: Place, node: int):
    """Gap [m], slope difference rail - outline [-] and rail abscissa [m] at node ``node``."""
    point = tables.scan.nodes[node]
    y_track, z_track, outline_slope = outline_point(at, point.y, point.height, point.slope)
    abscissa = y_track - tables.rail_y
    height, rail_slope = height_slope(tables.rail, abscissa)
    return height - z_track, rail_slope - outline_slope, abscissa


def rail_below(tables: Tables, at: Place, y: float):
    """Abscissa on the rail [m] below wheel abscissa ``y`` [m]."""
    z, slope = height_slope(tables.wheel, y)
    y_track, z_track, outline_slope = outline_point(at, y, z, slope)
    return y_track - tables.rail_y


def leaves_rail(tables: Tables, at: Place, node: int, direction: int, abscissa: float) -> bool:
    """Whether the outline, beside the rail at node ``node``, does not come back above it further
    in ``direction``.

    Yaw moves a place of the wheel sideways by about sin^2(yaw) r times its slope, so that a steep flank can
    reach over a rail that ends below the flange root.
    """
    scan = tables.scan
    rail = tables.rail
    apart = abscissa - rail.stop
    if direction < 0:
        apart = rail.start - abscissa
    reach = 0.0
    if at.yawed:
        sine = at.sin_yaw
        steep = scan.steepest + scan.nodes[node].slope
        reach = REACH_SHARE * sine * sine * at.radius * steep + REACH_ROLL * fabs(at.sin_roll)
    return apart > reach


def above_rail_end(tables: Tables, at: Place, node: int, outward: int):
    """Wheel abscissa [m] above the end of the rail, which lies between node ``node``, above the rail, and the
    next one ``outward`` (1 or -1)."""
    inside = tables.scan.nodes[node].y
    outside = tables.scan.nodes[node + outward].y
    while fabs(outside - inside) > END_SHARP:
        middle = 0.5 * (inside + outside)
        if above_rail(tables, rail_below(tables, at, middle)):
            inside = middle
        else:
            outside = middle
    return inside
