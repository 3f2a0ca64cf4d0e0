"""Where a pressed wheel overlaps its rail: the deepest point of every region, and the humps between them.

The overlap is sampled at the scan nodes where the wheel is below the rail, taken straight down and turned into the normal;
between two samples where it turns from rising to falling lies a deepest point, which is refined along the rail's normals
(:mod:`pressed`).  Two that are parted by a low hump are one region (regions.MERGE).
"""

from math import fabs
from typing import Final

from ..layout import EXPONENTS, OVERLAP_LIMIT, REGION_LIMIT, WORK_OVERLAP, Place, SideSearch, State, Tables, Work
from ..search.bounds import clear_exponent
from ..search.raster import node_below
from ..surface.gap import above_rail
from ..surface.locus import outline_point
from ..surface.profile_table import height_slope, height_slope_bend
from .contact_plane import open_frame, start_tracer
from .planes import keep_frame, line_up, use_frame
from .pressed import normal_line, pressed_gap, rail_length, rail_speed
from .regions import MERGE, lean_region

# deepest points, in the order of the rail
DEEP_COUNT: Final[int] = WORK_OVERLAP
DEEP_FIRST: Final[int] = WORK_OVERLAP + 1        # blocks of DEEP_SIZE:
DEEP_SIZE: Final[int] = 6
DEEP_LIMIT: Final[int] = 9
DEEP_RAIL: Final[int] = 0            # rail and wheel abscissa [m]
DEEP_WHEEL: Final[int] = 1
DEEP_DEPTH: Final[int] = 2           # [m]
DEEP_HUMP: Final[int] = 3            # abscissa of the hump to the next one [m]
DEEP_BETWEEN: Final[int] = 4         # and the overlap there [m], negative where they are apart
# samples, the fields one after the other
SAMPLE_RAIL: Final[int] = WORK_OVERLAP + 64      # rail and wheel abscissa [m]
SAMPLE_WHEEL: Final[int] = SAMPLE_RAIL + 2 * OVERLAP_LIMIT
SAMPLE_RISE: Final[int] = SAMPLE_WHEEL + 2 * OVERLAP_LIMIT       # slope of the overlap [-]
SAMPLE_NEXT: Final[int] = SAMPLE_RISE + 2 * OVERLAP_LIMIT        # 1 if the sample before it is its neighbour

#: A deepest point is located to this on the rail [m], so that differences of its place between poses are its derivatives; its
#: depth, being second order, asks for less.
DEEP_SHARP: Final[float] = 1e-13
DEEP_ITERATIONS: Final[int] = 60
#: Slope of the overlap below which it has turned there [-]: standard profiles are joined with slopes that differ by up to 1e-5.
LEVEL_RISE: Final[float] = 1e-4
#: Deepest points closer than this on the rail are one [m].
SAME: Final[float] = 1e-6
#: Between two samples the overlap is looked at in so many parts.
PARTS: Final[int] = 4
#: The deepest point beside the smallest gap is looked for in steps that double from the first one on, up to the other [m].
FIRST_STEP: Final[float] = 1e-7
FAR_STEP: Final[float] = 1e-3
#: Steps that a deepest point is looked for beyond its two samples.
WIDENINGS: Final[int] = 6


def sample_overlap(tables: Tables, work: Work, at: Place, node: int, height: float, entry: int):
    """Write scan node ``node`` to sample ``entry``; its vertical gap [m], slope difference [-] and rail abscissa [m]."""
    point = tables.scan.nodes[node]
    y = point.y
    y_track, z_track, outline_slope = outline_point(at, y, point.height, point.slope)
    abscissa = y_track - tables.rail_y
    z_rail, m, bend = height_slope_bend(tables.rail, abscissa)
    gap = z_rail - z_track
    square = 1.0 / (1.0 + m * m)
    work[SAMPLE_RAIL + entry] = abscissa
    work[SAMPLE_WHEEL + entry] = y
    # of (height - gap) cos, but for a factor cos; apart from each other, where the rail's normals say little, of height - gap
    rise = outline_slope - m
    if height > gap:
        rise -= (height - gap) * m * bend * square
    work[SAMPLE_RISE + entry] = rise
    return gap, m - outline_slope, abscissa


def sample_end(tables: Tables, work: 'float[:]', direction: int, entry: int):
    """Let sample ``entry``, beyond the rail, stand for its end, with a slope that lets the last stretch be searched.

    It keeps its own wheel abscissa, less than a cell away: it may be the first one, whose neighbour is not sampled yet.
    """
    rail = tables.rail
    work[SAMPLE_RAIL + entry] = rail.start
    work[SAMPLE_RISE + entry] = 1.0
    if direction > 0:
        work[SAMPLE_RAIL + entry] = rail.stop
        work[SAMPLE_RISE + entry] = -1.0
    return 0


def walk_overlap(tables: Tables, work: Work, state: State, at: Place, node: int, direction: int, height: float,
                 first: int):
    """Sample from scan node ``node`` on in ``direction`` (1 or -1), leaving out stretches where the wheel is above the rail;
    the entry after the last one.  Entries begin with ``first`` and run in ``direction``."""
    count = tables.scan.count
    entry = first
    exponent = EXPONENTS - 1
    neighbour = 1.0
    while node >= 0 and node < count and entry > 0 and entry < 2 * OVERLAP_LIMIT - 1:
        gap, mismatch, abscissa = sample_overlap(tables, work, at, node, height, entry)
        state.gap_count += 1.0
        on_rail = above_rail(tables, abscissa)
        if on_rail == 0:
            sample_end(tables, work.raw, direction, entry)
        if direction > 0:
            work[SAMPLE_NEXT + entry] = neighbour
        else:
            work[SAMPLE_NEXT + entry + 1] = neighbour
        entry += direction
        if on_rail == 0:
            return entry
        neighbour = 1.0
        step = 1
        if gap > height:
            exponent = clear_exponent(tables.scan, at, node, direction, abscissa, gap - height, float(direction) * mismatch,
                                      exponent)
            if exponent < 0:
                exponent = 0
            elif exponent > 0:
                step = 1 << exponent
                neighbour = 0.0
            if exponent < EXPONENTS - 1:
                exponent += 1
        node += direction * step
    return entry


def turning_point(tables: Tables, work: Work, at: Place, low: float, high: float, y: float, height: float,
                  sign: float):
    """Rail and wheel abscissa [m] of the largest overlap (``sign`` = 1) or the smallest (-1) between two rail abscissae, and
    the overlap [m]: Newton's method on its slope, bracketed, from the middle on.  Fourth value: 1 if the slope turns there,
    else 0.

    The bend leaves out a factor (:mod:`pressed`); between nearly conformal profiles under a deep overlap that can send
    Newton's method to and fro.  Where a step has not halved the slope, the bracket is.
    """
    x = 0.5 * (low + high)
    overlap = 0.0
    rise = 1.0
    before = 0.0
    for i in range(DEEP_ITERATIONS):
        y, overlap, rise, bend, curvature, found = normal_line(tables, work, at, x, y, height)
        if found == 0:
            return x, y, overlap, 0
        if sign * rise > 0.0:
            low = x
        else:
            high = x
        following = 0.5 * (low + high)
        if sign * bend < 0.0 and (i == 0 or fabs(rise) < 0.5 * before):
            newton = x - rise / (bend * rail_speed(tables, x))
            if newton > low and newton < high:
                following = newton
        if fabs(following - x) < DEEP_SHARP:
            break
        x = following
        before = fabs(rise)
    turned = 0
    if fabs(rise) < LEVEL_RISE:
        turned = 1
    return x, y, overlap, turned


def bracket_end(tables: Tables, work: Work, at: Place, x: float, step: float, y: float, height: float):
    """``x``, or the first place some ``step`` [m] further, from where the overlap rises towards the other side; the samples
    are straight down and may have turned a little before it."""
    rail = tables.rail
    for i in range(WIDENINGS):
        if x <= rail.start:
            return rail.start
        if x >= rail.stop:
            return rail.stop
        y, overlap, rise, bend, curvature, found = normal_line(tables, work, at, x, y, height)
        if found == 0 or rise * step < 0.0:
            break
        x += step
    return x


def keep_deep(work: 'float[:]', x: float, y: float, depth: float):
    """List a deepest point."""
    entry = int(work[DEEP_COUNT])
    if entry < DEEP_LIMIT:
        block = DEEP_FIRST + DEEP_SIZE * entry
        work[block + DEEP_RAIL] = x
        work[block + DEEP_WHEEL] = y
        work[block + DEEP_DEPTH] = depth
        work[DEEP_COUNT] = float(entry + 1)
    return 0


def drop_deep(work: 'float[:]', entry: int):
    """Leave out a deepest point; of the humps beside it the lower one stays."""
    count = int(work[DEEP_COUNT])
    block = DEEP_FIRST + DEEP_SIZE * entry
    if entry > 0 and entry < count - 1:
        before = block - DEEP_SIZE
        if work[block + DEEP_BETWEEN] < work[before + DEEP_BETWEEN]:
            work[before + DEEP_BETWEEN] = work[block + DEEP_BETWEEN]
            work[before + DEEP_HUMP] = work[block + DEEP_HUMP]
    remove_deep(work, entry)
    return 0


def find_humps(tables: Tables, work: Work, at: Place, height: float):
    """The smallest overlap between neighbouring deepest points."""
    for entry in range(int(work[DEEP_COUNT]) - 1):
        block = DEEP_FIRST + DEEP_SIZE * entry
        x, y, overlap, turned = turning_point(tables, work, at, work[block + DEEP_RAIL], work[block + DEEP_SIZE + DEEP_RAIL],
                                              0.5 * (work[block + DEEP_WHEEL] + work[block + DEEP_SIZE + DEEP_WHEEL]),
                                              height, -1.0)
        work[block + DEEP_HUMP] = x
        work[block + DEEP_BETWEEN] = overlap
    return 0


def deepest_entry(work: 'float[:]'):
    """The deepest of the list."""
    best = 0
    for entry in range(int(work[DEEP_COUNT])):
        if work[DEEP_FIRST + DEEP_SIZE * entry + DEEP_DEPTH] > work[DEEP_FIRST + DEEP_SIZE * best + DEEP_DEPTH]:
            best = entry
    return best


def keep_deepest(work: 'float[:]'):
    """Leave only the deepest of the list, which then has no bounds."""
    deepest = DEEP_FIRST + DEEP_SIZE * deepest_entry(work)
    for i in range(DEEP_SIZE):
        work[DEEP_FIRST + i] = work[deepest + i]
    work[DEEP_COUNT] = 1.0
    return 0


def shallowest_entry(work: 'float[:]'):
    """The least deep of the list."""
    least = 0
    for entry in range(int(work[DEEP_COUNT])):
        if work[DEEP_FIRST + DEEP_SIZE * entry + DEEP_DEPTH] < work[DEEP_FIRST + DEEP_SIZE * least + DEEP_DEPTH]:
            least = entry
    return least


def merge_deep(work: 'float[:]'):
    """Join what a low hump parts, and keep the deepest REGION_LIMIT."""
    depth = work[DEEP_FIRST + DEEP_SIZE * deepest_entry(work) + DEEP_DEPTH]
    entry = 0
    while entry < int(work[DEEP_COUNT]) - 1:
        block = DEEP_FIRST + DEEP_SIZE * entry
        if depth - work[block + DEEP_BETWEEN] < MERGE * depth:
            less = entry
            if work[block + DEEP_DEPTH] > work[block + DEEP_SIZE + DEEP_DEPTH]:
                less = entry + 1
            # the hump between the two goes, the one on the far side stays
            if less == entry + 1:
                work[block + DEEP_HUMP] = work[block + DEEP_SIZE + DEEP_HUMP]
                work[block + DEEP_BETWEEN] = work[block + DEEP_SIZE + DEEP_BETWEEN]
            remove_deep(work, less)
        else:
            entry += 1
    while int(work[DEEP_COUNT]) > REGION_LIMIT:
        drop_deep(work, shallowest_entry(work))
    return 0


def remove_deep(work: 'float[:]', entry: int):
    """Take entry ``entry`` off the list with its own hump."""
    block = DEEP_FIRST + DEEP_SIZE * entry
    count = int(work[DEEP_COUNT])
    for i in range(block, DEEP_FIRST + DEEP_SIZE * (count - 1)):
        work[i] = work[i + DEEP_SIZE]
    work[DEEP_COUNT] = float(count - 1)
    return 0


def find_overlaps(tables: Tables, work: Work, state: State, side: SideSearch, at: Place, height: float):
    """List the regions in which the wheel placed at ``at`` and moved down by ``height`` [m] overlaps its rail; their number."""
    node = node_below(tables.scan, side.best_y)
    work[DEEP_COUNT] = 0.0
    start = walk_overlap(tables, work, state, at, node, -1, height, OVERLAP_LIMIT - 1) + 1
    stop = walk_overlap(tables, work, state, at, node + 1, 1, height, OVERLAP_LIMIT)
    for entry in range(start, stop - 1):
        if work[SAMPLE_RISE + entry] > 0.0 and work[SAMPLE_RISE + entry + 1] <= 0.0 and work[SAMPLE_NEXT + entry + 1] == 1.0:
            step = work[SAMPLE_RAIL + entry + 1] - work[SAMPLE_RAIL + entry]
            y = 0.5 * (work[SAMPLE_WHEEL + entry] + work[SAMPLE_WHEEL + entry + 1])
            low = bracket_end(tables, work, at, work[SAMPLE_RAIL + entry], -step, y, height)
            high = bracket_end(tables, work, at, work[SAMPLE_RAIL + entry + 1], step, y, height)
            list_between(tables, work, at, low, high, y, height)
    list_smallest(tables, work, side, at, height)
    if int(work[DEEP_COUNT]) > 0:
        find_humps(tables, work, at, height)
        merge_deep(work.raw)
    return int(work[DEEP_COUNT])


def list_between(tables: Tables, work: Work, at: Place, low: float, high: float, y: float, height: float):
    """List the deepest points between two rail abscissae from where the overlap rises towards each other: on nearly conformal
    profiles the joints of their arcs leave several, of which a bracket by itself would end at either."""
    step = (high - low) / float(PARTS)
    start = low
    rising = 1
    guess = y
    for i in range(1, PARTS + 1):
        stop = low + step * float(i)
        falls = 1
        if i < PARTS:
            near, overlap, rise, bend, curvature, found = normal_line(tables, work, at, stop, guess, height)
            if found == 1:
                guess = near
            if found == 1 and rise > 0.0:
                falls = 0
        if rising == 1 and falls == 1:
            x, y, depth, turned = turning_point(tables, work, at, start, stop, guess, height, 1.0)
            if turned == 1 and depth > 0.0 and is_listed(work.raw, x) == 0:
                keep_deep(work.raw, x, y, depth)
        rising = 1 - falls
        start = stop
    return 0


def list_smallest(tables: Tables, work: Work, side: SideSearch, at: Place, height: float):
    """List the deepest point beside the smallest gap where none on the list is as deep as the overlap there: between two
    scan nodes on nearly conformal profiles it can turn three times."""
    z, slope = height_slope(tables.wheel, side.best_y)
    y_track, z_track, outline_slope = outline_point(at, side.best_y, z, slope)
    x = y_track - tables.rail_y
    y, overlap, rise, bend, curvature, found = normal_line(tables, work, at, x, side.best_y, height)
    deepest = 0.0
    if int(work[DEEP_COUNT]) > 0:
        deepest = work[DEEP_FIRST + DEEP_SIZE * deepest_entry(work.raw) + DEEP_DEPTH]
    if found == 1 and overlap > deepest:
        step = FIRST_STEP
        if rise < 0.0:
            step = -FIRST_STEP
        far = x
        while rise * step > 0.0 and fabs(far - x) < FAR_STEP and found == 1:
            far += step
            y, overlap, rise, bend, curvature, found = normal_line(tables, work, at, far, y, height)
            step *= 2.0
        low = x
        high = far
        if far < x:
            low = far
            high = x
        x, y, depth, turned = turning_point(tables, work, at, low, high, side.best_y, height, 1.0)
        if turned == 1 and depth > deepest:
            keep_deep(work.raw, x, y, depth)
            sort_deep(work.raw)
    return 0


def sort_deep(work: 'float[:]'):
    """Bring the last deepest point listed to its place along the rail."""
    block = DEEP_FIRST + DEEP_SIZE * (int(work[DEEP_COUNT]) - 1)
    while block > DEEP_FIRST and work[block + DEEP_RAIL] < work[block - DEEP_SIZE + DEEP_RAIL]:
        for i in range(block, block + DEEP_SIZE):
            kept = work[i]
            work[i] = work[i - DEEP_SIZE]
            work[i - DEEP_SIZE] = kept
        block -= DEEP_SIZE
    return 0


def is_listed(work: 'float[:]', x: float):
    """1 if the last deepest point listed is at ``x`` [m] or beyond, else 0."""
    listed = 0
    entry = int(work[DEEP_COUNT]) - 1
    if entry >= 0:
        if x < work[DEEP_FIRST + DEEP_SIZE * entry + DEEP_RAIL] + SAME:
            listed = 1
    return listed


def touching_shift(tables: Tables, work: Work, at: Place, entry: int, height: float):
    """Lateral and vertical shift [m] that let the wheel just touch at a deepest point."""
    block = DEEP_FIRST + DEEP_SIZE * entry
    x = work[block + DEEP_RAIL]
    y = work[block + DEEP_WHEEL]
    z, slope = height_slope(tables.wheel, y)
    y_track, z_track, outline_slope = outline_point(at, y, z, slope)
    z_rail, m = height_slope(tables.rail, x)
    return x + tables.rail_y - y_track, z_rail - z_track


def press_frame(work: Work, height: float, depth: float, gap: float):
    """Let the open frame be that of a wheel pressed ``depth`` deep, whose own gap is ``gap`` [m]."""
    work.frame.pose = height
    work.frame.depth = depth
    work.frame.pressed = True
    work.frame.raised = gap
    return 0


def gather_overlaps(tables: Tables, work: Work, state: State):
    """Open a region for every deepest point on the list, each with its own frame; their number.  The open frame is that of the
    deepest, whose share of the approach counts as one."""
    count = int(work[DEEP_COUNT])
    contact = deepest_entry(work.raw)
    cosine = work.frame.cos
    abscissa = work.frame.abscissa
    height = work.frame.pose
    depth = work.frame.depth
    at = Place.at(work, int(work.frame.place))
    rail = tables.rail
    keep_frame(work.raw, REGION_LIMIT)
    for region in range(count):
        block = work.regions[region]
        deep = DEEP_FIRST + DEEP_SIZE * region
        block.station = 0.0
        block.gap = 0.0
        block.rail = work[deep + DEEP_RAIL]
        block.wheel = work[deep + DEEP_WHEEL]
        z_rail, m = height_slope(rail, work[deep + DEEP_RAIL])
        lean_region(tables, work, block, m)
        if region != contact:
            aside, shift = touching_shift(tables, work, at, region, height)
            open_frame(tables, work, at, work[deep + DEEP_WHEEL], aside, shift)
            block.own = True
            block.turn = block.cos / cosine
            block.gap = block.turn * depth - work[deep + DEEP_DEPTH]
            block.offset = rail_length(tables, abscissa, work[deep + DEEP_RAIL])
            press_frame(work, height, work[deep + DEEP_DEPTH], block.gap)
        start_tracer(work, 0.0, work[deep + DEEP_RAIL], work[deep + DEEP_WHEEL])
        gap, rate, bend, curvature = pressed_gap(tables, work, state, 0.0)
        block.bend = bend
        block.curvature = curvature
        low = rail.start
        high = rail.stop
        if region > 0:
            low = work[deep - DEEP_SIZE + DEEP_HUMP]
        if region < count - 1:
            high = work[deep + DEEP_HUMP]
        block.low = rail_length(tables, work[deep + DEEP_RAIL], low)
        block.high = rail_length(tables, work[deep + DEEP_RAIL], high)
        keep_frame(work.raw, region)
        use_frame(work.raw, REGION_LIMIT)
    if count > 1:
        line_up(tables, work, count)
    return count
