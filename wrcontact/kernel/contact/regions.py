"""Where a wheel may carry load: the contact point's own region and others whose gap is small enough.

A region is the neighbourhood of a local minimum of the normal gap.  Two minima belong to one region while the hump
between them stays below MERGE of the penetration; otherwise the hump bounds both.
"""

from math import fabs, sqrt
from typing import Final

from .contact_plane import (FRAME_ABSCISSA, FRAME_COS, FRAME_HEIGHT, FRAME_PLACE, FRAME_PRESSED, FRAME_SIN, FRAME_Y,
                            NO_GAP, TRACER_RAIL, TRACER_STATION, TRACER_WHEEL, normal_gap, start_tracer)
from ..layout import (LOAD_VERTICAL, REGION_BLOCK, REGION_LIMIT, SET_LOAD, SET_RAIL, SIDE_ABSCISSA, SIDE_BEST, SIDE_FIRST,
                     SIDE_LAST, SIDE_PLACE, WORK_REGION)
from ..surface.profile_table import height_slope
from ..search.search import scan_side
from .separation import open_origin, separation

# a region block
REGION_STATION: Final[int] = 0       # of the minimum [m]
REGION_GAP: Final[int] = 1           # there [m]
REGION_RAIL: Final[int] = 2          # rail and wheel abscissa there [m]
REGION_WHEEL: Final[int] = 3
REGION_LOW: Final[int] = 4           # stations that bound it [m]
REGION_HIGH: Final[int] = 5
REGION_WIDTH_LOW: Final[int] = 6     # half-widths of the interpenetration [m]
REGION_WIDTH_HIGH: Final[int] = 7
REGION_SPACING: Final[int] = 8       # of its nodes [m]
REGION_FIRST: Final[int] = 9         # first and last node
REGION_LAST: Final[int] = 10
REGION_LEVEL: Final[int] = 11        # local penetration: total minus own gap minus what other regions push down [m]
REGION_LOAD: Final[int] = 12         # [N]
REGION_STIFFNESS: Final[int] = 13    # load per level [N/m]
REGION_BEND: Final[int] = 14         # second derivative of the gap at the minimum [1/m]
REGION_CURVATURE: Final[int] = 15    # the wheel's 1/R_x at the minimum [1/m]
REGION_MIDDLE: Final[int] = 16       # station that stands for its load in the interaction [m]
REGION_START: Final[int] = 21        # where its strips begin and end [m]
REGION_STOP: Final[int] = 22
REGION_REACHED: Final[int] = 25      # rise of the gap where the last half-width ends [m]
REGION_SIDE_LOW: Final[int] = 26     # lateral curvature on either side, rise over square of the half-width [1/m]
REGION_SIDE_HIGH: Final[int] = 27
REGION_UPRIGHT_A: Final[int] = 28    # upright ellipse with the strips of a yawed wheel's tilted one: its A and B over the
REGION_UPRIGHT_B: Final[int] = 29    # real ones, and its penetration over the real one [-]
REGION_UPRIGHT_SHARE: Final[int] = 30
REGION_SLANT: Final[int] = 31        # of the line along which the gap is smallest, dx/ds [-]; of a yawed wheel only
REGION_OWN: Final[int] = 32          # 1 if it has a plane of its own, else 0
REGION_TURN: Final[int] = 33         # how much of the penetration comes along its normal [-]
REGION_OFFSET: Final[int] = 34       # from its own stations to those of the outputs [m]
REGION_COS: Final[int] = 35          # of the angle along which its force acts: the rail's at its minimum, or the mean over it
REGION_SIN: Final[int] = 36
REGION_SHARE: Final[int] = 37        # of its load that counts for the prescribed force
REGION_MOMENT: Final[int] = 38       # of the load that it carries, over the stations of the outputs [N m]
REGION_CARRIED: Final[int] = 39      # that load [N]
REGION_LEAN: Final[int] = 40         # slope of the rail at its minimum
REGION_ALONG: Final[int] = 41        # track coordinate x of the minimum [m], where regions lean apart
REGION_SQUARE: Final[int] = 24       # square of its half-length as estimated [m^2]
REGION_WEIGHT: Final[int] = 23       # integral of their density's graded part
REGION_WIDTH_LEVEL: Final[int] = 20  # level that the half-widths were measured at [m]
REGION_RESIDUAL: Final[int] = 17     # of its level during the force solve [m]
REGION_SLOPE: Final[int] = 18        # change of its level per change of the penetration [-]
REGION_MOVE: Final[int] = 19         # change of its level that closes the residual [m]

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


def region_block(index: int):
    """Offset of region ``index`` in the workspace."""
    return WORK_REGION + REGION_BLOCK * index


def open_region(tables: 'float[:]', work: 'float[:]', state: 'float[:]', index: int, station: float):
    """Start region ``index`` at the gap's local minimum near ``station``; its gap [m] (FAR if there is none)."""
    block = region_block(index)
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
    work[block + REGION_STATION] = station
    work[block + REGION_GAP] = gap
    work[block + REGION_RAIL] = work[TRACER_RAIL]
    work[block + REGION_WHEEL] = work[TRACER_WHEEL]
    work[block + REGION_BEND] = bend
    work[block + REGION_CURVATURE] = curvature
    height, slope = height_slope(tables, int(tables[SET_RAIL]), work[TRACER_RAIL])
    lean_region(tables, work, block, slope)
    return found


def lean_region(tables: 'float[:]', work: 'float[:]', block: int, slope: float):
    """Angle of a region in the contact point's plane from the rail's ``slope`` there, and what follows from it."""
    cosine = 1.0 / sqrt(1.0 + slope * slope)
    work[block + REGION_LEAN] = slope
    work[block + REGION_OWN] = 0.0
    work[block + REGION_TURN] = 1.0
    work[block + REGION_OFFSET] = 0.0
    work[block + REGION_COS] = cosine
    work[block + REGION_SIN] = slope * cosine
    work[block + REGION_SHARE] = 1.0
    if int(tables[SET_LOAD]) == LOAD_VERTICAL:
        work[block + REGION_SHARE] = cosine
    return 0


def open_contact_region(tables: 'float[:]', work: 'float[:]', state: 'float[:]'):
    """Region 0: the rigid contact point itself, station and gap zero."""
    block = region_block(0)
    gap, rate, bend, curvature = normal_gap(tables, work, state, 0.0, TRACE)
    work[block + REGION_STATION] = 0.0
    work[block + REGION_GAP] = 0.0
    work[block + REGION_RAIL] = work[FRAME_ABSCISSA]
    work[block + REGION_WHEEL] = work[FRAME_Y]
    work[block + REGION_BEND] = bend
    work[block + REGION_CURVATURE] = curvature
    work[block + REGION_LOW] = -FAR
    work[block + REGION_HIGH] = FAR
    lean_region(tables, work, block, work[FRAME_SIN] / work[FRAME_COS])
    return 0


def find_regions(tables: 'float[:]', work: 'float[:]', state: 'float[:]', side: int, level: float):
    """Open the regions whose smallest gap is below ``level`` [m]; their count, region 0 included.

    They are sought at the local minima of the vertical gap.
    """
    count = 1
    reach = work[side + SIDE_BEST] + 2.0 * level / work[FRAME_COS]
    scan_side(tables, work, side, work, int(work[FRAME_PLACE]), state, reach, work[FRAME_ABSCISSA])
    for i in range(int(work[side + SIDE_FIRST]), int(work[side + SIDE_LAST]) + 1):
        if count < REGION_LIMIT:
            y = work[side + SIDE_PLACE + i]
            abscissa = work[side + SIDE_ABSCISSA + i]
            height, slope = height_slope(tables, int(tables[SET_RAIL]), abscissa)
            station = ((abscissa - work[FRAME_ABSCISSA]) * work[FRAME_COS]
                       + (height - work[FRAME_HEIGHT]) * work[FRAME_SIN])
            start_tracer(work, station, abscissa, y)
            if open_region(tables, work, state, count, station) < level:
                if is_new(work, count) == 1:
                    count += 1
    return count


def is_new(work: 'float[:]', count: int):
    """1 if region ``count`` is away from all before it, else 0."""
    new = 1
    for i in range(count):
        distance = work[region_block(i) + REGION_STATION] - work[region_block(count) + REGION_STATION]
        if fabs(distance) < APART:
            new = 0
    return new


def bound_regions(tables: 'float[:]', work: 'float[:]', state: 'float[:]', count: int, level: float):
    """Order the regions by station, set the humps between them as bounds, and join those with a low hump; the count."""
    for i in range(count - 1):
        for j in range(count - 1 - i):
            if work[region_block(j) + REGION_STATION] > work[region_block(j + 1) + REGION_STATION]:
                swap_regions(work, j, j + 1)
    work[region_block(0) + REGION_LOW] = -FAR
    work[region_block(count - 1) + REGION_HIGH] = FAR
    i = 0
    while i < count - 1:
        low = region_block(i)
        high = region_block(i + 1)
        station, gap = find_hump(tables, work, state, low, high)
        if gap < MERGE * level:
            if work[high + REGION_GAP] < work[low + REGION_GAP]:
                bound = work[low + REGION_LOW]
                swap_regions(work, i, i + 1)
                work[low + REGION_LOW] = bound
            for j in range(i + 1, count - 1):
                swap_regions(work, j, j + 1)
            count -= 1
            work[region_block(count - 1) + REGION_HIGH] = FAR
        else:
            work[low + REGION_HIGH] = station
            work[high + REGION_LOW] = station
            i += 1
    return count


def swap_regions(work: 'float[:]', first: int, second: int):
    """Exchange two region blocks."""
    for i in range(REGION_BLOCK):
        kept = work[region_block(first) + i]
        work[region_block(first) + i] = work[region_block(second) + i]
        work[region_block(second) + i] = kept
    return 0


def find_hump(tables: 'float[:]', work: 'float[:]', state: 'float[:]', low: int, high: int):
    """Station and gap [m] of the hump between two regions: best of HUMP_SAMPLES, then Newton on the rate."""
    left = work[low + REGION_STATION]
    right = work[high + REGION_STATION]
    start_tracer(work, left, work[low + REGION_RAIL], work[low + REGION_WHEEL])
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


def zone_width(tables: 'float[:]', work: 'float[:]', state: 'float[:]', block: int, direction: float, level: float,
               guess: float):
    """Distance [m] from the region's minimum to where the gap has risen by ``level`` [m], or to the region's bound or the
    end of a profile; REGION_REACHED holds how far it has risen there, and there the tracer stands.

    Doubling to a bracket, then Newton on the square root of the gap, which is nearly linear.  The gap is the chosen
    separation, with arcs in place of the chords whose length follows from this width.
    """
    limit = work[block + REGION_HIGH] - work[block + REGION_STATION]
    if direction < 0.0:
        limit = work[block + REGION_STATION] - work[block + REGION_LOW]
    start_tracer(work, work[block + REGION_STATION], work[block + REGION_RAIL], work[block + REGION_WHEEL])
    open_origin(tables, work, work[block + REGION_STATION], work[block + REGION_GAP], work[block + REGION_RAIL],
                work[block + REGION_WHEEL], 0.0)
    tolerance = 1e-3 * guess
    if tolerance > WIDTH_TRACE:
        tolerance = WIDTH_TRACE
    root = sqrt(level)
    low = 0.0
    high = -1.0
    width = guess
    work[block + REGION_REACHED] = 0.0
    station = work[block + REGION_STATION]
    abscissa = work[block + REGION_RAIL]
    y = work[block + REGION_WHEEL]
    for i in range(WIDTH_ITERATIONS):
        if width > limit:
            width = limit
        gap, rate, bend, curvature = separation(tables, work, state,
                                                work[block + REGION_STATION] + direction * width, tolerance)
        if gap >= NO_GAP:
            # beyond an end the tracer has lost its way
            start_tracer(work, station, abscissa, y)
        else:
            station = work[TRACER_STATION]
            abscissa = work[TRACER_RAIL]
            y = work[TRACER_WHEEL]
        rise = gap - work[block + REGION_GAP]
        if rise < level:
            low = width
            work[block + REGION_REACHED] = rise
            if width >= limit:
                return limit
        else:
            high = width
        following = 2.0 * width
        sharp = HALVED_SHARP
        near = WIDTH_SHARP
        if work[FRAME_PRESSED] == 1.0:
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
                work[block + REGION_REACHED] = level
            return following
        width = following
    return width
