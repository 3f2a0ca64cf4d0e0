"""The normal contact of one side: estimate, regions, nodes, levels, patches.

1. estimate the penetration from the force and the width of the interpenetration,
2. find the regions that it reaches, and the half-width of each one's interpenetration, which sets
3. spacing and window of the nodes, on which
4. the force is met.

The estimate depends on pose and force alone and moves smoothly with them, and so does the result.
"""

from math import isfinite, log, pi, sqrt
from typing import Final

from .analyn import FORCE_SHARP, solve_levels
from ..contact.contact_plane import (FRAME_BLUR, FRAME_COS, FRAME_DEPTH, FRAME_PRESSED, FRAME_SIN, FRAME_WHEEL_COS, TRACER_STATION,
                            TRACER_WHEEL, is_yawed, ridge_place)
from .hertz import hertz_coefficients, hertz_stiffness, table_value
from ..layout import (DEPTH_ALL, LATERAL_ADAPTIVE, LOAD_VERTICAL, MODEL_ANALYN_STRIP, MODEL_HERTZ, PATCH_AREA,
                     PATCH_CENTROID, PATCH_CONTACT_ANGLE, PATCH_LENGTH, PATCH_MAX_PRESSURE, PATCH_NORMAL_FORCE,
                     PATCH_WIDTH, REGION_LIMIT, SEPARATION_CHORD, SEPARATION_VERTICAL, SET_CONTACT_MODULUS, SET_DEPTH,
                     SET_HERTZ, SET_LATERAL, SET_LOAD, SET_NODES, SET_NORMAL_MODEL, SET_RAIL, SET_SEPARATION, SET_STATIONS,
                     SET_STRIDE, SIDE_AREA, SIDE_CONTACT_ANGLE, SIDE_CURVATURE_X, SIDE_CURVATURE_Y, SIDE_MAX_PRESSURE,
                     SIDE_NORMAL_FORCE, SIDE_PATCH, SIDE_PATCH_CENTROID, SIDE_PATCH_COUNT, SIDE_PATCH_LENGTH,
                     SIDE_PATCH_WIDTH, SIDE_PENETRATION)
from .nodes import FLOOR, NODE_LENGTH, NODE_LINE, NODE_RISE, lay_nodes, node_field, weigh_nodes
from ..patch.outline import outline_place
from ..contact.overlaps import gather_overlaps, keep_deepest
from ..patch.patches import gather_islands, write_outline, write_patches
from ..contact.planes import enter_plane, give_planes, leave_plane
from ..surface.profile_table import height_slope
from ..contact.regions import (FAR, REGION_BEND, REGION_CARRIED, REGION_COS, REGION_CURVATURE, REGION_FIRST, REGION_GAP,
                      REGION_HIGH, REGION_LAST, REGION_LEVEL, REGION_LOW, REGION_MIDDLE, REGION_MOMENT, REGION_RAIL,
                      REGION_REACHED, REGION_SHARE, REGION_SIDE_HIGH, REGION_SIDE_LOW, REGION_SIN, REGION_SLANT,
                      REGION_SPACING, REGION_SQUARE, REGION_STATION, REGION_STIFFNESS, REGION_TURN, REGION_WIDTH_HIGH,
                      REGION_WIDTH_LEVEL, REGION_WIDTH_LOW, bound_regions, find_regions, open_contact_region,
                      region_block, zone_width)
from ..patch.strip_patches import gather_strips, write_strip_outline
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


def measure_widths(tables: 'float[:]', work: 'float[:]', state: 'float[:]', region: int, level: float):
    """Half-widths of the region's interpenetration at ``level`` [m], the lateral curvatures on both sides that follow from
    them, and the station its load is thought to act at."""
    block = region_block(region)
    # the first guess: the gap's own second derivative, as far as it is a usual one
    bend = work[block + REGION_BEND]
    if bend < LEAST_BEND * work[block + REGION_CURVATURE]:
        bend = LEAST_BEND * work[block + REGION_CURVATURE]
    if bend > MOST_BEND * work[block + REGION_CURVATURE]:
        bend = MOST_BEND * work[block + REGION_CURVATURE]
    low = sqrt(2.0 * level / bend)
    high = low
    if work[block + REGION_WIDTH_LEVEL] > 0.0:
        grown = sqrt(level / work[block + REGION_WIDTH_LEVEL])
        low = work[block + REGION_WIDTH_LOW] * grown
        high = work[block + REGION_WIDTH_HIGH] * grown
    high = zone_width(tables, work, state, block, 1.0, level, high)
    high_reached = work[block + REGION_REACHED]
    slant = 0.0
    start = work[TRACER_STATION]
    yawed = is_yawed(work)
    if yawed == 1:
        slant = ridge_place(tables, work, work[TRACER_WHEEL])
    if not work[block + REGION_WIDTH_LEVEL] > 0.0:
        low = high
    low = zone_width(tables, work, state, block, -1.0, level, low)
    if yawed == 1:
        slant -= ridge_place(tables, work, work[TRACER_WHEEL])
        if start > work[TRACER_STATION]:
            work[block + REGION_SLANT] = slant / (start - work[TRACER_STATION])
    work[block + REGION_SIDE_HIGH] = side_curvature(high_reached, high, 0.5 * (low + high))
    work[block + REGION_SIDE_LOW] = side_curvature(work[block + REGION_REACHED], low, 0.5 * (low + high))
    work[block + REGION_WIDTH_HIGH] = high
    work[block + REGION_WIDTH_LOW] = low
    work[block + REGION_WIDTH_LEVEL] = level
    work[block + REGION_MIDDLE] = work[block + REGION_STATION] + 0.5 * (high - low)
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


def zone_share(tables: 'float[:]', A: float, side: float):
    """Share of the level up to which the gap is laid with nodes on a side with lateral curvature ``side`` [1/m]: strips
    are loaded while (1 + beta) g is below the level.  With prepared curvatures 1 + beta may fall to 1."""
    if side < FLOOR * A:
        side = FLOOR * A
    spread = SPREAD
    if int(tables[SET_NORMAL_MODEL]) == MODEL_ANALYN_STRIP:
        spread = STRIP_SPREAD
    share = spread / table_value(tables, int(tables[SET_HERTZ]), 0, log(A / side))
    if share > COVER or int(tables[SET_LATERAL]) != LATERAL_ADAPTIVE:
        share = COVER
    return share


def node_stride(tables: 'float[:]'):
    """Every so many of the nodes are traced on the profiles.

    All of them are where curvatures are read there, where chords lead to them, and for vertical distances: on a steep side
    these rise too fast for a cubic over several nodes, which falls below zero before.
    """
    stride = int(tables[SET_STRIDE])
    kind = int(tables[SET_SEPARATION])
    if int(tables[SET_LATERAL]) != LATERAL_ADAPTIVE or kind == SEPARATION_CHORD or kind == SEPARATION_VERTICAL:
        stride = 1
    return stride


def prepare_regions(tables: 'float[:]', work: 'float[:]', state: 'float[:]', count: int, enlarge: float):
    """Widths, nodes and coefficients of all regions at their levels times ``enlarge``."""
    window = int(tables[SET_NODES] * WINDOW + 0.5)
    stride = node_stride(tables)
    for i in range(count):
        block = region_block(i)
        level = work[block + REGION_LEVEL]
        enter_plane(work, i)
        measure_widths(tables, work, state, i, MEASURED * level)
        mean = 0.5 * (work[block + REGION_WIDTH_LOW] + work[block + REGION_WIDTH_HIGH])
        widest = work[block + REGION_WIDTH_LOW]
        if work[block + REGION_WIDTH_HIGH] > widest:
            widest = work[block + REGION_WIDTH_HIGH]
        least = NARROWEST * sqrt(level / work[block + REGION_CURVATURE])
        if mean < least:
            mean = least
        spacing = mean / tables[SET_NODES]
        if widest * enlarge > WIDEST * spacing:
            spacing = widest * enlarge / WIDEST
        A = 0.5 * work[block + REGION_CURVATURE]
        low_reach = level * enlarge * zone_share(tables, A, work[block + REGION_SIDE_LOW])
        high_reach = level * enlarge * zone_share(tables, A, work[block + REGION_SIDE_HIGH])
        if work[FRAME_PRESSED] == 1.0 and is_yawed(work) == 1:
            work[FRAME_BLUR] = spacing * float(stride) * work[FRAME_WHEEL_COS]
        lay_nodes(tables, work, state, i, low_reach, high_reach, spacing, window, stride)
        weigh_nodes(tables, work, i, window)
        if work[FRAME_PRESSED] == 1.0 or int(tables[SET_LOAD]) == LOAD_VERTICAL:
            mean_normal(tables, work, i, level)
        leave_plane(work, i)
        work[block + REGION_SQUARE] = level / work[node_field(i, NODE_LENGTH)]
    return 0


def rail_per_station(tables: 'float[:]', work: 'float[:]', abscissa: float):
    """Change of the rail's abscissa per station of the open frame [-]."""
    height, slope = height_slope(tables, int(tables[SET_RAIL]), abscissa)
    along = sqrt(1.0 + slope * slope)
    if work[FRAME_PRESSED] == 0.0:
        along = work[FRAME_COS] + slope * work[FRAME_SIN]
    return 1.0 / along


def mean_normal(tables: 'float[:]', work: 'float[:]', region: int, level: float):
    """Let the force of a region act along the mean of the rail's normals, weighted by the line load at ``level`` [m].

    The rail is followed from node to node by the midpoint rule; nodes of a pressed wheel lie along it, others in the plane.
    """
    block = region_block(region)
    rises = node_field(region, NODE_RISE)
    lines = node_field(region, NODE_LINE)
    total = 0.0
    cosines = 0.0
    sines = 0.0
    for direction in range(-1, 2, 2):
        x = work[block + REGION_RAIL]
        step = float(direction) * work[block + REGION_SPACING]
        last = int(work[block + REGION_LAST])
        if direction < 0:
            last = -int(work[block + REGION_FIRST])
        for k in range(last + 1):
            height, slope = height_slope(tables, int(tables[SET_RAIL]), x)
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
        work[block + REGION_COS] = cosines / total
        work[block + REGION_SIN] = sines / total
        if int(tables[SET_LOAD]) == LOAD_VERTICAL:
            work[block + REGION_SHARE] = work[block + REGION_COS]
    return 0


def start_levels(work: 'float[:]', count: int, penetration: float):
    """Levels before any interaction is known; a region that is hardly reached still gets nodes for a tenth of it."""
    for i in range(count):
        block = region_block(i)
        level = work[block + REGION_TURN] * penetration - work[block + REGION_GAP]
        if level < 0.1 * penetration:
            level = 0.1 * penetration
        work[block + REGION_LEVEL] = level
    return 0


def covered(work: 'float[:]', count: int):
    """1 if no region is loaded at an end of its nodes other than its bound, else 0."""
    result = 1
    for i in range(count):
        block = region_block(i)
        rises = node_field(i, NODE_RISE)
        level = work[block + REGION_LEVEL]
        low = work[block + REGION_LOW]
        high = work[block + REGION_HIGH]
        if work[FRAME_PRESSED] == 1.0:
            # its bounds may be the rail's ends, far away
            if low < work[block + REGION_STATION] + work[block + REGION_SPACING] * work[block + REGION_FIRST]:
                low = -FAR
            if high > work[block + REGION_STATION] + work[block + REGION_SPACING] * work[block + REGION_LAST]:
                high = FAR
        if level > work[rises + int(work[block + REGION_LAST])] and high >= FAR:
            result = 0
        if level > work[rises + int(work[block + REGION_FIRST])] and low <= -FAR:
            result = 0
    return result


def estimate_penetration(tables: 'float[:]', work: 'float[:]', state: 'float[:]', force: float):
    """Hertz's penetration [m] for the interpenetration's own width: B = level / width^2 at a guessed level.

    Exact for constant curvatures; within 12 % for nine of ten poses of S1002 on UIC60.
    """
    block = region_block(0)
    A = 0.5 * work[block + REGION_CURVATURE]
    guess = guess_penetration(force, A, tables[SET_CONTACT_MODULUS])
    measure_widths(tables, work, state, 0, guess)
    width = 0.5 * (work[block + REGION_WIDTH_LOW] + work[block + REGION_WIDTH_HIGH])
    B = FLOOR * A
    if guess > CEILING * A * width * width:
        B = CEILING * A
    elif guess > B * width * width:
        B = guess / (width * width)
    stiffness = hertz_stiffness(tables, int(tables[SET_HERTZ]), A, B, tables[SET_CONTACT_MODULUS])
    return (force / stiffness) ** (2.0 / 3.0)


def gather_regions(tables: 'float[:]', work: 'float[:]', state: 'float[:]', side: int, penetration: float):
    """Open the regions that ``penetration`` [m] reaches, with their bounds and first levels; their number."""
    for i in range(REGION_LIMIT):
        work[region_block(i) + REGION_WIDTH_LEVEL] = 0.0
        work[region_block(i) + REGION_SLANT] = 0.0
    count = 1
    if work[FRAME_PRESSED] == 1.0:
        count = gather_overlaps(tables, work, state)
    else:
        open_contact_region(tables, work, state)
        count = find_regions(tables, work, state, side, penetration)
        count = bound_regions(tables, work, state, count, penetration)
        give_planes(tables, work, state, count)
    start_levels(work, count, penetration)
    return count


def first_penetration(tables: 'float[:]', work: 'float[:]', state: 'float[:]', force: float):
    """What the penetration [m] under the prescribed ``force`` [N] is estimated to be."""
    open_contact_region(tables, work, state)
    work[region_block(0) + REGION_WIDTH_LEVEL] = 0.0
    return estimate_penetration(tables, work, state, force / work[region_block(0) + REGION_SHARE])


def solve_estimated(tables: 'float[:]', work: 'float[:]', state: 'float[:]', side: int, force: float, estimate: float,
                    by_penetration: int):
    """Penetration [m] and number of regions, with regions and nodes laid for the ``estimate`` of it; third value 1 when
    met, else 0."""
    count = gather_regions(tables, work, state, side, estimate)
    penetration, met = solve_fine(tables, work, state, count, force, estimate, by_penetration)
    if met == 0 and count > 1:
        # regions so close that pressing on each other has no fixed point are one region
        count = 1
        if work[FRAME_PRESSED] == 1.0:
            keep_deepest(work)
            gather_overlaps(tables, work, state)
        else:
            open_contact_region(tables, work, state)
        start_levels(work, count, estimate)
        penetration, met = solve_fine(tables, work, state, count, force, estimate, by_penetration)
    return penetration, count, met


def solve_analyn(tables: 'float[:]', work: 'float[:]', state: 'float[:]', side: int, force: float, prescribed: float):
    """Penetration [m] and number of regions under ``force`` [N], or at ``prescribed`` penetration [m] if that is a
    number; third value 1 when met, else 0.  A pressed wheel has its regions where it stands."""
    by_penetration = 0
    penetration = prescribed
    if isfinite(prescribed):
        by_penetration = 1
    if work[FRAME_PRESSED] == 1.0:
        penetration, count, met = solve_estimated(tables, work, state, side, force, work[FRAME_DEPTH], by_penetration)
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


def solve_fine(tables: 'float[:]', work: 'float[:]', state: 'float[:]', count: int, force: float, penetration: float,
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
            if work[FRAME_PRESSED] == 1.0:
                # nodes stay where the wheel stands; there are only more of them
                laid = work[FRAME_DEPTH]
            start_levels(work, count, laid)
    return penetration, met


def solve_hertz(tables: 'float[:]', work: 'float[:]', side: int, force: float, prescribed: float):
    """Hertz's ellipse with the curvatures at the contact point, written to the outputs at ``side``; its penetration.

    A lateral curvature below FLOOR A (concave or flat pairs, which Hertz does not cover) counts as FLOOR A.
    """
    base = int(tables[SET_HERTZ])
    A = 0.5 * work[side + SIDE_CURVATURE_X]
    B = 0.5 * work[side + SIDE_CURVATURE_Y]
    if not B > FLOOR * A:
        B = FLOOR * A
    block = region_block(0)
    stiffness = hertz_stiffness(tables, base, A, B, tables[SET_CONTACT_MODULUS])
    penetration = prescribed
    if not isfinite(prescribed):
        penetration = (force / (work[block + REGION_SHARE] * stiffness)) ** (2.0 / 3.0)
    load = stiffness * penetration * sqrt(penetration)
    work[block + REGION_STIFFNESS] = 1.5 * stiffness * sqrt(penetration)
    work[block + REGION_CARRIED] = load
    work[block + REGION_MOMENT] = 0.0
    work[block + REGION_SLANT] = 0.0
    one_alpha, one_beta, nr = hertz_coefficients(tables, base, A, B)
    a = sqrt(penetration / (one_alpha * A))
    b = sqrt(penetration / (one_beta * B))
    area = pi * a * b
    pressure = 1.5 * load / area
    work[side + SIDE_PATCH_COUNT] = 1.0
    work[side + SIDE_PENETRATION] = penetration
    work[side + SIDE_NORMAL_FORCE] = load
    work[side + SIDE_AREA] = area
    work[side + SIDE_MAX_PRESSURE] = pressure
    work[side + SIDE_PATCH_LENGTH] = 2.0 * a
    work[side + SIDE_PATCH_WIDTH] = 2.0 * b
    work[side + SIDE_PATCH_CENTROID] = 0.0
    work[side + SIDE_PATCH + PATCH_NORMAL_FORCE] = load
    work[side + SIDE_PATCH + PATCH_AREA] = area
    work[side + SIDE_PATCH + PATCH_MAX_PRESSURE] = pressure
    work[side + SIDE_PATCH + PATCH_LENGTH] = 2.0 * a
    work[side + SIDE_PATCH + PATCH_WIDTH] = 2.0 * b
    work[side + SIDE_PATCH + PATCH_CENTROID] = 0.0
    work[side + SIDE_PATCH + PATCH_CONTACT_ANGLE] = work[side + SIDE_CONTACT_ANGLE]
    if int(tables[SET_DEPTH]) == DEPTH_ALL:
        write_ellipse(work, outline_place(tables, side), int(tables[SET_STATIONS]), a, b, pressure)
    return penetration


def write_ellipse(work: 'float[:]', place: int, stations: int, a: float, b: float, pressure: float):
    """Outline and pressure of an ellipse of half-length ``a`` and half-width ``b`` [m] at ``stations`` stations, to
    ``place``."""
    for j in range(stations):
        share = 2.0 * float(j) / float(stations - 1) - 1.0
        height = sqrt(1.0 - share * share)
        work[place + j] = share * b
        work[place + stations + j] = a * height
        work[place + 2 * stations + j] = pressure * height
    return 0


def solve_normal(tables: 'float[:]', work: 'float[:]', state: 'float[:]', side: int, outputs: int, force: float,
                 prescribed: float):
    """Normal contact of the side whose frame is open, into the outputs at ``outputs``; the number of regions, and 1 when
    met, else 0."""
    met = 1
    count = 1
    if int(tables[SET_NORMAL_MODEL]) == MODEL_HERTZ:
        solve_hertz(tables, work, outputs, force, prescribed)
    else:
        penetration, count, met = solve_analyn(tables, work, state, side, force, prescribed)
        if met == 1 and int(tables[SET_NORMAL_MODEL]) == MODEL_ANALYN_STRIP:
            by_penetration = 0
            if isfinite(prescribed):
                by_penetration = 1
            penetration, strips, met = correct_strips(tables, work, state, count, force, penetration, by_penetration)
            if met == 1:
                islands = gather_strips(work, strips)
                write_patches(work, outputs, islands)
                if int(tables[SET_DEPTH]) == DEPTH_ALL:
                    write_strip_outline(work, outline_place(tables, outputs), int(tables[SET_STATIONS]), strips, islands)
        elif met == 1:
            islands = gather_islands(tables, work, count)
            write_patches(work, outputs, islands)
            if int(tables[SET_DEPTH]) == DEPTH_ALL:
                write_outline(work, outputs, outline_place(tables, outputs), int(tables[SET_STATIONS]), count, islands)
        work[outputs + SIDE_PENETRATION] = penetration
    return count, met
