"""What wheel and rail are under the strips: traced once at even stations of every zone, where wheel and rail
overlap, and read between them.

The overlap follows cubics with its own slope at the stations, all else straight lines.
"""

from math import fabs, sqrt
from typing import Final

from ..contact.curves import open_origin
from ..contact.frame import NO_GAP, enter_plane, is_yawed, leave_plane
from ..contact.separation import separation
from ..contact.traces import start_traces
from ..contact.widths import zone_width
from ..layout import (
    LOAD_VERTICAL,
    LONGITUDINAL_BASIC,
    RAIL,
    WHEEL,
    Contact,
    Frame,
    Pair,
    Place,
    Region,
    StripProblem,
    StripZone,
    Tables,
    TracedStation,
)
from ..surface.curvature import longitudinal_curvature
from ..surface.locus import outline_x
from ..surface.rails import upright_share
from ..surface.tables import height_slope, height_slope_bend
from .coefficients import hertz_coefficients, middle_slant, skewed_coefficients, table_value
from .strip_pressures import TESTED

#: A zone ends where the overlap has fallen to this share of the deepest one, or of its own: far from the
#: deepest, a region is loaded long before it is so deep.
SHALLOW: Final[float] = 0.03
OWN_SHALLOW: Final[float] = 0.25
#: Stations of a zone, and how far the outermost ones lie inside, of the distance between two.
ZONE_STATIONS: Final[int] = 16
INSET: Final[float] = 0.1
#: Zones and runs closer than this share of their width touch.
TOUCHING: Final[float] = 1e-5
#: To what the abscissae of wheel and rail are traced [m].
STRIP_TRACE: Final[float] = 1e-9
#: Lateral curvatures of a zone over A are within these.
FLATTEST_ZONE: Final[float] = 0.02
SHARPEST_ZONE: Final[float] = 1e3
#: Beside a yawed wheel's ridge, the level of a station counts as no less than this share of its zone's depth.
LEAST_LEVEL: Final[float] = 0.05


def find_zones(pair: Pair, contact: Contact, count: int, deepest: float):
    """The zones of ``count`` regions, of which the deepest overlaps by ``deepest`` [m]."""
    for index in range(count):
        region = contact.regions[index]
        enter_plane(contact.frame, contact.frames, region, index)
        measure_zone(pair, contact, region, contact.strip_problem.zones[index], deepest)
        leave_plane(contact.frame, contact.frames, region)


def measure_zone(pair: Pair, contact: Contact, region: Region, zone: StripZone, deepest: float):
    """The zone of a region whose frame is open; without width where nothing overlaps."""
    zone.middle = region.offset + region.station
    zone.start = zone.middle
    zone.stop = zone.middle
    zone.depth = contact.frame.depth
    level = zone.depth - min(SHALLOW * deepest, OWN_SHALLOW * zone.depth)
    if level > 0.0:
        bend = max(region.bend, region.curvature)
        estimate = sqrt(2.0 * level / bend)
        contact.frame.blur = 0.0
        high = zone_width(pair, contact.frame, contact.origin, region, 1.0, level, estimate)
        low = zone_width(pair, contact.frame, contact.origin, region, -1.0, level, high)
        zone.stop += high
        zone.start -= low


def weigh_zone(pair: Pair, problem: StripProblem, zone: StripZone, A: float, first: int, yawed: bool):
    """ANALYN's coefficients of a zone, by how wide it is to either side: Hertz's for gap and curvature.  Of a
    yawed wheel those of its slanted ridge, from its stations, which begin with number ``first``; levels and
    ridges of the stations."""
    tables = pair.tables
    low = zone_curvature(zone.depth, zone.middle - zone.start, A)
    high = zone_curvature(zone.depth, zone.stop - zone.middle, A)
    B = sqrt(low * high)
    one_alpha, one_beta, nr = hertz_coefficients(tables.hertz, A, B)
    low_beta = table_value(tables.hertz, 0, A / low)
    high_beta = table_value(tables.hertz, 0, A / high)
    zone.lean = 0.0
    if yawed:
        start = problem.traced[first]
        stop = problem.traced[first + ZONE_STATIONS - 1]
        slant = (stop.x - start.x) / (stop.station - start.station)
        one_alpha, beta, nr = skewed_coefficients(tables.hertz, A, B, slant)
        zone.lean = middle_slant(tables.hertz, A, B, slant) - slant
        low_beta *= beta / one_beta
        high_beta *= beta / one_beta
    zone.one_alpha = one_alpha
    zone.line = tables.contact_modulus / nr
    for i in range(first, first + ZONE_STATIONS):
        at = problem.traced[i]
        beta = low_beta
        if at.station > zone.middle:
            beta = high_beta
        at.level = zone.depth - beta * (zone.depth - at.overlap)


def zone_curvature(depth: float, width: float, A: float):
    """Lateral curvature [1/m] with which the gap rises by the ``depth`` [m] over the ``width`` of a zone to
    one side [m]; between FLATTEST_ZONE A and SHARPEST_ZONE A."""
    B = SHARPEST_ZONE * A
    if depth < B * width * width:
        B = depth / (width * width)
    B = max(B, FLATTEST_ZONE * A)
    return B


def trace_zones(pair: Pair, contact: Contact, count: int):
    """Wheel and rail at the stations of the zones of ``count`` regions."""
    problem = contact.strip_problem
    problem.traced_count = 0
    for index in range(count):
        zone = problem.zones[index]
        if zone.stop > zone.start:
            region = contact.regions[index]
            first = problem.traced_count
            if index > 0 and first > 0:
                apart = zone.start - problem.zones[index - 1].stop
                problem.traced[first - 1].joined = apart < TOUCHING * (zone.stop - zone.start)
            enter_plane(contact.frame, contact.frames, region, index)
            start_traces(contact.frame, region.station, region.rail, region.wheel)
            open_origin(pair, contact.frame, contact.origin, region, 0.0)
            zone.spacing = (zone.stop - zone.start) / (float(ZONE_STATIONS - 1) + 2.0 * INSET)
            for i in range(ZONE_STATIONS):
                at = problem.traced[first + i]
                at.station = zone.start + (float(i) + INSET) * zone.spacing
                at.region = index
                at.joined = i < ZONE_STATIONS - 1
                trace_station(pair, contact, region, at)
            problem.traced_count = first + ZONE_STATIONS
            weigh_zone(pair, problem, zone, 0.5 * region.curvature, first, is_yawed(contact.frame))
            leave_plane(contact.frame, contact.frames, region)
    place_on_middle(problem)
    for i in range(problem.traced_count):
        incline_station(pair.tables, contact.frame, problem.traced[i])
    bend_gaps(problem)


def trace_station(pair: Pair, contact: Contact, region: Region, at: TracedStation):
    """Wheel and rail at a station of ``region``, whose frame is open."""
    frame = contact.frame
    gap, rate, bend, curvature = separation(
        pair, frame, contact.origin, at.station - region.offset, STRIP_TRACE
    )
    at.rise = 0.0
    at.overlap = 0.0
    if gap < NO_GAP:
        at.overlap = frame.raised + frame.depth - gap
        at.rise = -rate
    height, slope = height_slope(pair.rail, frame.traces[RAIL].abscissa)
    at.cos = 1.0 / sqrt(1.0 + slope * slope)
    at.sin = slope * at.cos
    at.x = 0.0
    at.A = 0.5 * curvature
    at.skew = 0.0
    at.odd = 0.0
    at.wheel = frame.traces[WHEEL].abscissa
    if is_yawed(frame):
        at.x = outline_x(pair, frame.place, at.wheel)


def measure_ridges(pair: Pair, place: Place, problem: StripProblem):
    """The gap beside a yawed wheel's ridge at all stations, as far away as their levels say."""
    for i in range(problem.traced_count):
        at = problem.traced[i]
        zone = problem.zones[at.region]
        level = max(at.level, LEAST_LEVEL * zone.depth)
        measure_ridge(pair, place, at, TESTED * sqrt(level / (zone.one_alpha * at.A)))


def profile_within(pair: Pair, y: float):
    """Height [m] of the wheel's profile at ``y`` [m], or at the end that it lies beyond."""
    wheel = pair.wheel
    y = min(max(y, wheel.start), wheel.stop)
    z, slope = height_slope(wheel, y)
    return z


def measure_ridge(pair: Pair, place: Place, at: TracedStation, away: float):
    """A and skew of the gap beside a yawed wheel's ridge, which at a distance ``away`` along x are those of
    the wheel there.

    Along x a yawed wheel shows other parts of its profile, to either side of the ridge's.
    """
    if pair.tables.longitudinal != LONGITUDINAL_BASIC:
        across = away * place.sin_yaw * place.cos_roll
        z, slope, bend = height_slope_bend(pair.wheel, at.wheel)
        before = profile_within(pair, at.wheel - across)
        after = profile_within(pair, at.wheel + across)
        mean = bend
        square = across * across
        if square > 0.0:
            mean = (before + after - 2.0 * z) / square
        at.A = 0.5 * longitudinal_curvature(pair.tables, place, at.wheel, z, slope, mean)
        odd = 0.5 * (after - before) - slope * across
        at.skew = odd / (sqrt(1.0 + slope * slope) * away * away * away)
        at.odd = fabs(at.skew) * away


def place_on_middle(problem: StripProblem):
    """Stations on the curve between wheel and rail, in the middle of the overlap.

    Where the rail bulges, that is shorter than the rail by half the overlap times its curvature; and it is
    inclined by half of what the overlap rises.
    """
    stations = problem.traced
    for i in range(problem.traced_count):
        at = stations[i]
        before = i
        after = i
        if i > 0 and stations[i - 1].joined:
            before = i - 1
        if at.joined and i < problem.traced_count - 1:
            after = i + 1
        turned = stations[after].sin * stations[before].cos - stations[after].cos * stations[before].sin
        at.stretch = 1.0
        if at.overlap > 0.0:
            at.stretch -= 0.5 * at.overlap * turned / (stations[after].station - stations[before].station)
        at.place = at.station
        if i > 0:
            way = at.station - stations[i - 1].station
            at.place = stations[i - 1].place + 0.5 * (stations[i - 1].stretch + at.stretch) * way


def incline_station(tables: Tables, frame: Frame, at: TracedStation):
    """Turn a station to the mean of the normals of wheel and rail; what of penetration and load counts
    there."""
    half = 0.5 * at.rise
    scale = 1.0 / sqrt(1.0 + half * half)
    at.share = at.cos / frame.plane.cos
    cosine = (at.cos - half * at.sin) * scale
    at.sin = (at.sin + half * at.cos) * scale
    at.cos = cosine
    at.counted = 1.0
    if tables.load == LOAD_VERTICAL:
        at.counted = upright_share(frame.place, cosine, at.sin)


def interval(problem: StripProblem, first: int, high: int, station: float):
    """The station of a curve after which ``station`` [m] lies, from number ``first`` on, no later than the
    last but one."""
    while first < high - 1 and problem.traced[first + 1].station < station:
        first += 1
    return first


def way_through(problem: StripProblem, j: int, station: float):
    """How far ``station`` [m] lies on the way from station ``j`` to the next one, 0 ... 1."""
    start = problem.traced[j].station
    return (station - start) / (problem.traced[j + 1].station - start)


def between(low: float, high: float, u: float):
    """A value on the straight line between two others, at 0 <= ``u`` <= 1."""
    return low + u * (high - low)


def rest_gap(problem: StripProblem, j: int, station: float):
    """Gap [m] at ``station`` [m] behind traced station ``j``, on the ridge, where nothing penetrates."""
    gaps = problem.traced[j].gaps
    u = way_through(problem, j, station)
    return gaps[0] + u * (gaps[1] + u * (gaps[2] + u * gaps[3]))


def bend_gaps(problem: StripProblem):
    """The gap between every two stations of a curve: what comes of the penetration less the overlap, a cubic
    with the rise at both."""
    for i in range(problem.traced_count - 1):
        low = problem.traced[i]
        high = problem.traced[i + 1]
        if low.joined:
            way = high.station - low.station
            start = way * low.rise
            stop = way * high.rise
            grown = high.overlap - low.overlap
            low.gaps[0] = low.share * problem.penetration - low.overlap
            low.gaps[1] = (high.share - low.share) * problem.penetration - start
            low.gaps[2] = 2.0 * start + stop - 3.0 * grown
            low.gaps[3] = 2.0 * grown - start - stop
