"""Where a wheel may carry load: the contact point's own region and others whose gap is small enough.

A region is the neighbourhood of a local minimum of the normal gap.  Two minima belong to one region while the hump
between them stays below MERGE of the penetration; otherwise the hump bounds both.
"""

from math import fabs, sqrt
from typing import Final

from ..layout import LOAD_VERTICAL, REGION_BLOCK, REGION_LIMIT, Region, SideSearch, State, Tables, Work
from ..search.smallest_gap import list_minima
from ..surface.profile_table import height_slope
from .contact_plane import NO_GAP, normal_gap, start_tracer
from .separation import open_origin, separation

# a region block

#: Two minima are one region while the hump between them is below this share of the penetration.  Against the complete
#: theory 0.3 does best; 0.2 parts the centred S1002 (peak pressure +14 %), 0.45 joins what is separate.
MERGE: Final[float] = 0.3
#: Minima closer than this to another are the same [m].
APART: Final[float] = 2e-4
#: A minimum of the normal gap lies within this of the vertical gap's [m]; 2 mm where a tread is seen from a flange.
WANDER: Final[float] = 5e-3
DOWNHILL: Final[float] = 0.25e-3
FAR: Final[float] = 1.0
TRACE: Final[float] = 1e-12          # tolerance of the abscissae while minima and humps are sought [m]
PLACE_SHARP: Final[float] = 1e-11    # last Newton step to a minimum or a hump [m]; a hump cuts a load
WIDTH_TRACE: Final[float] = 5e-8     # and while half-widths are measured [m]
HALVED_SHARP: Final[float] = 1e-9    # last halving, relative
WIDTH_ITERATIONS: Final[int] = 60
WIDTH_SHARP: Final[float] = 5e-3     # last Newton step, relative; its error is a tenth of the square
PRESSED_SHARP: Final[float] = 1e-5   # where height and roll are sought, which asks for a smooth answer
HUMP_SAMPLES: Final[int] = 8
MINIMUM_ITERATIONS: Final[int] = 30





def open_region(tables: Tables, work: Work, state: State, index: int, station: float):
    """Start region ``index`` at the gap's local minimum near ``station``; its gap [m] (FAR if there is none)."""
    block = work.regions[index]
    start = station
    gap = FAR
    found = FAR
    bend = 0.0
    curvature = 0.0
    low = start - WANDER
    high = start + WANDER
    for i in range(MINIMUM_ITERATIONS):
        gap, rate, bend, curvature = normal_gap(tables, work, state, station, TRACE)
        # half a scan cell downhill, until the gap bends upwards
        move = -DOWNHILL
        if rate < 0.0:
            move = DOWNHILL
            low = station
        else:
            high = station
        if bend > 0.0:
            move = -rate / bend
            if fabs(move) < PLACE_SHARP:
                found = gap
        if (station + move > high and high < start + WANDER) or (station + move < low and low > start - WANDER):
            # the curvature jumps in between
            move = 0.5 * (low + high) - station
        if station + move > start + WANDER:
            move = start + WANDER - station
        if station + move < start - WANDER:
            move = start - WANDER - station
        if fabs(move) < PLACE_SHARP:
            break
        station += move
    block.station = station
    block.gap = gap
    block.rail = work.frame.tracer_rail
    block.wheel = work.frame.tracer_wheel
    block.bend = bend
    block.curvature = curvature
    height, slope = height_slope(tables.rail, work.frame.tracer_rail)
    lean_region(tables, work, block, slope)
    return found


def lean_region(tables: Tables, work: Work, block: Region, slope: float):
    """Angle of a region in the contact point's plane from the rail's ``slope`` there, and what follows from it."""
    cosine = 1.0 / sqrt(1.0 + slope * slope)
    block.lean = slope
    block.own = False
    block.turn = 1.0
    block.offset = 0.0
    block.cos = cosine
    block.sin = slope * cosine
    block.share = 1.0
    if int(tables.load) == LOAD_VERTICAL:
        block.share = cosine
    return 0


def open_contact_region(tables: Tables, work: Work, state: State):
    """Region 0: the rigid contact point itself, station and gap zero."""
    block = work.regions[0]
    gap, rate, bend, curvature = normal_gap(tables, work, state, 0.0, TRACE)
    block.station = 0.0
    block.gap = 0.0
    block.rail = work.frame.abscissa
    block.wheel = work.frame.y
    block.bend = bend
    block.curvature = curvature
    block.low = -FAR
    block.high = FAR
    lean_region(tables, work, block, work.frame.sin / work.frame.cos)
    return 0


def find_regions(tables: Tables, work: Work, state: State, side: SideSearch, level: float):
    """Open the regions whose smallest gap is below ``level`` [m]; their count, region 0 included.

    They are sought at the local minima of the vertical gap.
    """
    count = 1
    reach = side.best + 2.0 * level / work.frame.cos
    list_minima(tables, side, state, reach, work.frame.abscissa)
    for i in range(side.first, side.last + 1):
        if count < REGION_LIMIT:
            y = side.candidates[i].y
            abscissa = side.candidates[i].rail
            height, slope = height_slope(tables.rail, abscissa)
            station = ((abscissa - work.frame.abscissa) * work.frame.cos
                       + (height - work.frame.height) * work.frame.sin)
            start_tracer(work, station, abscissa, y)
            if open_region(tables, work, state, count, station) < level:
                if is_new(work, count) == 1:
                    count += 1
    return count


def is_new(work: Work, count: int):
    """1 if region ``count`` is away from all before it, else 0."""
    new = 1
    for i in range(count):
        distance = work.regions[i].station - work.regions[count].station
        if fabs(distance) < APART:
            new = 0
    return new


def bound_regions(tables: Tables, work: Work, state: State, count: int, level: float):
    """Order the regions by station, set the humps between them as bounds, and join those with a low hump; the count."""
    for i in range(count - 1):
        for j in range(count - 1 - i):
            if work.regions[j].station > work.regions[j + 1].station:
                swap_regions(work.regions[j], work.regions[j + 1])
    work.regions[0].low = -FAR
    work.regions[count - 1].high = FAR
    i = 0
    while i < count - 1:
        low = work.regions[i]
        high = work.regions[i + 1]
        station, gap = find_hump(tables, work, state, low, high)
        if gap < MERGE * level:
            if high.gap < low.gap:
                bound = low.low
                swap_regions(work.regions[i], work.regions[i + 1])
                low.low = bound
            for j in range(i + 1, count - 1):
                swap_regions(work.regions[j], work.regions[j + 1])
            count -= 1
            work.regions[count - 1].high = FAR
        else:
            low.high = station
            high.low = station
            i += 1
    return count


def swap_regions(first: Region, second: Region):
    """Exchange two regions."""
    for i in range(REGION_BLOCK):
        kept = first[i]
        first[i] = second[i]
        second[i] = kept
    return 0


def find_hump(tables: Tables, work: Work, state: State, low: Region, high: Region):
    """Station and gap [m] of the hump between two regions: best of HUMP_SAMPLES, then Newton on the rate."""
    left = low.station
    right = high.station
    start_tracer(work, left, low.rail, low.wheel)
    step = (right - left) / float(HUMP_SAMPLES + 1)
    top = left
    largest = -FAR
    for i in range(1, HUMP_SAMPLES + 1):
        station = left + step * float(i)
        gap, rate, bend, curvature = normal_gap(tables, work, state, station, TRACE)
        if gap > largest:
            largest = gap
            top = station
    station = top
    for i in range(MINIMUM_ITERATIONS):
        gap, rate, bend, curvature = normal_gap(tables, work, state, station, TRACE)
        if not bend < 0.0 or fabs(station - top) > step:
            return top, largest
        move = -rate / bend
        if fabs(move) < PLACE_SHARP:
            return station, gap
        station += move
    return top, largest


def zone_width(tables: Tables, work: Work, state: State, block: Region, direction: float, level: float,
               guess: float):
    """Distance [m] from the region's minimum to where the gap has risen by ``level`` [m], or to the region's bound or the
    end of a profile; REGION_REACHED holds how far it has risen there, and there the tracer stands.

    Doubling to a bracket, then Newton on the square root of the gap, which is nearly linear.  The gap is the chosen
    separation, with arcs in place of the chords whose length follows from this width.
    """
    limit = block.high - block.station
    if direction < 0.0:
        limit = block.station - block.low
    start_tracer(work, block.station, block.rail, block.wheel)
    open_origin(tables, work, block.station, block.gap, block.rail,
                block.wheel, 0.0)
    tolerance = 1e-3 * guess
    if tolerance > WIDTH_TRACE:
        tolerance = WIDTH_TRACE
    root = sqrt(level)
    low = 0.0
    high = -1.0
    width = guess
    block.reached = 0.0
    station = block.station
    abscissa = block.rail
    y = block.wheel
    for i in range(WIDTH_ITERATIONS):
        if width > limit:
            width = limit
        gap, rate, bend, curvature = separation(tables, work, state,
                                                block.station + direction * width, tolerance)
        if gap >= NO_GAP:
            # beyond an end the tracer has lost its way
            start_tracer(work, station, abscissa, y)
        else:
            station = work.frame.tracer_station
            abscissa = work.frame.tracer_rail
            y = work.frame.tracer_wheel
        rise = gap - block.gap
        if rise < level:
            low = width
            block.reached = rise
            if width >= limit:
                return limit
        else:
            high = width
        following = 2.0 * width
        sharp = HALVED_SHARP
        near = WIDTH_SHARP
        if work.frame.pressed:
            near = PRESSED_SHARP
        if high > 0.0:
            following = 0.5 * (low + high)
        if rise > 0.0 and rate * direction > 0.0:
            square = sqrt(rise)
            newton = width + (root - square) * 2.0 * square / (rate * direction)
            if newton > low and newton < 4.0 * width and (high < 0.0 or newton < high):
                following = newton
                sharp = near
        if fabs(following - width) < sharp * width:
            if sharp == near:
                block.reached = level
            return following
        width = following
    return width
