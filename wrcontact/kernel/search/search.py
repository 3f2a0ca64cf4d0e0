"""The smallest vertical gap of one side: march, bound, refine.

The gap has up to three local minima (tread, flange root, flange) that exchange rank.  From a known place the search
marches outwards over a fixed raster of the wheel profile.  Gap, slope and a lower bound of the second derivative tell how
far the gap cannot have fallen below the best one known; that stretch, of up to 32 cells, is skipped.  Where not even one
cell can be, the gap between its two nodes lies above its chord by no less than -M h^2 / 8, where M bounds its second
derivative from above, and a cell that could still hold a smaller value is halved until that is settled.  So the global
minimum is bounded and not assumed.
"""

from math import fabs
from typing import Final

from ..layout import SIDE_STACK, Place, SideSearch, State, Tables, Work, offset
from ..surface.gap import FOLDED, above_rail, vertical_gap
from ..surface.locus import outline_point
from ..surface.profile_table import height_slope

# the scan table: sizes, then the nodes, then the raster of the rail's bounds, then the first node of each bin
SCAN_COUNT: Final[int] = 0           # nodes
SCAN_RAIL_COUNT: Final[int] = 1      # cells of the rail's raster
SCAN_RAIL_START: Final[int] = 2      # [m]
SCAN_RAIL_PER_METRE: Final[int] = 3
SCAN_RAIL_OFFSET: Final[int] = 4
SCAN_BIN_OFFSET: Final[int] = 5
SCAN_BIN_COUNT: Final[int] = 6
SCAN_BINS_PER_METRE: Final[int] = 7
SCAN_STEEPEST: Final[int] = 8        # largest absolute slope of the wheel [-]
SCAN_NODES: Final[int] = 9
LEVELS: Final[int] = 6               # stretches of 1, 2, 4 ... 32 cells
SCAN_ROW: Final[int] = 17            # of a node:
ROW_Y: Final[int] = 0                # abscissa [m]
ROW_HEIGHT: Final[int] = 1           # [m]
ROW_SLOPE: Final[int] = 2
ROW_LEAST_BEND: Final[int] = 3       # smallest second derivative up to the next node [1/m]
ROW_MOST_BENDS: Final[int] = 4       # largest one up to the node 1, 2, 4 ... further
ROW_STEEPEST_BENDS: Final[int] = 10  # largest absolute value, likewise
ROW_LEVER: Final[int] = 16           # largest change of the gap with the roll, here and at all nodes beyond [m]
RAIL_ROW: Final[int] = 9             # of a cell of the rail's raster:
RAIL_LEAST_BEND: Final[int] = 0      # smallest and largest second derivative around it [1/m]
RAIL_MOST_BEND: Final[int] = 1
RAIL_LEAST_BENDS: Final[int] = 2     # smallest one along a wheel's stretch of 1, 2, 4 ... 64 fine cells that starts in it

#: Share by which roll and yaw change the second derivative of either profile, as seen along the track; with yaw also in
#: proportion to how much the outline is stretched or folded.  Held against dense sampling in tests/test_rigid.py.
YAWED_SHARE: Final[float] = 0.3
STRETCHED_SHARE: Final[float] = 10.0
ROLLED_SHARE: Final[float] = 0.02
#: Stretches of the wheel that are steeper than this somewhere are not skipped [-]; 71.5 deg.  On the others the outline is
#: stretched by no more than the share ROLL_STRETCH sin(roll) + sin^2(yaw) (BEND_STRETCH r |r''| + STEEP_STRETCH), and its
#: slope changes along the profile like r'' but for the share ROLL_BEND sin(roll) + YAW_BEND sin^2(yaw).
STEEP: Final[float] = 3.0
ROLL_STRETCH: Final[float] = 3.1
BEND_STRETCH: Final[float] = 1.1
STEEP_STRETCH: Final[float] = 10.0
ROLL_BEND: Final[float] = 9.5
YAW_BEND: Final[float] = 18.0
#: Stretches that the yawed outline stretches or folds by more than this share are not skipped.
WIDEST: Final[float] = 0.25
#: The yawed outline comes back above the rail from no further than sin^2(yaw) times radius times slope, but for this factor, and
#: for the heights of the wheel, turned by the roll [m].
REACH_SHARE: Final[float] = 1.2
REACH_ROLL: Final[float] = 0.06
#: A stretch of no more than this times its number of cells consists of fine cells only [m].
FINE_CELL: Final[float] = 0.501e-3
#: Without a known place the search begins at the best of every eighth node.
PROBE_STRIDE: Final[int] = 8
#: Cells are halved down to this width [m]; what a cell can then hide is less than M (2e-6 m)^2 / 8, 1e-11 m at worst.
NARROW: Final[float] = 2e-6
#: The same where further minima are looked for; and a stretch that has one is not halved below this: two would be one contact.
LISTED: Final[float] = 2e-6
LISTED_ONE: Final[float] = 2.5e-4
#: Abscissa to which a minimum is refined [m]; its gap is then exact to rounding, being second order.
SHARP: Final[float] = 1e-13
ROUNDING: Final[float] = 1e-15       # of gaps [m]
#: The end of the rail is located to this [m].
END_SHARP: Final[float] = 1e-9
LARGE_GAP: Final[float] = 1e3
#: Candidates for other regions that are listed to either side of the smallest gap; two or three occur.
CANDIDATES: Final[int] = 16


def node_below(tables: Tables, y: float):
    """The scan node at or below ``y`` [m]; the second last one at most."""
    scan = int(tables.scan)
    u = (y - tables[scan + SCAN_NODES + ROW_Y]) * tables[scan + SCAN_BINS_PER_METRE]
    if not u > 0.0:
        u = 0.0
    if u > tables[scan + SCAN_BIN_COUNT] - 1.0:
        u = tables[scan + SCAN_BIN_COUNT] - 1.0
    node = int(tables[scan + int(tables[scan + SCAN_BIN_OFFSET]) + int(u)])
    if node + 2 < int(tables[scan + SCAN_COUNT]) and tables[scan + SCAN_NODES + SCAN_ROW * (node + 1) + ROW_Y] <= y:
        node += 1
    return node


def node_gap(tables: Tables, place: Work, at: Place, node: int):
    """Gap [m], slope difference rail - outline [-] and rail abscissa [m] at scan node ``node``."""
    row = int(tables.scan) + SCAN_NODES + SCAN_ROW * node
    y_track, z_track, outline_slope = outline_point(at, tables[row + ROW_Y], tables[row + ROW_HEIGHT],
                                                    tables[row + ROW_SLOPE])
    abscissa = y_track - tables.rail_y
    height, rail_slope = height_slope(tables.rail, abscissa)
    return height - z_track, rail_slope - outline_slope, abscissa


def rail_cell(tables: Tables, abscissa: float):
    """Place of ``abscissa`` [m] in the rail's raster, in cells."""
    scan = int(tables.scan)
    return (abscissa - tables[scan + SCAN_RAIL_START]) * tables[scan + SCAN_RAIL_PER_METRE]


def rail_row(tables: Tables, u: float):
    """Offset in ``tables`` of the rail raster's cell at place ``u``, or of the nearest."""
    scan = int(tables.scan)
    if not u > 0.0:
        u = 0.0
    if u > tables[scan + SCAN_RAIL_COUNT] - 1.0:
        u = tables[scan + SCAN_RAIL_COUNT] - 1.0
    return scan + int(tables[scan + SCAN_RAIL_OFFSET]) + RAIL_ROW * int(u)


def clear_level(tables: Tables, place: Work, at: Place, node: int, direction: int, abscissa: float, excess: float,
                slope: float, level: int, risen: int):
    """The largest level of 2^level cells from ``node`` on in which the gap does not fall by more than ``excess`` [m], or
    with ``risen`` = 1 in which it only rises; from ``level`` downwards, -1 if there is none.

    abscissa : where the stretch begins on the rail [m].
    slope : of rail minus outline at the node, seen in ``direction`` (1 or -1).

    Along the wheel the slope difference rises by no less than m = rail'' - wheel'', each but for its share, and the gap by
    that slope times the outline's stretch 1 +- w.
    """
    scan = int(tables.scan)
    count = int(tables[scan + SCAN_COUNT])
    begin = rail_cell(tables, abscissa)
    back = 0.0
    if direction < 0:
        back = (1.0 + WIDEST) * tables[scan + SCAN_RAIL_PER_METRE]
    while level >= 0:
        cells = 1 << level
        first = node
        if direction < 0:
            first = node - cells
        if first >= 0 and first + cells < count:
            row = scan + SCAN_NODES + SCAN_ROW * first
            length = tables[row + SCAN_ROW * cells + ROW_Y] - tables[row + ROW_Y]
            bend, stretch = least_bend(tables, place, at, first, level, length, begin - back * length)
            if stretch < WIDEST:
                if largest_fall(slope, bend, length, stretch) <= excess:
                    return level
                if risen == 1 and slope >= 0.0 and slope + bend * length >= 0.0:
                    return level
        level -= 1
    return level


def least_bend(tables: Tables, place: Work, at: Place, first: int, level: int, length: float, u: float):
    """By how much the slope difference rises at least [1/m] over the 2^level cells, of ``length`` [m] together, that begin
    with scan node ``first``, and the share by which the outline is stretched there; the first tells nothing where the second is
    not below WIDEST.

    u : place in the rail's raster where they begin, in cells.
    """
    roll = fabs(at.sin_roll)
    stretch = ROLL_STRETCH * roll
    share = ROLL_BEND * roll
    row = int(tables.scan) + SCAN_NODES + SCAN_ROW * first
    if at.yawed:
        square = at.sin_yaw * at.sin_yaw
        stretch += STEEP_STRETCH * square + BEND_STRETCH * square * at.radius * tables[
            row + ROW_STEEPEST_BENDS + level]
        share += YAW_BEND * square
    bend = 0.0
    if stretch < WIDEST:
        rail = rail_row(tables, u)
        bend = tables[rail + RAIL_LEAST_BENDS + level]
        if length > FINE_CELL * float(1 << level):
            bend = tables[rail + RAIL_LEAST_BENDS + level + 1]
        wheel = tables[row + ROW_MOST_BENDS + level]
        bend -= stretch * fabs(bend) + wheel + share * fabs(wheel)
    return bend, stretch


def leave_minimum(tables: Tables, place: Work, at: Place, cell: int, direction: int, abscissa: float):
    """``clear_level`` from a minimum of the gap in ``cell``, at ``abscissa`` on the rail [m]: where the gap only rises.

    The stretch is counted from the cell's far node, so that it covers the whole cell.
    """
    row = int(tables.scan) + SCAN_NODES + SCAN_ROW * cell
    margin = (1.0 + WIDEST) * (tables[row + SCAN_ROW + ROW_Y] - tables[row + ROW_Y])
    node = cell
    start = abscissa - margin
    if direction < 0:
        node = cell + 1
        start = abscissa + margin
    return clear_level(tables, place, at, node, direction, start, 0.0, 0.0, LEVELS - 1, 0)


def largest_fall(slope: float, bend: float, length: float, stretch: float):
    """How far the gap can fall at most over ``length`` [m], with a slope that begins with ``slope`` and rises by no less
    than ``bend`` [1/m], on a wheel that is stretched by no more than the share ``stretch``."""
    if bend >= 0.0:
        if slope >= 0.0:
            return 0.0
        if -slope < bend * length:
            return 0.5 * (1.0 + stretch) * slope * slope / bend
    fall = -slope * length + stretch * fabs(slope) * length - 0.5 * (1.0 + stretch) * bend * length * length
    if fall < 0.0:
        fall = 0.0
    return fall


def bend_bounds(tables: Tables, place: Work, at: Place, cell: int, abscissa: float):
    """Bounds [1/m] of the gap's second derivative between scan nodes ``cell`` and ``cell`` + 1, the first of them above
    the rail's ``abscissa`` [m]: rail minus wheel."""
    rail = rail_row(tables, rail_cell(tables, abscissa))
    row = int(tables.scan) + SCAN_NODES + SCAN_ROW * cell
    share = ROLLED_SHARE
    if at.yawed:
        # how much the outline is stretched: |dY/dy - 1| is about sin^2(yaw) r |r''|
        sine = at.sin_yaw
        share = YAWED_SHARE + STRETCHED_SHARE * sine * sine * at.radius * tables[row + ROW_STEEPEST_BENDS]
    least_rail = tables[rail + RAIL_LEAST_BEND]
    most_rail = tables[rail + RAIL_MOST_BEND]
    least_wheel = tables[row + ROW_LEAST_BEND]
    most_wheel = tables[row + ROW_MOST_BENDS]
    least = least_rail - most_wheel - share * (fabs(least_rail) + fabs(most_wheel))
    most = most_rail - least_wheel + share * (fabs(most_rail) + fabs(least_wheel))
    if not most > 0.0:
        most = 0.0
    return least, most


def search_side(tables: Tables, work: Work, side: SideSearch, place: Work, at: Place, state: State,
                known: int):
    """Put the smallest gap of the side and its abscissa into SIDE_BEST, SIDE_BEST_Y; 1 if there is one, else 0.

    With ``known`` = 1 the two, and SIDE_BEST_RAIL, already hold a local minimum of this pose, and only a smaller one is
    looked for.
    """
    state.scan_count += 1.0
    if known == 1:
        cell = node_below(tables, side.best_y)
        ahead = leave_minimum(tables, place, at, cell, 1, side.best_rail)
        behind = leave_minimum(tables, place, at, cell, -1, side.best_rail)
        if ahead >= 0 and behind >= 0:
            march(tables, work, side, place, at, state, cell + (1 << ahead), 1)
            march(tables, work, side, place, at, state, cell + 1 - (1 << behind), -1)
            return 1
        node = cell
        gap, mismatch, abscissa = node_gap(tables, place, at, node)
        if above_rail(tables, abscissa) == 0:
            node = cell + 1
    else:
        side.best = LARGE_GAP
        node = probe(tables, work, side, place, at, state, PROBE_STRIDE)
        if node < 0:
            node = probe(tables, work, side, place, at, state, 1)
        if node < 0:
            return 0
    march(tables, work, side, place, at, state, node, 1)
    march(tables, work, side, place, at, state, node, -1)
    return 1


def probe(tables: Tables, work: Work, side: SideSearch, place: Work, at: Place, state: State, stride: int):
    """The node with the smallest gap among every ``stride``-th one above the rail, which becomes the best known; -1 if
    there is none."""
    found = -1
    node = 0
    count = int(tables[int(tables.scan) + SCAN_COUNT])
    while node < count:
        gap, mismatch, abscissa = node_gap(tables, place, at, node)
        state.gap_count += 1.0
        if above_rail(tables, abscissa) == 1:
            if gap < side.best:
                side.best = gap
                side.best_y = tables[int(tables.scan) + SCAN_NODES + SCAN_ROW * node + ROW_Y]
                found = node
        elif found >= 0 and is_gone(tables, place, at, node, 1, abscissa) == 1:
            return found
        node += stride
    return found


def march(tables: Tables, work: Work, side: SideSearch, place: Work, at: Place, state: State, node: int,
          direction: int):
    """Search from scan node ``node`` on in ``direction`` (1 or -1), up to the end of rail or wheel."""
    scan = int(tables.scan)
    count = int(tables[scan + SCAN_COUNT])
    level = LEVELS - 1
    gap_before = LARGE_GAP
    abscissa_before = 0.0
    skipped = 1
    off = 0
    while node >= 0 and node < count:
        gap, mismatch, abscissa = node_gap(tables, place, at, node)
        state.gap_count += 1.0
        if above_rail(tables, abscissa) == 0:
            if skipped == 0 and off == 0:
                search_end(tables, work, side, place, at, state, node - direction, direction, abscissa_before, abscissa)
            if is_gone(tables, place, at, node, direction, abscissa) == 1:
                return 0
            off = 1
            skipped = 0
            level = 0
        else:
            keep_best(work, side, tables[scan + SCAN_NODES + SCAN_ROW * node + ROW_Y], gap)
            if off == 1:
                search_end(tables, work, side, place, at, state, node, -direction, abscissa, abscissa_before)
            elif skipped == 0:
                if direction > 0:
                    bound_cell(tables, work, side, place, at, state, node - 1, gap_before, gap, abscissa_before)
                else:
                    bound_cell(tables, work, side, place, at, state, node, gap, gap_before, abscissa)
            off = 0
            gap_before = gap
            level = clear_level(tables, place, at, node, direction, abscissa, gap - side.best,
                                float(direction) * mismatch, level, 0)
            skipped = 1
            if level < 0:
                level = 0
                skipped = 0
        abscissa_before = abscissa
        node += direction * (1 << level)
        if off == 0 and level < LEVELS - 1:
            level += 1
    return 0


def is_gone(tables: Tables, place: Work, at: Place, node: int, direction: int, abscissa: float):
    """1 if the outline, beside the rail at scan node ``node``, does not come back above it further in ``direction``, else 0.

    Yaw moves a place of the wheel sideways by about sin^2(yaw) r times its slope, so that a steep flank can reach over a
    rail that ends below the flange root.
    """
    scan = int(tables.scan)
    rail = tables.rail
    apart = abscissa - rail.stop
    if direction < 0:
        apart = rail.start - abscissa
    reach = 0.0
    if at.yawed:
        sine = at.sin_yaw
        steep = tables[scan + SCAN_STEEPEST] + tables[scan + SCAN_NODES + SCAN_ROW * node + ROW_SLOPE]
        reach = REACH_SHARE * sine * sine * at.radius * steep + REACH_ROLL * fabs(at.sin_roll)
    gone = 0
    if apart > reach:
        gone = 1
    return gone


def bound_cell(tables: Tables, work: Work, side: SideSearch, place: Work, at: Place, state: State, cell: int,
               gap_low: float, gap_high: float, abscissa: float):
    """Search between the scan nodes ``cell`` and ``cell`` + 1 if the gap can be smaller there than the best one known.

    gap_low, gap_high : at the two nodes [m].
    abscissa : of the first one on the rail [m].
    """
    row = int(tables.scan) + SCAN_NODES + SCAN_ROW * cell
    low = tables[row + ROW_Y]
    high = tables[row + SCAN_ROW + ROW_Y]
    least, most = bend_bounds(tables, place, at, cell, abscissa)
    lowest = gap_low
    if gap_high < lowest:
        lowest = gap_high
    if lowest - most * (high - low) * (high - low) / 8.0 < side.best:
        search_cell(tables, work, side, place, at, state, least, most, low, high)
    return 0


def search_end(tables: Tables, work: Work, side: SideSearch, place: Work, at: Place, state: State, node: int,
               outward: int, abscissa: float, beyond: float):
    """Search between scan node ``node``, above the rail at ``abscissa`` [m], and the end of the rail, which lies before the next
    node at ``beyond`` [m]."""
    inner = tables[int(tables.scan) + SCAN_NODES + SCAN_ROW * node + ROW_Y]
    inside = rail_end(tables, place, at, node, outward)
    cell = node
    if outward < 0:
        cell = node - 1
    if beyond < abscissa:
        abscissa = tables.rail.start
    least, most = bend_bounds(tables, place, at, cell, abscissa)
    if inside < inner:
        search_cell(tables, work, side, place, at, state, -1.0, most, inside, inner)
    elif inside > inner:
        search_cell(tables, work, side, place, at, state, -1.0, most, inner, inside)
    return 0


def rail_end(tables: Tables, place: Work, at: Place, node: int, outward: int):
    """Wheel abscissa [m] above the end of the rail, which lies between scan node ``node``, above it, and the next one
    ``outward`` (1 or -1)."""
    row = int(tables.scan) + SCAN_NODES + SCAN_ROW * node
    inside = tables[row + ROW_Y]
    outside = tables[row + SCAN_ROW * outward + ROW_Y]
    while fabs(outside - inside) > END_SHARP:
        middle = 0.5 * (inside + outside)
        z, slope = height_slope(tables.wheel, middle)
        y_track, z_track, outline_slope = outline_point(at, middle, z, slope)
        if above_rail(tables, y_track - tables.rail_y) == 1:
            inside = middle
        else:
            outside = middle
    return inside


def scan_side(tables: Tables, work: Work, side: SideSearch, place: Work, at: Place, state: State,
              reach: float, abscissa: float):
    """List the local minima of the gap below ``reach`` [m] other than the known smallest one, which lies at ``abscissa`` on
    the rail [m].

    SIDE_FIRST and SIDE_LAST tell which entries of SIDE_PLACE, their wheel abscissae, and of SIDE_ABSCISSA, their places on
    the rail [m], hold them, by rising abscissa.
    """
    cell = node_below(tables, side.best_y)
    side.first = float(CANDIDATES)
    side.last = float(CANDIDATES - 1)
    ahead = leave_minimum(tables, place, at, cell, 1, abscissa)
    if ahead < 0:
        ahead = 0
    scan_on(tables, work, side, place, at, state, reach, cell + (1 << ahead), 1)
    behind = leave_minimum(tables, place, at, cell, -1, abscissa)
    if behind < 0:
        behind = 0
    scan_on(tables, work, side, place, at, state, reach, cell + 1 - (1 << behind), -1)
    return 0


def scan_on(tables: Tables, work: Work, side: SideSearch, place: Work, at: Place, state: State, reach: float,
            node: int, direction: int):
    """``scan_side`` from scan node ``node`` on in ``direction`` (1 or -1).

    Stretches are skipped in which the gap only rises, or stays above ``reach``.
    """
    nodes = int(tables.scan) + SCAN_NODES
    count = int(tables[int(tables.scan) + SCAN_COUNT])
    level = LEVELS - 1
    gap_before = 0.0
    mismatch_before = 0.0
    abscissa_before = 0.0
    skipped = 1
    off = 0
    while node >= 0 and node < count:
        gap, mismatch, abscissa = node_gap(tables, place, at, node)
        state.gap_count += 1.0
        y = tables[nodes + SCAN_ROW * node + ROW_Y]
        if above_rail(tables, abscissa) == 0:
            if skipped == 0 and off == 0:
                list_end(tables, work, side, place, at, state, reach, node - direction, direction, direction)
            if is_gone(tables, place, at, node, direction, abscissa) == 1:
                return 0
            off = 1
            skipped = 0
            level = 0
        else:
            if off == 1:
                list_end(tables, work, side, place, at, state, reach, node, -direction, direction)
            elif skipped == 0 and direction > 0:
                list_cell(tables, work, side, place, at, state, reach, node - 1, direction, abscissa_before,
                          tables[nodes + SCAN_ROW * (node - 1) + ROW_Y], y, gap_before, gap, mismatch_before, mismatch)
            elif skipped == 0:
                list_cell(tables, work, side, place, at, state, reach, node, direction, abscissa, y,
                          tables[nodes + SCAN_ROW * (node + 1) + ROW_Y], gap, gap_before, mismatch, mismatch_before)
            off = 0
            level = clear_level(tables, place, at, node, direction, abscissa, gap - reach, float(direction) * mismatch, level,
                                1)
            skipped = 1
            if level < 0:
                level = 0
                skipped = 0
            gap_before = gap
            mismatch_before = mismatch
            abscissa_before = abscissa
        node += direction * (1 << level)
        if off == 0 and level < LEVELS - 1:
            level += 1
    return 0


def list_end(tables: Tables, work: Work, side: SideSearch, place: Work, at: Place, state: State, reach: float,
             node: int, outward: int, direction: int):
    """``list_cell`` between scan node ``node`` and the end of the rail before the next one ``outward`` (1 or -1)."""
    inner = tables[int(tables.scan) + SCAN_NODES + SCAN_ROW * node + ROW_Y]
    end = rail_end(tables, place, at, node, outward)
    low = min(inner, end)
    high = max(inner, end)
    cell = node
    if outward < 0:
        cell = node - 1
    if low < high:
        gap_low, mismatch_low, rate = vertical_gap(tables, at, low)
        gap_high, mismatch_high, rate = vertical_gap(tables, at, high)
        state.gap_count += 2.0
        list_cell(tables, work, side, place, at, state, reach, cell, direction, rail_place(tables, place, at, low), low,
                  high, gap_low, gap_high, mismatch_low, mismatch_high)
    return 0


def rail_place(tables: Tables, place: Work, at: Place, y: float):
    """Abscissa on the rail [m] below wheel abscissa ``y`` [m]."""
    z, slope = height_slope(tables.wheel, y)
    y_track, z_track, outline_slope = outline_point(at, y, z, slope)
    return y_track - tables.rail_y


def list_cell(tables: Tables, work: Work, side: SideSearch, place: Work, at: Place, state: State, reach: float,
              cell: int, direction: int, abscissa: float, low: float, high: float, gap_low: float, gap_high: float,
              mismatch_low: float, mismatch_high: float):
    """List the local minima between ``low`` and ``high`` [m], which lie between the scan nodes ``cell`` and ``cell`` + 1.

    abscissa : of ``low`` on the rail [m].
    gap_low, gap_high, mismatch_low, mismatch_high : at both.
    """
    nothing, most = bend_bounds(tables, place, at, cell, abscissa)
    least, stretch = least_bend(tables, place, at, cell, 0, high - low, rail_cell(tables, abscissa))
    if not stretch < WIDEST:
        # the outline may be folded there
        least = nothing
        gap_low, mismatch_low, rate = vertical_gap(tables, at, low)
        gap_high, mismatch_high, rate = vertical_gap(tables, at, high)
        state.gap_count += 2.0
    stack = offset(side, work) + SIDE_STACK
    push_cell(work.raw, stack, low, high, gap_low, gap_high, mismatch_low, mismatch_high)
    depth = 1
    while depth > 0:
        depth -= 1
        top = stack + 6 * depth
        low = work[top]
        high = work[top + 1]
        gap_low = work[top + 2]
        gap_high = work[top + 3]
        mismatch_low = work[top + 4]
        mismatch_high = work[top + 5]
        width = high - low
        if min(gap_low, gap_high) - most * width * width / 8.0 < reach:
            folded = mismatch_low == FOLDED or mismatch_high == FOLDED
            turns = mismatch_low < 0.0 and mismatch_high >= 0.0 and not folded
            if turns and (least > 0.0 or width <= LISTED_ONE):
                y, gap = refine_minimum(tables, place, at, state, low, high, mismatch_low, mismatch_high, LISTED)
                if gap < reach:
                    list_minimum(work, side, y, rail_place(tables, place, at, y), direction)
            elif width > LISTED and (folded or is_steady(least, most, width, mismatch_low, mismatch_high) == 0):
                middle = 0.5 * (low + high)
                gap, mismatch, rate = vertical_gap(tables, at, middle)
                state.gap_count += 1.0
                # the one that comes first in ``direction`` on top
                if direction > 0:
                    push_cell(work.raw, top, middle, high, gap, gap_high, mismatch, mismatch_high)
                    push_cell(work.raw, top + 6, low, middle, gap_low, gap, mismatch_low, mismatch)
                else:
                    push_cell(work.raw, top, low, middle, gap_low, gap, mismatch_low, mismatch)
                    push_cell(work.raw, top + 6, middle, high, gap, gap_high, mismatch, mismatch_high)
                depth += 2
    return 0


def is_steady(least: float, most: float, width: float, mismatch_low: float, mismatch_high: float):
    """1 if the gap certainly only rises, or only falls, over a ``width`` [m] in which the slope difference rises by no less
    than ``least`` and no more than ``most`` [1/m], else 0."""
    steady = 0
    if mismatch_low >= 0.0 and least_slope(least, most, width, mismatch_low, mismatch_high) >= 0.0:
        steady = 1
    if mismatch_high <= 0.0 and least_slope(least, most, width, -mismatch_high, -mismatch_low) >= 0.0:
        steady = 1
    return steady


def least_slope(least: float, most: float, width: float, first: float, last: float):
    """The smallest slope that is possible over a ``width`` [m] between ``first`` and ``last`` at its ends, where it rises by
    no less than ``least`` and no more than ``most`` [1/m]: where the lines from both ends meet."""
    lowest = min(first, last)
    if least < 0.0:
        lowest = first + least * width
        if most > 0.0:
            meet = (last - first - most * width) / (least - most)
            lowest = first + least * min(max(meet, 0.0), width)
    return lowest


def list_minimum(work: Work, side: SideSearch, y: float, abscissa: float, direction: int):
    """Add the minimum at ``y`` [m] to the list of ``scan_side``, at the end for ``direction`` = 1, else at the beginning."""
    entry = side.last + 1
    if direction < 0:
        entry = side.first - 1
    if entry >= 0 and entry < 2 * CANDIDATES:
        side.place[entry] = y
        side.abscissa[entry] = abscissa
        if direction < 0:
            side.first = float(entry)
        else:
            side.last = float(entry)
    return 0


def search_cell(tables: Tables, work: Work, side: SideSearch, place: Work, at: Place, state: State,
                least: float, most: float, first: float, last: float):
    """Local minima between ``first`` and ``last`` [m]: halve while a better value is possible, refine where the slope
    turns.  ``least`` and ``most`` bound the second derivative."""
    stack = offset(side, work) + SIDE_STACK
    gap_low, mismatch_low, rate = vertical_gap(tables, at, first)
    gap_high, mismatch_high, rate = vertical_gap(tables, at, last)
    state.gap_count += 2.0
    push_cell(work.raw, stack, first, last, gap_low, gap_high, mismatch_low, mismatch_high)
    depth = 1
    while depth > 0:
        depth -= 1
        top = stack + 6 * depth
        low = work[top]
        high = work[top + 1]
        gap_low = work[top + 2]
        gap_high = work[top + 3]
        mismatch_low = work[top + 4]
        mismatch_high = work[top + 5]
        width = high - low
        lowest = gap_low
        keep_best(work, side, low, gap_low)
        if gap_high < gap_low:
            lowest = gap_high
            keep_best(work, side, high, gap_high)
        if lowest - most * width * width / 8.0 < side.best:
            folded = mismatch_low == FOLDED or mismatch_high == FOLDED
            turns = mismatch_low < 0.0 and mismatch_high >= 0.0 and not folded
            steady = is_steady(least, most, width, mismatch_low, mismatch_high) == 1 and not folded
            if turns and (least > 0.0 or width <= NARROW):
                y, gap = refine_minimum(tables, place, at, state, low, high, mismatch_low, mismatch_high, SHARP)
                keep_refined(work, side, y, gap, width)
            elif width > NARROW and not steady and (folded or not least > 0.0):
                middle = 0.5 * (low + high)
                gap, mismatch, rate = vertical_gap(tables, at, middle)
                state.gap_count += 1.0
                push_cell(work.raw, top, low, middle, gap_low, gap, mismatch_low, mismatch)
                push_cell(work.raw, top + 6, middle, high, gap, gap_high, mismatch, mismatch_high)
                depth += 2
    return 0


def push_cell(work: 'float[:]', top: int, low: float, high: float, gap_low: float, gap_high: float, mismatch_low: float,
              mismatch_high: float):
    """Write a cell to the stack at ``top``."""
    work[top] = low
    work[top + 1] = high
    work[top + 2] = gap_low
    work[top + 3] = gap_high
    work[top + 4] = mismatch_low
    work[top + 5] = mismatch_high
    return 0


def keep_best(work: Work, side: SideSearch, y: float, gap: float):
    """Keep (y, gap) if it is the side's best so far, by more than rounding: a node beside a place of contact is none."""
    if gap < side.best - ROUNDING:
        side.best = gap
        side.best_y = y
    return 0


def keep_refined(work: Work, side: SideSearch, y: float, gap: float, width: float):
    """Keep (y, gap), a place of contact, if it is the side's best so far: before a node within ``width`` [m] that has the same
    gap but for the last bits."""
    allowed = side.best
    if fabs(y - side.best_y) < width:
        allowed += ROUNDING
    if gap < allowed:
        side.best = gap
        side.best_y = y
    return 0


def refine_minimum(tables: Tables, place: Work, at: Place, state: State, low: float, high: float,
                   mismatch_low: float, mismatch_high: float, sharp: float):
    """Abscissa [m], to ``sharp`` [m], and gap [m] where the slope difference vanishes between ``low`` and ``high``:
    bracketed Newton."""
    y = low - mismatch_low * (high - low) / (mismatch_high - mismatch_low)
    gap = 0.0
    for i in range(60):
        gap, mismatch, rate = vertical_gap(tables, at, y)
        state.gap_count += 1.0
        if mismatch < 0.0:
            low = y
        else:
            high = y
        following = 0.5 * (low + high)
        if rate > 0.0:
            move = -mismatch / rate
            if fabs(move) < sharp:
                break
            if y + move > low and y + move < high:
                following = y + move
        if fabs(following - y) < sharp:
            break
        y = following
    return y, gap
