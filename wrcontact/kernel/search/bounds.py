"""How far the gap can fall: bounds of its second derivative between nodes of the raster.

Along the wheel the slope difference rail - outline rises by no less than m = rail'' - wheel'', each but for
its share, and the gap changes by that slope times the outline's stretch 1 +- w. Both second derivatives are
bounded in the tables over stretches of 2^k cells. The shares are compared with dense sampling in
tests/search/test_rigid.py.

The raster is the wheel's outline over the rail, at the nodes of the raster and at the ends of the rail.
"""

from math import fabs
from typing import Final

from ..layout import EXPONENTS, Pair, Place, Scan, inlined
from ..surface.gap import above_rail
from ..surface.locus import outline_point
from ..surface.tables import height_slope

#: The yawed outline comes back above the rail from no further than sin^2(yaw) times radius times slope, but
#: for this factor [-], and for the heights of the wheel, turned by the roll [m].
REACH_SHARE: Final[float] = 1.2
REACH_ROLL: Final[float] = 0.06
#: The wheel's abscissa above the end of the rail is located to this [m].
END_SHARP: Final[float] = 1e-9
#: Share by which roll and yaw change the second derivative of either profile, as seen along the track [-];
#: with yaw also in proportion to how much the outline is stretched or folded.
YAWED_SHARE: Final[float] = 0.3
STRETCHED_SHARE: Final[float] = 10.0
ROLLED_SHARE: Final[float] = 0.02
#: Stretches of the wheel that are steeper than this somewhere are not skipped [-]; 71.5 deg. On the others
#: the outline is stretched by no more than the share ROLL_STRETCH sin(roll) + sin^2(yaw) (BEND_STRETCH r
#: |r''| + STEEP_STRETCH), and its slope changes along the profile like r'' but for the share ROLL_BEND
#: sin(roll) + YAW_BEND sin^2(yaw).
STEEP: Final[float] = 3.0
ROLL_STRETCH: Final[float] = 3.1
BEND_STRETCH: Final[float] = 1.1
STEEP_STRETCH: Final[float] = 10.0
ROLL_BEND: Final[float] = 9.5
YAW_BEND: Final[float] = 18.0
#: Stretches that the yawed outline stretches or folds by more than this share are not skipped [-].
WIDEST: Final[float] = 0.25
#: A stretch of no more than this times its number of cells consists of fine cells only [m].
FINE_CELL: Final[float] = 0.501e-3


def node_below(scan: Scan, y: float):
    """The node at or below ``y`` [m]; the second last one at most."""
    u = min(max(0.0, (y - scan.nodes[0].y) * scan.bins_per_metre), scan.bin_count - 1.0)
    node = int(scan.bins[int(u)])
    if node + 2 < scan.count and scan.nodes[node + 1].y <= y:
        node += 1
    return node


@inlined
def node_gap(pair: Pair, at: Place, node: int):
    """Gap [m], slope difference rail - outline [-] and rail abscissa [m] at node ``node``."""
    point = pair.scan.nodes[node]
    y_track, z_track, outline_slope = outline_point(at, point.y, point.height, point.slope)
    abscissa = y_track - pair.rail_y
    height, rail_slope = height_slope(pair.rail, abscissa)
    return height - z_track, rail_slope - outline_slope, abscissa


def rail_below(pair: Pair, at: Place, y: float):
    """Abscissa on the rail [m] below wheel abscissa ``y`` [m]."""
    z, slope = height_slope(pair.wheel, y)
    y_track, z_track, outline_slope = outline_point(at, y, z, slope)
    return y_track - pair.rail_y


def leaves_rail(pair: Pair, at: Place, node: int, direction: int, abscissa: float) -> bool:
    """Whether the outline, beside the rail at node ``node``, does not come back above it further
    in ``direction``.

    Yaw moves a place of the wheel sideways by about sin^2(yaw) r times its slope, so that a steep flank can
    reach over a rail that ends below the flange root.
    """
    scan = pair.scan
    rail = pair.rail
    apart = abscissa - rail.stop
    if direction < 0:
        apart = rail.start - abscissa
    reach = 0.0
    if at.yawed:
        sine = at.sin_yaw
        steep = scan.steepest + scan.nodes[node].slope
        reach = REACH_SHARE * sine * sine * at.radius * steep + REACH_ROLL * fabs(at.sin_roll)
    return apart > reach


def above_rail_end(pair: Pair, at: Place, node: int, outward: int):
    """Wheel abscissa [m] above the end of the rail, which lies between node ``node``, above the rail, and the
    next one ``outward`` (1 or -1)."""
    inside = pair.scan.nodes[node].y
    outside = pair.scan.nodes[node + outward].y
    while fabs(outside - inside) > END_SHARP:
        middle = 0.5 * (inside + outside)
        if above_rail(pair, rail_below(pair, at, middle)):
            inside = middle
        else:
            outside = middle
    return inside


def rail_place(scan: Scan, abscissa: float):
    """Place of ``abscissa`` [m] in the raster of the rail, in cells."""
    return (abscissa - scan.rail_start) * scan.rail_per_metre


def rail_index(scan: Scan, u: float):
    """The cell of the raster of the rail at place ``u``, or the nearest."""
    u = min(max(0.0, u), scan.rail_count - 1.0)
    return int(u)


def largest_fall(slope: float, bend: float, length: float, stretch: float):
    """How far the gap can fall at most [m] over ``length`` [m], with a slope that begins with
    ``slope`` and rises by no less than ``bend`` [1/m], on a wheel that is stretched by no more than
    the share ``stretch``."""
    if bend >= 0.0:
        if slope >= 0.0:
            return 0.0
        if -slope < bend * length:
            return 0.5 * (1.0 + stretch) * slope * slope / bend
    fall = -slope * length + stretch * fabs(slope) * length - 0.5 * (1.0 + stretch) * bend * length * length
    fall = max(fall, 0.0)
    return fall


@inlined
def bend_shares(at: Place):
    """By which share a stretch of the outline is stretched at least, and per steepest bend of the wheel [m];
    by which share its own bends change."""
    roll = fabs(at.sin_roll)
    least_stretch = ROLL_STRETCH * roll
    share = ROLL_BEND * roll
    stretch_per_bend = 0.0
    if at.yawed:
        square = at.sin_yaw * at.sin_yaw
        least_stretch += STEEP_STRETCH * square
        share += YAW_BEND * square
        stretch_per_bend = BEND_STRETCH * square * at.radius
    return least_stretch, stretch_per_bend, share


@inlined
def stretch_bounds(
    scan: Scan,
    node: int,
    direction: int,
    u: float,
    exponent: int,
    least_stretch: float,
    stretch_per_bend: float,
    share: float,
):
    """Length [m] of the 2^exponent cells from ``node`` on in ``direction``, by which share they are stretched,
    WIDEST or more if nothing is known of them, and by how much the slope difference rises there at least
    [1/m]; the cell of the rail and the exponent whose bounds hold for the rail below them.

    u : of the node in the raster of the rail, in cells.
    """
    length = 0.0
    stretch = WIDEST
    bend = 0.0
    cell = 0
    reach = exponent
    cells = 1 << exponent
    first = node
    if direction < 0:
        first = node - cells
    if first >= 0 and first + cells < scan.count:
        begin = scan.nodes[first]
        stretch = least_stretch + stretch_per_bend * begin.steepest_bends[exponent]
        if stretch < WIDEST:
            length = scan.nodes[first + cells].y - begin.y
            edge = u
            if direction < 0:
                edge -= (1.0 + WIDEST) * scan.rail_per_metre * length
            cell = rail_index(scan, edge)
            if length > FINE_CELL * float(cells):
                reach += 1
            bend = scan.rail[cell].least_bends[reach]
            wheel = begin.most_bends[exponent]
            bend -= stretch * fabs(bend) + wheel + share * fabs(wheel)
    return length, stretch, bend, cell, reach


@inlined
def clear_exponent(
    scan: Scan,
    at: Place,
    node: int,
    direction: int,
    abscissa: float,
    excess: float,
    slope: float,
    exponent: int,
):
    """The largest exponent, from ``exponent`` downwards, for which the gap does not fall by more than
    ``excess`` [m] over the 2^exponent cells from ``node`` on; -1 if there is none.

    abscissa : of the node on the rail [m].
    slope : of rail minus outline at the node, seen in ``direction`` (1 or -1).
    """
    u = rail_place(scan, abscissa)
    least_stretch, stretch_per_bend, share = bend_shares(at)
    while exponent >= 0:
        length, stretch, bend, cell, reach = stretch_bounds(
            scan, node, direction, u, exponent, least_stretch, stretch_per_bend, share
        )
        if stretch < WIDEST and largest_fall(slope, bend, length, stretch) <= excess:
            return exponent
        exponent -= 1
    return exponent


def rising_from_minimum(scan: Scan, at: Place, y: float, direction: int, abscissa: float):
    """``clear_exponent`` from a minimum of the gap at ``y``, at ``abscissa`` on the rail [m], on:
    where the gap only rises.

    The stretch is counted from the far node of the minimum's cell, so that it covers the whole cell.
    """
    cell = node_below(scan, y)
    margin = (1.0 + WIDEST) * (scan.nodes[cell + 1].y - scan.nodes[cell].y)
    node = cell
    start = abscissa - margin
    if direction < 0:
        node = cell + 1
        start = abscissa + margin
    return clear_exponent(scan, at, node, direction, start, 0.0, 0.0, EXPONENTS - 1)


def bend_bounds(scan: Scan, at: Place, cell: int, abscissa: float):
    """Bounds [1/m] of the gap's second derivative between the nodes ``cell`` and ``cell`` + 1, the first of
    them above the rail's ``abscissa`` [m]: rail minus wheel."""
    rail = scan.rail[rail_index(scan, rail_place(scan, abscissa))]
    node = scan.nodes[cell]
    share = ROLLED_SHARE
    if at.yawed:
        # how much the outline is stretched: |dY/dy - 1| is about sin^2(yaw) r |r''|
        sine = at.sin_yaw
        share = YAWED_SHARE + STRETCHED_SHARE * sine * sine * at.radius * node.steepest_bends[0]
    least_rail = rail.least_bend
    most_rail = rail.most_bend
    least_wheel = node.least_bend
    most_wheel = node.most_bends[0]
    least = least_rail - most_wheel - share * (fabs(least_rail) + fabs(most_wheel))
    most = max(0.0, most_rail - least_wheel + share * (fabs(most_rail) + fabs(least_wheel)))
    return least, most


def only_rises_or_falls(
    least: float, most: float, width: float, mismatch_low: float, mismatch_high: float
) -> bool:
    """Whether the gap certainly only rises, or only falls, over a ``width`` [m] in which the slope difference
    rises by no less than ``least`` and no more than ``most`` [1/m]."""
    steady = mismatch_low >= 0.0 and least_slope(least, most, width, mismatch_low, mismatch_high) >= 0.0
    if mismatch_high <= 0.0 and least_slope(least, most, width, -mismatch_high, -mismatch_low) >= 0.0:
        steady = True
    return steady


def least_slope(least: float, most: float, width: float, first: float, last: float):
    """The smallest slope that is possible over a ``width`` [m] between ``first`` and ``last``
    at its ends, where it rises by no less than ``least`` and no more than ``most`` [1/m]:
    where the lines from both ends meet."""
    lowest = min(first, last)
    if least < 0.0:
        lowest = first + least * width
        if most > 0.0:
            meet = (last - first - most * width) / (least - most)
            lowest = first + least * min(max(meet, 0.0), width)
    return lowest
