"""Nodes across a region: gap, longitudinal curvature, and a prepared lateral curvature.

Nodes are anchored at the minimum of the region, station + k h, with h a fixed share of the half-width of the
interpenetration. So a result depends on the pose alone and is smooth in it.

They reach as far as the gap says that strips are loaded.
"""

from math import sqrt
from typing import Final

from ..contact.curves import open_origin
from ..contact.frame import BEYOND, NO_GAP, enter_plane, is_yawed, leave_plane
from ..contact.separation import separation
from ..contact.traces import start_traces
from ..contact.widths import measure_widths
from ..layout import (
    LATERAL_ADAPTIVE,
    LOAD_VERTICAL,
    NODE_LIMIT,
    NODE_MIDDLE,
    RAIL,
    SEPARATION_EQUIDISTANT_CHORD,
    SEPARATION_NORMAL,
    SEPARATION_VERTICAL,
    WHEEL,
    Contact,
    Frame,
    NodeRun,
    Nodes,
    NodesOfRegions,
    Pair,
    Region,
    Regions,
    Tables,
)
from ..surface.curvature import relative_curvature
from ..surface.tables import height_slope
from .coefficients import FLOOR, table_value, weigh_nodes
from .patch_places import mean_normal

#: Window of the lateral curvature as a share of the half-width of the interpenetration
#: (docs/theory).
WINDOW: Final[float] = 4.0 / 15.0
#: Tolerance of the abscissae: this share of the spacing, or this [m]. The residual is removed to second
#: order, which leaves 1e-9 m of the gap where the curvature jumps within it, and less elsewhere.
TRACE_SHARE: Final[float] = 1e-2
COARSEST_TRACE: Final[float] = 5e-6
#: Where the rail has turned by more than this cosine says, nothing of that counts [-].
LEAST_TURN: Final[float] = 0.2
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
NODE_ROOM: Final[float] = 110.0  # nodes that a region has room for on one side


def window_nodes(tables: Tables):
    """Half the width of the window of the lateral curvature, in nodes."""
    return int(tables.nodes * WINDOW + 0.5)


def node_stride(tables: Tables):
    """Every so many of the nodes are traced on the profiles.

    All of them are traced where curvatures are read there, where chords lead to them, and for vertical
    distances: on a steep side these rise too fast for a cubic over several nodes, which falls below zero
    before.
    """
    stride = tables.stride
    kind = tables.separation
    if kind == SEPARATION_EQUIDISTANT_CHORD or kind == SEPARATION_VERTICAL:
        stride = 1
    if tables.lateral != LATERAL_ADAPTIVE:
        stride = 1
    return stride


def trace_tolerance(spacing: float):
    """To what the abscissae of nodes with this ``spacing`` are traced [m]."""
    tolerance = min(TRACE_SHARE * spacing, COARSEST_TRACE)
    return tolerance


def lay_nodes(
    pair: Pair, contact: Contact, region: Region, nodes: Nodes, low_reach: float, high_reach: float
):
    """Gap and A at the nodes of a region, until the gap has risen above ``low_reach`` or ``high_reach`` [m]
    on that side or the bound is passed, and so many nodes further as the window of the lateral curvature
    needs.

    Where the lateral curvature is a prepared one, it is kept in nodes.B for
    :func:`node_coefficients.weigh_nodes`.
    """
    start_traces(contact.frame, region.station, region.rail, region.wheel)
    open_origin(pair, contact.frame, contact.origin, region, region.spacing)
    gap, rate, bend, curvature = separation(
        pair, contact.frame, contact.origin, region.station, trace_tolerance(region.spacing)
    )
    nodes.gap[0] = 0.0
    nodes.A[0] = 0.5 * curvature
    nodes.turn[0] = turn_cosine(pair, contact.frame)
    if pair.tables.lateral != LATERAL_ADAPTIVE:
        nodes.B[0] = relative_curvature(
            pair, contact.frame.traces[WHEEL].abscissa, contact.frame.traces[RAIL].abscissa
        )
    before = lay_side_nodes(pair, contact, region, nodes, -1, low_reach, rate)
    region.first = -before
    after = lay_side_nodes(pair, contact, region, nodes, 1, high_reach, rate)
    region.last = after


def turn_cosine(pair: Pair, frame: Frame):
    """Cosine of the angle between the rail's normal at the present trace and that of the open frame."""
    slope = frame.place.meeting.rail_slope
    if not frame.pressed or pair.tables.separation != SEPARATION_NORMAL:
        height, slope = height_slope(pair.rail, frame.traces[RAIL].abscissa)
    return (frame.plane.cos + slope * frame.plane.sin) / sqrt(1.0 + slope * slope)


def bring_nearer(region: Region, nodes: Nodes):
    """Let the gap rise less where a region turns.

    A load displaces the surface beside it along the normal there by the cosine of the angle between the two
    normals, so that what the load in the middle displaces is missing there: of the level that is left at a
    node, the share 1 / cosine - 1 counts less as gap.
    """
    for k in range(region.first, region.last + 1):
        level = region.local_penetration - nodes.gap[k]
        if level > 0.0 and nodes.turn[k] > LEAST_TURN:
            nodes.gap[k] -= level * (1.0 / nodes.turn[k] - 1.0)


def trace_node(pair: Pair, contact: Contact, region: Region, nodes: Nodes, at: int):
    """Trace node ``at`` on the profiles; its gap [m], NO_GAP where a profile has ended, and the gap's rate
    [-]."""
    station = region.station + region.spacing * float(at)
    gap, rate, bend, curvature = separation(
        pair, contact.frame, contact.origin, station, trace_tolerance(region.spacing)
    )
    if gap < NO_GAP:
        nodes.gap[at] = gap - region.gap
        nodes.A[at] = 0.5 * curvature
        nodes.turn[at] = turn_cosine(pair, contact.frame)
        if pair.tables.lateral != LATERAL_ADAPTIVE:
            nodes.B[at] = relative_curvature(
                pair, contact.frame.traces[WHEEL].abscissa, contact.frame.traces[RAIL].abscissa
            )
    return gap, rate


def lay_side_nodes(
    pair: Pair, contact: Contact, region: Region, nodes: Nodes, direction: int, reach: float, rate: float
):
    """Nodes in ``direction`` from the minimum, where the gap has this ``rate``; how many until the gap has
    risen above ``reach`` [m] or the bound is passed.

    Every so many nodes one is traced (``node_stride``); those between are read off the cubic through gap and
    slope there.
    """
    start_traces(contact.frame, region.station, region.rail, region.wheel)
    stride = node_stride(pair.tables)
    window = window_nodes(pair.tables)
    k = 0
    traced = 0
    step = stride
    left = window
    passed = 0
    ended = False
    while left > 0 and k < NODE_LIMIT - NODE_MIDDLE - 2 - stride:
        if k == traced and not ended:
            gap, next_rate = trace_node(pair, contact, region, nodes, direction * (traced + step))
            if gap >= NO_GAP and step > 1:
                # a profile ends within this stretch: node by node from here
                step = 1
                start_traces(contact.frame, region.station, region.rail, region.wheel)
                gap, next_rate = trace_node(pair, contact, region, nodes, direction * (traced + step))
            if gap >= NO_GAP:
                ended = True
                end_region(region, direction, region.station + region.spacing * float(direction * k))
            else:
                start = direction * traced
                fill_between(nodes, start, start + direction * step, step, region.spacing, rate, next_rate)
                rate = next_rate
                traced += step
        k += 1
        at = direction * k
        station = region.station + region.spacing * float(at)
        if ended:
            extrapolate_node(nodes, at, direction)
            if pair.tables.lateral != LATERAL_ADAPTIVE:
                nodes.B[at] = nodes.B[at - direction]
        if passed > 0:
            left -= 1
        elif ended or nodes.gap[at] > reach:
            passed = k
        elif station > region.high or station < region.low:
            passed = k
    if passed == 0:
        passed = k - window
    return passed


def fill_straight(values: NodeRun, start: int, stop: int, count: int):
    """Values at the ``count`` - 1 nodes between ``start`` and ``stop``, on a straight line."""
    inward = 1
    if stop < start:
        inward = -1
    rise = (values[stop] - values[start]) / float(count)
    for i in range(1, count):
        values[start + inward * i] = values[start] + rise * float(i)


def fill_between(
    nodes: Nodes, start: int, stop: int, count: int, spacing: float, start_rate: float, stop_rate: float
):
    """Gap (cubic of Hermite) and A (linear) at the ``count`` - 1 nodes between two traced ones, ``start`` and
    ``stop``, with their slopes.

    Beside a conformal stretch the gap can rise so suddenly that the cubic falls below zero before; no gap of
    a region is smaller than that at its minimum.
    """
    low = nodes.gap[start]
    rise = nodes.gap[stop] - low
    width = spacing * float(stop - start)
    forward = start_rate * width - rise
    backward = stop_rate * width - rise
    inward = 1
    if stop < start:
        inward = -1
    for i in range(1, count):
        x = float(i) / float(count)
        rest = 1.0 - x
        gap = max(low + x * (rise + rest * (rest * forward - x * backward)), 0.0)
        nodes.gap[start + inward * i] = gap
    fill_straight(nodes.A, start, stop, count)
    fill_straight(nodes.turn, start, stop, count)


def end_region(region: Region, direction: int, station: float):
    """Bound the region at ``station`` [m]: beyond it a profile ends, or the outline of a strongly yawed wheel
    folds back.  A bound that is known to lie before the next node stays."""
    if direction > 0:
        if station + region.spacing < region.high:
            region.high = station
    elif station - region.spacing > region.low:
        region.low = station


def extrapolate_node(nodes: Nodes, at: int, direction: int):
    """Continue gap and A past an end, so that windows over it see the curvature before it."""
    one = at - direction
    if at * direction > 2:
        two = one - direction
        nodes.gap[at] = 3.0 * nodes.gap[one] - 3.0 * nodes.gap[two] + nodes.gap[two - direction]
    else:
        # next to the minimum: take the other side's, or nothing if that is not known yet
        nodes.gap[at] = nodes.gap[one]
    nodes.A[at] = nodes.A[one]
    nodes.turn[at] = nodes.turn[one]


def zone_share(tables: Tables, A: float, side: float):
    """Share of the local penetration up to which the gap is laid with nodes on a side with lateral curvature
    ``side`` [1/m]: strips are loaded while (1 + beta) g is below the local penetration.  With prepared
    curvatures 1 + beta may fall to 1."""
    side = max(side, FLOOR * A)
    share = SPREAD / table_value(tables.hertz, 0, A / side)
    if share > COVER or tables.lateral != LATERAL_ADAPTIVE:
        share = COVER
    return share


def node_spacing(tables: Tables, region: Region, enlarge: float):
    """Spacing of a region's nodes [m]: its half-width over the nodes wanted on it, unless there is no room
    for so many."""
    mean = 0.5 * (region.width_low + region.width_high)
    widest = max(region.width_low, region.width_high)
    least = NARROWEST * sqrt(region.local_penetration / region.curvature)
    mean = max(mean, least)
    spacing = mean / tables.nodes
    if widest * enlarge > NODE_ROOM * spacing:
        spacing = widest * enlarge / NODE_ROOM
    return spacing


def prepare_regions(pair: Pair, contact: Contact, count: int, enlarge: float):
    """Widths, nodes and coefficients of all regions at their local penetrations times ``enlarge``."""
    for i in range(count):
        region = contact.regions[i]
        enter_plane(contact.frame, contact.frames, contact.regions[i], i)
        measure_widths(pair, contact, region, MEASURED * region.local_penetration)
        region.spacing = node_spacing(pair.tables, region, enlarge)
        prepare_nodes(pair, contact, region, contact.nodes[i], enlarge)
        leave_plane(contact.frame, contact.frames, contact.regions[i])


def prepare_nodes(pair: Pair, contact: Contact, region: Region, nodes: Nodes, enlarge: float):
    """Nodes and coefficients of a region whose frame is open, up to its local
    penetration times ``enlarge``."""
    yawed = is_yawed(contact.frame)
    reach = region.local_penetration * enlarge
    A = 0.5 * region.curvature
    low_reach = reach * zone_share(pair.tables, A, region.side_low)
    high_reach = reach * zone_share(pair.tables, A, region.side_high)
    if contact.frame.pressed and yawed:
        contact.frame.blur = region.spacing * float(node_stride(pair.tables)) * contact.frame.wheel_plane.cos
    lay_nodes(pair, contact, region, nodes, low_reach, high_reach)
    bring_nearer(region, nodes)
    weigh_nodes(pair.tables, region, nodes, window_nodes(pair.tables), yawed, contact.filling)
    if contact.frame.pressed or pair.tables.load == LOAD_VERTICAL:
        mean_normal(pair, contact.frame, region, nodes, region.local_penetration)
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
