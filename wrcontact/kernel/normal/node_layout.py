"""Where the nodes of regions lie: spacing from the width of the interpenetration, as far as the gap says that
strips are loaded."""

from math import log, sqrt
from typing import Final

from ..contact.contact_plane import is_yawed
from ..contact.planes import enter_plane, leave_plane
from ..contact.regions import BEYOND
from ..layout import (LATERAL_ADAPTIVE, LOAD_VERTICAL, Contact, Frame, Nodes, NodesOfRegions, Region, Regions,
                      State, Tables)
from .hertz import table_value
from .mean_normal import mean_normal
from .node_coefficients import FLOOR, weigh_nodes
from .nodes import bring_nearer, lay_nodes, node_stride, window_nodes
from .widths import measure_widths

#: Half-widths are measured at this share of the local penetration: at all of it a flat end of the profile
#: would count as all of its width.
MEASURED: Final[float] = 0.9
#: Nodes are laid until the gap has risen to this share of the local penetration, or before it where (1 +
#: beta) g has risen to
COVER: Final[float] = 1.1
#: this share; the estimate of the local penetration is within 12 % for nine of ten poses.
SPREAD: Final[float] = 1.25
#: Smallest mean half-width, as a share of the half-length sqrt(penetration R_x), of a region that an end
#: nearly closes.
NARROWEST: Final[float] = 0.01
WIDEST: Final[float] = 110.0         # nodes that a region has room for on one side


def zone_share(tables: Tables, A: float, side: float):
    """Share of the local penetration up to which the gap is laid with nodes on a side with lateral curvature
    ``side`` [1/m]: strips are loaded while (1 + beta) g is below the local penetration.  With prepared
    curvatures 1 + beta may fall to 1."""
    if side < FLOOR * A:
        side = FLOOR * A
    share = SPREAD / table_value(tables.hertz, 0, log(A / side))
    if share > COVER or tables.lateral != LATERAL_ADAPTIVE:
        share = COVER
    return share


def node_spacing(tables: Tables, region: Region, enlarge: float):
    """Spacing of a region's nodes [m]: its half-width over the nodes wanted on it, unless there is no room
    for so many."""
    mean = 0.5 * (region.width_low + region.width_high)
    widest = region.width_low
    if region.width_high > widest:
        widest = region.width_high
    least = NARROWEST * sqrt(region.local_penetration / region.curvature)
    if mean < least:
        mean = least
    spacing = mean / tables.nodes
    if widest * enlarge > WIDEST * spacing:
        spacing = widest * enlarge / WIDEST
    return spacing


def prepare_regions(tables: Tables, contact: Contact, state: State, count: int, enlarge: float):
    """Widths, nodes and coefficients of all regions at their local penetrations times ``enlarge``."""
    for i in range(count):
        region = contact.regions[i]
        enter_plane(contact.frame, contact.frames, contact.regions[i], i)
        measure_widths(tables, contact, state, region, MEASURED * region.local_penetration)
        region.spacing = node_spacing(tables, region, enlarge)
        prepare_nodes(tables, contact, state, region, contact.nodes[i], enlarge)
        leave_plane(contact.frame, contact.frames, contact.regions[i])


def prepare_nodes(tables: Tables, contact: Contact, state: State, region: Region, nodes: Nodes,
                  enlarge: float):
    """Nodes and coefficients of a region whose frame is open, up to its local
    penetration times ``enlarge``."""
    yawed = is_yawed(contact.frame)
    reach = region.local_penetration * enlarge
    A = 0.5 * region.curvature
    low_reach = reach * zone_share(tables, A, region.side_low)
    high_reach = reach * zone_share(tables, A, region.side_high)
    if contact.frame.pressed and yawed:
        contact.frame.blur = region.spacing * float(node_stride(tables)) * contact.frame.wheel_plane.cos
    lay_nodes(tables, contact, state, region, nodes, low_reach, high_reach)
    bring_nearer(region, nodes)
    weigh_nodes(tables, region, nodes, window_nodes(tables), yawed)
    if contact.frame.pressed or tables.load == LOAD_VERTICAL:
        mean_normal(tables, contact.frame, region, nodes, region.local_penetration)
    region.square = region.local_penetration / nodes.length[0]


def covered(frame: Frame, regions: Regions, nodes: NodesOfRegions, count: int) -> bool:
    """Whether no region is loaded at an end of its nodes other than its bound."""
    result = True
    for i in range(count):
        region = regions[i]
        low = region.low
        high = region.high
        if frame.pressed:
            # a bound that it does not reach is none
            if low < region.station + region.spacing * region.first:
                low = -BEYOND
            if high > region.station + region.spacing * region.last:
                high = BEYOND
        ends = nodes[i]
        if region.local_penetration > ends.rise[region.last] and high >= BEYOND:
            result = False
        if region.local_penetration > ends.rise[region.first] and low <= -BEYOND:
            result = False
    return result
