"""The normal contact of one side: estimate, regions, nodes, levels, patches.

1. estimate the penetration from the force and the width of the interpenetration,
2. find the regions that it reaches, and the half-width of each one's interpenetration, which sets
3. spacing and window of the nodes, on which
4. the force is met.

The estimate depends on pose and force alone and moves smoothly with them, and so does the result.
"""

from math import isfinite, log, sqrt
from typing import Final

from ..contact.contact_plane import is_yawed, ridge_place
from ..contact.overlaps import gather_overlaps, keep_deepest
from ..contact.planes import enter_plane, give_planes, leave_plane, line_up
from ..contact.regions import FAR, bound_regions, find_regions, open_contact_region, zone_width
from ..layout import (
    LATERAL_ADAPTIVE,
    LOAD_VERTICAL,
    MODEL_ANALYN_STRIP,
    MODEL_HERTZ,
    REGION_LIMIT,
    SEPARATION_CHORD,
    SEPARATION_VERTICAL,
    SideOutputs,
    SideSearch,
    State,
    Tables,
    Work,
)
from ..patch.strip_patches import gather_strips
from ..surface.profile_table import height_slope
from .analyn import FORCE_SHARP, solve_levels
from .hertz import hertz_stiffness, table_value
from .hertz_contact import solve_hertz
from .node_patches import fill_from_nodes
from .nodes import FLOOR, NODE_LENGTH, NODE_LINE, NODE_RISE, lay_nodes, node_field, weigh_nodes
from .strips import correct_strips

#: Window of the lateral curvature as a share of the half-width of the interpenetration (docs/method.md), which is measured
WINDOW: Final[float] = 4.0 / 15.0
#: at this share of the level: at the level itself a flat end of the profile would count as all of its width.
MEASURED: Final[float] = 0.9
#: The narrower half of a region counts as at most so many times narrower than the mean.
NARROWER: Final[float] = 4.0
#: Nodes are laid until the gap has risen to this share of the level, or before it where (1 + beta) g has risen to
COVER: Final[float] = 1.1
#: this share; the estimate of the level is within 12 % for nine of ten poses.
SPREAD: Final[float] = 1.25
#: The same where strips follow, which lie beyond ANALYN's patch too (strips.BEYOND).
STRIP_SPREAD: Final[float] = 3.0
#: Lateral over longitudinal curvature of the first guess; penetration goes with (A + B)^(1/3).
TYPICAL_RATIO: Final[float] = 2.0
#: Largest lateral over longitudinal curvature of the estimate; a width cut short by a profile's end gives no curvature.
CEILING: Final[float] = 1e3
#: Regions and nodes are laid anew while the estimate was off by more than this factor.
ESTIMATE_FACTOR: Final[float] = 1.5
ESTIMATE_REPEATS: Final[int] = 4
COVER_REPEATS: Final[int] = 6
#: Smallest mean half-width, as a share of the half-length sqrt(level R_x), of a region that an end nearly closes.
#: Second derivative of the gap, over 1/R_x, that a first half-width is guessed with.
LEAST_BEND: Final[float] = 1.0
MOST_BEND: Final[float] = 100.0
NARROWEST: Final[float] = 0.01
WIDEST: Final[float] = 110.0         # nodes that a region has room for on one side


def guess_penetration(force: float, A: float, contact_modulus: float):
    """((3 N / 4 E*)^2 (A + B))^(1/3) [m], Hertz's eq. (2.8) with r = 1 and a typical B."""
    share = 0.75 * force / contact_modulus
    return (share * share * (1.0 + TYPICAL_RATIO) * A) ** (1.0 / 3.0)


def measure_widths(tables: Tables, work: Work, state: State, region: int, level: float):
    """Half-widths of the region's interpenetration at ``level`` [m], the lateral curvatures on both sides that follow from
    them, and the station its load is thought to act at."""
    block = work.regions[region]
    # the first guess: the gap's own second derivative, as far as it is a usual one
    bend = block.bend
    if bend < LEAST_BEND * block.curvature:
        bend = LEAST_BEND * block.curvature
    if bend > MOST_BEND * block.curvature:
        bend = MOST_BEND * block.curvature
    low = sqrt(2.0 * level / bend)
    high = low
    if block.width_level > 0.0:
        grown = sqrt(level / block.width_level)
        low = block.width_low * grown
        high = block.width_high * grown
    high = zone_width(tables, work, state, block, 1.0, level, high)
    high_reached = block.reached
    slant = 0.0
    start = work.frame.tracer_station
    yawed = is_yawed(work)
    if yawed == 1:
        slant = ridge_place(tables, work, work.frame.tracer_wheel)
    if not block.width_level > 0.0:
        low = high
    low = zone_width(tables, work, state, block, -1.0, level, low)
    if yawed == 1:
        slant -= ridge_place(tables, work, work.frame.tracer_wheel)
        if start > work.frame.tracer_station:
            block.slant = slant / (start - work.frame.tracer_station)
    block.side_high = side_curvature(high_reached, high, 0.5 * (low + high))
    block.side_low = side_curvature(block.reached, low, 0.5 * (low + high))
    block.width_high = high
    block.width_low = low
    block.width_level = level
    block.middle = block.station + 0.5 * (high - low)
    return 0


def side_curvature(reached: float, own: float, mean: float):
    """g / w^2 [1/m] where the gap has risen to g = ``reached`` at the half-width w = ``own``, enlarged where that side is
    the narrower, up to NARROWER times."""
    curvature = 0.0
    if own > 0.0:
        ratio = mean / own
        if ratio > NARROWER:
            ratio = NARROWER
        curvature = reached / (own * own) * ratio * ratio
    return curvature


def zone_share(tables: Tables, A: float, side: float):
    """Share of the level up to which the gap is laid with nodes on a side with lateral curvature ``side`` [1/m]: strips
    are loaded while (1 + beta) g is below the level.  With prepared curvatures 1 + beta may fall to 1."""
    if side < FLOOR * A:
        side = FLOOR * A
    spread = SPREAD
    if int(tables.normal_model) == MODEL_ANALYN_STRIP:
        spread = STRIP_SPREAD
    share = spread / table_value(tables.raw, int(tables.hertz), 0, log(A / side))
    if share > COVER or int(tables.lateral) != LATERAL_ADAPTIVE:
        share = COVER
    return share


def node_stride(tables: Tables):
    """Every so many of the nodes are traced on the profiles.

    All of them are where curvatures are read there, where chords lead to them, and for vertical distances: on a steep side
    these rise too fast for a cubic over several nodes, which falls below zero before.
    """
    stride = int(tables.stride)
    kind = int(tables.separation)
    if int(tables.lateral) != LATERAL_ADAPTIVE or kind == SEPARATION_CHORD or kind == SEPARATION_VERTICAL:
        stride = 1
    return stride


def prepare_regions(tables: Tables, work: Work, state: State, count: int, enlarge: float):
    """Widths, nodes and coefficients of all regions at their levels times ``enlarge``."""
    window = int(tables.nodes * WINDOW + 0.5)
    stride = node_stride(tables)
    for i in range(count):
        block = work.regions[i]
        level = block.level
        enter_plane(work, i)
        measure_widths(tables, work, state, i, MEASURED * level)
        mean = 0.5 * (block.width_low + block.width_high)
        widest = block.width_low
        if block.width_high > widest:
            widest = block.width_high
        least = NARROWEST * sqrt(level / block.curvature)
        if mean < least:
            mean = least
        spacing = mean / tables.nodes
        if widest * enlarge > WIDEST * spacing:
            spacing = widest * enlarge / WIDEST
        A = 0.5 * block.curvature
        low_reach = level * enlarge * zone_share(tables, A, block.side_low)
        high_reach = level * enlarge * zone_share(tables, A, block.side_high)
        if work.frame.pressed and is_yawed(work) == 1:
            work.frame.blur = spacing * float(stride) * work.frame.wheel_cos
        lay_nodes(tables, work, state, i, low_reach, high_reach, spacing, window, stride)
        weigh_nodes(tables, work, i, window)
        if work.frame.pressed or int(tables.load) == LOAD_VERTICAL:
            mean_normal(tables, work, i, level)
        leave_plane(work, i)
        block.square = level / work[node_field(i, NODE_LENGTH)]
    return 0


def rail_per_station(tables: Tables, work: Work, abscissa: float):
    """Change of the rail's abscissa per station of the open frame [-]."""
    height, slope = height_slope(tables.raw, int(tables.rail), abscissa)
    along = sqrt(1.0 + slope * slope)
    if not work.frame.pressed:
        along = work.frame.cos + slope * work.frame.sin
    return 1.0 / along


def mean_normal(tables: Tables, work: Work, region: int, level: float):
    """Let the force of a region act along the mean of the rail's normals, weighted by the line load at ``level`` [m].

    The rail is followed from node to node by the midpoint rule; nodes of a pressed wheel lie along it, others in the plane.
    """
    block = work.regions[region]
    rises = node_field(region, NODE_RISE)
    lines = node_field(region, NODE_LINE)
    total = 0.0
    cosines = 0.0
    sines = 0.0
    for direction in range(-1, 2, 2):
        x = block.rail
        step = float(direction) * block.spacing
        last = block.last
        if direction < 0:
            last = -block.first
        for k in range(last + 1):
            height, slope = height_slope(tables.raw, int(tables.rail), x)
            cosine = 1.0 / sqrt(1.0 + slope * slope)
            weight = work[lines + direction * k] * (level - work[rises + direction * k])
            if weight <= 0.0:
                break
            if k == 0:
                weight *= 0.5
            total += weight
            cosines += weight * cosine
            sines += weight * slope * cosine
            x += step * rail_per_station(tables, work, x + 0.5 * step * rail_per_station(tables, work, x))
    if total > 0.0:
        block.cos = cosines / total
        block.sin = sines / total
        if int(tables.load) == LOAD_VERTICAL:
            block.share = block.cos
    return 0


def start_levels(work: Work, count: int, penetration: float):
    """Levels before any interaction is known; a region that is hardly reached still gets nodes for a tenth of it."""
    for i in range(count):
        block = work.regions[i]
        level = block.turn * penetration - block.gap
        if level < 0.1 * penetration:
            level = 0.1 * penetration
        block.level = level
    return 0


def covered(work: Work, count: int):
    """1 if no region is loaded at an end of its nodes other than its bound, else 0."""
    result = 1
    for i in range(count):
        block = work.regions[i]
        rises = node_field(i, NODE_RISE)
        level = block.level
        low = block.low
        high = block.high
        if work.frame.pressed:
            # its bounds may be the rail's ends, far away
            if low < block.station + block.spacing * block.first:
                low = -FAR
            if high > block.station + block.spacing * block.last:
                high = FAR
        if level > work[rises + block.last] and high >= FAR:
            result = 0
        if level > work[rises + block.first] and low <= -FAR:
            result = 0
    return result


def estimate_penetration(tables: Tables, work: Work, state: State, force: float):
    """Hertz's penetration [m] for the interpenetration's own width: B = level / width^2 at a guessed level.

    Exact for constant curvatures; within 12 % for nine of ten poses of S1002 on UIC60.
    """
    block = work.regions[0]
    A = 0.5 * block.curvature
    guess = guess_penetration(force, A, tables.contact_modulus)
    measure_widths(tables, work, state, 0, guess)
    width = 0.5 * (block.width_low + block.width_high)
    B = FLOOR * A
    if guess > CEILING * A * width * width:
        B = CEILING * A
    elif guess > B * width * width:
        B = guess / (width * width)
    stiffness = hertz_stiffness(tables.raw, int(tables.hertz), A, B, tables.contact_modulus)
    return (force / stiffness) ** (2.0 / 3.0)


def gather_regions(tables: Tables, work: Work, state: State, side: SideSearch, penetration: float):
    """Open the regions that ``penetration`` [m] reaches, with their bounds and first levels; their number."""
    for i in range(REGION_LIMIT):
        work.regions[i].width_level = 0.0
        work.regions[i].slant = 0.0
    count = 1
    if work.frame.pressed:
        count = gather_overlaps(tables, work, state)
    else:
        open_contact_region(tables, work, state)
        count = find_regions(tables, work, state, side, penetration)
        count = bound_regions(tables, work, state, count, penetration)
        give_planes(tables, work, state, count)
    start_levels(work, count, penetration)
    return count


def first_penetration(tables: Tables, work: Work, state: State, force: float):
    """What the penetration [m] under the prescribed ``force`` [N] is estimated to be."""
    open_contact_region(tables, work, state)
    work.regions[0].width_level = 0.0
    return estimate_penetration(tables, work, state, force / work.regions[0].share)


def solve_estimated(tables: Tables, work: Work, state: State, side: SideSearch, force: float, estimate: float,
                    by_penetration: int):
    """Penetration [m] and number of regions, with regions and nodes laid for the ``estimate`` of it; third value 1 when
    met, else 0."""
    count = gather_regions(tables, work, state, side, estimate)
    penetration, met = solve_fine(tables, work, state, count, force, estimate, by_penetration)
    if met == 0 and count > 1:
        # regions so close that pressing on each other has no fixed point are one region
        count = 1
        if work.frame.pressed:
            keep_deepest(work.raw)
            gather_overlaps(tables, work, state)
        else:
            open_contact_region(tables, work, state)
        start_levels(work, count, estimate)
        penetration, met = solve_fine(tables, work, state, count, force, estimate, by_penetration)
    return penetration, count, met


def solve_analyn(tables: Tables, work: Work, state: State, side: SideSearch, force: float, prescribed: float):
    """Penetration [m] and number of regions under ``force`` [N], or at ``prescribed`` penetration [m] if that is a
    number; third value 1 when met, else 0.  A pressed wheel has its regions where it stands."""
    by_penetration = 0
    penetration = prescribed
    if isfinite(prescribed):
        by_penetration = 1
    if work.frame.pressed:
        penetration, count, met = solve_estimated(tables, work, state, side, force, work.frame.depth, by_penetration)
        return penetration, count, met
    if by_penetration == 0:
        penetration = first_penetration(tables, work, state, force)
    count = 1
    met = 0
    for repeat in range(ESTIMATE_REPEATS):
        estimate = penetration
        penetration, count, met = solve_estimated(tables, work, state, side, force, estimate, by_penetration)
        if penetration < ESTIMATE_FACTOR * estimate and ESTIMATE_FACTOR * penetration > estimate:
            break
    return penetration, count, met


def solve_fine(tables: Tables, work: Work, state: State, count: int, force: float, penetration: float,
               by_penetration: int):
    """Penetration [m] on fine nodes laid over the regions' levels, laid again where the patch outgrows them; and 1 when
    met, else 0."""
    start = penetration
    enlarge = 1.0
    met = 0
    for repeat in range(COVER_REPEATS):
        prepare_regions(tables, work, state, count, enlarge)
        penetration, met = solve_levels(tables, work, state, count, force, start, by_penetration, FORCE_SHARP)
        if met == 0:
            return start, met
        if covered(work, count) == 1:
            break
        if repeat < COVER_REPEATS - 1:
            enlarge *= 1.4
            start = penetration
            laid = penetration
            if work.frame.pressed:
                # nodes stay where the wheel stands; there are only more of them
                laid = work.frame.depth
            start_levels(work, count, laid)
    return penetration, met


def solve_normal(tables: Tables, work: Work, state: State, side: SideSearch, outputs: SideOutputs, force: float,
                 prescribed: float):
    """Solve the normal contact of the side whose frame is open, under ``force`` [N] or at ``prescribed`` penetration [m] if that
    is a number, into the solved patches; penetration [m], number of regions, and 1 when the force is satisfied, else 0."""
    met = 1
    count = 1
    if int(tables.normal_model) == MODEL_HERTZ:
        line_up(tables, work, 1)
        penetration = solve_hertz(tables, outputs, work.regions[0], work.solved, force, prescribed)
        return penetration, count, met
    penetration, count, met = solve_analyn(tables, work, state, side, force, prescribed)
    if met == 1:
        line_up(tables, work, count)
        if int(tables.normal_model) == MODEL_ANALYN_STRIP:
            by_penetration = 0
            if isfinite(prescribed):
                by_penetration = 1
            penetration, strips, met = correct_strips(tables, work, state, count, force, penetration, by_penetration)
            if met == 1:
                gather_strips(work, strips)
        else:
            fill_from_nodes(work.regions, work.nodes, work.solved, count)
    return penetration, count, met
