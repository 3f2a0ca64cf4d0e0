"""The strip correction: ANALYN's patch, put right by the elastic half-space.

ANALYN's strips do not feel each other: the displacement of each is that of a Hertz ellipse with its own curvatures.  Here
the same strips, each with a pressure p sqrt(1 - (x/a)^2) along the track, press on one half-space (docs/method.md, S1-S9):

1. place the strips over ANALYN's zone, finer where the gap bends and near the contact,
2. solve sum_j F_ij y_j = penetration - gap_i with y = h p / (pi E*) >= 0 and the force given; F_ij tells how a strip j of
   half-length a_j pushes the middle line of strip i down,
3. correct every half-length by what the middle line's curvature along the track asks for, at its line load.

One round of 2 and 3 is a sweep.  Where the true patch differs from ANALYN's, strips lose their load or take some up.
"""

from math import fabs, log, pi, sqrt
from typing import Final

from ..contact.contact_plane import is_yawed
from ..layout import (
    NODE_MIDDLE,
    STRIP_LIMIT,
    WORK_DISTANCE,
    WORK_INFLUENCE,
    WORK_STRIPS,
    WORK_SYSTEM,
    Region,
    State,
    Tables,
    Work,
)
from .interaction import planes_cosine, region_lead
from .nodes import NODE_A, NODE_B, NODE_GAP, NODE_LENGTH, NODE_LINE, NODE_RISE, node_field

# strip fields
STRIP_STATION: Final[int] = 0        # middle [m]
STRIP_WIDTH: Final[int] = 1          # [m]
STRIP_GAP: Final[int] = 2            # there [m]
STRIP_A: Final[int] = 3              # longitudinal A = 1/(2 R_x) [1/m]
STRIP_HERTZ: Final[int] = 4          # ANALYN's line load per square of the half-length [N/m^3]
STRIP_HALF: Final[int] = 5           # half-length a [m]
STRIP_LOG: Final[int] = 6            # its logarithm
STRIP_SHARE: Final[int] = 7          # y = h p / (pi E*) [m]; zero where not loaded
STRIP_LOADED: Final[int] = 8         # 1 or 0
STRIP_REGION: Final[int] = 9
STRIP_LINE: Final[int] = 10          # line load q [N/m]
STRIP_SQUARE: Final[int] = 11        # square of the corrected half-length [m^2]
STRIP_PRESSURE: Final[int] = 12      # pressure on the middle line [Pa]
STRIP_JOINED: Final[int] = 13        # 1 if it touches the next one
STRIP_RANK: Final[int] = 14          # the loaded strips, one after the other
STRIP_TURN: Final[int] = 15          # penetration of the upright problem over the real one; 1 without yaw

# the influence table: Phi of eq. (S3) over ln(distance / half-length)
TABLE_START: Final[int] = 0
TABLE_CELLS_PER_UNIT: Final[int] = 1
TABLE_COUNT: Final[int] = 2
TABLE_CELLS: Final[int] = 4
TABLE_ROW: Final[int] = 4

#: Strips lie where the gap is below this share of ANALYN's penetration, and where ANALYN sees load.
ZONE: Final[float] = 0.9
#: and, where a patch is short across, where ANALYN's level is above minus this share of it.
BEYOND: Final[float] = 0.6
#: Share of the strips that is spread evenly; the others go with sqrt(B) sqrt(1 - gap / penetration).
EVEN: Final[float] = 0.5
#: Fewest strips of a region.
LEAST: Final[int] = 12
#: Smallest half-length: of the longest one, of that of the interpenetration, and of the strip's width.  Shorter ones make
#: the strip's own pressure grow without limit (a light load then misses its area by all of it).
SHORTEST: Final[float] = 0.1
INSIDE: Final[float] = 0.3
SQUARE: Final[float] = 0.5
#: Loaded strips are exchanged all at once so often, then one at a time, which cannot go in circles.
EXCHANGES: Final[int] = 10
EXCHANGE_LIMIT: Final[int] = 200
#: A strip without load must penetrate by this share of the penetration to take some up; rounding is 1e-14.
TOUCH: Final[float] = 1e-12
#: Strips whose edges are closer than this share of their width touch.
TOUCHING: Final[float] = 1e-6


def strip_field(field: int):
    """Offset of strip 0 of ``field`` in the workspace."""
    return WORK_STRIPS + field * STRIP_LIMIT


def zone_excess(work: Work, block: Region, gaps: int, rises: int, k: int, penetration: float):
    """Positive where strips belong: by how much the gap stays below ZONE, or ANALYN's load level above nothing [m]."""
    below = ZONE * penetration - block.gap - work[gaps + k]
    level = block.level - work[rises + k]
    beyond = level + BEYOND * penetration
    if beyond < below:
        below = beyond
    if level > below:
        below = level
    return below


def zone_end(work: Work, region: int, direction: int, penetration: float):
    """Station [m] where the region's strips end in ``direction``; its minimum's if none belong there."""
    block = work.regions[region]
    gaps = node_field(region, NODE_GAP)
    rises = node_field(region, NODE_RISE)
    last = block.last
    bound = block.high
    if direction < 0:
        last = -block.first
        bound = block.low
    inner = zone_excess(work, block, gaps, rises, 0, penetration)
    reach = 0.0
    if inner > 0.0:
        reach = float(last)
        for k in range(1, last + 1):
            outer = zone_excess(work, block, gaps, rises, direction * k, penetration)
            if outer <= 0.0:
                reach = float(k - 1) + inner / (inner - outer)
                break
            inner = outer
    station = block.station + float(direction) * reach * block.spacing
    if (station - bound) * float(direction) > 0.0:
        station = bound
    return station


def node_weight(work: Work, region: int, k: int, penetration: float):
    """sqrt(B) sqrt(1 - gap / penetration) at a node [m^-1/2]."""
    block = work.regions[region]
    share = 1.0 - (block.gap + work[node_field(region, NODE_GAP) + k]) / penetration
    weight = 0.0
    if share > 0.0:
        weight = sqrt(work[node_field(region, NODE_B) + k] * share)
    return weight


def cell_overlap(work: Work, block: Region, k: int):
    """Length of the cell between nodes ``k`` and ``k`` + 1 inside the region's zone [m], and where it begins there."""
    spacing = block.spacing
    start = block.station + spacing * float(k)
    stop = start + spacing
    if start < block.start:
        start = block.start
    if stop > block.stop:
        stop = block.stop
    return stop - start, start


def weigh_region(work: Work, region: int, penetration: float):
    """Integral of the weight over the region's zone [m^1/2]."""
    block = work.regions[region]
    total = 0.0
    before = node_weight(work, region, block.first, penetration)
    for k in range(block.first, block.last):
        after = node_weight(work, region, k + 1, penetration)
        length, start = cell_overlap(work, block, k)
        if length > 0.0:
            total += 0.5 * (before + after) * length
        before = after
    return total


def place_strips(tables: Tables, work: Work, count: int, penetration: float):
    """Strips over the zones of all regions; their number."""
    weight = 0.0
    width = 0.0
    for region in range(count):
        block = work.regions[region]
        share = block.turn * penetration
        block.start = zone_end(work, region, -1, share)
        block.stop = zone_end(work, region, 1, share)
        block.weight = weigh_region(work, region, share)
        weight += block.weight
        width += block.stop - block.start
    strips = 0
    for region in range(count):
        block = work.regions[region]
        length = block.stop - block.start
        if length > 0.0 and weight > 0.0:
            even = EVEN / width
            graded = (1.0 - EVEN) / weight
            share = even * length + graded * block.weight
            own = int(tables.strips * share + 0.5)
            if own < LEAST:
                own = LEAST
            strips = divide_zone(work, region, block.turn * penetration, strips, own, even, graded, share)
    return strips


def divide_zone(work: Work, region: int, penetration: float, strips: int, own: int, even: float, graded: float,
                share: float):
    """Cut the region's zone into ``own`` strips of equal weight after the first ``strips`` ones; the number of all."""
    block = work.regions[region]
    stations = strip_field(STRIP_STATION)
    widths = strip_field(STRIP_WIDTH)
    regions = strip_field(STRIP_REGION)
    offset = block.offset
    each = share / float(own)
    done = 0.0
    made = 0
    edge = block.start
    before = node_weight(work, region, block.first, penetration)
    for k in range(block.first, block.last):
        after = node_weight(work, region, k + 1, penetration)
        length, start = cell_overlap(work, block, k)
        if length > 0.0:
            density = even + graded * 0.5 * (before + after)
            while made < own - 1 and done + density * length >= each * float(made + 1):
                cut = start + (each * float(made + 1) - done) / density
                work[stations + strips + made] = offset + 0.5 * (edge + cut)
                work[widths + strips + made] = cut - edge
                work[regions + strips + made] = float(region)
                edge = cut
                made += 1
            done += density * length
        before = after
    while made < own:
        # the last one, and any that rounding has left over
        cut = edge + (block.stop - edge) / float(own - made)
        work[stations + strips + made] = offset + 0.5 * (edge + cut)
        work[widths + strips + made] = cut - edge
        work[regions + strips + made] = float(region)
        edge = cut
        made += 1
    return strips + own


def join_strips(work: 'float[:]', strips: int):
    """Mark the strips whose edges meet."""
    stations = strip_field(STRIP_STATION)
    widths = strip_field(STRIP_WIDTH)
    for i in range(strips):
        joined = 0.0
        if i < strips - 1:
            reach = 0.5 * (work[widths + i] + work[widths + i + 1])
            if work[stations + i + 1] - work[stations + i] < reach * (1.0 + TOUCHING):
                joined = 1.0
        work[strip_field(STRIP_JOINED) + i] = joined
    return 0


def cubic_through(before: float, low: float, high: float, after: float, x: float):
    """The cubic through values at -1, 0, 1, 2, at x."""
    bend = 0.5 * (before - 2.0 * low + high)
    third = (after - 3.0 * high + 3.0 * low - before) / 6.0
    return low + x * (high - low + (x - 1.0) * (bend + (x + 1.0) * third))


def cubic_value(work: 'float[:]', at: int, x: float):
    """The cubic through the four values around ``at`` + x, 0 <= x <= 1."""
    return cubic_through(work[at - 1], work[at], work[at + 1], work[at + 2], x)


def locate_strip(work: Work, i: int):
    """Gap and A of strip ``i`` where it stands; its node and the share of the way to the next one."""
    region = int(work[strip_field(STRIP_REGION) + i])
    block = work.regions[region]
    u = ((work[strip_field(STRIP_STATION) + i] - block.offset - block.station)
         / block.spacing)
    k = int(u + float(NODE_MIDDLE)) - NODE_MIDDLE
    if k > block.last - 1:
        k = block.last - 1
    if k < block.first:
        k = block.first
    x = u - float(k)
    gap = cubic_value(work.raw, node_field(region, NODE_GAP) + k, x)
    if gap < 0.0:
        # beside a sudden rise a cubic falls below the region's smallest gap
        gap = 0.0
    work[strip_field(STRIP_GAP) + i] = block.gap + gap
    work[strip_field(STRIP_A) + i] = node_value(work.raw, region, NODE_A, k, x)
    work[strip_field(STRIP_TURN) + i] = block.turn
    if is_yawed(work) == 1:
        # the patch is tilted; the strips are those of an upright one (hertz.upright_coefficients)
        turn = block.upright_share
        work[strip_field(STRIP_GAP) + i] = turn * block.gap + gap * block.upright_b
        work[strip_field(STRIP_A) + i] *= block.upright_a
        work[strip_field(STRIP_TURN) + i] = turn * block.turn
    return region, k, x


def node_value(work: 'float[:]', region: int, field: int, k: int, x: float):
    """``field`` on the straight line between nodes ``k`` and ``k`` + 1."""
    at = node_field(region, field) + k
    return work[at] + x * (work[at + 1] - work[at])


def describe_strips(work: Work, strips: int, penetration: float):
    """Gap, curvature and ANALYN's half-length of every strip, from its region's nodes."""
    halves = strip_field(STRIP_HALF)
    longest = 0.0
    for i in range(strips):
        region, k, x = locate_strip(work, i)
        line = node_value(work.raw, region, NODE_LINE, k, x)
        length = node_value(work.raw, region, NODE_LENGTH, k, x)
        level = work.regions[region].level - node_value(work.raw, region, NODE_RISE, k, x)
        work[strip_field(STRIP_HERTZ) + i] = line * length
        loaded = 0.0
        square = 0.0
        if level > 0.0:
            loaded = 1.0
            square = level / length
        below = penetration - work[strip_field(STRIP_GAP) + i] / work[strip_field(STRIP_TURN) + i]
        below *= work.regions[region].turn
        inside = INSIDE * INSIDE * below / length
        if inside > square:
            square = inside
        work[strip_field(STRIP_LOADED) + i] = loaded
        work[halves + i] = sqrt(square)
        if loaded == 1.0 and work[halves + i] > longest:
            longest = work[halves + i]
    keep_long(work.raw, strips, longest)
    return 0


def keep_long(work: 'float[:]', strips: int, longest: float):
    """Raise half-lengths to their least, and take the logarithms."""
    halves = strip_field(STRIP_HALF)
    widths = strip_field(STRIP_WIDTH)
    for i in range(strips):
        if work[halves + i] < SHORTEST * longest:
            work[halves + i] = SHORTEST * longest
        if work[halves + i] < SQUARE * work[widths + i]:
            work[halves + i] = SQUARE * work[widths + i]
        work[strip_field(STRIP_LOG) + i] = log(work[halves + i])
    return 0


def fit_edges(work: Work, strips: int):
    """Let the outermost strips of every run of loaded ones end at the run's edges."""
    lines = strip_field(STRIP_LINE)
    first = 0
    while first < strips:
        last = first
        if work[lines + first] > 0.0:
            last = run_end(work.raw, strips, first)
            if last > first + 2:
                start = run_edge(work.raw, strips, first, last, -1)
                stop = run_edge(work.raw, strips, last, first, 1)
                fit_edge(work, strips, first, start, -1)
                fit_edge(work, strips, last, stop, 1)
        first = last + 1
    return 0


def fit_edge(work: Work, strips: int, last: int, edge: float, outward: int):
    """Let the run that ends with strip ``last`` end at ``edge`` [m], which lies within one and a half of its widths.

    A strip is never narrower than half of what it was, since a narrow one answers the smallest mismatch with a large
    pressure: the one before takes over what little is left of it.
    """
    direction = float(outward)
    width = work[strip_field(STRIP_WIDTH) + last]
    inner = work[strip_field(STRIP_STATION) + last] - 0.5 * direction * width
    outer = inner + direction * width
    beyond = last + outward
    pair = last
    if outward < 0:
        pair = beyond
    touching = 0.0
    if pair >= 0 and pair < strips:
        touching = work[strip_field(STRIP_JOINED) + pair]
    if (edge - inner) * direction > 0.5 * width:
        set_strip(work, strips, last, inner, edge)
        if (edge - outer) * direction > 0.0 and touching == 1.0:
            far = work[strip_field(STRIP_STATION) + beyond] + 0.5 * direction * work[strip_field(STRIP_WIDTH) + beyond]
            set_strip(work, strips, beyond, edge, far)
    else:
        before = last - outward
        near = work[strip_field(STRIP_STATION) + before] - 0.5 * direction * work[strip_field(STRIP_WIDTH) + before]
        set_strip(work, strips, before, near, edge)
        set_strip(work, strips, last, edge, outer)
        work[strip_field(STRIP_LOADED) + last] = 0.0
    return 0


def set_strip(work: Work, strips: int, i: int, start: float, stop: float):
    """Let strip ``i`` lie between two stations [m]."""
    work[strip_field(STRIP_WIDTH) + i] = fabs(stop - start)
    work[strip_field(STRIP_STATION) + i] = 0.5 * (start + stop)
    region, k, x = locate_strip(work, i)
    measure_distances(work, strips, i, strips)
    return 0


def measure_distances(work: Work, strips: int, i: int, others: int):
    """Logarithms of the distances between strip ``i`` and the first ``others``, and how far their regions lie
    ahead of each other."""
    stations = strip_field(STRIP_STATION)
    regions = strip_field(STRIP_REGION)
    row = WORK_DISTANCE + strips * i
    for j in range(others):
        if j != i:
            apart = fabs(work[stations + i] - work[stations + j])
            if work[regions + i] != work[regions + j]:
                along = region_lead(work.regions[int(work[regions + i])], work.regions[int(work[regions + j])])
                apart = sqrt(apart * apart + along * along)
            distance = log(apart)
            work[row + j] = distance
            work[WORK_DISTANCE + strips * j + i] = distance
    return 0


def influence_value(tables: 'float[:]', base: int, abscissa: float):
    """Phi of eq. (S3) at ln(distance / half-length)."""
    u = (abscissa - tables[base + TABLE_START]) * tables[base + TABLE_CELLS_PER_UNIT]
    last = tables[base + TABLE_COUNT]
    if not u > 0.0:
        u = 0.0
    if u > last:
        u = last
    cell = int(u)
    u -= float(cell)
    at = base + TABLE_CELLS + TABLE_ROW * cell
    return tables[at] + u * (tables[at + 1] + u * (tables[at + 2] + u * tables[at + 3]))


def near_share(share: float):
    """What the mean of -2 ln(distance) over a strip exceeds its middle value by; ``share`` is half-width over distance."""
    square = share * share
    rest = 1.0 / 42.0 + square * (1.0 / 72.0 + square / 110.0)
    return 2.0 * square * (1.0 / 6.0 + square * (1.0 / 20.0 + square * rest))


def fill_influence(tables: Tables, work: Work, strips: int, count: int):
    """F_ij: displacement of middle line i for y_j = 1; eqs. (S3), (S4).  ``count`` is the number of regions."""
    base = int(tables.influence)
    stations = strip_field(STRIP_STATION)
    widths = strip_field(STRIP_WIDTH)
    halves = strip_field(STRIP_HALF)
    logs = strip_field(STRIP_LOG)
    for i in range(strips):
        row = WORK_INFLUENCE + strips * i
        distances = WORK_DISTANCE + strips * i
        for j in range(strips):
            if j != i:
                work[row + j] = influence_value(tables.raw, base, work[distances + j] - work[logs + j])
        for j in range(i - 2, i + 3):
            if j >= 0 and j < strips and j != i:
                work[row + j] += near_share(0.5 * work[widths + j] / fabs(work[stations + i] - work[stations + j]))
        work[row + i] = 2.0 * log(8.0 * work[halves + i] / work[widths + i])
    if count > 1:
        turn_influence(work, strips)
    return 0


def turn_influence(work: Work, strips: int):
    """Let strips of regions in different planes press on each other by the cosine of the angle between them."""
    regions = strip_field(STRIP_REGION)
    for i in range(strips):
        for j in range(strips):
            if work[regions + i] != work[regions + j]:
                cosine = planes_cosine(work.regions[int(work[regions + i])], work.regions[int(work[regions + j])])
                work[WORK_INFLUENCE + strips * i + j] *= cosine
    return 0


def eliminate(work: 'float[:]', size: int):
    """Solve the system of ``size`` rows with two right-hand sides in its last two columns, in place.

    Without exchange of rows: the matrix is that of a positive kernel, largest on the diagonal.
    """
    width = size + 2
    for pair in range(size // 2):
        # two columns at a time, so that every row is read and written once for both
        k = 2 * pair
        first = WORK_SYSTEM + width * k
        second = first + width
        inverse = 1.0 / work[first + k]
        factor = work[second + k] * inverse
        for j in range(k + 1, width):
            work[second + j] -= factor * work[first + j]
        next_inverse = 1.0 / work[second + k + 1]
        for i in range(k + 2, size):
            row = WORK_SYSTEM + width * i
            factor = work[row + k] * inverse
            next_factor = (work[row + k + 1] - factor * work[first + k + 1]) * next_inverse
            for j in range(k + 2, width):
                work[row + j] = work[row + j] - factor * work[first + j] - next_factor * work[second + j]
    for back in range(size):
        k = size - 1 - back
        pivot = WORK_SYSTEM + width * k
        unit = work[pivot + size]
        rest = work[pivot + size + 1]
        for j in range(k + 1, size):
            row = WORK_SYSTEM + width * j
            unit -= work[pivot + j] * work[row + size]
            rest -= work[pivot + j] * work[row + size + 1]
        work[pivot + size] = unit / work[pivot + k]
        work[pivot + size + 1] = rest / work[pivot + k]
    return 0


def solve_loaded(tables: Tables, work: Work, strips: int, force: float, prescribed: float, by_penetration: int):
    """y of the loaded strips under ``force`` [N], or at ``prescribed`` penetration [m]; the penetration."""
    ranks = strip_field(STRIP_RANK)
    size = 0
    for i in range(strips):
        if work[strip_field(STRIP_LOADED) + i] == 1.0:
            work[ranks + size] = float(i)
            size += 1
    for rank in range(size):
        i = int(work[ranks + rank])
        row = WORK_SYSTEM + (size + 2) * rank
        influences = WORK_INFLUENCE + strips * i
        for other in range(size):
            work[row + other] = work[influences + int(work[ranks + other])]
        work[row + size] = work[strip_field(STRIP_TURN) + i]
        work[row + size + 1] = work[strip_field(STRIP_GAP) + i]
    eliminate(work.raw, size)
    unit_load = 0.0
    rest_load = 0.0
    for rank in range(size):
        row = WORK_SYSTEM + (size + 2) * rank
        i = int(work[ranks + rank])
        half = work[strip_field(STRIP_HALF) + i]
        # what of it counts for the prescribed force
        half *= work.regions[int(work[strip_field(STRIP_REGION) + i])].share
        unit_load += half * work[row + size]
        rest_load += half * work[row + size + 1]
    penetration = prescribed
    if by_penetration == 0:
        penetration = (force / (0.5 * pi * pi * tables.contact_modulus) + rest_load) / unit_load
    for i in range(strips):
        work[strip_field(STRIP_SHARE) + i] = 0.0
    for rank in range(size):
        row = WORK_SYSTEM + (size + 2) * rank
        work[strip_field(STRIP_SHARE) + int(work[ranks + rank])] = penetration * work[row + size] - work[row + size + 1]
    return penetration


def exchange_strips(work: 'float[:]', strips: int, penetration: float, single: int):
    """Unload strips that pull, load strips that penetrate (only the last of all where ``single``); how many."""
    loaded = strip_field(STRIP_LOADED)
    shares = strip_field(STRIP_SHARE)
    changed = 0
    for back in range(strips):
        i = strips - 1 - back
        if single == 0 or changed == 0:
            if work[loaded + i] == 1.0:
                if work[shares + i] < 0.0:
                    work[loaded + i] = 0.0
                    changed += 1
            else:
                pushed = (work[strip_field(STRIP_TURN) + i] - TOUCH) * penetration - work[strip_field(STRIP_GAP) + i]
                row = WORK_INFLUENCE + strips * i
                for j in range(strips):
                    pushed -= work[row + j] * work[shares + j]
                if pushed > 0.0:
                    work[loaded + i] = 1.0
                    changed += 1
    return changed


def solve_strips(tables: Tables, work: Work, state: State, strips: int, force: float, prescribed: float,
                 by_penetration: int):
    """Loaded strips and their y with no pull and no penetration; the penetration [m], and 1 when found, else 0."""
    penetration = prescribed
    for exchange in range(EXCHANGE_LIMIT):
        state.strip_count += 1.0
        penetration = solve_loaded(tables, work, strips, force, prescribed, by_penetration)
        single = 0
        if exchange >= EXCHANGES:
            single = 1
        if exchange_strips(work.raw, strips, penetration, single) == 0:
            return penetration, 1
    return penetration, 0


def correct_lengths(tables: Tables, work: 'float[:]', strips: int):
    """Line load, square of the corrected half-length, and pressure of every strip; eqs. (S6)-(S9).

    At fixed line load the half-length follows from two conditions that are one for an ellipse: the middle line's
    curvature along the track, and ANALYN's ratio of line load to half-length.  Their geometric mean is taken.
    """
    stations = strip_field(STRIP_STATION)
    halves = strip_field(STRIP_HALF)
    shares = strip_field(STRIP_SHARE)
    scale = 0.5 * pi * pi * tables.contact_modulus
    for i in range(strips):
        line = 0.0
        square = 0.0
        pressure = 0.0
        if work[shares + i] > 0.0:
            half = work[halves + i]
            line = scale * half * work[shares + i] / work[strip_field(STRIP_WIDTH) + i]
            bend = 0.0
            row = WORK_INFLUENCE + strips * i
            for j in range(strips):
                away = work[stations + i] - work[stations + j]
                bend += work[row + j] * work[shares + j] / (work[halves + j] * work[halves + j] + away * away)
            asked = half * half * bend / (2.0 * work[strip_field(STRIP_A) + i])
            hertz = line / work[strip_field(STRIP_HERTZ) + i]
            square = sqrt(asked * hertz)
            pressure = 2.0 / pi * line / sqrt(square)
        work[strip_field(STRIP_LINE) + i] = line
        work[strip_field(STRIP_SQUARE) + i] = square
        work[strip_field(STRIP_PRESSURE) + i] = pressure
    return 0


def adopt_lengths(work: 'float[:]', strips: int):
    """Let loaded strips have their corrected half-lengths in the next sweep."""
    longest = 0.0
    for i in range(strips):
        if work[strip_field(STRIP_SQUARE) + i] > 0.0:
            half = sqrt(work[strip_field(STRIP_SQUARE) + i])
            work[strip_field(STRIP_HALF) + i] = half
            if half > longest:
                longest = half
    keep_long(work, strips, longest)
    return 0


def run_end(work: 'float[:]', strips: int, first: int):
    """Last strip of the run of loaded strips that begins at ``first``."""
    lines = strip_field(STRIP_LINE)
    last = first
    while last < strips - 1 and work[lines + last + 1] > 0.0 and work[strip_field(STRIP_JOINED) + last] == 1.0:
        last += 1
    return last


def run_edge(work: 'float[:]', strips: int, last: int, first: int, outward: int):
    """Station [m] of the edge beyond strip ``last`` of a run that reaches to ``first`` on the other side."""
    stations = strip_field(STRIP_STATION)
    lines = strip_field(STRIP_LINE)
    station = work[stations + last]
    edge = station + 0.5 * float(outward) * work[strip_field(STRIP_WIDTH) + last]
    if last != first:
        # no farther than the middle of the next strip, which carries nothing
        limit = edge
        after = last + outward
        beside = last
        if outward < 0:
            beside = last - 1
        if after >= 0 and after < strips:
            if work[strip_field(STRIP_JOINED) + beside] == 1.0:
                limit = work[stations + after]
        inner = last - outward
        fall = work[lines + inner] - work[lines + last]
        edge = limit
        if fall > 0.0:
            reach = work[lines + last] / fall * (station - work[stations + inner])
            if reach * float(outward) < (limit - station) * float(outward):
                edge = station + reach
    return edge


def start_loaded(work: 'float[:]', strips: int):
    """Load the strip with the smallest gap where ANALYN loads none of them."""
    least = 0
    loaded = 0.0
    for i in range(strips):
        loaded += work[strip_field(STRIP_LOADED) + i]
        if work[strip_field(STRIP_GAP) + i] < work[strip_field(STRIP_GAP) + least]:
            least = i
    if loaded == 0.0:
        work[strip_field(STRIP_LOADED) + least] = 1.0
    return 0


def correct_strips(tables: Tables, work: Work, state: State, count: int, force: float, predicted: float,
                   by_penetration: int):
    """Strip correction of ANALYN's ``count`` regions at its ``predicted`` penetration [m]; the corrected penetration
    [m], the number of strips, and 1 when met, else 0."""
    strips = place_strips(tables, work, count, predicted)
    join_strips(work.raw, strips)
    describe_strips(work, strips, predicted)
    start_loaded(work.raw, strips)
    for i in range(strips):
        measure_distances(work, strips, i, i)
    penetration = predicted
    met = 0
    sweeps = int(tables.sweeps)
    for sweep in range(sweeps):
        fill_influence(tables, work, strips, count)
        penetration, met = solve_strips(tables, work, state, strips, force, predicted, by_penetration)
        if met == 0:
            return penetration, strips, met
        correct_lengths(tables, work.raw, strips)
        if sweep < sweeps - 1:
            adopt_lengths(work.raw, strips)
            fit_edges(work, strips)
    return penetration, strips, met
