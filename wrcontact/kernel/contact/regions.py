"""Where a wheel may carry load: the contact point's own region and others whose gap is small enough.

A region is the neighbourhood of a local minimum of the normal gap.  Between two minima lies a saddle, where
the gap is largest.  Both belong to one region while the saddle stays below MERGE of the penetration;
otherwise it bounds both.
"""

from math import fabs, sqrt
from typing import Final

from ..layout import (
    LOAD_VERTICAL,
    RAIL,
    REGION_LIMIT,
    REGION_SIZE,
    WHEEL,
    Frame,
    Region,
    Regions,
    SideSearch,
    State,
    Tables,
)
from ..search.smallest_gap import list_minima
from ..surface.profile_table import height_slope
from .contact_plane import normal_gap
from .traces import start_traces

#: Two minima are one region while the saddle between them is below this share of the penetration.  Against
#: the complete theory 0.3 does best; 0.2 parts the centred S1002 (peak pressure +14 %), 0.45 joins what is
#: separate.
MERGE: Final[float] = 0.3
#: Minima closer than this to another are the same [m].
SEPARATE: Final[float] = 2e-4
#: A minimum of the normal gap lies within this of the vertical gap's [m]; 2 mm where a tread is seen from a
#: flange.
WANDER: Final[float] = 5e-3
#: Step towards a minimum while the gap bends downwards: half a scan cell [m].
DOWNHILL: Final[float] = 0.25e-3
#: Gap of a region that does not exist, and station of a bound that is none [m]; longer than any profile.
BEYOND: Final[float] = 1.0
#: Tolerance of the traces while minima and saddles are sought [m]; the residual is removed to second order,
#: which leaves rounding.
PLACE_TRACE: Final[float] = 1e-8
#: Last Newton step to a minimum or a saddle [m]; a saddle cuts a load.
PLACE_SHARP: Final[float] = 1e-11
SADDLE_SAMPLES: Final[int] = 8
MINIMUM_ITERATIONS: Final[int] = 30


def open_region(tables: Tables, frame: Frame, region: Region, state: State, station: float):
    """Start a region at the gap's local minimum near ``station``; its gap [m] (BEYOND if there is none)."""
    start = station
    gap = BEYOND
    found = BEYOND
    bend = 0.0
    curvature = 0.0
    low = start - WANDER
    high = start + WANDER
    for i in range(MINIMUM_ITERATIONS):
        gap, rate, bend, curvature = normal_gap(tables, frame, state, station, PLACE_TRACE)
        # downhill, until the gap bends upwards
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
        if ((station + move > high and high < start + WANDER)
                or (station + move < low and low > start - WANDER)):
            # the curvature jumps in between
            move = 0.5 * (low + high) - station
        if station + move > start + WANDER:
            move = start + WANDER - station
        if station + move < start - WANDER:
            move = start - WANDER - station
        if fabs(move) < PLACE_SHARP:
            break
        station += move
    region.station = station
    region.gap = gap
    region.rail = frame.traces[RAIL].abscissa
    region.wheel = frame.traces[WHEEL].abscissa
    region.bend = bend
    region.curvature = curvature
    height, slope = height_slope(tables.rail, frame.traces[RAIL].abscissa)
    incline_region(tables, region, slope)
    return found


def incline_region(tables: Tables, region: Region, slope: float):
    """Give a region in the contact point's plane its inclination, the rail's ``slope`` there, and what
    follows from it."""
    cosine = 1.0 / sqrt(1.0 + slope * slope)
    region.inclination = slope
    region.own = False
    region.alignment = 1.0
    region.offset = 0.0
    region.cos = cosine
    region.sin = slope * cosine
    region.share = 1.0
    if tables.load == LOAD_VERTICAL:
        region.share = cosine
    return 0


def measure_contact(tables: Tables, frame: Frame, state: State):
    """Note in the open frame how the gap bends at the contact point, and the wheel's 1/R_x."""
    gap, rate, bend, curvature = normal_gap(tables, frame, state, 0.0, PLACE_TRACE)
    frame.bend = bend
    frame.curvature = curvature
    return 0


def open_contact_region(tables: Tables, frame: Frame, region: Region):
    """The region of the rigid contact point itself, station and gap zero."""
    region.station = 0.0
    region.gap = 0.0
    region.rail = frame.rail.y
    region.wheel = frame.wheel.y
    region.bend = frame.bend
    region.curvature = frame.curvature
    region.low = -BEYOND
    region.high = BEYOND
    incline_region(tables, region, frame.plane.sin / frame.plane.cos)
    return 0


def find_regions(tables: Tables, frame: Frame, regions: Regions, side: SideSearch, state: State,
                 level: float):
    """Open the regions whose smallest gap is below ``level`` [m]; their count, region 0 included.

    They are sought at the local minima of the vertical gap.
    """
    count = 1
    reach = side.best + 2.0 * level / frame.plane.cos
    list_minima(tables, side, state, reach, frame.rail.y)
    for i in range(side.first, side.last + 1):
        if count < REGION_LIMIT:
            y = side.candidates[i].y
            abscissa = side.candidates[i].rail
            height, slope = height_slope(tables.rail, abscissa)
            station = ((abscissa - frame.rail.y) * frame.plane.cos
                       + (height - frame.rail.z) * frame.plane.sin)
            start_traces(frame, station, abscissa, y)
            if open_region(tables, frame, regions[count], state, station) < level:
                if is_new(regions, count) == 1:
                    count += 1
    return count


def is_new(regions: Regions, count: int):
    """1 if region ``count`` is away from all before it, else 0."""
    new = 1
    for i in range(count):
        distance = regions[i].station - regions[count].station
        if fabs(distance) < SEPARATE:
            new = 0
    return new


def bound_regions(tables: Tables, frame: Frame, regions: Regions, state: State, count: int, level: float):
    """Order the regions by station, set the saddles between them as bounds, and join those with a low saddle;
    the count."""
    for i in range(count - 1):
        for j in range(count - 1 - i):
            if regions[j].station > regions[j + 1].station:
                swap_regions(regions[j], regions[j + 1])
    regions[0].low = -BEYOND
    regions[count - 1].high = BEYOND
    i = 0
    while i < count - 1:
        low = regions[i]
        high = regions[i + 1]
        station, gap = find_saddle(tables, frame, low, high, state)
        if gap < MERGE * level:
            if high.gap < low.gap:
                bound = low.low
                swap_regions(low, high)
                low.low = bound
            for j in range(i + 1, count - 1):
                swap_regions(regions[j], regions[j + 1])
            count -= 1
            regions[count - 1].high = BEYOND
        else:
            low.high = station
            high.low = station
            i += 1
    return count


def swap_regions(first: Region, second: Region):
    """Exchange two regions."""
    for i in range(REGION_SIZE):
        kept = first[i]
        first[i] = second[i]
        second[i] = kept
    return 0


def find_saddle(tables: Tables, frame: Frame, low: Region, high: Region, state: State):
    """Station and gap [m] of the saddle between two regions: best of SADDLE_SAMPLES, then
    Newton on the rate."""
    left = low.station
    right = high.station
    start_traces(frame, left, low.rail, low.wheel)
    step = (right - left) / float(SADDLE_SAMPLES + 1)
    top = left
    largest = -BEYOND
    for i in range(1, SADDLE_SAMPLES + 1):
        station = left + step * float(i)
        gap, rate, bend, curvature = normal_gap(tables, frame, state, station, PLACE_TRACE)
        if gap > largest:
            largest = gap
            top = station
    station = top
    for i in range(MINIMUM_ITERATIONS):
        gap, rate, bend, curvature = normal_gap(tables, frame, state, station, PLACE_TRACE)
        if not bend < 0.0 or fabs(station - top) > step:
            return top, largest
        move = -rate / bend
        if fabs(move) < PLACE_SHARP:
            return station, gap
        station += move
    return top, largest
