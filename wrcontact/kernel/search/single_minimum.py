"""Whether a cell of the raster holds one minimum of the gap at most.

The bounds of ``bounds.py`` hold for stretches that begin anywhere in a cell of the rail, and so count a joint
of the rail that lies beyond the cell of the wheel.  Where they say too little about the cell of a known
minimum, both its ends say more: the rate at which the slope difference rises is known there, and in between
it follows a straight line but for a departure that tables bound (prepare/scan_bends.py), and for a jump where
there is a joint.
"""

from math import fabs
from typing import Final

from ..layout import Pair, Place, ScanNode, inlined, seldom
from ..surface.gap import above_rail
from ..surface.locus import outline_jet
from ..surface.tables import height_slope_bend
from .bounds import STRETCHED_SHARE, WIDEST, YAWED_SHARE, rail_index, rail_place

#: What is longer than this on the rail [m] is not judged: the tables reach so far.
WIDEST_CELL: Final[float] = 1.25e-3
#: The rate departs from a straight line by shares of its parts' departures, of the rail's change and of the
#: wheel's bend, and by this [1/m].
CELL_SHARE: Final[float] = 0.02
WHEEL_SHARE: Final[float] = 0.01
LEAST_DEPARTURE: Final[float] = 0.02


@inlined
def rate_at_node(pair: Pair, at: Place, node: ScanNode):
    """Rail abscissa [m], the rail's bend [1/m], how much the outline is stretched [-], and the rate at which
    the slope difference rises along the wheel [1/m], at a node of the raster."""
    y_track, z_track, outline_slope, stretch, rate = outline_jet(
        at, node.y, node.height, node.slope, node.bend
    )
    abscissa = y_track - pair.rail_y
    height, slope, bend = height_slope_bend(pair.rail, abscissa)
    return abscissa, bend, stretch, bend * stretch - rate


@inlined
def departure_from_line(at: Place, node: ScanNode, rest: float):
    """By how much the rate may depart from a straight line [1/m] up to the next node, but for the rail's
    change, if wheel and rail do by ``rest``; and the share of that change which comes on top [-]."""
    share = CELL_SHARE
    change_share = CELL_SHARE
    if at.yawed:
        stretch = at.sin_yaw * at.sin_yaw * at.radius * node.steepest_bends[0]
        share = YAWED_SHARE + STRETCHED_SHARE * stretch
        change_share += stretch
    return LEAST_DEPARTURE + (1.0 + share) * rest + WHEEL_SHARE * node.steepest_bends[0], change_share


@seldom
def rises_in_cell(pair: Pair, at: Place, cell: int) -> bool:
    """Whether the slope difference certainly rises all the way from node ``cell`` to the next one, and both
    are above the rail."""
    scan = pair.scan
    node = scan.nodes[cell]
    first, first_bend, stretch, first_rate = rate_at_node(pair, at, node)
    last, last_bend, last_stretch, last_rate = rate_at_node(pair, at, scan.nodes[cell + 1])
    length = last - first
    if not (
        first_rate > 0.0
        and last_rate > 0.0
        and length > 0.0
        and length < WIDEST_CELL
        and above_rail(pair, first)
        and above_rail(pair, last)
    ):
        return False
    rail = scan.rail[rail_index(scan, rail_place(scan, first))]
    joint = rail.joint
    while scan.joints[joint].place < first:
        joint += 1
    share = 1.0
    jump = 0.0
    if scan.joints[joint].place <= last:
        share = (scan.joints[joint].place - first) / length
        jump = scan.joints[joint].jump
        if scan.joints[joint + 1].place <= last:
            return False
    rest = node.departure + length * (0.125 * length * rail.wave + 0.25 * rail.kinks)
    departure, change_share = departure_from_line(at, node, rest)
    departure += change_share * (fabs(last_bend - jump - first_bend) + fabs(jump))
    before = first_rate + share * (last_rate - jump * stretch - first_rate)
    least = min(min(first_rate, last_rate), min(before, before + jump * stretch))
    # where the outline is stretched by so much, it may be folded
    return least > departure and change_share < WIDEST
